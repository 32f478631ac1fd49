"""A picture that is drawn once, and drawn again only after something on it has changed."""

from collections.abc import Callable

import pygame


class CachedPicture:
    """Shows what a drawing function drew, from a copy as long as it would draw the same again."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._key: tuple[object, ...] | None = None
        self._picture = pygame.Surface((0, 0))

    def show(self, surface: pygame.Surface, shown: tuple[object, ...], draw: Callable[[pygame.Surface], None]) -> None:
        """Show on a surface what `draw` draws there. shown: all that the picture depends on, except the surface's size."""
        key = (surface.get_size(), *shown)
        if key == self._key:
            surface.blit(self._picture, (0, 0))
            return
        draw(surface)
        self._picture, self._key = surface.copy(), key
