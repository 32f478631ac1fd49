"""Where a better answer than the source's exists: each is accepted beside the source's own, and reported apart."""

from collections.abc import Callable, Mapping
from typing import Any

from game.student.slides import Plane, Scalar, SlideFunctions


class OnSegment(SlideFunctions):
    """The closest point stays between A and B; so an end has corners."""

    def share_of_line(self, share: Scalar) -> Scalar:
        """Clamped to the segment."""
        return min(max(share, 0), 1)


class SideOfMiddle(SlideFunctions):
    """The side of the sector's middle picks the end; also for wide sectors, whose farther end the slide's rule can pick."""

    def end_sign(self, theta: Scalar, theta_p: Scalar, phi_p: Scalar) -> int:  # noqa: ARG002  # the slide's rule needs it
        """1 where the ball is on the left of the sector's middle."""
        return 1 if self.on_left(theta, theta_p) else -1


class SegmentAndSide(OnSegment, SideOfMiddle):
    """Both of them."""


class Carried(SlideFunctions):
    """A ball that the reset to v_0 would leave slower along the normal than the surface moves at the surface's speed."""

    def final_velocity(self, v_res: Plane, v_0: Scalar, n: Plane, v_p: Plane) -> Plane:
        """Of length v_0; its component along n is at least that of v_p."""
        velocity = super().final_velocity(v_res, v_0, n, v_p)
        pace = v_p.real * n.real + v_p.imag * n.imag
        if velocity.real * n.real + velocity.imag * n.imag >= pace:
            return velocity
        if pace >= v_0:
            return v_0 * n
        tangent = self.point(-n.imag, n.real)
        sense = 1 if velocity.real * tangent.real + velocity.imag * tangent.imag >= 0 else -1
        return pace * n + sense * self.maths.sqrt(v_0 * v_0 - pace * pace) * tangent


class Topic:
    """A refinement of the source.

    Attributes:
        functions: makes the source's functions with this refinement.
        source: what a report says of answers that are the source's own.
        beyond: what it says of answers that are the refined ones.
    """

    def __init__(self, functions: Callable[..., SlideFunctions], source: str, beyond: str) -> None:
        self.functions = functions
        self.source = source
        self.beyond = beyond


TOPICS: Mapping[str, Topic] = {
    "segment": Topic(
        OnSegment,
        "line in place of segment: the foot of the perpendicular may lie beyond A and B, as slide 5's name has it. Clamp its"
        " share of AB to [0, 1], and the ends get corners",
        "the closest point is on the segment AB, so that the ends have corners",
    ),
    "wide sector": Topic(
        SideOfMiddle,
        "on_left(θ, θ_p + φ_p) picks the end, as slide 5 has it; for a wide sector that can be the farther one. Ask for the"
        " side of θ_p instead",
        "the side of the sector's middle picks the end, also for wide sectors",
    ),
    "segment and wide sector": Topic(
        SegmentAndSide, "line in place of segment, and slide 5's rule for the end", "a segment, and the nearer end"
    ),
    "carried": Topic(
        Carried,
        "slide 10's reset to v_0 can leave the ball slower than the paddle that follows it",
        "a ball is carried by a paddle that would overtake it",
    ),
}


def alternatives(name: str) -> Mapping[str, Any]:
    """The topics that can change a function's answer."""
    if name == "closest_point_on_line":
        return {"segment": TOPICS["segment"]}
    if name in {"narrow_phase_case_2", "broad_phase"}:
        return {topic: TOPICS[topic] for topic in ("segment", "wide sector", "segment and wide sector")}
    return {"carried": TOPICS["carried"]} if name == "collision_response" else {}
