"""The sound card: plays the sounds that `voices` has chosen and `synth` has made; silent where there is no card."""

import sys
import time
from collections.abc import Callable, Sequence

import numpy as np
import pygame

from game.rules import Event
from game.sound.music.loops import PEAK
from game.sound.music.mood import Mood
from game.sound.music.player import CHANNELS, MusicPlayer
from game.sound.notes import Note, every_note
from game.sound.synth import waveform
from game.sound.tails import tail
from game.sound.voices import SILENCE, VOICES, Panning, Tail, Voice, chorus, cues
from game.sound.waves import Waveform
from game.system.quiet_stderr import quiet_libraries

_BLOCK = 512
"""Samples the mixer makes at once: 12 ms, soon enough to be heard with the hit."""
_FADE_OUT = 30
"""Milliseconds in which sounds fade out when they are switched off: a cut would click."""
_FULL_SCALE = 32767.0


class Audio:
    """The game's sounds; made once, after the window, and told the events of every frame.

    Without a sound card one line on stderr says so, `problem` holds it, and everything else does nothing. Nothing here
    raises, and nothing changes a game.
    """

    problem: str | None
    """Why there is no sound; None if there is."""

    def __init__(self, sample_rate: int = 44100, clock: Callable[[], float] = time.perf_counter) -> None:
        """Open the mixer. Sounds are computed one by one by `prepare`, or when they are first heard.

        sample_rate: per second; the mixer converts if the card wants another. clock: seconds.
        """
        self._rate, self._clock = sample_rate, clock
        self._volume, self._muted, self._closed = 1.0, False, False
        self._voices = SILENCE
        self._sounds: dict[Note, pygame.mixer.Sound] = {}
        self._tails: dict[Note, Tail] = {}
        self._waiting = list(every_note()[::-1])
        self._music = MusicPlayer(VOICES, sample_rate, clock)
        self.problem = _opened(sample_rate)
        if self.problem is not None and sys.stderr is not None:
            sys.stderr.write(f"{self.problem}\n")

    @property
    def volume(self) -> float:
        """0 silent to 1; the amplitude is its square, so that half the volume sounds about half as loud."""
        return self._volume

    @volume.setter
    def volume(self, volume: float) -> None:
        """Also changes the sounds that are being played."""
        self._volume = min(max(volume, 0.0), 1.0)
        if self._is_open():
            for channel in range(VOICES):
                self._set_volume(channel)

    @property
    def muted(self) -> bool:
        """Whether sound is switched off."""
        return self._muted

    @muted.setter
    def muted(self, muted: bool) -> None:
        """Also fades out the sounds that are being played."""
        if muted and not self._muted:
            self._voices = SILENCE
            if self._is_open():
                self._music.stop()
                pygame.mixer.fadeout(_FADE_OUT)
        self._muted = muted

    @property
    def music_volume(self) -> float:
        """0 for no music, to 1; as `volume`, which it goes with: it says how loud the music is beside all else."""
        return self._music.volume

    @music_volume.setter
    def music_volume(self, volume: float) -> None:
        """Heard from the next `prepare` on."""
        self._music.volume = min(max(volume, 0.0), 1.0)

    def follow(self, mood: Mood) -> None:
        """Let the music follow what happens in a game; to be told as long as it is played."""
        self._music.follow(mood)

    def prepare(self) -> None:
        """Compute one more sound ahead of its use, until there are all, and let the music go on: to be called every frame."""
        if not self._is_open():
            return
        if self._waiting:
            self._compute([self._waiting.pop()])
        elif not self._muted:
            self._music.advance(self._volume)

    def play(self, events: Sequence[Event], side: Panning, combo: int) -> None:
        """Make the sounds of some events. side: where they are heard. combo: the game's, after the last of them."""
        if self._muted or not events or not self._is_open():
            return
        wanted = cues(events, side, combo)
        self._compute([cue.note for cue in wanted])
        self._voices, new = chorus(self._voices, wanted, self._tails, self._clock())
        for channel in new:
            voice = self._voices[channel]
            if voice is not None:
                pygame.mixer.Channel(channel).play(self._sounds[voice.note])
                self._set_volume(channel)

    def close(self) -> None:
        """Give the sound card back; nothing is heard any more."""
        if self._is_open():
            pygame.mixer.quit()
        self._voices = SILENCE
        self._sounds.clear()
        self._closed = True

    def _is_open(self) -> bool:
        """Whether there is a mixer; pygame.quit() takes it away, too."""
        return self.problem is None and not self._closed and pygame.mixer.get_init() is not None

    def _compute(self, notes: Sequence[Note]) -> None:
        """Compute the sounds that are not there yet."""
        for note in notes:
            if note not in self._sounds:
                wave = waveform(note, self._rate)
                self._sounds[note] = pygame.mixer.Sound(buffer=_stereo(wave))
                self._tails[note] = tail(wave, self._rate)

    def _set_volume(self, channel: int) -> None:
        """Set how loud each ear hears the voice on a channel."""
        voice: Voice | None = self._voices[channel]
        if voice is not None:
            gain = self._volume**2 * (1.0 - PEAK if self._music.volume > 0.0 else 1.0)
            pygame.mixer.Channel(channel).set_volume(voice.left * gain, voice.right * gain)


def _opened(sample_rate: int) -> str | None:
    """Open the mixer; one line that says why that is not possible, or None."""
    try:
        pygame.mixer.quit()
        with quiet_libraries():
            pygame.mixer.init(sample_rate, -16, 2, _BLOCK, allowedchanges=0)
        pygame.mixer.set_num_channels(VOICES + CHANNELS)
    except (pygame.error, NotImplementedError) as error:
        return f"no sound: {' '.join(str(error).split())}"
    return None


def _stereo(wave: Waveform) -> bytes:
    """16-bit samples, the same for both ears. wave: -1 to 1."""
    return np.repeat(np.rint(wave * _FULL_SCALE).astype(np.int16), 2).tobytes()
