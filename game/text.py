"""Text in pygame's own font, at any size, remembered so that a frame costs blits only."""

from collections import OrderedDict

import pygame

from game.palette import Colour

_SMALLEST = 6
_LARGEST = 400
_REMEMBERED = 256
_FONTS = 32
_FINER = 3
"""Letters are drawn this much larger and scaled down: they stand where they belong, not on whole pixels."""


class Type:
    """Renders lines of text; keeps the most recent ones."""

    def __init__(self) -> None:
        """Start with nothing rendered."""
        pygame.font.init()
        self._fonts: dict[int, pygame.font.Font] = {}
        self._lines: OrderedDict[tuple[str, int, Colour], pygame.Surface] = OrderedDict()

    def rendered(self, text: str, size: float, colour: Colour) -> pygame.Surface:
        """A line of text on a transparent surface. size: pixels."""
        pixels = min(max(round(size), _SMALLEST), _LARGEST)
        key = (text, pixels, colour)
        if key in self._lines:
            self._lines.move_to_end(key)
            return self._lines[key]
        if pixels not in self._fonts:
            if len(self._fonts) >= _FONTS:
                self._fonts.clear()
            self._fonts[pixels] = pygame.font.Font(None, pixels * _FINER)
        large = self._fonts[pixels].render(text, True, colour)
        line = pygame.transform.smoothscale(large, (-(-large.get_width() // _FINER), -(-large.get_height() // _FINER)))
        self._lines[key] = line
        if len(self._lines) > _REMEMBERED:
            self._lines.popitem(last=False)
        return line

    def write(
        self, surface: pygame.Surface, text: str, size: float, colour: Colour, place: complex, anchor: str = "topleft"
    ) -> pygame.Rect:
        """Draw a line of text and return where. place: pixels, of the rectangle's point named by anchor, as in pygame.Rect."""
        line = self.rendered(text, size, colour)
        box = line.get_rect(**{anchor: (round(place.real), round(place.imag))})
        surface.blit(line, box)
        return box

    def wrapped(self, text: str, size: float, width: float) -> list[str]:
        """The text in lines no wider than `width` pixels, as far as words allow."""
        lines: list[str] = []
        for word in text.split():
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and self.rendered(longer, size, (0, 0, 0)).get_width() <= width:
                lines[-1] = longer
            else:
                lines.append(word)
        return lines
