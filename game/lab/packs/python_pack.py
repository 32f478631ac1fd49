"""A scene pack in Python: a file that defines SCENES, scenes written as docs/lab.md says.

The file is a program and is run as one. Whatever it does wrong is one line with the file's own line number; after it was
loaded, a scene that fails shows that line in place of its picture.
"""

import importlib.util
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

from game.lab.kit.picture import Pane, Picture
from game.lab.kit.scene import LabScene, Motion
from game.lab.session.checks import report
from game.system.errors import BadInputError
from game.system.files import read_input
from game.system.wording import quoted_message, quoted_path

_LARGEST = 1024 * 1024
_MODULE = "scene_pack"
_DRAGS, _SEED = 60, 1
"""Random drags that a scene must stand before it is shown."""
_TITLE = "TITLE"


def python_pack(path: Path) -> tuple[str, tuple[LabScene, ...]]:
    """The title and the scenes of a file; BadInputError, in one line, names the file, its line and what is wrong there."""
    read_input(path, "scene pack", _LARGEST)
    module = _run(path)
    scenes = getattr(module, "SCENES", None)
    if not isinstance(scenes, list | tuple) or not scenes or not all([isinstance(scene, LabScene) for scene in scenes]):
        raise BadInputError(f"{quoted_path(path)}: expected SCENES, a tuple of LabScene (docs/lab.md says how to write one)")
    for scene in scenes:
        _try_out(scene, path)
    return str(getattr(module, _TITLE, "your scenes")), tuple([_guarded(scene, path) for scene in scenes])


def _run(path: Path) -> ModuleType:
    """The file as a module."""
    spec = importlib.util.spec_from_file_location(_MODULE, path)
    if spec is None or spec.loader is None:
        raise BadInputError(f"{quoted_path(path)}: expected a name that ends in .py or .toml")
    module = importlib.util.module_from_spec(spec)
    sys.modules[_MODULE] = module
    try:
        spec.loader.exec_module(module)
    except Exception as error:  # noqa: BLE001  # a program of somebody else's: anything can go wrong in it
        raise BadInputError(_problem(error, path)) from None
    return module


def _try_out(scene: LabScene, path: Path) -> None:
    """Check a scene's claims at its defaults, its presets and after random drags."""
    try:
        found = report(scene, _DRAGS, _SEED)
    except BadInputError as error:
        raise BadInputError(f"{quoted_path(path)}: scene {scene.name}: {error}") from None
    except Exception as error:  # noqa: BLE001  # see above
        raise BadInputError(f"{_problem(error, path)} (scene {scene.name})") from None
    if found.failures:
        first = found.failures[0]
        raise BadInputError(f'{quoted_path(path)}: scene {scene.name}: "{first.fact}" does not hold: {first.line}')


def _guarded(scene: LabScene, path: Path) -> LabScene:
    """The scene; where its picture fails, a picture that says why."""

    def shown(picture: Callable[..., Picture]) -> Callable[..., Picture]:
        """A function that always gives a picture."""

        def guarded(*arguments: Any) -> Picture:
            try:
                return picture(*arguments)
            except Exception as error:  # noqa: BLE001  # see above
                return Picture((Pane(()),), (_problem(error, path),), None)

        return guarded

    if isinstance(scene.shows, Motion):
        return scene._replace(shows=scene.shows._replace(picture=shown(scene.shows.picture)))
    return scene._replace(shows=shown(scene.shows))


def _problem(error: Exception, path: Path) -> str:
    """What went wrong, in one line: the file, its line that was reached last, and the error."""
    if isinstance(error, SyntaxError):
        number = error.lineno
    else:
        lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if Path(frame.filename) == path]
        number = lines[-1] if lines else None
    where = quoted_path(path) if number is None else f"{quoted_path(path)}:{number}"
    return f"{where}: {type(error).__name__}: {quoted_message(str(error))}"
