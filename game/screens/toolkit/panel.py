"""A screen of items over another screen, which stands still meanwhile; used by keys alone, by mouse alone, or by gamepad."""

import pygame

from game.drawing.camera import unit_of
from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.input.keys import Action
from game.input.repeat import Repeat
from game.input.signals import PAD_POSITIONS, Clicked, KeyboardState, Moved, Pressed, Released, Signal, Zoomed
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.still_picture import StillPicture
from game.screens.toolkit import layout
from game.screens.toolkit.focus import TABS, Focus, first_focus, moved_focus
from game.screens.toolkit.icons import draw_cross
from game.screens.toolkit.layout import Content, Laid, Spot, laid_out
from game.screens.toolkit.plate import dim, draw_focus, draw_panel, index_at, write_fitting
from game.screens.toolkit.slider import Slider

_WHEEL = 3.0
"""Units of text that a step of the wheel scrolls."""
_LARGE = 1.4
"""Text is called large beyond so many times its usual size."""
_UNDERLINE = 0.16
"""Width of the line below the tab that is shown, units of text."""


class Panel:
    """The screen that all panels derive from: they say what is on them (`content`) and where they lead back (`back`)."""

    def __init__(self, state: AppState, under: Screen | None) -> None:
        """Open over a screen; None for one that covers everything."""
        self._state, self._under = state, under
        self._focus: Focus | None = None
        self._scroll = 0.0  # pixels
        self._tab = 0
        self._changes = 0  # counts what happened: while it stays, so does the picture
        self._on_close = False  # whether the mouse is on the button that leads back
        self._pixel = 0j  # where the mouse was
        self._held: tuple[Pressed, Repeat] | None = None  # the direction that is held down
        self._behind = StillPicture()

    def content(self) -> Content:
        """What is on it now."""
        raise NotImplementedError

    def back(self) -> Screen | None:
        """The screen that it leads back to."""
        return self._under

    def first(self) -> Focus | None:
        """What has the focus when it opens; None for the first item that can be used."""
        return None

    @property
    def state(self) -> AppState:
        """What all screens share."""
        return self._state

    @property
    def looks(self) -> tuple[object, ...]:
        """All that its picture depends on."""
        return self._state.appearance, self._changes, self._focus, self._scroll, self._on_close

    def open_tab(self, index: int) -> None:
        """Show another part of it, from its beginning."""
        self._tab, self._scroll, self._focus = index, 0.0, Focus(TABS, index)
        self._changes += 1

    def area(self, size: tuple[int, int]) -> pygame.Rect:
        """What the plate may cover of a surface."""
        return pygame.Rect((0, 0), size)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Move the focus, use an item, or lead back."""
        self._held = _held_after(self._held, signal)
        match signal:
            case Pressed(Action.UP | Action.DOWN | Action.LEFT | Action.RIGHT as action):
                self._moved(action, size)
            case Pressed(Action.CONFIRM | Action.SERVE):
                self._changes += 1
                return self._accepted(size)
            case Pressed(Action.BACK):
                return self.back()
            case Pressed(Action.TIP) if tabs := self.content().tabs:
                self.open_tab((self._tab + 1) % len(tabs))
            case Pressed(action):
                return self._named(action, size)
            case Zoomed(steps):
                self._scroll_by(-steps * _WHEEL * self.unit(size), size)
            case Moved(pixel, held):
                return self._hovered(pixel, size, held=held)
            case Clicked(pixel):
                return self._clicked(pixel, size)
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """A direction that is held down acts again and again; nothing else moves."""
        if self._held is not None:
            pressed, repeat = self._held
            repeat, acts = repeat.later(seconds)
            self._held = pressed, repeat
            if acts:
                self._moved(pressed.action, size)
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed, and the panel."""
        self.draw_behind(surface)
        size = surface.get_size()
        canvas = self._state.canvas(surface)._replace(unit=self.unit(size))
        content, laid = self.content(), self._laid(size)
        focus = self._settled(laid)
        self.draw_plate(canvas, content, laid)
        _draw_tabs(canvas, content, laid, focus)
        for spot in laid.spots:
            surface.set_clip(laid.body if spot.in_body else None)
            if not spot.in_body or spot.box.colliderect(laid.body):
                spot.item.draw(canvas, spot.box, focused=Focus(spot.row, spot.column) == focus)
        surface.set_clip(None)
        _draw_scroll_bar(canvas, laid, self._scroll)
        focused = _spot_at(laid, focus)
        if focused is not None and focused.item.tip:
            _draw_tip(canvas, focused.item.tip, laid.tip)

    def draw_behind(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed: drawn once."""
        self._behind.show(surface, (self._state.appearance,), self._draw_behind)

    def draw_plate(self, canvas: Canvas, content: Content, laid: Laid) -> None:
        """The plate, its title and the button that leads back."""
        theme, unit, plate = canvas.theme, canvas.unit, laid.plate
        draw_panel(canvas.surface, plate, theme, unit)
        draw_focus(canvas, laid.close, focused=self._on_close)
        draw_cross(canvas, laid.close, theme.accent if self._on_close else theme.faint)
        anchor, x = ("midtop", float(plate.centerx)) if content.centred else ("topleft", plate.left + unit * layout.MARGIN)
        room = plate.width - unit * (2.0 * layout.MARGIN + layout.CLOSE * (2.0 if content.centred else 1.0))
        titled = canvas._replace(unit=self._title_unit(canvas.size))
        pixel = complex(x, plate.top + titled.unit * layout.TOP)
        write_fitting(titled, content.title, layout.TITLE, theme.text, pixel, anchor, room)

    @property
    def has_large_text(self) -> bool:
        """Whether the player wants texts so large that tables have room for few columns."""
        return self._state.text_scale > _LARGE

    def unit(self, size: tuple[int, int]) -> float:
        """Size of text, pixels."""
        return unit_of(size) * self._state.text_scale

    def _title_unit(self, size: tuple[int, int]) -> float:
        """Half way from the usual size of text to the player's, pixels: a title is large already."""
        return (unit_of(size) + self.unit(size)) / 2.0

    def draw_ground(self, surface: pygame.Surface) -> None:
        """What is below all panels: of panels over each other only the uppermost is seen."""
        if isinstance(self._under, Panel):
            self._under.draw_ground(surface)
        elif self._under is not None:
            self._under.draw(surface)
        else:
            surface.fill(self._state.theme.background)

    def _draw_behind(self, surface: pygame.Surface) -> None:
        """Draw what is below anew."""
        self.draw_ground(surface)
        dim(surface, self._state.theme)

    def _laid(self, size: tuple[int, int]) -> Laid:
        """Where everything is now."""
        units = self.unit(size), self._title_unit(size)
        laid = laid_out(self.content(), self.area(size), self._state.type, units, self._scroll)
        self._scroll = min(self._scroll, float(laid.over))
        return laid

    def _settled(self, laid: Laid) -> Focus | None:
        """What has the focus; where that is gone, the first item that can be used."""
        if self._focus is None:
            self._focus = self.first()
        if self._focus is None or (self._focus.row != TABS and _spot_at(laid, self._focus) is None):
            self._focus = first_focus(laid, self._focus)
        return self._focus

    def _moved(self, action: Action, size: tuple[int, int]) -> None:
        """Move the focus, or step the item that has it."""
        laid = self._laid(size)
        focus = self._settled(laid)
        steps = {Action.LEFT: -1, Action.RIGHT: 1}.get(action, 0)
        tabs = self.content().tabs
        self._changes += 1
        if not steps and self._read_on(laid, size, 1.0 if action is Action.DOWN else -1.0):
            return
        if focus is None:
            return
        if steps and focus.row == TABS:
            self.open_tab((self._tab + steps) % len(tabs))
        elif not steps or _shares_row(laid, focus) or (spot := _spot_at(laid, focus)) is None or not spot.item.stepped(steps):
            self._focus = moved_focus(laid, focus, action, self._tab if tabs else None)
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
        spot = _spot_at(laid, self._settled(laid))
        return self if spot is None else spot.item.accepted(self)

    def _named(self, action: Action, size: tuple[int, int]) -> Screen | None:
        """Use the item that a key stands for."""
        for spot in self._laid(size).spots:
            if spot.item.key is action and spot.item.focusable:
                self._changes += 1
                return spot.item.accepted(self)
        return self

    def _hovered(self, pixel: complex, size: tuple[int, int], *, held: bool) -> Screen | None:
        """Focus what the mouse is on; with the button held, drag it."""
        laid, before, self._pixel = self._laid(size), self._pixel, pixel
        self._on_close = index_at([laid.close], pixel) is not None
        if held and self._drags_bar(pixel, laid, size):
            return self
        spot = _pointed_spot(laid, pixel)
        if held and (spot is None or not isinstance(spot.item, Slider)):
            self._scroll_by(before.imag - pixel.imag, size)
        elif spot is not None and held and Focus(spot.row, spot.column) == self._focus:
            self._changes += 1
            return spot.item.pointed(self, pixel, spot.box, self.unit(size), clicked=False)
        elif spot is not None and not held:
            self._focus = Focus(spot.row, spot.column)
        return self

    def _clicked(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Use what the mouse is on."""
        laid = self._laid(size)
        if index_at([laid.close], pixel) is not None:
            return self.back()
        if (tab := index_at(list(laid.tabs), pixel)) is not None:
            self.open_tab(tab)
            return self
        if self._drags_bar(pixel, laid, size):
            return self
        spot = _pointed_spot(laid, pixel)
        if spot is None:
            return self
        self._focus = Focus(spot.row, spot.column)
        self._changes += 1
        return spot.item.pointed(self, pixel, spot.box, self.unit(size), clicked=True)

    def _drags_bar(self, pixel: complex, laid: Laid, size: tuple[int, int]) -> bool:
        """Scroll to where the mouse is on the scroll bar; whether it is there."""
        track = _scroll_track(laid, self.unit(size))
        if not laid.over or index_at([track.inflate(track.width * 2, 0)], pixel) is None:
            return False
        thumb = track.height * laid.body.height / (laid.body.height + laid.over)
        share = (pixel.imag - track.top - thumb / 2.0) / max(track.height - thumb, 1.0)
        self._scroll = min(max(share, 0.0), 1.0) * laid.over
        return True

    def _scroll_by(self, pixels: float, size: tuple[int, int]) -> None:
        """Scroll the body as far as it goes."""
        self._scroll = min(max(self._scroll + pixels, 0.0), float(self._laid(size).over))

    def _show_focus(self, size: tuple[int, int]) -> None:
        """Scroll so that the item that has the focus is seen whole; to the very top with the first."""
        laid = self._laid(size)
        spot = _spot_at(laid, self._focus)
        if spot is None or not spot.in_body:
            return
        above, below = laid.body.top - spot.box.top, spot.box.bottom - laid.body.bottom
        if above > 0:
            rows = [other.row for other in laid.spots if other.item.focusable]
            self._scroll_by(-1e6 if spot.row == min(rows) else -float(above), size)
        elif below > 0:
            self._scroll_by(float(below), size)


def _held_after(held: tuple[Pressed, Repeat] | None, signal: Signal) -> tuple[Pressed, Repeat] | None:
    """The direction that is held down after a signal: the last that was pressed, until it comes up or anything else happens."""
    match signal:
        case Pressed(Action.UP | Action.DOWN | Action.LEFT | Action.RIGHT):
            return signal, Repeat(signal.position)
        case KeyboardState(down):
            return held if held is not None and (held[0].position in down or held[0].position >= PAD_POSITIONS) else None
        case Released(_, position):
            return None if held is not None and held[0].position == position else held
        case Moved():
            return held
        case _:
            return None


def _spot_at(laid: Laid, focus: Focus | None) -> Spot | None:
    """The item that has the focus, if it can be used."""
    for spot in laid.spots:
        if focus is not None and (spot.row, spot.column) == focus and spot.item.focusable:
            return spot
    return None


def _shares_row(laid: Laid, focus: Focus) -> bool:
    """Whether there are other items to be used beside the one that has the focus: left and right lead to these then."""
    return len([spot for spot in laid.spots if spot.row == focus.row and spot.item.focusable]) > 1


def _pointed_spot(laid: Laid, pixel: complex) -> Spot | None:
    """The item that can be used at a pixel."""
    for spot in laid.spots:
        if spot.item.focusable and index_at([spot.box.clip(laid.body) if spot.in_body else spot.box], pixel) is not None:
            return spot
    return None


def _draw_tabs(canvas: Canvas, content: Content, laid: Laid, focus: Focus | None) -> None:
    """The tabs' heads, the one that is shown underlined."""
    theme, unit = canvas.theme, canvas.unit
    for index, (name, box) in enumerate(zip(content.tabs, laid.tabs, strict=True)):
        shown = index == content.tab
        draw_focus(canvas, box, focused=shown and focus is not None and focus.row == TABS)
        write_fitting(
            canvas, name, 1.15, theme.accent if shown else theme.faint, complex(*box.center), "center", box.width - unit * 0.5
        )
        if shown:
            line = pygame.Rect(box.left, box.bottom, box.width, max(round(unit * _UNDERLINE), 1))
            pygame.draw.rect(canvas.surface, theme.accent, line.inflate(-round(unit), 0))


def _draw_tip(canvas: Canvas, tip: str, box: pygame.Rect) -> None:
    """What is said about the item that has the focus."""
    size = layout.TIP
    lines = canvas.type.wrapped(tip, canvas.unit * size, box.width)
    if len(lines) > layout.TIP_LINES:
        size *= 0.85
        lines = canvas.type.wrapped(tip, canvas.unit * size, box.width)[: layout.TIP_LINES]
    for index, line in enumerate(lines):
        pixel = complex(box.left, box.top + canvas.unit * size * layout.LINE * index)
        canvas.write(line, size, canvas.theme.faint, pixel)


def _scroll_track(laid: Laid, unit: float) -> pygame.Rect:
    """The whole scroll bar."""
    bar = pygame.Rect(0, laid.body.top, max(round(layout.BAR * unit), 2), laid.body.height)
    bar.right = laid.plate.right - round(unit * layout.MARGIN)
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
