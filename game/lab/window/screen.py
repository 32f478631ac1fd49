"""The lab's screen: events become changes of the session, the session becomes a picture."""

import pygame

from game.input.events import code_among, position_in
from game.input.repeat import Repeat
from game.input.signals import Clicked, Moved, Pressed, Signal, is_still_down, pad_of
from game.lab.course.progress import course_progress
from game.lab.course.progress_path import progress_path
from game.lab.export.slide import SLIDE_SIZE, SlideStyle
from game.lab.kit.handles import Handle, dragged
from game.lab.kit.parameters import Clamped, clamped
from game.lab.kit.picture import Picture, Toggle
from game.lab.registry import scenes
from game.lab.session import reveal as reveals
from game.lab.session import session as sessions
from game.lab.session.commands import Command
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.presenting import DEFAULT_SCALE, TEXT_SCALES
from game.lab.session.session import Session
from game.lab.session.share import SharedScene, parsed, preset, share_line
from game.lab.session.stepping import SESSION_CHANGES, STEPS, Following, stepped_by
from game.lab.window import saving
from game.lab.window.commands import BOUND, PAD_COMMANDS, TOGGLE_KEYS, command_of
from game.lab.window.controls import LabControls, NumberRefused, PresetChosen, Request, SceneChosen, ValueRequested
from game.lab.window.dragging import HandleDrag, PaneView, drag_at
from game.lab.window.help import lab_help
from game.lab.window.layout import WindowLayout, layout_of
from game.lab.window.lesson import Lesson
from game.lab.window.presented import paint_presented, presented_words
from game.lab.window.side_panel import LabSidePanel
from game.lab.window.view import draw_all_handles, draw_halo, draw_panes, letters_for, pane_views
from game.lab.window.words import TextSheet, draw_head, draw_notice, draw_small_print, draw_words
from game.lab.yours.pane import with_yours
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.side_panel import MODIFIERS

SHOWN = frozenset(Toggle) - {Toggle.PYMUNK}
"""What is shown at first."""
_NOTICE_SECONDS = 5.0
_REPEATED = frozenset({Command.FORWARD, Command.BACK})
"""Commands that a held key gives again and again: single steps."""


class Lab:
    """One scene at a time, and everything that can be done to it."""

    def __init__(
        self,
        shared: AppState,
        session: Session,
        under: Screen | None = None,
        *,
        step: int | None = None,
        presents: bool = False,
    ) -> None:
        """Open with a session.

        under: the screen to go back to; None leaves the program. step: of the reveal; None for the whole picture.
        presents: whether it is shown to a lecture room.
        """
        self._shared, self._session, self._under = shared, session, under
        self._letters = letters_for(shared.type)
        self._shown = SHOWN
        self._reveal = reveals.WHOLE
        self._scale: int | None = None  # of TEXT_SCALES, while presenting
        self._pan_zoom = PanZoom.whole(session.scene, session.given)
        self._drawn: tuple[Session, Picture] | None = None
        self._side: LabSidePanel | None = None
        self._drag: HandleDrag | None = None
        self._repeat: tuple[Repeat, Command] | None = None
        self._pointer = -1 - 1j  # pixels
        self._pixels_per_point = 1 + 1j
        self._notice, self._notice_left = "", 0.0
        self._lesson: Lesson | None = None
        if presents:
            self.present()
        if step is not None and self._picture().steps:
            self._reveal = reveals.Reveal(max(step, 1))

    @property
    def session(self) -> Session:
        """The scene as it stands."""
        return self._session

    @property
    def presents(self) -> bool:
        """Whether it is shown to a lecture room."""
        return self._scale is not None

    def present(self) -> None:
        """Show the scene to a lecture room, from its first step on."""
        self._scale, self._reveal = DEFAULT_SCALE, self._first_step()

    def layout(self, size: tuple[int, int]) -> WindowLayout:
        """How a window of that size is divided."""
        found = layout_of(size, None if self._scale is None else TEXT_SCALES[self._scale], self._shared.text_scale)
        return found if self._lesson is None else self._lesson.lowered(found, self._shared.type)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """React to gamepad, fingers and released keys. Keyboard and mouse come as events of the window, to `hear`."""
        if self._repeat is not None and not is_still_down(self._repeat[0].position, signal):
            self._repeat = None
        if isinstance(signal, Moved | Clicked):
            return self if self.presents else self._controls(size).hear_finger(signal, size)
        if pad_of(signal) is None:
            return self._controls(size).answer(signal, size)
        taken, following = (False, self) if self.presents else self._controls(size).hear_pad(signal, size)
        if taken or not isinstance(signal, Pressed) or signal.action not in PAD_COMMANDS:
            return following
        return self._asked(PAD_COMMANDS[signal.action], signal.position)

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> Screen | None:
        """React to an event of the window."""
        self._pixels_per_point = pixels_per_point
        if event.type == pygame.KEYDOWN:
            return self._key(event, size)
        elsewhere = self.presents or self._drag is not None
        taken, following = (False, self) if elsewhere else self._controls(size).hear(event, size, pixels_per_point)
        if not taken:
            self._mouse(event, size)
        return following

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Let time pass."""
        self._controls(size).advance(seconds, size)
        if self._reveal.seen is None:  # a scene that runs waits until all of it is shown
            self._session = sessions.later(self._session, seconds)
        if self._repeat is not None:
            held, command = self._repeat
            held, due = held.later(seconds)
            self._repeat = held, command
            if due:
                self._obey(command)
        self._notice_left -= seconds
        if self._lesson is not None:
            self._lesson.observe(self._session)
        functions = self._shared.functions
        if functions is not None and (news := functions.refresh()):
            self._drawn = None
            self._tell(news)
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The world, the words, the controls."""
        theme, size = self._shared.theme, surface.get_size()
        sheet = TextSheet(surface, self.layout(size), theme, self._shared.type)
        surface.fill(theme.background)
        views = self._pane_views(size)
        seen, given = self._seen(), self._session.given
        draw_panes(sheet, self._letters, seen, views, self._shown, given)
        draw_all_handles(sheet, self._letters, seen, views, given, self._hovered(views, sheet.layout.pen))
        bottom = self._draw_words(sheet)
        for note in reversed(self._notes()):
            bottom = draw_notice(sheet, note, bottom - sheet.unit * 0.5)
        if not sheet.layout.presents:
            self._draw_side(sheet)
        elif self._pointer.real >= 0.0:
            draw_halo(sheet, self._pointer)
        if self._lesson is not None:
            self._lesson.draw(sheet)

    def _draw_words(self, sheet: TextSheet) -> float:
        """The words around the picture; returns where notices end, above them."""
        scene, picture, step = self._session.scene, self._seen(), self._step_name()
        if sheet.layout.presents:
            words = presented_words(sheet.layout, self._letters.around, sheet.theme, scene.title, step, picture)
            paint_presented(sheet.surface, self._letters.around, sheet.theme, words)
            return float(words.plates[-1].top)
        draw_head(sheet, scene, step)
        draw_words(sheet, picture)
        return float(sheet.layout.world.bottom)

    def _line(self) -> str:
        """The share line that opens the lab as it stands, at its step."""
        session, seen = self._session, self._reveal.seen
        step = None if seen is None else self._reveal.shown(self._picture())
        return share_line(SharedScene(session.scene, session.given, session.tick, step))

    def _draw_side(self, sheet: TextSheet) -> None:
        """The controls, and the small print below them."""
        bottom = self._controls(sheet.surface.get_size()).draw(sheet.surface)
        if bottom is not None:
            draw_small_print(sheet, bottom, (f"state hash {sessions.state_hash(self._session)}", self._line()))

    def _step_name(self) -> str:
        """Which step of a reveal is shown."""
        return reveals.step_words(self._reveal, self._picture())

    def _key(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """React to a key, unless it is for the controls."""
        if not self.presents:
            taken, following = self._controls(size).hear_key(event, size)
            if taken:
                return following
        key = code_among(event, BOUND)
        toggle = TOGGLE_KEYS.get(key)
        request = toggle or command_of(key)
        if request is None or event.mod & MODIFIERS:
            return self
        if toggle is not None and self._lesson is not None and self._lesson.answer(list(Toggle).index(toggle)):
            return self
        return self._asked(request, position_in(event))

    def _asked(self, request: Command | Toggle, position: int) -> Screen | None:
        """Do what a key or a button asks for that went down; as long as it is, again and again where that is wanted."""
        self._repeat = (Repeat(position), request) if isinstance(request, Command) and request in _REPEATED else None
        return self._do(request)

    def _mouse(self, event: pygame.Event, size: tuple[int, int]) -> None:
        """React to the mouse over the world."""
        views, unit = self._pane_views(size), self.layout(size).pen
        match event.type:
            case pygame.MOUSEMOTION:
                before, self._pointer = self._pointer, self._pixel(event.pos)
                if self._drag is not None:
                    self._move(self._drag, views, self._pointer - before)
            case pygame.MOUSEBUTTONDOWN if event.button in (1, 2, 3):
                self._pointer = self._pixel(event.pos)
                pressed = views if event.button == 1 else [view._replace(handles=()) for view in views]
                self._drag = drag_at(self._pointer, pressed, self._session.given, unit)
            case pygame.MOUSEBUTTONUP | pygame.WINDOWFOCUSLOST:
                self._drag = None
            case pygame.MOUSEWHEEL:
                for view in views:
                    if view.area.collidepoint(self._pointer.real, self._pointer.imag):
                        box, steps = self._session.scene.view_box, float(event.precise_y)
                        self._pan_zoom = self._pan_zoom.zoomed(box, view.focus, self._pointer, steps)

    def _move(self, drag: HandleDrag, views: list[PaneView], pixels: complex) -> None:
        """Move what is held by so many pixels."""
        camera = views[min(drag.pane, len(views) - 1)].camera
        if drag.handle is None:
            self._pan_zoom = self._pan_zoom.dragged(camera, pixels)
            return
        target = camera.unproject(self._pointer) + drag.offset
        scene = self._session.scene
        requested = drag.handle.values_at(self._session.given, target)
        if reveals.GUESS in requested:
            self._reveal = self._reveal._replace(guess=requested[reveals.GUESS])
            return
        self._session = sessions.changed(self._session, dragged(scene.parameters, self._session.given, drag.handle, target))

    def _do(self, request: Request) -> Screen | None:
        """Do what a control or a key asks for."""
        scene, given = self._session.scene, self._session.given
        match request:
            case Command.LEAVE:
                return self._under
            case Command.HELP:
                return lab_help(self._shared, self)
            case Command():
                self._obey(request)
            case Toggle():
                self._shown = self._shown ^ {request}
            case ValueRequested(name, value):
                self._session = sessions.changed(self._session, clamped(scene.parameters, given, {name: value}))
            case NumberRefused(note):
                self._session = self._session._replace(notes=(note,))
            case SceneChosen(name):
                self._open(name)
            case PresetChosen(line):
                self._session = sessions.changed(self._session, Clamped(preset(scene, line, given.engine), ()))
                self._pan_zoom = PanZoom.whole(self._session.scene, self._session.given)
        return self

    def _obey(self, command: Command) -> None:
        """Do what a command asks for, of those that do not leave the lab."""
        if command in SESSION_CHANGES:
            self._session = SESSION_CHANGES[command](self._session)
            return
        if command in STEPS:
            self._step(command)
            return
        if command in saving.WRITING:
            self._tell(self._written(command))
            return
        match command:
            case Command.PREVIOUS | Command.NEXT:
                self._turn(1 if command is Command.NEXT else -1)
            case Command.WHOLE:
                self._pan_zoom = PanZoom.whole(self._session.scene, self._session.given)
            case Command.PRESENT | Command.LARGER | Command.SMALLER:
                self._resize(command)
            case Command.THEME:
                self._shared.change(self._shared.settings.other_colours())
            case Command.COURSE:
                self._attend()

    def _written(self, command: Command) -> str:
        """Write what a command asks for; a sentence that says what became of it."""
        if command not in saving.PICTURES:
            return saving.written(command, self._session, self._line())
        style = SlideStyle(SLIDE_SIZE, self._shared.theme, self._letters, self._shown)
        return saving.saved_picture(saving.PICTURES[command], style, self._session, self._reveal, self._pan_zoom)

    def _step(self, command: Command) -> None:
        """Show more or less of the picture, and what follows from that."""
        self._reveal, following = stepped_by(command, self._reveal, self._picture(), runs=self._session.runs)
        if command is Command.PREDICT:
            self._tell("guess first: drag the answer, then press Space" if self._reveal.predicts else "no more guessing")
        if following is Following.PLAY:
            self._session = sessions.toggled(self._session)
        elif following is not Following.NOTHING:
            self._turn(1 if following is Following.NEXT else -1)

    def _attend(self) -> None:
        """Begin the course, or leave it."""
        self._lesson = Lesson(course_progress(progress_path())) if self._lesson is None else None
        if self._lesson is not None:
            self._show(parsed(self._lesson.line, self._session.given.engine))
            self._tell(self._lesson.problem or "the course: [ and ] turn its pages, E leaves it")

    def _turn(self, step: int) -> None:
        """Open the scene so many after this one; in the course, the task."""
        if self._lesson is not None:
            self._show(parsed(self._lesson.turn(step), self._session.given.engine))
            return
        names = [scene.name for scene in scenes()]
        self._open(names[(names.index(self._session.scene.name) + step) % len(names)])

    def _resize(self, command: Command) -> None:
        """Begin or end to present, or change the size of the text there."""
        if command is Command.PRESENT and self._scale is None:
            self.present()
        elif command is Command.PRESENT:
            self._scale, self._reveal = None, reveals.whole(self._reveal)
        elif self._scale is not None:
            self._scale = min(max(self._scale + (1 if command is Command.LARGER else -1), 0), len(TEXT_SCALES) - 1)

    def _open(self, name: str) -> None:
        """Another scene, at its defaults, shown whole; to a lecture room from its first step on."""
        self._show(parsed(name, self._session.given.engine))
        if self.presents:
            self._reveal = self._first_step()

    def _show(self, shared: SharedScene) -> None:
        """A scene as a share line names it."""
        self._session = sessions.opened(shared)
        self._pan_zoom, self._drag = PanZoom.whole(shared.scene, shared.given), None
        self._reveal = reveals.Reveal(shared.step, self._reveal.predicts)

    def _first_step(self) -> reveals.Reveal:
        """The beginning of the reveal, where the picture has steps."""
        return reveals.begun(self._reveal) if self._picture().steps else reveals.whole(self._reveal)

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

    def _seen(self) -> Picture:
        """What is shown of the picture."""
        return reveals.shown_picture(self._reveal, self._picture())

    def _controls(self, size: tuple[int, int]) -> LabSidePanel:
        """The controls of the scene as it stands."""
        seen = LabControls(self._session, self._shown, self._picture().toggles)
        layout = layout_of(size, text=self._shared.text_scale)
        if self._side is None:
            self._side = LabSidePanel(self._shared, self, self._do, layout, seen)
        self._side.show(layout, seen)
        return self._side

    def _pane_views(self, size: tuple[int, int]) -> list[PaneView]:
        """Area, camera and handles of each pane."""
        return pane_views(self.layout(size), self._session.scene, self._seen(), self._pan_zoom, self._reveal)

    def _hovered(self, views: list[PaneView], unit: float) -> Handle | None:
        """The handle that is held, or that a press would take hold of."""
        if self._drag is not None:
            return self._drag.handle
        found = drag_at(self._pointer, views, self._session.given, unit)
        return None if found is None else found.handle

    def _pixel(self, point: tuple[int, int]) -> complex:
        """The pixel at a point given in the mouse's coordinates."""
        return complex(point[0] * self._pixels_per_point.real, point[1] * self._pixels_per_point.imag)
