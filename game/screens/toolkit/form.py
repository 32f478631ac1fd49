"""A form: rows of items on a part of a surface. One item has the focus; keys, mouse, touch and gamepad use and scroll them."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.input.keys import Action
from game.input.repeat import Repeat
from game.input.signals import Clicked, KeyboardState, Moved, Pressed, Released, Signal, Zoomed, is_still_down
from game.screens.base import Screen
from game.screens.toolkit.focus import Focus, first_focus, moved_focus
from game.screens.toolkit.layout import BAR, LINE, TIP, TIP_LINES, FormLayout, PositionedItem
from game.screens.toolkit.plate import index_at

_WHEEL = 3.0
"""Units of text that a step of the wheel scrolls."""


class Grip(NamedTuple):
    """The item that the mouse drags. offset: pixels from its knob's middle to the mouse, so that the knob does not jump."""

    focus: Focus
    offset: complex


class Form:
    """The base class of panels and side panels: these say where their items are (`_form_layout`)."""

    def __init__(self) -> None:
        """Begin at the top."""
        self._focus: Focus | None = None
        self._scroll = 0.0  # pixels
        self._stride = 1  # steps that left and right step an item by
        self._changes = 0  # counts what happened: while it stays, so does the picture
        self._pixel = 0j  # where the mouse was
        self._grip: Grip | None = None
        self._is_pressed = False  # whether the mouse was pressed here, and still is
        self._drags_bar = False  # whether the mouse drags the scroll bar
        self._held: tuple[Pressed, Repeat] | None = None  # the direction that is held down

    @property
    def screen(self) -> Screen:
        """The screen that it is on."""
        raise NotImplementedError

    @property
    def tab(self) -> int | None:
        """Index of the tab that is shown; None where there are no tabs."""
        return None

    def unit(self, size: tuple[int, int]) -> float:
        """Size of text, pixels. size: of the whole surface."""
        raise NotImplementedError

    def first(self) -> Focus | None:
        """The focus when the form opens; None for the first item that can be used."""
        return None

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Move the focus, or use an item: the screen to go on with."""
        self._held = _held_after(self._held, signal)
        match signal:
            case Pressed(Action.UP | Action.DOWN | Action.LEFT | Action.RIGHT as action):
                self._moved(action, size)
            case Pressed(Action.CONFIRM | Action.SERVE):
                self._changes += 1
                return self._accepted(size)
            case Pressed(action):
                return self._named(action, size)
            case Zoomed(steps):
                self._scroll_by(-steps * _WHEEL * self.unit(size), size)
            case Moved(pixel, held):
                return self._dragged(pixel, size) if held else self._hovered(pixel, size)
            case Clicked(pixel):
                return self._clicked(pixel, size)
        return self.screen

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Repeat a direction that is held down."""
        if self._held is not None:
            pressed, repeat = self._held
            repeat, acts = repeat.later(seconds)
            self._held = pressed, repeat
            if acts:
                self._moved(pressed.action, size)
        return self.screen

    def draw_items(self, canvas: Canvas, layout: FormLayout, focus: Focus | None, *, centred: bool = False) -> None:
        """Draw all items, the scroll bar, and the tip of the focused item. centred: whether the tip is."""
        surface, clip = canvas.surface, canvas.surface.get_clip()
        for positioned in layout.items:
            surface.set_clip(layout.body.clip(clip) if positioned.in_body else clip)
            if not positioned.in_body or positioned.box.colliderect(layout.body):
                positioned.item.draw(canvas, positioned.box, focused=Focus(positioned.row, positioned.column) == focus)
        surface.set_clip(clip)
        _draw_scroll_bar(canvas, layout, self._scroll)
        focused = focused_item(layout, focus)
        if focused is not None and focused.item.tip and layout.tip.height:
            _draw_tip(canvas, focused.item.tip, layout.tip, centred=centred)

    def _form_layout(self, size: tuple[int, int]) -> FormLayout:
        """The layout now. The scroll position is limited to what there is to scroll."""
        raise NotImplementedError

    def _settled(self, layout: FormLayout) -> Focus | None:
        """The focus; if its item is gone, the first item that can be used."""
        if self._focus is None:
            self._focus = self.first()
        if self._focus is None or (self._focus.row >= 0 and focused_item(layout, self._focus) is None):
            self._focus = first_focus(layout, self._focus)
        return self._focus

    def _moved(self, action: Action, size: tuple[int, int]) -> None:
        """Move the focus, or step the item that has it."""
        layout = self._form_layout(size)
        focus = self._settled(layout)
        steps = {Action.LEFT: -1, Action.RIGHT: 1}.get(action, 0)
        self._changes += 1
        if not steps and self._read_on(layout, size, 1.0 if action is Action.DOWN else -1.0):
            return
        if focus is None:
            return
        if (
            not steps
            or _shares_row(layout, focus)
            or (positioned := focused_item(layout, focus)) is None
            or not positioned.item.stepped(steps * self._stride)
        ):
            self._focus = moved_focus(layout, focus, action, self.tab)
            self._show_focus(size)

    def _read_on(self, layout: FormLayout, size: tuple[int, int], direction: float) -> bool:
        """Scroll a body without usable items, -1.0 up or 1.0 down. Returns whether it moved."""
        before = self._scroll
        if not any([positioned.in_body and positioned.item.focusable for positioned in layout.items]):
            self._scroll_by(direction * _WHEEL * self.unit(size), size)
        return self._scroll != before

    def _accepted(self, size: tuple[int, int]) -> Screen | None:
        """Use the item that has the focus."""
        layout = self._form_layout(size)
        positioned = focused_item(layout, self._settled(layout))
        return self.screen if positioned is None else positioned.item.accepted(self.screen)

    def _named(self, action: Action, size: tuple[int, int]) -> Screen | None:
        """Use the item whose key was pressed."""
        for positioned in self._form_layout(size).items:
            if positioned.item.key is action and positioned.item.focusable:
                self._changes += 1
                return positioned.item.accepted(self.screen)
        return self.screen

    def _hovered(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Focus the item under the mouse."""
        layout = self._form_layout(size)
        self._pixel, self._grip, self._is_pressed = pixel, None, False
        self._drags_bar = _is_on_bar(layout, pixel, self.unit(size))
        positioned = pointed_item(layout, pixel)
        if positioned is not None:
            self._focus = Focus(positioned.row, positioned.column)
        return self.screen

    def _dragged(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """With the button held, drag the knob that was pressed, or the scroll bar; else the body follows the mouse.

        A finger that comes down presses nothing yet: what it is on when it moves is dragged, if it has the focus.
        """
        layout, unit, before, self._pixel = self._form_layout(size), self.unit(size), self._pixel, pixel
        if self._drags_bar:
            self._scroll_to(pixel, layout, unit)
            return self.screen
        if self._grip is None and not self._is_pressed:
            positioned = pointed_item(layout, pixel)
            if positioned is not None and Focus(positioned.row, positioned.column) == self._focus:
                self._grip = _grip_of(positioned, pixel, unit)
        held = None if self._grip is None else focused_item(layout, self._grip.focus)
        if self._grip is None or held is None:
            self._scroll_by(before.imag - pixel.imag, size)
            return self.screen
        self._changes += 1
        return held.item.pointed(self.screen, pixel - self._grip.offset, held.box, unit, clicked=False)

    def _clicked(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Use the item under the mouse."""
        layout, unit = self._form_layout(size), self.unit(size)
        self._pixel, self._grip, self._is_pressed = pixel, None, True
        self._drags_bar = _is_on_bar(layout, pixel, unit)
        if self._drags_bar:
            self._scroll_to(pixel, layout, unit)
            return self.screen
        positioned = pointed_item(layout, pixel)
        if positioned is None:
            return self.screen
        self._focus = Focus(positioned.row, positioned.column)
        self._grip = _grip_of(positioned, pixel, unit)
        self._changes += 1
        return positioned.item.pointed(self.screen, pixel, positioned.box, unit, clicked=True)

    def _scroll_to(self, pixel: complex, layout: FormLayout, unit: float) -> None:
        """Scroll to the mouse's position on the scroll bar."""
        track = _scroll_track(layout, unit)
        thumb = track.height * layout.body.height / (layout.body.height + layout.over)
        share = (pixel.imag - track.top - thumb / 2.0) / max(track.height - thumb, 1.0)
        self._scroll = min(max(share, 0.0), 1.0) * layout.over

    def _scroll_by(self, pixels: float, size: tuple[int, int]) -> None:
        """Scroll the body by some pixels, as far as possible."""
        self._scroll = min(max(self._scroll + pixels, 0.0), float(self._form_layout(size).over))

    def _show_focus(self, size: tuple[int, int]) -> None:
        """Scroll so that the item that has the focus is seen whole; to the very top with the first."""
        layout = self._form_layout(size)
        positioned = focused_item(layout, self._focus)
        if positioned is None or not positioned.in_body:
            return
        above, below = layout.body.top - positioned.box.top, positioned.box.bottom - layout.body.bottom
        if above > 0:
            rows = [other.row for other in layout.items if other.item.focusable and other.in_body]
            self._scroll_by(-1e6 if positioned.row == min(rows) else -float(above), size)
        elif below > 0:
            self._scroll_by(float(below), size)


def focused_item(layout: FormLayout, focus: Focus | None) -> PositionedItem | None:
    """The item that has the focus, if it can be used."""
    for positioned in layout.items:
        if focus is not None and (positioned.row, positioned.column) == focus and positioned.item.focusable:
            return positioned
    return None


def _held_after(held: tuple[Pressed, Repeat] | None, signal: Signal) -> tuple[Pressed, Repeat] | None:
    """The direction that is held down after a signal: the last that was pressed, until it comes up or anything else happens."""
    match signal:
        case Pressed(Action.UP | Action.DOWN | Action.LEFT | Action.RIGHT):
            return signal, Repeat(signal.position)
        case KeyboardState() | Released():
            return held if held is not None and is_still_down(held[0].position, signal) else None
        case Moved():
            return held
        case _:
            return None


def _grip_of(positioned: PositionedItem, pixel: complex, unit: float) -> Grip | None:
    """The knob or scroll bar that a press at a pixel begins to drag; None for nothing."""
    offset = positioned.item.grip(pixel, positioned.box, unit)
    return None if offset is None else Grip(Focus(positioned.row, positioned.column), offset)


def _shares_row(layout: FormLayout, focus: Focus) -> bool:
    """Whether there are other items to be used beside the one that has the focus: left and right lead to these then."""
    return len([positioned for positioned in layout.items if positioned.row == focus.row and positioned.item.focusable]) > 1


def pointed_item(layout: FormLayout, pixel: complex) -> PositionedItem | None:
    """The item that can be used at a pixel."""
    for positioned in layout.items:
        if (
            positioned.item.focusable
            and index_at([positioned.box.clip(layout.body) if positioned.in_body else positioned.box], pixel) is not None
        ):
            return positioned
    return None


def _draw_tip(canvas: Canvas, tip: str, box: pygame.Rect, *, centred: bool) -> None:
    """Draw the tip of the item that has the focus."""
    anchor, x = ("midtop", box.centerx) if centred else ("topleft", box.left)
    size = TIP
    lines = canvas.type.wrapped(tip, canvas.unit * size, box.width)
    if len(lines) > TIP_LINES:
        size *= 0.85
        lines = canvas.type.wrapped(tip, canvas.unit * size, box.width)[:TIP_LINES]
    for index, line in enumerate(lines):
        pixel = complex(x, box.top + canvas.unit * size * LINE * index)
        canvas.write(line, size, canvas.theme.faint, pixel, anchor)


def _is_on_bar(layout: FormLayout, pixel: complex, unit: float) -> bool:
    """Whether a pixel is on the scroll bar, or a little beside it."""
    track = _scroll_track(layout, unit)
    return layout.over > 0 and index_at([track.inflate(track.width * 2, 0)], pixel) is not None


def _scroll_track(layout: FormLayout, unit: float) -> pygame.Rect:
    """The whole scroll bar."""
    bar = pygame.Rect(0, layout.body.top, max(round(BAR * unit), 2), layout.body.height)
    bar.right = layout.bar
    return bar


def _draw_scroll_bar(canvas: Canvas, layout: FormLayout, scroll: float) -> None:
    """Draw the scroll bar: which part of the body is visible."""
    if not layout.over:
        return
    track, theme = _scroll_track(layout, canvas.unit), canvas.theme
    draw_box(canvas.surface, track, track.width / 2.0, theme.background)
    thumb = track.copy()
    thumb.height = max(round(track.height * layout.body.height / (layout.body.height + layout.over)), track.width)
    thumb.top = track.top + round((track.height - thumb.height) * scroll / layout.over)
    draw_box(canvas.surface, thumb, track.width / 2.0, theme.panel_edge)
