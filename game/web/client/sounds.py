"""The sounds of a browser: which samples are to be played, how loud in each ear."""

from collections.abc import Sequence

import msgspec

from game.rules import Event
from game.sound.notes import Note
from game.sound.patches import Patch
from game.sound.voices import SILENCE, Panning, Tail, Voice, chorus, cues

RATE = 24_000
"""Samples per second: enough for what the synthesiser makes, and a browser resamples anyway."""


class SoundEntry(msgspec.Struct, frozen=True, array_like=True):
    """One sound. patch, step, layers: its note. start, length: of its samples. tail: as `game.sound.voices.Tail`."""

    patch: str
    step: int
    layers: int
    start: int
    length: int
    tail: list[float]


class SoundIndex(msgspec.Struct, frozen=True):
    """What a file of samples holds. rate: samples per second."""

    rate: int
    sounds: list[SoundEntry]


class Sounds:
    """Decides, as the desktop's mixer does, which sounds there is room for."""

    def __init__(self, index: bytes) -> None:
        """index: a `SoundIndex` in JSON."""
        sounds = msgspec.json.decode(index, type=SoundIndex).sounds
        notes = [Note(Patch[entry.patch], entry.step, entry.layers) for entry in sounds]
        self._numbers = {note: number for number, note in enumerate(notes)}
        self._tails: dict[Note, Tail] = {note: entry.tail for note, entry in zip(notes, sounds, strict=True)}
        self._voices: tuple[Voice | None, ...] = SILENCE

    def started(self, events: Sequence[Event], side: Panning, combo: int, now: float) -> list[tuple[int, float, float]]:
        """The sounds that events begin: number of the sound, gains of the left and the right ear. Arguments as of `cues`."""
        wanted = cues(events, side, combo)
        if not wanted:
            return []
        heard = chorus(self._voices, wanted, self._tails, now)
        self._voices = heard.voices
        begun = [heard.voices[channel] for channel in heard.new]
        return [
            (self._numbers[voice.note], round(voice.left, 3), round(voice.right, 3)) for voice in begun if voice is not None
        ]
