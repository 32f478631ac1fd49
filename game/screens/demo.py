"""A game that plays itself."""

from game import effects
from game.autopilot import Autopilot
from game.effects import EffectKind, Effects, Shown
from game.levels import Level
from game.loop.fixed_step import Due, due
from game.rules import Phase, Ruleset, new_game, tick
from game.scene import Scene, scene_at, still

_END_TICKS = 240
"""From the end of its game to the end of the demonstration."""
_DISTURBING = frozenset({EffectKind.SHAKE, EffectKind.POINTS})
"""Effects that are left out, for somebody reads what is written over the demonstration."""


class Demo:
    """The autopilot's game of one level, by the arcade rules."""

    def __init__(self, level: Level, seed: int) -> None:
        """Start before the first serve."""
        self._ticked = still(new_game((level,), seed, Ruleset()))
        self._autopilot = Autopilot()
        self._effects = Effects()
        self._due = Due(0, 0.0)

    @property
    def ended(self) -> bool:
        """Whether the game is over, and its end was shown for a moment."""
        game = self._ticked.game
        return game.phase in (Phase.OVER, Phase.WON) and game.phase_tick > _END_TICKS

    def advance(self, seconds: float, shown: Shown) -> None:
        """Play on for some seconds. shown: the effects that the player wants."""
        self._due = due(self._due.rest, seconds)
        for _ in range(self._due.ticks):
            game = self._ticked.game
            self._ticked = tick(game, self._autopilot.controls(game))
            self._effects = effects.after(self._effects, self._ticked, shown - _DISTURBING)

    def scene(self) -> Scene:
        """What there is to see."""
        return scene_at(self._ticked, self._due.alpha, self._effects)
