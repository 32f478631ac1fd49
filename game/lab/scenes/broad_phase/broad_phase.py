"""The broad phase: the outcome that follows from the ball's distance from the centre alone."""

import math

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.handles import Handle
from game.lab.kit.marks import ball_marks, ray
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Annulus, Circle, Line, Mark, Picture, Role, Stroke, Toggle, Words, in_steps, one_step
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import (
    Ball,
    Outcome,
    Ring,
    broad_phase_outcome,
    contact,
    has_left,
    in_band,
    length,
    normalize_angle,
    to_cartesian,
    to_polar,
)

_ROLES = {
    Outcome.GAME_OVER: Role.SOURCE,
    Outcome.PADDLES: Role.GOOD,
    Outcome.BRICKS: Role.ONE,
    Outcome.NO_COLLISION: Role.FAINT,
}
_FAR = 25.0


def _rings(given: Given) -> tuple[Ring, Ring]:
    """The paddles' ring and the bricks', closed: the broad phase does not look at angles."""
    paddles = Ring(given.number("r_p"), given.number("w_p"), math.pi, 1)
    return paddles, Ring(given.number("r_b"), given.number("w_b"), math.pi, 1)


def _outcome(given: Given) -> Outcome:
    """What the broad phase says."""
    paddles, bricks = _rings(given)
    return broad_phase_outcome(given.point("ball"), given.number("r"), given.number("r_g"), paddles, [bricks])


def _picture(given: Given) -> Picture:
    """For each outcome the distances of the ball's centre that lead to it, and the distances that the ball covers."""
    p, r, r_g = given.point("ball"), given.number("r"), given.number("r_g")
    paddles, bricks = _rings(given)
    distance, theta = to_polar(p)
    outcome = _outcome(given)
    role = _ROLES[outcome] if outcome is not Outcome.NO_COLLISION else Role.PLAIN
    covered = (to_cartesian(max(distance - r, 0.0), theta), to_cartesian(distance + r, theta))
    over, *bands, so = _formula(given)
    steps = (
        one_step("the ball, and two rings on the ground", [*_rings_marks(r_g, paddles, bricks), *ball_marks(p, r)]),
        one_step(
            "from |p| - r to |p| + r: all that the ball covers",
            [ray(theta, distance), Line(covered, role, None, Stroke.THICK)],
            [f"|p| = {distance:.2f},   |p| - r = {distance - r:.2f},   |p| + r = {distance + r:.2f}"],
        ),
        one_step("game over: beyond the ground", [Annulus(r_g + r, _FAR, Role.SOURCE, Toggle.BANDS, 0.16)], [over]),
        one_step("the band of the paddles: their ring, grown by r", _band_marks(paddles, r, Role.GOOD, "paddles"), bands[:1]),
        one_step(
            "the band of the bricks: their ring, grown by r", _band_marks(bricks, r, Role.ONE, "bricks"), [*bands[1:], so]
        ),
    )
    return in_steps(steps, _cited(outcome), _note(outcome, distance))


def _rings_marks(r_g: float, paddles: Ring, bricks: Ring) -> list[Mark]:
    """The ground's rim, and the faces of both rings."""
    faces = [radius for ring in (paddles, bricks) for radius in (ring.inner_radius, ring.outer_radius)]
    return [
        Circle(0j, r_g, Role.PLAIN),
        *[Circle(0j, radius, Role.GHOST, None, Stroke.DASHED) for radius in faces],
        Words(to_cartesian(r_g, 2.0) + 0.6j, "ground: r_g", Role.PLAIN),
        Words(to_cartesian(paddles.radius, -2.3), "paddles: r_p ± w_p", Role.PLAIN),
        Words(to_cartesian(bricks.radius, -2.3), "bricks: r_b ± w_b", Role.PLAIN),
    ]


def _band_marks(ring: Ring, r: float, role: Role, name: str) -> list[Mark]:
    """Where the ball's centre is while the ball can touch a ring."""
    return [
        Annulus(max(ring.inner_radius - r, 0.0), ring.outer_radius + r, role, Toggle.BANDS, 0.3),
        Words(to_cartesian(ring.radius, 2.5), f"p here: may touch {name}", Role.PLAIN, Toggle.BANDS),
    ]


def _formula(given: Given) -> tuple[str, ...]:
    """The three tests, in the source's order, and the outcome."""
    p, r, r_g = given.point("ball"), given.number("r"), given.number("r_g")
    distance = length(p)
    low, high = distance - r, distance + r
    lines = [f"|p| - r = {low:.2f} {'>' if low > r_g else '≤'} r_g = {r_g:g}"]
    for letter, ring in zip("pb", _rings(given), strict=True):
        inner, outer = ring.inner_radius, ring.outer_radius
        lines.append(
            f"|p| + r = {high:.2f} {'≥' if high >= inner else '<'} r_{letter} - w_{letter} = {inner:.2f}   and   "
            f"|p| - r = {low:.2f} {'≤' if low <= outer else '>'} r_{letter} + w_{letter} = {outer:.2f}"
        )
    return (*lines, f"so: {_outcome(given).value}")


def _cited(outcome: Outcome) -> CitedLine:
    """The test that decided."""
    if outcome is Outcome.GAME_OVER:
        return code_line(has_left, "return length(p) - ball_radius > ground_radius")
    if outcome is Outcome.NO_COLLISION:
        return code_line(broad_phase_outcome, "return NO_COLLISION")
    return code_line(
        in_band,
        "distance + ball_radius >= ring.radius - ring.half_width and distance - ball_radius <= ring.radius + ring.half_width",
    )


def _note(outcome: Outcome, distance: float) -> str:
    """What the bands mean, and what follows."""
    if distance == 0.0:
        return "The ball is on the centre: it has no angle there, but the broad phase asks only for its distance."
    if outcome is Outcome.GAME_OVER:
        return "The source's game is over. Here the ball costs one life, once, and the game ends with the last."
    if outcome is Outcome.NO_COLLISION:
        return "The ball's centre is in no coloured band. A band is a ring, dashed, grown by r on both sides."
    ring = "paddles" if outcome is Outcome.PADDLES else "bricks"
    return f"p is in the band of the {ring}: the ring, dashed, grown by r on both sides. Next: which of its sectors is nearest?"


def _check(given: Given) -> tuple[Claim, ...]:
    """The outcome is what the narrow phase finds for closed rings, and does not depend on the ball's angle."""
    p, r, r_g = given.point("ball"), given.number("r"), given.number("r_g")
    paddles, bricks = _rings(given)
    outcome, distance = _outcome(given), length(p)
    gaps = [contact(Ball(p, 0j, r), ring, 0).gap for ring in (paddles, bricks)]
    margins = [abs(distance - r - r_g), *[abs(gap) for gap in gaps]]
    turned = to_cartesian(distance, normalize_angle(to_polar(p)[1] + 1.0))
    elsewhere = broad_phase_outcome(turned, r, r_g, paddles, [bricks])
    touching = [gap <= 0.0 for gap in gaps]
    expected = (
        Outcome.GAME_OVER
        if distance - r > r_g
        else Outcome.PADDLES
        if touching[0]
        else Outcome.BRICKS
        if touching[1]
        else Outcome.NO_COLLISION
    )
    return (
        Claim("the outcome is what a closed ring would feel", outcome is expected or min(margins) < 1e-9),
        Claim("it does not depend on the ball's angle", outcome is elsewhere or min(margins) < 1e-9),
        Claim("no collision means no contact", outcome is not Outcome.NO_COLLISION or min(gaps) > -1e-9),
    )


def _on_axis(name: str, label: str, turn: float) -> Handle:
    """A radius, dragged along a bearing."""
    return Handle(
        label, lambda given: to_cartesian(given.number(name), turn), lambda _given, position: {name: length(position)}
    )


SCENE = LabScene(
    name="broad-phase",
    title="Broad phase: four outcomes",
    idea="The distance from the centre alone says which ring a ball can touch; most of the time it can touch none.",
    functions=("broad_phase",),
    parameters=(
        Point("ball", "p", -20.0, 20.0, 4 + 8.2j, meaning="the ball's centre"),
        Number("r", "r", "", 0.1, 3.0, 0.8, 0.05, "the ball's radius"),
        Number("r_g", "r_g", "", 5.0, 15.0, 12.0, 0.1, "the ground's radius"),
        Number("r_p", "r_p", "", 2.1, 14.0, 10.0, 0.1, "the paddles' middle radius"),
        Number("w_p", "w_p", "", 0.05, 2.0, 0.4, 0.05, "their half width"),
        Number("r_b", "r_b", "", 2.1, 14.0, 5.0, 0.1, "the bricks' middle radius"),
        Number("w_b", "w_b", "", 0.05, 2.0, 1.0, 0.05, "their half width"),
    ),
    handles=(
        handles.point("ball", "ball", "r"),
        _on_axis("r_g", "r_g", 0.0),
        _on_axis("r_p", "r_p", 0.0),
        _on_axis("r_b", "r_b", 0.0),
    ),
    view_box=ViewBox(0j, 14.8 + 13.4j),
    shows=_picture,
    check=_check,
    rows=(9,),
    presets=(
        Preset("no collision", "ball=6,5"),
        Preset("bricks", "ball=4,4"),
        Preset("paddles", "ball=8.5,-5"),
        Preset("game over", "ball=10,9"),
        Preset("just not over", "ball=12.8,0"),
        Preset("the ball on the centre", "ball=0,0"),
    ),
)
