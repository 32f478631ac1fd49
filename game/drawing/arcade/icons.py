"""Pictures of the chips of power-ups."""

import pygame

from game.drawing.arcade.signs import Outline, chip, power_colour
from game.drawing.palette import Colour, Theme
from game.rules import PowerUp

_FINER = 4
"""Rows and columns of the drawing per pixel of the icon."""
_MOST_ICONS = 256


class PowerIcons:
    """Draws the icons of power-ups; caches their pictures."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._icons: dict[tuple[PowerUp, int, Colour, Colour], pygame.Surface] = {}

    def icon(self, kind: PowerUp, radius: float, theme: Theme) -> pygame.Surface:
        """A chip with its sign on a transparent square. radius: of the chip, pixels."""
        key = (kind, max(round(radius), 4), power_colour(kind, theme), theme.ground)
        if key not in self._icons:
            if len(self._icons) >= _MOST_ICONS:
                self._icons.clear()
            self._icons[key] = _icon(kind, key[1], theme)
        return self._icons[key]

    def draw(self, surface: pygame.Surface, kind: PowerUp, pixel: complex, radius: float, theme: Theme) -> None:
        """A chip around a pixel."""
        icon = self.icon(kind, radius, theme)
        surface.blit(icon, icon.get_rect(center=(round(pixel.real), round(pixel.imag))))


def _icon(kind: PowerUp, radius: int, theme: Theme) -> pygame.Surface:
    """A power-up's icon, drawn finer and scaled down."""
    side = 2 * radius + 2
    picture = pygame.Surface((side * _FINER, side * _FINER), pygame.SRCALPHA)
    picture.fill((*power_colour(kind, theme), 0))
    for outline, colour in chip(kind, theme):
        _fill(picture, outline, radius * _FINER, colour)
    return pygame.transform.smoothscale(picture, (side, side))


def _fill(picture: pygame.Surface, outline: Outline, scale: float, colour: Colour) -> None:
    """An outline about the picture's middle."""
    middle = picture.get_width() / 2.0
    pygame.draw.polygon(picture, colour, [(middle + point.real * scale, middle - point.imag * scale) for point in outline])
