"""The lab's screen: events become changes of the session, the session becomes a picture."""

from collections.abc import Callable

import pygame

from game.drawing.palette import Theme
from game.input.devices import as_key
from game.input.keys import code_among, position_in
from game.input.repeat import Repeat
from game.input.signals import KeyboardState, Signal
from game.lab.kit.handles import Handle, dragged
from game.lab.kit.parameters import Clamped, clamped
from game.lab.kit.picture import Picture, Toggle
from game.lab.registry import scene_named, scenes
from game.lab.session import session as sessions
from game.lab.session.cases import case_file, save_case
from game.lab.session.session import Session
from game.lab.session.share import preset
from game.lab.window.canvas import PaneCanvas, write_words
from game.lab.window.commands import BOUND, TOGGLE_KEYS, Command, command_of
from game.lab.window.dragging import Drag, PaneView, drag_at, draw_handles
from game.lab.window.help import draw_help
from game.lab.window.layout import layout_of, pane_areas
from game.lab.window.marks import draw_marks
from game.lab.window.pan_zoom import PanZoom
from game.lab.window.pane_lines import draw_pane_lines
from game.lab.window.widgets import PresetChosen, Refused, Request, SceneChosen, Side, ValueRequested
from game.lab.window.words import TextSheet, draw_head, draw_notice, draw_small_print, draw_words
from game.lab.yours.pane import with_yours
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.system.errors import BadInputError

SHOWN = frozenset(Toggle) - {Toggle.PYMUNK}
"""What is shown at first."""
_NOTICE_SECONDS = 5.0
_MODIFIERS = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META
"""Keys pressed together with one of these belong to the desktop."""
_REPEATED = frozenset({Command.FORWARD, Command.BACK})
"""Commands that a held key gives again and again: single steps."""

_CHANGES: dict[Command, Callable[[Session], Session]] = {
    Command.PLAY: sessions.toggled,
    Command.FORWARD: lambda session: sessions.moved(session, 1),
    Command.BACK: lambda session: sessions.moved(session, -1),
    Command.RESTART: sessions.restarted,
    Command.SLOWER: lambda session: sessions.paced(session, -1),
    Command.FASTER: lambda session: sessions.paced(session, 1),
    Command.DEFAULTS: sessions.reset,
}
"""Commands that only change the session."""


class Lab:
    """One scene at a time, and everything that can be done to it."""

    def __init__(self, shared: AppState, session: Session, under: Screen | None = None) -> None:
        """Open with a session. under: the screen to go back to; None leaves the program."""
        self._shared, self._session, self._under = shared, session, under
        self._shown = SHOWN
        self._pan_zoom = _whole(session)
        self._drawn: tuple[Session, Picture] | None = None
        self._side: tuple[tuple[tuple[int, int], Theme, str], Side] | None = None
        self._drag: Drag | None = None
        self._repeat: tuple[Repeat, Command] | None = None
        self._pointer = -1 - 1j  # pixels
        self._pixels_per_point = 1 + 1j
        self._seconds = 0.0  # since the last picture
        self._notice, self._notice_left = "", 0.0
        self._help = False

    @property
    def session(self) -> Session:
        """The scene as it stands."""
        return self._session

    def answer(self, signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """Let go of a repeating key that is up; everything else is heard as an event of the window."""
        if self._repeat is not None and isinstance(signal, KeyboardState) and self._repeat[0].position not in signal.down:
            self._repeat = None
        return self

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> Screen | None:
        """React to an event of the window."""
        self._pixels_per_point = pixels_per_point
        event = as_key(event) or event
        if event.type == pygame.WINDOWFOCUSLOST:
            self._repeat = None
        if self._help:
            self._help = event.type not in (pygame.KEYDOWN, pygame.MOUSEBUTTONDOWN)
            return self
        if event.type == pygame.KEYDOWN:
            return self._key(event, size)
        taken, request = self._widgets(size).hear(event)
        if request is not None:
            return self._do(request)
        if not taken:
            self._mouse(event, size)
        return self

    def advance(self, seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Let time pass."""
        self._session = sessions.later(self._session, seconds)
        if self._repeat is not None:
            held, command = self._repeat
            held, due = held.later(seconds)
            self._repeat = held, command
            if due:
                self._obey(command)
        self._seconds += seconds
        self._notice_left -= seconds
        functions = self._shared.functions
        if functions is not None and (news := functions.refresh()):
            self._drawn = None
            self._tell(news)
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The world, the words, the widgets."""
        theme, type_, size = self._shared.theme, self._shared.type, surface.get_size()
        sheet = TextSheet(surface, layout_of(size), theme, type_)
        surface.fill(theme.background)
        self._draw_world(sheet)
        bottom = float(sheet.layout.world.bottom)
        for note in reversed(self._notes()):
            bottom = draw_notice(sheet, note, bottom - sheet.unit * 0.5)
        picture, side = self._picture(), self._widgets(size)
        draw_head(sheet, self._session.scene)
        draw_words(sheet, picture)
        side.show(self._session, self._shown, picture.toggles)
        draw_small_print(sheet, side.bottom, (f"state hash {sessions.state_hash(self._session)}", self._session.line))
        side.draw(surface, self._session, self._seconds, self._pixels_per_point)
        self._seconds = 0.0
        if self._help:
            draw_help(surface, theme, type_)

    def _draw_world(self, sheet: TextSheet) -> None:
        """Every pane with its title and the handles."""
        given, views = self._session.given, self._pane_views(sheet.surface.get_size())
        hovered = self._hovered(views, sheet.unit)
        for pane, view in zip(self._picture().panes, views, strict=True):
            pygame.draw.rect(sheet.surface, sheet.theme.ground, view.area)
            canvas = PaneCanvas(sheet.surface, view.area, view.camera, sheet.theme, sheet.type, sheet.unit, self._shown)
            draw_marks(canvas, pane.marks)
            if pane.title:
                top = complex(view.area.centerx, view.area.top + sheet.unit * 0.4)
                write_words(canvas, top, pane.title, sheet.theme.text, "midtop")
            if view.area.left > sheet.layout.world.left:
                pygame.draw.line(sheet.surface, sheet.theme.panel_edge, view.area.topleft, view.area.bottomleft)
            draw_handles(canvas, given, view.handles, hovered if hovered in view.handles else None)
            draw_pane_lines(sheet.surface, view.area, pane, sheet.theme, sheet.type, sheet.unit)

    def _key(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """React to a key. While a field is typed into, the key is the field's."""
        side = self._widgets(size)
        if side.busy:
            if event.key == pygame.K_ESCAPE:
                side.release_focus()
                return self
            _, request = side.hear(event)
            return self if request is None else self._do(request)
        key = code_among(event, BOUND)
        toggle, command = TOGGLE_KEYS.get(key), command_of(key)
        request = toggle or command
        if request is None or event.mod & _MODIFIERS:
            return self
        self._repeat = None if command is None or command not in _REPEATED else (Repeat(position_in(event)), command)
        return self._do(request)

    def _mouse(self, event: pygame.Event, size: tuple[int, int]) -> None:
        """React to the mouse over the world."""
        views, unit = self._pane_views(size), layout_of(size).unit
        match event.type:
            case pygame.MOUSEMOTION:
                before, self._pointer = self._pointer, self._pixel(event.pos)
                if self._drag is not None:
                    self._move(self._drag, views, self._pointer - before)
            case pygame.MOUSEBUTTONDOWN if event.button in (1, 2, 3):
                self._pointer = self._pixel(event.pos)
                pressed = views if event.button == 1 else [view._replace(handles=()) for view in views]
                self._drag = drag_at(self._pointer, pressed, self._session.given, unit)
                self._widgets(size).release_focus()
            case pygame.MOUSEBUTTONUP | pygame.WINDOWFOCUSLOST:
                self._drag = None
            case pygame.MOUSEWHEEL:
                for view in views:
                    if view.area.collidepoint(self._pointer.real, self._pointer.imag):
                        box, steps = self._session.scene.view_box, float(event.precise_y)
                        self._pan_zoom = self._pan_zoom.zoomed(box, view.area, self._pointer, steps)

    def _move(self, drag: Drag, views: list[PaneView], pixels: complex) -> None:
        """Move what is held by so many pixels."""
        camera = views[min(drag.pane, len(views) - 1)].camera
        if drag.handle is None:
            self._pan_zoom = self._pan_zoom.dragged(camera, pixels)
            return
        target = camera.unproject(self._pointer) + drag.offset
        scene = self._session.scene
        self._session = sessions.changed(self._session, dragged(scene.parameters, self._session.given, drag.handle, target))

    def _do(self, request: Request) -> Screen | None:
        """Do what a widget or a key asks for."""
        scene, given = self._session.scene, self._session.given
        match request:
            case Command.LEAVE:
                return self._under
            case Command():
                self._obey(request)
            case Toggle():
                self._shown = self._shown ^ {request}
            case ValueRequested(name, value):
                self._session = sessions.changed(self._session, clamped(scene.parameters, given, {name: value}))
            case Refused(note):
                self._session = self._session._replace(notes=(note,))
            case SceneChosen(name):
                self._open(name)
            case PresetChosen(line):
                self._session = sessions.changed(self._session, Clamped(preset(scene, line, given.engine), ()))
                self._pan_zoom = _whole(self._session)
        return self

    def _obey(self, command: Command) -> None:
        """Do what a command asks for, of those that do not leave the lab."""
        session = self._session
        if command in _CHANGES:
            self._session = _CHANGES[command](session)
            return
        match command:
            case Command.PREVIOUS | Command.NEXT:
                names = [scene.name for scene in scenes()]
                step = 1 if command is Command.NEXT else -1
                self._open(names[(names.index(session.scene.name) + step) % len(names)])
            case Command.WHOLE:
                self._pan_zoom = _whole(self._session)
            case Command.COPY:
                self._tell(_copied(session.line))
            case Command.SAVE:
                self._tell(_saved(session.line))
            case Command.THEME:
                self._shared.change(self._shared.settings.other_colours())
            case Command.HELP:
                self._help = True

    def _open(self, name: str) -> None:
        """Another scene, at its defaults, shown whole."""
        self._session = sessions.fresh(scene_named(name), self._session.given.engine)
        self._pan_zoom, self._drag = _whole(self._session), None

    def _tell(self, notice: str) -> None:
        """Show a notice for some seconds."""
        self._notice, self._notice_left = notice, _NOTICE_SECONDS

    def _notes(self) -> tuple[str, ...]:
        """The notices to show now: of the last change, and of the last command."""
        return (*self._session.notes, *((self._notice,) if self._notice_left > 0.0 else ()))

    def _picture(self) -> Picture:
        """What the scene looks like. It is cached until the state changes, since a field of numbers takes some time."""
        session = self._session
        if self._drawn is not None:
            drawn, picture = self._drawn
            if drawn.given is session.given and drawn.tick == session.tick and drawn.scene is session.scene:
                return picture
        self._drawn = session, with_yours(session.picture, session.scene, session.given, self._shared.functions)
        return self._drawn[1]

    def _widgets(self, size: tuple[int, int]) -> Side:
        """The widgets, built anew when the window's size, the theme or the scene changes."""
        key = (size, self._shared.theme, self._session.scene.name)
        if self._side is None or self._side[0] != key:
            self._side = key, Side(layout_of(size), self._shared.theme, self._shared.type, self._session)
        return self._side[1]

    def _pane_views(self, size: tuple[int, int]) -> list[PaneView]:
        """Area, camera and handles of each pane; all of them show the same part of the world."""
        scene, panes = self._session.scene, self._picture().panes
        areas = pane_areas(layout_of(size), len(panes))
        return [
            PaneView(area, self._pan_zoom.camera(scene.view_box, area), scene.handles if pane.has_handles else ())
            for area, pane in zip(areas, panes, strict=True)
        ]

    def _hovered(self, views: list[PaneView], unit: float) -> Handle | None:
        """The handle that is held, or that a press would take hold of."""
        if self._drag is not None:
            return self._drag.handle
        found = drag_at(self._pointer, views, self._session.given, unit)
        return None if found is None else found.handle

    def _pixel(self, point: tuple[int, int]) -> complex:
        """The pixel at a point given in the mouse's coordinates."""
        return complex(point[0] * self._pixels_per_point.real, point[1] * self._pixels_per_point.imag)


def _whole(session: Session) -> PanZoom:
    """Shows the scene's view box, and the positions of its first two handles wherever they are."""
    return PanZoom.showing(session.scene.view_box, [handle.position(session.given) for handle in session.scene.handles[:2]])


def _copied(line: str) -> str:
    """Put a line on the clipboard; returns a sentence that says whether that worked."""
    try:
        pygame.scrap.put_text(f'python -m game lab "{line}"')
    except pygame.error as error:
        return f"no clipboard here ({error}); the line is at the right"
    return "copied: the line that opens this"


def _saved(line: str) -> str:
    """Save a line as a case; returns a sentence that says whether that worked."""
    try:
        return save_case(line, case_file())
    except BadInputError as error:
        return str(error)
