"""What the tests of whole sessions do on the way."""

import pygame

from game.rules import Phase
from game.screens.play.screen import PlayScreen


def lose(desk, serve):
    """Let every ball go, but for what hits a brick on its way."""
    for _ in range(3000):
        if not isinstance(desk.screen, PlayScreen):
            return
        if desk.screen._ticked.game.phase == Phase.SERVING:
            serve()
        desk.screen._untouched = 10**6  # the ball may be given up
        if desk.screen._ticked.game.score and desk.screen._ticked.game.phase == Phase.PLAYING:
            desk.press(pygame.K_g)
        desk.wait(0.1)
    raise AssertionError("the game does not end")


def visit(desk, *expected):
    """The screens that are opened by functions, one after the other, each led back from by another."""
    for opens, kind, leaves in expected:
        before = desk.screen
        opens()
        assert isinstance(desk.screen, kind)
        leaves()
        assert desk.screen is before
