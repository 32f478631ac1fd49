"""Every scene there is, by name. `game/lab/scenes/__init__.py` lists them."""

import difflib

from game.lab.kit.scene import LabScene
from game.system.errors import BadInputError
from game.system.wording import quoted


def scenes() -> tuple[LabScene, ...]:
    """All scenes, chapter by chapter."""
    from game.lab.scenes import SCENES  # noqa: PLC0415  # some thirty modules, which the game does not need before L is pressed

    return SCENES


def chapters() -> dict[str, tuple[LabScene, ...]]:
    """All scenes by chapter, each chapter by the name of its folder in words."""
    from game.lab.scenes import CHAPTERS  # noqa: PLC0415  # as for `scenes`

    return {chapter.__name__.rpartition(".")[2].replace("_", " "): chapter.SCENES for chapter in CHAPTERS}


def scene_named(name: str) -> LabScene:
    """The scene of that name; BadInputError with the names near to it."""
    found = {scene.name: scene for scene in scenes()}
    if name in found:
        return found[name]
    near = difflib.get_close_matches(name, found, n=3, cutoff=0.4)
    hint = f"near: {', '.join(near)}" if near else "--list names them all"
    raise BadInputError(f"lab: no scene '{quoted(name)}'; {hint}")
