"""Items below each other on a part of a surface: one has the focus, they scroll, and keys, mouse, touch or gamepad use them."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.input.keys import Action
from game.input.repeat import Repeat
from game.input.signals import Clicked, KeyboardState, Moved, Pressed, Released, Signal, Zoomed, is_still_down
from game.screens.base import Screen
from game.screens.toolkit import layout
from game.screens.toolkit.focus import Focus, first_focus, moved_focus
from game.screens.toolkit.layout import Laid, Spot
from game.screens.toolkit.plate import index_at

_WHEEL = 3.0
"""Units of text that a step of the wheel scrolls."""


class Grip(NamedTuple):
    """The item that the mouse drags. offset: pixels from its knob's middle to the mouse, so that the knob does not jump."""

    focus: Focus
    offset: complex


class Form:
    """What panels, and the sides of other screens, derive from: they say how their items are laid out (`_laid`)."""

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
        """What has the focus when it opens; None for the first item that can be used."""
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
        """A direction that is held down acts again and again; nothing else moves."""
        if self._held is not None:
            pressed, repeat = self._held
            repeat, acts = repeat.later(seconds)
            self._held = pressed, repeat
            if acts:
                self._moved(pressed.action, size)
        return self.screen

    def draw_items(self, canvas: Canvas, laid: Laid, focus: Focus | None, *, centred: bool = False) -> None:
        """All items, the scroll bar, and what is said about the item that has the focus. centred: those words."""
        surface, clip = canvas.surface, canvas.surface.get_clip()
        for spot in laid.spots:
            surface.set_clip(laid.body.clip(clip) if spot.in_body else clip)
            if not spot.in_body or spot.box.colliderect(laid.body):
                spot.item.draw(canvas, spot.box, focused=Focus(spot.row, spot.column) == focus)
        surface.set_clip(clip)
        _draw_scroll_bar(canvas, laid, self._scroll)
        focused = spot_at(laid, focus)
        if focused is not None and focused.item.tip and laid.tip.height:
            _draw_tip(canvas, focused.item.tip, laid.tip, centred=centred)

    def _laid(self, size: tuple[int, int]) -> Laid:
        """Where everything is now. It does not scroll further than there is something."""
        raise NotImplementedError

    def _settled(self, laid: Laid) -> Focus | None:
        """What has the focus; where that is gone, the first item that can be used."""
        if self._focus is None:
            self._focus = self.first()
        if self._focus is None or (self._focus.row >= 0 and spot_at(laid, self._focus) is None):
            self._focus = first_focus(laid, self._focus)
        return self._focus

    def _moved(self, action: Action, size: tuple[int, int]) -> None:
        """Move the focus, or step the item that has it."""
        laid = self._laid(size)
        focus = self._settled(laid)
        steps = {Action.LEFT: -1, Action.RIGHT: 1}.get(action, 0)
        self._changes += 1
        if not steps and self._read_on(laid, size, 1.0 if action is Action.DOWN else -1.0):
            return
        if focus is None:
            return
        if (
            not steps
            or _shares_row(laid, focus)
            or (spot := spot_at(laid, focus)) is None
            or not spot.item.stepped(steps * self._stride)
        ):
            self._focus = moved_focus(laid, focus, action, self.tab)
            self._show_focus(size)

    def _read_on(self, laid: Laid, size: tuple[int, int], direction: float) -> bool:
        """Scroll a body that can only be read, -1.0 up or 1.0 down; whether there was more of it."""
        before = self._scroll
        if not any([spot.in_body and spot.item.focusable for spot in laid.spots]):
            self._scroll_by(direction * _WHEEL * self.unit(size), size)
        return self._scroll != before

    def _accepted(self, size: tuple[int, int]) -> Screen | None:
        """Use the item that has the focus."""
        laid = self._laid(size)
        spot = spot_at(laid, self._settled(laid))
        return self.screen if spot is None else spot.item.accepted(self.screen)

    def _named(self, action: Action, size: tuple[int, int]) -> Screen | None:
        """Use the item that a key stands for."""
        for spot in self._laid(size).spots:
            if spot.item.key is action and spot.item.focusable:
                self._changes += 1
                return spot.item.accepted(self.screen)
        return self.screen

    def _hovered(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Focus what the mouse is on."""
        laid = self._laid(size)
        self._pixel, self._grip, self._is_pressed = pixel, None, False
        self._drags_bar = _is_on_bar(laid, pixel, self.unit(size))
        spot = pointed_spot(laid, pixel)
        if spot is not None:
            self._focus = Focus(spot.row, spot.column)
        return self.screen

    def _dragged(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """With the button held, drag the knob that was pressed, or the scroll bar; else the body follows the mouse.

        A finger that comes down presses nothing yet: what it is on when it moves is dragged, if it has the focus.
        """
        laid, unit, before, self._pixel = self._laid(size), self.unit(size), self._pixel, pixel
        if self._drags_bar:
            self._scroll_to(pixel, laid, unit)
            return self.screen
        if self._grip is None and not self._is_pressed:
            spot = pointed_spot(laid, pixel)
            if spot is not None and Focus(spot.row, spot.column) == self._focus:
                self._grip = _grip_of(spot, pixel, unit)
        held = None if self._grip is None else spot_at(laid, self._grip.focus)
        if self._grip is None or held is None:
            self._scroll_by(before.imag - pixel.imag, size)
            return self.screen
        self._changes += 1
        return held.item.pointed(self.screen, pixel - self._grip.offset, held.box, unit, clicked=False)

    def _clicked(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Use what the mouse is on."""
        laid, unit = self._laid(size), self.unit(size)
        self._pixel, self._grip, self._is_pressed = pixel, None, True
        self._drags_bar = _is_on_bar(laid, pixel, unit)
        if self._drags_bar:
            self._scroll_to(pixel, laid, unit)
            return self.screen
        spot = pointed_spot(laid, pixel)
        if spot is None:
            return self.screen
        self._focus = Focus(spot.row, spot.column)
        self._grip = _grip_of(spot, pixel, unit)
        self._changes += 1
        return spot.item.pointed(self.screen, pixel, spot.box, unit, clicked=True)

    def _scroll_to(self, pixel: complex, laid: Laid, unit: float) -> None:
        """Scroll to where the mouse is along the scroll bar."""
        track = _scroll_track(laid, unit)
        thumb = track.height * laid.body.height / (laid.body.height + laid.over)
        share = (pixel.imag - track.top - thumb / 2.0) / max(track.height - thumb, 1.0)
        self._scroll = min(max(share, 0.0), 1.0) * laid.over

    def _scroll_by(self, pixels: float, size: tuple[int, int]) -> None:
        """Scroll the body as far as it goes."""
        self._scroll = min(max(self._scroll + pixels, 0.0), float(self._laid(size).over))

    def _show_focus(self, size: tuple[int, int]) -> None:
        """Scroll so that the item that has the focus is seen whole; to the very top with the first."""
        laid = self._laid(size)
        spot = spot_at(laid, self._focus)
        if spot is None or not spot.in_body:
            return
        above, below = laid.body.top - spot.box.top, spot.box.bottom - laid.body.bottom
        if above > 0:
            rows = [other.row for other in laid.spots if other.item.focusable and other.in_body]
            self._scroll_by(-1e6 if spot.row == min(rows) else -float(above), size)
        elif below > 0:
            self._scroll_by(float(below), size)


def spot_at(laid: Laid, focus: Focus | None) -> Spot | None:
    """The item that has the focus, if it can be used."""
    for spot in laid.spots:
        if focus is not None and (spot.row, spot.column) == focus and spot.item.focusable:
            return spot
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


def _grip_of(spot: Spot, pixel: complex, unit: float) -> Grip | None:
    """What a press at a pixel takes hold of, to be dragged; None for nothing."""
    offset = spot.item.grip(pixel, spot.box, unit)
    return None if offset is None else Grip(Focus(spot.row, spot.column), offset)


def _shares_row(laid: Laid, focus: Focus) -> bool:
    """Whether there are other items to be used beside the one that has the focus: left and right lead to these then."""
    return len([spot for spot in laid.spots if spot.row == focus.row and spot.item.focusable]) > 1


def pointed_spot(laid: Laid, pixel: complex) -> Spot | None:
    """The item that can be used at a pixel."""
    for spot in laid.spots:
        if spot.item.focusable and index_at([spot.box.clip(laid.body) if spot.in_body else spot.box], pixel) is not None:
            return spot
    return None


def _draw_tip(canvas: Canvas, tip: str, box: pygame.Rect, *, centred: bool) -> None:
    """What is said about the item that has the focus."""
    anchor, x = ("midtop", box.centerx) if centred else ("topleft", box.left)
    size = layout.TIP
    lines = canvas.type.wrapped(tip, canvas.unit * size, box.width)
    if len(lines) > layout.TIP_LINES:
        size *= 0.85
        lines = canvas.type.wrapped(tip, canvas.unit * size, box.width)[: layout.TIP_LINES]
    for index, line in enumerate(lines):
        pixel = complex(x, box.top + canvas.unit * size * layout.LINE * index)
        canvas.write(line, size, canvas.theme.faint, pixel, anchor)


def _is_on_bar(laid: Laid, pixel: complex, unit: float) -> bool:
    """Whether a pixel is on the scroll bar, or a little beside it."""
    track = _scroll_track(laid, unit)
    return laid.over > 0 and index_at([track.inflate(track.width * 2, 0)], pixel) is not None


def _scroll_track(laid: Laid, unit: float) -> pygame.Rect:
    """The whole scroll bar."""
    bar = pygame.Rect(0, laid.body.top, max(round(layout.BAR * unit), 2), laid.body.height)
    bar.right = laid.bar
    return bar


def _draw_scroll_bar(canvas: Canvas, laid: Laid, scroll: float) -> None:
    """What part of the body is seen."""
    if not laid.over:
        return
    track, theme = _scroll_track(laid, canvas.unit), canvas.theme
    draw_box(canvas.surface, track, track.width / 2.0, theme.background)
    thumb = track.copy()
    thumb.height = max(round(track.height * laid.body.height / (laid.body.height + laid.over)), track.width)
    thumb.top = track.top + round((track.height - thumb.height) * scroll / laid.over)
    draw_box(canvas.surface, thumb, track.width / 2.0, theme.panel_edge)
