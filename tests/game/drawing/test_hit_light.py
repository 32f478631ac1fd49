"""The light of a hit changes nothing but colours."""

import math

import numpy as np

from game.drawing.palette import DARK
from game.drawing.solid.blocks import recoloured, ring_blocks
from game.picture.slots.contents import GLOW_STEPS, ContentKind, SlotContent
from game.picture.slots.parts import SlotShape
from game.picture.solid.prisms import slot_division
from game.picture.solid.rings import SolidRing, ring_prisms

SHAPE = SlotShape(4.0, 0.4, math.radians(14.0), 4, 0.0)
KINDS = (ContentKind.STEEL, ContentKind.EMPTY, ContentKind.BUMPER, ContentKind.SHIELD, ContentKind.PADDLE)
RING = (*[SlotContent(kind) for kind in KINDS], SlotContent(ContentKind.BRICKS, 3), SlotContent(ContentKind.GROWING, 2, tint=1))


def lit(glows):
    """The prisms of a ring, with the light of hits. glows: of each slot."""
    contents = tuple([content._replace(glow=glow) for content, glow in zip(RING, glows, strict=True)])
    division = slot_division(SHAPE, math.radians(6.0), 60.0, 0.002)
    return ring_prisms(SolidRing(contents, SHAPE, division, (), 0.45, DARK))


def test_blocks_in_other_colours_are_those_cut_anew():
    """Recoloured blocks equal newly computed ones: every content, every light, also if only some slots are lit."""
    dark = ring_blocks(lit([0] * len(RING)))
    for glow in range(1, GLOW_STEPS + 1):
        ring = lit([glow if slot % 3 else 0 for slot in range(len(RING))])
        cut = ring_blocks(ring)
        for field, recut, coloured in zip(cut._fields, cut, recoloured(dark, ring), strict=True):
            np.testing.assert_array_equal(recut, coloured, err_msg=field)
        assert (cut.colours != dark.colours).any()
