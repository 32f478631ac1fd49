"""A scene as a slide: its shapes, labels and words in pixels, as a value. It is painted, or written as SVG."""

from typing import NamedTuple

import pygame

from game.drawing.palette import Theme
from game.lab.drawing.labels import placed_labels
from game.lab.drawing.marks import shapes_of
from game.lab.drawing.painting import paint_labels, paint_shapes
from game.lab.drawing.shapes import PixelShape, PlacedLabel
from game.lab.kit.picture import Picture, Toggle
from game.lab.kit.scene import LabScene
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.presenting import DEFAULT_SCALE, TEXT_SCALES
from game.lab.window.layout import layout_of
from game.lab.window.presented import PresentedWords, paint_presented, presented_words
from game.lab.window.view import Letters, pane_canvas, pane_views
from game.lab.window.words import TextSheet

SLIDE_SIZE = (1920, 1080)


class SlidePane(NamedTuple):
    """One world of a slide. area: pixels. shapes: from back to front."""

    area: pygame.Rect
    shapes: tuple[PixelShape, ...]
    labels: tuple[PlacedLabel, ...]


class Slide(NamedTuple):
    """Everything that is to be seen. size: pixels."""

    size: tuple[int, int]
    theme: Theme
    panes: tuple[SlidePane, ...]
    words: PresentedWords


class SlideStyle(NamedTuple):
    """How slides look. size: pixels. shown: the toggles that are on. letters: cached from slide to slide."""

    size: tuple[int, int]
    theme: Theme
    letters: Letters
    shown: frozenset[Toggle]


def slide_of(style: SlideStyle, scene: LabScene, picture: Picture, pan_zoom: PanZoom, step: str = "") -> Slide:
    """A picture of a scene as a slide. pan_zoom: the part of the world that is shown. step: the name of the step shown last."""
    layout = layout_of(style.size, TEXT_SCALES[DEFAULT_SCALE])
    sheet = TextSheet(pygame.Surface(layout.size, 0, 32), layout, style.theme, style.letters.around.words)
    panes = []
    for pane, view in zip(picture.panes, pane_views(layout, scene, picture, pan_zoom), strict=True):
        canvas = pane_canvas(sheet, style.letters, view, style.shown)
        shapes, labels = shapes_of(canvas, pane.marks), placed_labels(canvas, pane.marks, pane.title)
        panes.append(SlidePane(view.area, tuple(shapes), tuple(labels)))
    words = presented_words(layout, style.letters.around, style.theme, scene.title, step, picture)
    return Slide(layout.size, style.theme, tuple(panes), words)


def painted(slide: Slide, letters: Letters) -> pygame.Surface:
    """A slide as pixels."""
    surface = pygame.Surface(slide.size, 0, 32)
    for pane in slide.panes:
        surface.set_clip(pane.area)
        pygame.draw.rect(surface, slide.theme.ground, pane.area)
        paint_shapes(surface, pane.shapes)
        paint_labels(surface, letters.labels, pane.labels)
        if pane.area.left > 0:
            pygame.draw.line(surface, slide.theme.panel_edge, pane.area.topleft, pane.area.bottomleft)
    surface.set_clip(None)
    paint_presented(surface, letters.around, slide.theme, slide.words)
    return surface
