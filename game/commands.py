"""The game's commands and their options: `polar-breakout`, `python -m game`."""

import contextlib
import random
import tempfile
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Literal, NamedTuple

import typer

from game import VERSION
from game.chosen_physics import SOURCE, SWEPT, ChosenPhysics
from game.editor.command import file_to_edit
from game.effects import LONGEST, after_all
from game.headless import autopilot_game, result_line
from game.lab.kit.second_engine import Engine
from game.levels import Level, chosen, level_schema, warnings
from game.replays import file as replay
from game.replays.history import History, kept_games
from game.replays.verify import verified
from game.rules import SOURCE_RULES, Difficulty, Game, Ruleset, Ticked
from game.second_opinion import Compare, NormalPair
from game.settings.file import SettingsFile, settings_path
from game.system.command_line import refuse_ignored
from game.system.ending import deferred
from game.system.errors import BadInputError, CheckFailedError, EnvironmentMissingError
from game.system.files import check_target, free_path
from game.system.output import say, tell
from game.system.pygame_ce import check_pygame
from game.system.wording import quoted, quoted_path

app = typer.Typer(
    help="A circular Breakout.",
    add_completion=False,
    pretty_exceptions_enable=False,
    invoke_without_command=True,
    rich_markup_mode=None,
)

_DEMO_TICKS = 240 * 20
_MOST_TICKS = replay.MAX_TICKS
_PICTURE_OPTIONS = ("size", "view")
_GAME_OPTIONS = (
    "level",
    "seed",
    "headless",
    "autopilot",
    "ticks",
    "record",
    "physics",
    "rules",
    "difficulty",
    "screenshot",
    *_PICTURE_OPTIONS,
    "version",
)
_PHYSICS = {"swept": SWEPT, "source": SOURCE}


@app.callback()
def play(
    context: typer.Context,
    level: Annotated[str, typer.Option(help="Start at a level: its number, its name, or a TOML file of one's own.")] = "1",
    seed: Annotated[
        int | None,
        typer.Option(
            min=0,
            max=2**63 - 1,
            help="Decides the power-ups, where the aim of each serve begins, and nudges; the same seed is the same chance.",
            show_default="1 if --headless, else random",
        ),
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Play without a window and print one result line.")] = False,
    autopilot: Annotated[bool, typer.Option("--autopilot", help="Let the program play.")] = False,
    ticks: Annotated[int, typer.Option(min=0, max=_MOST_TICKS, help="Ticks of 1/240 s to play headless.")] = 24_000,
    record: Annotated[Path | None, typer.Option(help="Write a replay of the game to this file.")] = None,
    physics: Annotated[
        Literal["swept", "source"],
        typer.Option(help="What flies the balls: exact times of impact, or the slides' own test once a frame."),
    ] = "swept",
    rules: Annotated[
        Literal["arcade", "source"] | None,
        typer.Option(
            help="The game's own rules, or the source's: one speed, no power-ups, no turn by where a paddle is hit.",
            show_default="arcade; source if --physics source",
        ),
    ] = None,
    difficulty: Annotated[Literal["easy", "normal", "hard"], typer.Option(help="Of the arcade rules.")] = "normal",
    screenshot: Annotated[Path | None, typer.Option(help="Draw the last tick of a headless game into this PNG file.")] = None,
    size: Annotated[str, typer.Option(metavar="WxH", help="Size of the screenshot in pixels.")] = "1280x800",
    view: Annotated[Literal["flat", "solid"], typer.Option(help="The screenshot's view: from above, or in 3D.")] = "flat",
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """Play the circular Breakout; without options, in a window."""
    if context.invoked_subcommand is not None:
        refuse_ignored(context, f"is not for the command {context.invoked_subcommand}", *_GAME_OPTIONS)
        return
    if version:
        tell(f"polar-breakout {VERSION}")
        return
    pixels = _size(size)
    if not headless:
        refuse_ignored(context, "draws a headless game; add --headless --autopilot", "screenshot")
        refuse_ignored(context, "is for a headless game; add --headless --autopilot", "ticks")
    if screenshot is None:
        refuse_ignored(context, "is for a picture; add --screenshot FILE", *_PICTURE_OPTIONS)
    if record is not None and physics == "source":
        raise BadInputError("--record: a replay is verified with the swept physics; leave out --physics source")
    ruleset = _ruleset(context, rules, difficulty, physics)
    check_target(record, "--record")
    check_target(screenshot, "--screenshot", ".png")
    levels = chosen(level)
    for line in warnings(levels[0]):
        say(f"polar-breakout: warning: {quoted(level)}: {line}")
    if headless and not autopilot:
        raise BadInputError("--headless: nobody plays; add --autopilot")
    if headless:
        last = _play_headless(_ChosenGame(levels, 1 if seed is None else seed, ruleset, record, _PHYSICS[physics]), ticks)
        if screenshot is not None:
            _save_screenshot(last, screenshot, pixels, solid=view == "solid")
        tell(result_line(last.game, physics))
        return
    seed = random.SystemRandom().getrandbits(32) if seed is None else seed
    _play_in_window(_ChosenGame(levels, seed, ruleset, record, _PHYSICS[physics]), autopilot=autopilot)


def _ruleset(context: typer.Context, rules: str | None, difficulty: str, physics: str) -> Ruleset:
    """The rules that the options ask for; BadInputError for options that contradict each other."""
    if rules == "arcade" and physics == "source":
        raise BadInputError(
            "--rules arcade: the slides' own algorithm is played by the source's rules; leave out one of the two"
        )
    if rules == "source" or physics == "source":
        refuse_ignored(context, "is for the arcade rules", "difficulty")
        return SOURCE_RULES
    return Ruleset(Difficulty[difficulty.upper()])


@app.command("levels")
def show_levels(
    pictures: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Draw every level into a PNG file in this folder.")
    ] = None,
    schema: Annotated[bool, typer.Option("--schema", help="Print the JSON schema of level files, for text editors.")] = False,
) -> None:
    """List the levels that come with the game, and one's own."""
    from game.level_listing import list_levels, save_pictures  # noqa: PLC0415  # not for a game, which starts the sooner

    if schema:
        tell(level_schema())
    elif pictures is None:
        list_levels()
    else:
        check_pygame()
        save_pictures(pictures)


@app.command("edit")
def edit_level(
    file: Annotated[
        Path | None,
        typer.Argument(help="A level file, new or not; a name alone is one in the folder of own levels.", show_default=False),
    ] = None,
) -> None:
    """Open the level editor."""
    path = file_to_edit(file)
    check_pygame()
    from game.app import Services, edit  # noqa: PLC0415  # pygame, only where it is needed

    with _settings() as settings:
        edit(path, Services(settings=settings, lost=_say_lost))


@app.command("replays")
def list_replays() -> None:
    """List the games kept from the window, newest first."""
    for path in kept_games():
        tell(str(path))


@app.command("replay")
def watch_replay(
    files: Annotated[list[Path], typer.Argument(help="Replay files (.polar); one to watch, any number to verify.")],
    verify: Annotated[bool, typer.Option("--verify", help="Play them again without a window and check every hash.")] = False,
) -> None:
    """Watch a recorded game, or verify recorded games."""
    if verify:
        _verify(files)
        return
    if len(files) > 1:
        raise BadInputError(f"replay: {len(files)} files to watch; expected one")
    recording = replay.load(files[0])
    check_pygame()
    from game.app import Services, watch  # noqa: PLC0415  # pygame, only where it is needed

    with _settings() as settings:
        watch(recording, Services(_second_opinion(), _second_engine, settings, _say_lost))


@app.command("lab")
def open_lab(
    context: typer.Context,
    scene: Annotated[
        str | None,
        typer.Argument(help='A scene, or one as it stands: "case-2?ball=9.9,0.3&r=1".', show_default=False),
    ] = None,
    list_: Annotated[bool, typer.Option("--list", help="List the scenes.")] = False,
    headless: Annotated[bool, typer.Option("--headless", help="Check every scene's claims without a window.")] = False,
    drags: Annotated[int, typer.Option(min=0, max=10**6, help="Random drags of each scene to check after.")] = 1000,
    screenshot: Annotated[Path | None, typer.Option(help="Draw the scene into this PNG file.")] = None,
    size: Annotated[str, typer.Option(metavar="WxH", help="Size of the screenshot in pixels.")] = "1280x800",
    theme: Annotated[Literal["dark", "light"], typer.Option(help="Colours of the screenshot.")] = "dark",
) -> None:
    """Open the lab: scenes of the collision detection one can touch."""
    from game.lab import command  # noqa: PLC0415  # its scenes, only where they are needed

    if list_:
        refuse_ignored(context, "does nothing beside --list", "scene", "headless", "drags", "screenshot", "size", "theme")
        command.list_scenes()
        return
    if headless:
        refuse_ignored(context, "does nothing beside --headless", "screenshot", "size", "theme")
        command.check_scenes(scene, drags, _second_engine())
        return
    refuse_ignored(context, "is for checking scenes; add --headless", "drags")
    if screenshot is None:
        refuse_ignored(context, "is for a picture; add --screenshot FILE", "size", "theme")
        check_pygame()
        from game.app import Services, lab  # noqa: PLC0415  # pygame, only where it is needed

        with _settings() as settings:
            lab(scene, Services(engine=_second_engine, settings=settings, lost=_say_lost))
        return
    pixels = _size(size)
    check_target(screenshot, "--screenshot", ".png")
    check_pygame()
    command.save_picture(scene, screenshot, pixels, theme, _second_engine())


def _verify(files: list[Path]) -> None:
    """Verify every file; CheckFailedError with the first divergence, after all have been looked at."""
    failed: list[str] = []
    for file in files:
        verdict = verified(replay.load(file))
        if verdict.divergence is None:
            tell(f"verified {file}: {result_line(verdict.game)}")
        else:
            failed.append(f"{quoted_path(file)}: {verdict.divergence}")
            say(f"polar-breakout: {failed[-1]}")
    if failed:
        raise CheckFailedError(f"{len(failed)} of {len(files)} replays diverged")


class _ChosenGame(NamedTuple):
    """The game that the options ask for. record: the file of its replay; None for none."""

    levels: tuple[Level, ...]
    seed: int
    ruleset: Ruleset
    record: Path | None
    physics: ChosenPhysics


class _Last(NamedTuple):
    """How a game ended, and the ticks before whose effects are still to be seen."""

    game: Game
    passed: deque[Ticked]


def _play_headless(chosen_game: _ChosenGame, ticks: int) -> _Last:
    """A game of the autopilot without a window, recorded if asked for; a signal ends it early, what was played is kept."""
    levels, seed, ruleset, record, physics = chosen_game
    recorder = None if record is None else replay.Recorder(levels, seed, ruleset)
    passed, cut_short = deque[Ticked](maxlen=LONGEST), 0

    def told(ticked: Ticked) -> None:
        """Remember the last ticks, and count those that ended before their time."""
        nonlocal cut_short
        passed.append(ticked)
        cut_short += ticked.step.dropped > 0

    with deferred():
        game = autopilot_game(levels, seed, ticks, recorder, told, physics.advance, ruleset)
        if recorder is not None and record is not None:
            replay.save(recorder.recording(), record)
        if cut_short:
            ticks_were = "1 tick was" if cut_short == 1 else f"{cut_short} ticks were"
            say(f"polar-breakout: {ticks_were} cut short: a ball is held in a lane too narrow")
    return _Last(game, passed)


def _play_in_window(chosen_game: _ChosenGame, *, autopilot: bool) -> None:
    """The game in its window; without a display, a short demonstration and a picture of it instead."""
    check_pygame()
    from game.app import Services  # noqa: PLC0415  # pygame, only where it is needed
    from game.app import play as play_in_window  # noqa: PLC0415

    levels, seed, ruleset, record, physics = chosen_game
    history = History(record) if physics is SWEPT else None  # replays are verified with the swept physics

    def lost() -> None:
        """Xlib ends the program: what there is of the game is written at once."""
        _close(history)
        kept = "" if history is None else "; games of five seconds and more are kept (polar-breakout replays)"
        say(f"polar-breakout: the display is gone{kept}")

    with deferred():
        try:
            with _settings() as settings:
                services = Services(_second_opinion(), _second_engine, settings, lost)
                play_in_window(levels, seed, services, recorder=history, autopilot=autopilot, physics=physics, ruleset=ruleset)
        except EnvironmentMissingError as error:
            say(f"polar-breakout: {error}; playing 20 s without a window instead")
            _demonstrate(chosen_game)
        finally:
            _close(history)


def _close(history: History | None) -> None:
    """Write the game that is being played, if any is kept, and say if that was not possible."""
    if history is None:
        return
    history.close()
    if history.problem is not None:
        say(f"polar-breakout: game not kept: {history.problem}")


@contextlib.contextmanager
def _settings() -> Iterator[SettingsFile]:
    """The player's settings; what went wrong with them is said at the end."""
    settings = SettingsFile(settings_path())
    with deferred():
        try:
            yield settings
        finally:
            if settings.problem is not None:
                say(f"polar-breakout: {settings.problem}")


def _second_opinion() -> Compare:
    """Asks pymunk about contacts; it is loaded with the first of them."""

    def compare(ticked: Ticked) -> tuple[NormalPair, ...]:
        from tools.crosscheck.overlay import opinions  # noqa: PLC0415  # pymunk, only where it is needed

        return opinions(ticked)

    return compare


def _say_lost() -> None:
    """Xlib ends the program: there is nothing to be saved."""
    say("polar-breakout: the display is gone")


def _second_engine() -> Engine:
    """Pymunk, for the lab's scenes to ask."""
    from tools.crosscheck.second_engine import Pymunk  # noqa: PLC0415  # pymunk, only where it is needed

    return Pymunk()


def _demonstrate(chosen_game: _ChosenGame) -> None:
    """A short game of the autopilot and a picture of how it stands."""
    last = _play_headless(chosen_game, _DEMO_TICKS)
    tell(result_line(last.game, "swept" if chosen_game.physics is SWEPT else "source"))
    for folder in _picture_folders():
        path = free_path(folder, "polar-breakout.png")
        with contextlib.suppress(BadInputError):
            _save_screenshot(last, path, (1280, 800))
            tell(f"picture: {path.absolute()}")
            return


def _picture_folders() -> Iterator[Path]:
    """Where a picture may be saved that nobody has named a file for: the working directory, else the one for such files."""
    yield Path()
    with contextlib.suppress(OSError):  # there may be none
        yield Path(tempfile.gettempdir())


def _save_screenshot(last: _Last, path: Path, size: tuple[int, int], *, solid: bool = False) -> None:
    """Draw a game into a PNG file; BadInputError where it cannot be written."""
    check_pygame()
    from game.input.view import FLAT, SOLID  # noqa: PLC0415  # pygame, only where it is needed
    from game.screenshot import save_screenshot  # noqa: PLC0415

    try:
        save_screenshot(last.game, path, size, view=SOLID if solid else FLAT, effects=after_all(last.passed))
    except OSError as error:
        raise BadInputError(f"--screenshot {quoted_path(path)}: cannot write; {error.strerror or error}") from None


def _size(text: str) -> tuple[int, int]:
    """Width and height from "WxH"."""
    width, cross, height = text.partition("x")
    if not (cross and width.isdecimal() and height.isdecimal()):
        raise BadInputError(f"--size {quoted(text)}: expected WIDTHxHEIGHT in pixels, such as 1280x800")
    pixels = int(width[:9]), int(height[:9])
    if not all([16 <= length <= 16384 for length in pixels]):
        raise BadInputError(f"--size {quoted(text)}: expected 16 to 16384 pixels each way")
    return pixels
