"""The editor as a screen of the game's loop: events to commands of the session, and one picture."""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import pygame

from game.drawing.painter import Painter
from game.editor import cursor
from game.editor import session as editing
from game.editor.document import saved_text
from game.editor.file_watch import WatchedFile
from game.editor.history import EditHistory
from game.editor.session import EditorSession
from game.editor.window.arena import draw_arena, draw_outlines, slot_at
from game.editor.window.commands import (
    CHANGES,
    COMMAND_ACTIONS,
    COMMAND_KEYS,
    CONTROL_KEYS,
    DIRECTIONS,
    ERASING_KEYS,
    PAINTING_KEYS,
    folded,
    layers_of,
    next_of,
)
from game.editor.window.help import EditorHelp, Hand, hint
from game.editor.window.layout import BRUSHES, BUTTONS, EditorLayout, editor_layout
from game.editor.window.number_entry import typed_after
from game.editor.window.panel import PanelState, draw_panel, stepper_at
from game.editor.window.play_test import PlayTest
from game.editor.window.targets import Target, TargetKind, beside, target_below
from game.input.keys import Action, position_in
from game.input.repeat import Repeat
from game.input.signals import FocusLost, Pressed, Released, Signal, is_still_down, pad_of
from game.language import tr
from game.levels import Level
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.menu import Entry, Menu
from game.system.errors import BadInputError
from game.system.files import write_text

_LOOK_SECONDS = 0.5
"""From one look at the file to the next."""


class BrushDrag(NamedTuple):
    """What the mouse or the cursor paints until the button or the key is let go. before: the history when it began."""

    layers: int
    before: EditHistory


class Editor:
    """Edits one level file.

    Keys and gamepad act on the cursor in the arena, or on what they have chosen in the panel beside it.
    """

    def __init__(
        self, state: AppState, session: EditorSession, file: WatchedFile, back: Callable[[], Screen | None] = lambda: None
    ) -> None:
        """Open with a session on a file. back: the screen that it leads back to."""
        self._state, self.session, self._file, self._back = state, session, file, back
        self._painter = Painter()
        self._drawn: Level | None = None  # the last one that could be drawn
        self._hand = Hand.KEYS
        self._in_panel = False
        self._target = Target(TargetKind.NUMBER)
        self._typed: str | None = None
        self._pixel: complex | None = None  # of the mouse
        self._drag: BrushDrag | None = None  # of the mouse, or of the cursor while a key is down
        self._held: tuple[Pressed, int, Repeat] | None = None  # the direction that is held down, and the steps it takes
        self._since_look = 0.0
        self.discarded = False  # whether the player has chosen to lose what is not saved

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> Screen | None:
        """React to a window's event. What gamepads do comes as signals, to `answer`."""
        if event.type == pygame.KEYDOWN:
            return self._key(event)
        if event.type == pygame.KEYUP and event.key in (*PAINTING_KEYS, *ERASING_KEYS):
            self._drag = None
        if event.type == pygame.MOUSEWHEEL:
            return self._wheel(event, size)
        if event.type not in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION):
            return self
        x, y = event.pos
        self._pixel, self._hand = complex(x * pixels_per_point.real, y * pixels_per_point.imag), Hand.MOUSE
        if event.type == pygame.MOUSEBUTTONUP:
            self._drag = None
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button in (1, 3):
            return self._pressed(self._pixel, event.button, editor_layout(size, self.session))
        elif event.type == pygame.MOUSEMOTION and self._drag is not None:
            self._stroke(self._hovered(editor_layout(size, self.session)))
        return self

    def answer(self, signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """React to a gamepad, or to a key that was let go."""
        if self._held is not None and not is_still_down(self._held[0].position, signal):
            self._held = None
        if isinstance(signal, FocusLost):
            self._drag = None
        return self if pad_of(signal) is None else self._pad(signal)

    def _pad(self, signal: Signal) -> Screen | None:
        """A gamepad's button or stick."""
        self._hand = Hand.PAD
        match signal:
            case Pressed(Action.LEFT | Action.RIGHT | Action.UP | Action.DOWN):
                self._typed, self._held = None, (signal, 1, Repeat(signal.position))
                self._go(signal.action, 1)
            case Pressed(Action.SERVE | Action.CONFIRM) if not (self._in_panel and self._target.kind is TargetKind.NUMBER):
                return self._accept()
            case Pressed(Action.GIVE_UP) if not self._in_panel:
                self._draw_at_cursor(0)
            case Released(Action.SERVE | Action.CONFIRM | Action.GIVE_UP):
                self._drag = None
            case Pressed(Action.TIP):
                self._in_panel = not self._in_panel
            case Pressed(Action.STEP | Action.STEP_BACK as action):
                self._shoulder(1 if action is Action.STEP else -1)
            case Pressed(Action.BACK) if self._in_panel:
                self._in_panel = False
            case Pressed(action):
                return self._command(COMMAND_ACTIONS.get(action))
        return self

    def advance(self, seconds: float, _size: tuple[int, int]) -> Screen | None:
        """A direction that is held down acts again and again; look at the file now and then."""
        if self._held is not None:
            pressed, steps, repeat = self._held
            repeat, acts = repeat.later(seconds)
            self._held = pressed, steps, repeat
            if acts:
                self._go(pressed.action, steps)
        self._since_look += seconds
        if self._since_look >= _LOOK_SECONDS:
            self._since_look = 0.0
            self._look()
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The arena and the panel."""
        seen = editor_layout(surface.get_size(), self.session)
        canvas = self._state.canvas(surface, seen.camera)._replace(unit=seen.unit)
        surface.fill(canvas.theme.background)
        try:
            draw_arena(canvas, self._painter, self.session.document.level)
            self._drawn = self.session.document.level
        except ValueError:  # sizes that the physics does not take; the problem is written below
            if self._drawn is not None:
                draw_arena(canvas, self._painter, self._drawn)
        by_mouse = self._hand is Hand.MOUSE
        at = self._hovered(seen) if by_mouse else (self.session.ring, self.session.slot)
        in_panel = self._in_panel and not by_mouse
        draw_outlines(canvas, self.session, at, canvas.theme.faint if in_panel else canvas.theme.accent)
        panel = PanelState(self._target, in_panel, self._typed, hint(self._hand, in_panel=self._in_panel))
        draw_panel(canvas, seen, self.session, panel, str(self._file.path.name))

    def save(self) -> bool:
        """Write the file; whether that was possible. What is wrong is shown."""
        try:
            text = saved_text(self.session.document)
            write_text(self._file.path, text)
        except BadInputError as error:
            self.session = self.session._replace(message=str(error))
            return False
        self._file.written(text)
        self.session = self.session._replace(saved=text, message="")
        return True

    def _look(self) -> None:
        """Take over what another program wrote into the file."""
        try:
            text = self._file.news()
        except BadInputError as error:
            self.session = self.session._replace(message=str(error))
            return
        if text is not None:
            self.session = editing.reloaded(self.session, text)

    def _key(self, event: pygame.Event) -> Screen | None:
        """A key went down."""
        if self._type(event):
            return self
        self._hand = Hand.KEYS
        if event.mod & (pygame.KMOD_CTRL | pygame.KMOD_META):
            again = event.key == pygame.K_y or (event.key == pygame.K_z and event.mod & pygame.KMOD_SHIFT)
            return self._command("redo" if again else CONTROL_KEYS.get(event.key))
        command = COMMAND_KEYS.get(event.key)
        if command is not None:
            return self._command(command)
        layers = layers_of(event)
        if layers is not None:
            self.session = editing.brushed(self.session, layers)
        elif event.key in DIRECTIONS:
            pressed, steps = Pressed(DIRECTIONS[event.key], position_in(event)), 10 if event.mod & pygame.KMOD_SHIFT else 1
            self._held = pressed, steps, Repeat(pressed.position)
            self._go(pressed.action, steps)
        else:
            return self._act(event)
        return self

    def _act(self, event: pygame.Event) -> Screen | None:
        """A key that paints, takes away, accepts, or goes to another ring or into the panel."""
        if event.key in PAINTING_KEYS:
            return self._accept()
        if event.key in ERASING_KEYS and not self._in_panel:
            self._draw_at_cursor(0)
        elif event.key == pygame.K_TAB:
            self._in_panel = not self._in_panel
        elif event.key in (pygame.K_PAGEUP, pygame.K_PAGEDOWN):
            self.session = cursor.moved_across(self.session, 1 if event.key == pygame.K_PAGEUP else -1)
        return self

    def _go(self, action: Action, steps: int) -> None:
        """Move the cursor, or in the panel choose another number or change it. steps: at once, of a number."""
        sign = 1 if action in (Action.RIGHT, Action.UP) else -1
        if self._in_panel:
            self._go_in_panel(sign, steps, across=action in (Action.LEFT, Action.RIGHT))
            return
        along = action in (Action.LEFT, Action.RIGHT)
        self.session = (cursor.moved_along if along else cursor.moved_across)(self.session, sign)
        self._stroke((self.session.ring, self.session.slot))

    def _go_in_panel(self, sign: int, steps: int, *, across: bool) -> None:
        """Choose another target, or change the one that is chosen."""
        shown = editing.rows(self.session)
        if not across:
            self._target = target_below(self._target, -sign, len(shown))
            return
        match self._target.kind:
            case TargetKind.NUMBER:
                self.session = editing.stepped(self.session, shown[self._target.number], float(sign * steps))
            case TargetKind.BRUSH:
                self.session = editing.brushed(self.session, next_of(BRUSHES, self.session.brush, sign))
            case TargetKind.FOLD:
                self.session = folded(self.session, sign)
            case TargetKind.COMMAND:
                self._target = beside(self._target)

    def _shoulder(self, sign: int) -> None:
        """The gamepad's shoulders: ten steps of a number, else another brush."""
        if self._in_panel and self._target.kind is TargetKind.NUMBER:
            self._go_in_panel(sign, 10, across=True)
        else:
            self.session = editing.brushed(self.session, next_of(BRUSHES, self.session.brush, sign))

    def _accept(self) -> Screen | None:
        """Paint at the cursor, or in the panel type a number or give a command."""
        if not self._in_panel:
            self._draw_at_cursor(self.session.brush)
        elif self._target.kind is TargetKind.NUMBER:
            self._typed = ""
        elif self._target.kind is TargetKind.COMMAND:
            return self._command(BUTTONS[self._target.number].name)
        return self

    def _draw_at_cursor(self, layers: int) -> None:
        """Begin a stroke at the cursor; it goes on while the key is held and the cursor moves."""
        self._drag = BrushDrag(layers, self.session.history)
        self._stroke((self.session.ring, self.session.slot))

    def _type(self, event: pygame.Event) -> bool:
        """Go on with the number that is typed, if one is; whether the key was for that."""
        if self._typed is None:
            return False
        typing = typed_after(self._typed, event)
        self._typed = typing.text
        if typing.value is not None:
            self.session = editing.entered(self.session, editing.rows(self.session)[self._target.number], typing.value)
        return typing.used

    def _wheel(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """The wheel changes the number under the pointer, else the brush."""
        seen, steps = editor_layout(size, self.session), float(event.precise_y)
        index = None if self._pixel is None else _index_at([box for _, box in seen.rows], self._pixel)
        if index is not None:
            self._target = Target(TargetKind.NUMBER, index)
            self.session = editing.stepped(self.session, seen.rows[index][0], steps)
        elif steps:
            self.session = editing.brushed(self.session, self.session.brush + (1 if steps > 0.0 else -1))
        return self

    def _pressed(self, pixel: complex, button: int, seen: EditorLayout) -> Screen | None:
        """A mouse button went down."""
        self._typed = None
        for command, box in seen.buttons:
            if box.collidepoint(pixel.real, pixel.imag):
                return self._command(command.name)
        for layers, box in seen.chips:
            if box.collidepoint(pixel.real, pixel.imag):
                self.session = editing.brushed(self.session, layers)
        for fold, box in seen.folds:
            if box.collidepoint(pixel.real, pixel.imag):
                self.session = self.session._replace(symmetry=self.session.symmetry._replace(fold=fold))
        index = _index_at([box for _, box in seen.rows], pixel)
        if index is not None:
            row, box = seen.rows[index]
            self._target, self._in_panel = Target(TargetKind.NUMBER, index), True
            sign = stepper_at(box, pixel, seen.unit)
            if sign:
                self.session = editing.stepped(self.session, row, float(sign))
            else:
                self._typed = ""
        hovered = self._hovered(seen)
        if hovered is not None:
            self._in_panel = False
        self._drag = BrushDrag(0 if button == 3 else self.session.brush, self.session.history)
        self._stroke(hovered)
        return self

    def _stroke(self, at: tuple[int, int] | None) -> None:
        """Paint a slot of a ring and its images, while something is dragged."""
        if at is not None and self._drag is not None:
            self.session = editing.stroked(self.session, *at, layers=self._drag.layers, before=self._drag.before)

    def _hovered(self, seen: EditorLayout) -> tuple[int, int] | None:
        """Ring and slot under the pointer."""
        if self._pixel is None or not seen.arena.collidepoint(self._pixel.real, self._pixel.imag):
            return None
        return slot_at(self.session.document.level, seen.camera.unproject(self._pixel))

    def _command(self, name: str | None) -> Screen | None:
        """Do what a button or a key says."""
        self._drag = self._held = None
        change = CHANGES.get(name or "")
        if change is not None:
            self.session = change(self.session)
        elif name == "save":
            self.save()
        elif name == "help":
            return EditorHelp(self._state, self)
        elif name == "test":
            return self._play_test()
        elif name == "leave":
            return self._leaving() if self.session.changed else self._back()
        return self

    def _play_test(self) -> Screen:
        """Play the level as it stands, if it can be played."""
        if self.session.document.problem:
            self.session = self.session._replace(message=self.session.document.problem)
            return self
        return PlayTest(replace(self._state, recorder=None), self, self.session.document.level)

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


def _index_at(boxes: list[pygame.Rect], pixel: complex) -> int | None:
    """Index of the box that a pixel is in."""
    return next((index for index, box in enumerate(boxes) if box.collidepoint(pixel.real, pixel.imag)), None)
