"""The axes of v and n: the source gives the two vectors different planes."""

from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.bounce import Bounce, bounce, response_line
from game.lab.kit.cited_line import CitedLine, source_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks, two_decimals
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Arrow, Disc, Mark, Pane, Picture, RevealStep, Role, Toggle, in_steps
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import Ball, Ring, contact, length, to_cartesian

_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 1.1, 0.3, 1.0
_BALL_RADIUS = 0.4
_ROUNDING = 1e-12
"""A component of n below this is 0 but for rounding."""


class _Vector(NamedTuple):
    """A vector of three components, as the source writes them. y: upwards, where v = (v_x, 0, v_z) has 0."""

    x: float
    y: float
    z: float


class _TwoReadings(NamedTuple):
    """A ball that touches a wall at rest, and its velocity after by both readings.

    three: by the components that the source writes, v = (v_x, 0, v_z) and n = (n_x, n_y, 0). found: in the ground's plane.
    """

    ball: Ball
    ring: Ring
    three: _Vector
    found: Bounce

    @property
    def literal_approach(self) -> float:
        """v · n by the source's components: v_x n_x, since the other products have a factor 0."""
        n_x = self.found.normal.real
        return self.found.v.real * n_x if abs(n_x) > _ROUNDING else 0.0


def _two_readings(given: Given) -> _TwoReadings:
    """The bounce that the values make. The ground's second coordinate is z in v, and y in n."""
    speed, theta = given.number("speed"), given.angle("theta")
    ring = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, theta)
    ball = Ball(
        to_cartesian(ring.outer_radius + _BALL_RADIUS, theta), to_cartesian(speed, given.angle("heading")), _BALL_RADIUS
    )
    v = ball.velocity
    both = _TwoReadings(ball, ring, _Vector(v.real, 0.0, v.imag), bounce(v, contact(ball, ring, 0).normal, 0j, 0.0, speed))
    if both.literal_approach >= 0.0:
        return both
    twice, n = 2.0 * both.literal_approach, both.found.normal
    return both._replace(three=_Vector(v.real - twice * n.real, -twice * n.imag if abs(n.imag) > _ROUNDING else 0.0, v.imag))


def _picture(given: Given) -> Picture:
    """The literal reading at the left, the plane at the right, both from above."""
    both = _two_readings(given)
    p, found, literal = both.ball.position, both.found, complex(both.three.x, both.three.z)
    panes = (Pane((), "the source, read literally"), Pane((), "here: both in the ground's plane"))
    situation: tuple[Mark, ...] = (
        *ring_marks(both.ring),
        Disc(p, _BALL_RADIUS, Role.BALL),
        Arrow(p, found.normal * 1.2, Role.OURS, Toggle.NORMALS, label="n"),
        Arrow(p, found.v * VELOCITY_SCALE, Role.PLAIN, label="v before"),
    )
    theirs = Arrow(p, literal * VELOCITY_SCALE, Role.SOURCE, label="v after")
    ours = Arrow(p, found.steps.velocity * VELOCITY_SCALE, Role.GOOD, label="v after")
    vectors, product, after, plane, mirrored = _formula(both)
    steps = (
        RevealStep("v and n, as the source writes them", (situation, situation), (vectors,)),
        RevealStep("v · n by these components", ((), ()), (product,)),
        RevealStep("v after, read literally", ((theirs,), ()), (after,)),
        RevealStep("v after, in the plane", ((), (ours,)), (plane, mirrored)),
    )
    return in_steps(steps, _cited(both), _note(both), panes)


def _formula(both: _TwoReadings) -> tuple[str, ...]:
    """Both scalar products, and both results without friction."""
    v, n, three = both.found.v, both.found.normal, both.three
    return (
        f"the source:   v = ({v.real:.2f}, 0, {v.imag:.2f}),   n = ({n.real:.2f}, {n.imag:.2f}, 0)",
        f"v · n = v_x n_x = {both.literal_approach + 0.0:.2f}",
        f"v after = ({three.x:.2f}, {three.y + 0.0:.2f}, {three.z:.2f}),   its height: {three.y + 0.0:.2f}",
        f"here:   v = {two_decimals(v)},   n = {two_decimals(n)},   v · n = {both.found.approach:.2f}",
        f"v after = v - 2 (v · n) n = {two_decimals(both.found.steps.result)}",
    )


def _cited(both: _TwoReadings) -> CitedLine:
    """The source's two vectors where they give another answer."""
    if length(complex(both.three.x, both.three.z) - both.found.steps.velocity) < 1e-9:
        return response_line(both.found)
    return source_line("Collision response", "v = (v_x, 0, v_z),  n = (n_x, n_y, 0)")


def _note(both: _TwoReadings) -> str:
    """What follows from the literal reading."""
    literally, here = both.literal_approach < 0.0, both.found.approach < 0.0
    if here and not literally:
        return "Read literally, v · n is not below 0: there is no bounce, and the ball flies into the wall."
    if literally and not here:
        return "The ball already leaves the wall, but read literally it bounces once more."
    if both.three.y:
        return (
            "Read literally, the ball leaves the ground, and its third component is never reflected. One of the two is a slip."
        )
    return "Where n is along x, or nothing is answered, both readings are the same."


def _check(given: Given) -> tuple[Claim, ...]:
    """What the literal reading changes, and when it does not matter."""
    both = _two_readings(given)
    v, n, three = both.found.v, both.found.normal, both.three
    size = (three.x**2 + three.y**2 + three.z**2) ** 0.5
    along_x = abs(n.imag) < _ROUNDING
    same = length(complex(three.x, three.z) - both.found.steps.velocity) < 1e-9 and abs(three.y) < 1e-9
    return (
        Claim("the literal bounce has the speed v_0 in space", abs(size - both.found.speed) < 1e-9),
        Claim("it never changes the component v_z", three.z == v.imag),
        Claim("where n is along x, both readings are the same", not along_x or same),
        Claim("where n is along the other axis, it never bounces", abs(n.real) > _ROUNDING or both.literal_approach == 0.0),
        Claim("ours stays in the plane at the speed v_0", abs(length(both.found.steps.velocity) - both.found.speed) < 1e-9),
    )


SCENE = LabScene(
    name="axis-slip",
    title="Response: the axes of v and n",
    idea="The source writes v = (v_x, 0, v_z) but n = (n_x, n_y, 0). Read literally, a bounce lifts the ball off the ground.",
    functions=("collision_response",),
    parameters=(
        Number("theta", "θ", "°", 0.0, 360.0, 50.0, 0.5, "where the ball touches; the direction of n"),
        Number("heading", "ψ", "°", 0.0, 360.0, 200.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 0.5, 15.0, 9.0, 0.1, "the ball's fixed speed"),
    ),
    handles=(
        handles.polar_vector(
            "speed",
            "heading",
            lambda given: to_cartesian(_RADIUS + _HALF_WIDTH + _BALL_RADIUS, given.angle("theta")),
            VELOCITY_SCALE,
            "velocity",
        ),
        handles.on_circle("theta", lambda _: _RADIUS, "wall"),
    ),
    view_box=ViewBox(0j, 3.9 + 3.9j),
    shows=_picture,
    check=_check,
    rows=(12,),
    presets=(
        Preset("off the ground", "theta=50&heading=200"),
        Preset("n along x: no difference", "theta=0&heading=160"),
        Preset("n along the other axis: no bounce at all", "theta=90&heading=250"),
        Preset("approaching, but not literally", "theta=60&heading=280"),
        Preset("leaving, but literally approaching", "theta=60&heading=110"),
    ),
)
