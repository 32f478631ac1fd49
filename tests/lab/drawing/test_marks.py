"""What the lab draws is what physics says: marks against contacts, and pixels against marks."""

import cmath
import math
from itertools import combinations

import numpy as np
import pygame
import pytest
from hypothesis import assume, given

from game.drawing.camera import Camera
from game.drawing.palette import DARK, LIGHT, contrast
from game.drawing.text import Type
from game.lab.drawing import strokes
from game.lab.drawing.canvas import PaneCanvas
from game.lab.drawing.colours import role_colour, text_colour
from game.lab.drawing.labels import placed_labels
from game.lab.drawing.painting import draw_marks
from game.lab.kit.marks import angle_between, contact_marks, ring_marks, second_opinion
from game.lab.kit.parameters import Given
from game.lab.kit.picture import (
    AnnularSector,
    Annulus,
    Arc,
    Arrow,
    Circle,
    Disc,
    Line,
    PointMark,
    Role,
    ScalarField,
    Stroke,
    Toggle,
    Words,
)
from game.lab.kit.scene import ViewBox
from game.lab.kit.second_engine import EngineContact
from game.lab.session.pan_zoom import camera_for
from physics import Ball, Ring, contact
from tests.support.strategies import balls, balls_beside_an_end, reals, rings
from tools.crosscheck.second_engine import Pymunk


@given(balls(), rings())
def test_a_contacts_marks_are_the_contact(ball, ring):
    """The normal starts at the closest point; the gap's line is as long as the gap and leads to the ball's surface."""
    found = contact(ball, ring, 0)
    marks = contact_marks(ball, found, 2.0)
    arrow = next(mark for mark in marks if isinstance(mark, Arrow))
    assert (arrow.start, arrow.vector) == (found.point, found.normal * 2.0)
    line = next(mark for mark in marks if isinstance(mark, Line))
    assert abs(abs(line.points[1] - line.points[0]) - abs(found.gap)) < 1e-9
    assert abs(abs(line.points[1] - ball.position) - ball.radius) < 1e-9
    touches = [mark for mark in marks if mark.toggle is Toggle.CONTACTS]
    assert bool(touches) == (found.gap <= 1e-9)


@given(rings())
def test_a_rings_marks_are_its_living_sectors(ring):
    """There is one mark for each slot that is not empty, at the slot's angle."""
    alive = [slot % 2 for slot in range(ring.count)]
    marks = ring_marks(ring, alive, 1)
    assert [mark.angle for mark in marks] == [ring.angle(slot) for slot in range(ring.count) if slot % 2]
    assert {mark.role for mark in marks} <= {Role.SECTOR, Role.OTHER}


@given(balls_beside_an_end())
def test_pymunk_sees_the_same_end(beside):
    """Within two radii of an end, pymunk's normal and distance are ours."""
    touch = Pymunk().touch(beside.ball, beside.ring, (beside.slot,))
    assume(abs(beside.across - 2.0 * beside.ball.radius) > 1e-9)
    assert (touch is None) == (beside.across >= 2.0 * beside.ball.radius)
    if touch is not None:
        found = contact(beside.ball, beside.ring, beside.slot)
        assert abs(touch.normal - found.normal) < 1e-6
        assert abs(touch.distance - beside.across) < 1e-9


@given(rings(), reals(-0.99, 0.99), reals(0.05, 0.5))
def test_pymunk_sees_the_same_outer_face(ring, share, radius):
    """Over an outer face, which is a circle in pymunk, too, its normal and distance are exact."""
    bearing = ring.angle(0) + share * ring.half_angle
    ball = Ball(cmath.rect(ring.outer_radius + 0.9 * radius, bearing), 0j, radius)
    touch = Pymunk().touch(ball, ring, (0,))
    assert abs(touch.normal - contact(ball, ring, 0).normal) < 1e-9
    assert abs(touch.distance - 0.9 * radius) < 1e-9
    assert Pymunk().touch(ball, ring, ()) is None


@given(rings())
def test_pymunks_pieces_are_where_the_sector_is(ring):
    """The end points of pymunk's shapes lie on the sector's outline."""
    for piece in Pymunk().shapes(ring, (0,)):
        for end in (piece.a, piece.b):
            assert abs(abs(abs(end) - ring.radius) - ring.half_width) < 1e-9
            offset = cmath.phase(end * cmath.rect(1.0, -ring.angle(0)))
            assert abs(offset) <= ring.half_angle + 1e-9


def test_a_flight_in_pymunk_bounces():
    """A ball flies straight to a closed ring's inner face and straight back at the same speed."""
    ring = Ring(8.0, 1.0, math.pi, 1)
    positions = Pymunk().flight(Ball(0j, 10 + 0j, 0.5), (ring,), 1.0 / 240.0, 240)
    assert positions[0] == 0j
    assert len(positions) == 241
    assert max([point.real for point in positions]) < 6.6
    assert abs(positions[240].real - (6.5 - 3.5)) < 0.3


class Crooked:
    """Another engine that is off by a right angle."""

    name = "crooked"

    def touch(self, *_):
        return EngineContact(1j, 1.0)

    def shapes(self, *_):
        return ()


def test_the_angle_between_two_opinions_is_written_beside_them():
    """The angle between the two normals is written beside the second engine's. Without such an engine there are no marks."""
    ball, ring = Ball(9.5 + 0j, 0j, 0.6), Ring(8.0, 1.0, 0.5, 1)
    found = contact(ball, ring, 0)._replace(normal=1 + 0j)
    marks = second_opinion(Given({}, Crooked()), ball, ring, (0,), found)
    assert [mark.label for mark in marks] == ["crooked: 90.00° from ours"]
    assert {mark.toggle for mark in marks} == {Toggle.PYMUNK}
    assert second_opinion(Given({}), ball, ring, (0,), found) == ()


def test_angles_are_written_as_people_read_them():
    """Angles have two decimals, or the power of ten of what is smaller."""
    assert angle_between(1j, 1 + 0j) == "90.00°"
    assert angle_between(1 + 0j, 1 + 0j) == "0.00°"
    assert angle_between(cmath.rect(1.0, 1e-9), 1 + 0j) == "6e-08°"


def away(one, other):
    """How far two colours are apart."""
    return sum([abs(a - b) for a, b in zip(one[:3], other[:3], strict=True)])


AREA = pygame.Rect(50, 40, 300, 200)
CAMERA = camera_for(ViewBox(1 + 1j, 3 + 2j), AREA)


@pytest.fixture(params=[DARK, LIGHT], ids=["dark", "light"])
def canvas(request):
    """A surface in the ground's colour."""
    surface = pygame.Surface((400, 300), 0, 32)
    surface.fill(request.param.ground)
    return PaneCanvas(surface, AREA, CAMERA, request.param, Type(), 14.0, frozenset({Toggle.GAP}))


def test_the_view_is_in_the_middle_of_its_area_and_fits():
    """The centre of the view box is in the middle of the area, and its corners are inside."""
    assert CAMERA.project(1 + 1j) == complex(*AREA.center)
    corners = [CAMERA.project(1 + 1j + corner) for corner in (3 + 2j, -3 - 2j)]
    assert all([AREA.left <= corner.real <= AREA.right and AREA.top <= corner.imag <= AREA.bottom for corner in corners])


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_words_of_every_role_can_be_read(theme):
    """Words of every role have the contrast that WCAG asks for; marks have less, but stand out."""
    for role in Role:
        assert contrast(text_colour(theme, role), theme.ground) >= 4.5
        assert contrast(role_colour(theme, role), theme.ground) >= (1.5 if role in {Role.OTHER, Role.FAINT} else 2.5), role


MARKS = [
    (Disc(1 + 1j, 1.0, Role.BALL), 1 + 2j),
    (Circle(1 + 1j, 1.0, Role.GOOD, None, Stroke.THICK), 1 + 2j),
    (AnnularSector(2.0, 0.5, 0.5, 0.4, Role.SECTOR), cmath.rect(2.0, 0.5)),
    (Line((0j, 3 + 0j), Role.SOURCE, None, Stroke.THICK), 1 + 0j),
    (Line((0j, 3 + 0j), Role.SOURCE, None, Stroke.DASHED), 0.1 + 0j),
    (Arrow(0j, 3 + 0j, Role.OURS), 1 + 0j),
    (PointMark(2 + 1j, Role.TWO), 2 + 1j),
    (Arc(0j, 2.0, 0.0, 1.0, Role.PLAIN, None, Stroke.THICK), cmath.rect(2.0, 0.5)),
]


@pytest.mark.parametrize(("mark", "point"), MARKS, ids=lambda value: type(value).__name__)
def test_a_mark_is_where_it_should_be_in_its_colour(canvas, mark, point):
    """A mark is drawn in its role's colour where it should be, and not at all while its toggle is off."""
    pixel = canvas.camera.project(point)
    pixels = [(math.floor(pixel.real) + dx, math.floor(pixel.imag) + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
    colour = role_colour(canvas.theme, mark.role)
    draw_marks(canvas, [mark._replace(toggle=Toggle.BANDS)])
    assert all([canvas.surface.get_at(pixel)[:3] == canvas.theme.ground for pixel in pixels])
    draw_marks(canvas, [mark._replace(toggle=Toggle.GAP)])
    nearest = min([away(canvas.surface.get_at(pixel), colour) for pixel in pixels])
    assert nearest < 0.6 * away(canvas.theme.ground, colour)


def test_a_band_is_coloured_between_its_radii_only(canvas):
    """An annulus colours what is between its radii, and nothing else."""
    draw_marks(canvas, [Annulus(1.0, 2.0, Role.ONE)])

    def at(point):
        pixel = canvas.camera.project(point)
        return canvas.surface.get_at((round(pixel.real), round(pixel.imag)))[:3]

    assert at(1.5 + 0j) != canvas.theme.ground
    assert at(0.5 + 0j) == at(2.5 + 0j) == canvas.theme.ground


def test_a_sector_is_coloured_between_its_ends_and_faces_only(canvas):
    """A sector colours what is between its ends and its faces, and nothing else."""
    draw_marks(canvas, [AnnularSector(2.0, 0.5, 0.5, 0.4, Role.SECTOR)])
    colour = role_colour(canvas.theme, Role.SECTOR)
    inside = [(2.0, 0.14), (2.0, 0.86), (1.6, 0.5), (2.4, 0.5)]
    outside = [(2.0, 0.04), (2.0, 0.96), (1.4, 0.5), (2.6, 0.5)]
    for radius, angle in [*inside, *outside]:
        pixel = canvas.camera.project(cmath.rect(radius, angle))
        colour_there = canvas.surface.get_at((round(pixel.real), round(pixel.imag)))[:3]
        assert colour_there == (colour if (radius, angle) in inside else canvas.theme.ground)


class Quarters:
    """Above 0 at the lower left and the upper right, below 0 at the upper left, 0 at the lower right."""

    def at(self, p):
        """The number at a position."""
        return {(False, False): 1.0, (False, True): -1.0, (True, False): 0.0, (True, True): 1.0}[p.real > 1.0, p.imag > 1.0]


def test_a_field_is_coloured_by_its_sign(canvas):
    """Positions above 0, below 0 and of 0 have three colours; it covers what it says."""
    draw_marks(canvas, [ScalarField(-1 - 1j, 3 + 3j, Quarters(), 1.0)])

    def at(point):
        pixel = canvas.camera.project(point)
        return canvas.surface.get_at((round(pixel.real), round(pixel.imag)))[:3]

    low_left, high_left, low_right, high_right = (at(point) for point in (-0.8 - 0.8j, -0.8 + 2.8j, 2.8 - 0.8j, 2.8 + 2.8j))
    assert low_left == high_right
    assert len({low_left, high_left, low_right}) == 3


def test_nothing_is_drawn_outside_of_the_area(canvas):
    """Marks that reach beyond the pane change no pixel outside of it."""
    words = [Words(9 + 9j, "far away", Role.PLAIN), PointMark(6 + 1j, Role.PLAIN, None, "label"), Annulus(0.0, 50.0, Role.ONE)]
    draw_marks(canvas, [*[mark for mark, _ in MARKS], *words, Line((-99 + 0j, 99 + 1j), Role.PLAIN, None, Stroke.DASHED)])
    outside = pygame.mask.from_threshold(canvas.surface, canvas.theme.ground, (1, 1, 1, 255))
    outside.draw(pygame.mask.Mask(AREA.size, fill=True), AREA.topleft)
    assert outside.count() == 400 * 300


def test_words_at_the_same_point_do_not_cover_each_other(canvas):
    """Three words at one point are placed beside each other, also in a corner of the pane."""
    for corner in (AREA.center, AREA.topleft, AREA.bottomright):
        point = canvas.camera.unproject(complex(*corner))
        boxes = [one.box for one in placed_labels(canvas, [Words(point, text, Role.PLAIN) for text in ("one", "two", "three")])]
        assert len(boxes) == 3
        assert all([AREA.contains(box) for box in boxes])
        assert all([not one.colliderect(other) for one, other in combinations(boxes, 2)])


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e4, 1e7])
def test_any_zoom_can_be_drawn(canvas, scale):
    """At every zoom all marks can be drawn; what is too large is left out or cut off."""
    camera = Camera(canvas.camera.centre, scale)
    degenerate = [
        Arrow(0j, 0j, Role.OURS, label="n"),
        Line((1j, 1j), Role.PLAIN),
        AnnularSector(2.0, 0.5, 0.5, 0.0, Role.SECTOR),
        AnnularSector(2.0, 0.5, 0.5, math.pi, Role.SECTOR),
        Disc(0j, 0.0, Role.BALL),
        Arc(0j, 1.0, 0.0, 0.0, Role.PLAIN, label="0"),
    ]
    draw_marks(canvas._replace(camera=camera), [*[mark for mark, _ in MARKS], *degenerate, Annulus(0.0, 2.0, Role.ONE)])


@pytest.mark.parametrize("reach", [30.0, 900.0, 9e5])
def test_a_polygon_that_leaves_the_surface_looks_as_if_all_of_it_was_drawn(reach):
    """What is seen of a slanted bar is right however far it reaches, to a pixel and a half: corners lie on whole pixels."""
    surface = pygame.Surface((100, 60), 0, 32)
    along, aside = 0.6 + 0.8j, 0.8 - 0.6j
    corners = [50 + 30j + s * reach * along + t * 10.0 * aside for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    strokes.draw_polygon(surface, (255, 255, 255), [(corner.real, corner.imag) for corner in corners])
    columns, rows = np.indices(surface.get_size())
    offset = (columns - 50) + 1j * (rows - 30)
    length, width = (np.abs((offset * part.conjugate()).real) for part in (along, aside))
    lit = pygame.surfarray.array3d(surface)[:, :, 0] > 0
    assert lit[(width < 8.5) & (length < reach - 1.5)].all()
    assert not lit[(width > 11.5) | (length > reach + 1.5)].any()


def test_the_rows_of_a_polygon_that_are_not_seen_are_cut_off(monkeypatch):
    """Pygame is given no more rows than the surface has, and two on either side; none at all where nothing is seen."""
    given = []
    monkeypatch.setattr(pygame.draw, "polygon", lambda _surface, _colour, corners: given.append(corners))
    surface = pygame.Surface((100, 60), 0, 32)
    strokes.draw_polygon(surface, (255, 255, 255), [(50.0, -9e5), (9e5, 30.0), (50.0, 9e5)])
    assert all(-2 <= y <= 62 for _, y in given[0])
    strokes.draw_polygon(surface, (255, 255, 255), [(50.0, -9e5), (90.0, -500.0), (50.0, -400.0)])
    assert len(given) == 1
