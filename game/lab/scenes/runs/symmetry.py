"""The same game turned by any angle, and mirrored."""

import math
from itertools import pairwise
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import code_line
from game.lab.kit.marks import VELOCITY_SCALE, degrees, ray, ring_marks
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Picture, Role, Stroke, Toggle
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Hit, Ring, advance, contact, direction, dot, length, to_cartesian

_RADIUS = 0.4
_BRICKS, _PADDLES = 9, 3
_TRAIL = 96
_RUN = 72
_SCALE = VELOCITY_SCALE


class _ThreeGames(NamedTuple):
    """One game three times. trails: the last positions of the ball in each."""

    plain: Arena
    turned: Arena
    mirrored: Arena
    hits: int
    trails: tuple[tuple[complex, ...], ...]


def _start(given: Given) -> _ThreeGames:
    """Turning paddles, a ring of bricks, a wall; then the same turned by alpha, and mirrored at the x axis."""
    ball = Ball(given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading")), _RADIUS)
    rings = (
        Ring(8.0, 0.4, 0.5, _PADDLES, 0.7, given.number("spin"), 0.5),
        Ring(3.5, 0.6, 0.22, _BRICKS, 0.3),
        Ring(10.5, 0.3, math.pi, 1),
    )
    plain = Arena((ball,), rings, ((PERMANENT,) * _PADDLES, (2,) * _BRICKS, (PERMANENT,)))
    turned, mirrored = _turned(plain, given.angle("alpha")), _mirrored(plain)
    return _ThreeGames(plain, turned, mirrored, 0, tuple([(arena.balls[0].position,) for arena in (plain, turned, mirrored)]))


def _turned(arena: Arena, alpha: float) -> Arena:
    """An arena turned about the centre."""
    turn, ball = direction(alpha), arena.balls[0]
    rings = tuple([Ring(*ring[:4], ring.phase + alpha, ring.spin, ring.friction) for ring in arena.rings])
    return Arena((Ball(ball.position * turn, ball.velocity * turn, ball.radius),), rings, arena.layers)


def _mirrored(arena: Arena) -> Arena:
    """An arena mirrored at the x axis: slot k becomes slot -k."""
    ball = arena.balls[0]
    rings = tuple([Ring(*ring[:4], -ring.phase, -ring.spin, ring.friction) for ring in arena.rings])
    layers = tuple([(row[0], *row[:0:-1]) for row in arena.layers])
    return Arena((Ball(ball.position.conjugate(), ball.velocity.conjugate(), ball.radius),), rings, layers)


def _step(given: Given, state: _ThreeGames) -> _ThreeGames:
    """A tick later, three times."""
    speed = given.number("speed")
    steps = [advance(arena, TICK, speed) for arena in state[:3]]
    plain, turned, mirrored = [step.arena for step in steps]
    trails = [(*trail, step.arena.balls[0].position)[-_TRAIL:] for trail, step in zip(state.trails, steps, strict=True)]
    return _ThreeGames(plain, turned, mirrored, state.hits + len(steps[0].hits), tuple(trails))


def _picture(given: Given, state: _ThreeGames) -> Picture:
    """Three games side by side."""
    alpha = given.angle("alpha")
    titles = ("a game", f"turned by {degrees(alpha)}", "mirrored")
    axes = (ray(0.0, 11.0), ray(alpha, 11.0), Line((-11 + 0j, 11 + 0j), Role.FAINT, None, Stroke.DASHED))
    panes = [
        Pane((axis, *_marks(arena, trail)), title, has_handles=arena is state.plain)
        for title, axis, arena, trail in zip(titles, axes, state[:3], state.trails, strict=True)
    ]
    panes[0] = panes[0]._replace(marks=(*panes[0].marks, *_first(given)))
    cited = code_line(Ring.angle, "return subtract_angles(self.phase, (self.count - slot) / self.count * math.tau)")
    return Picture(tuple(panes), _formula(given, state), cited, _note(given, state))


def _first(given: Given) -> tuple[Mark, ...]:
    """Where the ball began, and its velocity there."""
    position, velocity = given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading"))
    return Circle(position, _RADIUS, Role.GHOST, None, Stroke.DASHED), Arrow(position, velocity * _SCALE, Role.PLAIN, label="v")


def _marks(arena: Arena, trail: tuple[complex, ...]) -> tuple[Mark, ...]:
    """The rings, the ball, and its path."""
    paddles, bricks, wall = arena.rings
    return (
        *ring_marks(wall, nearest=-1),
        *ring_marks(paddles),
        *ring_marks(bricks, arena.layers[1], nearest=0),
        Line(trail, Role.OURS, Toggle.SWEPT),
        Disc(arena.balls[0].position, _RADIUS, Role.BALL),
    )


def _differences(given: Given, state: _ThreeGames) -> tuple[float, float]:
    """Distances of the plain ball from the turned one, turned back, and from the mirrored one, mirrored back."""
    p = state.plain.balls[0].position
    back = state.turned.balls[0].position * direction(-given.angle("alpha"))
    return length(back - p), length(state.mirrored.balls[0].position.conjugate() - p)


def _formula(given: Given, state: _ThreeGames) -> tuple[str, ...]:
    """Both differences."""
    turned, mirrored = _differences(given, state)
    same = [state.plain.layers == state.turned.layers, state.plain.layers == _mirrored(state.mirrored).layers]
    return (
        f"the turned ball, turned back:   |p_2 - p| = {turned:.1e}",
        "the mirrored ball, mirrored back:   |p_3 - p| = " + (f"{mirrored:.1e}" if mirrored else "0:   equal to the last bit"),
        f"bounces: {state.hits};   the same bricks hit: {'yes' if all(same) else 'no'}",
    )


def _note(given: Given, state: _ThreeGames) -> str:
    """What is happening."""
    start = _start(given).plain
    if min([contact(start.balls[0], ring, slot).gap for ring in start.rings for slot in range(ring.count)]) < 0.0:
        return "The ball starts in the material: it is pushed out before it flies, in all three games."
    if _differences(given, state)[0] > 1e-6:
        return "The turned game rounds differently in the last bits, and every bounce off a round surface multiplies that."
    return "No direction is special, not even the polar axis. The mirrored game is exact, since -θ is exact for every phase θ."


def _check(given: Given) -> tuple[Claim, ...]:
    """A third of a second of the three games."""
    states, hits = [_start(given)], list[Hit]()
    speed = given.number("speed")
    freed = 0
    for _ in range(_RUN):
        step = advance(states[-1].plain, TICK, speed)
        freed += step.freed
        hits += step.hits
        states.append(_step(given, states[-1]))
    end = states[-1]
    turned, mirrored = _differences(given, end)
    tie = any([a.time == b.time for a, b in pairwise(hits)])
    sharp = all([dot(hit.before, hit.contact.normal) < -0.02 * speed for hit in hits])
    plain = freed == 0 and not tie
    return (
        Claim("the mirrored game is the same to the last bit", not plain or mirrored == 0.0),
        Claim("its bricks are the same", not plain or _mirrored(end.mirrored).layers == end.plain.layers),
        Claim("the turned game is the same but for rounding", not (plain and sharp) or turned < 1e-7),
        Claim("turned by 0°, it is the same to the last bit", given.angle("alpha") > 0.0 or turned == 0.0),
        Claim("the speed is v_0 in all three", all([_keeps(arena, speed) for arena in end[:3]])),
    )


def _keeps(arena: Arena, speed: float) -> bool:
    """Whether the ball has the speed v_0."""
    return abs(length(arena.balls[0].velocity) - speed) < 1e-9


SCENE = LabScene(
    name="symmetry",
    title="Turned and mirrored",
    idea="The physics knows no special direction and no preferred sense of turning: turned or mirrored, a game is the same.",
    functions=("advance", "normalize_angle"),
    parameters=(
        Number("alpha", "β", "°", 0.0, 360.0, 137.5, 0.5, "the angle by which the second is turned"),
        Point("ball", "p", -9.0, 9.0, 5.6 - 1.5j, meaning="the ball's centre at first"),
        Number("heading", "ψ", "°", 0.0, 360.0, 151.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 1.0, 20.0, 10.0, 0.5, "the ball's fixed speed"),
        Number("spin", "ω", "rad/s", -1.0, 1.0, 0.6, 0.05, "the paddles' spin"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball"),
    ),
    view_box=ViewBox(0j, 11.2 + 11.2j),
    shows=Motion(_start, _step, _picture, ticks=960),
    check=_check,
    presets=(
        Preset("turned by the golden angle", "alpha=137.5"),
        Preset("a quarter", "alpha=90"),
        Preset("across the polar axis", "alpha=359.5&ball=6,0.2&heading=180"),
        Preset("not at all", "alpha=0"),
        Preset("fast paddles", "spin=1&speed=14"),
    ),
)
