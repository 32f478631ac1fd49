"""What is stored of a game while it is played, its finished levels; and the ghost that it races."""

from game.chosen_physics import SWEPT
from game.input.players import Players
from game.levels import Level
from game.rules import EventKind, Game, Ticked
from game.screens.app_state import AppState
from game.screens.earned import earned
from game.storage.ghost import Ghost, ghost_of
from game.storage.progress import Best, is_built_in, record_name
from game.storage.scores import ENDLESS


class PlayRecord:
    """Stores the finished levels of one game and runs its ghost.

    counts: whether bests and scores are stored. Games of the autopilot and of the editor do not count, nor do those on a
    physics other than the game's own, since their replays cannot be verified.
    """

    def __init__(self, state: AppState, levels: tuple[Level, ...], *, endless: bool) -> None:
        """Begin with a new game; what the one before has left is written.

        endless: whether its levels are made from a seed; they have a table of scores, and no bests.
        ranked: whether its score may stand in the table, which it may not with levels that anybody can make.
        """
        self._state, self._levels = state, levels
        alone = state.players == Players.ONE and not state.autopilot
        self.counts = alone and state.physics is SWEPT and state.recorder is not None
        self._has_bests = self.counts and not endless
        self.ranked = self.counts and (endless or all([is_built_in(level) for level in levels]))
        self.table = ENDLESS if endless else state.difficulty
        self._start = 0
        self.speed = 100  # per cent, the slowest so far
        self.done: Best | None = None
        self.before: Best | None = None
        self.earned: tuple[str, ...] = ()
        self.ghost: Ghost | None = None
        state.storage.game_done()
        self._open_ghost(0)

    def prepare(self) -> None:
        """Note the game speed in use, and prepare the ghost."""
        self.speed = min(self.speed, self._state.settings.speed)
        if self.ghost is not None:
            self.ghost.prepare()

    def after_tick(self, ticked: Ticked) -> None:
        """Note whether a level has begun or ended."""
        game = ticked.game
        if self.ghost is not None:
            self.ghost.after_tick(game)
        for event in ticked.events:
            if event.kind == EventKind.LEVEL_STARTED:
                self._start = game.tick
                self._open_ghost(game.number)
            elif event.kind == EventKind.LEVEL_CLEARED and self._has_bests:
                self._note(game)

    def _note(self, game: Game) -> None:
        """Store the result of a finished level."""
        result = game.results[-1]
        difficulty = self._state.difficulty
        self.done = Best(record_name(game.level), difficulty, result.score, int(result.rank), result.ticks, start=self._start)
        earned_before = earned(self._state.storage.progress.value)
        self.before = self._state.storage.level_done(self.done)
        self.earned = tuple([name for name in earned(self._state.storage.progress.value) if name not in earned_before])
        self._state.tell_problem()

    def _open_ghost(self, number: int) -> None:
        """Open the best run of a level as the ghost, if its replay still exists."""
        level = self._levels[number]
        self.ghost = ghost_of(self._state.storage, level, self._state.difficulty, number) if self._has_bests else None
