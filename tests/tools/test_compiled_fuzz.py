"""The compiled fuzzer: its geometry is the oracle's, its checks find what is wrong with a tick, and it finds nothing wrong."""

import re
import sys

import numpy as np
import pytest

from game.system.command_line import run
from physics import advance
from physics.batch.arrays import arrays_of
from tests.physics.batch.test_batch import rows
from tools.fuzz import campaign
from tools.fuzz.arenas import TICK, random_case
from tools.fuzz.checks import PENETRATION, first_fault
from tools.fuzz.commands import app
from tools.fuzz.compiled.campaign import _compiled, compiled_fuzzer, plain_fault, play_compiled, room_for
from tools.fuzz.compiled.checks import Before, Fault, gap_beside, overlap_time, tick_fault
from tools.fuzz.compiled.play import play_checked
from tools.fuzz.oracle import FINEST, LONGEST_WALK, first_overlap, ring_gap

pytestmark = pytest.mark.deep


def test_nothing_is_found_and_the_same_case_is_the_same(capsys, monkeypatch):
    """`python -m tools.fuzz --compiled --steps 1000000000` is the same at length. A game is the same without the compiler."""
    monkeypatch.setattr(campaign, "CASES_PER_TALLY", 2)
    assert run(app, "fuzz", ["--compiled", "--steps", "50000", "--seed", "12"]) == 0
    line = capsys.readouterr().out.splitlines()[-1]
    assert re.match(r"seed 12: 2 cases, \d+ ball-steps, \d+ hits, \d+ dropped .* 0 failed; done$", line)
    assert play_compiled(12, 3) == play_compiled(12, 3) != play_compiled(12, 4)


def played(case, play):
    """Room and result of some ticks of one game of a case."""
    arena, speed, _ = case
    room = room_for([arena], np.array([8], np.uint64))
    with np.errstate(over="ignore"):
        return room, play(*room, 0, 1, 60, TICK, speed, 100.0)


def test_plain_python_plays_a_game_with_the_same_bits():
    """So a fault of the compiled engine alone can be told from one of the physics."""
    for index in range(3):
        one, found = played(random_case(12, index), compiled_fuzzer().play)
        other, also = played(random_case(12, index), play_checked)
        assert found == also == (-1, -1, 0)
        assert one.tally.tolist() == other.tally.tolist()
        assert (one.games.positions == other.games.positions).all()
        assert (one.games.layers == other.games.layers).all()


def test_the_compiled_checks_find_a_fault(monkeypatch, capsys):
    """Exit code 1, the case to play again, that plain Python finds nothing. The checks get the end of a tick for its start."""
    genuine = compiled_fuzzer()

    def aliased(games, before, *others):
        """The position before a tick lies where the one after it is written."""
        return genuine.play(games, Before(games.positions[0], *before[1:]), *others)

    monkeypatch.setattr("tools.fuzz.compiled.campaign.compiled_fuzzer", lambda: genuine._replace(play=aliased))
    assert run(app, "fuzz", ["--compiled", "--steps", "1", "--seed", "12"]) == 1
    out = capsys.readouterr().out
    case = re.search(
        r"^case 12:(\d+) fails at tick 0: game 0: \w+ at tick 0; plain Python, which finds nothing, differs", out, re.MULTILINE
    )
    assert f"again: python -m tools.fuzz --case 12:{case[1]} --compiled" in out
    assert plain_fault(12, int(case[1]), 0) == (-1, Fault.NONE)


def test_without_numba_the_exit_code_is_3(monkeypatch, capsys):
    """The extra is named."""
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.setattr("tools.fuzz.compiled.campaign._compiled", _compiled.__wrapped__)
    assert run(app, "fuzz", ["--compiled"]) == 3
    assert "--compiled: physics.batch needs numba" in capsys.readouterr().err


def test_gaps_and_walks_are_those_of_the_oracle():
    """In arenas of every kind: to a hundredth of what is tolerated, and an overlap at the same step of the walk or none."""
    overlaps = 0
    for index in range(120):
        arena, speed, chance = random_case(5, index)
        for ring, alive in zip(arena.rings, arena.layers, strict=True):
            row, p = np.array(alive, np.int32), chance.uniform(0.0, ring.outer_radius * 1.2) * arena.balls[0].velocity / speed
            ball = arena.balls[0]._replace(position=p)
            r, v = ball.radius, ball.velocity
            assert gap_beside(p, r, ring, 0.01, row, -1) == pytest.approx(
                ring_gap(p, r, ring, 0.01, alive), abs=1e-11 * (r + ring.radius)
            )
            found = first_overlap(ball, ring, 0.0, TICK, alive, PENETRATION * r)
            time = overlap_time(p, v, r, ring, 0.0, TICK, row)
            step = 2.0 * FINEST * r / abs(v) + 2.0 * TICK / LONGEST_WALK
            assert time == (-1.0 if found is None else pytest.approx(found, abs=step))
            overlaps += found is not None
    assert overlaps > 40


def one_with_hits(least):
    """A tick of a random arena in which one ball has so many hits, and the next is calm: arena, step, speed."""
    for index in range(1000):
        arena, speed, _ = random_case(6, index)
        step = advance(arena._replace(balls=arena.balls[:1]), TICK, speed)
        if len(step.hits) >= least and not step.freed and not step.dropped and any(hit.layers >= 0 for hit in step.hits):
            return arena._replace(balls=arena.balls[:1]), step, speed
    raise AssertionError


def fault_of(arena, step, speed):
    """What the checks say of a tick."""
    room, after = room_for([arena], np.zeros(1, np.uint64)), arrays_of([step.arena])
    found = rows([step])
    for n, row in enumerate(found):
        room.rows.hits[n] = row
    return Fault(
        tick_fault(room.before, after, 0, room.rows.hits, len(found), TICK, speed, step.freed, step.dropped, room.work)
    )


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
    "a bounce in another direction": (Fault.BOUNCE, lambda s: with_first_hit(s, after=s.hits[0].after * (1.0 + 1e-6j))),
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
