"""The compiled fuzzer: its geometry is the oracle's, its checks find what is wrong with a tick, and it finds nothing wrong."""

import re

import numpy as np
import pytest

from game.system.command_line import run
from physics import advance
from physics.batch.arrays import arrays_of
from physics.batch.hits import HIT
from physics.tolerances import MAX_IMPACTS
from tests.physics.test_batch import rows
from tools.fuzz import campaign
from tools.fuzz.arenas import TICK, random_case
from tools.fuzz.checks import PENETRATION, first_fault
from tools.fuzz.commands import app
from tools.fuzz.compiled.campaign import compiled_fuzzer, play_compiled, room_for
from tools.fuzz.compiled.checks import Fault
from tools.fuzz.oracle import first_overlap, ring_gap


def test_nothing_is_found_and_the_same_case_is_the_same(capsys, monkeypatch):
    """`python -m tools.fuzz --compiled --steps 1000000000` is the same at length."""
    monkeypatch.setattr(campaign, "CASES_PER_TALLY", 2)
    assert run(app, "fuzz", ["--compiled", "--steps", "50000", "--seed", "12"]) == 0
    line = capsys.readouterr().out.splitlines()[-1]
    assert re.match(r"seed 12: 2 cases, \d+ ball-steps, \d+ hits, \d+ dropped .* 0 failed; done$", line)
    assert play_compiled(12, 3) == play_compiled(12, 3) != play_compiled(12, 4)


def test_gaps_and_walks_are_those_of_the_oracle():
    """In arenas of every kind: to a hundredth of what is tolerated, and the same first overlap or none."""
    compiled, overlaps = compiled_fuzzer(), 0
    for index in range(60):
        arena, speed, chance = random_case(5, index)
        for ring, alive in zip(arena.rings, arena.layers, strict=True):
            row, p = np.array(alive, np.int32), chance.uniform(0.0, ring.outer_radius * 1.2) * arena.balls[0].velocity / speed
            ball = arena.balls[0]._replace(position=p)
            ours, theirs = compiled.gap(p, ball.radius, ring, 0.01, row, -1), ring_gap(p, ball.radius, ring, 0.01, alive)
            assert ours == pytest.approx(theirs, abs=1e-11 * (ball.radius + ring.radius))
            found = first_overlap(ball, ring, 0.0, TICK, alive, PENETRATION * ball.radius)
            time = compiled.overlap(p, ball.velocity, ball.radius, ring, 0.0, TICK, row)
            assert time == (-1.0 if found is None else pytest.approx(found, abs=1e-6 * TICK))
            overlaps += found is not None
    assert overlaps > 20


def one_with_hits(least):
    """A tick of a random arena in which one ball has so many hits, and the next is calm: arena, step, speed."""
    for index in range(1000):
        arena, speed, _ = random_case(6, index)
        step = advance(arena._replace(balls=arena.balls[:1]), TICK, speed)
        if len(step.hits) >= least and not step.freed and not step.dropped and any(hit.layers >= 0 for hit in step.hits):
            return arena._replace(balls=arena.balls[:1]), step, speed
    raise AssertionError


def fault_of(arena, step, speed):
    """What the compiled checks say of a tick."""
    before, after = arrays_of([arena]), arrays_of([step.arena])
    start = room_for(before)
    start.positions[:], start.velocities[:] = before.positions[0], before.velocities[0]
    start.phases[:], start.spins[:], start.layers[:] = before.phases[0], before.spins[0], before.layers[0]
    hits = np.zeros(2 * MAX_IMPACTS, HIT)
    found = rows([step._replace(hits=step.hits)])
    for n, row in enumerate(found):
        hits[n] = row
    arguments = len(found), TICK, speed, step.freed, step.dropped, np.zeros_like(start.layers)
    return Fault(compiled_fuzzer().fault(start, after, 0, hits, *arguments))


def with_ball(step, **fields):
    """The step with another ball at its end."""
    return step._replace(arena=step.arena._replace(balls=(step.arena.balls[0]._replace(**fields),)))


def with_first_hit(step, **fields):
    """The step with another first hit."""
    return step._replace(hits=(step.hits[0]._replace(**fields), *step.hits[1:]))


WRONG = {
    "a faster ball": (Fault.NUMBERS, lambda s: with_ball(s, velocity=s.arena.balls[0].velocity * 1.001)),
    "another place": (Fault.END, lambda s: with_ball(s, position=s.arena.balls[0].position * (1.0 + 1e-7))),
    "a ring that turned too far": (
        Fault.RINGS,
        lambda s: s._replace(arena=s.arena._replace(rings=(s.arena.rings[0]._replace(phase=1.0), *s.arena.rings[1:]))),
    ),
    "a hit that is kept back": (Fault.LAYERS, lambda s: s._replace(hits=tuple(h for h in s.hits if h.layers < 0))),
    "hits in another order": (Fault.LAYERS, lambda s: s._replace(hits=s.hits[::-1])),
    "a late hit": (Fault.FLIGHT, lambda s: with_first_hit(s, time=(s.hits[0].time + s.hits[1].time) / 2.0)),
    "a wrong normal": (
        Fault.HIT,
        lambda s: with_first_hit(s, contact=s.hits[0].contact._replace(normal=s.hits[0].contact.normal * (1.0 + 1e-6j))),
    ),
    "a ball that was freed from nothing": (Fault.FREED, lambda s: s._replace(freed=1)),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_wrong_with_a_tick_is_found(wrong):
    """By the compiled checks, under its name, and by the plain ones; the tick as it was is faultless to both."""
    arena, step, speed = one_with_hits(2)
    assert fault_of(arena, step, speed) is Fault.NONE
    assert first_fault(arena, step, TICK, speed) is None
    expected, change = WRONG[wrong]
    changed = change(step)
    assert fault_of(arena, changed, speed) is expected
    assert first_fault(arena, changed, TICK, speed) is not None
