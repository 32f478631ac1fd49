"""The fuzzer in small: hypothesis plays, changes the arena between ticks as a game does, and shrinks what fails."""

import cmath
import math

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from physics import PERMANENT, Arena, Ball, Ring, Step, advance
from tests.support.oracles.impact_oracle import gap
from tests.support.strategies import angles, reals
from tools.fuzz.checks import first_fault

SPEED = 8.0
EDGE = 14.0


class FuzzedGame(RuleBasedStateMachine):
    """An arena, ticks of any length, and everything that rules may do between two ticks."""

    @initialize(count=st.integers(1, 4), per_row=st.integers(1, 12), fill=reals(0.2, 1.0), friction=reals(0.0, 1.0))
    def build(self, count, per_row, fill, friction):
        """Paddles near the rim, two rows of bricks, no ball."""
        paddles = Ring(10.0, 0.3, 0.3, count, 0.0, 0.0, friction)
        rows = [Ring(radius, 0.4, fill * math.pi / per_row, per_row, 0.1 * radius) for radius in (3.0, 4.5)]
        self.arena = Arena((), (paddles, *rows), ((PERMANENT,) * count, (1,) * per_row, (2,) * per_row))
        self.saved = self.arena

    @precondition(lambda self: len(self.arena.balls) < 5)
    @rule(distance=reals(0.0, 12.0), place=angles(), way=angles(), radius=reals(0.1, 0.4))
    def serve(self, distance, place, way, radius):
        """A new ball, wherever it is free."""
        ball = Ball(cmath.rect(distance, place), cmath.rect(SPEED, way), radius)
        gaps = [
            gap(ball, ring, 0.0, [slot for slot in range(ring.count) if alive[slot]])
            for ring, alive in zip(self.arena.rings, self.arena.layers, strict=True)
        ]
        if min(gaps) > 1e-6:
            self.arena = self.arena._replace(balls=(*self.arena.balls, ball))

    @rule(share=reals(-0.99, 0.99))
    def steer(self, share):
        """The player turns the paddles."""
        paddles, *rows = self.arena.rings
        self.arena = self.arena._replace(rings=(paddles._replace(spin=share * SPEED / 10.3), *rows))

    @rule(half_angle=reals(0.05, 0.7))
    def resize(self, half_angle):
        """A power-up makes paddles wider or narrower, perhaps over a ball."""
        paddles, *rows = self.arena.rings
        self.arena = self.arena._replace(rings=(paddles._replace(half_angle=half_angle), *rows))

    @rule(row=st.integers(1, 2))
    def rebuild(self, row):
        """Bricks grow back, perhaps over a ball."""
        layers = list(self.arena.layers)
        layers[row] = (1,) * len(layers[row])
        self.arena = self.arena._replace(layers=tuple(layers))

    @rule()
    def save(self):
        """Remember this moment."""
        self.saved = self.arena

    @rule(ticks=st.integers(1, 30))
    def restore(self, ticks):
        """The same moment has the same future, to the bit."""
        futures = []
        for _ in range(2):
            state = self.saved
            for _ in range(ticks):
                state = advance(state, 1.0 / 240.0, SPEED).arena
            futures.append(state)
        assert futures[0] == futures[1]
        self.arena = futures[0]

    @rule(ticks=st.integers(1, 40), dt=st.sampled_from([1.0 / 240.0, 1.0 / 60.0, 0.1]))
    def play(self, ticks, dt):
        """Some ticks, each checked; balls that left are taken out."""
        for _ in range(ticks):
            step = advance(self.arena, dt, SPEED)
            assert first_fault(self.arena, step, dt, SPEED) is None
            balls = tuple(ball for ball in step.arena.balls if abs(ball.position) < EDGE)
            self.arena = step.arena._replace(balls=balls)

    @rule()
    def pause(self):
        """No time passes, nothing happens."""
        assert advance(self.arena, 0.0, SPEED) == Step(self.arena, (), 0, 0)

    @invariant()
    def everything_is_finite(self):
        """Always."""
        if hasattr(self, "arena"):
            assert all(cmath.isfinite(ball.position) and cmath.isfinite(ball.velocity) for ball in self.arena.balls)


TestPlay = FuzzedGame.TestCase
TestPlay.settings = settings(max_examples=40, stateful_step_count=25, deadline=None)
