"""The levels as a table and as pictures."""

import io
from pathlib import Path

from rich.console import Console
from rich.table import Table

from game.levels import Level, built_in
from game.levels.own import own_levels, own_levels_folder
from game.system.errors import BadInputError
from game.system.files import write_atomically
from game.system.output import print_error, print_line
from game.system.wording import quoted_path

_SIDE = 640
"""Of a picture, pixels."""


def list_levels() -> None:
    """Print a table of the levels that come with the game, then of the player's own; then what is wrong with other files."""
    _print_table(built_in(), [str(number) for number in range(1, len(built_in()) + 1)])
    own = own_levels()
    if own.levels:
        print_line(f"\nown levels, in {quoted_path(own_levels_folder())}")
        _print_table(own.levels, [path.name for path in own.paths])
    for problem in own.problems:
        print_error(f"polar-breakout: {problem}")


def save_pictures(folder: Path) -> None:
    """Draw every level into a PNG file; BadInputError where that cannot be written."""
    import pygame  # noqa: PLC0415  # only where it is needed

    from game.drawing.palette import DARK  # noqa: PLC0415
    from game.screens.level_pictures import thumbnail  # noqa: PLC0415

    pygame.font.init()
    own = own_levels()
    named = [(f"{number}-{_slug(level)}", level) for number, level in enumerate(built_in(), 1)]
    named += [(path.stem, level) for path, level in zip(own.paths, own.levels, strict=True)]
    for name, level in named:
        picture = io.BytesIO()
        pygame.image.save(thumbnail(level, _SIDE, DARK, whole=True), picture, "level.png")
        path = folder / f"{name}.png"
        try:
            folder.mkdir(parents=True, exist_ok=True)
            write_atomically(path, picture.getvalue())
        except OSError as error:
            raise BadInputError(f"--pictures {quoted_path(path)}: cannot be written; {error.strerror or error}") from None
        print_line(str(path))


def _print_table(levels: tuple[Level, ...], labels: list[str]) -> None:
    """One line a level. labels: what each is called by on the command line."""
    table = Table(box=None, pad_edge=False)
    for heading, right in (("#", True), ("name", False), ("bricks", True), ("layers", True), ("description", False)):
        table.add_column(heading, justify="right" if right else "left", no_wrap=heading in {"#", "name"})
    for label, level in zip(labels, levels, strict=True):
        stacks = [layers for ring in level.rings for layers in ring.slots() if layers > 0]
        table.add_row(label, level.name, str(len(stacks)), str(sum(stacks)), level.description)
    Console().print(table)


def _slug(level: Level) -> str:
    """A level's name as part of a file's name."""
    return "".join([letter if letter.isalnum() else "-" for letter in level.name.casefold()])
