"""The lab on the page: a scene that can be touched, with its values and switches beside it."""

import textwrap
from collections.abc import Sequence
from typing import NamedTuple

from game.drawing.camera import Camera, unit_of
from game.input.actions import Action
from game.input.signals import FocusLost, Pressed, Signal
from game.lab.kit.handles import Handle, dragged
from game.lab.kit.parameters import Clamped, Count, Parameter, Point, clamped, plain
from game.lab.kit.picture import Picture, Toggle
from game.lab.kit.scene import LabScene
from game.lab.registry import scene_named, scenes
from game.lab.session import session as sessions
from game.lab.session.session import PACES, Session
from game.lab.session.share import parsed, preset
from game.picture.display_list import DisplayList
from game.picture.lab import SeenLabPane, add_handles, add_pane
from game.web.client.menus import Screens
from game.web.client.messages import PageItem, PageMenu, PointerChange, WheelTurn
from game.web.client.state import PageScreen, PageState, Pictures

_WITHOUT = frozenset({"gap-field"})
"""Scenes that compute with numpy."""
_SMALLEST = 13.0
"""CSS pixels of text, at least."""
_LINE, _LETTER = 1.3, 0.57
"""Height of a line and width of a letter, in shares of its size."""
_CATCH, _FINGER = 1.2, 2.2
"""Units within which a press takes hold of a handle, by mouse and by finger."""
_ZOOM, _NEAREST, _FARTHEST = 1.15, 200.0, 0.05
"""Zoom of one step of the wheel, and its limits."""


class _Hold(NamedTuple):
    """What the pointer holds. handle: None for the world itself. offset: from the pointer to the handle, world units."""

    pointer: int
    handle: Handle | None
    offset: complex
    pixel: complex


class LabOnPage:
    """One scene."""

    def __init__(self, state: PageState, screens: Screens, line: str) -> None:
        """line: a share line, "" for the first scene. BadInputError where it names nothing."""
        self._state, self._screens = state, screens
        self._session = sessions.opened(parsed(line or shown_scenes()[0].name))
        if self._session.scene.name in _WITHOUT:
            state.told.append(f"{self._session.scene.name} needs numpy, which no browser has")
            self._session = sessions.opened(parsed(shown_scenes()[0].name))
        self._toggles = frozenset(Toggle)
        self._pan, self._zoom = 0j, 1.0
        self._hold: _Hold | None = None
        self._hovered: Handle | None = None
        self._fragment = ""
        self._empty = DisplayList()

    @property
    def session(self) -> Session:
        """The scene as it stands."""
        return self._session

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """None: the menu has all."""
        return ()

    @property
    def fragment(self) -> str:
        """The share line, while nothing moves: browsers stop pages that change their address all the time."""
        if (self._hold is None and not self._session.playing) or not self._fragment:
            self._fragment = f"lab/{self._session.line}"
        return self._fragment

    @property
    def described(self) -> str:
        """The title and the formula with its numbers."""
        picture = self._session.picture
        return ". ".join([self._session.scene.title, *picture.formula, picture.note])

    @property
    def menu(self) -> PageMenu:
        """The scene's values and what can be done with it."""
        session, scene = self._session, self._session.scene
        presets = (("", "-"), *[(one.line, one.label) for one in scene.presets])
        items = [
            PageItem("scene", "Scene", "choice", scene.name, tuple([(one.name, one.title) for one in shown_scenes()])),
            PageItem("preset", "Values worth a look", "choice", "", presets),
            *([] if not session.runs else _running(session)),
            *[item for parameter in scene.parameters for item in _fields(parameter, session.given.values[parameter.name])],
            *_switches(session.picture, self._toggles),
            PageItem("defaults", "Defaults"),
            PageItem("whole", "Whole scene"),
            PageItem("title", "Title"),
        ]
        return PageMenu(scene.title, (scene.idea, *session.notes), tuple(items), side=True)

    def answer(self, signal: Signal, size: tuple[int, int]) -> PageScreen:
        """The keys of the desktop's lab."""
        del size
        match signal:
            case Pressed(Action.BACK):
                return self._screens.title()
            case Pressed(Action.SERVE | Action.PAUSE):
                self._session = sessions.toggled(self._session)
            case Pressed(Action.STEP | Action.RIGHT):
                self._session = sessions.moved(self._session, 1)
            case Pressed(Action.STEP_BACK | Action.LEFT):
                self._session = sessions.moved(self._session, -1)
            case Pressed(Action.LESS | Action.MORE as action):
                self._session = sessions.paced(self._session, 1 if action is Action.MORE else -1)
            case Pressed(Action.RESTART):
                self._session = sessions.restarted(self._session)
            case Pressed(Action.START):
                self._pan, self._zoom = 0j, 1.0
            case Pressed(Action.THEME):
                self._state.change(self._state.settings.other_colours())
            case FocusLost():
                self._hold = None
        return self

    def point(self, message: PointerChange | WheelTurn, size: tuple[int, int]) -> None:
        """Handles and the world are dragged; the wheel zooms about the pointer."""
        pixel, panes = complex(message.x, message.y), self._panes(size)
        seen = next((one for one in panes if _contains(one, pixel)), panes[0])
        if isinstance(message, WheelTurn):
            self._zoom_about(seen, pixel, message.steps, size)
        elif message.phase == "down":
            reach = (_FINGER if message.touch else _CATCH) * seen.unit
            handle = self._handle_at(seen, pixel, reach)
            offset = 0j if handle is None else handle.position(self._session.given) - seen.camera.unproject(pixel)
            self._hold = _Hold(message.id, handle, offset, pixel)
        elif message.phase == "move":
            self._move(message, seen, pixel)
        elif self._hold is not None and self._hold.pointer == message.id:
            self._hold = None

    def choose(self, item: str, value: str) -> PageScreen:
        """What a control does."""
        session, scene = self._session, self._session.scene
        kind, _, name = item.partition(":")
        match kind:
            case "title":
                return self._screens.title()
            case "scene":
                self._session = sessions.fresh(scene_named(value), None)
                self._pan, self._zoom, self._hovered = 0j, 1.0, None
            case "preset" if value:
                self._session = sessions.changed(session, Clamped(preset(scene, value, None), ()))
            case "value":
                self._session = sessions.changed(session, _typed(session, name, value))
            case "toggle":
                self._toggles = self._toggles ^ {Toggle(name)}
            case "pace" if value.isdecimal():
                self._session = sessions.paced(session, int(value) - session.pace)
            case "whole":
                self._pan, self._zoom = 0j, 1.0
            case _:
                change = _COMMANDS.get(kind)
                self._session = session if change is None else change(session)
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> PageScreen:
        """Let a scene that runs run."""
        del size
        self._session = sessions.later(self._session, seconds)
        return self

    def draw(self, out: Pictures, size: tuple[int, int]) -> None:
        """The panes with their handles, the formula, the line that decides, and the note."""
        picture, theme, unit = self._session.picture, self._state.theme, _unit(size, self._state.density)
        out.backdrop = self._empty
        panes = self._panes(size)
        for pane, seen in zip(picture.panes, panes, strict=True):
            add_pane(out.frame, pane, seen)
            if pane.has_handles:
                add_handles(out.frame, self._session.scene.handles, self._session.given, self._hovered, seen)
        top = panes[0].extent.imag + 0.9 * unit
        colours = (theme.text, theme.faint, theme.accent)
        for words, colour in zip(_words(picture, size, unit), colours, strict=True):
            for line in words:
                out.frame.text(line, unit, complex(0.7 * unit, top), colour, 0.0)
                top += _LINE * unit

    def _panes(self, size: tuple[int, int]) -> list[SeenLabPane]:
        """Where the panes are: side by side above the words; on a narrow canvas one above the other."""
        picture, unit = self._session.picture, _unit(size, self._state.density)
        lines = sum(map(len, _words(picture, size, unit)))
        room = complex(size[0], max(size[1] - (lines + 0.8) * _LINE * unit, 0.4 * size[1]))
        count = len(picture.panes)
        across = complex(1.0 / count, 1.0) if room.real >= room.imag else complex(1.0, 1.0 / count)
        extent = complex(room.real * across.real, room.imag * across.imag)
        step = complex(extent.real, 0.0) if across.real < 1.0 else complex(0.0, extent.imag)
        camera, theme = self._camera(extent), self._state.theme
        corners = [k * step for k in range(count)]
        return [
            SeenLabPane(corner, extent, camera._replace(centre=camera.centre + corner), theme, unit, self._toggles)
            for corner in corners
        ]

    def _camera(self, extent: complex) -> Camera:
        """The camera of a pane at the canvas' corner."""
        box = self._session.scene.view_box
        half = box.half / self._zoom
        scale = max(min(extent.real / (2.0 * half.real), extent.imag / (2.0 * half.imag)), 1e-3)
        return Camera(extent / 2.0 - (box.centre + self._pan).conjugate() * scale, scale)

    def _handle_at(self, seen: SeenLabPane, pixel: complex, reach: float) -> Handle | None:
        """The handle that a press at a pixel takes hold of: the nearest within reach, else one within whose ball it is."""
        given, handles = self._session.given, self._session.scene.handles
        point = seen.camera.unproject(pixel)
        near = [(abs(handle.position(given) - point), k) for k, handle in enumerate(handles)]
        found = [one for one in near if one[0] * seen.camera.scale <= reach]
        found = found or [(far, k) for far, k in near if (own := handles[k].reach) is not None and far <= own(given)]
        return handles[min(found)[1]] if found else None

    def _move(self, message: PointerChange, seen: SeenLabPane, pixel: complex) -> None:
        """The pointer moved: with what it holds, or over what it could take."""
        hold = self._hold
        if hold is None or hold.pointer != message.id:
            self._hovered = None if message.touch else self._handle_at(seen, pixel, _CATCH * seen.unit)
            return
        if hold.handle is None:
            self._pan -= (pixel - hold.pixel).conjugate() / seen.camera.scale
        else:
            target = seen.camera.unproject(pixel) + hold.offset
            parameters = self._session.scene.parameters
            self._session = sessions.changed(self._session, dragged(parameters, self._session.given, hold.handle, target))
        self._hovered, self._hold = hold.handle, hold._replace(pixel=pixel)

    def _zoom_about(self, seen: SeenLabPane, pixel: complex, steps: float, size: tuple[int, int]) -> None:
        """Zoom; what is under the pixel stays there."""
        before = seen.camera.unproject(pixel)
        self._zoom = min(max(self._zoom * _ZOOM ** min(max(steps, -20.0), 20.0), _FARTHEST), _NEAREST)
        after = next(one for one in self._panes(size) if one.corner == seen.corner)
        self._pan += before - after.camera.unproject(pixel)


_COMMANDS = {
    "run": sessions.toggled,
    "forward": lambda session: sessions.moved(session, 1),
    "back": lambda session: sessions.moved(session, -1),
    "restart": sessions.restarted,
    "defaults": sessions.reset,
}
"""What the buttons do."""


def shown_scenes() -> list[LabScene]:
    """The scenes that a browser can show."""
    return [scene for scene in scenes() if scene.name not in _WITHOUT]


def _unit(size: tuple[int, int], density: float) -> float:
    """Size of text, pixels."""
    return max(unit_of(size) * 0.8, _SMALLEST * density)


def _words(picture: Picture, size: tuple[int, int], unit: float) -> tuple[list[str], list[str], list[str]]:
    """The lines below the panes: the formula, the line that decides, the note."""
    letters = max(int(size[0] / (unit * _LETTER)), 20)
    cited = "" if picture.cited is None else f"{picture.cited.where}:  {picture.cited.text}"
    texts: tuple[Sequence[str], ...] = (picture.formula, (cited,), (picture.note,))
    formula, decided, note = ([line for text in group for line in textwrap.wrap(text, letters)] for group in texts)
    return formula, decided, note


def _contains(seen: SeenLabPane, pixel: complex) -> bool:
    """Whether a pixel is in a pane."""
    inside = pixel - seen.corner
    return 0.0 <= inside.real < seen.extent.real and 0.0 <= inside.imag < seen.extent.imag


def _running(session: Session) -> list[PageItem]:
    """The controls of a scene that runs."""
    paces = tuple([(str(number), f"{pace:g} x") for number, pace in enumerate(PACES)])
    return [
        PageItem("run", "Stop" if session.playing else "Run"),
        PageItem("forward", "Step"),
        PageItem("back", "Back"),
        PageItem("restart", "Restart"),
        PageItem("pace", "Pace", "choice", str(session.pace), paces),
    ]


def _fields(parameter: Parameter, value: complex) -> list[PageItem]:
    """The fields of a parameter: one, or two for a point."""
    low, high = float(parameter.low), float(parameter.high)
    step = 1.0 if isinstance(parameter, Count) else parameter.step
    if isinstance(parameter, Point):
        parts = (("x", value.real), ("y", value.imag))
        return [
            PageItem(
                f"value:{parameter.name}.{axis}",
                f"{parameter.label} {axis}",
                "number",
                plain(number),
                hint=parameter.meaning,
                low=low,
                high=high,
            )
            for axis, number in parts
        ]
    unit = getattr(parameter, "unit", "")
    label = f"{parameter.label} ({unit})" if unit else parameter.label
    number = plain(value.real)
    return [PageItem(f"value:{parameter.name}", label, "number", number, hint=parameter.meaning, low=low, high=high, step=step)]


def _switches(picture: Picture, shown: frozenset[Toggle]) -> list[PageItem]:
    """A switch for everything that can be hidden."""
    return [
        PageItem(f"toggle:{toggle.value}", toggle.value, "switch", str(toggle in shown))
        for toggle in Toggle
        if toggle in picture.toggles
    ]


def _typed(session: Session, name: str, value: str) -> Clamped:
    """The values after one was typed; a note says where it is no number."""
    try:
        number = float(value)
    except ValueError:
        return Clamped(session.given, (f"'{value[:40]}' is not a number",))
    parameter, _, axis = name.partition(".")
    before = session.given.values.get(parameter, 0j)
    if axis:
        return clamped(
            session.scene.parameters,
            session.given,
            {parameter: complex(number, before.imag) if axis == "x" else complex(before.real, number)},
        )
    return clamped(session.scene.parameters, session.given, {parameter: number})
