"""pymunk's model of a ring: built from the level's numbers, answers by itself, and is what geometry says it is."""

import cmath
import itertools
import math
import subprocess
import sys

import pytest

from tools.crosscheck.pymunk_model import facets
from tools.crosscheck.pymunk_model.ring_model import Geometry, Part, RingModel

GEOMETRY = Geometry(5.0, 0.5, 0.3, 4)
N = 16
SLOT_0_OUTER_CORNER = cmath.rect(5.5, 0.3)


@pytest.fixture
def model():
    return RingModel(GEOMETRY, N)


def test_the_other_side_runs_none_of_our_code():
    """Importing pymunk's model, its sweep and its solver loads no module of physics, and of the game none either."""
    program = (
        "import sys, tools.crosscheck.pymunk_model.ring_model, tools.crosscheck.pymunk_model.one_bounce, "
        "tools.crosscheck.pymunk_model.sweep, tools.crosscheck.comparisons.presence\n"
        "assert 'pymunk' in sys.modules\n"
        "ours = [name for name in sys.modules if name.partition('.')[0] in ('physics', 'game')]\n"
        "assert not ours, ours\n"
    )
    done = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_that_proof_can_fail():
    """The same program names the modules of physics as soon as one is imported."""
    program = "import sys, physics.shapes\nassert not [name for name in sys.modules if name.partition('.')[0] == 'physics']"
    assert subprocess.run([sys.executable, "-c", program], check=False, capture_output=True).returncode == 1


def test_a_sector_is_two_chains_two_ends_and_four_corners(model):
    """Every slot has 2 N chords, 2 ends, 4 corners, all of zero radius."""
    for pieces in model.slots:
        counts = {part: sum(piece.part == part for piece in pieces) for part in Part}
        assert (counts[Part.OUTER_FACET], counts[Part.INNER_FACET], counts[Part.END], counts[Part.CORNER]) == (N, N, 2, 4)
        assert {piece.shape.radius for piece in pieces} == {0.0}


def test_a_closed_ring_has_no_ends():
    """One sector all the way round: chords only, and the last ends where the first begins."""
    closed = RingModel(Geometry(5.0, 0.5, math.pi, 1), N)
    assert {piece.part for piece in closed.slots[0]} == {Part.OUTER_FACET, Part.INNER_FACET}
    outer = [piece.shape for piece in closed.slots[0] if piece.part == Part.OUTER_FACET]
    assert outer[0].a == outer[-1].b


def test_every_chord_ends_on_its_arc(model):
    """The chains lie inside the circle, touching it at their vertices."""
    for pieces in model.slots:
        for part, radius in ((Part.OUTER_FACET, 5.5), (Part.INNER_FACET, 4.5)):
            for piece in (piece for piece in pieces if piece.part == part):
                assert abs(complex(*piece.shape.a)) == pytest.approx(radius, rel=4e-16)
                middle = (complex(*piece.shape.a) + complex(*piece.shape.b)) / 2.0
                assert radius - abs(middle) == pytest.approx(facets.sagitta(radius, 0.3, N), abs=4e-15)


@pytest.mark.parametrize(
    ("place", "part", "distance", "normal"),
    [
        (cmath.rect(5.7, 0.1), Part.OUTER_CIRCLE, 0.2, cmath.rect(1.0, 0.1)),
        (SLOT_0_OUTER_CORNER + cmath.rect(0.2, 0.3 + math.pi / 4.0), Part.CORNER, 0.2, cmath.rect(1.0, 0.3 + math.pi / 4.0)),
        (cmath.rect(5.0, 0.3) + cmath.rect(0.2, 0.3 + math.pi / 2.0), Part.END, 0.2, cmath.rect(1.0, 0.3 + math.pi / 2.0)),
        (cmath.rect(5.0, -0.3) + cmath.rect(0.2, -0.3 - math.pi / 2.0), Part.END, 0.2, cmath.rect(1.0, -0.3 - math.pi / 2.0)),
    ],
    ids=["outer face", "corner", "end", "other end"],
)
def test_exact_shapes_answer_as_geometry_says(model, place, part, distance, normal):
    """On all four sides that exist exactly: the part, its distance and the normal from it to the ball."""
    touch = model.exact(place, 1.0)
    assert touch is not None
    assert touch.piece.part == part
    assert touch.distance == pytest.approx(distance, abs=4e-15)  # places of size 5.7 are rounded to 9e-16
    assert abs(touch.normal - normal) < 2e-14  # and a normal is such a place divided by 0.2


def test_over_an_inner_face_there_is_no_exact_shape(model):
    """pymunk has no hollow circle: only facets answer."""
    place = cmath.rect(4.3, 0.1)
    assert model.exact(place, 1.0) is None
    touch = model.faceted(place, 1.0)
    assert touch is not None
    assert touch.piece.part == Part.INNER_FACET


def test_an_empty_slot_touches_nothing(model):
    """Broken bricks are seen by no query, mended ones by all again; only the mending is announced."""
    place = cmath.rect(5.7, 0.1)
    assert model.set_alive((0, 1, 1, 1)) is False
    assert (model.nearest(place, 1.0), model.exact(place, 1.0), model.slot_over(place)) == (None, None, None)
    assert model.set_alive((1, 1, 1, 1)) is True
    assert model.nearest(place, 1.0) is not None
    assert model.slot_over(place) == 0


def test_a_place_lies_over_the_slot_whose_bearings_it_has(model):
    """Also across the half axis where bearings jump from pi to -pi, and not in the gaps."""
    found = [
        model.slot_over(cmath.rect(6.0, bearing)) for bearing in (0.0, 0.29, 0.31, math.pi / 2.0, math.pi, 3.2, -3.2, -0.2)
    ]
    assert found == [0, 0, None, 1, 2, 2, 2, 0]


def test_an_outer_facet_is_off_by_its_derived_bound_and_no_more():
    """Over a whole facet, in 2001 places: the worst normal comes within a hundredth of the bound."""
    radius = 0.7
    ring = RingModel(GEOMETRY._replace(count=1), N)
    bound = facets.outer_facet_bound(5.5, radius, 0.3, N)
    worst = 0.0
    for k in range(2001):
        bearing = 0.6 / N * k / 2000.0
        touch = ring.faceted(cmath.rect(5.5 + radius, bearing), 1.0)
        worst = max(worst, abs(cmath.phase(touch.normal * cmath.rect(1.0, -bearing))))
    assert 0.99 * bound < worst <= bound + facets.normal_noise(5.5, radius)
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
    assert 0.99 * bound < worst <= bound + facets.normal_noise(5.5, radius)


def test_bounds_shrink_with_the_facets():
    """Twice the facets: half the angle, a quarter of the sagitta."""
    for few, many in itertools.pairwise((8, 16, 32, 64)):
        assert facets.half_facet(0.3, many) == facets.half_facet(0.3, few) / 2.0
        assert facets.sagitta(5.0, 0.3, many) == pytest.approx(facets.sagitta(5.0, 0.3, few) / 4.0, rel=1e-3)
