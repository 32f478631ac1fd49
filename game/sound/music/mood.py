"""How much of every layer is wanted, by what happens in the game."""

from typing import NamedTuple

from game.rules import Game, Phase, layers_left
from game.sound.music.score import Layer

_RISE, _FALL = 1.2, 3.5
"""Seconds in which a layer comes, and goes."""


class Mood(NamedTuple):
    """What the music follows.

    playing: whether a ball is in play. combo: bricks in a row. left: share of the level's layers that is left.
    """

    playing: bool = False
    combo: int = 0
    left: float = 1.0


CALM = Mood()
"""Of menus and pauses."""

_COMBOS = {Layer.PAD: 0, Layer.BASS: 0, Layer.ARPEGGIO: 2, Layer.DRUMS: 4, Layer.MELODY: 6}
"""Bricks in a row from which a layer is wanted while a ball is in play."""
_FEW = {Layer.ARPEGGIO: 0.5, Layer.DRUMS: 0.3, Layer.MELODY: 0.12}
"""Shares of layers left from which on a layer is wanted however short the row."""
_CALM_PAD = 0.7
"""The pad while no ball is in play."""

Gains = tuple[float, ...]
"""How much of each layer, 0 to 1."""
SILENT: Gains = (0.0,) * len(Layer)


def mood_of(game: Game) -> Mood:
    """The mood of a game."""
    full = sum([max(layers, 0) for ring in game.level.rings for layers in ring.slots()])
    return Mood(game.phase == Phase.PLAYING, game.combo, layers_left(game) / max(full, 1))


def wanted(mood: Mood) -> Gains:
    """The gains that the layers should have."""
    if not mood.playing:
        return tuple([_CALM_PAD if layer is Layer.PAD else 0.0 for layer in Layer])
    return tuple([1.0 if mood.combo >= _COMBOS[layer] or mood.left <= _FEW.get(layer, -1.0) else 0.0 for layer in Layer])


def nearer(gains: Gains, goal: Gains, seconds: float) -> Gains:
    """The gains some seconds later, on their way to others."""
    up, down = seconds / _RISE, seconds / _FALL
    return tuple([min(now + up, end) if end > now else max(now - down, end) for now, end in zip(gains, goal, strict=True)])
