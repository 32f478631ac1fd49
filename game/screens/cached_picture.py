"""A picture that is drawn once, and then again only when something on it has changed."""

from collections.abc import Callable

import pygame


class CachedPicture:
    """Shows what a drawing function drew, from memory as long as the same things are to be seen."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._key: tuple[object, ...] | None = None
        self._picture = pygame.Surface((0, 0))

    def show(self, surface: pygame.Surface, shown: tuple[object, ...], draw: Callable[[pygame.Surface], None]) -> None:
        """Cover a surface with what `draw` draws on it. shown: all that the picture depends on, but the surface's size."""
        key = (surface.get_size(), *shown)
        if key == self._key:
            surface.blit(self._picture, (0, 0))
            return
        draw(surface)
        self._picture, self._key = surface.copy(), key
