"""Overlap tested once a frame, beside the exact time of impact."""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Count, Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Picture, PointMark, Role, Stroke, Toggle
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Ring, advance, cross, in_band, length, to_cartesian
from physics.time_of_impact import first_impact

_RADIUS = 8.0
_TICKS_PER_SECOND = round(1.0 / TICK)
_TRAIL = 24
_GRAZING = 0.99
_SCALE = VELOCITY_SCALE / 2.0


class _BallAndWall(NamedTuple):
    """The ball and the wall that the values make. rate: frames per second."""

    ball: Ball
    wall: Ring
    speed: float
    rate: int

    @property
    def inside(self) -> bool:
        """Whether the ball starts in the hole of the ring, clear of the wall."""
        return length(self.ball.position) + self.ball.radius < self.wall.inner_radius

    @property
    def grazes(self) -> bool:
        """Whether the ball flies nearly along the wall."""
        lever = abs(cross(self.ball.position, self.ball.velocity)) / self.speed
        return lever > _GRAZING * (self.wall.inner_radius - self.ball.radius)


class _BothLoops(NamedTuple):
    """Both balls after the last frame.

    theirs: the source's ball. seen: frames in which its test found an overlap. trail: its positions, frame by frame.
    ours: the swept ball. path: where it started and where it bounced.
    """

    tick: int
    frames: int
    theirs: source.SourceBall
    seen: int
    trail: tuple[complex, ...]
    ours: Ball
    hits: int
    path: tuple[complex, ...]


def _ball_and_wall(given: Given) -> _BallAndWall:
    """The ball and the wall."""
    speed, r = given.number("speed"), given.number("r")
    ball = Ball(given.point("ball"), to_cartesian(speed, given.angle("heading")), r)
    return _BallAndWall(ball, Ring(_RADIUS, given.number("half_width"), math.pi, 1), speed, given.count("rate"))


def _start(given: Given) -> _BothLoops:
    """The first frame."""
    ball = _ball_and_wall(given).ball
    here = (ball.position,)
    return _BothLoops(0, 0, source.SourceBall(ball.position, ball.velocity), 0, here, ball, 0, here)


def _step(given: Given, state: _BothLoops) -> _BothLoops:
    """A tick later: the next frame, when it is due."""
    tick = state.tick + 1
    setup = _ball_and_wall(given)
    due = tick * setup.rate // _TICKS_PER_SECOND > state.frames
    return _next_frame(setup, state)._replace(tick=tick) if due else state._replace(tick=tick)


def _next_frame(setup: _BallAndWall, state: _BothLoops) -> _BothLoops:
    """Both balls one frame later."""
    dt, wall = 1.0 / setup.rate, setup.wall
    theirs = source.frame(state.theirs, setup.ball.radius, (wall,), dt, setup.speed)
    seen = in_band(length(theirs.position), setup.ball.radius, wall)
    after = advance(Arena((state.ours,), (wall,), ((PERMANENT,),)), dt, setup.speed)
    touched = [hit.contact.point + hit.contact.normal * setup.ball.radius for hit in after.hits]
    return state._replace(
        frames=state.frames + 1,
        theirs=theirs,
        seen=state.seen + seen,
        trail=(*state.trail, theirs.position)[-_TRAIL:],
        ours=after.arena.balls[0],
        hits=state.hits + len(after.hits),
        path=(*state.path, *touched)[-_TRAIL:],
    )


def _picture(given: Given, state: _BothLoops) -> Picture:
    """The source's ball frame by frame, and ours with its whole path."""
    setup = _ball_and_wall(given)
    r, wall = setup.ball.radius, ring_marks(setup.wall)
    theirs: list[Mark] = [*wall, Line(state.trail, Role.GHOST, Toggle.SWEPT, Stroke.DASHED)]
    theirs += [Circle(position, r, Role.SOURCE, Toggle.SWEPT) for position in state.trail[:-1]]
    ours: list[Mark] = [*wall, Line((*state.path, state.ours.position), Role.OURS, Toggle.SWEPT)]
    ours += [Circle(position, r, Role.OURS, Toggle.SWEPT) for position in state.path[1:]]
    for marks, position in ((theirs, state.theirs.position), (ours, state.ours.position)):
        marks.append(Disc(position, r, Role.BALL))
        if state.frames == 0:
            marks.append(Arrow(position, setup.ball.velocity * _SCALE, Role.PLAIN, label="v"))
        else:
            marks.append(PointMark(position, Role.FAINT))
    panes = (
        Pane(tuple(theirs), f"the source: {setup.rate} tests a second"),
        Pane(tuple(ours), f"swept: {setup.rate} steps a second"),
    )
    return Picture(panes, _formula(setup, state), _cited(setup, state), _note(setup, state))


def _formula(setup: _BallAndWall, state: _BothLoops) -> tuple[str, ...]:
    """How far the ball flies in a frame, and what the last test found."""
    r, w = setup.ball.radius, setup.wall.half_width
    distance = length(state.theirs.position)
    overlap = "yes" if in_band(distance, r, setup.wall) else "no"
    return (
        f"a frame's flight:   v_0 / f = {setup.speed:g} / {setup.rate} = {setup.speed / setup.rate:.3f}",
        f"the wall and the ball:   2 (w_p + r) = {2.0 * (w + r):.3f}",
        f"the source, frame {state.frames}:   |p| = {distance:.3f},   overlap: {overlap},   so far {state.seen}",
        f"swept:   |p| = {length(state.ours.position):.3f},   bounces so far {state.hits}",
    )


def _is_out(setup: _BallAndWall, state: _BothLoops) -> bool:
    """Whether the source's ball is outside the wall."""
    return setup.inside and length(state.theirs.position) - setup.ball.radius > setup.wall.outer_radius


def _cited(setup: _BallAndWall, state: _BothLoops) -> CitedLine:
    """The test that found nothing, or the sweep."""
    if _is_out(setup, state):
        return source_line("Broad phase", "|p| + r ≥ r_p - w_p and |p| - r ≤ r_p + w_p")
    return code_line(first_impact, "impact = None if inward is None else _first_touch(ball, ring, inward, alive)")


def _note(setup: _BallAndWall, state: _BothLoops) -> str:
    """What has happened."""
    if not setup.inside:
        return "The ball does not start inside the wall. Drag it there."
    if _is_out(setup, state) and state.seen == 0:
        return "Through the wall: before it in one frame, behind it in the next, and no test found an overlap."
    if _is_out(setup, state):
        return "Through the wall: a test found the ball's centre beyond r_p, where case 1 takes the outer face."
    if setup.speed / setup.rate > 2.0 * (setup.ball.radius + setup.wall.half_width):
        return (
            "A frame's flight is longer than the wall and the ball together, so the ball can pass the wall between two tests."
        )
    return "No crossing is missed at this speed, but each is found up to a frame late: the source's ball bounces too late."


def _check(given: Given) -> tuple[Claim, ...]:
    """A second of flight: what is conserved, independence of the frame rate, and the flight backwards in time."""
    setup = _ball_and_wall(given)
    smooth = setup.inside and not setup.grazes
    states, out = [_start(given)], False
    for _ in range(setup.rate):
        states.append(_next_frame(setup, states[-1]))
        out |= _is_out(setup, states[-1]) and states[-1].seen == 0
    end = states[-1].ours
    spins = [abs(cross(state.ours.position, state.ours.velocity)) for state in states]
    farthest = max([length(state.ours.position) for state in states]) + setup.ball.radius
    fine = _flown(setup, setup.ball, 2 * setup.rate)
    home = _flown(setup, Ball(end.position, -end.velocity, end.radius), setup.rate)
    return (
        Claim("our ball stays inside the wall", not setup.inside or farthest < setup.wall.inner_radius + 1e-9),
        Claim("our ball has the speed v_0", abs(length(end.velocity) - setup.speed) < 1e-9),
        Claim("its angular momentum does not change", not smooth or max(spins) - min(spins) < 1e-9 * _RADIUS * setup.speed),
        Claim("twice as many frames lead to the same position", not smooth or length(fine.position - end.position) < 1e-6),
        Claim("flown backwards, it comes back to its start", not smooth or length(home.position - setup.ball.position) < 1e-6),
        Claim(
            "the source's ball passes unseen only where a frame's flight is longer than 2 (w_p + r)",
            not out or setup.speed / setup.rate > 2.0 * (setup.wall.half_width + setup.ball.radius),
        ),
    )


def _flown(setup: _BallAndWall, ball: Ball, frames: int) -> Ball:
    """Our ball a second later, in so many steps."""
    arena = Arena((ball,), (setup.wall,), ((PERMANENT,),))
    for _ in range(frames):
        arena = advance(arena, 1.0 / frames, setup.speed).arena
    return arena.balls[0]


SCENE = LabScene(
    name="discrete-swept",
    title="Discrete against swept",
    idea="Tested once a frame, a fast ball is before the wall and then behind it. The time of impact misses nothing.",
    functions=("narrow_phase_case_1", "collision_response"),
    parameters=(
        Count("rate", "f", 5, 240, 20, "frames per second"),
        Number("speed", "v_0", "", 1.0, 60.0, 24.0, 0.5, "the ball's fixed speed"),
        Point("ball", "p", -7.0, 7.0, -4.0 - 2j, meaning="the ball's centre at first"),
        Number("heading", "ψ", "°", 0.0, 360.0, 60.0, 0.5, "direction of v"),
        Number("r", "r", "", 0.05, 1.0, 0.3, 0.05, "the ball's radius"),
        Number("half_width", "w_p", "", 0.02, 1.0, 0.1, 0.02, "the wall's half width"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
    ),
    view_box=ViewBox(0j, 10.5 + 10.5j),
    shows=Motion(_start, _step, _picture, ticks=480),
    check=_check,
    rows=(6,),
    presets=(
        Preset("20 tests a second", "rate=20"),
        Preset("60 tests a second: late, but not through", "rate=60"),
        Preset("240 tests a second", "rate=240"),
        Preset("a thin wall, a small fast ball", "rate=60&speed=60&r=0.1&half_width=0.02"),
        Preset("head-on, found too late", "rate=25&speed=22&ball=-6,0&heading=0&half_width=0.3"),
        Preset("grazing", "ball=-7,0&heading=95&rate=30"),
    ),
)
