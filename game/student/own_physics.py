"""A physics from a student's functions, or from a student's own `advance`; where they fail, the slides' functions answer."""

import math
from collections.abc import Sequence
from typing import Any

from game.student.answering import AnsweringFunctions
from physics import Arena, Ball, FreeFlight, Step, source_mode
from physics.source_mode import SlidesBounce


class OwnPhysics:
    """A physics for `game.rules.tick`: the slides' algorithm on the functions of a file, which is asked for the bounces."""

    def __init__(self, file: AnsweringFunctions) -> None:
        self.file = file

    @property
    def note(self) -> str:
        """One line that says whose functions answer."""
        return self.file.note

    def news(self) -> str:
        """What has happened to the file since the last call, in a few words; "" if nothing has. To be called often."""
        return self.file.refresh()

    def advance(self, arena: Arena, dt: float, speed: float, flight: FreeFlight | None = None) -> Step:
        """As `physics.source_mode.advance`. A file's own `advance` is asked every tick, not once a frame."""
        if arena.balls and "advance" in self.file.own:
            step = self._own_advance(arena, dt, speed)
            if step is not None:
                return step
        return source_mode.advance(arena, dt, speed, flight, self._bounces)

    def _bounces(self, arena: Arena, speed: float) -> Sequence[SlidesBounce]:
        """The bounces by the file's functions; by the slides' where those do not answer."""
        if not arena.balls:
            return ()
        answer = self.file.ask("bounces", [*_plain(arena), speed])
        found = None if answer is None else _read_bounces(answer, arena)
        if answer is not None and found is None:
            self.file.reject("the velocity after a bounce is beyond every measure")
        return source_mode.bounces(arena, speed) if found is None else found

    def _own_advance(self, arena: Arena, dt: float, speed: float) -> Step | None:
        """The tick by the file's own `advance`; None where it does not answer."""
        answer: Any = self.file.ask("advance", [*_plain(arena), dt, speed])
        if answer is None:
            return None
        rings = tuple([ring.turned(dt) for ring in arena.rings])
        try:
            states, hits = answer
            balls = [
                Ball(complex(*p_v[:2]), complex(*p_v[2:]), ball.radius) for p_v, ball in zip(states, arena.balls, strict=True)
            ]
            moved = Arena(tuple(balls), rings, arena.layers)
            later, found = source_mode.answered(
                moved,
                [SlidesBounce(ball, ring, slot, complex(x, y), balls[ball].velocity) for ball, ring, slot, x, y in hits],
                dt,
            )
        except (TypeError, ValueError, IndexError):
            self.file.reject("advance has put a ball beyond every measure")
            return None
        before = [hit._replace(before=arena.balls[hit.ball].velocity) for hit in found]
        return Step(later, tuple(before), 0, 0, (later, 0.0, ()))


def _plain(arena: Arena) -> list[object]:
    """Balls, rings and layers as JSON has them."""
    balls = [(p.real, p.imag, v.real, v.imag, radius) for p, v, radius in arena.balls]
    return [balls, arena.rings, arena.layers]


def _read_bounces(answer: object, arena: Arena) -> list[SlidesBounce] | None:
    """The bounces in an answer; None where it has none, or a velocity that no ball can have."""
    found = []
    try:
        for ball, ring, slot, *numbers in answer:  # type: ignore[attr-defined]  # whatever the child has answered
            n_x, n_y, v_x, v_y = [float(number) for number in numbers]
            Ball(arena.balls[ball].position, complex(v_x, v_y), arena.balls[ball].radius)
            if min(ball, ring, slot) < 0 or arena.layers[ring][slot] == 0 or not math.isfinite(n_x + n_y):
                return None
            found.append(SlidesBounce(ball, ring, slot, complex(n_x, n_y), complex(v_x, v_y)))
    except (TypeError, ValueError, IndexError):
        return None
    return found
