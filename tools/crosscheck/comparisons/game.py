"""Every comparison over one trajectory."""

import cmath
import math
import time
from collections.abc import Iterable
from itertools import islice
from typing import NamedTuple

from physics import Arena, Ball, Hit, Ring
from tools.crosscheck.comparisons.bounce import checked_bounce
from tools.crosscheck.comparisons.contact import checked_contact
from tools.crosscheck.comparisons.hit_frame import Scene, geometry_of, moment_of
from tools.crosscheck.comparisons.presence import UNKNOWN, Pose, room_around
from tools.crosscheck.comparisons.touch_time import checked_time
from tools.crosscheck.games.trajectory import Leg, Tick, layers_before, paths
from tools.crosscheck.pymunk_model import facets
from tools.crosscheck.pymunk_model.ring_model import Part, RingModel, ring_model
from tools.crosscheck.results.cases import ANYWHERE, Class, Comparison
from tools.crosscheck.results.rows import Rows

_BLOCK = 240
"""Ticks between two looks at the clock."""
_NOWHERE = (0j, 0.0)
_STRAIGHT = 2.0**-50
"""Fraction of a coordinate: a few roundings."""


class Checked(NamedTuple):
    """What checking one game gave."""

    rows: Rows
    ticks: int
    playing: float  # seconds of the processor that the game took
    checking: float  # those that the comparisons took
    building: float  # those that pymunk's models took


def checked_ticks(ticks: Iterable[Tick], facet_count: int, options: str, only: int | None = None) -> Checked:
    """Compare a whole game. options: of the command that repeats it. only: the one tick to compare."""
    checker = _Checker(facet_count, options)
    playing = checking = 0.0
    count = 0
    source = iter(ticks)
    while True:
        before = time.process_time()
        block = list(islice(source, _BLOCK))
        between = time.process_time()
        for tick in block:
            if only is None or tick.number == only:
                checker.check(tick)
                count += 1
        playing += between - before
        checking += time.process_time() - between
        if not block:
            return Checked(checker.rows, count, playing, checking - checker.building, checker.building)


class _Checker:
    """Both engines side by side through one game."""

    def __init__(self, facet_count: int, options: str) -> None:
        self.rows = Rows()
        self._poses_checked = self.rows.row(Comparison.PRESENCE_TICK, ANYWHERE)
        self.building = 0.0
        self._facets, self._options = facet_count, options
        self._models: list[RingModel] = []
        self._rings: tuple[Ring, ...] = ()
        self._all_layers: tuple[tuple[int, ...], ...] = ()
        self._layers: list[object] = []
        self._poses: dict[tuple[int, int], Pose] = {}
        self._free: dict[int, tuple[complex, float]] = {}  # per ball: nothing reaches into this circle
        self._end: Arena | None = None

    def check(self, tick: Tick) -> None:
        """Compare one tick."""
        unchanged = tick.arena is self._end  # nothing but the physics has acted since the last tick
        self._end = tick.step.arena
        if not tick.arena.balls:
            return
        if unchanged and not tick.step.hits and self._far_from_all(tick):
            self._poses_checked.zeros += len(tick.arena.balls)
            return
        self._take_rings(tick)
        self._take_layers(tick.step.arena.layers)
        suspect = bool(tick.step.hits)
        for i, ball in enumerate(tick.step.arena.balls):
            near = self._near(tick, i, ball)
            if near or not _flies_straight(tick.arena.balls[i], ball, tick.dt):
                suspect = True
            overlaps = [k for k in near if self._poses[i, k].room < 0.0]
            self._poses_checked.zeros += not overlaps
            for k in overlaps:
                self._overlap(tick, (i, k), self._poses[i, k])
        if suspect:
            self._check_paths(self._scene(tick))

    def _scene(self, tick: Tick) -> Scene:
        return Scene(tick, self._models, self._options)

    def _take_rings(self, tick: Tick) -> None:
        """The models of this tick's rings: the same as in the last tick unless a level began or a paddle was resized."""
        rings, known = tick.arena.rings, self._rings
        self._rings = rings
        if len(rings) == len(known) and all([new is old or new[:4] == old[:4] for new, old in zip(rings, known, strict=True)]):
            return
        before = time.process_time()
        self._models = [ring_model(geometry_of(ring), self._facets) for ring in rings]
        self.building += time.process_time() - before
        self._all_layers, self._layers = (), [None] * len(self._models)
        self._poses.clear()
        self._free.clear()

    def _take_layers(self, layers: tuple[tuple[int, ...], ...]) -> None:
        """Which sectors pymunk's rings hold."""
        if layers is self._all_layers:
            return
        self._all_layers = layers
        for k, slots in enumerate(layers):
            if slots is not self._layers[k]:
                self._layers[k] = slots
                if self._models[k].set_alive(slots):
                    self._poses.clear()
        self._free.clear()

    def _near(self, tick: Tick, index: int, ball: Ball) -> list[int]:
        """The rings that the ball may have touched during this tick, by its room at the end."""
        position, velocity, ball_radius = ball
        distance = abs(position)
        way = abs(velocity) * tick.dt
        near = []
        free = math.inf
        for k, (ring, model) in enumerate(zip(tick.arena.rings, self._models, strict=True)):
            if not model.living:
                continue
            radius, half_width, _, _, phase, spin, _ = ring
            wanted = way + model.sagitta
            above = abs(distance - radius) - half_width - ball_radius - wanted
            if above > 0.0:
                free = min(free, above)
                continue
            place = position * cmath.rect(1.0, -(phase + spin * tick.dt))
            pose = room_around(model, place, ball_radius, self._poses.get((index, k), UNKNOWN), wanted)
            self._poses[index, k] = pose
            spare = pose.room - abs(place - pose.place) - wanted
            free = min(free, spare if spin == 0.0 else 0.0)  # a ring that turns comes nearer by itself
            if spare < 0.0:
                near.append(k)
        self._free[index] = position, free
        return near

    def _far_from_all(self, tick: Tick) -> bool:
        """Whether every ball flies straight on in the free space between the rings' bands in which it was last seen."""
        for i, (start, end) in enumerate(zip(tick.arena.balls, tick.step.arena.balls, strict=True)):
            center, radius = self._free.get(i, _NOWHERE)
            if abs(end.position - center) >= radius or not _flies_straight(start, end, tick.dt):
                return False
        return True

    def _check_paths(self, scene: Scene) -> None:
        """The hits of a tick, and the flights between them."""
        tick = scene.tick
        legs: dict[int, Leg] = {}
        last: list[Leg] = []
        for index, path in enumerate(paths(tick)):
            if path.fits:
                legs.update({id(leg.hit): leg for leg in path.legs[:-1]})
                last.append(path.legs[-1])
            elif tick.step.freed or tick.step.dropped:
                self.rows.set_free += len(path.legs) - 1
            else:
                self._report_path(scene, index)
        for hit in tick.step.hits:
            if id(hit) in legs:
                self._take_layers(layers_before(tick, hit))
                self._check_hit(scene, hit, legs[id(hit)])
        self._take_layers(tick.step.arena.layers)
        for leg in last:
            checked_time(scene, leg, self.rows, None)

    def _check_hit(self, scene: Scene, hit: Hit, leg: Leg) -> None:
        """All comparisons of one hit."""
        moment = moment_of(scene, hit, leg.end)
        seen = checked_contact(moment, self.rows)
        kind = max(seen.kind, checked_time(scene, leg, self.rows, moment))
        if seen.touch is not None:
            answer = checked_bounce(moment, self.rows, seen.touch)
            kind = max(kind, answer) if answer > Class.FACETS else kind
        self.rows.contacts += 1
        self.rows.classes[kind] += 1

    def _overlap(self, tick: Tick, place: tuple[int, int], pose: Pose) -> None:
        """A ball that pymunk finds in material."""
        model = self._models[place[1]]
        bound = facets.contact_noise(model.geometry.outer) + (model.inner_sagitta if pose.part == Part.INNER_FACET else 0.0)
        what = "overlap at a tick's end" if -pose.room <= bound else "the ball is in material: the game missed a bounce"
        position = tick.step.arena.balls[place[0]].position
        case = self._scene(tick).case(Comparison.PRESENCE_TICK, what, (-pose.room, bound), place, position, tick.dt)
        if self._poses_checked.add(-pose.room, bound):
            self._poses_checked.worst = case
        if case.kind == Class.UNEXPLAINED:
            self.rows.report(case)

    def _report_path(self, scene: Scene, index: int) -> None:
        """A ball whose velocity or place no recorded hit explains."""
        start, end = scene.tick.arena.balls[index], scene.tick.step.arena.balls[index]
        what = "the ball's flight does not follow from the recorded bounces (missed bounce)"
        error = max(abs(start.velocity - end.velocity), abs(start.position + start.velocity * scene.tick.dt - end.position))
        self.rows.report(scene.case(Comparison.VELOCITY, what, (error, 0.0), (index, 0), end.position, scene.tick.dt))


def _flies_straight(start: Ball, end: Ball, dt: float) -> bool:
    """Whether a ball is where its velocity takes it, as far as the comparison of floats can say."""
    there = start.position + start.velocity * dt
    return start.velocity == end.velocity and abs(there - end.position) <= _STRAIGHT * (abs(there) + abs(start.velocity))
