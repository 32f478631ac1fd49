"""The figures in the four corners, and the words that say what to do now."""

from textwrap import wrap

from game.drawing.camera import Layout
from game.drawing.palette import Colour, Theme
from game.language import grouped, ntr, tr
from game.overlay.notice_words import Notice
from game.overlay.readings import Readings
from game.picture.display_list import DisplayList
from game.rules import LIVES

# Lengths are in units of text.
_EDGE, _CAPTION, _FIGURE, _LEVEL_NAME = 0.8, 0.9, 2.0, 1.3
"""From the figures to the surface's edges, and sizes of letters."""
_LIFE, _LIFE_PITCH, _LIFE_LINE = 0.42, 1.134, 0.08
"""Radius of a ball that stands for a life, from one to the next, and the line of one that is lost."""
_TITLE, _HINT, _LETTER = 1.5, 1.0, 0.56
"""Sizes of a notice's letters, and the width of a letter in shares of its size, roughly."""
_ABOUT, _ABOUT_LINE, _ABOUT_WIDE = 0.95, 1.3, 0.5
"""Of what the level is about: size of letters, from line to line, and share of the width in which it is broken into lines."""
_NARROW_TOP = 0.115
"""From the upper edge to a notice where the figures are above the arena, in shares of the height."""


def add_figures(out: DisplayList, shown: Readings, layout: Layout, theme: Theme, unit: float) -> None:
    """Add score, combo, lives, level and the layers that are left."""
    (width, height), edge = layout.size, unit * _EDGE
    _add_left(out, shown, complex(edge, edge), theme, unit)
    right = width - edge
    out.text(tr("LIVES"), unit * _CAPTION, complex(right, edge + 0.5 * unit), theme.faint, 1.0)
    for index in range(max(LIVES, shown.lives)):
        pixel = complex(right - (_LIFE + index * _LIFE_PITCH) * unit, edge + 1.75 * unit)
        if index < shown.lives:
            out.disc(pixel, _LIFE * unit, theme.ball)
        else:
            out.circle(pixel, _LIFE * unit, max(_LIFE_LINE * unit, 1.0), theme.faint)
    bottom = height - edge
    out.text(shown.level_name, unit * _LEVEL_NAME, complex(edge, bottom - 0.65 * unit), theme.text, 0.0, bold=1.0)
    number = tr("LEVEL {number} of {count}").format(number=shown.level_number, count=shown.level_count)
    out.text(number, unit * _CAPTION, complex(edge, bottom - 1.95 * unit), theme.faint, 0.0)
    lines: list[tuple[str, Colour]] = [
        (ntr("{count} layer left", "{count} layers left", shown.layers).format(count=shown.layers), theme.text),
        (shown.badge, theme.accent),
    ]
    for index, (words, colour) in enumerate([line for line in lines if line[0]]):
        out.text(words, unit * _CAPTION, complex(right, bottom - (0.5 + 1.3 * index) * unit), colour, 1.0)


def _add_left(out: DisplayList, shown: Readings, corner: complex, theme: Theme, unit: float) -> None:
    """Add the score, and the bricks in a row."""
    out.text(tr("SCORE"), unit * _CAPTION, corner + 0.5j * unit, theme.faint, 0.0)
    out.text(grouped(shown.score), unit * _FIGURE, corner + 2.1j * unit, theme.text, 0.0, bold=1.0)
    if shown.combo > 1:
        words = tr("combo ×{count}").format(count=shown.combo)
        out.text(words, unit * (1.1 + 0.06 * min(shown.combo, 8)), corner + 4.1j * unit, theme.accent, 0.0, bold=1.0)


def add_notice(out: DisplayList, notice: Notice, layout: Layout, theme: Theme, unit: float) -> None:
    """Add a few words on a plate at the upper edge of the arena."""
    width, height = layout.size
    top = unit * 0.6 if layout.beside else _NARROW_TOP * height
    most = max(int(_ABOUT_WIDE * width / (unit * _ABOUT * _LETTER)), 1)
    about = [line for words in notice.about.splitlines() for line in wrap(words, most)]
    letters = max(len(notice.title) * _TITLE, len(notice.hint) * _HINT, *[len(line) * _ABOUT for line in about], 0.0)
    half = min((letters * _LETTER / 2.0 + 0.8) * unit, width / 2.0)
    below = len(about) * _ABOUT_LINE
    deep = ((3.6 if notice.hint else 2.4) + below) * unit
    middle = width / 2.0
    plate = (
        complex(middle - half, top),
        complex(middle + half, top),
        complex(middle + half, top + deep),
        complex(middle - half, top + deep),
    )
    out.polygon(plate, theme.panel, 0.92)
    out.line([*plate, plate[0]], max(0.06 * unit, 1.0), theme.panel_edge)
    out.text(notice.title, unit * _TITLE, complex(middle, top + 1.25 * unit), theme.text, bold=1.0)
    for index, line in enumerate(about):
        out.text(line, unit * _ABOUT, complex(middle, top + (2.6 + _ABOUT_LINE * index) * unit), theme.text)
    if notice.hint:
        out.text(notice.hint, unit * _HINT, complex(middle, top + (2.75 + below) * unit), theme.faint)
