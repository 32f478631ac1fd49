"""Which words stand beside a mark, and where they would stand if there were nothing else."""

import cmath
from typing import NamedTuple

from game.drawing.palette import Colour
from game.lab.drawing.colours import text_colour
from game.lab.drawing.seen import SeenPane
from game.lab.kit.picture import Arc, Arrow, Line, Mark, PointMark, Role, Words

SHORTEST = 1.0
"""Pixels: a shorter arrow is left out, and so is its label."""


class WantedLabel(NamedTuple):
    """Words beside a mark. anchor: the point of their box that is at the pixel, as in pygame.Rect."""

    pixel: complex
    text: str
    colour: Colour
    anchor: str = "center"


def wanted_label(canvas: SeenPane, mark: Mark) -> WantedLabel | None:
    """The words of a mark, beside it; None for a mark without words."""
    project, unit, size = canvas.camera.project, canvas.unit, canvas.size

    def words(pixel: complex, text: str, role: Role, anchor: str = "center") -> WantedLabel:
        """A label in the colour of a role."""
        return WantedLabel(pixel, text, text_colour(canvas.theme, role), anchor)

    match mark:
        case PointMark(position, label=text) if text:
            return words(project(position) + complex(0.35, -0.3) * unit, text, mark.role, "bottomleft")
        case Arrow(start, vector, label=text) if text and abs(vector) * canvas.camera.scale >= SHORTEST:
            on_screen = vector.conjugate() / abs(vector)
            return words(project(start + vector) + on_screen * unit * 0.5, text, mark.role, _anchor(on_screen))
        case Line(points, label=text) if text:
            return words((project(points[0]) + project(points[-1])) / 2.0 - 0.9j * size, text, mark.role)
        case Arc(centre, radius, start, sweep, label=text) if text and abs(sweep) * radius * canvas.camera.scale > unit:
            middle = start + sweep / 2.0
            pixel = project(centre + cmath.rect(radius, middle)) + cmath.rect(1.26 * size, -middle)
            return words(pixel, text, mark.role)
        case Words(position, text) if text:
            return words(project(position), text, mark.role)
    return None


def _anchor(direction: complex) -> str:
    """The side of words at the tip of an arrow that faces it. direction: of the arrow on the screen, y downwards."""
    if abs(direction.real) > abs(direction.imag):
        return "midleft" if direction.real > 0.0 else "midright"
    return "midtop" if direction.imag > 0.0 else "midbottom"
