"""What the player is told before a serve."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.drawing.camera import Camera, layout
from game.drawing.canvas import Canvas
from game.drawing.letter_sizes import width
from game.drawing.palette import DARK
from game.drawing.text import Type
from game.effects import NOTHING
from game.language import CODES, choose, tr
from game.levels import campaign
from game.overlay import notice as plate
from game.overlay.notice_words import Notice, notice, to_newcomer
from game.picture.display_list import DisplayList
from game.picture.notice import Around, add_notice
from game.picture.primitives import primitives
from game.rules import Controls, Phase, Ruleset, new_game, tick
from game.scene import scene_at, still

SIZE = (800, 600)


def test_what_a_level_teaches_is_said_before_its_first_serve_alone():
    """After a lost ball the notice says how many lives are left; a newcomer is told how one steers, too."""
    game = new_game(campaign(), 1, Ruleset())
    told = notice(game, "Space")
    assert (told.title, told.about) == (game.level.name, game.level.description)
    assert to_newcomer(told, "Left", "Right").about.splitlines() == [told.about, "Left, Right or the mouse: turn the paddles"]
    while game.lives == new_game(campaign(), 1, Ruleset()).lives or game.phase != Phase.SERVING:
        game = tick(game, Controls(turn=1, serve=True)).game
    told = notice(game, "Space")
    assert "left" in told.title
    assert to_newcomer(told, "Left", "Right").about == told.about == ""


@pytest.mark.parametrize("language", CODES)
@pytest.mark.parametrize("text_scale", [1.0, 2.0])
def test_the_plate_stays_above_the_wall_and_between_the_figures(language, text_scale):
    """Whatever is to be said, in large letters too, it takes at most a quarter of the height and two thirds of the width."""
    choose(language)
    longest = max([level.description for level in campaign()], key=lambda words: len(tr(words)))
    hint = tr("{key} or click: serve along the arrow").format(key=tr("Space"))
    told = to_newcomer(Notice("Ringe in Ringen", hint, tr(longest)), "Left", "Right")
    choose("en")
    surface = pygame.Surface(SIZE, 0, 32)
    canvas = Canvas(surface, Camera(400 + 300j, 28.0), DARK, Type(), SIZE[1] / 34.0 * text_scale)
    scene = scene_at(still(new_game(campaign(), 1, Ruleset())), 1.0, NOTHING)
    plate.draw(canvas, told, scene._replace(balls=()), layout(SIZE, 10.0))
    across, down = np.nonzero(pygame.surfarray.array3d(surface).any(axis=2))
    assert np.ptp(across) < SIZE[0] * 2 / 3
    assert down.max() < SIZE[1] / 4
    assert down.max() < 300.0 - 28.0 * max([ring.radius + ring.half_width for ring in campaign()[0].rings])
    assert np.ptp(down) > SIZE[1] / 12


def test_all_words_are_said_in_their_order():
    """The level's description is between its name and the hint, wrapped into lines."""
    out, told = (
        DisplayList(),
        Notice("Name", "Hint", "What it is about, in so many words that no line has room for all of them.\nSteer"),
    )
    add_notice(out, told, layout(SIZE, 10.0), DARK, 20.0, Around(150.0))
    name, *about, hint = out.texts
    assert (name, hint, about[-1]) == ("Name", "Hint", "Steer")
    assert " ".join(about[:-1]) == told.about.splitlines()[0]
    assert len(about) > 2


def test_the_plate_leaves_a_ball_alone():
    """It is at the lower edge while a ball is at the upper one."""
    tops = []
    for balls in ((), (400 + 40j,), (400 + 560j,)):
        out = DisplayList()
        add_notice(out, Notice("Name", "Hint"), layout(SIZE, 10.0), DARK, 20.0, Around(150.0, balls))
        tops.append(next(primitives(out.numbers))[3][1])
    assert tops[0] == tops[2] < SIZE[1] / 4 < tops[1]


@pytest.mark.parametrize("words", [level.description for level in campaign()[:6]] + ["Příliš žluťoučký kůň", "LEVEL 12 of 32"])
def test_words_are_as_wide_as_is_said_without_a_font(words):
    """The estimated width is at least the width on the screen, and less than a tenth above it."""
    for size in (14, 21, 40):
        drawn = Type().rendered(words, size, (255, 255, 255)).get_width()
        assert drawn <= size * width(words) + 1.0 < 1.1 * drawn + 2.0
