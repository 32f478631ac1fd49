"""A surface's pixels as arrays, and points as pygame takes them."""

from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray


def pixels_of(surface: pygame.Surface) -> NDArray[np.uint32]:
    """A 32-bit surface's pixels, row after row. The surface is locked for as long as the array lives."""
    buffer: Any = surface.get_buffer()
    return np.frombuffer(buffer, dtype=np.uint32)


def packed(surface: pygame.Surface, colours: NDArray[np.float32]) -> NDArray[np.uint32]:
    """Colours as a 32-bit surface stores them. colours: red, green and blue, 0 to 255, along the last axis."""
    channels = np.rint(colours).astype(np.uint32)
    red, green, blue, _ = (np.uint32(shift) for shift in surface.get_shifts())
    opaque = np.uint32(surface.get_masks()[3] & 0xFFFFFFFF)
    stored = channels[..., 0] << red | channels[..., 1] << green | channels[..., 2] << blue | opaque
    return np.asarray(stored, dtype=np.uint32)


def unpacked(surface: pygame.Surface, pixels: NDArray[np.uint32]) -> NDArray[np.float32]:
    """Red, green and blue, 0 to 255, along one more axis, of pixels as a 32-bit surface stores them."""
    channels = [pixels >> np.uint32(shift) & np.uint32(255) for shift in surface.get_shifts()[:3]]
    return np.stack(channels, axis=-1).astype(np.float32)


def pairs(points: NDArray[np.complex128]) -> Any:
    """Points as nested lists of their x and y, which pygame draws from: one more level than the array has axes."""
    return np.ascontiguousarray(points).view(np.float64).reshape(*points.shape, 2).tolist()
