"""Letters that set formulas: v_res with its index below, what is divided above what divides it."""

import pygame

from game.drawing.palette import Colour
from game.drawing.text import Type
from game.lab.typeset.mathtext import can_typeset, set_line
from game.lab.typeset.tex import has_symbols

EM = 0.6875
"""The em square of pygame's own font, in the size that it is asked for."""
_MOST_SET = 256
"""Lines cached, at most."""
_GAP = "   "
"""Between formulas on a line."""


class FormulaType(Type):
    """Sets what has a variable in it by mathtext, where that is installed; everything else in pygame's own font."""

    def __init__(self, *, words: bool = False) -> None:
        """words: whether lines without any variable are set as well, as those of a scene's formula are."""
        super().__init__()
        self._words = words
        self._set: dict[tuple[str, int, Colour], pygame.Surface] = {}

    def rendered(self, text: str, size: float, colour: Colour, spacing: float = 0.0) -> pygame.Surface:
        """A line of text or a formula on a transparent surface."""
        pixels = round(size * EM)
        if spacing or pixels < 1 or not self.sets(text):
            return super().rendered(text, size, colour, spacing)
        key = (text, pixels, colour)
        if key not in self._set:
            if len(self._set) >= _MOST_SET:
                self._set.clear()
            self._set[key] = self._typeset(text, size, colour)
        return self._set[key]

    def sets(self, text: str) -> bool:
        """Whether a text is set as a formula."""
        return can_typeset() and (self._words or has_symbols(text))

    def wrapped(self, text: str, size: float, width: float) -> list[str]:
        """The text in lines no wider than `width` pixels: broken between formulas, and only then between words."""
        lines: list[str] = []
        for part in text.split(_GAP) if text else ():
            longer = f"{lines[-1]}{_GAP}{part.strip()}" if lines else part.strip()
            if lines and self._width(longer, size) <= width:
                lines[-1] = longer
            else:
                lines += [part.strip()] if self._width(part, size) <= width else super().wrapped(part, size, width)
        return lines

    def _width(self, text: str, size: float) -> int:
        """Width of a line, pixels."""
        return self.rendered(text, size, (0, 0, 0)).get_width()

    def _typeset(self, text: str, size: float, colour: Colour) -> pygame.Surface:
        """A formula, or the plain text where mathtext cannot set it."""
        try:
            line = set_line(text, float(round(size * EM)))
        except ValueError:
            return super().rendered(text, size, colour)
        surface = pygame.Surface((line.shades.shape[1], line.shades.shape[0]), pygame.SRCALPHA)
        surface.fill((*colour, 0))
        alpha = pygame.surfarray.pixels_alpha(surface)
        alpha[:] = line.shades.T
        del alpha  # it locks the surface
        return surface
