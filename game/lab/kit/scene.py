"""What a scene is, and how to write one.

1. Add one file to a chapter's folder in `game/lab/scenes/`, and name it in the tuple of that folder's `__init__.py`, at its
   position in the lab's list. Its name with hyphens is the scene's.
2. Choose the numbers one can set: `Number` (angles in degrees), `Count`, `Point`, each with range and default.
3. Write `_picture(given) -> Picture`: pure; read the numbers with `given.number("r")`, `given.angle("half_angle")` (radians),
   `given.point("ball")`, ask `physics`, and answer with marks, the formula with the numbers in it, and the line that
   decides (`code_line(function, "a part of the line")` or `source_line("Narrow phase", "the line")`). `game/lab/kit/marks.py`
   has the marks of a ball, a sector, a contact, a second opinion. Two worlds side by side are two `Pane`s.
4. Write `_check(given) -> tuple[Claim, ...]`: facts that must hold for every setting in range, each with whether it does.
   They are asserted by pytest for the defaults, the presets, saved cases, and after a thousand random drags.
5. Say what can be dragged, what matters most first: `handles.point`, `vector`, `polar_vector`, `sector_handles`, or a
   `Handle` of your own.
6. `SCENE = Scene(...)` with title, idea, and the rows of the README's table "Beyond the source" that it explains.

A scene that runs gives `Motion(start, step, picture)` instead of `_picture`: `start(given)` is the state at tick 0,
`step(given, state)` the state one tick later, `picture(given, state)` what it looks like. All three are pure and the state
is a value (NamedTuples, tuples, numbers): so stepping back is a list of states, and a state can be hashed and shared. Any
changed setting starts it anew. Degenerate settings are in range on purpose: say in `Picture.note` what happens, and why.
Without another engine `given.engine` is None: leave its marks out.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given, Parameter
from game.lab.kit.picture import Picture


class View(NamedTuple):
    """The part of the world that is seen at first."""

    centre: complex
    half: complex  # half the width and half the height that must fit


class Claim(NamedTuple):
    """A fact about a scene at some values, and whether it holds."""

    fact: str
    holds: bool


class Preset(NamedTuple):
    """Values worth looking at."""

    label: str
    line: str  # as in a share line, after the question mark; what is not named has its default


class Motion(NamedTuple):
    """How a scene runs. A tick is 1/240 s unless `tick` says otherwise."""

    start: Callable[[Given], Any]
    step: Callable[[Given, Any], Any]
    picture: Callable[[Given, Any], Picture]
    tick: float = 1.0 / 240.0
    ticks: int = 480  # it stands still after that many


class Scene(NamedTuple):
    """One idea, to be touched."""

    name: str
    title: str
    idea: str  # in one sentence
    functions: tuple[str, ...]  # of the source that it shows, by name
    parameters: tuple[Parameter, ...]
    handles: tuple[Handle, ...]
    view: View
    shows: Callable[[Given], Picture] | Motion
    check: Callable[[Given], tuple[Claim, ...]]
    rows: tuple[int, ...] = ()  # of the table "Beyond the source" that it explains
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
