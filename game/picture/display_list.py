"""A picture being made: a flat list of primitives, and the texts in it. `primitives` says how each stands in the list."""

from array import array
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Colour
from game.picture.primitives import Primitive, packed

Standing = Sequence[tuple[float, float, float]]
"""Angle, lower and upper height of prisms."""


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

    def sector(self, sector: Sector, inset: float, colour: Colour) -> None:
        """An annular sector, each of its sides moved inwards by an inset."""
        self.numbers.extend((Primitive.SECTOR, packed(colour), 1.0, *sector.numbers, inset))

    def foot(self, sector: Sector, inset: float, reach: float, opacity: float) -> None:
        """The shade on a sector at the foot of a smaller one. inset: of that one; reach: of the shade."""
        self.numbers.extend((Primitive.FOOT, 0.0, opacity, *sector.numbers, inset, reach))

    def relief(self, sector: Sector, edge: float, at_faces: float, at_ends: float, slope: float, opacity: float) -> None:
        """The light on a sector. edge: width of its bright and dark edges; the others: strengths, 0 to 1."""
        self.numbers.extend((Primitive.RELIEF, 0.0, opacity, *sector.numbers, edge, at_faces, at_ends, slope))

    def cast(self, sector: Sector, inwards: float, outwards: float, aside: float, opacity: float) -> None:
        """The shadow around a sector. inwards, outwards, aside: how far it goes beyond the faces and the ends."""
        self.numbers.extend((Primitive.CAST, 0.0, opacity, *sector.numbers, inwards, outwards, aside))

    def bar(
        self, centre: complex, angle: float, ends: tuple[float, float, float, float], half_width: float, colour: Colour
    ) -> None:
        """A bar. ends: radius and angle of the inner one, then of the outer one; angles from `angle` on."""
        own = centre.real, centre.imag, -angle, *ends, half_width
        self.numbers.extend((Primitive.BAR, packed(colour), 1.0, *own))

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
