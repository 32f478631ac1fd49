"""The music on the page: how loud each of its layers is now. The page mixes the layers of notes, and plays them."""

import msgspec

from game.settings.values import LOUDEST, Settings
from game.sound.music.mood import CALM, SILENT, Gains, Mood, nearer, wanted

_STALE = 0.6
"""Seconds after which a mood that nobody has told again gives way to calm: the game is paused, or there is a menu."""


class MusicLayer(msgspec.Struct, frozen=True):
    """A layer of the piece, of which all have the same length.

    rate: samples per second. length: samples of the loop. gain: of all its notes. waves: first sample, number of samples, and
    what each is multiplied by. notes: number of the wave, sample at which it begins, gains of the left and the right ear.
    """

    rate: int
    length: int
    gain: float
    waves: list[tuple[int, int, float]]
    notes: list[tuple[int, int, float, float]]


class MusicIndex(msgspec.Struct, frozen=True):
    """What a file of music holds. seconds: of the loop."""

    seconds: float
    layers: list[MusicLayer]


class MusicOnPage:
    """Follows the game as the desktop's player does."""

    def __init__(self) -> None:
        """Silent."""
        self._gains, self._mood, self._stale = SILENT, CALM, 0.0

    def follow(self, mood: Mood) -> None:
        """Let the music follow a mood; it is to be told again and again."""
        self._mood, self._stale = mood, 0.0

    def advance(self, seconds: float, settings: Settings) -> Gains:
        """The gains of the layers some seconds later."""
        share = settings.music / LOUDEST * settings.volume / LOUDEST if settings.sound else 0.0
        if not share:
            self._gains = SILENT
            return SILENT
        self._stale += seconds
        self._gains = nearer(self._gains, wanted(self._mood if self._stale < _STALE else CALM), seconds)
        return tuple([round(gain * share * share, 3) for gain in self._gains])
