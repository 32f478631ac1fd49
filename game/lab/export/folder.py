"""Every scene's picture as a file in a folder."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import pygame

from game.drawing.text import Type
from game.lab.export.files import FileKind, file_of
from game.lab.export.slide import SlideStyle
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.reveal import WHOLE, Reveal
from game.lab.session.session import Session, opened
from game.lab.session.share import SharedScene
from game.lab.window.screen import SHOWN
from game.lab.window.view import letters_for
from game.settings.values import THEMES
from game.system.errors import BadInputError
from game.system.files import write_atomically
from game.system.wording import quoted_path


class ExportWish(NamedTuple):
    """What is to be written.

    kinds: of each scene. size: pixels. colours: a key of `settings.THEMES`. steps: whether each is a file of its own, too.
    """

    kinds: tuple[FileKind, ...]
    size: tuple[int, int]
    colours: str
    steps: bool


def export_scenes(shared: Sequence[SharedScene], folder: Path, wish: ExportWish) -> list[Path]:
    """Write the scenes into a folder, which is made if it is not there; the files. One that is there already is replaced.

    A scene that is named with a step is written at that step. BadInputError where the folder cannot be written to.
    """
    pygame.font.init()
    style = SlideStyle(wish.size, THEMES[wish.colours], letters_for(Type()), SHOWN)
    files: list[Path] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for one in shared:
            session = opened(one)
            for kind in wish.kinds:
                files += _written(style, session, Reveal(one.step), folder, kind, steps=wish.steps)
    except OSError as error:
        raise BadInputError(f"--export {quoted_path(folder)}: cannot be written; {error.strerror or error}") from None
    return files


def _written(style: SlideStyle, session: Session, reveal: Reveal, folder: Path, kind: FileKind, *, steps: bool) -> list[Path]:
    """The files of one scene and one kind."""
    name, pan_zoom, count = session.scene.name, PanZoom.whole(session.scene, session.given), len(session.picture.steps)
    wanted = {f"{name}.{kind}": reveal}
    if steps and kind != "gif":
        wanted |= {f"{name}-{step}.{kind}": Reveal(step) if step < count else WHOLE for step in range(1, count + 1)}
    for file, one in wanted.items():
        write_atomically(folder / file, file_of(kind, style, session, one, pan_zoom))
    return [folder / file for file in wanted]
