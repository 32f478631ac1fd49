"""The game's commands and their options: `polar-breakout`, `python -m game`."""

import contextlib
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Literal

import typer

from game import VERSION
from game.chosen_game import ChosenGame, demonstrate, play_headless
from game.chosen_physics import SWEPT, flown_on, functions_of
from game.editor.command import file_to_edit
from game.headless import result_line
from game.input.players import Players
from game.lab.commands import LabServices, lab_command
from game.lab.kit.second_engine import Engine
from game.levels import chosen, level_schema, warnings
from game.picture_file import save_picture, size_of
from game.replays import file as replay
from game.replays.verified_files import verify_files
from game.rules import SOURCE_RULES, Difficulty, Ruleset, Ticked
from game.second_opinion import Compare, NormalPair
from game.settings.file import SettingsFile
from game.settings.folder import settings_path
from game.storage.folder import data_folder
from game.storage.score_listing import print_scores
from game.storage.storage import Storage
from game.system.command_line import refuse_ignored
from game.system.ending import deferred
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import check_target
from game.system.output import print_error, print_line
from game.system.pygame_ce import check_pygame
from game.system.wording import quoted, quoted_path

app = typer.Typer(
    help="A circular Breakout.",
    add_completion=False,
    pretty_exceptions_enable=False,
    invoke_without_command=True,
    rich_markup_mode=None,
)

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
    "with_",
    "rules",
    "difficulty",
    "players",
    "screenshot",
    *_PICTURE_OPTIONS,
    "version",
)


_WITH_HELP = "A Python file with any of the source's functions, in place of ours or beside them (docs/student.md)."


@app.callback()
def play(
    context: typer.Context,
    level: Annotated[str, typer.Option(help="Start at a level: its number, its name, or a TOML file of one's own.")] = "1",
    seed: Annotated[
        int | None,
        typer.Option(
            min=0,
            max=2**63 - 1,
            help="Decides the power-ups, where the aim of each serve begins, and nudges; the same seed is the same chance. "
            "In the window it is the first game's, and the seeds of the games after it are made of it.",
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
    with_: Annotated[Path | None, typer.Option("--with", help=_WITH_HELP)] = None,
    rules: Annotated[
        Literal["arcade", "source"] | None,
        typer.Option(
            help="The game's own rules, or the source's: one speed, no power-ups, no turn by where a paddle is hit.",
            show_default="arcade; source if --physics source",
        ),
    ] = None,
    difficulty: Annotated[
        Literal["easy", "normal", "hard"] | None,
        typer.Option(help="Of the arcade rules.", show_default="normal; in the window the one chosen last"),
    ] = None,
    players: Annotated[
        Literal["one", "together", "versus"],
        typer.Option(
            help="One; two who steer the same paddles; two against each other, each with a paddle and a half of the ring."
        ),
    ] = "one",
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
        print_line(f"polar-breakout {VERSION}")
        return
    pixels = size_of(size)
    if not headless:
        refuse_ignored(context, "draws a headless game; add --headless --autopilot", "screenshot")
        refuse_ignored(context, "is for a headless game; add --headless --autopilot", "ticks")
    if screenshot is None:
        refuse_ignored(context, "is for a picture; add --screenshot FILE", *_PICTURE_OPTIONS)
    _refuse_physics(context, physics, with_, record)
    flown = physics if with_ is None else "source"
    ruleset = _ruleset(context, rules, difficulty, flown)
    _refuse_versus(players, ruleset)
    check_target(record, "--record")
    check_target(screenshot, "--screenshot", ".png")
    levels = chosen(level)
    for line in warnings(levels[0]):
        print_error(f"polar-breakout: warning: {quoted(level)}: {line}")
    if headless and not autopilot:
        raise BadInputError("--headless: nobody plays; add --autopilot")
    if seed is None:
        seed = 1 if headless else random.SystemRandom().getrandbits(32)
    with functions_of(with_, checked=headless) as own:
        game = ChosenGame(levels, seed, ruleset, record, flown_on(physics, own), own, Players[players.upper()])
        if not headless:
            _play_in_window(game, autopilot=autopilot)
            return
        last = play_headless(game, ticks)
        if screenshot is not None:
            save_picture(last, screenshot, pixels, solid=view == "solid")
        print_line(result_line(last.game, physics if own is None else "own"))


def _ruleset(context: typer.Context, rules: str | None, difficulty: str | None, physics: str) -> Ruleset | None:
    """The rules that the options ask for, None where they say nothing; BadInputError for options that contradict each other."""
    if rules == "arcade" and physics == "source":
        raise BadInputError(
            "--rules arcade: the slides' own algorithm is played by the source's rules; leave out one of the two"
        )
    if rules == "source" or physics == "source":
        refuse_ignored(context, "is for the arcade rules", "difficulty")
        return SOURCE_RULES
    if rules is None and difficulty is None:
        return None
    return Ruleset(Difficulty[(difficulty or "normal").upper()])


def _refuse_versus(players: str, ruleset: Ruleset | None) -> None:
    """BadInputError for two against each other under the source's rules."""
    if players == "versus" and ruleset == SOURCE_RULES:
        raise BadInputError("--players versus: the source's rules know one player; play by the arcade rules")


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
        print_line(level_schema())
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
    from game.loop.app import Services, edit  # noqa: PLC0415  # pygame, only where it is needed

    with _settings() as settings:
        edit(path, Services(settings=settings, lost=_say_lost))


@app.command("screens")
def save_screens(
    pictures: Annotated[Path, typer.Option(metavar="DIR", help="The folder that gets a PNG file of every screen.")],
    only: Annotated[str, typer.Option(help="A part of the names of the screens wanted.")] = "",
    size: Annotated[str, typer.Option(metavar="WxH", help="Size of the pictures in pixels.")] = "1280x800",
    theme: Annotated[Literal["dark", "light", "contrast"], typer.Option(help="Their colours.")] = "dark",
    vision: Annotated[
        Literal["full", "protanopia", "deuteranopia", "tritanopia"],
        typer.Option(help="The colours that the player tells apart."),
    ] = "full",
    language: Annotated[Literal["en", "de", "cs"], typer.Option(help="Of the texts.")] = "en",
    text_size: Annotated[int, typer.Option(min=100, max=200, help="Of the texts, per cent.")] = 100,
) -> None:
    """Draw every screen of the game, with made-up scores, into a folder."""
    pixels = size_of(size)
    check_pygame()
    from game.screens.gallery.pictures import save_pictures  # noqa: PLC0415  # pygame, only where it is needed
    from game.settings.values import Settings  # noqa: PLC0415

    settings = Settings(theme, vision=vision, language=language, text_size=text_size)

    try:
        pictures.mkdir(parents=True, exist_ok=True)
        for path in save_pictures(pictures, pixels, settings, only):
            print_line(str(path))
    except OSError as error:
        raise BadInputError(f"--pictures {quoted_path(pictures)}: cannot write; {error.strerror or error}") from None


@app.command("replays")
def list_replays() -> None:
    """List the games kept from the window, newest first."""
    for path in Storage(data_folder()).games.paths():
        print_line(str(path))


@app.command("scores")
def list_scores(
    verify: Annotated[bool, typer.Option("--verify", help="Play every score's replay again and compare the points.")] = False,
) -> None:
    """List the high scores, best first; with --verify, prove them."""
    print_scores(Storage(data_folder()), verify=verify)


@app.command("replay")
def watch_replay(
    files: Annotated[list[Path], typer.Argument(help="Replay files (.polar); one to watch, any number to verify.")],
    verify: Annotated[bool, typer.Option("--verify", help="Play them again without a window and check every hash.")] = False,
) -> None:
    """Watch a recorded game, or verify recorded games."""
    if verify:
        verify_files(files)
        return
    if len(files) > 1:
        raise BadInputError(f"replay: {len(files)} files to watch; expected one")
    recording = replay.load(files[0])
    check_pygame()
    from game.loop.app import Services, watch  # noqa: PLC0415  # pygame, only where it is needed

    with _settings() as settings:
        watch(recording, Services(_second_opinion(), _second_engine, settings, lost=_say_lost))


@app.command("web")
def serve_web(
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port on this machine; 0 for any free one.")] = 8000,
    quiet: Annotated[bool, typer.Option("--no-browser", help="Do not open the browser.")] = False,
) -> None:
    """Serve the game for a browser on this machine, until it is interrupted."""
    from game.web.command import serve  # noqa: PLC0415  # numpy and the sounds, only where they are needed

    serve(port, opens=not quiet)


def _refuse_physics(context: typer.Context, physics: str, own: Path | None, record: Path | None) -> None:
    """BadInputError for options that do not go with the physics that is asked for."""
    if own is not None and physics == "swept":
        refuse_ignored(context, "own functions fly as the slides have it; leave out --physics swept", "physics")
    if record is not None and (physics == "source" or own is not None):
        option = "--physics source" if own is None else "--with"
        raise BadInputError(f"--record: a replay is verified with the swept physics; leave out {option}")


def _play_in_window(chosen_game: ChosenGame, *, autopilot: bool) -> None:
    """The game in its window; without a display, a short demonstration and a picture of it instead."""
    check_pygame()
    from game.loop.app import Services  # noqa: PLC0415  # pygame, only where it is needed
    from game.loop.app import play as play_in_window  # noqa: PLC0415

    levels, seed, ruleset, record, physics, own, players = chosen_game
    storage = Storage(data_folder(), record)
    games = storage.games if physics is SWEPT else None  # replays are verified with the swept physics

    def lost() -> None:
        """Xlib ends the program: what there is of the game is written at once."""
        _close(storage)
        told = "" if games is None else "; games of five seconds and more are kept (polar-breakout replays)"
        print_error(f"polar-breakout: the display is gone{told}")

    with deferred():
        try:
            with _settings() as settings:
                services = Services(_second_opinion(), _second_engine, settings, storage, lost, own)
                play_in_window(
                    levels,
                    seed,
                    services,
                    recorder=games,
                    autopilot=autopilot,
                    physics=physics,
                    ruleset=ruleset,
                    players=players,
                )
        except EnvironmentMissingError as error:
            print_error(f"polar-breakout: {error}; playing 20 s without a window instead")
            demonstrate(chosen_game)
        finally:
            _close(storage)


def _close(storage: Storage) -> None:
    """Write the game that is being played, and say what could not be read or written."""
    storage.game_done()
    for line in storage.problems:
        print_error(f"polar-breakout: {line}")


@contextlib.contextmanager
def _settings() -> Iterator[SettingsFile]:
    """The player's settings; what went wrong with them is said at the end."""
    settings = SettingsFile(settings_path())
    with deferred():
        try:
            yield settings
        finally:
            if settings.problem is not None:
                print_error(f"polar-breakout: {settings.problem}")


def _second_opinion() -> Compare:
    """Asks pymunk about contacts; it is loaded with the first of them."""

    def compare(ticked: Ticked) -> tuple[NormalPair, ...]:
        from tools.crosscheck.overlay import opinions  # noqa: PLC0415  # pymunk, only where it is needed

        return opinions(ticked)

    return compare


def _say_lost() -> None:
    """Xlib ends the program: there is nothing to be saved."""
    print_error("polar-breakout: the display is gone")


def _second_engine() -> Engine:
    """Pymunk, for the lab's scenes to ask."""
    from tools.crosscheck.second_engine import Pymunk  # noqa: PLC0415  # pymunk, only where it is needed

    return Pymunk()


app.command("lab")(lab_command(LabServices(_second_engine, _settings, _say_lost, _WITH_HELP)))
