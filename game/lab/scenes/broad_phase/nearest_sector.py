"""Which of many sectors is nearest: the source's search beside the arithmetic for evenly spaced slots."""

import math

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import ball_marks, contact_marks, degrees, gap_words, ray, ring_marks, second_opinion
from game.lab.kit.parameters import Count, Given, Number, Point
from game.lab.kit.picture import (
    AnnularSector,
    Line,
    Mark,
    Picture,
    Prediction,
    Role,
    Stroke,
    Words,
    in_steps,
    one_step,
)
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import (
    Ball,
    Ring,
    angle_of,
    broad_phase,
    contact,
    length,
    min_difference,
    nearest_slot,
    normalize_angle,
    to_cartesian,
)

_RADIUS, _HALF_WIDTH = 8.0, 0.9
_NUMBERED = 16
"""Slots up to this many have their number written on them."""


def _ring(given: Given) -> Ring:
    """Evenly spaced sectors."""
    count = given.count("n")
    return Ring(_RADIUS, _HALF_WIDTH, given.number("fill") * math.pi / count, count, given.angle("phase"))


def _ball(given: Given) -> Ball:
    """The ball."""
    return Ball(given.point("ball"), 0j, given.number("r"))


def _picture(given: Given) -> Picture:
    """The sectors, the nearest one bright, and the bearings halfway between neighbours."""
    ring, ball = _ring(given), _ball(given)
    theta = angle_of(ball.position)
    slot = nearest_slot(ring, theta)
    found = contact(ball, ring, slot)
    situation: list[Mark] = [*ring_marks(ring, None, -1), *ball_marks(ball.position, ball.radius)]
    if ring.count <= _NUMBERED:
        situation += [Words(to_cartesian(_RADIUS, ring.angle(k)), str(k), Role.PLAIN) for k in range(ring.count)]
    neighbours = tuple({(slot + step) % ring.count: None for step in (-1, 0, 1)})
    nearest = AnnularSector(ring.radius, ring.half_width, ring.angle(slot), ring.half_angle, Role.SECTOR)
    contact_drawn = [*contact_marks(ball, found, 2.0), *second_opinion(given, ball, ring, neighbours, found)]
    difference = min_difference(theta, ring.angle(slot))
    pitch, face = math.tau / ring.count, difference <= ring.half_angle
    searched = f"the least min_difference(θ, θ_p) is {degrees(difference)}, of sector {slot}"
    turned = f"round({_turned(theta, ring) / pitch:.2f}) mod {ring.count} = {slot}"
    steps = (
        one_step("a ball and a ring of sectors", situation),
        one_step("θ, the ball's angle", [ray(theta, 11.0)], [f"θ = {degrees(theta)}"]),
        one_step(
            "the search of the source",
            [nearest],
            [f"the source searches all {ring.count}:   {searched}"],
            Prediction("nearest sector", None, to_cartesian(_RADIUS, ring.angle(slot))),
        ),
        one_step("the same by a division", _borders(ring), [f"here:   round((θ - θ_0) / (2π / n)) mod n = {turned}"]),
        one_step(
            "case 1 or case 2, and the contact",
            contact_drawn,
            [
                f"min_difference {'≤' if face else '>'} φ_p = {degrees(ring.half_angle)}:   case {1 if face else 2}",
                gap_words(found.gap),
            ],
        ),
    )
    return in_steps(steps, _cited(), _note(given, ring, ball))


def _borders(ring: Ring) -> list[Mark]:
    """The bearings at which two neighbours are equally near."""
    angles = [ring.angle(k) + math.pi / ring.count for k in range(ring.count)] if ring.count > 1 else []
    return [Line((to_cartesian(5.0, angle), to_cartesian(14.0, angle)), Role.FAINT, None, Stroke.DASHED) for angle in angles]


def _turned(theta: float, ring: Ring) -> float:
    """The ball's angle from slot 0, in (-pi, pi]."""
    turn = normalize_angle(theta - ring.phase)
    return turn - math.tau if turn > math.pi else turn


def _cited() -> CitedLine:
    """The arithmetic that replaces the search."""
    return code_line(nearest_slot, "return round(signed_difference(theta, ring.phase) / pitch) % ring.count")


def _note(given: Given, ring: Ring, ball: Ball) -> str:
    """What is special about these values."""
    if ball.position == 0.0:
        return "The ball is on the centre: every sector is equally near, and by convention its angle is 0."
    touched = _touched(ring, ball)
    if len(touched) > 1:
        return f"The ball touches {len(touched)} sectors. One nearest is not enough: each is answered, in the order of time."
    if given.number("fill") == 1.0:
        return "The sectors meet: the ring is closed, and there are no ends to hit."
    return ""


def _touched(ring: Ring, ball: Ball) -> list[int]:
    """The slots that the ball touches."""
    return [slot for slot in range(ring.count) if contact(ball, ring, slot).gap < 0.0]


def _check(given: Given) -> tuple[Claim, ...]:
    """The arithmetic against the search, and the search against the contacts themselves."""
    ring, ball = _ring(given), _ball(given)
    theta = angle_of(ball.position)
    slot = nearest_slot(ring, theta)
    differences = [min_difference(theta, ring.angle(k)) for k in range(ring.count)]
    gaps = [contact(ball, ring, k).gap for k in range(ring.count)]
    positions = [(_RADIUS, ring.angle(k)) for k in range(ring.count)]
    normal = broad_phase(ball.position, ball.radius, theta, positions, _HALF_WIDTH, ring.half_angle)
    ends = differences[slot] > ring.half_angle
    asked = ends and abs(differences[slot] - ring.half_angle) > 1e-9 and abs(gaps[slot]) > 1e-9
    return (
        Claim("the arithmetic finds the least difference of the search", differences[slot] <= min(differences) + 1e-9),
        Claim("no other sector is nearer to the ball", gaps[slot] <= min(gaps) + 1e-9 or _inside(ring, ball)),
        Claim(
            "at an end, broad_phase has a normal exactly where they touch",
            not asked or _has(normal) == (gaps[slot] < 0.0),
        ),
        Claim("over a face, broad_phase always has a normal", ends or normal is not None),
    )


def _has(normal: complex | None) -> bool:
    """Whether there is a normal."""
    return normal is not None


def _inside(ring: Ring, ball: Ball) -> bool:
    """Whether the ball's centre is between the two radii, where the sector nearest in angle need not be the nearest."""
    return ring.inner_radius < length(ball.position) < ring.outer_radius


SCENE = LabScene(
    name="nearest-sector",
    title="Broad phase: the nearest sector",
    idea="The source searches a list for the angle nearest to the ball's; evenly spaced slots turn the search into a division.",
    functions=("broad_phase", "min_difference"),
    parameters=(
        Point("ball", "p", -13.0, 13.0, 8.6 + 5.2j, meaning="the ball's centre"),
        Number("r", "r", "", 0.1, 3.0, 0.8, 0.05, "the ball's radius"),
        Count("n", "n", 1, 60, 9, "sectors"),
        Number("fill", "φ_p n / π", "", 0.05, 1.0, 0.7, 0.01, "share of the ring that is filled"),
        Number("phase", "θ_0", "°", 0.0, 360.0, 0.0, 0.5, "middle angle of sector 0"),
    ),
    handles=(
        handles.point("ball", "ball", "r"),
        handles.on_circle("phase", lambda _: _RADIUS + _HALF_WIDTH, "θ_0: turn the ring"),
    ),
    view_box=ViewBox(0j, 11.8 + 11.2j),
    shows=_picture,
    check=_check,
    rows=(8,),
    presets=(
        Preset("across the polar axis", "ball=9.5,-1&phase=10"),
        Preset("between two: both are touched", "ball=8.2,2.98&n=9&fill=0.75&r=0.9"),
        Preset("three paddles", "n=3&fill=0.3"),
        Preset("sixty bricks", "n=60&fill=0.8&r=0.4"),
        Preset("a closed ring", "fill=1"),
        Preset("the ball on the centre", "ball=0,0"),
    ),
    engine_use=EngineUse.TOGGLE,
)
