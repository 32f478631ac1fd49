"""What was hit, by pymunk's shapes and the level's numbers; and how a ring stands, by the recorded spins."""

import math
import random

import pytest

from game.levels import classic
from physics import PERMANENT, Arena, Ball, Feature, Ring, advance
from tests.support.crosscheck import what
from tools.crosscheck.comparisons.game import WantedChecks, checked_ticks
from tools.crosscheck.comparisons.phases import PhaseBook
from tools.crosscheck.comparisons.target import LayerBook
from tools.crosscheck.games.level_numbers import UNBREAKABLE, LevelNumbers, RingNumbers, numbers_of_arena, numbers_of_level
from tools.crosscheck.games.trajectory import Tick
from tools.crosscheck.pymunk_model.ring_model import Geometry
from tools.crosscheck.results.measurements import Comparison

DT = 1.0 / 60.0
RINGS = (Ring(5.0, 0.5, 0.3, 4), Ring(3.0, 0.5, 0.3, 4))


def one_hit(change=lambda hit: hit, layers=(2, 1, 1, 1)):
    """A ball on slot 0 of the outer ring, its hit changed; the layers left are those that the hit names."""
    arena = Arena((Ball(6.5 + 0j, -60.0 + 0j, 0.25),), RINGS, (layers, (1, 1, 1, 1)))
    step = advance(arena, DT, 60.0)
    hit = change(step.hits[0])
    left = [list(ring) for ring in arena.layers]
    left[hit.ring][hit.slot] = hit.layers
    step = step._replace(hits=(hit,), arena=step.arena._replace(layers=tuple(map(tuple, left))))
    tick = Tick(0, arena, DT, step, numbers_of_arena(arena, 60.0))
    return what(checked_ticks([tick], WantedChecks(64, "")).rows, Comparison.TARGET)


def test_a_right_hit_is_right():
    """Ring 0, slot 0, an outer face, one of two layers left; and an unbreakable sector stays as it is."""
    assert one_hit() == set()
    assert one_hit(layers=(PERMANENT, 1, 1, 1)) == set()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda hit: hit._replace(slot=1, layers=0), "the game names slot 1, pymunk touches slot 0"),
        (lambda hit: hit._replace(layers=0), "the game leaves no brick, the level's numbers 1 layers"),
        (lambda hit: hit._replace(layers=2), "the game leaves 2 layers, the level's numbers 1 layers"),
        (
            lambda hit: hit._replace(contact=hit.contact._replace(feature=Feature.CORNER)),
            "the game names a corner, pymunk an outer face",
        ),
    ],
)
def test_a_wrong_hit_is_said(change, said):
    """Slot, layers and feature, each in words."""
    assert any(said in line for line in one_hit(change))


def test_a_wrong_ring_is_said():
    """Two rings, one reaching farther out; the game names the other one, on which the ball has not come yet."""
    rings = (Ring(5.0, 0.5, 0.3, 4), Ring(5.2, 0.1, 0.3, 4))
    arena = Arena((Ball(6.5 + 0j, -60.0 + 0j, 0.7),), rings, ((1,) * 4, (1,) * 4))
    step = advance(arena, DT, 60.0)
    step = step._replace(hits=(step.hits[0]._replace(ring=1),), arena=step.arena._replace(layers=((1,) * 4, (0, 1, 1, 1))))
    rows = checked_ticks([Tick(0, arena, DT, step, numbers_of_arena(arena, 60.0))], WantedChecks(64, "")).rows
    assert "the game names ring 1, pymunk touches ring 0 first" in what(rows, Comparison.TARGET)


def test_layers_that_change_without_a_hit_are_noticed():
    """A brick that vanishes by itself: said with its ring and slot, once."""
    arena = Arena((Ball(8.0 + 0j, 60.0 + 0j, 0.25),), RINGS, ((1,) * 4, (1,) * 4))
    level = numbers_of_arena(arena, 60.0)
    ticks = []
    for number in range(4):
        step = advance(arena, DT, 60.0)
        if number == 1:
            step = step._replace(arena=step.arena._replace(layers=((1,) * 4, (1, 0, 1, 1))))
        ticks.append(Tick(number, arena, DT, step, level))
        arena = step.arena
    rows = checked_ticks(ticks, WantedChecks(64, "")).rows
    assert what(rows) == {"at the tick's end ring 1, slot 1 has no brick in the game, 1 layers by the hits"}
    assert rows.elsewhere == 1


def test_the_book_takes_layers_as_the_level_says():
    """One at a hit, none from what is unbreakable or empty."""
    geometry = Geometry(5.0, 0.5, 0.3, 4)
    book = LayerBook(LevelNumbers((RingNumbers(geometry, 0.0, None, 0.0, (3, 1, 0, UNBREAKABLE)),), 0.25, 8.0))
    assert [book.take_one(0, slot) for slot in (0, 0, 1, 2, 3)] == [2, 1, 0, 0, UNBREAKABLE]
    assert book.differs_from([(1, 0, 0, UNBREAKABLE)]) is None
    assert book.differs_from([(1, 1, 0, UNBREAKABLE)]) == "ring 0, slot 1 has 1 layers in the game, no brick by the hits"


@pytest.mark.parametrize("level", classic(), ids=lambda level: level.name)
def test_a_levels_numbers_are_those_of_its_arena(level):
    """Read from the file's degrees, without the game's rings: sizes, friction and spins to the bit, phases to rounding."""
    arena = level.arena()
    numbers = numbers_of_level(level)
    assert (numbers.ball_radius, numbers.speed) == (level.ball.radius, level.ball.speed)
    for index, (ring, own, layers) in enumerate(zip(arena.rings, numbers.rings, arena.layers, strict=True)):
        assert tuple(own.geometry) == ring[:4]
        assert (own.friction, own.layers) == (ring.friction, layers)
        assert own.spin == (ring.spin if index else None)
        assert abs(math.remainder(own.phase - ring.phase, math.tau)) < 1e-15


def turned(spins, ticks_each, drift=0.0):
    """The difference after turning a ring of paddles with these spins, and one of bricks with one, and their bounds."""
    paddles, bricks = Ring(9.0, 0.2, 0.3, 3, phase=1.0), Ring(5.0, 0.5, 0.3, 4, phase=2.0, spin=-0.7)
    arena = Arena((Ball(0j, 1.0 + 0j, 0.1),), (paddles, bricks), ((PERMANENT,) * 3, (1,) * 4))
    book = PhaseBook(numbers_of_arena(arena, 8.0), 1.0 / 240.0)
    for spin in spins:
        paddles = paddles._replace(spin=spin)
        for _ in range(ticks_each):
            book.turn((paddles, bricks))
            paddles, bricks = paddles.turned((1.0 + drift) / 240.0), bricks.turned((1.0 + drift) / 240.0)
    return [book.difference(0, paddles.phase), book.difference(1, bricks.phase)]


def test_phases_are_rebuilt_to_rounding():
    """20,000 ticks with 2,000 spins: within the bound, which is far below a millionth of a degree."""
    chance = random.Random(2)
    for error, bound in turned([chance.uniform(-0.9, 0.9) for _ in range(2000)], 10):
        assert error <= bound < 1e-10


def test_a_drift_of_a_millionth_of_a_millionth_a_tick_shows():
    """A ring that turns too far by a thousand-millionth leaves the bound."""
    for error, bound in turned([0.8], 4000, drift=1e-9):
        assert error > 100.0 * bound


def test_only_the_paddles_may_change_their_spin():
    """A ring of bricks that turns otherwise than its level says is none of that level."""
    arena = Arena((Ball(0j, 1.0 + 0j, 0.1),), (RINGS[0], RINGS[1]._replace(spin=0.5)), ((1,) * 4, (1,) * 4))
    book = PhaseBook(numbers_of_arena(arena, 8.0), 1.0 / 240.0)
    assert [book.is_the_levels(0, 3.0), book.is_the_levels(1, 0.5), book.is_the_levels(1, 0.4999)] == [True, True, False]
