"""A struck paddle out of its place: from above as a picture of its own, aslant as the same blocks a little farther out."""

import math

import numpy as np
import pygame

from game.blocks import Blocks
from game.camera import Camera, Points
from game.effects import Recoil
from game.palette import Colour, Theme, mixed
from game.skins import GLOW, Kind, Look
from physics import Ring

_RIM, _LEAST_RIM = 0.4, 1.0
"""Width of a paddle's darker edge: of its half width, and pixels."""
_CHORD = 0.06
"""Radians, at most."""
_AWAY = Look(Kind.EMPTY)


def draw(surface: pygame.Surface, ring: Ring, recoil: Recoil, look: Look, camera: Camera, theme: Theme) -> None:
    """The paddle from straight above. ring: the paddles in their place."""
    light = 0.8 * look.glow / GLOW
    out = ring.radius + recoil.out
    rim = max(_RIM * ring.half_width, _LEAST_RIM / camera.scale)
    for inset, colour in ((0.0, theme.paddle), (rim, theme.paddle_top)):
        half_width = ring.half_width - inset
        half_angle = ring.half_angle - inset / ring.radius
        _fill(
            surface, _outline(out, half_width, ring.angle(recoil.slot), half_angle, camera), mixed(colour, theme.flash, light)
        )


def without(looks: tuple[Look, ...], recoils: tuple[Recoil, ...]) -> tuple[Look, ...]:
    """The looks of the paddles' places, nothing where one is out of its place."""
    away = {recoil.slot for recoil in recoils}
    return tuple([_AWAY if slot in away else look for slot, look in enumerate(looks)]) if away else looks


def pushed(blocks: Blocks, recoils: tuple[Recoil, ...]) -> Blocks:
    """The paddles' blocks, those of a struck one out of their place."""
    for recoil in recoils:
        out = np.where(blocks.slot == recoil.slot, recoil.out, 0.0)[:, None]
        blocks = blocks._replace(foot=blocks.foot * (1.0 + out / np.abs(blocks.foot)))
    return blocks


def _outline(radius: float, half_width: float, angle: float, half_angle: float, camera: Camera) -> Points:
    """Around a sector, pixels."""
    count = max(math.ceil(2.0 * half_angle / _CHORD), 2)
    arc = np.exp(1j * (angle + half_angle * np.linspace(-1.0, 1.0, count + 1)))
    return camera.projected(
        np.concatenate([arc * (radius + half_width), arc[::-1] * (radius - half_width)]) * camera.turning, 0.0
    )


def _fill(surface: pygame.Surface, outline: Points, colour: Colour) -> None:
    """A polygon with an anti-aliased edge."""
    pygame.draw.polygon(surface, colour, outline.view(np.float64).reshape(-1, 2).tolist())
    pygame.draw.aalines(surface, colour, True, (outline - (0.5 + 0.5j)).view(np.float64).reshape(-1, 2).tolist())
