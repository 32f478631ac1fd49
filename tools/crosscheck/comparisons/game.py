"""Every comparison over one trajectory."""

import cmath
import math
import time
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from typing import NamedTuple

from physics import Ball, Hit
from tools.crosscheck.comparisons.bounce import compare_bounce
from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.double_bounce import compare_double_bounce, compare_sole_bounce
from tools.crosscheck.comparisons.freed_balls import compare_freed_balls, compare_numbers
from tools.crosscheck.comparisons.hit_frame import CheckedTick, geometry_of, moment_of
from tools.crosscheck.comparisons.hit_offset_turn import compare_hit_offset_turns
from tools.crosscheck.comparisons.normals import across, compare_normals
from tools.crosscheck.comparisons.phases import PhaseBook
from tools.crosscheck.comparisons.rules import MOST_BOUNCES
from tools.crosscheck.comparisons.target import LayerBook, compare_target
from tools.crosscheck.comparisons.touch_time import compare_time, missed_touch
from tools.crosscheck.games.level_numbers import LevelNumbers
from tools.crosscheck.games.trajectory import Leg, Tick, flight_paths, one_bounce
from tools.crosscheck.pymunk_model import rounding
from tools.crosscheck.pymunk_model.presence import UNKNOWN, Room, room_around
from tools.crosscheck.pymunk_model.ring_model import RingModel, ring_model
from tools.crosscheck.results.coverage import CoverageCell, Judged, cell_of
from tools.crosscheck.results.measurements import ANYWHERE, Compared, Comparison, ContactVerdict, Measurement, Situation
from tools.crosscheck.results.rows import ContactRows

_BLOCK = 24
"""Ticks between two looks at the clock, and at whether there is enough."""
_NOWHERE = (0j, 0.0)
_STRAIGHT = 2.0**-50
"""Fraction of a coordinate: a few roundings."""
_SPARE = 1e-9
"""World units added to how far a ball moves in a tick: far above the noise of a contact, far below any distance that counts."""


class Checked(NamedTuple):
    """What checking one game gave.

    playing, checking, building: seconds of the processor for the game, for the comparisons, and for pymunk's models.
    """

    rows: ContactRows
    ticks: int
    playing: float
    checking: float
    building: float


class WantedChecks(NamedTuple):
    """What to do with a game.

    facets: of each arc in the chain. options: of the command that repeats the game. only: the one tick to compare, or None.
    recorded: whether every contact gets a record of its own. enough: unexplained measurements after which to stop, or None.
    """

    facets: int
    options: str
    only: int | None = None
    recorded: bool = False
    enough: int | None = None


def checked_ticks(ticks: Iterable[Tick], wanted: WantedChecks) -> Checked:
    """Compare a whole game."""
    checker = _Checker(wanted)
    playing = checking = 0.0
    count = 0
    source = iter(ticks)
    while True:
        before = time.process_time()
        block = list(islice(source, _BLOCK))
        between = time.process_time()
        for tick in block:
            if wanted.only is None or tick.number == wanted.only:
                checker.check(tick)
                count += 1
            else:
                checker.pass_by(tick)
        playing += between - before
        checking += time.process_time() - between
        if not block or (wanted.enough is not None and checker.rows.unexplained >= wanted.enough):
            return Checked(checker.rows, count, playing, checking - checker.building, checker.building)


class _Checker:
    """Both engines side by side through one game."""

    def __init__(self, wanted: WantedChecks) -> None:
        self.rows = ContactRows()
        self.building = 0.0
        self._poses_checked = self.rows.row(Comparison.PRESENCE_TICK, ANYWHERE)
        self._wanted = wanted
        self._level: LevelNumbers | None = None
        self._models: list[RingModel] = []
        self._book: LayerBook
        self._phases: PhaseBook
        self._layers: object = None  # of the game, as the models and the book have them
        self._rooms: dict[tuple[int, int], Room] = {}
        self._free: dict[int, tuple[complex, float]] = {}  # per ball: nothing reaches into this circle
        self._balls: object = None  # of the game, after the last tick
        self._straight = 0.0  # world units: the rounding of a ball's position after a tick

    def check(self, tick: Tick) -> None:
        """Compare one tick."""
        _, arena, dt, step, level, _ = tick
        balls, rings, layers = arena
        if level is not self._level:
            self._start(tick)
        self._phases.turn(rings)
        if not balls:
            return
        after = step.arena.balls
        undisturbed = balls is self._balls and layers is self._layers  # since the last tick, but by the physics
        self._balls = after
        followed = bool(step.hits or step.freed or step.dropped)
        if undisturbed and not followed and self._far_from_all(balls, after, dt):
            self._poses_checked.zeros += len(balls)
            return
        if followed:
            self._check_flights(tick)
        self._compare_layers(tick)
        suspect = False
        for i, ball in enumerate(after):
            near = self._near(tick, i, ball)
            if near or not self._flies_straight(balls[i], ball, dt):
                suspect = True
            overlaps = [k for k in near if self._rooms[i, k].room < 0.0]
            self._poses_checked.zeros += not overlaps
            for k in overlaps:
                self._overlap(tick, i, k)
        if suspect and not followed:
            self._check_flights(tick)

    def pass_by(self, tick: Tick) -> None:
        """A tick that is not compared: its hits take layers, its rings turn."""
        if tick.level is not self._level:
            self._start(tick)
        self._phases.turn(tick.arena.rings)
        if tick.step.arena.layers is not self._layers:
            self._layers = tick.step.arena.layers
            self._book.take_over(tick.step.arena.layers)
            self._show_layers()

    def _start(self, tick: Tick) -> None:
        """The models and the books of a level."""
        self._level = tick.level
        before = time.process_time()
        self._models = [ring_model(ring.geometry, self._wanted.facets) for ring in tick.level.rings]
        self.building += time.process_time() - before
        self._book, self._phases = LayerBook(tick.level), PhaseBook(tick.level, tick.dt)
        self._layers = None
        farthest = max([ring.geometry.outer for ring in tick.level.rings])
        self._straight = 2.0 * _STRAIGHT * (farthest + tick.level.speed)
        self._rooms.clear()
        self._free.clear()
        self._show_layers()
        for k, (ring, model) in enumerate(zip(tick.arena.rings, self._models, strict=True)):
            if geometry_of(ring) != model.geometry:
                self._report_ring(tick, k, "a ring of the game has not the level's sizes")

    def _show_layers(self) -> None:
        """Show the book's layers to pymunk."""
        for model, layers in zip(self._models, self._book.layers, strict=True):
            if model.set_alive(layers):
                self._rooms.clear()
        self._free.clear()

    def _compare_layers(self, tick: Tick) -> None:
        """Whether the game's layers are those that its hits left."""
        layers = tick.step.arena.layers
        if layers is self._layers:
            return
        difference = self._book.differs_from(layers)
        if difference is not None:
            compared = Compared(Comparison.TARGET, ContactVerdict.UNEXPLAINED, f"at the tick's end {difference}", 1.0, 0.0)
            self.rows.report(Measurement(compared, self._situation(tick, 0, 0)))
            self._book.take_over(layers)
            self._show_layers()
        self._layers = layers

    def _near(self, tick: Tick, index: int, ball: Ball) -> list[int]:
        """The rings that the ball may have touched during this tick, by its room at the end."""
        position, velocity, _ = ball
        ball_radius = tick.level.ball_radius
        distance = abs(position)
        travel = abs(velocity) * tick.dt + _SPARE
        near = []
        free = math.inf
        for k, (ring, model) in enumerate(zip(tick.arena.rings, self._models, strict=True)):
            if not model.living:
                continue
            radius, half_width, _, _, phase, spin, _ = ring
            above = abs(distance - radius) - half_width - ball_radius - travel
            if above > 0.0:
                free = min(free, above)
                continue
            wanted = travel + abs(spin) * distance * tick.dt  # seen from the turning ring
            local = position * cmath.rect(1.0, -(phase + spin * tick.dt))
            room = room_around(model, local, ball_radius, self._rooms.get((index, k), UNKNOWN), wanted)
            self._rooms[index, k] = room
            spare = room.room - abs(local - room.position) - wanted
            rests = tick.level.rings[k].spin == 0.0
            free = min(free, spare if rests else 0.0)  # a ring that turns, or is steered, comes nearer by itself
            if spare < 0.0:
                near.append(k)
        self._free[index] = position, free
        return near

    def _far_from_all(self, before: Sequence[Ball], after: Sequence[Ball], dt: float) -> bool:
        """Whether every ball flies straight on in the free space between the rings' bands in which it was last seen."""
        for i, (p, v, _) in enumerate(before):
            q, w, _ = after[i]
            center, radius = self._free.get(i, _NOWHERE)
            if v != w or abs(q - center) >= radius or abs(p + v * dt - q) > self._straight:
                return False
        return True

    def _flies_straight(self, start: Ball, end: Ball, dt: float) -> bool:
        """Whether a ball is where its velocity takes it, as far as the comparison of floats can say."""
        there = start.position + start.velocity * dt
        return start.velocity == end.velocity and abs(there - end.position) <= self._straight

    def _check_flights(self, tick: Tick) -> None:
        """The hits of a tick in the order of time, and the flights between them."""
        checked = CheckedTick(tick, self._models, self._wanted.options)
        current: dict[int, list[Leg]] = {}
        freed = dropped = 0
        for index, path in enumerate(flight_paths(tick, MOST_BOUNCES)):
            if path.fits:
                current[index] = list(path.legs)
                compare_freed_balls(checked, index, path, self.rows)
                freed += (path.freed is not None) + path.freed_after
                dropped += path.dropped
            else:
                self._report_path(checked, index)
        compare_numbers(checked, freed, dropped, self.rows)
        if tick.answers:
            ends = {id(leg.hit): leg for legs in current.values() for leg in legs if leg.hit is not None}
            compare_hit_offset_turns(checked, ends, self.rows)
        for hits in _bounces(tick.step.hits):
            if hits[0].ball not in current:  # its flight is no proof of where it hit; it has been reported
                for hit in hits:
                    self._book.take_one(hit.ring, hit.slot)
                continue
            legs = [current[hit.ball].pop(0) for hit in hits]
            if self._check_bounce(checked, hits, legs):
                self._break(checked, hits[0], current)
        for legs in current.values():
            self._check_no_touch(checked, legs[0])
        self._compare_phases(tick)

    def _check_bounce(self, checked: CheckedTick, hits: list[Hit], legs: list[Leg]) -> bool:
        """All comparisons of one bounce, off one sector or two at once; whether it emptied a slot."""
        shared = len(hits) > 1
        checks = [ContactCheck(moment_of(checked, hit, leg.end, shared=shared)) for hit, leg in zip(hits, legs, strict=True)]
        for check, leg in zip(checks, legs, strict=True):
            compare_normals(check)
            compare_time(check, checked, leg)
        touching = [check for check in checks if check.touched is not None]
        for check in checks:
            if check.touched is None:
                self._book.take_one(check.moment.hit.ring, check.moment.hit.slot)  # that there is nothing has been reported
            else:
                compare_target(check, checked, self._book)
        if len(touching) == 2:
            compare_double_bounce(touching)
        elif touching:
            compare_bounce(touching[0])
            compare_sole_bounce(touching[0], checked)
        for check in checks:
            check.add_to(self.rows, _cell(check), recorded=self._wanted.recorded)
        models = [(check.moment.model, self._book.layers[check.moment.hit.ring]) for check in checks]
        return any(alive and not left for model, layers in models for alive, left in zip(model.alive, layers, strict=True))

    def _break(self, checked: CheckedTick, hit: Hit, current: dict[int, list[Leg]]) -> None:
        """A brick is gone: up to that moment it could be touched by the other balls, from then on it cannot."""
        for ball, legs in current.items():
            if ball != hit.ball and legs[0].start < hit.time:
                self._check_no_touch(checked, legs[0]._replace(stop=hit.time))
                legs[0] = legs[0].without(hit.time)
        self._show_layers()

    def _check_no_touch(self, checked: CheckedTick, leg: Leg) -> None:
        """A leg that no hit ended."""
        missed = missed_touch(checked, leg)
        if missed is not None:
            self.rows.report(missed)

    def _compare_phases(self, tick: Tick) -> None:
        """The recorded phases at a tick's end beside the rebuilt ones."""
        row = self.rows.row(Comparison.PHASE, ANYWHERE)
        for k, ring in enumerate(tick.step.arena.rings):
            if not self._phases.is_the_levels(k, ring.spin):
                self._report_ring(tick, k, "a ring of the game turns as no ring of the level does")
            error, bound = self._phases.difference(k, ring.phase)
            if error <= bound and row.worst is not None and error <= row.worst.compared.error:
                row.add(error, bound)
                continue
            fine = error <= bound
            what = "the phase, rebuilt" if fine else "the ring does not stand where its spins have turned it"
            verdict = ContactVerdict.EXACT if fine else ContactVerdict.UNEXPLAINED
            self.rows.report(Measurement(Compared(Comparison.PHASE, verdict, what, error, bound), self._situation(tick, 0, k)))

    def _overlap(self, tick: Tick, index: int, ring: int) -> None:
        """A ball that pymunk finds in material."""
        depth = -self._rooms[index, ring].room
        bound = rounding.contact_noise(self._models[ring].geometry.outer, tick.level.ball_radius)
        fine = depth <= bound
        what = "overlap at a tick's end" if fine else "the ball is in material: the game missed a bounce"
        verdict = ContactVerdict.EXACT if fine else ContactVerdict.UNEXPLAINED
        compared = Compared(Comparison.PRESENCE_TICK, verdict, what, depth, bound)
        self.rows.report(Measurement(compared, self._situation(tick, index, ring)))

    def _report_path(self, checked: CheckedTick, index: int) -> None:
        """A ball whose velocity or position no recorded hit explains."""
        tick = checked.tick
        start, end = tick.arena.balls[index], tick.step.arena.balls[index]
        what = "the ball's flight does not follow from the recorded bounces (missed bounce)"
        error = max(abs(start.velocity - end.velocity), abs(start.position + start.velocity * tick.dt - end.position))
        compared = Compared(Comparison.VELOCITY, ContactVerdict.UNEXPLAINED, what, error, 0.0)
        self.rows.report(Measurement(compared, self._situation(tick, index, 0)))

    def _report_ring(self, tick: Tick, ring: int, what: str) -> None:
        """A ring that is not the level's."""
        compared = Compared(Comparison.PHASE, ContactVerdict.UNEXPLAINED, what, math.inf, 0.0)
        self.rows.report(Measurement(compared, self._situation(tick, 0, ring)))

    def _situation(self, tick: Tick, ball: int, ring: int) -> Situation:
        """A ball at a tick's end, beside a ring."""
        balls = tick.step.arena.balls
        position = balls[ball].position if ball < len(balls) else 0j
        return CheckedTick(tick, self._models, self._wanted.options).situation(ball, ring, position, tick.dt)


def _bounces(hits: Sequence[Hit]) -> Iterator[list[Hit]]:
    """The hits of a tick, those together that are one bounce."""
    together: list[Hit] = []
    for hit in hits:
        if together and one_bounce(together[-1], hit):
            together.append(hit)
        else:
            if together:
                yield together
            together = [hit]
    if together:
        yield together


def _cell(check: ContactCheck) -> CoverageCell | None:
    """The kind of a contact, as pymunk judges it; None where it touches nothing."""
    moment, touched = check.moment, check.touched
    if touched is None:
        return None
    velocities = moment.world(touched.normal), moment.pushed(touched), moment.hit.before
    sector = moment.numbers.friction, moment.model.geometry.half_angle
    balls = len(moment.tick.arena.balls)
    return cell_of(Judged(touched.shape.part, across(touched, moment), *velocities, *sector, balls))
