"""Anti-aliased shapes on a surface, seen from straight above."""

import math

import numpy as np
import pygame
from numpy.typing import NDArray

from game.camera import Camera
from game.outlines import Outline, arrow, sector, truss
from game.palette import Colour, Theme, layer_colour, mixed
from physics import PERMANENT, Ring

_HALF_PIXEL = 0.5 + 0.5j
"""Lines count pixels from their centres, polygons from their corners."""
_TERRACE = 0.085
"""World units from one terrace's edge to the next, where there is room."""


def fill_outline(
    surface: pygame.Surface, camera: Camera, outline: Outline | None, angles: NDArray[np.float64], colour: Colour
) -> None:
    """One shape at every angle."""
    if outline is None or not len(angles):
        return
    edges = camera._replace(centre=camera.centre - _HALF_PIXEL).placed(outline.edge, angles)
    for fill, edge in zip(camera.placed(outline.fill, angles), edges, strict=True):
        pygame.draw.polygon(surface, colour, fill)
        pygame.draw.aalines(surface, colour, True, edge)


def draw_paddles(surface: pygame.Surface, camera: Camera, ring: Ring, theme: Theme, glow: dict[int, float]) -> None:
    """The paddles; those that were just hit glow. glow: strength, 0 to 1, per slot."""
    inner, outer = ring.inner_radius * camera.scale, ring.outer_radius * camera.scale
    rim = max(1.0, 0.2 * (outer - inner))
    for slot, angle in enumerate(_angles(ring, range(ring.count))):
        strength = glow.get(slot, 0.0)
        at = np.array([angle])
        fill_outline(
            surface, camera, sector(inner, outer, ring.half_angle, 0.0), at, mixed(theme.paddle, theme.flash, strength)
        )
        top = sector(inner, outer, ring.half_angle, rim)
        fill_outline(surface, camera, top, at, mixed(theme.paddle_top, theme.flash, strength))


def draw_bricks(
    surface: pygame.Surface, camera: Camera, ring: Ring, layers: tuple[int, ...], theme: Theme, slots: range | list[int]
) -> None:
    """Stacks as terraces, one step and one colour per layer; what cannot break as steel with a truss."""
    steel = [slot for slot in slots if layers[slot] == PERMANENT]
    if steel:
        _draw_steel(surface, camera, ring, theme, _angles(ring, steel))
    inner, outer = ring.inner_radius * camera.scale, ring.outer_radius * camera.scale
    tallest = max([layers[slot] for slot in slots], default=0)
    step = terrace_step(ring, max(layers)) * camera.scale
    for layer in range(1, tallest + 1):
        high_enough = [slot for slot in slots if layers[slot] >= layer]
        outline = sector(inner, outer, ring.half_angle, step * (layer - 1))
        fill_outline(surface, camera, outline, _angles(ring, high_enough), layer_colour(theme, layer))


def draw_flash(surface: pygame.Surface, camera: Camera, ring: Ring, slot: int, layers: int, age: float, theme: Theme) -> None:
    """The mark of a hit: the layer that broke shrinks away; steel rings; what is left shines."""
    inner, outer = ring.inner_radius * camera.scale, ring.outer_radius * camera.scale
    at = _angles(ring, [slot])
    if layers == 0:
        fade = mixed(theme.flash, theme.ground, min(1.0, 0.35 + 0.65 * age))
        outline = sector(inner, outer, ring.half_angle, age * min(outer - inner, 2.0 * ring.half_angle * inner) / 2.0)
    else:
        base = theme.steel if layers == PERMANENT else layer_colour(theme, layers)
        fade = mixed(theme.flash, base, age)
        width = 0.0 if layers == PERMANENT else terrace_step(ring, layers) * camera.scale * (layers - 1)
        outline = sector(inner, outer, ring.half_angle, width)
    fill_outline(surface, camera, outline, at, fade)
    if layers == PERMANENT:
        _draw_truss(surface, camera, ring, theme, at)


def terrace_step(ring: Ring, tallest: int) -> float:
    """World units from one terrace's edge to the next, so that the tallest stack of the ring keeps a top."""
    room = min(ring.half_width, ring.half_angle * ring.inner_radius)
    return min(_TERRACE, room * 0.8 / max(tallest, 1))


def draw_arrow(surface: pygame.Surface, camera: Camera, origin: complex, way: complex, theme: Theme, reach: float) -> None:
    """Where the serve will go: a line of dots that ends in an arrow's head. origin, reach: world units; way: unit."""
    turn = np.array([math.atan2(way.imag, way.real)])
    start = camera._replace(centre=camera.project(origin))
    size = 0.2 * camera.scale
    head = arrow(reach * camera.scale, size)
    for dot in np.linspace(0.5, reach - 0.55, 6):
        place = start.centre + complex(way.real, -way.imag) * float(dot) * camera.scale
        draw_dot(surface, place, max(1.5, 0.055 * camera.scale), theme.accent)
    points = start.placed(head, turn)[0]
    pygame.draw.polygon(surface, theme.accent, points)
    edge = start._replace(centre=start.centre - _HALF_PIXEL).placed(head, turn)[0]
    pygame.draw.aalines(surface, theme.accent, True, edge)


def draw_dot(surface: pygame.Surface, place: complex, radius: float, colour: Colour) -> None:
    """A small anti-aliased disc around a pixel."""
    pygame.draw.aacircle(surface, colour, (place.real - 0.5, place.imag - 0.5), radius)


def _draw_steel(surface: pygame.Surface, camera: Camera, ring: Ring, theme: Theme, angles: NDArray[np.float64]) -> None:
    """Sectors that no hit breaks."""
    inner, outer = ring.inner_radius * camera.scale, ring.outer_radius * camera.scale
    fill_outline(surface, camera, sector(inner, outer, ring.half_angle, 0.0), angles, theme.steel)
    _draw_truss(surface, camera, ring, theme, angles)


def _draw_truss(surface: pygame.Surface, camera: Camera, ring: Ring, theme: Theme, angles: NDArray[np.float64]) -> None:
    """The zigzag on steel."""
    inner, outer = ring.inner_radius * camera.scale, ring.outer_radius * camera.scale
    width = max(1, round(0.05 * camera.scale))
    line = truss(inner, outer, ring.half_angle, 0.16 * (outer - inner))
    frame = sector(inner, outer, ring.half_angle, 0.08 * (outer - inner))
    lines = camera._replace(centre=camera.centre - _HALF_PIXEL)
    for outline, closed in ((line, False), (frame.edge if frame else None, True)):
        if outline is not None:
            for points in lines.placed(outline, angles):
                pygame.draw.aalines(surface, theme.steel_line, closed, points)
                if width > 1 and not closed:
                    pygame.draw.lines(surface, theme.steel_line, closed, points, width)


def _angles(ring: Ring, slots: range | list[int]) -> NDArray[np.float64]:
    """Middle angles of some slots."""
    return ring.phase + np.asarray(slots, dtype=np.float64) * (math.tau / ring.count)
