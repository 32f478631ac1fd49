"""The words that say what to do now, on a plate where they hide neither bricks nor the ball; for pygame and for a browser."""

from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera, Layout
from game.drawing.letter_sizes import LINE, width
from game.drawing.palette import Theme
from game.overlay.notice_words import Notice
from game.picture.display_list import DisplayList
from game.picture.slots.parts import LAYER_HEIGHT
from game.rules import PADDLES
from game.scene import Scene

# Lengths are in units of text.
_TITLE, _ABOUT, _HINT = 1.5, 0.95, 1.0
"""Sizes of letters."""
_GAP, _LINE_GAP = 0.25, 0.1
"""Space between title, description of the level, and hint; and between the lines of the description."""
_MARGIN = complex(0.8, 0.5)
"""From the words to the plate's edges, across and down."""
_WIDEST, _HIGHEST = (0.52, 0.9), 0.22
"""Share of the surface's width for the words, on a wide one and on a narrow one, and of its height for the plate: letters are
smaller where they need more, for the figures are beside them, or above them on a narrow surface."""
_LEAST_HIGH, _ABOVE_WALL = 0.08, 0.4
"""Share of the surface's height that the plate has at least, and from the plate to the wall."""
_BALANCED, _TRIES = 0.96, 16
"""The width is reduced by this factor, at most so often, as long as the number of lines stays: all are then about equal."""
_ABOUT_WIDE = 0.44, 0.8
"""Share of the surface's width to which the level's description is wrapped; the second one on a narrow surface."""
_SHRINK, _LEAST = 0.94, 4.0
"""Factor by which smaller letters are tried, and the least size, pixels."""
_CORNER, _EDGE_LINE = 0.6, 0.06
"""Radius of the plate's corners, and width of its edge."""
_TOP, _NARROW_TOP = 0.6, 0.115
"""From the surface's upper edge to the plate: where the figures stand beside the arena; and where they are above it, in
shares of the height."""
_ROOM = 2.0
"""Least distance from the plate to a ball."""


class _Line(NamedTuple):
    """A line of words. size: of its letters; middle: offset of its middle below the first line's top; in units of text."""

    words: str
    size: float
    middle: float
    faint: bool = False


class Around(NamedTuple):
    """What the plate must not cover, pixels.

    wall: y of the wall's upper end. balls: their positions.
    """

    wall: float
    balls: tuple[complex, ...] = ()


def around(scene: Scene, camera: Camera) -> Around:
    """What the plate must not cover of a scene."""
    others = (PADDLES, scene.shield, scene.second_paddle)
    walls = [ring.outer_radius for k, ring in enumerate(scene.rings) if k not in others]
    away = 1j * max(walls, default=0.0) / camera.turning
    height = 0.0 if camera.flat else max(scene.tallest) * LAYER_HEIGHT * scene.ground_radius
    balls = tuple([camera.project(ball.position, ball.radius) for ball in scene.balls])
    return Around(camera.project(away, height).imag, balls)


def add_notice(out: DisplayList, notice: Notice, layout: Layout, theme: Theme, unit: float, free: Around) -> None:
    """Add the words at the upper edge of the arena, at the lower one while a ball is at the upper: never over bricks."""
    surface = layout.size
    edge = unit * _TOP if layout.beside else _NARROW_TOP * surface[1]
    room = free.wall - edge - _ABOVE_WALL * unit
    highest = max(min(_HIGHEST * surface[1], room), _LEAST_HIGH * surface[1])
    unit, lines, size = _fitting(notice, surface, unit, round(highest), narrow=not layout.beside)
    plate = size + 2.0 * _MARGIN * unit
    corner, room = complex((surface[0] - plate.real) / 2.0, edge), _ROOM * unit
    if any(
        [
            abs(ball.real - surface[0] / 2.0) < plate.real / 2.0 + room and ball.imag < edge + plate.imag + room
            for ball in free.balls
        ]
    ):
        corner = complex(corner.real, surface[1] - edge - plate.imag)
    out.box(corner, plate, unit * _CORNER, theme.panel, (max(unit * _EDGE_LINE, 1.0), theme.panel_edge))
    for line in lines:
        pixel = complex(surface[0] / 2.0, corner.imag + unit * (_MARGIN.imag + line.middle))
        out.text(line.words, unit * line.size, pixel, theme.faint if line.faint else theme.text, room=size.real)


@lru_cache(maxsize=8)
def _fitting(
    notice: Notice, surface: tuple[int, int], unit: float, highest: int, *, narrow: bool
) -> tuple[float, tuple[_Line, ...], complex]:
    """A unit of text in which the words fit, their lines, and width and height of all together, pixels.

    highest: greatest height of the plate, pixels.
    """
    while True:
        lines, size = _lines(notice, _ABOUT_WIDE[narrow] * surface[0] / unit)
        fits = unit * size.real <= _WIDEST[narrow] * surface[0] and unit * (size.imag + 2.0 * _MARGIN.imag) <= highest
        if fits or unit <= _LEAST:
            return unit, lines, size * unit
        unit *= _SHRINK


def _lines(notice: Notice, wide: float) -> tuple[tuple[_Line, ...], complex]:
    """The lines, with width and height of all together. wide: greatest width of the level's description; in units of text."""
    texts = [(notice.title, _TITLE, 0.0)]
    for paragraph in notice.about.splitlines():
        for index, words in enumerate(_balanced(paragraph, wide / _ABOUT)):
            texts.append((words, _ABOUT, _LINE_GAP if index else _GAP))
    if notice.hint:
        texts.append((notice.hint, _HINT, _GAP))
    lines, height = list[_Line](), 0.0
    for words, size, gap in texts:
        height += gap + size * LINE
        lines.append(_Line(words, size, height - size * LINE / 2.0, faint=words == notice.hint))
    return tuple(lines), complex(max([width(words) * size for words, size, _ in texts]), height)


def _balanced(paragraph: str, wide: float) -> list[str]:
    """The words in as few lines as possible, all of about the same length."""
    lines = _wrapped(paragraph, wide)
    for _ in range(_TRIES if len(lines) > 1 else 0):
        wide *= _BALANCED
        narrower = _wrapped(paragraph, wide)
        if len(narrower) > len(lines):
            break
        lines = narrower
    return lines


def _wrapped(paragraph: str, wide: float) -> list[str]:
    """The words wrapped to a width, in units of their letters' size; a single longer word has a line of its own."""
    lines = list[str]()
    for word in paragraph.split():
        if lines and width(f"{lines[-1]} {word}") <= wide:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines
