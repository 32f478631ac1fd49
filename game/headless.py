"""A whole game without a window, as fast as it goes."""

import sys
from collections.abc import Callable, Iterable

from game.autopilot import Autopilot
from game.levels import Level, built_in
from game.replays.file import Recorder
from game.replays.state_hash import state_hash
from game.rules import SOURCE_RULES, Advance, Game, Phase, Ruleset, Ticked, layers_left, new_game, tick
from game.rules.state import PLAYING
from game.system.ending import deferred_signals
from physics import advance as swept_advance

_PROGRESS_STEP = 1000
_ENDED = (Phase.WON, Phase.OVER)


def autopilot_game(
    levels: tuple[Level, ...],
    seed: int,
    ticks: int,
    recorder: Recorder | None = None,
    told: Callable[[Ticked], None] | None = None,
    advance: Advance = swept_advance,
    ruleset: Ruleset = SOURCE_RULES,
) -> Game:
    """The game after that many ticks of the autopilot, or when it is won or over, or a signal asks for an end.

    told: of every tick. advance: the physics that is flown. A recorder records what the swept physics of the engine flies.
    """
    game, pilot = new_game(levels, seed, ruleset), Autopilot()
    for start in _with_progress(range(0, ticks, _PROGRESS_STEP)):
        for _ in range(min(_PROGRESS_STEP, ticks - start)):
            if deferred_signals or (game.phase is not PLAYING and game.phase in _ENDED):
                return game
            controls = pilot.controls(game)
            done = tick(game, controls, advance)
            game = done.game
            if told is not None:
                told(done)
            if recorder is not None:
                recorder.add(controls, game)
    return game


def result_line(game: Game, physics: str = "swept") -> str:
    """The one line that says how a game stands.

    level: its number as `--level` takes it; of a level that does not come with the game, its number among those being played.
    layers: still to be broken in it.
    physics: as `--physics` takes it. If two players play against each other, the line has a score and lives of each.
    """
    listed = built_in() if game.level in built_in() else game.levels
    sides = [f"player_{k}_score={side.score} player_{k}_lives={side.lives} " for k, side in enumerate(game.sides, 1)]
    return (
        f"ticks={game.tick} seed={game.seed} physics={physics} level={listed.index(game.level) + 1} phase={game.phase.name.lower()} "
        f"score={game.score} lives={game.lives} {''.join(sides)}layers={layers_left(game)} hash={state_hash(game)}"
    )


def _with_progress(steps: range) -> Iterable[int]:
    """The steps, with a progress bar on stderr if somebody can see it."""
    if not sys.stderr.isatty():
        return steps
    from rich.console import Console  # noqa: PLC0415  # only where somebody waits: the game starts the sooner
    from rich.progress import track  # noqa: PLC0415

    console = Console(stderr=True)
    return track(steps, "playing", console=console, transient=True, disable=not console.is_terminal)
