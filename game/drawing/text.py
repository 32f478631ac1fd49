"""Text in pygame's own font, at any size, cached so that a frame costs blits only."""

import math
from collections import OrderedDict

import pygame

from game.drawing.palette import Colour

_SMALLEST, _LARGEST = 6, 400
"""Sizes of letters, pixels."""
_MOST_LINES, _MOST_FONTS = 256, 32
"""Greatest numbers of cached lines (also of cached wrapped texts), and of cached fonts."""
_FINER = 3
"""Letters are drawn larger by at least this factor and scaled down, so that gaps are exact to a fraction of a pixel."""
_LARGE, _FONT_STEPS = 24, 6
"""From this size on, pixels, letters of several sizes share a font: so many fonts for a size and its double. A font and its
first letters take about 1 ms, and words that grow would need a font for every frame."""


class Type:
    """Renders lines of text; caches the most recent ones."""

    def __init__(self) -> None:
        """Start with nothing rendered."""
        pygame.font.init()
        self._fonts: dict[int, pygame.font.Font] = {}
        self._lines: OrderedDict[tuple[str, int, Colour, float], pygame.Surface] = OrderedDict()
        self._wrapped: OrderedDict[tuple[str, int, float], list[str]] = OrderedDict()

    def rendered(self, text: str, size: float, colour: Colour, spacing: float = 0.0) -> pygame.Surface:
        """A line of text on a transparent surface. size: pixels; spacing: between letters, as a share of the size."""
        pixels, text = _pixels(size), _drawable(text)
        key = (text, pixels, colour, spacing)
        if key in self._lines:
            self._lines.move_to_end(key)
            return self._lines[key]
        font = self._font(pixels)
        gap = round(spacing * _font_pixels(pixels))
        large = _spaced(font, text, colour, gap) if gap else font.render(text, True, colour)
        large = _levelled(large, font.get_linesize(), _above(font, text))
        line = pygame.transform.smoothscale(large, (_scaled(large.get_width(), pixels), _scaled(large.get_height(), pixels)))
        self._lines[key] = line
        if len(self._lines) > _MOST_LINES:
            self._lines.popitem(last=False)
        return line

    def write(
        self,
        surface: pygame.Surface,
        text: str,
        size: float,
        colour: Colour,
        pixel: complex,
        anchor: str = "topleft",
        spacing: float = 0.0,
        opacity: float = 1.0,
    ) -> pygame.Rect:
        """Draw a line of text and return its box, pixels.

        size: of the letters, pixels. pixel: position of the box's point that `anchor` names, as in pygame.Rect. spacing:
        between letters, as a share of their size. opacity: 0 to 1.
        """
        text = _drawable(text)
        line = self.rendered(text, size, colour, spacing)
        box = line.get_rect(**{anchor: (round(pixel.real), round(pixel.imag))})
        if anchor.startswith("top"):
            box.top -= _above(self._font(_pixels(size)), text) // _FINER
        blit_faded(surface, line, box, opacity)
        return box

    def wrapped(self, text: str, size: float, width: float) -> list[str]:
        """The text in lines no wider than `width` pixels, as far as words allow."""
        key = (_drawable(text), _pixels(size), width)
        if key in self._wrapped:
            self._wrapped.move_to_end(key)
        else:
            self._wrapped[key] = self._broken(*key)
            if len(self._wrapped) > _MOST_LINES:
                self._wrapped.popitem(last=False)
        return list(self._wrapped[key])

    def _broken(self, text: str, pixels: int, width: float) -> list[str]:
        """As `wrapped`, without a cache: measuring every word of a panel full of text takes a millisecond."""
        lines: list[str] = []
        font = self._font(pixels)
        for word in text.split():
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and _scaled(font.size(longer)[0], pixels) <= width:  # the width that `rendered` would give
                lines[-1] = longer
            else:
                lines.append(word)
        return lines

    def _font(self, pixels: int) -> pygame.font.Font:
        """The font that letters of a size are scaled down from."""
        size = _font_pixels(pixels)
        if size not in self._fonts:
            if len(self._fonts) >= _MOST_FONTS:
                self._fonts.clear()
            self._fonts[size] = pygame.font.Font(None, size)
        return self._fonts[size]


def _spaced(font: pygame.font.Font, text: str, colour: Colour, gap: int) -> pygame.Surface:
    """A line with the same gap between all letters, for large words. gap: pixels of the font."""
    letters = [font.render(letter, True, colour) for letter in text]
    inked, lower = [letter.subsurface(_ink(letter)) for letter in letters], [_above(font, letter) for letter in text]
    height = font.render(text, True, colour).get_height()
    line = pygame.Surface((sum([letter.get_width() + gap for letter in inked]) - gap, height), pygame.SRCALPHA)
    line.fill((*colour, 0))
    left = 0
    for letter, above in zip(inked, lower, strict=True):
        line.blit(letter, (left, max(lower) - above))
        left += letter.get_width() + gap
    return line


def blit_faded(surface: pygame.Surface, picture: pygame.Surface, box: pygame.Rect, opacity: float) -> None:
    """Draw a picture with some opacity, 0 to 1. The picture may be a cached one: it is left as it was."""
    if opacity >= 1.0:
        surface.blit(picture, box)
        return
    picture.set_alpha(round(255.0 * opacity))
    surface.blit(picture, box)
    picture.set_alpha(255)


def _levelled(line: pygame.Surface, height: int, above: int) -> pygame.Surface:
    """The line with space added below, so that its letters are at the same distance from its middle as without accents.

    height: of a line without accents; above: how much lower the letters are, as `_above` returns it; pixels.
    """
    missing = height + 2 * above - line.get_height()
    if not above or missing <= 0:
        return line
    level = pygame.Surface((line.get_width(), line.get_height() + missing), pygame.SRCALPHA)
    level.fill((*line.get_at((0, 0))[:3], 0))
    level.blit(line, (0, 0), special_flags=pygame.BLEND_RGBA_MAX)
    return level


def _above(font: pygame.font.Font, text: str) -> int:
    """How far accents on capitals extend above a font's line, which moves the letters down by as much, pixels."""
    if text.isascii():
        return 0
    highest = max([metrics[3] for metrics in font.metrics(text) if metrics is not None], default=0)
    return max(highest - font.get_ascent(), 0)


def _drawable(text: str) -> str:
    """The text without null characters, which a level's name may have and pygame refuses."""
    return text.replace("\0", "\N{REPLACEMENT CHARACTER}")


def _pixels(size: float) -> int:
    """A size of letters that there is a font for, pixels."""
    return min(max(round(size), _SMALLEST), _LARGEST)


def _font_pixels(pixels: int) -> int:
    """Size of the font for letters of a size, pixels."""
    finer = pixels * _FINER
    return finer if pixels < _LARGE else math.ceil(2.0 ** (math.ceil(math.log2(finer) * _FONT_STEPS) / _FONT_STEPS))


def _scaled(length: int, pixels: int) -> int:
    """Length on the screen of what has a length in pixels of the font. pixels: size of the letters on the screen."""
    return -(-length * pixels // _font_pixels(pixels))


def _ink(letter: pygame.Surface) -> pygame.Rect:
    """The columns that a letter covers, at full height; for a space, which covers none, all of its columns."""
    ink = letter.get_bounding_rect()
    if ink.width == 0:
        return pygame.Rect(0, 0, letter.get_width(), letter.get_height())
    return pygame.Rect(ink.left, 0, ink.width, letter.get_height())
