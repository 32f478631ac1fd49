"""The light of a hit changes nothing but colours."""

import math

import numpy as np

from game.drawing.palette import DARK
from game.drawing.slots.contents import GLOW_STEPS, ContentKind, SlotContent
from game.drawing.slots.parts import SlotShape, parts
from game.drawing.solid.prisms import Cut, recoloured, ring_blocks

CUT = Cut(4.0, 0.4, math.radians(14.0), 8, math.radians(6.0), 0.45, 60.0, 0.002)
SHAPE = SlotShape(CUT.radius, CUT.half_width, CUT.half_angle, 4, 0.0)
KINDS = (ContentKind.STEEL, ContentKind.EMPTY, ContentKind.BUMPER, ContentKind.SHIELD, ContentKind.PADDLE)
RING = (*[SlotContent(kind) for kind in KINDS], SlotContent(ContentKind.BRICKS, 3), SlotContent(ContentKind.GROWING, 2, tint=1))


def piles(glows):
    """The parts in a ring's slots, with the light of hits. glows: of each slot."""
    lit = [content._replace(glow=glow) for content, glow in zip(RING, glows, strict=True)]
    return [(slot, parts(content, SHAPE, 0.0, DARK)) for slot, content in enumerate(lit)]


def test_blocks_in_other_colours_are_those_cut_anew():
    """Recoloured blocks equal newly computed ones: every content, every light, also if only some slots are lit."""
    dark = ring_blocks(CUT, piles([0] * len(RING)))
    for glow in range(1, GLOW_STEPS + 1):
        lit = piles([glow if slot % 3 else 0 for slot in range(len(RING))])
        cut = ring_blocks(CUT, lit)
        for field, recut, coloured in zip(cut._fields, cut, recoloured(dark, lit), strict=True):
            np.testing.assert_array_equal(recut, coloured, err_msg=field)
        assert (cut.colours != dark.colours).any()
