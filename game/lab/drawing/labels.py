"""The labels of a pane, rendered by pygame at the positions that label_boxes.py chooses."""

from collections.abc import Sequence

import pygame

from game.drawing.palette import Colour
from game.lab.drawing.canvas import PaneCanvas
from game.lab.drawing.label_boxes import BoxedLabel, boxed_label, boxed_labels
from game.lab.drawing.shapes import PlacedLabel
from game.lab.drawing.wanted_labels import WantedLabel
from game.lab.kit.picture import Mark


def placed_labels(
    canvas: PaneCanvas, marks: Sequence[Mark], title: str = "", handles: Sequence[complex] = ()
) -> list[PlacedLabel]:
    """The title of a pane and the labels of its marks, as `boxed_labels` places them."""
    return [_placed(canvas, one) for one in boxed_labels(canvas, marks, title, handles)]


def label_at(canvas: PaneCanvas, pixel: complex, text: str, colour: Colour, anchor: str = "center") -> list[PlacedLabel]:
    """Words at a pixel, moved into the pane where they stand out of it; none far outside of it. anchor: as in pygame.Rect."""
    return [_placed(canvas, one) for one in boxed_label(canvas, WantedLabel(pixel, text, colour, anchor))]


def _placed(canvas: PaneCanvas, label: BoxedLabel) -> PlacedLabel:
    """A label in the size and with the outline of its pane."""
    return PlacedLabel(pygame.Rect(*label.box), label.text, canvas.size, label.colour, canvas.theme.ground, canvas.plates)
