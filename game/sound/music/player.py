"""Plays the layers of the piece together, each on a channel of its own."""

import time
from collections.abc import Callable, Iterator

import numpy as np
import pygame

from game.sound.music.loops import Loop, composed, length
from game.sound.music.mood import CALM, SILENT, Mood, nearer, wanted
from game.sound.music.score import Layer

CHANNELS = len(Layer)
_FULL_SCALE = 32767.0
_FADE_OUT = 400
"""Milliseconds."""
_STALE = 0.6
"""Seconds after which a mood that nobody has told again gives way to calm: the game is paused, or on a menu."""
_APART = 0.002
"""Seconds that the layers' starts may be apart, or they are started again: they would not be together."""
_ATTEMPTS = 4
_NOTES_A_FRAME, _WORK = 6, 0.002
"""Notes computed in a frame at most, and seconds after which no more is begun."""


class MusicPlayer:
    """The music of a mixer that is open; computes the loops bit by bit, then plays them all, silent ones too."""

    def __init__(self, first_channel: int, rate: int, clock: Callable[[], float] = time.perf_counter) -> None:
        """Start with nothing computed. first_channel: of CHANNELS in a row. rate: samples per second. clock: seconds."""
        self._channels = range(first_channel, first_channel + CHANNELS)
        self._rate, self._clock = rate, clock
        self._loops: list[pygame.mixer.Sound] = []
        self._ready = 0  # loops that are computed
        self._work: Iterator[Loop | None] | None = None
        self._gains = SILENT
        self._mood, self._told, self._before = CALM, clock(), clock()
        self._plays = False
        self.volume = 0.0
        """0 off to 1; the amplitude is its square."""

    def follow(self, mood: Mood) -> None:
        """Let the music follow a mood; it is to be told again and again."""
        self._mood, self._told = mood, self._clock()

    def advance(self, volume: float) -> None:
        """Compute one more note, or bring the layers nearer to the mood: to be called every frame. volume: of all sounds."""
        now = self._clock()
        seconds, self._before = min(max(now - self._before, 0.0), 0.25), now
        if self.volume <= 0.0:
            self.stop()
            return
        for _ in range(_NOTES_A_FRAME):
            if self._ready < CHANNELS and self._clock() - now < _WORK:
                self._compute()
        if self._ready < CHANNELS:
            return
        if not self._plays:
            self._start()
        mood = self._mood if now - self._told < _STALE else CALM
        self._gains = nearer(self._gains, wanted(mood), seconds)
        for channel, gain in zip(self._channels, self._gains, strict=True):
            pygame.mixer.Channel(channel).set_volume(gain * (self.volume * volume) ** 2)

    def stop(self) -> None:
        """Fade out; it begins anew when it is wanted again."""
        if self._plays:
            for channel in self._channels:
                pygame.mixer.Channel(channel).fadeout(_FADE_OUT)
        self._plays, self._gains = False, SILENT

    def _compute(self) -> None:
        """Compute another note of the next layer; before the first note, allocate all loops.

        If loops were allocated one by one, each would lie in memory behind the temporary arrays of the one before, and 20 MB of
        these could not be returned to the system.
        """
        if len(self._loops) < CHANNELS:
            self._loops.append(pygame.mixer.Sound(buffer=bytes(4 * length(self._rate))))
            return
        if self._work is None:
            self._work = composed(Layer(self._ready), self._rate)
        loop = next(self._work)
        if loop is not None:
            samples = pygame.sndarray.samples(self._loops[self._ready])
            for ear, row in enumerate(loop):
                samples[:, ear] = np.rint(np.clip(row, -1.0, 1.0) * np.float32(_FULL_SCALE))
            self._ready, self._work = self._ready + 1, None

    def _start(self) -> None:
        """Start all layers at once, silent. They stay together, for all have the same length."""
        for _ in range(_ATTEMPTS):
            begin = self._clock()
            for channel, loop in zip(self._channels, self._loops, strict=True):
                pygame.mixer.Channel(channel).play(loop, loops=-1)
                pygame.mixer.Channel(channel).set_volume(0.0)
            if self._clock() - begin < _APART:
                break
        self._plays = True
