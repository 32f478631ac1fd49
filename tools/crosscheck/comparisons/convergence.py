"""As arcs get more facets, pymunk's chain comes closer to us, by exactly as much as its chords come closer to their arcs.

A chord's normal is off by up to d/2, its middle by R (1 - cos d/2): so with N facets the error of normals must fall as 1/N,
that of times as 1/N^2. More than that, the position of a contact on its facet says how far off the chord must be there. The
measured errors are compared with these derived ones at every N: an error of our own, however small, would be left over.
"""

import cmath
import math
import statistics
from collections.abc import Iterable
from itertools import islice
from typing import NamedTuple

from physics import Feature
from tools.crosscheck.comparisons.hit_frame import angle_between, dot, geometry_of
from tools.crosscheck.comparisons.rules import MOST_BOUNCES
from tools.crosscheck.games.sources import Source, ticks_of
from tools.crosscheck.games.trajectory import Leg, Tick, flight_paths
from tools.crosscheck.pymunk_model import rounding
from tools.crosscheck.pymunk_model.facets import half_facet, sagitta
from tools.crosscheck.pymunk_model.ring_model import Geometry, RingModel
from tools.crosscheck.pymunk_model.sweep import facet_touch

FACETS = (8, 16, 32, 64, 128, 256, 512, 1024)

_SCATTER = 0.447
"""A contact sits anywhere on its facet, x in [-1, 1] of half its length: normals err by |x| d/2, times by (1 - x^2) sagitta /
approach. The root mean square of n such |x|, and the mean of n such 1 - x^2, both scatter by sqrt(4/45) / (2/3) / sqrt(n) of
themselves: the variance of x^2 is 4/45, and half of that relative scatter of x^2, whose mean is 1/3, is the same number."""
_SIGMAS = 6.0
"""Of the slope's scatter: a right slope is farther off once in 500 million runs."""

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
    """How one error falls.

    expected: the slope in log-log that geometry asks for. errors: measured, for each number of facets; root mean square of
    normals, weighted mean of times. derived: the same by the contacts' positions on their facets. bounds: how far the two may
    differ.
    """

    name: str
    unit: str
    expected: float
    facets: tuple[int, ...]
    errors: tuple[float, ...]
    derived: tuple[float, ...]
    bounds: tuple[float, ...]
    contacts: int

    @property
    def slope(self) -> float:
        """Least-squares slope of log error over log N, above rounding; nan without three such points."""
        points = [(math.log(n), math.log(e)) for n, e in zip(self.facets, self.errors, strict=True) if e > _ROUNDING]
        if len(points) < 3:
            return math.nan
        return statistics.linear_regression(*zip(*points, strict=True)).slope

    @property
    def slack(self) -> float:
        """How far the slope may be from the expected one.

        Each of the points scatters by _SCATTER / sqrt(contacts) in the logarithm; so does the slope, divided by the root of
        the sum of squared distances of log N from their mean.
        """
        logs = [math.log(n) for n in self.facets]
        middle = math.fsum(logs) / len(logs)
        spread = math.sqrt(math.fsum([(log - middle) ** 2 for log in logs]))
        return _SIGMAS * _SCATTER / math.sqrt(self.contacts) / spread

    @property
    def residual(self) -> float:
        """The largest difference between a measured and a derived error, as a share of its bound; nan if one is no number."""
        shares = [
            abs(error - derived) / bound for error, derived, bound in zip(self.errors, self.derived, self.bounds, strict=True)
        ]
        return math.nan if any(math.isnan(share) for share in shares) else max(shares)

    @property
    def holds(self) -> bool:
        """Whether every error is the derived one, and the slope what geometry asks for."""
        return self.residual <= 1.0 and abs(self.slope - self.expected) <= self.slack


class _Sample(NamedTuple):
    """A contact with an arc, brought into the frame of its sector, which there has its middle at angle 0.

    flight: start, velocity and seconds to our touch, on resting rings.
    """

    feature: Feature
    geometry: Geometry
    position: complex
    ball_radius: float
    normal: complex
    flight: tuple[complex, complex, float] | None


class _ChordContact(NamedTuple):
    """Where a ball that touches an arc is, seen from the arc's chords: by plane geometry alone.

    normal: from the nearest point of the chain to the ball. gap: world units, negative where the chord is already passed.
    """

    normal: complex
    gap: float


def converged(sources: Iterable[Source]) -> list[Curve]:
    """The curves of the outer and the inner faces' normals and times, from the first contacts of these games."""
    found = _samples(sources)
    curves = []
    for feature, name in ((Feature.OUTER_FACE, "outer face"), (Feature.INNER_FACE, "inner face")):
        if len(found[feature, False]) >= _FEWEST:
            curves.append(_normal_curve(f"normal, {name}", found[feature, False]))
        if len(found[feature, True]) >= _FEWEST:
            curves.append(_time_curve(f"time, {name}", found[feature, True]))
    return curves


def _normal_curve(name: str, samples: list[_Sample]) -> Curve:
    """How the angle between our normal and the nearest facet's falls.

    Two root mean squares differ by no more than the root mean square of the differences: by rounding alone.
    """
    radial = [sample.position / abs(sample.position) for sample in samples]
    outward = [one if sample.feature == Feature.OUTER_FACE else -one for one, sample in zip(radial, samples, strict=True)]
    errors, derived = [], []
    for n in FACETS:
        errors.append(_rms([_normal_error(sample, n) for sample in samples]))
        normals = [_chord_contact(sample, n).normal for sample in samples]
        derived.append(_rms([angle_between(own, chord) for own, chord in zip(outward, normals, strict=True)]))
    noise = max([rounding.normal_noise(sample.geometry.outer, sample.ball_radius) for sample in samples])
    return Curve(name, "rad", -1.0, FACETS, tuple(errors), tuple(derived), (noise,) * len(FACETS), len(samples))


def _time_curve(name: str, samples: list[_Sample]) -> Curve:
    """How the time between our first touch and the facets' falls.

    Derived: the gap at our touch over the approach to the facet there. While the ball closes that gap, the nearest part of
    the chain may become its neighbour, whose normal is turned by d: the time then changes by up to d |v| / approach of itself.
    """
    errors, derived, bounds = [], [], []
    for n in FACETS:
        errors.append(_weighted_mean([_time_error(sample, n) for sample in samples], samples))
        times, slacks = [], []
        for sample in samples:
            assert sample.flight is not None
            velocity = sample.flight[1]
            contact = _chord_contact(sample, n)
            approach = -dot(contact.normal, velocity)
            times.append(abs(contact.gap) / approach)
            noise = 2.0 * rounding.contact_noise(sample.geometry.outer, sample.ball_radius) / approach
            slacks.append(times[-1] * 2.0 * half_facet(sample.geometry.half_angle, n) * abs(velocity) / approach + noise)
        derived.append(_weighted_mean(times, samples))
        bounds.append(_weighted_mean(slacks, samples))
    return Curve(name, "s", -2.0, FACETS, tuple(errors), tuple(derived), tuple(bounds), len(samples))


def _chord_contact(sample: _Sample, facets: int) -> _ChordContact:
    """The nearest point of the chain of chords to a ball that touches the arc."""
    p, half_angle = sample.position, sample.geometry.half_angle
    half = half_facet(half_angle, facets)
    radius = sample.geometry.outer if sample.feature == Feature.OUTER_FACE else sample.geometry.inner
    index = min(max(math.floor((cmath.phase(p) + half_angle) / (2.0 * half)), 0), facets - 1)
    turn = cmath.rect(1.0, -half_angle + (2 * index + 1) * half)  # to the frame in which the chord stands across the x axis
    local = p * turn.conjugate()
    end = complex(radius * math.cos(half), radius * math.sin(half))
    nearest = complex(end.real, min(max(local.imag, -end.imag), end.imag))
    away = local - nearest
    return _ChordContact(away / abs(away) * turn, abs(away) - sample.ball_radius)


def _samples(sources: Iterable[Source]) -> dict[tuple[Feature, bool], list[_Sample]]:
    """Contacts by face: the first for their normals, the first on resting rings for their times."""
    faces = (Feature.OUTER_FACE, Feature.INNER_FACE)
    found: dict[tuple[Feature, bool], list[_Sample]] = {(face, timed): [] for face in faces for timed in (False, True)}
    for source in sources:
        seen: set[tuple[Geometry, int]] = set()
        for sample in islice(_face_contacts(source), 2 * _CONTACTS):
            spot = sample.geometry, round(cmath.phase(sample.position) / half_facet(sample.geometry.half_angle, FACETS[-1]))
            if spot in seen:  # a ball in a loop comes back to the same point
                continue
            seen.add(spot)
            for timed in (False, True):
                if len(found[sample.feature, timed]) < _CONTACTS and (sample.flight is not None or not timed):
                    found[sample.feature, timed].append(sample)
        if all(len(samples) >= _CONTACTS for samples in found.values()):
            break
    return found


def _face_contacts(source: Source) -> Iterable[_Sample]:
    """The contacts with arcs in one game, but for those in the middle of a sector and those with very wide sectors.

    The autopilot meets the ball with a paddle's middle, where two facets join for every even N: no random position.
    """
    for tick in ticks_of(source):
        for path in flight_paths(tick, MOST_BOUNCES) if tick.step.hits else ():
            for leg in path.legs[:-1] if path.fits else ():
                sample = _sample_of(tick, leg)
                if sample is not None:
                    yield sample


def _sample_of(tick: Tick, leg: Leg) -> _Sample | None:
    """A leg's hit as a sample; None where it is none."""
    hit = leg.hit
    if hit is None or hit.contact.feature not in {Feature.OUTER_FACE, Feature.INNER_FACE}:
        return None
    ring = tick.arena.rings[hit.ring]
    turn = cmath.rect(1.0, -(ring.phase + ring.spin * hit.time + hit.slot * math.tau / ring.count))
    position, radius = leg.end * turn, tick.level.ball_radius
    coarsest = half_facet(ring.half_angle, FACETS[0])
    if coarsest > _COARSEST or abs(cmath.phase(position)) <= 2.0 * coarsest:
        return None
    flight = None
    approach = -dot(hit.contact.normal, leg.velocity)
    if ring.spin == 0.0 and leg.stop > leg.start and approach >= _LEAST_APPROACH * abs(leg.velocity):
        flight = (leg.position * turn, leg.velocity * turn, leg.stop - leg.start)
    geometry = geometry_of(ring)._replace(count=1)
    return _Sample(hit.contact.feature, geometry, position, radius, hit.contact.normal * turn, flight)


def _normal_error(sample: _Sample, facets: int) -> float:
    """Radians between our normal and that of the nearest facet."""
    model = _model(sample.geometry, facets)
    touch = model.faceted(sample.position, 2.0 * sample.ball_radius + model.sagitta)
    return math.pi if touch is None else angle_between(sample.normal, touch.normal)


def _time_error(sample: _Sample, facets: int) -> float:
    """Seconds between our first touch and the facets'."""
    assert sample.flight is not None
    start, velocity, time = sample.flight
    model = _model(sample.geometry, facets)
    backed = 4.0 * model.sagitta / abs(velocity)  # facets of an inner face are touched earlier than the arc
    span = time + 4.0 * model.sagitta / abs(velocity) / _LEAST_APPROACH
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
        approach = -dot(sample.normal, sample.flight[1])
        weights.append(approach / sagitta(sample.geometry.radius, sample.geometry.half_angle, FACETS[0]))
    return math.fsum(error * weight for error, weight in zip(errors, weights, strict=True)) / math.fsum(weights)
