"""What stands in a slot has one description, and both views keep to it."""

import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

from itertools import pairwise

import numpy as np
import pygame
import pytest

from game.drawing.flat.sample import brick_sample
from game.drawing.flat.sector_colours import PolarPixels, paint_slot
from game.drawing.palette import DARK, LIGHT, layer_colour
from game.effects import Flash
from game.picture.display_list import DisplayList
from game.picture.slots.contents import (
    GLOW_STEPS,
    ContentKind,
    SlotContent,
    resting_contents,
    wall_contents,
)
from game.picture.slots.parts import Bar, Slab, SlotShape, height, parts
from physics import PERMANENT

SHAPE = SlotShape(5.0, 0.6, 0.3, 6, 0.0)
CONTENTS = [
    SlotContent(ContentKind.PADDLE),
    SlotContent(ContentKind.STEEL),
    SlotContent(ContentKind.BUMPER),
    SlotContent(ContentKind.SHIELD, 1),
    *[SlotContent(ContentKind.GROWING, layers) for layers in (1, 3)],
    *[SlotContent(ContentKind.BRICKS, layers) for layers in range(1, 10)],
]
EVERY = pytest.mark.parametrize("content", CONTENTS)


@EVERY
def test_the_height_of_a_content_is_the_top_of_its_parts(content):
    """What hides debris is as high as what is drawn; no part is higher, and slabs stand on each other without a gap."""
    pile = parts(content, SHAPE, 0.0, DARK)
    assert height(content) == max(part.top for part in pile)
    raised = [part for part in pile if isinstance(part, Slab) and part.top > part.bottom]
    assert [slab.bottom for slab in raised] == [0.0, *[slab.top for slab in raised[:-1]]]


def test_nothing_stands_in_an_empty_slot():
    """It has no parts and no height."""
    assert parts(SlotContent(ContentKind.EMPTY), SHAPE, 0.0, DARK) == ()
    assert height(SlotContent(ContentKind.EMPTY)) == 0.0


@EVERY
@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_a_glow_lights_up_the_top_and_changes_no_shape(content, theme):
    """At full glow the highest slab is nearer to the flash's colour, and every part is where it was."""
    plain, lit = (parts(content._replace(glow=glow), SHAPE, 0.0, theme) for glow in (0, GLOW_STEPS))
    assert [part._replace(colour=DARK.text) for part in plain] == [part._replace(colour=DARK.text) for part in lit]
    tops = [[part for part in pile if isinstance(part, Slab)][-1].colour for pile in (plain, lit)]
    away = [max(abs(one - other) for one, other in zip(top, theme.flash, strict=True)) for top in tops]
    assert away[1] <= 0.3 * away[0]


def test_a_line_is_never_thinner_than_asked_for():
    """On a slot of few pixels the lines on steel and a paddle's edge are as wide as a pixel."""
    small = SHAPE._replace(finest=0.2)
    frame, within = parts(SlotContent(ContentKind.STEEL), small, 0.0, DARK)[1:3]
    assert within.inset - frame.inset == pytest.approx(0.2)
    assert all(bar.half_width >= 0.1 for bar in parts(SlotContent(ContentKind.STEEL), small, 0.0, DARK)[3:])
    assert parts(SlotContent(ContentKind.PADDLE), SHAPE._replace(finest=0.5), 0.0, DARK)[1].inset == 0.5


def test_the_bars_on_steel_go_from_side_to_side_and_meet():
    """Each ends where the next begins, on the inner and the outer side in turn, and none leaves the frame."""
    bars = [part for part in parts(SlotContent(ContentKind.STEEL), SHAPE, 0.0, DARK) if isinstance(part, Bar)]
    assert len(bars) >= 2
    for k, (one, other) in enumerate(pairwise(bars)):
        shared = (one.outer, other.outer) if k % 2 == 0 else (one.inner, other.inner)
        assert shared[0] == pytest.approx(shared[1])
    for bar in bars:
        for radius, angle in (bar.inner, bar.outer):
            assert abs(radius - SHAPE.radius) < SHAPE.half_width
            assert abs(angle) < SHAPE.half_angle


def test_contents_follow_layers_and_flashes():
    """Paddles are paddles whatever their layers; a flash lights its slot, and leaves a light where a brick has gone."""
    layers = ((PERMANENT,) * 3, (0, 2, PERMANENT))
    paddles, wall = resting_contents(layers)
    assert {content.kind for content in paddles} == {ContentKind.PADDLE}
    assert [content.kind for content in wall] == [ContentKind.EMPTY, ContentKind.BRICKS, ContentKind.STEEL]
    gone, struck, _ = wall_contents(layers[1], [Flash(1, 0, 0, 0.5), Flash(1, 1, 2, 0.0)])
    assert gone == SlotContent(ContentKind.GHOST, 0, GLOW_STEPS // 2)
    assert struck == SlotContent(ContentKind.BRICKS, 2, GLOW_STEPS)


@pytest.mark.parametrize("layers", [1, 6, PERMANENT])
@pytest.mark.parametrize("size", [(94, 47), (1, 1), (16, 8), (95, 48)])
def test_a_sample_is_a_brick_on_a_card(layers, size):
    """The card has the panel's colour in its corners, the brick its own in the middle; it is the same left and right."""
    card = brick_sample(size, size[0] / 2.0, layers, LIGHT)
    assert card.get_size() == size
    picture = pygame.surfarray.array3d(card).astype(int)
    assert np.abs(picture - picture[::-1]).max() <= 1 or layers == PERMANENT
    if size[0] > 90:
        assert tuple(card.get_at((0, size[1] - 1)))[:3] == LIGHT.panel
        if layers == 1:
            assert tuple(card.get_at((size[0] // 2, size[1] // 2)))[:3] == layer_colour(LIGHT, 1)


@pytest.mark.parametrize("lean", [0.02, 0.05, 0.12])
def test_a_bar_covers_its_area_with_smooth_edges(lean):
    """However much it leans, its cover adds up to its area, and the pixels that it covers in part are those of its edges."""
    scale, bar = 100.0, DisplayList()
    bar.bar(0j, 0.0, (4.8 * scale, -lean, 5.2 * scale, lean), 0.06 * scale, (255, 255, 255))
    x, y = np.meshgrid(np.arange(200) + 0.5 - 100.0, np.arange(100) + 0.5 + 450.0)
    radius, angle = np.hypot(x, y).astype(np.float32).ravel(), np.arctan2(x, y).astype(np.float32).ravel()
    picture = np.zeros((3, radius.size), dtype=np.float32)
    paint_slot(picture, bar, PolarPixels(radius, angle))
    cover = picture[0] / 255.0
    assert cover.sum() == pytest.approx(0.12 * 0.4 * scale**2, rel=0.02)
    edges = 2.0 * (math.hypot(0.4, 2.0 * lean * 5.0) + 0.12) * scale
    assert 0.8 * edges < ((cover > 0.01) & (cover < 0.99)).sum() < 1.6 * edges


def test_bars_on_steel_are_equally_thick_on_every_slot():
    """Measured across a bar, not along the arc: however flat the zigzag is, its lines are as thick."""
    thick = []
    for shape in (SHAPE, SHAPE._replace(half_angle=0.15), SHAPE._replace(half_width=0.2), SHAPE._replace(radius=3.0)):
        for bar in [part for part in parts(SlotContent(ContentKind.STEEL), shape, 0.0, DARK) if isinstance(part, Bar)]:
            lean = (bar.outer[1] - bar.inner[1]) * shape.radius / (bar.outer[0] - bar.inner[0])
            thick.append(2.0 * bar.half_width / math.hypot(1.0, lean))
    assert len(thick) > 8
    assert thick == pytest.approx([thick[0]] * len(thick))
