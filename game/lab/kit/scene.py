"""What a scene is, and how to write one.

1. Add a file to a chapter's folder in `game/lab/scenes/`, and list it in that folder's `__init__.py`, at its position in the
   lab's list. The file's name with hyphens is the scene's name.
2. Choose the numbers that can be set: `Number` (angles in degrees), `Count`, `Point`, each with range and default.
3. Write `_picture(given) -> Picture`. It is pure. It reads the numbers with `given.number("r")`, `given.angle("half_angle")`
   (radians) and `given.point("ball")`, asks `physics`, and returns marks, the formula with the numbers in it, and the line
   that decides: `code_line(function, "the line")` or `source_line("Narrow phase", "the line")`. `game/lab/kit/marks.py` has
   the marks of a ball, a sector, a contact and a second opinion. Two worlds side by side are two `Pane`s.
4. Write `_check(given) -> tuple[Claim, ...]`: facts that hold for every setting in range, each with whether it holds now.
   pytest asserts them at the defaults, at the presets, at saved cases and after a thousand random drags.
5. Say what can be dragged, the most important first: `handles.point`, `vector`, `polar_vector`, `sector_handles`, or a
   `Handle` of your own.
6. `SCENE = Scene(...)` with title, idea, and the rows of the documentation's table "Beyond the source" that it shows.

A scene that runs gives `Motion(start, step, picture)` instead of `_picture`: `start(given)` is the state at tick 0,
`step(given, state)` the state one tick later, `picture(given, state)` what it looks like. All three are pure, and the state
is a value (NamedTuples, tuples, numbers). So a step back looks up the state before, and a state can be hashed and shared.
Any changed setting starts it anew.

Degenerate settings are in range on purpose: `Picture.note` says what happens there, and why. Without a second engine
`given.engine` is None, and its marks are left out.
"""

from collections.abc import Callable
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


class Scene(NamedTuple):
    """One idea of the collision detection, to be touched.

    name: in the list and in share lines.
    title: one line.
    idea: one sentence.
    functions: those of `physics` that it shows, by name.
    parameters: what can be set.
    handles: what can be dragged; of two handles equally near to the pointer the first is taken.
    view_box: the part of the world that is shown at first.
    shows: the picture of given values, or how the scene runs.
    check: the facts that hold at given values.
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


def started(scene: Scene, given: Given) -> Any:
    """The state of a scene at tick 0; None for one that does not run."""
    return scene.shows.start(given) if isinstance(scene.shows, Motion) else None


def stepped(scene: Scene, given: Given, state: Any) -> Any:
    """The state one tick later."""
    return scene.shows.step(given, state) if isinstance(scene.shows, Motion) else state


def picture_of(scene: Scene, given: Given, state: Any) -> Picture:
    """What a scene looks like in a state."""
    return scene.shows.picture(given, state) if isinstance(scene.shows, Motion) else scene.shows(given)
