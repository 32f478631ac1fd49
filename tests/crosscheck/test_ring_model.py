"""pymunk's model of a ring: built from the level's numbers, answers by itself, and is what geometry says it is."""

import cmath
import itertools
import math
import random
import subprocess
import sys

import numpy as np
import pymunk
import pytest

from tests.support.paths import ROOT
from tools.crosscheck.pymunk_model import facets, rounding
from tools.crosscheck.pymunk_model.ring_model import Geometry, Part, RingModel, chord_shapes, pointed_shapes

GEOMETRY = Geometry(5.0, 0.5, 0.3, 4)
N = 16
SLOT_0_OUTER_CORNER = cmath.rect(5.5, 0.3)


@pytest.fixture
def model():
    return RingModel(GEOMETRY, N)


def test_pymunks_side_runs_none_of_the_projects_code():
    """Loading every module of the folder pymunk_model loads no other module of physics, game or tools."""
    program = (
        "import importlib, pathlib, sys\n"
        "folder = pathlib.Path('tools/crosscheck/pymunk_model')\n"
        "names = [f'tools.crosscheck.pymunk_model.{path.stem}' for path in folder.glob('*.py') if path.stem != '__init__']\n"
        "assert len(names) >= 6, names\n"
        "for name in names: importlib.import_module(name)\n"
        "assert 'pymunk' in sys.modules\n"
        "ours = [name for name in sys.modules if name.partition('.')[0] in ('physics', 'game', 'tools')]\n"
        "ours = [name for name in ours if not (name + '.').startswith('tools.crosscheck.pymunk_model.')]\n"
        "assert set(ours) == {'tools', 'tools.crosscheck'}, ours\n"
    )
    done = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stderr


def test_that_proof_can_fail():
    """The same question, asked after a module of physics was loaded, is answered with its name."""
    program = "import sys, physics.shapes\nassert not [name for name in sys.modules if name.partition('.')[0] == 'physics']"
    assert subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, cwd=ROOT).returncode == 1


def test_a_sector_is_two_chains_two_ends_and_four_corners():
    """2 N chords, 2 ends, 4 corners, all of zero radius."""
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    shapes = [*chord_shapes(body, GEOMETRY, N), *pointed_shapes(body, GEOMETRY, 2)]
    counts = {part: sum(shape.part == part for shape in shapes) for part in Part}
    assert (counts[Part.OUTER_FACET], counts[Part.INNER_FACET], counts[Part.END], counts[Part.CORNER]) == (N, N, 2, 4)
    assert {shape.shape.radius for shape in shapes} == {0.0}
    assert {shape.slot for shape in shapes if shape.part in Part.POINTED} == {2}


def test_a_closed_ring_has_no_ends():
    """One sector over the whole circle: chords only, and the last ends where the first begins."""
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    geometry = Geometry(5.0, 0.5, math.pi, 1)
    assert pointed_shapes(body, geometry, 0) == []
    outer = [shape.shape for shape in chord_shapes(body, geometry, N) if shape.part == Part.OUTER_FACET]
    assert outer[0].a == outer[-1].b


def test_every_chord_ends_on_its_arc():
    """The chains lie inside the circle, touching it at their vertices."""
    shapes = chord_shapes(pymunk.Body(body_type=pymunk.Body.STATIC), GEOMETRY, N)
    for part, radius in ((Part.OUTER_FACET, 5.5), (Part.INNER_FACET, 4.5)):
        for segment in (shape.shape for shape in shapes if shape.part == part):
            assert abs(complex(*segment.a)) == pytest.approx(radius, rel=4e-16)
            middle = (complex(*segment.a) + complex(*segment.b)) / 2.0
            assert radius - abs(middle) == pytest.approx(facets.sagitta(radius, 0.3, N), abs=4e-15)


@pytest.mark.parametrize(
    ("position", "part", "distance", "normal"),
    [
        (cmath.rect(4.3, 0.1), Part.INNER_CIRCLE, 0.2, -cmath.rect(1.0, 0.1)),
        (cmath.rect(4.3, -2.9), Part.INNER_CIRCLE, 0.2, -cmath.rect(1.0, -2.9)),
        (cmath.rect(5.7, 0.1), Part.OUTER_CIRCLE, 0.2, cmath.rect(1.0, 0.1)),
        (SLOT_0_OUTER_CORNER + cmath.rect(0.2, 0.3 + math.pi / 4.0), Part.CORNER, 0.2, cmath.rect(1.0, 0.3 + math.pi / 4.0)),
        (cmath.rect(5.0, 0.3) + cmath.rect(0.2, 0.3 + math.pi / 2.0), Part.END, 0.2, cmath.rect(1.0, 0.3 + math.pi / 2.0)),
        (cmath.rect(5.0, -0.3) + cmath.rect(0.2, -0.3 - math.pi / 2.0), Part.END, 0.2, cmath.rect(1.0, -0.3 - math.pi / 2.0)),
    ],
    ids=["inner face", "inner face of another slot", "outer face", "corner", "end", "other end"],
)
def test_exact_shapes_answer_as_geometry_says(model, position, part, distance, normal):
    """On all sides, inner faces too: the part, its distance and the normal from it to the ball."""
    touch = model.exact(position, 1.0)
    assert touch is not None
    assert touch.shape.part == part
    assert touch.distance == pytest.approx(distance, abs=4e-15)  # positions of size 5.7 are rounded to 9e-16
    assert abs(touch.normal - normal) < 2e-14  # and a normal is such a position divided by 0.2


def test_the_chain_answers_beside_the_exact_shapes(model):
    """Over an inner face: a chord, no more than a sagitta away from the arc, its normal no more than half a facet off."""
    for slot in range(4):
        turn = cmath.rect(1.0, slot * math.pi / 2.0)
        position = cmath.rect(4.3, 0.1) * turn
        touch, exact = model.faceted(position, 1.0), model.exact(position, 1.0)
        assert (touch.shape.part, touch.shape.slot, exact.shape.slot) == (Part.INNER_FACET, slot, slot)
        assert 0.0 <= exact.distance - touch.distance <= model.inner_sagitta + 1e-15
        assert abs(cmath.phase(touch.normal / exact.normal)) <= facets.half_facet(0.3, N) + 1e-14


def test_over_every_bearing_the_nearest_shape_is_the_sectors_nearest_point(model):
    """Against the distance to 40,000 points along the sector's outline, from 300 positions on either side of it."""
    outline = [cmath.rect(radius, 0.3 * (2.0 * k / 9999.0 - 1.0)) for k in range(10_000) for radius in (4.5, 5.5)]
    outline += [cmath.rect(4.5 + k / 9999.0, side * 0.3) for k in range(10_000) for side in (-1.0, 1.0)]
    points = np.array(outline)
    model.set_alive((1, 0, 0, 0))
    chance = random.Random(3)
    for _ in range(300):
        position = cmath.rect(chance.choice((chance.uniform(3.6, 4.45), chance.uniform(5.55, 6.4))), chance.uniform(-0.5, 0.5))
        found = model.exact(position, 3.0)
        away = np.abs(points - position)
        assert found.distance == pytest.approx(away.min(), abs=1e-5)
        towards = (position - points[away.argmin()]) / away.min()
        assert abs(found.normal - towards) < 2e-4 / found.distance  # half of what lies between two points of the outline


def test_an_empty_slot_touches_nothing(model):
    """Broken bricks are seen by no query, mended ones by all again; only the mending is announced."""
    position = cmath.rect(5.7, 0.1)
    assert model.set_alive((0, 1, 1, 1)) is False
    assert (model.faceted(position, 1.0), model.exact(position, 1.0), model.slot_over(position)) == (None, None, None)
    assert (model.exact_near(position, 1.0), model.faceted_near(position, 1.0)) == ([], [])
    assert model.set_alive((1, 1, 1, 1)) is True
    assert model.faceted(position, 1.0) is not None
    assert model.slot_over(position) == 0


def test_a_point_lies_over_the_slot_whose_bearings_it_has(model):
    """Also across the half axis where bearings jump from pi to -pi, and not in the gaps."""
    found = [
        model.slot_over(cmath.rect(6.0, bearing)) for bearing in (0.0, 0.29, 0.31, math.pi / 2.0, math.pi, 3.2, -3.2, -0.2)
    ]
    assert found == [0, 0, None, 1, 2, 2, 2, 0]


def test_an_outer_facet_is_off_by_its_derived_bound_and_no_more():
    """Over a whole facet, in 2001 positions: the worst normal comes within a hundredth of the bound."""
    radius = 0.7
    ring = RingModel(GEOMETRY._replace(count=1), N)
    bound = facets.outer_facet_bound(5.5, radius, 0.3, N)
    worst = 0.0
    for k in range(2001):
        bearing = 0.6 / N * k / 2000.0
        touch = ring.faceted(cmath.rect(5.5 + radius, bearing), 1.0)
        worst = max(worst, abs(cmath.phase(touch.normal * cmath.rect(1.0, -bearing))))
    assert 0.99 * bound < worst <= bound + rounding.normal_noise(5.5, radius)
    assert bound < facets.half_facet(0.3, N)


def test_an_inner_facet_is_off_by_half_a_facet_and_no_more():
    """The same inside: here the bound is the half angle of the facet itself."""
    radius = 0.7
    ring = RingModel(GEOMETRY._replace(count=1), N)
    bound = facets.half_facet(0.3, N)
    worst = 0.0
    for k in range(2001):
        bearing = 0.6 / N * k / 2000.0
        touch = ring.faceted(cmath.rect(4.5 - radius, bearing), 1.0)
        worst = max(worst, abs(cmath.phase(-touch.normal * cmath.rect(1.0, -bearing))))
    assert 0.99 * bound < worst <= bound + rounding.normal_noise(5.5, radius)


def test_bounds_shrink_with_the_facets():
    """Twice the facets: half the angle, a quarter of the sagitta."""
    for few, many in itertools.pairwise((8, 16, 32, 64)):
        assert facets.half_facet(0.3, many) == facets.half_facet(0.3, few) / 2.0
        assert facets.sagitta(5.0, 0.3, many) == pytest.approx(facets.sagitta(5.0, 0.3, few) / 4.0, rel=1e-3)
