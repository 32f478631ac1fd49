"""Comparison g: balls that the physics put outside material, or stopped. Did they overlap before, and are they free after?"""

import cmath
import math
from typing import NamedTuple

from tools.crosscheck.comparisons.hit_frame import CheckedTick
from tools.crosscheck.games.trajectory import FlightPath
from tools.crosscheck.pymunk_model import rounding
from tools.crosscheck.results.measurements import Compared, Comparison, ContactVerdict, Measurement
from tools.crosscheck.results.rows import ContactRows


def compare_freed_balls(checked: CheckedTick, index: int, path: FlightPath, rows: ContactRows) -> None:
    """Whether pymunk confirms what the physics did with a ball, before the models lose the layers of this tick's hits."""
    tick = checked.tick
    if path.freed is not None:
        _compare_move(checked, _Move(index, tick.arena.balls[index].position, path.freed, 0.0), rows)
    if path.freed_after:
        end = tick.step.arena.balls[index].position
        _compare_move(checked, _Move(index, path.legs[-1].end, end, tick.dt), rows)
    rows.dropped += path.dropped


class _Move(NamedTuple):
    """A ball that was put from one point to another, some seconds after the tick's start."""

    ball: int
    before: complex
    after: complex
    time: float


def _compare_move(checked: CheckedTick, move: _Move, rows: ContactRows) -> None:
    """Whether a ball that was put elsewhere overlapped material before, and does not after."""
    noise = rounding.contact_noise(max([model.geometry.outer for model in checked.models]), checked.tick.level.ball_radius)
    room = _room(checked, move.after, move.time)
    wrong = []
    if _room(checked, move.before, move.time) > -noise:
        wrong.append("the ball overlapped nothing before it was put elsewhere")
    if room < -noise:
        wrong.append("the ball still overlaps material where it was put")
    verdict = ContactVerdict.UNEXPLAINED if wrong else ContactVerdict.EXACT
    what = "; ".join(wrong) or "overlap after it was put outside"
    compared = Compared(Comparison.SET_FREE, verdict, what, max(-room, 0.0), noise)
    rows.report(Measurement(compared, checked.situation(move.ball, 0, move.after, move.time)))
    rows.freed += not wrong


def compare_numbers(checked: CheckedTick, freed: int, dropped: int, rows: ContactRows) -> None:
    """Whether as many balls were put outside, and stopped, as the physics says."""
    step = checked.tick.step
    if (freed, dropped) == (step.freed, step.dropped):
        return
    what = f"the physics freed {step.freed} and dropped {step.dropped} balls, their flights show {freed} and {dropped}"
    error = float(abs(step.freed - freed) + abs(step.dropped - dropped))
    compared = Compared(Comparison.SET_FREE, ContactVerdict.UNEXPLAINED, what, error, 0.0)
    position = checked.tick.step.arena.balls[0].position
    rows.report(Measurement(compared, checked.situation(0, 0, position, checked.tick.dt)))


def _room(checked: CheckedTick, position: complex, time: float) -> float:
    """World units between the ball's rim and the nearest shape of any ring; negative for an overlap."""
    radius = checked.tick.level.ball_radius
    room = math.inf
    for ring, model in zip(checked.tick.arena.rings, checked.models, strict=True):
        if model.living:
            local = position * cmath.rect(1.0, -(ring.phase + ring.spin * time))
            found = model.nearest_exact(local, 2.0 * radius)
            room = min(room, radius if found is None else found[1] - radius)
    return room
