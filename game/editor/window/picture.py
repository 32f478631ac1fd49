"""What the editor draws beside its controls: the arena, marks at the cursor and the mouse, and the lines below."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.editor.fields import PanelPart
from game.editor.session import EditorSession
from game.editor.window.arena import draw_arena, draw_outlines, draw_ring, draw_wells
from game.editor.window.foot import cursor_words, draw_foot
from game.editor.window.help import Hand, hint
from game.editor.window.layout import EditorLayout
from game.editor.window.pointing import slot_at, well_near
from game.levels import Level
from game.screens.app_state import AppState
from game.screens.cached_picture import CachedPicture

_RING, _CHOSEN_RING = 0.12, 0.3
"""Widths of a ring's edges, and of the chosen one's where rings are edited, in units of text."""


class Shown(NamedTuple):
    """What the editor shows.

    part: of the controls. hand: device that the player used last. point: under the mouse, world units; None outside of the
    arena. in_panel: whether keys and gamepad act on the controls. tip: about the focused control. file: its name.
    """

    session: EditorSession
    layout: EditorLayout
    part: PanelPart
    hand: Hand
    point: complex | None
    in_panel: bool
    tip: str
    file: str

    @property
    def slot(self) -> tuple[int, int] | None:
        """Ring and slot under the cursor or the mouse; None for none."""
        if self.hand is not Hand.MOUSE:
            return self.session.ring, self.session.slot
        return None if self.point is None else slot_at(self.session.document.level, self.point)


class EditorPicture:
    """Draws what is `Shown`; the level itself is drawn only when it has changed."""

    def __init__(self) -> None:
        """Start without a cached picture."""
        self._painter, self._cached = Painter(), CachedPicture()
        self._drawn: Level | None = None  # the last level that could be drawn

    def draw(self, surface: pygame.Surface, state: AppState, shown: Shown) -> None:
        """Draw arena, marks and lines."""
        level, seen = shown.session.document.level, shown.layout
        canvas = state.canvas(surface, seen.camera)._replace(unit=seen.unit)
        self._cached.show(
            surface, (state.appearance, seen, level), lambda below: self._draw_level(canvas._replace(surface=below), level)
        )
        surface.set_clip(pygame.Rect(0, 0, seen.side.left, canvas.size[1]))
        _draw_marks(canvas, shown)
        _draw_lines(canvas, shown)
        surface.set_clip(None)

    def _draw_level(self, canvas: Canvas, level: Level) -> None:
        """Draw the level; if that is impossible, the last one that could be drawn."""
        canvas.surface.fill(canvas.theme.background)
        try:
            draw_arena(canvas, self._painter, level)
            self._drawn = level
        except ValueError:  # sizes that the physics refuses; the lines below name the problem
            if self._drawn is not None:
                draw_arena(canvas, self._painter, self._drawn)


def _draw_marks(canvas: Canvas, shown: Shown) -> None:
    """Mark what is under the cursor or the mouse, and what is chosen."""
    by_mouse, rings = shown.hand is Hand.MOUSE, shown.session.document.level.rings
    colour = canvas.theme.accent if by_mouse or not shown.in_panel else canvas.theme.faint
    if shown.part is PanelPart.WELLS:
        pointed = well_near(shown.session.document.level, shown.point) if by_mouse and shown.point is not None else None
        draw_wells(canvas, shown.session, pointed, colour)
        return
    chosen, of_rings = rings[shown.session.ring], shown.part is PanelPart.RING
    draw_ring(canvas, chosen, *(colour, _CHOSEN_RING) if of_rings else (canvas.theme.faint, _RING))
    if shown.slot is not None and of_rings and by_mouse:
        draw_ring(canvas, rings[shown.slot[0]], canvas.theme.text, _RING)
    elif shown.slot is not None:
        draw_outlines(canvas, shown.session, shown.slot, colour)


def _draw_lines(canvas: Canvas, shown: Shown) -> None:
    """Draw the lines below the arena."""
    theme, session = canvas.theme, shown.session
    problem = session.document.problem
    wrong = session.message or session.file_error or ("" if problem is None else problem.translated)
    status = "  ·  ".join([words for words in (shown.file, cursor_words(session, shown.part, shown.slot)) if words])
    tip = shown.tip or hint(shown.hand, shown.part, in_panel=shown.in_panel)
    draw_foot(canvas, shown.layout.foot, [(status, theme.faint), (wrong, theme.danger), (tip, theme.text)])
