"""Every scene there is, by name. `game/lab/scenes/__init__.py` lists them; a scene pack adds a chapter of its own."""

import difflib

from game.lab.kit.scene import LabScene
from game.system.errors import BadInputError
from game.system.wording import quoted

_ADDED: dict[str, tuple[LabScene, ...]] = {}


def add_chapter(title: str, added: tuple[LabScene, ...]) -> None:
    """Let scenes come before the others, in a chapter of that title, until this process ends."""
    _ADDED[title] = (*_ADDED.get(title, ()), *added)


def scenes() -> tuple[LabScene, ...]:
    """All scenes, chapter by chapter."""
    return tuple([scene for chapter in chapters().values() for scene in chapter])


def chapters() -> dict[str, tuple[LabScene, ...]]:
    """All scenes by chapter, each chapter by the name of its folder in words."""
    from game.lab.scenes import CHAPTERS  # noqa: PLC0415  # some thirty modules, which the game does not need before L is pressed

    own = {chapter.__name__.rpartition(".")[2].replace("_", " "): chapter.SCENES for chapter in CHAPTERS}
    return {**_ADDED, **own}


def scene_named(name: str) -> LabScene:
    """The scene of that name; BadInputError with the names near to it."""
    found = {scene.name: scene for scene in scenes()}
    if name in found:
        return found[name]
    near = difflib.get_close_matches(name, found, n=3, cutoff=0.4)
    hint = f"near: {', '.join(near)}" if near else "--list names them all"
    raise BadInputError(f"lab: no scene '{quoted(name)}'; {hint}")
