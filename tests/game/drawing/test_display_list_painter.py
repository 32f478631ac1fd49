"""Lists of primitives on a surface: shapes cover what they say, and lists are read as they were written."""

import cmath
import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.drawing.camera import Camera
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.text import Type
from game.picture.display_list import DisplayList, Sector
from game.picture.primitives import Primitive, packed, primitives, unpacked

SIDE, FINER = 200, 8
MIDDLE = 100.3 + 100.7j
WHITE, GREY = (255, 255, 255), (90, 90, 90)
SECTOR = Sector(0j, (1.0, 2.0), 0.0, 0.1)
AROUND = [cmath.rect(1.0, math.tau * k / 120) for k in range(121)]


def painted(picture, background=(0, 0, 0), painter=None):
    """A list on a square surface, as an array of colours."""
    surface = pygame.Surface((SIDE, SIDE), 0, 32)
    surface.fill(background)
    (painter or DisplayListPainter()).paint(surface, Type(), picture)
    return pygame.surfarray.array3d(surface).astype(np.float64)


def covered(inside):
    """The share of every pixel that lies within a shape. inside: of complex points, whether the shape has them."""
    at = (np.arange(SIDE * FINER) + 0.5) / FINER
    return inside(at[:, None] + 1j * at[None, :]).reshape(SIDE, FINER, SIDE, FINER).mean(axis=(1, 3))


def a_strip(outer, inner):
    """A circle's line."""
    out = DisplayList()
    out.strip([MIDDLE + point * outer for point in AROUND], [MIDDLE + point * inner for point in AROUND], WHITE)
    return out


def a_band(width):
    """A band around a corner."""
    out = DisplayList()
    out.band([(pixel, width, WHITE) for pixel in (30 + 40j, 120 + 50j, 140 + 150j)])
    return out


def of_a_band(width):
    """Whether points lie in it: near one of its two lines, its beginning and its corner."""

    def inside(points):
        near = np.zeros(points.shape, bool)
        for start, end in ((30 + 40j, 120 + 50j), (120 + 50j, 140 + 150j)):
            along = (points - start) / (end - start)
            near |= (np.abs(along.imag) * abs(end - start) < width) & (along.real > 0.0) & (along.real < 1.0)
        return near | (np.minimum(np.abs(points - (30 + 40j)), np.abs(points - (120 + 50j))) < width)

    return inside


@pytest.mark.parametrize(
    ("picture", "inside", "least"),
    [
        (a_strip(70.0, 64.0), lambda points: np.abs(np.abs(points - MIDDLE) - 67.0) < 3.0, 0.05),
        (a_strip(50.0, 49.0), lambda points: np.abs(np.abs(points - MIDDLE) - 49.5) < 0.5, 0.25),
        (a_band(9.0), of_a_band(9.0), 0.08),
    ],
    ids=["a strip", "a thin strip", "a band"],
)
def test_shapes_cover_what_they_say(picture, inside, least):
    """Pixels are covered to the share that lies within, on average to a few hundredths, and none within is left bare."""
    got, exact = painted(picture)[:, :, 0] / 255.0, covered(inside)
    off = np.abs(got - exact)[(got > 0.0) | (exact > 0.0)]
    assert off.mean() < least
    assert got[exact > 0.99].min(initial=1.0) > 0.6
    assert (got[exact == 0.0] > 0.6).sum() < 20


@pytest.mark.parametrize("multiplies", [False, True])
@pytest.mark.parametrize("wide", [60, 39])
def test_light_is_brightest_in_its_middle_and_ends_at_its_edge(wide, multiplies):
    """It adds its colour, or takes the others away, symmetrically and only within its ellipse."""
    out, ground = DisplayList(), WHITE if multiplies else GREY
    out.glow(100 + 100j, (wide, wide / 2), (200, 100, 0), 0.5, multiplies=multiplies)
    change = painted(out, ground) - ground[0]
    assert change[100, 100] == pytest.approx([-28, -78, -128] if multiplies else [100, 50, 0], abs=5)
    assert np.abs(change - change[::-1]).max() <= 8.0
    off = np.arange(SIDE) + 0.5 - 100
    away = np.hypot(off[:, None] / wide, off[None, :] * 2 / wide)
    assert np.abs(change[away > 1.05]).max() == 0.0
    assert (np.diff(np.abs(change[100 : 100 + wide, 100, 1])) <= 0.0).all()


def test_light_beyond_the_edge_is_cut_off():
    """What is seen of it looks as it does in the middle of a surface, to a few steps; one that is not seen changes nothing."""
    whole, cut, unseen = DisplayList(), DisplayList(), DisplayList()
    whole.glow(100 + 100j, (90.0, 60.0), (200, 100, 0), 0.5)
    cut.glow(30 + 190j, (90.0, 60.0), (200, 100, 0), 0.5)
    unseen.glow(500 + 100j, (90.0, 60.0), (200, 100, 0), 0.5)
    assert np.abs(painted(cut)[:120, 130:] - painted(whole)[70:190, 40:110]).max() <= 4.0
    assert painted(unseen).max() == 0.0


def test_a_sprite_is_its_polygons_about_a_pixel():
    """Anywhere it looks the same, and it covers what its polygons cover."""
    chip, out = DisplayList(), DisplayList()
    chip.polygon([point * 20.0 for point in AROUND], WHITE)
    out.sprite(60 + 60j, 21.0, chip)
    out.sprite(140 + 130j, 21.0, chip)
    picture = painted(out)[:, :, 0] / 255.0
    off = picture - covered(lambda at: np.minimum(np.abs(at - 60 - 60j), np.abs(at - 140 - 130j)) < 20.0)
    assert np.abs(off).max() < 0.35
    assert abs(off.sum()) < 60.0
    assert (picture[39:81, 39:81] == picture[119:161, 109:151]).all()


def test_a_plate_is_around_its_words():
    """It is as much wider and higher as it says, and has an edge."""
    words, out = Type().rendered("+100", 30.0, WHITE), DisplayList()
    out.plate("+100", 30.0, 100 + 100j, GREY, (12.0, 5.0), (2.0, WHITE))
    drawn = painted(out).max(axis=2) > 0.0
    width, height = words.get_size()
    assert drawn.any(axis=1).sum() == pytest.approx(width + 24, abs=1)
    assert drawn.any(axis=0).sum() == pytest.approx(height + 10, abs=1)
    assert tuple(painted(out)[100, 100]) == GREY


def test_words_and_their_plate_fade_together():
    """At half opacity both are halfway to what is below; opaque words afterwards look as if nothing had faded."""
    painter, letters, pictures = DisplayListPainter(), Type(), []
    for opacity in (1.0, 0.5, 1.0):
        picture = DisplayList()
        picture.plate("Wide", 60.0, MIDDLE, GREY, (10.0, 4.0), (2.0, GREY), opacity)
        picture.text("Wide", 60.0, MIDDLE, WHITE, opacity=opacity)
        surface = pygame.Surface((SIDE, SIDE), 0, 32)
        painter.paint(surface, letters, picture)
        pictures.append(pygame.surfarray.array3d(surface).astype(np.float64))
    opaque, faded, again = pictures
    assert np.array_equal(opaque, again)
    plate = (opaque == GREY[0]).all(axis=2)
    assert plate.sum() > 500
    assert np.abs(faded[plate] - GREY[0] / 2.0).max() <= 2.0
    words = (opaque > 250.0).all(axis=2)
    assert words.sum() > 20
    assert np.abs(faded[words] - (255.0 + GREY[0] / 2.0) / 2.0).max() <= 5.0


def test_a_list_is_read_as_it_was_written():
    """Every method adds the one primitive that its name says, with as many numbers as are read."""
    out = DisplayList()
    chip = DisplayList()
    chip.disc(0j, 1.0, WHITE)
    out.disc(0j, 1.0, (255, 254, 253))
    out.circle(0j, 1.0, 1.0, GREY)
    out.sector(SECTOR, 0.1, GREY)
    out.polygon((0j, 1 + 0j, 1j), GREY)
    out.line((0j, 1 + 0j), 1.0, GREY)
    out.text("x", 9.0, 0j, GREY)
    out.glow(0j, (1.0, 1.0), GREY, 0.5)
    out.fill(GREY)
    out.cells(0j, 2 + 2j, 2, [GREY, WHITE, GREY, WHITE])
    out.clip(0j, 1 + 1j)
    out.turn(0j, 1.0)
    out.strip((0j, 1 + 0j), (1j, 1 + 1j), GREY)
    out.band([(0j, 1.0, GREY), (1 + 0j, 1.0, WHITE)])
    out.plate("x", 9.0, 0j, GREY, (1.0, 1.0), (1.0, WHITE))
    out.sprite(0j, 1.0, chip)
    out.camera(Camera(0j, 1.0), 1j, (0.4, 0.8), 0.5j)
    out.slot(1.0)
    out.prism((0j, 1j, 1 + 0j), 0.0, 1.0, GREY)
    out.shadows((0j, 1j, 1 + 0j), [(0.25, 0.0, 1.0), (0.5, 1.0, 2.0)], 0.5)
    out.box(0j, 4 + 2j, 1.0, GREY, (1.0, WHITE))
    out.texture(1, 2, [GREY, WHITE, GREY, WHITE])
    out.textured(0j, 1.0, 1)
    out.foot(SECTOR, 0.2, 0.1, 0.5)
    out.relief(SECTOR, 0.1, 0.3, 0.2, 0.1, 0.5)
    out.cast(SECTOR, 0.1, 0.2, 0.1, 0.5)
    out.bar(0j, 0.0, (1.0, 0.0, 2.0, 0.1), 0.1, GREY)
    out.ground_disc(0.0, 1.0, [(0.0, 0.5, 1.0), (2.0, 2.5, 3.0)])
    out.ground_circle(1.0, 0.1, GREY)
    out.ground_side(1.0, 0.1, GREY)
    out.ground_mark((0j, 1j, 1 + 0j), GREY)
    found = list(primitives(out.numbers))
    assert [code for code, *_ in found] == list(Primitive)
    assert unpacked(found[0][1]) == (255, 254, 253)
    assert found[Primitive.SPRITE - 1][3][4:] == chip.numbers
    assert list(found[Primitive.SHADOWS - 1][3][-6:]) == [0.25, 0.0, 1.0, 0.5, 1.0, 2.0]
    assert packed(GREY) == found[1][1]


def test_what_only_a_canvas_paints_is_refused():
    """A mark of the ground, which the desktop paints elsewhere, is not painted as anything else."""
    out = DisplayList()
    out.ground_mark((0j, 1j, 1 + 0j), GREY)
    with pytest.raises(ValueError, match="does not paint GROUND_MARK"):
        painted(out)
