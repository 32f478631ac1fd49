"""The compiled batch is the scalar engine, to the bit, at every tick: state, hits, balls dropped and freed."""

import math
import re
import subprocess
import sys
from random import Random

import numpy as np
import pytest

from physics import PERMANENT, Arena, Ball, Ring, advance
from physics.batch import Batch, compiled
from tests.support.paths import ROOT
from tools.fuzz.arenas import TICK, random_case, served

pytestmark = pytest.mark.deep

pytest.importorskip("numba", reason="the batch needs the extra [batch]")

CASES = 40
GAMES = 4
TICKS = 250


def bits(values):
    """The bits of an array of floats, with one zero: the hash of a game knows no sign of zero either."""
    return np.ascontiguousarray(np.asarray(values) + 0.0).view(np.int64)


def assert_same(batch, arenas):
    """Every game of a batch has the bits of its arena."""
    assert (bits(batch.positions) == bits([[ball.position for ball in arena.balls] for arena in arenas])).all()
    assert (bits(batch.velocities) == bits([[ball.velocity for ball in arena.balls] for arena in arenas])).all()
    assert (bits(batch.phases) == bits([[ring.phase for ring in arena.rings] for arena in arenas])).all()
    for g, arena in enumerate(arenas):
        for k, row in enumerate(arena.layers):
            assert tuple(batch.layers[g, k, : len(row)]) == row


def rows(steps, tick=0):
    """The hits of scalar steps, one for every game, as the batch writes them."""
    return [
        (
            *(g, tick, hit.time, hit.ball, hit.ring, hit.slot, hit.layers, hit.contact.feature.value, hit.contact.gap),
            *(hit.contact.normal, hit.contact.point, hit.before, hit.after),
        )
        for g, step in enumerate(steps)
        for hit in step.hits
    ]


def games_of_one_shape(case, chance):
    """Games with the rings of one fuzz case, their balls elsewhere, some of them inside material, their bricks others."""
    arenas = []
    for _ in range(GAMES):
        arena = case.arena
        edge = max(ring.outer_radius for ring in arena.rings)
        for i, ball in enumerate(arena.balls):
            arena = served(arena, i, ball.radius, case.speed, chance)
            if chance.random() < 0.4:
                position = complex(chance.uniform(-edge, edge), chance.uniform(-edge, edge))
                balls = (*arena.balls[:i], arena.balls[i]._replace(position=position), *arena.balls[i + 1 :])
                arena = arena._replace(balls=balls)
        rings = tuple([ring._replace(phase=chance.uniform(0.0, math.tau)) for ring in arena.rings])
        layers = tuple([tuple([chance.choice((left, left, 0, 3)) for left in row]) for row in arena.layers])
        arenas.append(Arena(arena.balls, rings, layers))
    return arenas


def steered(arena, spins):
    """The arena with these spins, as the rules set them: a ring whose spin stays is the same value."""
    pairs = zip(arena.rings, spins, strict=True)
    rings = [ring if ring.spin == spin else ring.steered(float(spin)) for ring, spin in pairs]
    changed = any(new is not old for new, old in zip(rings, arena.rings, strict=True))
    return arena._replace(rings=tuple(rings)) if changed else arena


def random_spins(batch, case, chance, often):
    """The spins of a tick: once in a while a ring that turns is steered, also faster than the ball, or stopped."""
    spins = batch.spins.copy()
    for g in range(len(batch)):
        for k, ring in enumerate(case.arena.rings):
            if ring.spin != 0.0 and chance.random() < often:
                spins[g, k] = (
                    chance.choice((0.0, 1.5, *[0.99] * 6)) * chance.uniform(-1.0, 1.0) * case.speed / ring.outer_radius
                )
    return spins


class Played:
    """Counts of what a comparison went through, so that it can be shown to go through everything."""

    def __init__(self):
        self.ball_ticks = self.hits = self.stacks = self.freed = self.dropped = self.lost = 0

    def add(self, steps):
        """Count what one tick of every game did."""
        for step in steps:
            self.ball_ticks += len(step.arena.balls)
            self.hits += len(step.hits)
            self.stacks += sum(hit.layers > 0 for hit in step.hits)
            self.freed += step.freed
            self.dropped += step.dropped


def compared(batch, arenas, flights, spins, speed, dt=TICK):
    """One tick of both, compared; the scalar steps."""
    arenas = [steered(arena, row) for arena, row in zip(arenas, spins, strict=True)]
    steps = [advance(arena, dt, speed, flight) for arena, flight in zip(arenas, flights, strict=True)]
    done = batch.step(spins)
    assert_same(batch, [step.arena for step in steps])
    assert done.hits.tolist() == rows(steps)
    assert done.dropped.tolist() == [step.dropped for step in steps]
    assert done.freed.tolist() == [step.freed for step in steps]
    return steps, done


def test_a_batch_has_the_bits_of_the_scalar_engine_at_every_tick():
    """Random arenas of 1 to 5 rings and balls, steering, friction, stacks, balls inside material, lost balls served again."""
    played = Played()
    for index in range(CASES):
        case, chance = random_case(16, index), Random(f"batch {index}")
        arenas = games_of_one_shape(case, chance)
        edge = max(ring.outer_radius for ring in case.arena.rings) + 2.0 * case.arena.balls[0].radius
        batch = Batch(arenas, dt=TICK, speed=case.speed, ground_radius=edge)
        flights = [None] * GAMES
        for tick in range(TICKS):  # in the first quarter rings keep their spin, whose flights are followed to the very touch
            spins = random_spins(batch, case, chance, 0.0 if tick < TICKS // 4 else 0.1)
            steps, done = compared(batch, arenas, flights, spins, case.speed)
            played.add(steps)
            arenas, flights = [step.arena for step in steps], [step.flight for step in steps]
            for g, i in np.argwhere(done.lost).tolist():
                assert abs(arenas[g].balls[i].position) - arenas[g].balls[i].radius > edge * (1.0 - 1e-12)
                arenas[g] = served(arenas[g], i, arenas[g].balls[i].radius, case.speed, chance)
                batch.put(g, arenas[g])
                played.lost += 1
    assert played.ball_ticks >= 100_000
    assert min(played.hits, played.stacks, played.freed, played.lost) >= 100, vars(played)


def test_a_squeezed_ball_is_dropped_and_put_outside_as_in_the_scalar_engine():
    """Two rings turn against each other, their ends close on the ball; in other games it loses its time between two faces."""
    left, right = Ring(10.0, 0.5, 0.3, 1, 0.345, -0.5), Ring(10.0, 0.5, 0.3, 1, -0.345, 0.5)
    ends = [Arena((Ball(9.9 + 0.01j * k, 8j, 0.25),), (left, right), ((PERMANENT,),) * 2) for k in range(4)]
    inner, outer = Ring(10.0, 0.5, math.pi, 1), Ring(11.5 + 1e-6, 0.5, math.pi, 1)
    faces = [Arena((Ball(10.75 + 5e-7 + 0j, 12.5 / TICK + 0j, 0.25),), (inner, outer), ((PERMANENT,),) * 2)]
    for games, speed in ((ends, 8.0), (faces, 12.5 / TICK)):
        arenas = games
        played, batch, flights = Played(), Batch(arenas, dt=TICK, speed=speed), [None] * len(arenas)
        for _ in range(60):
            steps, _done = compared(batch, arenas, flights, batch.spins.copy(), speed)
            played.add(steps)
            arenas, flights = [step.arena for step in steps], [step.flight for step in steps]
        assert played.dropped > 0
        assert (played.freed > 0) is (speed == 8.0)


def wall_of_bricks(chance):
    """A game of paddles and three rows of stacked bricks, walled in."""
    rows = [Ring(radius, 0.4, 0.9 * math.pi / 16, 16) for radius in (2.6, 3.8, 5.0)]
    angle, heading = chance.uniform(0.0, math.tau), chance.uniform(0.0, math.tau)
    ball = Ball(7.0 * complex(math.cos(angle), math.sin(angle)), 8.0 * complex(math.cos(heading), math.sin(heading)), 0.25)
    rings = (Ring(10.0, 0.3, 0.35, 3, 0.0, 0.72), *rows, Ring(13.0, 0.5, math.pi, 1))
    return Arena((ball,), rings, ((PERMANENT,) * 3, *[(2,) * 16] * 3, (PERMANENT,)))


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_many_ticks_in_one_call_are_the_same_ticks(threads):
    """Whatever the number of threads: state and hits, also where the hits need more rows than the step began with."""
    chance = Random("calls")
    arenas = [wall_of_bricks(chance) for _ in range(50)]
    at_once, one_by_one = [Batch(arenas, dt=TICK, speed=8.0, ground_radius=12.0) for _ in range(2)]
    done, single = at_once.step(ticks=3000, threads=threads), [one_by_one.step() for _ in range(3000)]
    assert (bits(at_once.positions) == bits(one_by_one.positions)).all()
    assert (at_once.layers == one_by_one.layers).all()
    assert (done.lost == single[-1].lost).all()
    ordered = sorted(
        [(row[0], tick, *row[2:]) for tick, steps in enumerate(single) for row in steps.hits.tolist()], key=lambda row: row[:3]
    )
    assert done.hits.tolist() == ordered
    assert len(ordered) > 500


def test_more_hits_than_rows_grow_the_rows(monkeypatch):
    """A call stops where its rows might not do, and goes on at the same tick of the same game."""
    chance = Random("rows")
    arenas = [wall_of_bricks(chance) for _ in range(30)]
    plenty = Batch(arenas, dt=TICK, speed=8.0).step(ticks=2000)
    monkeypatch.setattr("physics.batch.batch._ROWS", 0)
    scarce = Batch(arenas, dt=TICK, speed=8.0).step(ticks=2000)
    assert scarce.hits.tolist() == plenty.hits.tolist()
    assert len(plenty.hits) > 128


def test_a_game_comes_back_as_the_arena_it_is():
    """`arena` of a batch is the arena that went in; after `put`, the one that was put."""
    chance = Random("arenas")
    arenas = [wall_of_bricks(chance) for _ in range(3)]
    batch = Batch(arenas, dt=TICK, speed=8.0)
    assert [batch.arena(g) for g in range(len(batch))] == arenas
    batch.step(ticks=100)
    batch.put(1, arenas[2])
    assert batch.arena(1) == arenas[2]
    assert batch.arena(0) != arenas[0]


def nan_at(shape, where):
    """Spins, one of which is no number."""
    spins = np.zeros(shape)
    spins[where] = math.nan
    return spins


@pytest.mark.parametrize(
    ("argument", "named"),
    [
        ({"spins": np.zeros(3)}, r"spins must be a float64 array of shape \(2, 5\), not float64 of shape \(3,\)"),
        ({"spins": np.zeros((2, 5), np.float32)}, "spins must be .* not float32"),
        ({"spins": [[0.0] * 5] * 2}, "spins must be .* not list"),
        ({"spins": nan_at((2, 5), (1, 0))}, "spins must be finite .* not nan at game 1, ring 0"),
        ({"spins": np.full((2, 5), math.inf)}, "spins must be finite .* not inf at game 0, ring 0"),
        ({"ticks": -1}, "ticks must be a whole number from 0 up, not -1"),
        ({"ticks": 2**63}, "ticks must be at most 9223372036854775807, not 9223372036854775808"),
        ({"ticks": 1.0}, "ticks must be .* not 1.0"),
        ({"threads": 0}, "threads must be a whole number from 1 up, not 0"),
    ],
)
def test_a_wrong_argument_of_a_step_is_named_and_changes_nothing(argument, named):
    """ValueError; the games go on as if nothing had been asked."""
    chance = Random("wrong")
    batch = Batch([wall_of_bricks(chance), wall_of_bricks(chance)], dt=TICK, speed=8.0)
    before = [batch.arena(g) for g in range(2)]
    with pytest.raises(ValueError, match=named):
        batch.step(**argument)
    assert [batch.arena(g) for g in range(2)] == before


def test_many_lost_balls_are_served_at_once():
    """`serve` leaves the games as `put` would, one by one; the games go on alike."""
    chance = Random("serve")
    arenas = [wall_of_bricks(chance) for _ in range(6)]
    at_once, one_by_one = [Batch(arenas, dt=TICK, speed=8.0) for _ in range(2)]
    full = at_once.layers[0].copy()
    for batch in (at_once, one_by_one):
        batch.step(ticks=400)
    balls = {4: Ball(7j, 8 + 0j, 0.25), 1: Ball(-7j, -8j, 0.25)}
    for game, ball in balls.items():
        one_by_one.put(game, Arena((ball,), one_by_one.arena(game).rings, arenas[0].layers))
    positions, velocities = ([[getattr(ball, name)] for ball in balls.values()] for name in ("position", "velocity"))
    at_once.serve(np.array([*balls]), np.array(positions), np.array(velocities), full)
    assert [at_once.arena(g) for g in range(6)] == [one_by_one.arena(g) for g in range(6)]
    assert at_once.step(ticks=400).hits.tolist() == one_by_one.step(ticks=400).hits.tolist()


@pytest.mark.parametrize(
    ("argument", "named"),
    [
        ({"games": np.array([2])}, "games must be from 0 to 1, not 2 to 2"),
        ({"games": [0]}, r"games must be a int64 array of shape \(1,\), not list"),
        ({"positions": np.array([[complex(math.nan, 0.0)]])}, "positions must be finite"),
        (
            {"positions": np.array([7j])},
            r"positions must be .* of shape \(1, 1\), not complex128 of shape \(1,\)",
        ),
        ({"velocities": np.array([[1e-40 + 0j]])}, "velocities must be 0 or from 1e-35 to 1e\\+35 long"),
        ({"layers": np.zeros((5, 16), np.int64)}, "layers must be a int8 array"),
        ({"layers": np.full((5, 16), -2, np.int8)}, "layers must be from -1 up, not -2"),
    ],
)
def test_a_wrong_argument_of_serve_is_named_and_changes_nothing(argument, named):
    """ValueError; the games stay as they are."""
    chance = Random("wrong serve")
    batch = Batch([wall_of_bricks(chance), wall_of_bricks(chance)], dt=TICK, speed=8.0)
    before = [batch.arena(g) for g in range(2)]
    right = {"games": np.array([0]), "positions": np.array([[7j]]), "velocities": np.array([[8 + 0j]])}
    with pytest.raises(ValueError, match=named):
        batch.serve(**(right | argument))
    assert [batch.arena(g) for g in range(2)] == before


def test_the_arrays_cannot_be_written_to():
    """A game changes by `step` and `put` alone: the batch remembers what it knows of it."""
    batch = Batch([wall_of_bricks(Random("views"))], dt=TICK, speed=8.0)
    for array in (batch.positions, batch.velocities, batch.phases, batch.spins, batch.layers):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_a_batch_of_other_shapes_is_refused_when_put():
    """One ball more."""
    arena = wall_of_bricks(Random("put"))
    batch = Batch([arena], dt=TICK, speed=8.0)
    with pytest.raises(ValueError, match="arena must have 1 balls, as the first, not 2"):
        batch.put(0, arena._replace(balls=arena.balls * 2))


def test_another_process_loads_what_this_one_compiled():
    """From disk, without compiling again."""
    compiled()
    code = "from physics.batch import compiled; print(compiled().cached)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout == "True\n"


def test_the_example_of_the_page_runs():
    """As it stands; some balls are lost in its second, and some bricks are hit."""
    text = (ROOT / "docs" / "batch.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    seen = {}
    exec(example, seen)  # noqa: S102  # the project's own page
    assert len(seen["steps"].hits) > 0
    assert seen["steps"].hits["ring"].max() == 1
