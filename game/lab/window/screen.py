"""The lab's screen: what the hands do becomes changes of the session, the session becomes a picture."""

from collections.abc import Callable

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import Theme
from game.input.keys import code_among, position_in
from game.input.repeat import Repeat
from game.input.signals import KeyboardState, Signal
from game.lab.kit.handles import Handle, dragged
from game.lab.kit.parameters import Settled, settled
from game.lab.kit.picture import Picture, Toggle
from game.lab.registry import scene_named, scenes
from game.lab.session import session as sessions
from game.lab.session.cases import case_file, save_case
from game.lab.session.session import Session
from game.lab.session.share import preset
from game.lab.window.canvas import Canvas, draw_note
from game.lab.window.commands import BOUND, TOGGLE_KEYS, Command, command_of
from game.lab.window.grips import Grip, draw_grips, grip_at
from game.lab.window.help import draw_help
from game.lab.window.lens import Lens
from game.lab.window.page import Page, draw_head, draw_picture, draw_side, draw_words, page, panes
from game.lab.window.widgets import Asked, Chosen, Preset, Refused, Side, Wished
from game.screens.base import Screen, Shared
from game.system.errors import BadInputError

SHOWN = frozenset(Toggle) - {Toggle.PYMUNK}
"""What is shown at first."""
_NOTICE_SECONDS = 5.0
_REPEATED = frozenset({Command.FORWARD, Command.BACK})
"""Commands that a held key gives again and again."""

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

    def __init__(self, shared: Shared, session: Session, under: Screen | None = None) -> None:
        """Open with a session. under: the screen to go back to; None leaves the program."""
        self._shared, self._session, self._under = shared, session, under
        self._shown = SHOWN
        self._lens = _lens_for(session)
        self._drawn: tuple[Session, Picture] | None = None
        self._side: tuple[tuple[tuple[int, int], Theme, str], Side] | None = None
        self._grip: Grip | None = None
        self._pointer = -1 - 1j  # pixels
        self._pixels_per_point = 1 + 1j
        self._seconds = 0.0  # since the last picture
        self._notice, self._notice_left = "", 0.0
        self._help = False
        self._repeat: tuple[Repeat, Command] | None = None

    @property
    def session(self) -> Session:
        """The scene as it stands."""
        return self._session

    def answer(self, signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """Let go of a repeating key that is up; everything else is heard as an event."""
        if self._repeat is not None and isinstance(signal, KeyboardState) and self._repeat[0].position not in signal.down:
            self._repeat = None
        return self

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> Screen | None:
        """React to an event of the window."""
        self._pixels_per_point = pixels_per_point
        if self._help:
            self._help = event.type not in (pygame.KEYDOWN, pygame.MOUSEBUTTONDOWN)
            return self
        if event.type == pygame.KEYDOWN:
            return self._key(event, size)
        taken, asked = self._widgets(size).hear(event)
        if asked is not None:
            return self._do(asked)
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
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The world, the words, the widgets."""
        theme, type_, size = self._shared.theme, self._shared.type, surface.get_size()
        place, side, session, picture = page(size), self._widgets(size), self._session, self._picture()
        surface.fill(theme.background)
        cameras = self._cameras(place, picture)
        draw_picture(surface, place, picture, cameras, theme, type_, self._shown)
        for area, camera in zip(panes(place, len(picture.panes)), cameras, strict=True):
            canvas = Canvas(surface, area, camera, theme, type_, place.unit, self._shown)
            draw_grips(canvas, session.given, session.scene.handles, self._hot(place, picture, cameras))
        bottom = float(place.world.bottom)
        for note in reversed(self._notes()):
            bottom = draw_note(surface, place.world, note, theme, type_, place.unit, bottom - place.unit * 0.5)
        draw_head(surface, place, session.scene, theme, type_)
        draw_words(surface, place, picture, theme, type_)
        side.show(session, self._shown, picture.toggles)
        draw_side(surface, place, side.bottom, _standing(session), theme, type_)
        side.draw(surface, session, self._seconds, self._pixels_per_point)
        self._seconds = 0.0
        if self._help:
            draw_help(surface, theme, type_)

    def _key(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """A key: a field's, if one is being typed into."""
        side = self._widgets(size)
        if side.busy:
            if event.key == pygame.K_ESCAPE:
                side.let_go()
                return self
            _, asked = side.hear(event)
            return self if asked is None else self._do(asked)
        key = code_among(event, BOUND)
        toggle, command = TOGGLE_KEYS.get(key), command_of(key)
        asked_by_key = toggle or command
        modified = event.mod & (pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META)
        if asked_by_key is None or modified:
            return self
        self._repeat = None if command is None or command not in _REPEATED else (Repeat(position_in(event)), command)
        return self._do(asked_by_key)

    def _mouse(self, event: pygame.Event, size: tuple[int, int]) -> None:
        """The mouse over the world."""
        place, picture = page(size), self._picture()
        cameras = self._cameras(place, picture)
        match event.type:
            case pygame.MOUSEMOTION:
                before, self._pointer = self._pointer, self._pixel(event.pos)
                if self._grip is not None:
                    self._drag(self._grip, cameras, self._pointer - before)
            case pygame.MOUSEBUTTONDOWN if event.button in (1, 2, 3):
                self._pointer = self._pixel(event.pos)
                handles = self._session.scene.handles if event.button == 1 else ()
                areas = panes(place, len(picture.panes))
                self._grip = grip_at(self._pointer, areas, cameras, self._session.given, handles, place.unit)
                self._widgets(size).let_go()
            case pygame.MOUSEBUTTONUP | pygame.WINDOWFOCUSLOST:
                self._grip = None
            case pygame.MOUSEWHEEL:
                for area, camera in zip(panes(place, len(picture.panes)), cameras, strict=True):
                    if area.collidepoint(self._pointer.real, self._pointer.imag):
                        steps = float(event.precise_y)
                        self._lens = self._lens.zoomed(camera, self._session.scene.view, area, self._pointer, steps)

    def _drag(self, grip: Grip, cameras: list[Camera], way: complex) -> None:
        """Move what is held; way: pixels."""
        camera = cameras[min(grip.pane, len(cameras) - 1)]
        if grip.handle is None:
            self._lens = self._lens.dragged(camera, way)
            return
        place = camera.unproject(self._pointer) + grip.slip
        scene = self._session.scene
        self._session = sessions.changed(self._session, dragged(scene.parameters, self._session.given, grip.handle, place))

    def _do(self, asked: Asked) -> Screen | None:
        """What was asked for by a widget or a key."""
        scene, given = self._session.scene, self._session.given
        match asked:
            case Command.LEAVE:
                return self._under
            case Command():
                self._obey(asked)
            case Toggle():
                self._shown = self._shown ^ {asked}
            case Wished(name, value):
                self._session = sessions.changed(self._session, settled(scene.parameters, given, {name: value}))
            case Refused(note):
                self._session = self._session._replace(notes=(note,))
            case Chosen(name):
                self._open(name)
            case Preset(line):
                self._session = sessions.changed(self._session, Settled(preset(scene, line, given.engine), ()))
                self._lens = _lens_for(self._session)
        return self

    def _obey(self, command: Command) -> None:
        """What stays on this screen and needs no number."""
        session = self._session
        match command:
            case _ if command in _CHANGES:
                self._session = _CHANGES[command](session)
            case Command.PREVIOUS | Command.NEXT:
                names = [scene.name for scene in scenes()]
                step = 1 if command is Command.NEXT else -1
                self._open(names[(names.index(session.scene.name) + step) % len(names)])
            case Command.VIEW:
                self._lens = _lens_for(self._session)
            case Command.COPY:
                self._tell(_copied(session.line))
            case Command.SAVE:
                self._tell(_saved(session.line))
            case Command.THEME:
                self._shared.change(self._shared.settings.other_colours())
            case Command.HELP:
                self._help = True

    def _open(self, name: str) -> None:
        """Another scene, at its defaults, seen whole."""
        self._session = sessions.fresh(scene_named(name), self._session.given.engine)
        self._lens, self._grip = _lens_for(self._session), None

    def _tell(self, notice: str) -> None:
        """Say something for a while."""
        self._notice, self._notice_left = notice, _NOTICE_SECONDS

    def _notes(self) -> tuple[str, ...]:
        """What is to be said now: of the last change, and of what was asked for."""
        return (*self._session.notes, *((self._notice,) if self._notice_left > 0.0 else ()))

    def _picture(self) -> Picture:
        """What the scene looks like, worked out once for each state: a field of numbers takes its time."""
        session = self._session
        if self._drawn is not None:
            drawn, picture = self._drawn
            if drawn.given is session.given and drawn.tick == session.tick and drawn.scene is session.scene:
                return picture
        self._drawn = session, session.picture
        return self._drawn[1]

    def _widgets(self, size: tuple[int, int]) -> Side:
        """The widgets for a size, built anew when the size, the theme or the scene is another."""
        key = (size, self._shared.theme, self._session.scene.name)
        if self._side is None or self._side[0] != key:
            self._side = key, Side(page(size), self._shared.theme, self._shared.type, self._session)
        return self._side[1]

    def _cameras(self, place: Page, picture: Picture) -> list[Camera]:
        """One for each world, all alike."""
        view = self._session.scene.view
        return [self._lens.camera(view, area) for area in panes(place, len(picture.panes))]

    def _hot(self, place: Page, picture: Picture, cameras: list[Camera]) -> Handle | None:
        """The handle that is held, or would be."""
        if self._grip is not None:
            return self._grip.handle
        areas = panes(place, len(picture.panes))
        found = grip_at(self._pointer, areas, cameras, self._session.given, self._session.scene.handles, place.unit)
        return None if found is None else found.handle

    def _pixel(self, place: tuple[int, int]) -> complex:
        """The pixel at a place given in the mouse's coordinates."""
        return complex(place[0] * self._pixels_per_point.real, place[1] * self._pixels_per_point.imag)


def _lens_for(session: Session) -> Lens:
    """The view that shows the scene, and what its first two handles are on, wherever that is."""
    return Lens.showing(session.scene.view, [handle.place(session.given) for handle in session.scene.handles[:2]])


def _standing(session: Session) -> tuple[str, ...]:
    """How the scene stands, in small print."""
    return (f"state {sessions.state_hash(session)}", session.line)


def _copied(line: str) -> str:
    """Put a line on the clipboard; what became of it, in words."""
    try:
        pygame.scrap.put_text(f'python -m game lab "{line}"')
    except pygame.error as error:
        return f"no clipboard here ({error}); the line is at the right"
    return "copied: the line that opens this"


def _saved(line: str) -> str:
    """Save a line as a case; what became of it, in words."""
    try:
        return save_case(line, case_file())
    except BadInputError as error:
        return str(error)
