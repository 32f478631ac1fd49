"""How a scene is drawn: its panes with their handles, and the words around them."""

from typing import NamedTuple

import pygame

from game.drawing.text import Type
from game.lab.drawing.canvas import PaneCanvas
from game.lab.drawing.formula_type import FormulaType
from game.lab.drawing.painting import draw_marks
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given
from game.lab.kit.picture import Picture, Toggle
from game.lab.kit.scene import LabScene
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.reveal import WHOLE, Reveal, guess_handle
from game.lab.window.dragging import PaneView, draw_handles
from game.lab.window.layout import WindowLayout, focus_areas, pane_areas
from game.lab.window.pane_lines import draw_pane_lines
from game.lab.window.presented import WordLetters
from game.lab.window.words import TextSheet

_HALO, _HALO_OPACITY = 1.5, 110
"""Radius of the ring of light around the pointer in a lecture room, in units; its opacity, of 255."""


class Letters(NamedTuple):
    """The letters of the words around a picture, and of the labels in it."""

    around: WordLetters
    labels: Type


def letters_for(words: Type) -> Letters:
    """Letters that set formulas where mathtext is there, and else the plain ones."""
    return Letters(WordLetters(words, FormulaType(words=True)), FormulaType())


def pane_views(
    layout: WindowLayout, scene: LabScene, picture: Picture, pan_zoom: PanZoom, reveal: Reveal = WHOLE
) -> list[PaneView]:
    """Area, camera and handles of each pane; all of them show the same part of the world.

    picture: what is shown. reveal: how much of the scene's picture that is; what is not drawn yet has no handle.
    """
    panes, answer = picture.panes, guess_handle(reveal, picture)
    handles = tuple([one for one in scene.handles if reveal.seen is None or one.step <= reveal.seen])
    views = [
        PaneView(area, focus, pan_zoom.camera(scene.view_box, focus), handles if pane.has_handles else ())
        for area, focus, pane in zip(pane_areas(layout, len(panes)), focus_areas(layout, len(panes)), panes, strict=True)
    ]
    if answer is not None:
        views[0] = views[0]._replace(handles=(answer, *views[0].handles))
    return views


def draw_panes(
    sheet: TextSheet, letters: Letters, picture: Picture, views: list[PaneView], shown: frozenset[Toggle], given: Given
) -> None:
    """Every pane with its title, without its handles."""
    for pane, view in zip(picture.panes, views, strict=True):
        pygame.draw.rect(sheet.surface, sheet.theme.ground, view.area)
        rings = [view.camera.project(handle.position(given)) for handle in view.handles]
        draw_marks(pane_canvas(sheet, letters, view, shown), pane.marks, pane.title, rings)
        if view.area.left > sheet.layout.world.left:
            pygame.draw.line(sheet.surface, sheet.theme.panel_edge, view.area.topleft, view.area.bottomleft)


def draw_all_handles(
    sheet: TextSheet, letters: Letters, picture: Picture, views: list[PaneView], given: Given, hovered: Handle | None
) -> None:
    """The rings of all handles, and a pane's own lines over them. hovered: the handle under the pointer."""
    for pane, view in zip(picture.panes, views, strict=True):
        there = next((one for one in view.handles if hovered is not None and one.label == hovered.label), None)
        draw_handles(pane_canvas(sheet, letters, view, frozenset()), given, view.handles, there)
        draw_pane_lines(sheet.surface, view.focus, pane, sheet.theme, sheet.type, sheet.unit)


def pane_canvas(sheet: TextSheet, letters: Letters, view: PaneView, shown: frozenset[Toggle]) -> PaneCanvas:
    """What one pane is drawn on."""
    layout = sheet.layout
    type_ = letters.labels if layout.presents else letters.around.words
    about = (sheet.surface, view.area, view.camera, sheet.theme, type_, layout.pen, shown)
    return PaneCanvas(*about, layout.letters, view.focus, layout.presents)


def draw_halo(sheet: TextSheet, pixel: complex) -> None:
    """A ring of light around the pointer, which a room can follow."""
    radius = round(sheet.unit * _HALO)
    ring = pygame.Surface((2 * radius + 2, 2 * radius + 2), pygame.SRCALPHA)
    pygame.draw.circle(ring, (*sheet.theme.accent, _HALO_OPACITY // 3), (radius + 1, radius + 1), radius)
    pygame.draw.circle(ring, (*sheet.theme.accent, _HALO_OPACITY), (radius + 1, radius + 1), radius, max(radius // 10, 2))
    sheet.surface.blit(ring, (round(pixel.real) - radius - 1, round(pixel.imag) - radius - 1))
