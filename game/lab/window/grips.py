"""The rings one takes hold of: where they are on the screen, and which is under the pointer."""

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import mixed
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given
from game.lab.window.canvas import Canvas, write_beside

_RADIUS, _CATCH = 0.42, 1.0
"""Of a ring, and of what counts as on it, in sizes of text."""


class Grip(NamedTuple):
    """What is held: a handle, or the view where there is none."""

    pane: int
    handle: Handle | None
    slip: complex  # world units from the pointer to the handle


def grip_at(
    pixel: complex,
    areas: Sequence[pygame.Rect],
    cameras: Sequence[Camera],
    given: Given,
    scene_handles: Sequence[Handle],
    unit: float,
) -> Grip | None:
    """What is under a pixel; None outside of the worlds. Of two near handles the first wins."""
    for pane, (area, camera) in enumerate(zip(areas, cameras, strict=True)):
        if not area.collidepoint(pixel.real, pixel.imag):
            continue
        world = camera.unproject(pixel)
        held = _nearest(world, camera, given, scene_handles, unit)
        return Grip(pane, held, held.place(given) - world if held is not None else 0j)
    return None


def draw_grips(canvas: Canvas, given: Given, scene_handles: Sequence[Handle], hot: Handle | None) -> None:
    """A ring for each handle; the one under the pointer is bright and says what it is."""
    before = canvas.surface.get_clip()
    canvas.surface.set_clip(canvas.area)
    for handle in scene_handles:
        place = canvas.camera.project(handle.place(given))
        colour = canvas.theme.accent if handle is hot else mixed(canvas.theme.ground, canvas.theme.text, 0.75)
        radius, width = canvas.unit * _RADIUS, max(round(canvas.unit * 0.14), 1)
        spot = (place.real - 0.5, place.imag - 0.5)
        if canvas.area.inflate(99, 99).collidepoint(spot):
            pygame.draw.aacircle(canvas.surface, canvas.theme.ground, spot, radius + width, width)
            pygame.draw.aacircle(canvas.surface, colour, spot, radius + 0.5 * width, width)
    if hot is not None:
        write_beside(canvas, canvas.camera.project(hot.place(given)) + 1.5j * canvas.unit, hot.label, canvas.theme.accent)
    canvas.surface.set_clip(before)


def _nearest(world: complex, camera: Camera, given: Given, scene_handles: Sequence[Handle], unit: float) -> Handle | None:
    """The handle nearest to a place, of those near enough: within a ring, or within what it moves."""
    catch = _CATCH * unit / camera.scale
    away = [abs(handle.place(given) - world) for handle in scene_handles]
    on = [(distance, number) for number, distance in enumerate(away) if distance <= catch]
    if not on:
        on = [
            (distance, number)
            for number, (handle, distance) in enumerate(zip(scene_handles, away, strict=True))
            if handle.reach is not None and distance <= handle.reach(given)
        ]
    return scene_handles[min(on)[1]] if on else None
