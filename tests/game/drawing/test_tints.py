"""A ring's tint moves the colours of its bricks along the palette, in every view and in what flies off them."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import msgspec

from game.drawing.palette import DARK, layer_colour
from game.effects import NOTHING, bursts, lights
from game.effects.kinds import EffectKind
from game.levels import checked
from game.picture.slots.contents import ContentKind, resting_contents, slot_contents
from game.picture.slots.parts import Slab, SlotShape, parts
from game.rules import EventKind
from game.scene import scene_at, still
from tests.support.games.arcade import LEVEL, arcade, until, with_balls

SHAPE = SlotShape(5.0, 0.6, 0.3, 6, 0.0)


def tinted(tint):
    """The test level, its rings with a tint."""
    rings = [msgspec.structs.replace(ring, tint=tint) for ring in LEVEL.rings]
    return checked(msgspec.structs.replace(LEVEL, rings=rings), "level")


def test_a_list_of_tints_is_repeated_around_the_ring():
    """The paddles and the shield have none; what rests is tinted as what glows."""
    scene = scene_at(still(arcade(tinted([4, 0, 1]))), 1.0, NOTHING)
    contents = slot_contents(scene)
    assert [content.tint for content in contents[1]] == [(4, 0, 1)[slot % 3] for slot in range(len(contents[1]))]
    assert {content.tint for k in (0, scene.shield) for content in contents[k]} == {0}
    assert resting_contents(scene.layers, scene.tints)[1] == contents[1]


def test_the_layers_of_a_tinted_stack_have_the_next_colours():
    """A stack of two with tint 3 has the colours of the fourth and the fifth layer; the dots and the height stay."""
    brick = next(content for content in slot_contents(scene_at(still(arcade(tinted(3))), 1.0, NOTHING))[1] if content.layers)
    slabs = [part for part in parts(brick._replace(layers=2), SHAPE, 0.0, DARK) if isinstance(part, Slab)]
    assert brick.kind is ContentKind.BRICKS
    assert [slab.colour for slab in slabs] == [layer_colour(DARK, 4), layer_colour(DARK, 5)]
    plain = parts(brick._replace(layers=2, tint=0), SHAPE, 0.0, DARK)
    assert [part.top for part in plain] == [part.top for part in parts(brick._replace(layers=2), SHAPE, 0.0, DARK)]


def test_shards_and_light_have_the_colour_of_the_tinted_brick():
    """A hit throws both, of the layer that it took."""
    for tint in (0, 5):
        done = until(with_balls(arcade(tinted(tint)), (4.0 + 0.0j, -1.0 + 0.0j)), EventKind.BRICK_HIT, 60)
        layer = next(event.hit.layers for event in done.events if event.kind == EventKind.BRICK_HIT) + 1 + tint
        assert [burst.layer for burst in bursts.after_tick((), done, frozenset(EffectKind))] == [layer]
        assert [light.layer for light in lights.after_tick((), done)] == [layer]


def test_a_tint_decides_nothing():
    """It leaves a level without one its hash, and another one gives a level another hash, so that records tell them apart."""
    assert tinted(0).content_hash() == LEVEL.content_hash() != tinted(3).content_hash()
