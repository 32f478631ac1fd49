"""The picture of a headless game: its file, and its size as it is written on the command line."""

import contextlib
import tempfile
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from game.effects import after_all
from game.rules import Game, Ticked
from game.system.errors import BadInputError
from game.system.pygame_ce import check_pygame
from game.system.wording import quoted, quoted_path


class PlayedGame(NamedTuple):
    """How a game ended, and the ticks before whose effects are still to be seen."""

    game: Game
    passed: deque[Ticked]


def picture_folders() -> Iterator[Path]:
    """Where a picture may be saved that nobody has named a file for: the working directory, else the one for such files."""
    yield Path()
    with contextlib.suppress(OSError):  # there may be none
        yield Path(tempfile.gettempdir())


def save_picture(last: PlayedGame, path: Path, size: tuple[int, int], *, solid: bool = False) -> None:
    """Draw a game into a PNG file; BadInputError where it cannot be written."""
    check_pygame()
    from game.input.view import FLAT, SOLID  # noqa: PLC0415  # pygame, only where it is needed
    from game.screenshot import save_screenshot  # noqa: PLC0415

    try:
        save_screenshot(last.game, path, size, view=SOLID if solid else FLAT, effects=after_all(last.passed))
    except OSError as error:
        raise BadInputError(f"--screenshot {quoted_path(path)}: cannot write; {error.strerror or error}") from None


def size_of(text: str) -> tuple[int, int]:
    """Width and height from "WxH"."""
    width, cross, height = text.partition("x")
    if not (cross and width.isdecimal() and height.isdecimal()):
        raise BadInputError(f"--size {quoted(text)}: expected WIDTHxHEIGHT in pixels, such as 1280x800")
    pixels = int(width[:9]), int(height[:9])
    if not all([16 <= length <= 16384 for length in pixels]):
        raise BadInputError(f"--size {quoted(text)}: expected 16 to 16384 pixels each way")
    return pixels
