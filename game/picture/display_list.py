"""A picture as one flat list of 32-bit floats, and the texts in it. docs/web.md has the same table.

Every primitive is its code, its colour (0xRRGGBB, exact in a 32-bit float), its opacity from 0 to 1, and its own numbers:

    DISC      x y radius
    CIRCLE    x y radius width                            the line of a circle
    SECTOR    x y inner outer angle half inset            an annular sector, each of its sides moved inwards by an inset; half:
                                                          its half angle, pi for a whole ring, which has no ends
    POLYGON   n, then n times x y                         filled
    LINE      width dash n, then n times x y              dash: length of dashes and gaps, 0 for a solid line
    TEXT      index size x y across bold room             index: of the text; across: 0 if it begins at x, 1 if it ends there;
                                                          y: of its middle; bold: 1 for the desktop's bold letters, which are
                                                          lower than their size; room: greatest width, for which the size is
                                                          reduced, 0 for any; on a canvas the text may be runs of letters
                                                          (game/lab/typeset/runs.py)
    GLOW      x y across down multiplies                  half axes of an ellipse of light that fades to its edge; multiplies: 0
                                                          if it is added to what is below, 1 if it is multiplied with it
    FILL                                                  all of the picture in the colour
    CELLS     x y width height columns rows, then colours a grid of cells, row by row from the top, smoothed
    CLIP      x y width height                            what follows is drawn inside this box only; a width of 0 ends that
    TURN      x y angle                                   what follows is rotated about a point, until the next TURN
    STRIP     n, then n times x y x y                     the filled area between two lines, one point of each at a time
    BAND      n, then n times x y half_width colour       a line through points, with a width and a colour at each; the colour
                                                          changes evenly between points, and bends are round
    PLATE     index size x y across down edge edge_colour a plate with round ends behind a text that is centred at x, y; across
                                                          and down: margins on each side; edge: width of its line
    SPRITE    x y reach n, then n numbers                 polygons around a point, within reach of it on both axes; the painter
                                                          caches them, since the same ones often come again
    TEXTURE   number columns n, then n colours            a square picture that the painter stores under the number; row by row
                                                          from the top
    TEXTURED  x y radius number                           a disc filled with a texture, smoothed
    BOX       x y width height corner edge edge_colour    a rectangle with round corners; corner: their radius; edge: width of
                                                          its line, inside the rectangle, 0 for none

x to the right, y down, pixels; angles in radians, clockwise, from the right.

What stands in a slot of the flat view has light and shade. Their numbers begin with those of its sector without the inset: x y
inner outer angle half. The depth of a point is its distance from the nearest side, inside the sector. The light is above x, y.

    FOOT      sector, inset reach                         the shade at the foot of a smaller sector on this one: black, in full
                                                          at the depth inset, linearly to nothing at the depth inset - reach,
                                                          and nothing beside the sector
    RELIEF    sector, edge at_faces at_ends slope         white where light falls on the sector, black where it is in the shade;
                                                          from 1 at a side to 0 at the depth edge: at_faces on the inner face,
                                                          -at_faces on the outer one, at_ends on the ends; added to that from
                                                          slope on the inner face, linearly to -slope on the outer one
    CAST      sector, inwards outwards aside              the shadow around the sector: black, its opacity is multiplied by the
                                                          square of a share that falls linearly, from 1 on the faces to 0 at
                                                          these distances, and by one from 1 on the ends to 0 aside of them
    BAR       x y angle inner start outer end half_width  straight from the radius inner and the angle start to the radius outer
                                                          and the angle end; these angles from angle on, counter-clockwise;
                                                          half_width: along the arc

Blocks in 3D are in world units, x to the right, y up, and their angles are counter-clockwise. The painter projects them, by the
equations of `game.drawing.camera.Camera`, so that a list stays the same while the camera moves and rings turn.

    CAMERA    x y scale azimuth tilt closeness, then      the projection of what follows, until the next CAMERA; the direction
              light_x light_y dimmest brightest           towards the light; brightness, as a share of the colour, of a side
              shadow_x shadow_y                           that faces away from the light, and of one that faces it; in between
                                                          the cosine of the angle counts; offset of a shadow from what throws
                                                          it, for each unit of that one's height
    SLOT      angle out                                   the prisms and shadows that follow are rotated by it about the
                                                          arena's centre, and each of their points is moved away from it
    PRISM     bottom top ends even n, then n times x y    the top in the colour, the sides that face the eye in shades of it;
                                                          with bottom equal to top only the top is drawn. The outline is
                                                          clockwise: half of its corners are on an inner arc, the others on an
                                                          outer one. ends: which of the two sides between the arcs there are, 1
                                                          the first, 2 the second, 3 both; even: 1 if the sides of an arc have
                                                          one shade, the one of a side at angle 0
    SHADOWS   n m ends, then n times x y, twice, then     the shadows of m prisms with one outline, each rotated by the angle:
              m times angle low high                      the outline at the height low, and what the sides that face the
                                                          movement pass over as the height goes to high; these sides are those
                                                          of the second outline, without the ends that are not in `ends`

So is the ground; a CAMERA comes before it.

    GROUND_DISC    inner outer n, then n times red green  a disc about the arena's centre; its colours change evenly from the
                   blue                                   inner radius to the outer one by these, 0 to 255, at equal distances;
                                                          within the inner radius it has the first one
    GROUND_CIRCLE  inner width                            a circular line about the centre; inner: its inner radius
    GROUND_SIDE    radius depth                           the side of a disc about the centre, which goes down from the ground
    GROUND_MARK    n, then n times x y                    a polygon
"""

from array import array
from collections.abc import Iterable, Iterator, Sequence
from enum import IntEnum
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Colour

Standing = Sequence[tuple[float, float, float]]
"""Angle, lower and upper height of prisms."""


class Primitive(IntEnum):
    """The codes."""

    DISC = 1
    CIRCLE = 2
    SECTOR = 3
    POLYGON = 4
    LINE = 5
    TEXT = 6
    GLOW = 7
    FILL = 8
    CELLS = 9
    CLIP = 10
    TURN = 11
    STRIP = 12
    BAND = 13
    PLATE = 14
    SPRITE = 15
    CAMERA = 16
    SLOT = 17
    PRISM = 18
    SHADOWS = 19
    BOX = 20
    TEXTURE = 21
    TEXTURED = 22
    FOOT = 23
    RELIEF = 24
    CAST = 25
    BAR = 26
    GROUND_DISC = 27
    GROUND_CIRCLE = 28
    GROUND_SIDE = 29
    GROUND_MARK = 30


_LENGTHS = {
    Primitive.DISC.value: 3,
    Primitive.CIRCLE.value: 4,
    Primitive.SECTOR.value: 7,
    Primitive.TEXT.value: 7,
    Primitive.GLOW.value: 5,
    Primitive.CLIP.value: 4,
    Primitive.TURN.value: 3,
    Primitive.PLATE.value: 8,
    Primitive.CAMERA.value: 12,
    Primitive.SLOT.value: 2,
    Primitive.BOX.value: 7,
    Primitive.TEXTURED.value: 4,
    Primitive.FOOT.value: 8,
    Primitive.RELIEF.value: 10,
    Primitive.CAST.value: 9,
    Primitive.BAR.value: 8,
    Primitive.FILL.value: 0,
    Primitive.GROUND_CIRCLE.value: 2,
    Primitive.GROUND_SIDE.value: 2,
}
"""Numbers of the primitives that always have as many."""
_COUNTED = {
    Primitive.POLYGON.value: (0, 2),
    Primitive.LINE.value: (2, 2),
    Primitive.STRIP.value: (0, 4),
    Primitive.BAND.value: (0, 4),
    Primitive.SPRITE.value: (3, 1),
    Primitive.PRISM.value: (4, 2),
    Primitive.TEXTURE.value: (2, 1),
    Primitive.GROUND_DISC.value: (2, 3),
    Primitive.GROUND_MARK.value: (0, 2),
}
"""Of the others the position of the count among their numbers, and how many follow it for each."""


class Sector(NamedTuple):
    """An annular sector.

    centre: of its circles. radii: inner and outer. angle: of its middle, counter-clockwise as in the world.
    half_angle: pi for a whole ring.
    """

    centre: complex
    radii: tuple[float, float]
    angle: float
    half_angle: float

    @property
    def numbers(self) -> tuple[float, ...]:
        """As a list has it."""
        return (self.centre.real, self.centre.imag, *self.radii, -self.angle, self.half_angle)


class DisplayList:
    """A picture being made. numbers: the list; texts: those that it refers to."""

    def __init__(self) -> None:
        """Nothing yet."""
        self.numbers = array("f")
        self.texts: list[str] = []

    def disc(self, centre: complex, radius: float, colour: Colour, opacity: float = 1.0) -> None:
        """A filled disc."""
        self.numbers.extend((Primitive.DISC, packed(colour), opacity, centre.real, centre.imag, radius))

    def circle(self, centre: complex, radius: float, width: float, colour: Colour, opacity: float = 1.0) -> None:
        """The line of a circle."""
        self.numbers.extend((Primitive.CIRCLE, packed(colour), opacity, centre.real, centre.imag, radius, width))

    def sector(self, sector: "Sector", inset: float, colour: Colour) -> None:
        """An annular sector, each of its sides moved inwards by an inset."""
        self.numbers.extend((Primitive.SECTOR, packed(colour), 1.0, *sector.numbers, inset))

    def foot(self, sector: "Sector", inset: float, reach: float, opacity: float) -> None:
        """The shade on a sector at the foot of a smaller one. inset: of that one; reach: of the shade."""
        self.numbers.extend((Primitive.FOOT, 0.0, opacity, *sector.numbers, inset, reach))

    def relief(self, sector: "Sector", edge: float, at_faces: float, at_ends: float, slope: float, opacity: float) -> None:
        """The light on a sector. edge: width of its bright and dark edges; the others: strengths, 0 to 1."""
        self.numbers.extend((Primitive.RELIEF, 0.0, opacity, *sector.numbers, edge, at_faces, at_ends, slope))

    def cast(self, sector: "Sector", inwards: float, outwards: float, aside: float, opacity: float) -> None:
        """The shadow around a sector. inwards, outwards, aside: how far it goes beyond the faces and the ends."""
        self.numbers.extend((Primitive.CAST, 0.0, opacity, *sector.numbers, inwards, outwards, aside))

    def bar(
        self, centre: complex, angle: float, ends: tuple[float, float, float, float], half_width: float, colour: Colour
    ) -> None:
        """A bar. ends: radius and angle of the inner one, then of the outer one; angles from `angle` on."""
        place = centre.real, centre.imag, -angle
        self.numbers.extend((Primitive.BAR, packed(colour), 1.0, *place, *ends, half_width))

    def polygon(self, points: Sequence[complex], colour: Colour, opacity: float = 1.0) -> None:
        """A filled polygon."""
        self.numbers.extend((Primitive.POLYGON, packed(colour), opacity, len(points)))
        self._add(points)

    def line(self, points: Sequence[complex], width: float, colour: Colour, opacity: float = 1.0, dash: float = 0.0) -> None:
        """A line through points. dash: length of dashes and gaps, 0 for none."""
        self.numbers.extend((Primitive.LINE, packed(colour), opacity, width, dash, len(points)))
        self._add(points)

    def text(
        self,
        words: str,
        size: float,
        pixel: complex,
        colour: Colour,
        across: float = 0.5,
        opacity: float = 1.0,
        bold: float = 1.0,
        room: float = 0.0,
    ) -> None:
        """Add a line of text. pixel: at the middle of its height; across: 0 if the text begins there, to 1 if it ends there.

        bold: whether in the desktop's letters. room: greatest width, pixels, for which the size is reduced; 0 for any width.
        """
        own = len(self.texts), size, pixel.real, pixel.imag, across, bold, room
        self.numbers.extend((Primitive.TEXT, packed(colour), opacity, *own))
        self.texts.append(words)

    def glow(
        self, centre: complex, half_axes: tuple[float, float], colour: Colour, strength: float, *, multiplies: bool = False
    ) -> None:
        """An ellipse of light. half_axes: across and down. multiplies: what is below, instead of being added to it."""
        self.numbers.extend((Primitive.GLOW, packed(colour), strength, centre.real, centre.imag, *half_axes, multiplies))

    def fill(self, colour: Colour) -> None:
        """All of the picture in one colour."""
        self.numbers.extend((Primitive.FILL, packed(colour), 1.0))

    def ground_disc(self, inner: float, outer: float, colours: Sequence[tuple[float, float, float]]) -> None:
        """A disc of the ground about the arena's centre. colours: from the inner radius to the outer one, not rounded."""
        self.numbers.extend((Primitive.GROUND_DISC, 0.0, 1.0, inner, outer, len(colours)))
        self.numbers.extend([channel for colour in colours for channel in colour])

    def ground_circle(self, inner: float, width: float, colour: Colour) -> None:
        """A circular line of the ground. inner: its inner radius."""
        self.numbers.extend((Primitive.GROUND_CIRCLE, packed(colour), 1.0, inner, width))

    def ground_side(self, radius: float, depth: float, colour: Colour) -> None:
        """The side of a disc whose top is the ground."""
        self.numbers.extend((Primitive.GROUND_SIDE, packed(colour), 1.0, radius, depth))

    def ground_mark(self, corners: Sequence[complex], colour: Colour) -> None:
        """A polygon of the ground."""
        self.numbers.extend((Primitive.GROUND_MARK, packed(colour), 1.0, len(corners)))
        self._add(corners)

    def cells(self, corner: complex, size: complex, columns: int, colours: Sequence[Colour]) -> None:
        """A grid of cells. corner: upper left; size: width and height; colours: row by row from the top."""
        rows = len(colours) // columns
        self.numbers.extend(
            (Primitive.CELLS, 0.0, 1.0, corner.real, corner.imag, size.real, size.imag, columns, rows, *map(packed, colours))
        )

    def clip(self, corner: complex, size: complex) -> None:
        """Show what follows in a box only. A size of 0 ends that."""
        self.numbers.extend((Primitive.CLIP, 0.0, 1.0, corner.real, corner.imag, size.real, size.imag))

    def turn(self, centre: complex, angle: float) -> None:
        """Turn what follows about a point, counter-clockwise as in the world; 0 ends that."""
        self.numbers.extend((Primitive.TURN, 0.0, 1.0, centre.real, centre.imag, -angle))

    def strip(self, left: Sequence[complex], right: Sequence[complex], colour: Colour) -> None:
        """What is between two lines of as many points."""
        self.numbers.extend((Primitive.STRIP, packed(colour), 1.0, len(left)))
        self._add([pixel for both in zip(left, right, strict=True) for pixel in both])

    def band(self, points: Iterable[tuple[complex, float, Colour]]) -> None:
        """A band through points. points: pixels, half widths there, and colours."""
        flat = [number for at, half, colour in points for number in (at.real, at.imag, half, float(packed(colour)))]
        self.numbers.extend((Primitive.BAND, 0.0, 1.0, len(flat) // 4, *flat))

    def plate(
        self,
        words: str,
        size: float,
        pixel: complex,
        colour: Colour,
        margin: tuple[float, float],
        edge: tuple[float, Colour],
        opacity: float = 1.0,
    ) -> None:
        """A plate behind words. size, pixel: of the words; margin: across and down; edge: its width and colour."""
        index = len(self.texts)
        self.numbers.extend((Primitive.PLATE, packed(colour), opacity, index, size, pixel.real, pixel.imag, *margin))
        self.numbers.extend((edge[0], packed(edge[1])))
        self.texts.append(words)

    def sprite(self, pixel: complex, reach: float, polygons: "DisplayList") -> None:
        """Polygons about a pixel. reach: how far from it they go at most, across and down."""
        self.numbers.extend((Primitive.SPRITE, 0.0, 1.0, pixel.real, pixel.imag, reach, len(polygons.numbers)))
        self.numbers.extend(polygons.numbers)

    def box(
        self, corner: complex, size: complex, radius: float, colour: Colour, edge: tuple[float, Colour] | None = None
    ) -> None:
        """A rectangle with round corners. corner: upper left; size: width and height; edge: its width and its colour."""
        line, line_colour = (0.0, colour) if edge is None else edge
        own = corner.real, corner.imag, size.real, size.imag, radius, line, packed(line_colour)
        self.numbers.extend((Primitive.BOX, packed(colour), 1.0, *own))

    def texture(self, number: int, columns: int, colours: Sequence[Colour]) -> None:
        """A square picture that the painter stores under a number. colours: row by row from the top."""
        self.numbers.extend((Primitive.TEXTURE, 0.0, 1.0, number, columns, len(colours), *map(packed, colours)))

    def textured(self, centre: complex, radius: float, number: int) -> None:
        """A disc filled with a texture."""
        self.numbers.extend((Primitive.TEXTURED, 0.0, 1.0, centre.real, centre.imag, radius, number))

    def camera(self, camera: Camera, light: complex, shares: tuple[float, float], shadow: complex) -> None:
        """The projection of prisms and shadows.

        light: unit vector towards it. shares: of the dimmest, the brightest side. shadow: offset for each unit of height.
        """
        centre, *rest = camera
        own = light.real, light.imag, *shares, shadow.real, shadow.imag
        self.numbers.extend((Primitive.CAMERA, 0.0, 1.0, centre.real, centre.imag, *rest, *own))

    def slot(self, angle: float, out: float = 0.0) -> None:
        """Rotate what follows about the arena's centre, and move it away from there. out: world units."""
        self.numbers.extend((Primitive.SLOT, 0.0, 1.0, angle, out))

    def prism(
        self, outline: Sequence[complex], bottom: float, top: float, colour: Colour, ends: int = 3, *, even: bool = False
    ) -> None:
        """A prism. outline: clockwise, world units, in a slot at angle 0; colour: of its top; ends, even: as in PRISM."""
        self.numbers.extend((Primitive.PRISM, packed(colour), 1.0, bottom, top, ends, even, len(outline)))
        self._add(outline)

    def shadows(
        self, outline: Sequence[complex], standing: Standing, opacity: float, casting: Sequence[complex] = (), ends: int = 3
    ) -> None:
        """The shadows of prisms. casting: the second outline, if it is not the first one; ends: as in SHADOWS."""
        self.numbers.extend((Primitive.SHADOWS, 0.0, opacity, len(outline), len(standing), ends))
        self._add([*outline, *(casting or outline)])
        self.numbers.extend([number for each in standing for number in each])

    def extend(self, other: "DisplayList") -> None:
        """Add a picture without texts."""
        self.numbers.extend(other.numbers)

    def _add(self, points: Sequence[complex]) -> None:
        """The coordinates of points."""
        self.numbers.extend([number for point in points for number in (point.real, point.imag)])


def primitives(numbers: "array[float]") -> Iterator[tuple[int, int, float, "array[float]"]]:
    """Every primitive of a list: its code, its packed colour, its opacity, and its own numbers."""
    at, end = 0, len(numbers)
    while at < end:
        code, own = int(numbers[at]), at + 3
        if code in _LENGTHS:
            behind = own + _LENGTHS[code]
        elif code == Primitive.CELLS:
            behind = own + 6 + int(numbers[own + 4] * numbers[own + 5])
        elif code == Primitive.SHADOWS:
            behind = own + 3 + 4 * int(numbers[own]) + 3 * int(numbers[own + 1])
        else:
            index, each = _COUNTED[code]
            behind = own + index + 1 + each * int(numbers[own + index])
        yield code, int(numbers[at + 1]), numbers[at + 2], numbers[own:behind]
        at = behind


def packed(colour: Colour) -> int:
    """A colour as one number."""
    return colour[0] << 16 | colour[1] << 8 | colour[2]


def unpacked(colour: float) -> Colour:
    """A colour that is one number."""
    number = int(colour)
    return number >> 16, number >> 8 & 255, number & 255
