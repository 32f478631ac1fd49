"""Every scene there is, by name. `game/lab/scenes/__init__.py` lists them."""

import difflib

from game.lab.kit.scene import Scene
from game.system.errors import BadInputError
from game.system.wording import quoted


def scenes() -> tuple[Scene, ...]:
    """All scenes, chapter by chapter."""
    from game.lab.scenes import SCENES  # noqa: PLC0415  # some thirty modules, which the game does not need before L is pressed

    return SCENES


def scene_named(name: str) -> Scene:
    """The scene of that name; BadInputError with the names near to it."""
    found = {scene.name: scene for scene in scenes()}
    if name in found:
        return found[name]
    near = difflib.get_close_matches(name, found, n=3, cutoff=0.4)
    hint = f"near: {', '.join(near)}" if near else "--list names them all"
    raise BadInputError(f"lab: no scene '{quoted(name)}'; {hint}")
