"""Where everything of the editor is on a surface. All in pixels; text sizes in units."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Camera, layout, unit_of
from game.editor.session import EditorSession, Row, rows
from game.editor.symmetry import FOLDS
from game.language import tr_noop

BRUSHES = (1, 2, 3, 4, 5, 6, 7, 8, 9, 0, -1)
"""As the chips show them."""
# Lengths are in units of text.
ROW_TEXT, CHIP_TEXT, BUTTON_TEXT, HEADING, TITLE, MESSAGE = 0.95, 0.9, 0.95, 0.9, 1.3, 1.0
"""Sizes of letters."""
_PANEL, _MARGIN, _GAP = 18.5, 0.8, 0.25
"""Width of the panel, around everything, and between neighbours."""
_TITLE_HEIGHT, _HEADING_HEIGHT, _ROW_HEIGHT, _CHIP_HEIGHT, _BUTTON_HEIGHT = 2.0, 1.3, 1.22, 1.25, 1.4
_PANEL_HEIGHT = 43.2
"""Of everything in the panel together, with the margins."""
_FOOT = 3.2
"""Height of the lines below the arena."""
_BUTTON_ROWS = 6


class Button(NamedTuple):
    """Something to press.

    name: of the command.
    label: what it says. key: what does the same on the keyboard.
    """

    name: str
    label: str
    key: str


BUTTONS = (
    Button("add", tr_noop("Copy ring"), "Ins"),
    Button("remove", tr_noop("Remove ring"), "Del"),
    Button("fill", tr_noop("Fill ring"), "F"),
    Button("mirror", tr_noop("Mirror"), "M"),
    Button("copy", tr_noop("Copy bricks"), "Ctrl+C"),
    Button("paste", tr_noop("Paste bricks"), "Ctrl+V"),
    Button("undo", tr_noop("Undo"), "Ctrl+Z"),
    Button("redo", tr_noop("Redo"), "Ctrl+Y"),
    Button("test", tr_noop("Play-test"), "F5"),
    Button("save", tr_noop("Save"), "Ctrl+S"),
    Button("help", tr_noop("Help"), "F1"),
    Button("leave", tr_noop("Leave"), "Esc"),
)


class EditorLayout(NamedTuple):
    """Boxes of a surface.

    arena: the arena's part. camera: that shows it there.
    panel: everything beside it. title, ring_heading, arena_heading, brush_heading, fold_heading: of its headings.
    rows: of the numbers, with their rows. chips: of the brushes. folds: of the rotations. buttons: of the commands.
    foot: of the lines below the arena.
    unit: size of the editor's text; smaller than elsewhere in the game where the panel would not fit otherwise.
    """

    arena: pygame.Rect
    camera: Camera
    panel: pygame.Rect
    title: pygame.Rect
    ring_heading: pygame.Rect
    arena_heading: pygame.Rect
    brush_heading: pygame.Rect
    fold_heading: pygame.Rect
    rows: tuple[tuple[Row, pygame.Rect], ...]
    chips: tuple[tuple[int, pygame.Rect], ...]
    folds: tuple[tuple[int, pygame.Rect], ...]
    buttons: tuple[tuple[Button, pygame.Rect], ...]
    foot: pygame.Rect
    unit: float


def editor_layout(size: tuple[int, int], session: EditorSession) -> EditorLayout:
    """The layout of a surface of some size."""
    unit = min(unit_of(size), size[1] / _PANEL_HEIGHT)
    margin, gap = round(unit * _MARGIN), round(unit * _GAP)
    width = min(round(unit * _PANEL), size[0] // 2)
    panel = pygame.Rect(size[0] - width - margin, margin, width, size[1] - 2 * margin)
    foot = pygame.Rect(margin, size[1] - margin - round(unit * _FOOT), panel.left - 2 * margin, round(unit * _FOOT))
    arena = pygame.Rect(margin, margin, foot.width, foot.top - margin - gap)
    fitted = layout((max(arena.width, 1), max(arena.height, 1)), session.document.level.ground_radius).camera
    scale = min(arena.width, arena.height) / 2.0 / session.document.level.ground_radius * 0.97
    camera = fitted._replace(centre=complex(*arena.center), scale=max(scale, 1e-3))
    column = _Column(panel, gap)
    title = column.box(unit * _TITLE_HEIGHT)
    ring_heading = column.box(unit * _HEADING_HEIGHT)
    all_rows = rows(session)
    own = [row for row in all_rows if row.path[0] == "rings"]
    own_boxes = [column.box(unit * _ROW_HEIGHT, 0) for _ in own]
    arena_heading = column.box(unit * _HEADING_HEIGHT)
    others = all_rows[len(own) :]
    other_boxes = [column.box(unit * _ROW_HEIGHT, 0) for _ in others]
    brush_heading = column.box(unit * _HEADING_HEIGHT)
    chips = column.across(len(BRUSHES), unit * _CHIP_HEIGHT)
    fold_heading = column.box(unit * _HEADING_HEIGHT)
    folds = column.across(len(FOLDS), unit * _CHIP_HEIGHT)
    column.skip(gap)
    pairs = [column.across(2, unit * _BUTTON_HEIGHT) for _ in range(_BUTTON_ROWS)]
    return EditorLayout(
        arena,
        camera,
        panel,
        title,
        ring_heading,
        arena_heading,
        brush_heading,
        fold_heading,
        tuple(zip(all_rows, [*own_boxes, *other_boxes], strict=True)),
        tuple(zip(BRUSHES, chips, strict=True)),
        tuple(zip(FOLDS, folds, strict=True)),
        tuple(zip(BUTTONS, [box for pair in pairs for box in pair], strict=True)),
        foot,
        unit,
    )


class _Column:
    """Boxes one below the other."""

    def __init__(self, panel: pygame.Rect, gap: int) -> None:
        """Begin at the panel's top."""
        self._panel, self._gap, self._y = panel, gap, panel.top

    def box(self, height: float, gap: int | None = None) -> pygame.Rect:
        """The next box over the whole width."""
        box = pygame.Rect(self._panel.left, self._y, self._panel.width, round(height))
        self._y = box.bottom + (self._gap if gap is None else gap)
        return box

    def across(self, count: int, height: float) -> list[pygame.Rect]:
        """The next boxes beside each other."""
        row = self.box(height)
        pitch = (row.width + self._gap) / count
        return [
            pygame.Rect(round(row.left + index * pitch), row.top, round(pitch - self._gap), row.height)
            for index in range(count)
        ]

    def skip(self, height: int) -> None:
        """Leave room."""
        self._y += height
