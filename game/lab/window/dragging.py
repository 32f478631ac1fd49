"""Dragging: the handles as rings on the screen, and what a press of the mouse takes hold of."""

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.drawing.camera import Camera
from game.drawing.palette import mixed
from game.lab.drawing.canvas import PaneCanvas
from game.lab.drawing.labels import label_at
from game.lab.drawing.painting import paint_labels
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given

_RADIUS, _CATCH, _WIDTH = 0.42, 1.2, 0.14
"""In units: radius of a handle's ring, distance within which a press takes hold of it, width of its line."""
_LEAST_CATCH = 12.0
"""Pixels: no target is smaller than a disc of this radius."""
_MISSED = 2.2
"""Within so many catches of a handle a press that takes hold of nothing was meant for it: the world stays where it is."""


class PaneView(NamedTuple):
    """One pane on the screen.

    area: pixels. focus: its part in which the scene is shown whole. handles: those that are drawn and can be dragged in it.
    """

    area: pygame.Rect
    focus: pygame.Rect
    camera: Camera
    handles: tuple[Handle, ...]


class HandleDrag(NamedTuple):
    """What the mouse holds.

    pane: the index of the pane where it was pressed. handle: None for the world itself, which is moved then.
    offset: world units from the pointer to the handle's position, so that a handle does not jump when it is taken hold of.
    """

    pane: int
    handle: Handle | None
    offset: complex


def drag_at(pixel: complex, panes: Sequence[PaneView], given: Given, unit: float) -> HandleDrag | None:
    """What a press at a pixel takes hold of; None outside of the panes, and where it just missed a handle.

    unit: pixels, the measure of lines and points.
    """
    for index, pane in enumerate(panes):
        if pane.area.collidepoint(pixel.real, pixel.imag):
            point, catch = pane.camera.unproject(pixel), max(_CATCH * unit, _LEAST_CATCH) / pane.camera.scale
            handle = _nearest(point, given, pane.handles, catch)
            distances = [abs(one.position(given) - point) for one in pane.handles]
            if handle is None and distances and min(distances) < _MISSED * catch:
                return None
            return HandleDrag(index, handle, 0j if handle is None else handle.position(given) - point)
    return None


def draw_handles(canvas: PaneCanvas, given: Given, handles: Sequence[Handle], hovered: Handle | None) -> None:
    """A ring for each handle; the one under the pointer is bright and says what it changes."""
    before = canvas.surface.get_clip()
    canvas.surface.set_clip(canvas.area)
    radius, width = canvas.unit * _RADIUS, max(round(canvas.unit * _WIDTH), 1)
    for handle in handles:
        pixel = canvas.camera.project(handle.position(given))
        centre = (pixel.real - 0.5, pixel.imag - 0.5)
        if canvas.area.inflate(99, 99).collidepoint(centre):
            colour = canvas.theme.accent if handle is hovered else mixed(canvas.theme.ground, canvas.theme.text, 0.75)
            pygame.draw.aacircle(canvas.surface, canvas.theme.ground, centre, radius + width, width)
            pygame.draw.aacircle(canvas.surface, colour, centre, radius + 0.5 * width, width)
    if hovered is not None:
        pixel = canvas.camera.project(hovered.position(given)) + 1.5j * canvas.unit
        paint_labels(canvas.surface, canvas.type, label_at(canvas, pixel, hovered.label, canvas.theme.accent))
    canvas.surface.set_clip(before)


def _nearest(point: complex, given: Given, handles: Sequence[Handle], catch: float) -> Handle | None:
    """The handle nearest to a point of the world, the first of equals: within `catch` of its ring, else within its reach."""
    distances = [abs(handle.position(given) - point) for handle in handles]
    caught = [(distance, index) for index, distance in enumerate(distances) if distance <= catch]
    if not caught:
        caught = [
            (distance, index)
            for index, (handle, distance) in enumerate(zip(handles, distances, strict=True))
            if handle.reach is not None and distance <= handle.reach(given)
        ]
    return handles[min(caught)[1]] if caught else None
