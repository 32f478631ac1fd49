"""A scene pack in TOML: scenes of the lab with other values, titles and words. It runs no code."""

import tomllib
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta

from game.lab.kit.parameters import Parameter
from game.lab.kit.scene import LabScene, Preset
from game.lab.session.share import parsed
from game.lab.session.share import preset as preset_values
from game.system.errors import BadInputError
from game.system.files import read_input
from game.system.wording import quoted_message, quoted_path

_LARGEST = 256 * 1024
_Name = Annotated[str, Meta(pattern="^[a-z0-9]+(-[a-z0-9]+)*$", max_length=40)]
_Line = Annotated[str, Meta(min_length=1, max_length=120)]


class _PackedScene(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One scene. shows: a share line; its values become the defaults. title, idea: those of the shown scene if left out."""

    name: _Name
    shows: str
    title: _Line = ""
    idea: _Line = ""
    presets: dict[str, str] = {}


class _ScenePackFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The file. title: of the pack, in the list of scenes."""

    scenes: Annotated[list[_PackedScene], Meta(min_length=1, max_length=100)]
    title: _Line = "your scenes"


def toml_pack(path: Path) -> tuple[str, tuple[LabScene, ...]]:
    """The title and the scenes of a file; BadInputError, in one line, names the file, the scene and what is wrong with it."""
    where = quoted_path(path)
    try:
        data = read_input(path, "scene pack", _LARGEST)
        said = msgspec.convert(tomllib.loads(data.decode()), _ScenePackFile)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise BadInputError(f"{where}: not TOML; {quoted_message(str(error))}") from None
    except msgspec.ValidationError as error:
        raise BadInputError(f"{where}: {quoted_message(str(error))}") from None
    return said.title, tuple([_scene(one, where) for one in said.scenes])


def _scene(packed: _PackedScene, where: str) -> LabScene:
    """A scene of the lab with the values of a share line as its defaults."""
    try:
        shown = parsed(packed.shows)
        for line in packed.presets.values():
            preset_values(shown.scene, line)
    except BadInputError as error:
        raise BadInputError(f"{where}: scene {packed.name}: {error}") from None
    return shown.scene._replace(
        name=packed.name,
        title=packed.title or shown.scene.title,
        idea=packed.idea or shown.scene.idea,
        parameters=tuple([_with_default(one, shown.given.values[one.name]) for one in shown.scene.parameters]),
        presets=tuple([Preset(label, line) for label, line in packed.presets.items()]) or shown.scene.presets,
    )


def _with_default(parameter: Parameter, value: complex) -> Parameter:
    """A parameter with another default."""
    return parameter._replace(default=value)  # type: ignore[arg-type]  # of the parameter's own kind: a share line checks it
