"""The source's formulas once more, in ball arithmetic, by other means than the physics uses.

Each takes the exact inputs and returns the exact result as one or two coordinates; None where the source finds no contact. A
`ValueError` says that the inputs are, or a box of them is, on a border of the formula.
"""

from collections.abc import Sequence

from flint import arb

Numbers = Sequence[arb]


def min_difference(inputs: Numbers) -> Numbers:
    """The difference without its sign, or what is missing to a full turn where that is less."""
    a, b = inputs
    difference = _sign(a - b) * (a - b)
    return [2 * arb.pi() - difference if _sign(difference - arb.pi()) > 0 else difference]


def direction(inputs: Numbers) -> Numbers:
    """Cosine and sine."""
    sine, cosine = inputs[0].sin_cos()
    return [cosine, sine]


def closest_point_on_line(inputs: Numbers) -> Numbers:
    """The point less its part along the segment's normal; an end where the point lies beyond it."""
    ax, ay, bx, by, px, py = inputs
    if _sign((px - ax) * (bx - ax) + (py - ay) * (by - ay)) < 0:
        return [ax, ay]
    if _sign((px - bx) * (ax - bx) + (py - by) * (ay - by)) < 0:
        return [bx, by]
    dx, dy = bx - ax, by - ay
    length = (dx * dx + dy * dy).sqrt()
    nx, ny = -dy / length, dx / length
    off = nx * (px - ax) + ny * (py - ay)
    return [px - nx * off, py - ny * off]


def narrow_phase_case_1(inputs: Numbers) -> Numbers:
    """The direction at the ball's angle, away from the middle radius."""
    x, y, radius = inputs
    side = _sign(x * x + y * y - radius * radius)
    sine, cosine = arb.atan2(y, x).sin_cos()
    return [side * cosine, side * sine]


def narrow_phase_case_2(inputs: Numbers) -> Numbers | None:
    """In the frame of the end that is nearer in angle, mirrored so that the ball lies above it."""
    x, y, ball_radius, theta, radius, angle, half_width, half_angle = inputs
    side = _sign((theta - angle).sin())
    sine, cosine = (angle + side * half_angle).sin_cos()
    along, above = cosine * x + sine * y, side * (cosine * y - sine * x)
    inner, outer = radius - half_width, radius + half_width
    run = along - inner if _sign(along - inner) < 0 else along - outer if _sign(along - outer) > 0 else arb(0)
    distance = (run * run + above * above).sqrt()
    if _sign(distance - ball_radius) > 0:
        return None
    nx, ny = (run / distance, above / distance) if not run.is_zero() else (arb(0), arb(1))
    return [cosine * nx - sine * side * ny, sine * nx + cosine * side * ny]


def _sign(x: arb) -> int:
    """+1 or -1; ValueError where it is neither for certain."""
    if x > 0:
        return 1
    if x < 0:
        return -1
    raise ValueError("on a border of the formula")
