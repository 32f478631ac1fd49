"""The lab's command line: `polar-breakout lab`, `python -m game lab`."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Annotated, Literal, NamedTuple

import typer

from game.chosen_physics import functions_of
from game.lab.kit.second_engine import Engine
from game.picture_file import size_of
from game.settings.file import SettingsFile
from game.student.functions_file import FunctionsFile
from game.system.command_line import refuse_ignored
from game.system.files import check_target
from game.system.pygame_ce import check_pygame

_PICTURE_OPTIONS = ("present", "screenshot", "export", "format_", "steps", "size", "theme")
_Colours = Literal["dark", "light"]


class LabServices(NamedTuple):
    """What the program hands to its lab.

    engine: makes the engine that the lab compares with. settings: the player's, for as long as the window is open.
    lost: told when the display is gone. with_help: what the option --with means.
    """

    engine: Callable[[], Engine]
    settings: Callable[[], AbstractContextManager[SettingsFile]]
    lost: Callable[[], None]
    with_help: str


class _LabWish(NamedTuple):
    """What a window is opened with, or a picture drawn of."""

    scene: str | None
    own: FunctionsFile | None
    presents: bool


def lab_command(services: LabServices) -> Callable[..., None]:
    """The command, with its options."""

    def open_lab(
        context: typer.Context,
        scene: Annotated[
            str | None,
            typer.Argument(help='A scene, or one as it stands: "case-2?ball=9.9,0.3&r=1".', show_default=False),
        ] = None,
        pack: Annotated[
            Path | None,
            typer.Option("--scenes", metavar="FILE", help="Add the scenes of a Python or TOML file (docs/lab.md)."),
        ] = None,
        arena: Annotated[
            Path | None, typer.Option(metavar="FILE", help="Open a level file as an arena of one's own to change and fly in.")
        ] = None,
        list_: Annotated[bool, typer.Option("--list", help="List the scenes.")] = False,
        headless: Annotated[bool, typer.Option("--headless", help="Check every scene's claims without a window.")] = False,
        drags: Annotated[int, typer.Option(min=0, max=10**6, help="Random drags of each scene to check after.")] = 1000,
        present: Annotated[bool, typer.Option("--present", help="Full screen, with large text, for a lecture room.")] = False,
        screenshot: Annotated[Path | None, typer.Option(help="Draw the scene into this PNG file.")] = None,
        export: Annotated[
            Path | None, typer.Option(metavar="DIR", help="Write pictures of all scenes, or of SCENE, into this folder.")
        ] = None,
        format_: Annotated[
            Literal["png", "svg", "gif", "all"], typer.Option("--format", help="Of what --export writes.")
        ] = "png",
        steps: Annotated[bool, typer.Option("--steps", help="Let --export write each step of a scene, too.")] = False,
        size: Annotated[
            str | None,
            typer.Option(metavar="WxH", help="Size of a picture.", show_default="1280x800; 1920x1080 if --export"),
        ] = None,
        theme: Annotated[
            _Colours | None, typer.Option(help="Colours of a picture.", show_default="dark; light if --export")
        ] = None,
        with_: Annotated[Path | None, typer.Option("--with", help=services.with_help)] = None,
    ) -> None:
        """Open the lab: scenes of the collision detection one can touch."""
        from game.lab import command  # noqa: PLC0415  # its scenes, only where they are needed

        _refuse_contradictions(context, list_=list_, headless=headless, screenshot=screenshot, export=export)
        pixels = size_of(size or ("1280x800" if export is None else "1920x1080"))
        check_target(screenshot, "--screenshot", ".png")
        if pack is not None:
            _add_pack(pack)
        if arena is not None:
            scene = command.arena_line(arena)
        if list_:
            command.list_scenes()
            return
        if export is not None:
            check_pygame()
            command.export(scene, export, format_, pixels, theme or "light", steps=steps)
            return
        with functions_of(with_) as own:
            if headless and own is None:
                command.check_scenes(scene, drags, services.engine())
            elif headless and own is not None:
                command.check_yours(scene, drags, own)
            elif screenshot is not None:
                check_pygame()
                command.save_picture(scene, screenshot, pixels, theme or "dark", services.engine(), own, presents=present)
            else:
                _open_window(services, _LabWish(scene, own, present))

    return open_lab


def _refuse_contradictions(
    context: typer.Context, *, list_: bool, headless: bool, screenshot: Path | None, export: Path | None
) -> None:
    """BadInputError for an option that would do nothing beside the others."""
    if context.params.get("arena") is not None:
        refuse_ignored(context, "does nothing beside --arena", "scene")
    if list_:
        refuse_ignored(context, "does nothing beside --list", "scene", "arena", "headless", "drags", "with_", *_PICTURE_OPTIONS)
    if headless:
        refuse_ignored(context, "does nothing beside --headless", *_PICTURE_OPTIONS)
    else:
        refuse_ignored(context, "is for checking scenes; add --headless", "drags")
    if export is not None:
        refuse_ignored(context, "does nothing beside --export", "screenshot", "present", "with_")
    else:
        refuse_ignored(context, "is for pictures of all scenes; add --export DIR", "format_", "steps")
    if screenshot is None and export is None:
        refuse_ignored(context, "is for a picture; add --screenshot FILE", "size", "theme")


def _add_pack(path: Path) -> None:
    """Add a file's scenes."""
    from game.lab.packs.load import load_pack  # noqa: PLC0415  # only where there is one

    load_pack(path)


def _open_window(services: LabServices, wish: _LabWish) -> None:
    """Open the lab's window."""
    check_pygame()
    from game.loop.app import Services, lab  # noqa: PLC0415  # pygame, only where it is needed

    with services.settings() as settings:
        given = Services(engine=services.engine, settings=settings, lost=services.lost, functions=wish.own)
        lab(wish.scene, given, presents=wish.presents)
