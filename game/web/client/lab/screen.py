"""The lab on the page: a scene that can be touched, revealed and presented, the course, the player's own functions."""

from typing import NamedTuple

from game.input.actions import Action
from game.input.signals import FocusLost, Pressed, Signal
from game.lab.kit.handles import Handle, dragged
from game.lab.kit.picture import Picture, Toggle
from game.lab.kit.scene import EngineUse
from game.lab.kit.second_engine import Engine
from game.lab.registry import scenes
from game.lab.session import reveal as reveals
from game.lab.session import session as sessions
from game.lab.session.commands import Command
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.presenting import DEFAULT_SCALE, TEXT_SCALES
from game.lab.session.reveal import Reveal
from game.lab.session.session import Session
from game.lab.session.share import SharedScene, parsed, share_line
from game.lab.session.stepping import SESSION_CHANGES, STEPS, Following, stepped_by
from game.lab.yours.pane import with_yours
from game.picture.display_list import DisplayList
from game.picture.lab import SeenLabPane, add_handles, add_pane
from game.web.client.functions.panel import CASE
from game.web.client.functions.text import FunctionsText
from game.web.client.lab.course import LessonOnPage
from game.web.client.lab.items import presenting_items, scene_items, step_items, with_value
from game.web.client.lab.view import LabLayout, handle_at, layout_of, words_of
from game.web.client.menus import Screens
from game.web.client.messages import PageItem, PageMenu, PageWords, PointerChange, WheelTurn
from game.web.client.state import PageScreen, PageState, Pictures

_CATCH, _FINGER = 1.2, 2.2
"""Units within which a press takes hold of a handle, by mouse and by finger."""
_KEYS = {
    Action.SERVE: Command.PLAY,
    Action.PAUSE: Command.PRESENT,
    Action.STEP: Command.FORWARD,
    Action.RIGHT: Command.FORWARD,
    Action.STEP_BACK: Command.BACK,
    Action.LEFT: Command.BACK,
    Action.LESS: Command.SLOWER,
    Action.MORE: Command.FASTER,
    Action.RESTART: Command.RESTART,
    Action.START: Command.WHOLE,
    Action.THEME: Command.THEME,
    Action.GIVE_UP: Command.PREDICT,
    Action.EFFECTS: Command.COURSE,
    Action.UP: Command.LARGER,
    Action.DOWN: Command.SMALLER,
    Action.BACK: Command.LEAVE,
}
"""What the keys of the page mean in the lab: what they do in the desktop's."""
_BY_ID = {command.name.lower(): command for command in Command}
"""Commands by the items that ask for them."""


class _Hold(NamedTuple):
    """What the pointer holds. handle: None for the world itself. offset: from the pointer to the handle, world units."""

    pointer: int
    handle: Handle | None
    offset: complex
    pixel: complex


class LabOnPage:
    """One scene at a time."""

    def __init__(self, state: PageState, screens: Screens, line: str) -> None:
        """line: a share line, "" for the first scene. BadInputError where it names nothing."""
        self._state, self._screens = state, screens
        self._session: Session
        self._pan_zoom: PanZoom
        shared = self._parsed(line or scenes()[0].name)
        self._toggles = frozenset(Toggle) - {Toggle.PYMUNK}
        self._reveal = reveals.WHOLE
        self._scale: int | None = None  # of TEXT_SCALES, while presenting
        self._lesson: LessonOnPage | None = None
        self._hold: _Hold | None = None
        self._hovered: Handle | None = None
        self._fragment = ""
        self._empty = DisplayList()
        self._shown: tuple[Session, FunctionsText | None, Picture] | None = None
        self._show(shared)

    @property
    def session(self) -> Session:
        """The scene as it stands."""
        return self._session

    @property
    def line(self) -> str:
        """The share line that opens it as it stands, at its step."""
        session, seen = self._session, self._reveal.seen
        step = None if seen is None else self._reveal.shown(self._picture)
        return share_line(SharedScene(session.scene, session.given, session.tick, step))

    @property
    def panes(self) -> list[str]:
        """The titles of the panes that are shown."""
        return [pane.title for pane in self._seen.panes]

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """To a lecture room: the steps. Else the menu has all."""
        return () if self._scale is None else presenting_items(self._reveal, self._picture)

    @property
    def fragment(self) -> str:
        """The share line, while nothing moves: browsers stop pages that change their address all the time."""
        if (self._hold is None and not self._session.playing) or not self._fragment:
            self._fragment = f"lab/{self.line}"
        return self._fragment

    @property
    def described(self) -> str:
        """The title and the step for a screen reader; formulas are read from the page itself."""
        step = reveals.step_words(self._reveal, self._picture)
        return ". ".join([part for part in (self._session.scene.title, step) if part])

    @property
    def words(self) -> PageWords:
        """The words around the picture."""
        return words_of(self._session.scene.title, self._seen, self._reveal, self._picture, self._scale)

    @property
    def menu(self) -> PageMenu | None:
        """The scene's values and what can be done with it, after what the course asks; or the player's own functions."""
        functions, scene = self._state.functions, self._session.scene
        if functions.is_open:
            return PageMenu("Your own functions", functions.lines, functions.items, side=True, editor=True)
        if self._scale is not None:
            return None
        steps = step_items(self._reveal, self._picture)
        items = scene_items(self._session, scenes(), self._picture, self._toggles)
        step = reveals.step_words(self._reveal, self._picture)
        notes = tuple([line for line in (step, *self._session.notes) if line])
        if self._lesson is not None:
            return PageMenu("The course", (*self._lesson.lines, *notes), (*self._lesson.items, *steps, *items), side=True)
        return PageMenu(scene.title, (scene.idea, *notes), (*steps, *items), side=True)

    def answer(self, signal: Signal, size: tuple[int, int]) -> PageScreen:
        """The keys of the desktop's lab."""
        del size
        match signal:
            case Pressed(action) if action in _KEYS:
                return self._obey(_KEYS[action])
            case FocusLost():
                self._hold = None
        return self

    def point(self, message: PointerChange | WheelTurn, size: tuple[int, int]) -> None:
        """Handles and the world are dragged; the wheel zooms about the pointer."""
        layout, pixel = self._layout(size), complex(message.x, message.y)
        index = next((k for k, area in enumerate(layout.panes) if area.contains(pixel)), 0)
        area, seen = layout.panes[index], self._panes(layout)[index]
        if isinstance(message, WheelTurn):
            self._pan_zoom = self._pan_zoom.zoomed(self._session.scene.view_box, area, pixel, message.steps)
        elif message.phase == "down":
            handle = self._handle_at(seen, pixel, _FINGER if message.touch else _CATCH)
            offset = 0j if handle is None else handle.position(self._session.given) - seen.camera.unproject(pixel)
            self._hold = _Hold(message.id, handle, offset, pixel)
        elif message.phase == "move":
            self._move(message, seen, pixel)
        elif self._hold is not None and self._hold.pointer == message.id:
            self._hold = None

    def choose(self, item: str, value: str) -> PageScreen:
        """What a control does."""
        if self._state.functions.is_open:
            return self._use_functions(item)
        kind, _, name = item.partition(":")
        if kind in _BY_ID:
            return self._obey(_BY_ID[kind])
        match kind:
            case "title":
                return self._screens.title()
            case "scene":
                self._show(self._parsed(value))
            case "toggle":
                self._toggles = self._toggles ^ {Toggle(name)}
                self._ask_engine()
            case "functions":
                self._state.functions.open()
            case "answer" if self._lesson is not None and name.isdecimal():
                self._lesson.answer(int(name))
            case _:
                self._session = with_value(self._session, item, value)
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> PageScreen:
        """Let a scene that runs run, once all of it is shown; see whether the goal of an exercise is reached."""
        del size
        if self._reveal.seen is None:
            self._session = sessions.later(self._session, seconds)
        if self._lesson is not None:
            self._lesson.observe(self._session)
        return self

    def draw(self, out: Pictures, size: tuple[int, int]) -> None:
        """Draw the panes with their handles."""
        picture, layout = self._seen, self._layout(size)
        out.backdrop = self._empty
        for pane, seen in zip(picture.panes, self._panes(layout), strict=True):
            handles, given = self._handles() if pane.has_handles else (), self._session.given
            add_pane(out.frame, pane, seen, [seen.camera.project(one.position(given)) for one in handles])
            add_handles(out.frame, handles, given, self._hovered, seen)

    @property
    def _picture(self) -> Picture:
        """All of the scene, and the answers of the player's functions. It is cached until one of them changes."""
        session, functions = self._session, self._state.functions.running
        if self._shown is None or self._shown[0] is not session or self._shown[1] is not functions:
            self._shown = session, functions, with_yours(session.picture, session.scene, session.given, functions)
        return self._shown[2]

    @property
    def _seen(self) -> Picture:
        """What is shown of it."""
        return reveals.shown_picture(self._reveal, self._picture)

    def _obey(self, command: Command) -> PageScreen:
        """What a key or a button asks for."""
        if command in SESSION_CHANGES:
            self._session = SESSION_CHANGES[command](self._session)
        elif command in STEPS:
            self._step(command)
        match command:
            case Command.LEAVE:
                return self._left()
            case Command.PRESENT:
                self._present()
            case Command.LARGER | Command.SMALLER if self._scale is not None:
                step = 1 if command is Command.LARGER else -1
                self._scale = min(max(self._scale + step, 0), len(TEXT_SCALES) - 1)
            case Command.WHOLE:
                self._pan_zoom = PanZoom.whole(self._session.scene, self._session.given)
            case Command.THEME:
                self._state.change(self._state.settings.other_colours())
            case Command.COURSE:
                self._attend()
            case Command.PREVIOUS | Command.NEXT:
                self._turn(1 if command is Command.NEXT else -1)
        return self

    def _left(self) -> PageScreen:
        """Close the editor, or end to present; else leave the lab."""
        if self._state.functions.is_open:
            self._state.functions.is_open = False
        elif self._scale is not None:
            self._present()
        else:
            return self._screens.title()
        return self

    def _step(self, command: Command) -> None:
        """Show more or less of the picture, and what follows from that."""
        self._reveal, following = stepped_by(command, self._reveal, self._picture, runs=self._session.runs)
        if following is Following.PLAY:
            self._session = sessions.toggled(self._session)
        elif following is not Following.NOTHING:
            self._turn(1 if following is Following.NEXT else -1)

    def _present(self) -> None:
        """Begin to show the scene to a lecture room, from its first step on; or end it."""
        if self._scale is None:
            self._scale, self._reveal = DEFAULT_SCALE, self._first_step()
        else:
            self._scale, self._reveal = None, reveals.whole(self._reveal)

    def _attend(self) -> None:
        """Begin the course, or leave it."""
        if self._lesson is not None:
            self._lesson = None
            return
        self._lesson = LessonOnPage(self._state)
        self._show(self._parsed(self._lesson.line))

    def _turn(self, step: int) -> None:
        """Open the scene so many after this one; in the course, the task."""
        if self._lesson is not None:
            self._show(self._parsed(self._lesson.turn(step)))
            return
        names = [scene.name for scene in scenes()]
        self._show(self._parsed(names[(names.index(self._session.scene.name) + step) % len(names)]))
        if self._scale is not None:
            self._reveal = self._first_step()

    def _first_step(self) -> Reveal:
        """The beginning of the reveal, where the picture has steps."""
        return reveals.begun(self._reveal) if self._picture.steps else reveals.whole(self._reveal)

    def _use_functions(self, item: str) -> PageScreen:
        """What a control beside the editor does."""
        state = self._state
        functions = state.functions
        kind, _, name = item.partition(":")
        match kind:
            case "close":
                functions.is_open = False
            case "grade":
                problem = functions.grade()
                state.notifications += [problem] if problem else []
                state.changed = True
            case "download":
                state.download = functions.download
            case "fly" if functions.running is not None:
                functions.is_open = False
                return self._screens.flight(functions.running)
            case str() if kind == CASE and functions.line_of(name):
                self.open(functions.line_of(name))
        return self

    def use_engine(self, engine: Engine) -> None:
        """Take the second engine, which was loaded."""
        self._session = sessions.with_engine(self._session, engine)

    def _ask_engine(self) -> None:
        """Request the second engine if the scene needs it and it is not loaded yet."""
        use = self._session.scene.engine_use
        wanted = use is EngineUse.ALWAYS or (use is EngineUse.TOGGLE and Toggle.PYMUNK in self._toggles)
        if wanted and self._state.engine is None:
            self._state.asks_engine = True
            self._state.notifications.append("pymunk is being loaded")

    def _parsed(self, line: str) -> SharedScene:
        """The scene of a share line; BadInputError if there is none."""
        return parsed(line, self._state.engine)

    def open(self, line: str) -> None:
        """Show what a share line names."""
        self._show(self._parsed(line))

    def _show(self, shared: SharedScene) -> None:
        """A scene as a share line names it."""
        self._session, self._hovered, self._hold = sessions.opened(shared), None, None
        self._pan_zoom = PanZoom.whole(shared.scene, shared.given)
        step = shared.step if shared.step is None or not self._picture.steps else max(shared.step, 1)
        self._reveal = Reveal(step, self._reveal.predicts)
        self._ask_engine()

    def _layout(self, size: tuple[int, int]) -> LabLayout:
        """Where everything is."""
        return layout_of(size, self._state.density, len(self._picture.panes), self._scale)

    def _panes(self, layout: LabLayout) -> list[SeenLabPane]:
        """Through what each pane is seen."""
        box, theme = self._session.scene.view_box, self._state.theme
        return [
            SeenLabPane(area.corner, area.extent, self._pan_zoom.camera(box, area), theme, layout.pen, self._toggles)
            for area in layout.panes
        ]

    def _handles(self) -> tuple[Handle, ...]:
        """The handles of what is shown, and of the answer that is to be drawn."""
        answer = reveals.guess_handle(self._reveal, self._picture)
        seen = self._reveal.seen
        there = tuple([one for one in self._session.scene.handles if seen is None or one.step <= seen])
        return there if answer is None else (answer, *there)

    def _handle_at(self, seen: SeenLabPane, pixel: complex, reach: float) -> Handle | None:
        """The handle that a press at a pixel takes hold of. reach: units."""
        point = seen.camera.unproject(pixel)
        return handle_at(self._handles(), self._session.given, point, reach * seen.unit / seen.camera.scale)

    def _move(self, message: PointerChange, seen: SeenLabPane, pixel: complex) -> None:
        """The pointer moved: with what it holds, or over what it could take."""
        hold = self._hold
        if hold is None or hold.pointer != message.id:
            self._hovered = None if message.touch else self._handle_at(seen, pixel, _CATCH)
            return
        if hold.handle is None:
            self._pan_zoom = self._pan_zoom.dragged(seen.camera, pixel - hold.pixel)
        else:
            self._drag(hold.handle, seen.camera.unproject(pixel) + hold.offset)
        self._hovered, self._hold = hold.handle, hold._replace(pixel=pixel)

    def _drag(self, handle: Handle, target: complex) -> None:
        """A handle was dragged to a point of the world: the answer that is drawn by hand, or the scene's values."""
        asked = handle.values_at(self._session.given, target)
        if reveals.GUESS in asked:
            self._reveal = self._reveal._replace(guess=asked[reveals.GUESS])
        else:
            parameters = self._session.scene.parameters
            self._session = sessions.changed(self._session, dragged(parameters, self._session.given, handle, target))
