"""The editor as a screen of the game's loop: events to commands of the session, and one picture."""

from collections.abc import Callable

import pygame

from game.editor import cursor
from game.editor import session as editing
from game.editor.changes import redo_words, undo_words
from game.editor.document import Stack, saved_text
from game.editor.fields import WELL_FIELDS, PanelPart
from game.editor.file_watch import WatchedFile
from game.editor.session import EditorSession
from game.editor.wells import chosen_well
from game.editor.window.commands import (
    CHANGES,
    COLOUR_KEY,
    COMMAND_ACTIONS,
    COMMAND_KEYS,
    CONTROL_KEYS,
    DIRECTIONS,
    ERASING_KEYS,
    KNOWN_KEYS,
    OF_WELLS,
    PAGES,
    PAINTING_KEYS,
    layers_of,
    recoloured,
    relayered,
)
from game.editor.window.help import Hand, editor_help
from game.editor.window.layout import EditorLayout, editor_layout
from game.editor.window.picture import EditorPicture, Shown
from game.editor.window.play_test import PlayTest
from game.editor.window.pointing import ERASER, EditorDrag, dragged, pressed, slot_at
from game.editor.window.side_panel import EditorSidePanel
from game.input.events import code_among, position_in
from game.input.keys import Action
from game.input.repeat import Repeat
from game.input.signals import Clicked, FocusLost, Moved, Pressed, Released, Signal, is_still_down, pad_of
from game.language import tr
from game.overlay.toast import Toast
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.menu import Entry, Menu
from game.system.errors import BadInputError
from game.system.files import write_text

_LOOK_SECONDS = 0.5
"""From one look at the file to the next."""
_STRIDE = 10
"""Steps that an arrow key takes with Shift."""
_DISTANCE, _ANGLE = WELL_FIELDS[:2]


class Editor:
    """Edits one level file.

    Keys and gamepad act on the cursor in the arena, or on the controls beside it. The part of the controls that is shown
    decides what cursor and mouse do in the arena.
    """

    def __init__(
        self, state: AppState, session: EditorSession, file: WatchedFile, back: Callable[[], Screen | None] = lambda: None
    ) -> None:
        """Open with a session on a file. back: the screen that it leads back to."""
        self._state, self.session, self._file, self._back = state, session, file, back
        self._picture = EditorPicture()
        self._hand = Hand.KEYS
        self._side: EditorSidePanel | None = None
        self._pixel: complex | None = None  # of the mouse
        self._drag: EditorDrag | None = None  # of the mouse, or of the cursor while a key is down
        self._held: tuple[Pressed, int, Repeat] | None = None  # the direction that is held down, and the steps it takes
        self._since_look = 0.0
        self.discarded = False  # whether the player has chosen to lose what is not saved

    @property
    def appearance(self) -> tuple[object, ...]:
        """Everything that its picture depends on."""
        side = () if self._side is None else self._side.full_appearance
        return self._state.appearance, self.session, self._hand, self._pixel, self._drag is not None, side

    def layout(self, size: tuple[int, int]) -> EditorLayout:
        """How a window of that size is divided."""
        return editor_layout(size, self.session.document.level.ground_radius, self._state.text_scale)

    def side(self, size: tuple[int, int]) -> EditorSidePanel:
        """The controls of the level as it stands."""
        shown = self.layout(size), self.session
        if self._side is None:
            self._side = EditorSidePanel(self._state, self, self._put, self._command, shown)
        self._side.show(*shown)
        return self._side

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> Screen | None:
        """React to a window's event. What gamepads and fingers do comes as signals, to `answer`."""
        if event.type == pygame.KEYDOWN:
            return self._key(event, size)
        if event.type == pygame.KEYUP and event.key in (*PAINTING_KEYS, *ERASING_KEYS):
            self._drag = None
        is_mouse = event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION)
        if is_mouse:
            x, y = event.pos
            self._pixel, self._hand = complex(x * pixels_per_point.real, y * pixels_per_point.imag), Hand.MOUSE
        taken, following = (False, self) if self._drag is not None else self.side(size).hear(event, size, pixels_per_point)
        if taken:
            return following
        if event.type == pygame.MOUSEBUTTONUP:
            self._drag = None
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button in (1, 3):
            self._press(event.button, size)
        elif event.type == pygame.MOUSEMOTION and self._drag is not None and self._pixel is not None:
            self.session = dragged(self.session, self._drag, self.layout(size).camera.unproject(self._pixel))
        elif event.type == pygame.MOUSEWHEEL and self._point(size) is not None and event.precise_y:
            self._scroll(1 if event.precise_y > 0.0 else -1)
        return self

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """React to a gamepad, to fingers on the controls, or to a released key. In the arena a finger acts as a mouse."""
        if self._held is not None and not is_still_down(self._held[0].position, signal):
            self._held = None
        if isinstance(signal, FocusLost):
            self._drag = None
        if isinstance(signal, Moved | Clicked):
            return self if self._drag is not None else self.side(size).hear_finger(signal, size)
        return self.side(size).answer(signal, size) if pad_of(signal) is None else self._pad(signal, size)

    def _pad(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """A gamepad's button or stick."""
        self._hand, side = Hand.PAD, self.side(size)
        match signal:
            case Released(Action.SERVE | Action.GIVE_UP):
                self._drag = None
            case Pressed(Action.TIP) if side.has_keys:
                side.release()
            case Pressed(Action.STEP_BACK | Action.STEP as action) if side.has_keys:
                side.turn(1 if action is Action.STEP else -1)
            case Pressed(action) if action in COMMAND_ACTIONS and action is not Action.BACK:
                return self._command(COMMAND_ACTIONS[action])
            case _:
                taken, following = side.hear_pad(signal, size)
                return following if taken else self._pad_in_arena(signal)
        return self

    def _pad_in_arena(self, signal: Signal) -> Screen | None:
        """React to a gamepad's button or stick that acts on the arena."""
        match signal:
            case Pressed(Action.LEFT | Action.RIGHT | Action.UP | Action.DOWN as action):
                self._hold(signal, 1)
                self._go(action, 1)
            case Pressed(Action.SERVE | Action.CONFIRM):
                self._begin(self.session.brush)
            case Pressed(Action.GIVE_UP):
                self._begin(ERASER)
            case Pressed(Action.STEP_BACK | Action.STEP as action):
                self._scroll(1 if action is Action.STEP else -1)
            case Pressed(action) if action in COMMAND_ACTIONS:
                return self._command(COMMAND_ACTIONS[action])
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Repeat a direction that is held down, and check the file for changes now and then."""
        self.side(size).advance(seconds, size)
        if self._held is not None:
            signal, steps, repeat = self._held
            repeat, acts = repeat.later(seconds)
            self._held = signal, steps, repeat
            if acts:
                self._go(signal.action, steps)
        self._since_look += seconds
        if self._since_look >= _LOOK_SECONDS:
            self._since_look = 0.0
            self._look()
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the arena, the lines below it, and the controls."""
        size = surface.get_size()
        side = self.side(size)
        tip, file = side.tip(size), self._file.path.name
        shown = Shown(self.session, self.layout(size), side.part, self._hand, self._point(size), side.has_keys, tip, file)
        self._picture.draw(surface, self._state, shown)
        side.draw(surface)

    def save(self) -> bool:
        """Write the file; whether that was possible. What is wrong is shown."""
        try:
            text = saved_text(self.session.document)
            write_text(self._file.path, text)
        except BadInputError as error:
            self.session = self.session._replace(message=str(error))
            return False
        self._file.written(text)
        self.session = self.session._replace(saved=text, message="", file_error="")
        self._tell(tr("Saved: {file}").format(file=self._file.path.name))
        return True

    @property
    def _part(self) -> PanelPart:
        """The part of the controls that is shown."""
        return PanelPart.BRICKS if self._side is None else self._side.part

    def _look(self) -> None:
        """Take over what another program wrote into the file."""
        try:
            text = self._file.news()
        except BadInputError as error:
            self.session = self.session._replace(file_error=str(error), saved="")  # nothing that is known is in the file
            return
        if text is not None:
            self.session = editing.reloaded(self.session, text)
            if not self.session.file_error:
                self._tell(tr("Taken over from the file"))

    def _key(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """React to a pressed key: it acts on the controls, runs a command, or changes the brush or the cursor."""
        side, ctrl = self.side(size), event.mod & (pygame.KMOD_CTRL | pygame.KMOD_META)
        self._hand = Hand.KEYS
        if event.key in PAGES and not side.is_typed_into and (ctrl or side.has_keys):
            side.turn(PAGES[event.key])
            return self
        taken, following = side.hear_key(event, size)
        if taken:
            return following
        key = code_among(event, KNOWN_KEYS)
        if ctrl:
            again = key == pygame.K_z and event.mod & pygame.KMOD_SHIFT
            return self._command("redo" if again else CONTROL_KEYS.get(key))
        layers = layers_of(event)
        if layers is not None:
            self._paint_with(editing.brushed(self.session, layers))
        elif key == COLOUR_KEY:
            self._paint_with(recoloured(self.session, -1 if event.mod & pygame.KMOD_SHIFT else 1))
        elif key in COMMAND_KEYS:
            return self._command(COMMAND_KEYS[key])
        else:
            return self._cursor_key(event, size)
        return self

    def _cursor_key(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """React to a key that moves the cursor, paints, removes, or chooses another ring."""
        if event.key in DIRECTIONS:
            steps = _STRIDE if event.mod & pygame.KMOD_SHIFT else 1
            signal = Pressed(DIRECTIONS[event.key], position_in(event))
            self._hold(signal, steps)
            self._go(signal.action, steps)
        elif event.key in PAINTING_KEYS and self.side(size).has_keys:
            return self.side(size).answer(Pressed(Action.CONFIRM, position_in(event)), size)
        elif event.key in PAINTING_KEYS:
            self._begin(self.session.brush)
        elif event.key in ERASING_KEYS and not self.side(size).has_keys:
            self._begin(ERASER)
        elif event.key in PAGES:
            self._go(Action.UP if PAGES[event.key] < 0 else Action.DOWN, 0)
        return self

    def _hold(self, signal: Pressed, steps: int) -> None:
        """Move in a direction repeatedly until its key is released."""
        self._held = signal, steps, Repeat(signal.position)

    def _go(self, action: Action, steps: int) -> None:
        """Move the cursor, or the chosen gravity well. steps: of a well's movement; 0 to choose another well instead."""
        sign = 1 if action in (Action.RIGHT, Action.UP) else -1
        along = action in (Action.LEFT, Action.RIGHT)
        if self._part is not PanelPart.WELLS:
            self.session = (cursor.moved_along if along else cursor.moved_across)(self.session, sign)
            self._stroke()
        elif steps == 0:
            self.session = chosen_well(self.session, sign)
        elif self.session.document.level.wells:  # counter-clockwise is the angle's direction, and that of the slots
            self.session = editing.stepped(self.session, _ANGLE if along else _DISTANCE, sign * steps)

    def _scroll(self, sign: int) -> None:
        """Choose another brush; in the parts for rings and wells, another ring or well."""
        if self._part is PanelPart.WELLS:
            self.session = chosen_well(self.session, sign)
        elif self._part is PanelPart.RING:
            self.session = cursor.moved_across(self.session, sign)
        else:
            self._paint_with(relayered(self.session, sign))

    def _paint_with(self, session: EditorSession) -> None:
        """Take another brush, and show its part of the controls."""
        self.session = session
        if self._side is not None:
            self._side.open_part(PanelPart.BRICKS)

    def _begin(self, stack: Stack) -> None:
        """Begin a stroke at the cursor, which lasts until the key is released; or add or remove a well."""
        if self._part is PanelPart.WELLS:
            self._command("remove-well" if stack is ERASER else "add-well")
            return
        if self._side is not None:
            self._side.open_part(PanelPart.BRICKS)
        self._drag = EditorDrag(PanelPart.BRICKS, self.session.history, stack)
        self._stroke()

    def _stroke(self) -> None:
        """Paint at the cursor while a key is held."""
        if self._drag is not None:
            at, drag = (self.session.ring, self.session.slot), self._drag
            self.session = editing.stroked(self.session, *at, stack=drag.stack, before=drag.before)

    def _press(self, button: int, size: tuple[int, int]) -> None:
        """React to a mouse button that was pressed in the arena."""
        point, side = self._point(size), self.side(size)
        if point is None:
            return
        if side.part not in (PanelPart.RING, PanelPart.WELLS) and slot_at(self.session.document.level, point) is not None:
            side.open_part(PanelPart.BRICKS)
        self.session, self._drag = pressed(self.session, side.part, point, erases=button != 1)

    def _point(self, size: tuple[int, int]) -> complex | None:
        """The point of the world under the mouse; None outside of the arena."""
        seen = self.layout(size)
        if self._pixel is None or not seen.arena.collidepoint(self._pixel.real, self._pixel.imag):
            return None
        return seen.camera.unproject(self._pixel)

    def _put(self, session: EditorSession) -> None:
        """Take a changed session."""
        self.session = session

    def _command(self, name: str | None) -> Screen | None:
        """Do what a button or a key says."""
        self._drag = self._held = None
        name = OF_WELLS.get(name or "", name) if self._part is PanelPart.WELLS else name
        if name in ("undo", "redo"):
            told = undo_words(self.session.history) if name == "undo" else redo_words(self.session.history)
            words = tr("Undone: {change}") if name == "undo" else tr("Done again: {change}")
            self._tell(words.format(change=told) if told else "")
        change = CHANGES.get(name or "")
        if change is not None:
            self.session = change(self.session)
        elif name == "save":
            self.save()
        elif name == "help":
            return editor_help(self._state, self)
        elif name == "test":
            return self._play_test()
        elif name == "leave":
            return self._leaving() if self.session.changed else self._back()
        return self

    def _tell(self, words: str) -> None:
        """Show for a moment what was done."""
        self._state.toast = Toast(words) if words else None

    def _play_test(self) -> Screen:
        """Play the level as it stands, if it can be played."""
        problem = self.session.document.problem
        if problem is not None:
            self.session = self.session._replace(message=problem.translated)
            return self
        return PlayTest(self._state, self, self.session.document.level)

    def _leaving(self) -> Screen:
        """The question before changes are lost."""

        def saved() -> Screen | None:
            """Save and leave; stay where that is not possible."""
            return self._back() if self.save() else self

        def discarded() -> Screen | None:
            """Leave without saving."""
            self.discarded = True
            return self._back()

        entries = (
            Entry(tr("Save and leave"), saved),
            Entry(tr("Go on editing"), lambda: self),
            Entry(tr("Leave without saving"), discarded),
        )
        return Menu(self._state, self, tr("Unsaved changes"), (self._file.path.name,), entries, back=lambda: self)
