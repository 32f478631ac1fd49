"""The editor as a screen of the game's loop: events to commands of the session, and one picture."""

from collections.abc import Callable
from dataclasses import replace

import pygame

from game.drawing.painter import Painter
from game.editor import session as editing
from game.editor.document import saved_text
from game.editor.file_watch import WatchedFile
from game.editor.session import EditorSession
from game.editor.symmetry import FOLDS, images
from game.editor.window.arena import draw_arena, draw_outlines, slot_at
from game.editor.window.help import EditorHelp
from game.editor.window.layout import EditorLayout, editor_layout
from game.editor.window.panel import draw_panel, stepper_at
from game.editor.window.play_test import PlayTest
from game.input.devices import as_key
from game.input.signals import Signal
from game.language import tr
from game.levels import Level
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.menu import Entry, Menu
from game.system.errors import BadInputError
from game.system.files import write_text

_LOOK_SECONDS = 0.5
"""From one look at the file to the next."""
_TYPED = "0123456789.-"
_LONGEST_NUMBER = 12


class Editor:
    """Edits one level file."""

    def __init__(
        self, state: AppState, session: EditorSession, file: WatchedFile, back: Callable[[], Screen | None] = lambda: None
    ) -> None:
        """Open with a session on a file. back: the screen that it leads back to."""
        self._state, self.session, self._file, self._back = state, session, file, back
        self._painter = Painter()
        self._drawn: Level = session.document.level  # the last one that could be drawn
        self._selected = 0
        self._typed: str | None = None
        self._pixel: complex | None = None
        self._painting: int | None = None  # layers that the drag puts
        self._since_look = 0.0
        self.discarded = False  # whether the player has chosen to lose what is not saved

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> Screen | None:
        """React to a window's event."""
        event = as_key(event) or event
        if event.type == pygame.KEYDOWN:
            return self._key(event)
        if event.type == pygame.MOUSEWHEEL:
            return self._wheel(event, size)
        if event.type not in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION):
            return self
        x, y = event.pos
        self._pixel = complex(x * pixels_per_point.real, y * pixels_per_point.imag)
        if event.type == pygame.MOUSEBUTTONUP:
            self._painting = None
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button in (1, 3):
            return self._pressed(self._pixel, event.button, editor_layout(size, self.session))
        elif event.type == pygame.MOUSEMOTION and self._painting is not None:
            self._stroke(editor_layout(size, self.session), begins=False)
        return self

    def answer(self, _signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """The editor hears events themselves."""
        return self

    def advance(self, seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Look at the file now and then."""
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
            draw_arena(canvas, self._painter, self._drawn)
        hovered = self._hovered(seen)
        slots = (
            None
            if hovered is None
            else images(self.session.document.level.rings[hovered[0]], hovered[1], self.session.symmetry)
        )
        draw_outlines(canvas, self.session, None if hovered is None or slots is None else (hovered[0], slots))
        draw_panel(canvas, seen, self.session, self._selected, self._typed, str(self._file.path.name))

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
        if self._typed is not None and self._type(event):
            return self
        if event.mod & (pygame.KMOD_CTRL | pygame.KMOD_META):
            again = event.key == pygame.K_y or (event.key == pygame.K_z and event.mod & pygame.KMOD_SHIFT)
            named = {pygame.K_z: "undo", pygame.K_s: "save"}.get(event.key)
            return self._command("redo" if again else named)
        command = _COMMAND_KEYS.get(event.key)
        if command is not None:
            return self._command(command)
        if event.unicode in tuple("0123456789"):
            self.session = editing.brushed(self.session, int(event.unicode))
        elif event.unicode == "-":
            self.session = editing.brushed(self.session, -1)
        else:
            self._move(event)
        return self

    def _move(self, event: pygame.Event) -> None:
        """Choose a ring or a number, or change it."""
        shown = editing.rows(self.session)
        step = 10.0 if event.mod & pygame.KMOD_SHIFT else 1.0
        match event.key:
            case pygame.K_TAB:
                self.session = editing.chosen_ring(self.session, -1 if event.mod & pygame.KMOD_SHIFT else 1)
            case pygame.K_UP:
                self._selected = (self._selected - 1) % len(shown)
            case pygame.K_DOWN:
                self._selected = (self._selected + 1) % len(shown)
            case pygame.K_LEFT:
                self.session = editing.stepped(self.session, shown[self._selected], -step)
            case pygame.K_RIGHT:
                self.session = editing.stepped(self.session, shown[self._selected], step)
            case pygame.K_RETURN | pygame.K_KP_ENTER:
                self._typed = ""

    def _type(self, event: pygame.Event) -> bool:
        """Enter a number; whether the key was for that."""
        typed = self._typed or ""
        if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER):
            self._enter(typed)
        elif event.key == pygame.K_ESCAPE:
            self._typed = None
        elif event.key == pygame.K_BACKSPACE:
            self._typed = typed[:-1]
        elif event.unicode and event.unicode in _TYPED:
            self._typed = (typed + event.unicode)[:_LONGEST_NUMBER]
        else:
            self._typed = None
            return False
        return True

    def _enter(self, typed: str) -> None:
        """Take over a number that was typed."""
        self._typed = None
        try:
            value = float(typed)
        except ValueError:
            return
        self.session = editing.entered(self.session, editing.rows(self.session)[self._selected], value)

    def _wheel(self, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """The wheel changes the number under the pointer, else the brush."""
        seen, steps = editor_layout(size, self.session), float(event.precise_y)
        index = None if self._pixel is None else _index_at([box for _, box in seen.rows], self._pixel)
        if index is not None:
            self._selected = index
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
            self._selected = index
            sign = stepper_at(box, pixel, seen.unit)
            if sign:
                self.session = editing.stepped(self.session, row, float(sign))
            else:
                self._typed = ""
        self._painting = 0 if button == 3 else self.session.brush
        self._stroke(seen, begins=True)
        return self

    def _stroke(self, seen: EditorLayout, *, begins: bool) -> None:
        """Paint the slot under the pointer and its images."""
        hovered = self._hovered(seen)
        if hovered is not None and self._painting is not None:
            self.session = editing.stroked(self.session, *hovered, layers=self._painting, begins=begins)

    def _hovered(self, seen: EditorLayout) -> tuple[int, int] | None:
        """Ring and slot under the pointer."""
        if self._pixel is None or not seen.arena.collidepoint(self._pixel.real, self._pixel.imag):
            return None
        return slot_at(self.session.document.level, seen.camera.unproject(self._pixel))

    def _command(self, name: str | None) -> Screen | None:
        """Do what a button or a key says."""
        change = _CHANGES.get(name or "")
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


def _mirrored(session: EditorSession) -> EditorSession:
    """The session with mirror images switched on or off."""
    return session._replace(symmetry=session.symmetry._replace(mirrored=not session.symmetry.mirrored))


def _next_fold(session: EditorSession) -> EditorSession:
    """The session with the next number of rotations."""
    fold = FOLDS[(FOLDS.index(session.symmetry.fold) + 1) % len(FOLDS)]
    return session._replace(symmetry=session.symmetry._replace(fold=fold))


def _index_at(boxes: list[pygame.Rect], pixel: complex) -> int | None:
    """Index of the box that a pixel is in."""
    return next((index for index, box in enumerate(boxes) if box.collidepoint(pixel.real, pixel.imag)), None)


_CHANGES: dict[str, Callable[[EditorSession], EditorSession]] = {
    "add": editing.with_ring_copied,
    "remove": editing.with_ring_removed,
    "fill": editing.filled,
    "undo": editing.undone,
    "redo": editing.redone,
    "mirror": _mirrored,
    "fold": _next_fold,
}
_COMMAND_KEYS = {
    pygame.K_INSERT: "add",
    pygame.K_c: "add",
    pygame.K_DELETE: "remove",
    pygame.K_f: "fill",
    pygame.K_m: "mirror",
    pygame.K_r: "fold",
    pygame.K_F5: "test",
    pygame.K_F1: "help",
    pygame.K_h: "help",
    pygame.K_ESCAPE: "leave",
}
