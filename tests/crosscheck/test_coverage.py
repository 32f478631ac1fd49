"""The kinds of contact: what a cell is, that aimed contacts fill all of them, and that an empty one is named."""

import cmath
import math
from collections import Counter
from itertools import pairwise

import pytest

from tools.crosscheck.games.aimed import SPECIAL
from tools.crosscheck.games.sources import AIMED, Source, ticks_of
from tools.crosscheck.games.trajectory import one_bounce
from tools.crosscheck.pymunk_model.ring_model import Part
from tools.crosscheck.results.coverage import ALL_CELLS, NAMES, CoverageCell, Judged, cell_of, empty_cells, margins
from tools.crosscheck.run import AIMED_TICKS, Job, check_game

PLAIN = Judged(Part.OUTER_CIRCLE, 0.5, 1.0 + 0.0j, 0j, -8.0 + 0.0j, 0.0, 0.2, 1)


def words(**changed):
    """The words of a contact that differs in these from a ball that falls straight on a resting outer face."""
    return cell_of(PLAIN._replace(**changed)).words


def test_a_contact_has_the_cell_that_its_numbers_say():
    """One dimension after the other."""
    assert words() == "outer face, resting, middle, head-on, no friction, narrow, one ball"
    assert words(part=Part.INNER_CIRCLE).startswith("inner face")
    assert words(part=Part.END).startswith("end")
    assert words(part=Part.CORNER).startswith("corner")
    assert ", with the ball, " in words(surface_velocity=1.0j, velocity=-8.0 + 1.0j)
    assert ", against it, " in words(surface_velocity=1.0j, velocity=-8.0 - 1.0j)
    assert [words(across=share).split(", ")[2] for share in (0.0, 0.19, 0.21, 0.5, 0.7, 0.99, 1.0)] == [
        "edge 0", "edge 0", "side 0", "middle", "side 1", "edge 1", "edge 1",
    ]  # fmt: skip
    slants = [words(velocity=-cmath.rect(8.0, math.radians(slant))).split(", ")[3] for slant in (29.0, 31.0, 59.0, 61.0, 89.9)]
    assert slants == ["head-on", "slanted", "slanted", "glancing", "glancing"]
    assert [words(friction=mu).split(", ")[4] for mu in (0.0, 1e-9, 0.999, 1.0)] == [
        "no friction", "some friction", "some friction", "friction 1",
    ]  # fmt: skip
    widths = [words(half_angle=math.radians(half)).split(", ")[5] for half in (19.9, 20.1, 89.9, 90.1)]
    assert widths == ["narrow", "wide", "wide", "beyond half a turn"]
    assert [words(balls=balls).split(", ")[6] for balls in (1, 2, 9)] == ["one ball", "several balls", "several balls"]


def test_incidence_is_that_of_the_relative_velocity():
    """A ball that flies along a paddle which comes towards it is hit head-on."""
    assert ", glancing, " in words(velocity=-0.1 + 1.0j)
    assert ", head-on, " in words(velocity=-0.1 + 1.0j, surface_velocity=5.0 + 1.0j)


@pytest.fixture(scope="module")
def aimed():
    return check_game(Job(Source(None, AIMED, 4, AIMED_TICKS), 8)).rows


def test_aimed_contacts_are_of_every_kind(aimed):
    """Each of the cells has a contact, as pymunk judges it; none is unexplained."""
    assert [cell.words for cell in empty_cells(aimed.cells)] == []
    assert aimed.unexplained == 0
    assert len(ALL_CELLS) == math.prod(len(values) for values in NAMES.values()) == 3240


def test_aimed_arenas_are_also_of_other_kinds(aimed):
    """One in 41, in turn: a ball inside material, a squeezed one, one in a notch. pymunk confirms what the physics did."""
    specials = AIMED_TICKS // SPECIAL
    assert aimed.freed >= specials // 3
    assert aimed.dropped == specials // 3
    ticks = list(ticks_of(Source(None, AIMED, 4, AIMED_TICKS)))
    assert sum(one_bounce(a, b) for tick in ticks for a, b in pairwise(tick.step.hits)) == specials // 3


def test_the_same_seed_aims_the_same_contacts():
    """And another seed others."""
    first, again, other = ([tick.arena for tick in ticks_of(Source(None, AIMED, seed, 60))] for seed in (7, 7, 8))
    assert first == again
    assert first != other


def test_an_empty_cell_is_named():
    """Of a single contact's cells all others are empty; the margins add up to it."""
    cell = CoverageCell(1, 2, 3, 0, 1, 2, 1)
    cells = Counter({cell: 5})
    assert len(empty_cells(cells)) == len(ALL_CELLS) - 1
    assert cell not in empty_cells(cells)
    found = [margin for margin in margins(cells) if margin.contacts]
    assert [(margin.feature, margin.value, margin.contacts, margin.cells) for margin in found] == [
        ("inner face", value, 5, 1) for value in cell.words.split(", ")[1:]
    ]
    assert {margin.possible for margin in margins(cells) if margin.dimension == "balls"} == {405}
