"""Every scene there is: the modules of `game/lab/scenes/` that have a `SCENE`."""

import difflib
import importlib
import pkgutil
from functools import cache

from game.lab import scenes as folder
from game.lab.kit.scene import Chapter, Scene
from game.system.errors import BadInputError
from game.system.wording import quoted


@cache
def scenes() -> tuple[Scene, ...]:
    """All scenes, in the order of their chapters."""
    names = sorted(
        [module.name for module in pkgutil.walk_packages(folder.__path__, f"{folder.__name__}.") if not module.ispkg]
    )
    modules = [importlib.import_module(name) for name in names]
    found: list[Scene] = [module.SCENE for module in modules]
    chapters = list(Chapter)
    return tuple(sorted(found, key=lambda scene: (chapters.index(scene.chapter), scene.place, scene.name)))


def scene_named(name: str) -> Scene:
    """The scene of that name; BadInputError with the names near to it."""
    found = {scene.name: scene for scene in scenes()}
    if name in found:
        return found[name]
    near = difflib.get_close_matches(name, found, n=3, cutoff=0.4)
    hint = f"near: {', '.join(near)}" if near else "--list names them all"
    raise BadInputError(f"lab: no scene '{quoted(name)}'; {hint}")
