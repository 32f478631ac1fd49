"""What a scene is. docs/lab.md says how to write one."""

from collections.abc import Callable
from enum import Enum
from typing import Any, NamedTuple

from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given, Parameter
from game.lab.kit.picture import Picture
from game.rules import TICK


class ViewBox(NamedTuple):
    """The part of the world that is shown at first.

    half: half of the width and half of the height that must fit, as one complex number; both world units.
    """

    centre: complex
    half: complex


class Claim(NamedTuple):
    """A fact about a scene, and whether it holds at some values."""

    fact: str
    holds: bool


class Preset(NamedTuple):
    """Values worth looking at.

    line: as in a share line, after the question mark; a parameter that it does not name has its default.
    """

    label: str
    line: str


class Motion(NamedTuple):
    """How a scene runs.

    start: the state at tick 0. step: the state one tick later. picture: what a state looks like.
    tick: seconds. ticks: after so many the scene stands still.
    """

    start: Callable[[Given], Any]
    step: Callable[[Given, Any], Any]
    picture: Callable[[Given, Any], Picture]
    tick: float = TICK
    ticks: int = 480


class EngineUse(Enum):
    """How a scene uses a second engine: not at all; for an answer while its toggle is on; or for a comparison all the time."""

    NONE = "none"
    TOGGLE = "toggle"
    ALWAYS = "always"


class LabScene(NamedTuple):
    """A scene of the lab: one idea of the collision detection, with values that can be changed and dragged.

    name: in the list and in share lines.
    title: one line.
    idea: one sentence.
    functions: those of `physics` that it shows, by name.
    parameters: what can be set.
    handles: what can be dragged; of two handles equally near to the pointer the first is taken.
    view_box: the part of the world that is shown at first.
    shows: the picture of given values, or how the scene runs.
    check: the facts that hold at given values.
    engine_use: how it uses a second engine.
    rows: of the documentation's table "Beyond the source" that it shows.
    presets: values worth looking at.
    """

    name: str
    title: str
    idea: str
    functions: tuple[str, ...]
    parameters: tuple[Parameter, ...]
    handles: tuple[Handle, ...]
    view_box: ViewBox
    shows: Callable[[Given], Picture] | Motion
    check: Callable[[Given], tuple[Claim, ...]]
    rows: tuple[int, ...] = ()
    presets: tuple[Preset, ...] = ()
    engine_use: EngineUse = EngineUse.NONE


def started(scene: LabScene, given: Given) -> Any:
    """The state of a scene at tick 0; None for one that does not run."""
    return scene.shows.start(given) if isinstance(scene.shows, Motion) else None


def stepped(scene: LabScene, given: Given, state: Any) -> Any:
    """The state one tick later."""
    return scene.shows.step(given, state) if isinstance(scene.shows, Motion) else state


def picture_of(scene: LabScene, given: Given, state: Any) -> Picture:
    """What a scene looks like in a state."""
    return scene.shows.picture(given, state) if isinstance(scene.shows, Motion) else scene.shows(given)
