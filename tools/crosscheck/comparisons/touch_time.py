"""Comparison c: when does the ball first touch a resting ring, by pymunk's segment queries and by the game?"""

import cmath
import math

from tools.crosscheck.comparisons.hit_frame import Moment, Scene
from tools.crosscheck.games.trajectory import Leg, Tick
from tools.crosscheck.pymunk_model import facets
from tools.crosscheck.pymunk_model.ring_model import RingModel
from tools.crosscheck.pymunk_model.sweep import Window, first_touch
from tools.crosscheck.results.cases import Class, Comparison
from tools.crosscheck.results.rows import Rows

_ROUNDING = 2.0**-50
"""Fraction of a ray as long as the arena: what rounding makes of pymunk's place on it."""

_NO_VECTORS = (0j, 0j)


def checked_time(scene: Scene, leg: Leg, rows: Rows, moment: Moment | None) -> Class:
    """Compare one leg's end with the first touch that pymunk finds; the class of the difference.

    moment: of the hit that ended the leg; None for a leg that ended with the tick. On turning rings the path is no straight
    segment in pymunk's frame: a hit there is not compared in time, but no resting ring may have been touched before it.
    """
    tick, flight = scene.tick, leg.stop - leg.start
    if not flight or _others_break(tick, leg):
        return Class.EXACT
    radius = tick.arena.balls[leg.ball].radius
    windows = {}
    for k, ring in enumerate(tick.arena.rings):
        model = scene.models[k]
        reach = abs(leg.velocity) * flight + radius + model.sagitta
        in_reach = abs(abs(leg.position) - ring.radius) - ring.half_width <= reach + facets.contact_noise(ring.outer_radius)
        if ring.spin == 0.0 and (in_reach or (moment is not None and moment.hit.ring == k)):
            windows[k] = _window(leg, radius, model, ring.phase, flight)
    late = min((window.late for window in windows.values()), default=math.inf)
    if late < flight:
        return _missed(scene, leg, rows, moment, (flight - late, min(windows, key=lambda k: windows[k].late)))
    if moment is None or moment.hit.ring not in windows:
        return Class.EXACT
    return _compared(moment, rows, windows, flight)


def _compared(moment: Moment, rows: Rows, windows: dict[int, Window], flight: float) -> Class:
    """Our time of impact against pymunk's."""
    early = min(window.early for window in windows.values())
    middle = min(window.middle for window in windows.values())
    late = min(window.late for window in windows.values())
    if math.isinf(late) and early <= flight:
        what = f"pymunk touches {'a ball larger by the sagitta' if math.isinf(middle) else 'this ball, but not a smaller one'}"
        rows.disagree(moment.case(Class.GRAZING, Comparison.TIME, what, (abs(middle - flight), math.inf), _NO_VECTORS))
        return Class.GRAZING
    error, bound = abs(middle - flight), late - early
    if early > flight:
        what = "the game bounced before pymunk touches (invented bounce)"
        rows.measure(moment, Class.UNEXPLAINED, Comparison.TIME, what, (error, bound), _NO_VECTORS)
        return Class.UNEXPLAINED
    rows.measure(moment, Class.FACETS, Comparison.TIME, "seconds between the two first touches", (error, bound), _NO_VECTORS)
    return Class.EXACT


def _missed(scene: Scene, leg: Leg, rows: Rows, moment: Moment | None, found: tuple[float, int]) -> Class:
    """pymunk touches a ring for certain, seconds before the leg ends."""
    error, ring = found
    what = "pymunk touches earlier than the game bounces (missed bounce)"
    if moment is not None:
        rows.measure(moment, Class.UNEXPLAINED, Comparison.TIME, what, (error, 0.0), _NO_VECTORS)
    else:
        rows.report(scene.case(Comparison.TIME, what, (error, 0.0), (leg.ball, ring), leg.end, leg.stop))
    return Class.UNEXPLAINED


def _window(leg: Leg, ball_radius: float, model: RingModel, angle: float, flight: float) -> Window:
    """The first touch with one resting ring, in its frame."""
    turn = cmath.rect(1.0, -angle)
    noise = facets.contact_noise(model.geometry.outer) + _ROUNDING * model.geometry.outer
    span = flight + 2.0 * noise / max(abs(leg.velocity), noise)
    return first_touch(model, leg.position * turn, leg.velocity * turn, ball_radius, span, noise)


def _others_break(tick: Tick, leg: Leg) -> bool:
    """Whether another ball breaks a brick during this tick: what stood in the way at which moment is then not one answer."""
    return any(hit.ball != leg.ball and hit.layers == 0 for hit in tick.step.hits)
