"""One bounce off a surface: the steps of the response, which of its branches answered, and the line that decided."""

from typing import NamedTuple

from game.lab.kit.cited_line import CitedLine, code_line
from physics import Response, dot, length, response_steps
from physics.response import leaving_at
from physics.tolerances import STOPPED


class Bounce(NamedTuple):
    """The arguments of the collision response, and its steps.

    v: the ball's velocity before. normal: unit, from the surface to the ball. surface_velocity: v_p at the contact point.
    friction: μ in [0, 1]. speed: the ball's fixed speed v_0.
    """

    v: complex
    normal: complex
    surface_velocity: complex
    friction: float
    speed: float
    steps: Response

    @property
    def approach(self) -> float:
        """Δv · n: below 0 where the ball and the surface approach each other."""
        return dot(self.steps.relative, self.normal)

    @property
    def separates(self) -> bool:
        """Whether the ball leaves the surface already, so that nothing is answered."""
        return self.approach >= 0.0

    @property
    def surface_speed(self) -> float:
        """u = v_p · n: the speed of the surface along the normal, above 0 where it comes after the ball."""
        return dot(self.surface_velocity, self.normal)

    @property
    def stopped(self) -> bool:
        """Whether v_res is 0 but for rounding."""
        return not self.separates and length(self.steps.result) <= STOPPED * self.speed

    @property
    def overtaken(self) -> bool:
        """Whether the ball, brought to v_0 as the source does it, would be slower along the normal than the surface."""
        if self.separates or self.stopped:
            return False
        v_res = self.steps.result
        return dot(v_res, self.normal) / length(v_res) * self.speed < self.surface_speed


def bounce(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> Bounce:
    """The bounce of a ball. The arguments are those of `physics.collision_response`."""
    steps = response_steps(v, normal, surface_velocity, friction, speed)
    return Bounce(v, normal, surface_velocity, friction, speed, steps)


def response_line(found: Bounce) -> CitedLine:
    """The line of the collision response that decided the result."""
    if found.separates:
        return code_line(response_steps, "if approach >= 0.0:")
    if found.stopped:
        return code_line(response_steps, "if length(result) <= STOPPED * speed:")
    if found.overtaken:
        straight = found.surface_speed >= found.speed
        return code_line(leaving_at, "if normal_speed >= speed:" if straight else "return unit(normal * normal_speed + tangent")
    return code_line(response_steps, "result = v + normal_change + tangential_change")
