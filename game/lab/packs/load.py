"""Adds the scenes of a pack to those of the lab."""

from pathlib import Path

from game.lab.packs.python_pack import python_pack
from game.lab.packs.toml_pack import toml_pack
from game.lab.registry import add_chapter, scenes
from game.system.errors import BadInputError
from game.system.wording import quoted_path


def load_pack(path: Path) -> None:
    """Add a file's scenes as the first chapter of the lab; BadInputError, in one line, for a file that cannot be used."""
    title, added = toml_pack(path) if path.suffix.casefold() == ".toml" else python_pack(path)
    names = [scene.name for scene in (*added, *scenes())]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise BadInputError(f"{quoted_path(path)}: there is already a scene {twice}; expected another name")
    add_chapter(title, added)
