"""Any moment of a recorded game: forward by playing it, backward from snapshots."""

from game.replays.file import Recording, controls_of, started
from game.rules import Controls, Game, Ticked, tick

_SNAPSHOT = 240


class Playback:
    """A recording one can seek in. A game is an immutable value, so a snapshot is a reference."""

    def __init__(self, recording: Recording) -> None:
        """Unpack the controls; nothing is played yet."""
        self._controls: list[Controls] = list(controls_of(recording))
        self._snapshots: list[Game] = [started(recording)]
        self._last = self._snapshots[0]

    @property
    def ticks(self) -> int:
        """Length of the recording."""
        return len(self._controls)

    def game(self, number: int) -> Game:
        """The game after `number` ticks, 0 to `ticks`. Costs up to a second of play backward, and what is new forward."""
        known = self._snapshots[min(number // _SNAPSHOT, len(self._snapshots) - 1)]
        game = self._last if known.tick <= self._last.tick <= number else known
        while game.tick < number:
            game = tick(game, self._controls[game.tick]).game
            if game.tick == len(self._snapshots) * _SNAPSHOT:
                self._snapshots.append(game)
        self._last = game
        return game

    def ticked(self, number: int) -> Ticked:
        """The tick that follows the first `number` ticks, 0 to `ticks` - 1: its events and its physics."""
        done = tick(self.game(number), self._controls[number])
        self._last = done.game
        return done
