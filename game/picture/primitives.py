"""The primitives of a picture: how they stand in its list, and how a list is read. docs/web.md has the same table.

A picture is one flat list of 32-bit floats, and the texts that it refers to. `display_list` makes it.

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
from collections.abc import Iterator
from enum import IntEnum

from game.drawing.palette import Colour


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
