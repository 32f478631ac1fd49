"""Mistakes in the response: put around the source's function, whose answer is the ball's next velocity."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from typing import Any

import physics
from physics import Ball, Impact, Ring, dot
from physics.bounce import bounce_off_two
from physics.time_of_impact import first_impact
from physics.vectors import quarter_turn
from tools.crosscheck.sabotage.replacing import constant, method, replaced

_right = physics.collision_response
_right_touch = first_impact
_right_surface = Ring.surface_velocity

Response = Callable[[complex, complex, complex, float, float], complex]


def still_surface() -> AbstractContextManager[None]:
    """The bounce forgets that the ring turns."""
    return replaced(_right, lambda v, normal, _, friction, speed: _right(v, normal, 0j, friction, speed))


def weak_mirror() -> AbstractContextManager[None]:
    """The normal part of the velocity is turned round by 1.98 of itself instead of 2."""

    def weak(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex:
        approach = dot(v - surface_velocity, normal)
        after = _right(v, normal, surface_velocity, friction, speed)
        if approach >= 0.0:
            return after
        shorter = after + normal * (0.02 * approach)
        return shorter * (speed / physics.length(shorter))

    return replaced(_right, weak)


def reversed_friction() -> AbstractContextManager[None]:
    """Friction pushes the ball on along the surface instead of holding it back."""
    return replaced(_right, lambda v, normal, surface, friction, speed: _right(v, normal, surface, -friction, speed))


def no_friction() -> AbstractContextManager[None]:
    """No surface has friction."""
    return replaced(_right, lambda v, normal, surface, _, speed: _right(v, normal, surface, 0.0, speed))


def more_friction_inside() -> AbstractContextManager[None]:
    """Inner faces have a tenth more friction."""
    return _with_friction(lambda normal, point: 1.1 if _radial(normal, point) < -0.999999 else 1.0)


def less_friction_on_ends() -> AbstractContextManager[None]:
    """Ends have a tenth less friction."""
    return _with_friction(lambda normal, point: 0.9 if abs(_radial(normal, point)) < 1e-6 else 1.0)


def lossy_speed() -> AbstractContextManager[None]:
    """Every bounce costs a thousand-millionth of the speed."""
    return replaced(
        _right, lambda v, normal, surface, friction, speed: _right(v, normal, surface, friction, speed * (1.0 - 1e-9))
    )


def stale_speed() -> AbstractContextManager[None]:
    """The speed is not reset: a ball that a paddle drives stays fast."""

    def stale(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex:
        after = _right(v, normal, surface_velocity, friction, speed)
        approach = dot(v - surface_velocity, normal)
        return after if approach >= 0.0 else v - normal * (2.0 * approach)

    return replaced(_right, stale)


def speed_at_the_centre() -> AbstractContextManager[None]:
    """The surface's velocity is taken at the ball's centre instead of the contact point."""
    seen: dict[str, float] = {"radius": 0.0, "spin": 0.0}

    def touched(ball: Ball, ring: Ring, *rest: object) -> Impact | None:
        seen["radius"] = ball.radius
        return _right_touch(ball, ring, *rest)  # type: ignore[arg-type]

    def surface(ring: Ring, point: complex) -> complex:
        seen["spin"] = ring.spin
        return _right_surface(ring, point)

    def answered(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex:
        at_centre = surface_velocity + quarter_turn(normal * seen["radius"]) * seen["spin"]
        return _right(v, normal, at_centre, friction, speed)

    return _all_of(replaced(_right_touch, touched), method(Ring, "surface_velocity", surface), replaced(_right, answered))


def reversed_spin() -> AbstractContextManager[None]:
    """The surface moves in the opposite direction."""
    return replaced(_right, lambda v, normal, surface, friction, speed: _right(v, normal, -surface, friction, speed))


def one_of_two() -> AbstractContextManager[None]:
    """A ball that touches two sectors at once bounces off one of them only."""
    return replaced(bounce_off_two, lambda *_: None)


def crooked_double_bounce() -> AbstractContextManager[None]:
    """A ball that touches two sectors at once leaves a millionth of a radian off."""

    def crooked(*arguments: Any) -> complex | None:
        after = bounce_off_two(*arguments)
        return None if after is None else after + quarter_turn(after) * 1e-6

    return replaced(bounce_off_two, crooked)


def far_separation() -> AbstractContextManager[None]:
    """The least speed of leaving an inner face or a turning end is a hundredfold."""
    return constant("LEAST_SEPARATION", 0.1)


def no_separation() -> AbstractContextManager[None]:
    """A ball may leave an inner face or a turning end as slowly as it likes."""
    return constant("LEAST_SEPARATION", 1e-9)


def far_graze() -> AbstractContextManager[None]:
    """The least speed of leaving an outer face or a resting end is tenfold."""
    return constant("LEAST_GRAZE", 1e-8)


def early_stop() -> AbstractContextManager[None]:
    """A resulting velocity counts as none when it is a hundred times longer than it should be."""
    return constant("STOPPED", 1e-10)


def _with_friction(factor: Callable[[complex, complex], float]) -> AbstractContextManager[None]:
    """The response with friction that depends on the normal and the contact point."""
    points = [0j]

    def surface(ring: Ring, point: complex) -> complex:
        points[0] = point
        return _right_surface(ring, point)

    def answered(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex:
        return _right(v, normal, surface_velocity, min(friction * factor(normal, points[0]), 1.0), speed)

    return _all_of(method(Ring, "surface_velocity", surface), replaced(_right, answered))


def _radial(normal: complex, point: complex) -> float:
    """The normal's part along the direction from the centre to the contact point."""
    return dot(normal, point) / physics.length(point)


@contextmanager
def _all_of(*changes: AbstractContextManager[None]) -> Iterator[None]:
    """Several changes at once."""
    with ExitStack() as stack:
        for change in changes:
            stack.enter_context(change)
        yield
