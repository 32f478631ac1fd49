"""What a game in the window leaves behind while it is played: finished levels, and the ghost that it races."""

from game.kept.progress import Best
from game.levels import Level
from game.replays.file import load
from game.rules import EventKind, Game, Ticked
from game.screens.app_state import AppState
from game.screens.ghost import Ghost
from game.system.errors import BadInputError


class PlayRecord:
    """Follows one game. Games of the autopilot, and of a physics that no replay can be verified with, do not count."""

    def __init__(self, state: AppState, levels: tuple[Level, ...], *, counts: bool) -> None:
        """Begin with a new game; what the one before has left is written. counts: whether bests and scores are kept."""
        self._state, self._levels, self.counts = state, levels, counts
        self._start = 0
        self.slowest = state.settings.speed  # per cent, of the whole game
        self.done: Best | None = None
        self.before: Best | None = None
        self.ghost: Ghost | None = None
        if counts:
            state.kept.game_done()
            self._open_ghost(0)

    def prepare(self) -> None:
        """Bring the ghost a little nearer to its start."""
        if self.ghost is not None:
            self.ghost.prepare()

    def after_tick(self, ticked: Ticked) -> None:
        """Note the begin and the end of a level."""
        game = ticked.game
        self.slowest = min(self.slowest, self._state.settings.speed)
        if self.ghost is not None:
            self.ghost.after_tick(game)
        for event in ticked.events:
            if event.kind == EventKind.LEVEL_STARTED:
                self._start = game.tick
                self._open_ghost(game.number)
            elif event.kind == EventKind.LEVEL_CLEARED and self.counts:
                self._note(game)

    def _note(self, game: Game) -> None:
        """A level was finished."""
        result = game.results[-1]
        difficulty = self._state.difficulty
        self.done = Best(game.level.name, difficulty, result.score, int(result.rank), result.ticks, start=self._start)
        self.before = self._state.kept.level_done(self.done)

    def _open_ghost(self, number: int) -> None:
        """The best run of a level, where its replay is still there."""
        self.ghost = None
        kept, folder = self._state.kept, self._state.kept.games.folder
        best = kept.progress.value.best(self._levels[number].name, self._state.difficulty)
        if not self.counts or folder is None or best is None or not best.replay:
            return
        try:
            recording = load(folder / best.replay)
        except BadInputError:
            return
        self.ghost = Ghost(recording, best.start, number)
