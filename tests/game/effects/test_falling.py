"""Stacks come down to where they belong, and nowhere further."""

from itertools import pairwise

import pytest

from game.drawing.palette import DARK
from game.effects.falling import FallingStack, after_hit, fallen
from game.picture.slots.contents import ContentKind, SlotContent
from game.picture.slots.parts import Slab, SlotShape, parts
from game.rules import TICK

SLOT = SlotShape(4.0, 0.4, 0.2, 6, 0.01)


def standing(layers, drop):
    """The slabs of a stack that are more than painted, from the lowest. drop: layers that it has still to fall."""
    pile = parts(SlotContent(ContentKind.BRICKS, layers), SLOT, drop, DARK)
    return [part for part in pile if isinstance(part, Slab) and part.top > part.bottom]


def fall(falling):
    """Every state until all are at rest."""
    states = [falling]
    while states[-1]:
        states.append(fallen(states[-1]))
        assert len(states) < 2000
    return states


def test_a_stack_settles_within_a_second_after_a_small_bounce():
    """It lands, rises again by less than a quarter of a layer, and comes to rest; it is never below the ground."""
    heights = [falling[0].height for falling in fall(after_hit((), 1, 2, 3))[:-1]]
    assert heights[0] == 1.0
    assert min(heights) == 0.0
    landed = heights.index(0.0)
    assert 0.02 < max(heights[landed:]) < 0.25
    assert len(heights) * TICK < 1.0


def test_a_second_hit_in_the_air_adds_a_layer_to_the_drop():
    """A stack that is hit while it falls keeps its speed and has one more layer to fall."""
    falling = after_hit((), 1, 2, 3)
    for _ in range(20):
        falling = fallen(falling)
    (before,) = falling
    (after,) = after_hit(falling, 1, 2, 2)
    assert after == FallingStack(1, 2, before.height + 1.0, before.speed)


def test_the_last_layer_leaves_nothing_to_fall():
    """In a slot that has become empty nothing falls any more; stacks in other slots go on falling."""
    falling = after_hit(after_hit((), 1, 2, 1), 1, 3, 4)
    assert after_hit(falling, 1, 2, 0) == (FallingStack(1, 3, 1.0, 0.0),)


@pytest.mark.parametrize("layers", [1, 2, 5])
def test_layers_of_a_falling_stack_stand_on_each_other(layers):
    """At every moment each layer begins where the one below ends; at rest the lowest begins at the ground."""
    for falling in fall(after_hit((), 1, 2, layers)):
        pile = standing(layers, falling[0].height if falling else 0.0)
        assert len(pile) == layers
        assert pile[0].bottom >= 0.0
        for low, high in pairwise(pile):
            assert high.bottom == pytest.approx(low.top)
            assert high.inset > low.inset
    assert pile[0].bottom == 0.0
    assert pile[-1].top == layers


def test_a_stack_begins_its_fall_as_what_was_above_the_layer_hit():
    """Heights, insets and colours of a stack of three that lost its lowest layer are those of its upper two."""
    assert standing(2, 1.0) == standing(3, 0.0)[1:]
