"""Surfaces as an animated GIF, by Pillow, which matplotlib brings along; the frozen application has neither."""

import io
from collections.abc import Sequence
from importlib.util import find_spec
from typing import NamedTuple

import pygame

_COLOURS = 128


class Frame(NamedTuple):
    """One picture of an animation. milliseconds: for which it stands."""

    surface: pygame.Surface
    milliseconds: int


def can_animate() -> bool:
    """Whether Pillow is installed."""
    return find_spec("PIL") is not None


def gif_of(frames: Sequence[Frame]) -> bytes:
    """The file. It goes round for ever."""
    from PIL import Image  # noqa: PLC0415  # a fifth of a second, only where it is needed

    pictures = [
        Image.frombytes("RGB", frame.surface.get_size(), pygame.image.tobytes(frame.surface, "RGB")).quantize(
            _COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE
        )
        for frame in frames
    ]
    file = io.BytesIO()
    durations = [frame.milliseconds for frame in frames]
    pictures[0].save(file, "GIF", save_all=True, append_images=pictures[1:], duration=durations, loop=0, optimize=True)
    return file.getvalue()
