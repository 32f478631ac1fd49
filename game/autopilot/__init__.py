"""A player for headless games and demonstrations: it sees the game and answers with controls, like anybody else."""

from game.autopilot.arcade_pilot import ArcadePilot
from game.autopilot.source_pilot import SourcePilot
from game.rules import Controls, Game


class Autopilot:
    """Plays by either ruleset. The same game seen from its start gets the same controls."""

    def __init__(self) -> None:
        """Start without a plan."""
        self._source, self._arcade = SourcePilot(), ArcadePilot()

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        return self._arcade.controls(game) if game.ruleset.arcade else self._source.controls(game)
