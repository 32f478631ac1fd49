"""What the lab writes for its user: the clipboard, a case, a picture. Each returns a sentence that says whether that worked."""

from pathlib import Path

import platformdirs
import pygame

from game.lab.export.files import FileKind, file_of
from game.lab.export.slide import SlideStyle
from game.lab.kit.arena_level import ARENA, saved_arena
from game.lab.session.cases import case_file, save_case
from game.lab.session.commands import Command
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.reveal import Reveal
from game.lab.session.session import Session
from game.levels.own import own_levels_folder
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import write_new
from game.system.wording import quoted_path

PICTURES: dict[Command, FileKind] = {Command.SAVE_PNG: "png", Command.SAVE_SVG: "svg", Command.SAVE_GIF: "gif"}
"""Commands that write a picture, and its kind."""
WRITING = frozenset({Command.COPY, Command.SAVE, Command.SAVE_LEVEL, *PICTURES})
"""Commands that leave the lab as it is and write something."""


def written(command: Command, session: Session, line: str) -> str:
    """Copy a share line, save a case, or a level."""
    if command is Command.SAVE_LEVEL:
        return saved_level(session)
    return copied(line) if command is Command.COPY else saved_case(session.line)


def saved_level(session: Session) -> str:
    """Save an arena of one's own as a new file among the player's levels."""
    if session.scene.name != ARENA:
        return f"only the scene {ARENA} is saved as a level"
    arena = saved_arena(session.given)
    if arena.problem:
        return f"no level yet: {arena.problem}"
    folder = own_levels_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path = write_new(folder, "my-arena.toml", arena.text.encode())
    except OSError as error:
        return f"not saved: {quoted_path(folder)}: {error.strerror or error}"
    return f"saved: python -m game --level {path}"


def copied(line: str) -> str:
    """Put a share line on the clipboard."""
    try:
        pygame.scrap.put_text(f'python -m game lab "{line}"')
    except pygame.error as error:
        return f"no clipboard here ({error}); the line is at the right"
    return "copied: the line that opens this"


def saved_case(line: str) -> str:
    """Save a share line as a case."""
    try:
        return save_case(line, case_file())
    except BadInputError as error:
        return str(error)


def saved_picture(kind: FileKind, style: SlideStyle, session: Session, reveal: Reveal, pan_zoom: PanZoom) -> str:
    """Save what is shown of a scene as a new file in the working directory, or where that cannot be, in the user's data."""
    try:
        data = file_of(kind, style, session, reveal, pan_zoom)
    except EnvironmentMissingError as error:
        return str(error)
    name = f"{session.scene.name}.{kind}"
    try:
        return f"saved: {write_new(Path(), name, data).absolute()}"
    except OSError:
        return _saved_in_user_data(name, data)


def _saved_in_user_data(name: str, data: bytes) -> str:
    """Save a new file in the user's data folder."""
    folder = platformdirs.user_data_path("polar-breakout", appauthor=False)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return f"saved: {write_new(folder, name, data)}"
    except OSError as error:
        return f"not saved: {quoted_path(folder / name)}: {error.strerror or error}"
