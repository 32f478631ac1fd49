"""The line that says what to do now, on a plate where it hides neither bricks nor the ball."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.rules import LIVES, PADDLES, Game, Phase
from game.scene import Scene

# Lengths are in units of text.
_TITLE, _HINT = 1.5, 1.0
"""Sizes of letters."""
_GAP = 0.25
"""Between title and hint."""
_MARGIN = complex(0.8, 0.5)
"""From the words to the plate's edges, across and down."""
_CORNER, _EDGE_LINE = 0.6, 0.06
"""Radius of the plate's corners, and width of its edge."""
# Radii are in shares of the inner radius of the paddles' track.
_LOWEST, _HIGHEST = 0.62, 0.75
"""The plate's middle is between these radii, above the centre or below it."""
_BALL_ABOVE = 0.2
"""A ball that is higher above the centre than this sends the plate below."""


class Notice(NamedTuple):
    """A few words, and what to do; the hint may be empty."""

    title: str
    hint: str


READY = Notice("Ready", "")


def notice(game: Game) -> Notice | None:
    """What to tell the player; None while a ball is in play."""
    if game.phase == Phase.SERVING:
        return Notice(_serve_title(game), "Space or click: serve along the arrow")
    if game.phase == Phase.CLEARED:
        following = game.levels[game.number + 1].name
        return Notice("Level cleared", f"Next: {following}. Space or click: go on")
    if game.phase == Phase.WON:
        return Notice("All levels cleared", "")
    return Notice("Game over", "") if game.phase == Phase.OVER else None


def draw(canvas: Canvas, shown: Notice, scene: Scene) -> None:
    """The words on a plate between the bricks and the paddles, on the side where the ball is not."""
    surface, theme, type_, unit = canvas.surface, canvas.theme, canvas.type, canvas.unit
    title = type_.rendered(shown.title, unit * _TITLE, theme.text)
    hint = type_.rendered(shown.hint, unit * _HINT, theme.faint)
    gap = unit * _GAP if shown.hint else 0.0
    height = title.get_height() + (hint.get_height() + gap if shown.hint else 0.0)
    margin = _MARGIN * unit
    width = max(title.get_width(), hint.get_width())
    plate = pygame.Rect(0, 0, round(width + 2.0 * margin.real), round(height + 2.0 * margin.imag))
    middle = canvas.camera.project(_free_position(scene))
    plate.center = (round(middle.real), round(middle.imag))
    draw_box(surface, plate, unit * _CORNER, theme.panel, theme.panel_edge, unit * _EDGE_LINE)
    top = plate.top + margin.imag
    surface.blit(title, title.get_rect(midtop=(plate.centerx, round(top))))
    if shown.hint:
        surface.blit(hint, hint.get_rect(midtop=(plate.centerx, round(top + title.get_height() + gap))))


def _serve_title(game: Game) -> str:
    """The level's name before its first serve, else what is left."""
    if game.tick == game.phase_tick or game.lives == LIVES:
        return game.level.name
    return "Last life" if game.lives == 1 else f"{game.lives} lives left"


def _free_position(scene: Scene) -> complex:
    """A position in the free ring between bricks and paddles: above the centre, unless a ball is there."""
    track = scene.rings[PADDLES].inner_radius
    wall = max([ring.outer_radius for ring in scene.rings[PADDLES + 1 :]], default=0.0)
    radius = min(max((track + wall) / 2.0, _LOWEST * track), _HIGHEST * track)
    ball_above = any([ball.position.imag > _BALL_ABOVE * track for ball in scene.balls])
    return -1j * radius if ball_above else 1j * radius
