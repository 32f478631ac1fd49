"""As arcs get more facets, pymunk comes closer to us: the proof that what remains is the polygons' error.

A chord's normal is off by up to d/2, its middle by R (1 - cos d/2): so with N facets the error of normals must fall as 1/N,
that of times as 1/N^2. An error of our own would stay where it is and bend the lines.
"""

import cmath
import math
import statistics
from collections.abc import Iterable
from itertools import islice
from typing import NamedTuple

from physics import Feature
from tools.crosscheck.comparisons.hit_frame import angle_between, geometry_of
from tools.crosscheck.games.sabotage import SABOTAGES
from tools.crosscheck.games.sources import Source, ticks_of
from tools.crosscheck.games.trajectory import paths
from tools.crosscheck.pymunk_model.facets import half_facet, sagitta
from tools.crosscheck.pymunk_model.ring_model import Geometry, RingModel
from tools.crosscheck.pymunk_model.sweep import facet_touch

FACETS = (8, 16, 32, 64, 128, 256, 512, 1024)
SLACK = 0.1
"""Of a slope. A contact sits anywhere on its facet, x in [-1, 1] of half its length: normals err by |x| d/2, times by
(1 - x^2) sagitta / approach. The root mean square of n such |x|, and the mean of n such 1 - x^2, scatter by 0.45 / sqrt(n).
With the 40 contacts asked for at least that is 0.07 in the logarithm of each of eight points a doubling apart, and 0.016 in
the slope; neighbouring points are not quite independent, so six times that is allowed. A wrong power is off by 1."""

_COARSEST = 0.1
"""Radians: half a facet at the fewest facets. sin d and d then differ by 0.2 %, and a chord stays inside its sector: above it,
the error is no power of N yet."""
_LEAST_APPROACH = 0.4
"""Least share of the speed that approaches the arc, for times: near a graze, time goes as the root of the gap."""

_CONTACTS = 80
_FEWEST = 40
_ROUNDING = 1e-12
"""Errors below this are floating point's, and not part of a slope."""


class Curve(NamedTuple):
    """How one error falls."""

    name: str
    unit: str
    expected: float  # slope in log-log
    facets: tuple[int, ...]
    errors: tuple[float, ...]  # root mean square of normals, weighted mean of times
    contacts: int

    @property
    def slope(self) -> float:
        """Least-squares slope of log error over log N, above rounding; nan without three such points."""
        points = [(math.log(n), math.log(e)) for n, e in zip(self.facets, self.errors, strict=True) if e > _ROUNDING]
        if len(points) < 3:
            return math.nan
        return statistics.linear_regression(*zip(*points, strict=True)).slope

    @property
    def holds(self) -> bool:
        """Whether the slope is what geometry asks for."""
        return abs(self.slope - self.expected) <= SLACK


class _Sample(NamedTuple):
    """A contact with an arc, brought into the frame of its sector, which there has its middle at angle 0."""

    feature: Feature
    geometry: Geometry
    place: complex
    ball_radius: float
    normal: complex
    flight: tuple[complex, complex, float] | None  # start, velocity, seconds to our touch, on resting rings


def converged(sources: Iterable[Source], sabotage: str | None = None) -> list[Curve]:
    """The curves of the outer and the inner faces' normals and times, from the first contacts of these games."""
    samples = _samples(sources, sabotage)
    curves = []
    for feature, name in ((Feature.OUTER_FACE, "outer face"), (Feature.INNER_FACE, "inner face")):
        normals = samples[feature, False]
        times = samples[feature, True]
        if len(normals) >= _FEWEST:
            errors = tuple(_rms([_normal_error(sample, n) for sample in normals]) for n in FACETS)
            curves.append(Curve(f"normal, {name}", "rad", -1.0, FACETS, errors, len(normals)))
        if len(times) >= _FEWEST:
            errors = tuple(_weighted_mean([_time_error(sample, n) for sample in times], times) for n in FACETS)
            curves.append(Curve(f"time, {name}", "s", -2.0, FACETS, errors, len(times)))
    return curves


def _samples(sources: Iterable[Source], sabotage: str | None) -> dict[tuple[Feature, bool], list[_Sample]]:
    """Contacts by face: the first for their normals, the first on resting rings for their times."""
    faces = (Feature.OUTER_FACE, Feature.INNER_FACE)
    found: dict[tuple[Feature, bool], list[_Sample]] = {(face, timed): [] for face in faces for timed in (False, True)}
    for source in sources:
        seen: set[tuple[Geometry, int]] = set()
        for sample in islice(_face_contacts(source, sabotage), 2 * _CONTACTS):
            spot = sample.geometry, round(cmath.phase(sample.place) / half_facet(sample.geometry.half_angle, FACETS[-1]))
            if spot in seen:  # a ball in a loop comes back to the same place
                continue
            seen.add(spot)
            for timed in (False, True):
                if len(found[sample.feature, timed]) < _CONTACTS and (sample.flight is not None or not timed):
                    found[sample.feature, timed].append(sample)
        if all(len(samples) >= _CONTACTS for samples in found.values()):
            break
    return found


def _face_contacts(source: Source, sabotage: str | None) -> Iterable[_Sample]:
    """The contacts with arcs in one game, but for those in the middle of a sector and those with very wide sectors.

    The autopilot meets the ball with a paddle's middle, where two facets join for every even N: no random place.
    """
    ticks = ticks_of(source) if sabotage is None else ticks_of(source, SABOTAGES[sabotage]())
    for tick in ticks:
        for path in paths(tick) if tick.step.hits else ():
            for leg in path.legs[:-1]:
                hit = leg.hit
                if hit is None or not path.fits or hit.contact.feature not in {Feature.OUTER_FACE, Feature.INNER_FACE}:
                    continue
                ring = tick.arena.rings[hit.ring]
                pitch = math.tau / ring.count
                turn = cmath.rect(1.0, -(ring.phase + ring.spin * hit.time + hit.slot * pitch))
                flight = None
                approach = -(hit.contact.normal.conjugate() * leg.velocity).real
                if ring.spin == 0.0 and leg.stop > leg.start and approach >= _LEAST_APPROACH * abs(leg.velocity):
                    flight = (leg.position * turn, leg.velocity * turn, leg.stop - leg.start)
                geometry = geometry_of(ring)._replace(count=1)
                radius = tick.arena.balls[hit.ball].radius
                place = leg.end * turn
                coarsest = half_facet(ring.half_angle, FACETS[0])
                if coarsest <= _COARSEST and abs(cmath.phase(place)) > 2.0 * coarsest:
                    yield _Sample(hit.contact.feature, geometry, place, radius, hit.contact.normal * turn, flight)


def _normal_error(sample: _Sample, facets: int) -> float:
    """Radians between our normal and that of the nearest facet."""
    model = _model(sample.geometry, facets)
    touch = model.faceted(sample.place, 2.0 * sample.ball_radius + model.sagitta)
    return math.pi if touch is None else angle_between(sample.normal, touch.normal)


def _time_error(sample: _Sample, facets: int) -> float:
    """Seconds between our first touch and the facets'."""
    assert sample.flight is not None
    start, velocity, time = sample.flight
    model = _model(sample.geometry, facets)
    span = time + 4.0 * model.sagitta / abs(velocity)
    backed = 4.0 * model.sagitta / abs(velocity)  # facets of an inner face are touched earlier than the arc
    touch = facet_touch(model, start - velocity * backed, velocity, sample.ball_radius, span + backed)
    return abs(touch - backed - time)


_models: dict[tuple[Geometry, int], RingModel] = {}


def _model(geometry: Geometry, facets: int) -> RingModel:
    """One sector with that many facets."""
    if (geometry, facets) not in _models:
        _models[geometry, facets] = RingModel(geometry, facets)
    return _models[geometry, facets]


def _rms(values: list[float]) -> float:
    return math.sqrt(math.fsum(value * value for value in values) / len(values))


def _weighted_mean(errors: list[float], samples: list[_Sample]) -> float:
    """The mean of times in which every contact counts alike: weighed by what makes it short, approach / sagitta."""
    weights = []
    for sample in samples:
        assert sample.flight is not None
        approach = -(sample.normal.conjugate() * sample.flight[1]).real
        weights.append(approach / sagitta(sample.geometry.radius, sample.geometry.half_angle, FACETS[0]))
    return math.fsum(error * weight for error, weight in zip(errors, weights, strict=True)) / math.fsum(weights)
