"""A panel: a form over another screen, which is paused meanwhile."""

import pygame

from game.drawing.camera import unit_of
from game.drawing.canvas import Canvas
from game.input.keys import Action
from game.input.signals import Pressed, Signal
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.cached_picture import CachedPicture
from game.screens.toolkit.focus import TABS, Focus
from game.screens.toolkit.form import Form
from game.screens.toolkit.icons import draw_cross
from game.screens.toolkit.layout import CLOSE, MARGIN, TITLE, TOP, Content, FormLayout, panel_layout
from game.screens.toolkit.plate import dim, draw_focus, draw_panel, index_at, write_fitting

_LARGE = 1.4
"""Text is called large beyond so many times its usual size."""
_UNDERLINE = 0.16
"""Width of the line below the tab that is shown, units of text."""


class Panel(Form):
    """The screen that all panels derive from: they say what is on them (`content`) and where they lead back (`back`)."""

    def __init__(self, state: AppState, under: Screen | None) -> None:
        """Open over a screen; None for one that covers everything."""
        super().__init__()
        self._state, self._under = state, under
        self._tab = 0
        self._on_close = False  # whether the mouse is on the button that leads back
        self._behind = CachedPicture()

    def content(self) -> Content:
        """The panel's content now."""
        raise NotImplementedError

    def back(self) -> Screen | None:
        """The screen that it leads back to."""
        return self._under

    @property
    def screen(self) -> Screen:
        """The panel itself."""
        return self

    @property
    def tab(self) -> int | None:
        """Index of the tab that is shown; None where there are no tabs."""
        return self._tab if self.content().tabs else None

    @property
    def state(self) -> AppState:
        """What all screens share."""
        return self._state

    @property
    def appearance(self) -> tuple[object, ...]:
        """All that its picture depends on."""
        return self._state.appearance, self._changes, self._focus, self._scroll, self._on_close

    def open_tab(self, index: int) -> None:
        """Show another part of it, from its beginning."""
        self._tab, self._scroll, self._focus = index, 0.0, Focus(TABS, index)
        self._changes += 1

    def area(self, size: tuple[int, int]) -> pygame.Rect:
        """The area of a surface that the plate may cover."""
        return pygame.Rect((0, 0), size)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Move the focus, use an item, or lead back."""
        match signal:
            case Pressed(Action.BACK):
                self._held = None
                return self.back()
            case Pressed(Action.TIP) if tabs := self.content().tabs:
                self._held = None
                self.open_tab((self._tab + 1) % len(tabs))
                return self
        return super().answer(signal, size)

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed, and the panel."""
        self.draw_behind(surface)
        size = surface.get_size()
        canvas = self._state.canvas(surface)._replace(unit=self.unit(size))
        content, layout = self.content(), self._form_layout(size)
        focus = self._settled(layout)
        self.draw_plate(canvas, content, layout)
        _draw_tabs(canvas, content, layout, focus)
        self.draw_items(canvas, layout, focus, centred=content.centred)

    def draw_behind(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed: drawn once."""
        self._behind.show(surface, (self._state.appearance,), self._draw_behind)

    def draw_plate(self, canvas: Canvas, content: Content, layout: FormLayout) -> None:
        """The plate, its title and the button that leads back."""
        theme, unit, plate = canvas.theme, canvas.unit, layout.plate
        draw_panel(canvas.surface, plate, theme, unit)
        draw_focus(canvas, layout.close, focused=self._on_close)
        draw_cross(canvas, layout.close, theme.accent if self._on_close else theme.faint)
        anchor, x = ("midtop", float(plate.centerx)) if content.centred else ("topleft", plate.left + unit * MARGIN)
        room = plate.width - unit * (2.0 * MARGIN + CLOSE * (2.0 if content.centred else 1.0))
        titled = canvas._replace(unit=self._title_unit(canvas.size))
        pixel = complex(x, plate.top + titled.unit * TOP)
        write_fitting(titled, content.title, TITLE, theme.text, pixel, anchor, room)

    @property
    def has_large_text(self) -> bool:
        """Whether the text is so large that tables have room for few columns only."""
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

    def _form_layout(self, size: tuple[int, int]) -> FormLayout:
        """The layout now."""
        units = self.unit(size), self._title_unit(size)
        layout = panel_layout(self.content(), self.area(size), self._state.type, units, self._scroll)
        self._scroll = min(self._scroll, float(layout.over))
        return layout

    def _moved(self, action: Action, size: tuple[int, int]) -> None:
        """Left and right on the tabs' heads show another part."""
        steps = {Action.LEFT: -1, Action.RIGHT: 1}.get(action, 0)
        focus = self._settled(self._form_layout(size))
        if steps and focus is not None and focus.row == TABS:
            self.open_tab((self._tab + steps) % len(self.content().tabs))
        else:
            super()._moved(action, size)

    def _hovered(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """The button that leads back shows that the mouse is on it."""
        self._on_close = index_at([self._form_layout(size).close], pixel) is not None
        return super()._hovered(pixel, size)

    def _clicked(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Lead back, show another part, or use what the mouse is on."""
        layout = self._form_layout(size)
        if index_at([layout.close], pixel) is not None:
            return self.back()
        if (tab := index_at(list(layout.tabs), pixel)) is not None:
            self.open_tab(tab)
            return self
        return super()._clicked(pixel, size)


def _draw_tabs(canvas: Canvas, content: Content, layout: FormLayout, focus: Focus | None) -> None:
    """The tabs' heads, the one that is shown underlined."""
    theme, unit = canvas.theme, canvas.unit
    for index, (name, box) in enumerate(zip(content.tabs, layout.tabs, strict=True)):
        shown = index == content.tab
        draw_focus(canvas, box, focused=shown and focus is not None and focus.row == TABS)
        write_fitting(
            canvas, name, 1.15, theme.accent if shown else theme.faint, complex(*box.center), "center", box.width - unit * 0.5
        )
        if shown:
            line = pygame.Rect(box.left, box.bottom, box.width, max(round(unit * _UNDERLINE), 1))
            pygame.draw.rect(canvas.surface, theme.accent, line.inflate(-round(unit), 0))
