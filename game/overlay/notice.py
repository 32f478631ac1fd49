"""The line that says what to do now, and where it stands in nobody's way."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Layout
from game.drawing.palette import Theme
from game.drawing.primitives import draw_box
from game.drawing.text import Type
from game.rules import LIVES, PADDLES, Game, Phase
from game.scene import Scene


class Notice(NamedTuple):
    """A few words, and what to do."""

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


def draw(surface: pygame.Surface, place: Layout, shown: Notice, scene: Scene, theme: Theme, type_: Type) -> None:
    """The words on a plate between the bricks and the paddles, on the side where the ball is not."""
    unit = place.unit
    title = type_.rendered(shown.title, unit * 1.5, theme.text)
    hint = type_.rendered(shown.hint, unit * 1.0, theme.faint)
    gap = unit * 0.25 if shown.hint else 0.0
    height = title.get_height() + (hint.get_height() + gap if shown.hint else 0.0)
    plate = pygame.Rect(0, 0, round(max(title.get_width(), hint.get_width()) + unit * 1.6), round(height + unit * 1.0))
    middle = place.camera.project(_free_spot(scene))
    plate.center = (round(middle.real), round(middle.imag))
    draw_box(surface, plate, unit * 0.6, theme.panel, theme.panel_edge, unit * 0.06)
    top = plate.top + unit * 0.5
    surface.blit(title, title.get_rect(midtop=(plate.centerx, round(top))))
    if shown.hint:
        surface.blit(hint, hint.get_rect(midtop=(plate.centerx, round(top + title.get_height() + gap))))


def _serve_title(game: Game) -> str:
    """The level's name before its first serve, else what is left."""
    if game.tick == game.phase_tick or game.lives == LIVES:
        return game.level.name
    return "Last life" if game.lives == 1 else f"{game.lives} lives left"


def _free_spot(scene: Scene) -> complex:
    """The middle of the free ring, above the centre unless a ball is there."""
    track = scene.rings[PADDLES].inner_radius
    wall = max([ring.outer_radius for ring in scene.rings[PADDLES + 1 :]], default=0.0)
    height = min(max((track + wall) / 2.0, 0.62 * track), 0.75 * track)
    return -1j * height if any([ball.position.imag > 0.2 * track for ball in scene.balls]) else 1j * height
