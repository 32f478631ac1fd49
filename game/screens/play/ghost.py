"""The ghost: the best run of a level, played again beside the present one, and drawn as a pale ball and pale paddles."""

import time
from collections.abc import Iterator

import pygame

from game.drawing.camera import Layout
from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.language import tr
from game.replays.file import Recording, played
from game.rules import PADDLES, Game, Phase, Ticked
from game.screens.toolkit.plate import write_fitting
from physics import direction

_BUDGET = 0.004
"""Seconds of a frame that may go into playing the recording up to where the level began."""
_PALE = 0.4
"""Share of the way from the ground's colour to the text's."""
_ARC_STEPS = 12
# Lengths are in units of text.
_EDGE, _ABOVE_NAME, _CAPTION, _FIGURE = 0.8, 4.6, 0.9, 1.5
"""From the words to the surface's left and lower edges, and sizes of letters."""


class Ghost:
    """A recorded game from the first serve of one level on, a tick for every tick of the player's after the first serve."""

    def __init__(self, recording: Recording, start: int, number: int) -> None:
        """start: tick of the recording at which the level began. number: of the level in the present game."""
        self._ticks: Iterator[Ticked] = played(recording)
        self._start, self.number = start, number
        self._game: Game | None = None
        self._level = -1
        self._running = self._over = False

    @property
    def game(self) -> Game | None:
        """How it stands; None before it is ready and after its level's end."""
        return None if self._over or not self._running else self._game

    def prepare(self) -> None:
        """Play the recording on towards the level's first serve, for a few milliseconds."""
        until = time.perf_counter() + _BUDGET
        while not self._is_ready() and not self._over and time.perf_counter() < until:
            self._step()

    def after_tick(self, game: Game) -> None:
        """A tick of the player's game has passed: the ghost's runs once the player has served for the first time."""
        if not self._is_ready() or self._over or game.phase not in (Phase.PLAYING, Phase.SERVING):
            return
        if not self._running and game.phase == Phase.PLAYING:
            self._running = True
        if self._running:
            self._step()
            if self._game is not None and (self._game.number != self._level or self._game.phase > Phase.PLAYING):
                self._over = True

    def _is_ready(self) -> bool:
        """Whether the recording stands at the level's first serve or later."""
        game = self._game
        return game is not None and game.tick > self._start and (self._running or game.phase != Phase.SERVING)

    def _step(self) -> None:
        """One tick of the recording."""
        done = next(self._ticks, None)
        if done is None:
            self._over = True
            return
        self._game = done.game
        if not self._running:
            self._level = done.game.number


def draw(canvas: Canvas, game: Game) -> None:
    """The outlines of balls and paddles, pale; the bricks are not shown, as they would be taken for the player's."""
    camera, theme = canvas.camera, canvas.theme
    colour = mixed(theme.ground, theme.text, _PALE)
    width = max(round(canvas.unit * 0.09), 1)
    paddles = game.arena.rings[PADDLES]
    for slot in range(paddles.count):
        outline = []
        for step in range(_ARC_STEPS + 1):
            towards = direction(paddles.angle(slot) + paddles.half_angle * (2.0 * step / _ARC_STEPS - 1.0))
            outer, inner = camera.project(paddles.outer_radius * towards), camera.project(paddles.inner_radius * towards)
            outline.append((outer.real, outer.imag))
            outline.insert(0, (inner.real, inner.imag))
        pygame.draw.aalines(canvas.surface, colour, True, outline)  # closed
    for ball in game.arena.balls:
        pixel = camera.project(ball.position)
        radius = ball.radius * camera.scale_at(ball.position)
        pygame.draw.aacircle(canvas.surface, colour, (pixel.real, pixel.imag), max(radius, 2.0), width)


def draw_lead(canvas: Canvas, game: Game, ghost: Game, layout: Layout) -> None:
    """How many points of the level the player is ahead of the ghost, at the left edge above the level's name."""
    theme, unit = canvas.theme, canvas.unit
    lead = (game.score - game.score_before) - (ghost.score - ghost.score_before)
    colour = theme.accent if lead > 0 else theme.danger if lead < 0 else theme.text
    foot = complex(unit * _EDGE, canvas.size[1] - unit * _ABOVE_NAME)
    box = canvas.write(f"{lead:+,}", _FIGURE, colour, foot, "bottomleft")
    room = layout.left_edge(box.top - unit * _CAPTION) - box.left
    write_fitting(canvas, tr("BEST RUN"), _CAPTION, theme.faint, complex(box.left, box.top), "bottomleft", room)
