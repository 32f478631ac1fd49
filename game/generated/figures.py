"""Figures for walls: a function that says of every spot around the centre whether it has a brick, how high, and its colour.

A figure repeats `fold` times around the centre. The position of a spot is measured from the nearest of `fold` axes, so that a
figure is mirrored at each of them, unless its rings are turned against each other. A maker (`petals`, `rays`, ...) draws the
random measures of a figure once, and returns the function.
"""

from collections.abc import Callable
from typing import NamedTuple

from game.generated.chance import Chance, below, between
from physics import direction, length


class Spot(NamedTuple):
    """A possible position of a brick.

    radius: of its ring's middle, world units. height: 0 in the figure's innermost ring to 1 in its outermost. row: index of the
    ring in the figure. column: number of bricks between it and the axis. share: its distance from the axis, 1 halfway between
    two axes.
    angle: the same distance in radians. half: half the distance between two axes along the ring, world units.
    """

    radius: float
    height: float
    row: int
    column: int
    share: float
    angle: float
    half: float

    @property
    def offset(self) -> float:
        """Distance from the axis along the ring, world units."""
        return self.share * self.half


class Cell(NamedTuple):
    """The brick of a spot. high: whether it is one of the figure's higher stacks. tint: as in a level file."""

    high: bool
    tint: int


Figure = Callable[[Spot], Cell | None]
"""Gives the brick of a spot; None for no brick."""


class Colours(NamedTuple):
    """Three tints that go together: for the outer, the inner and the middle part of a figure."""

    outer: int
    inner: int
    middle: int

    def at(self, depth: float) -> int:
        """The tint between the outer at depth 0 and the middle at depth 1."""
        return round(self.outer + (self.middle - self.outer) * min(max(depth, 0.0), 1.0))

    def band(self, number: int) -> int:
        """The tint of a band, counted from the outside."""
        return self[min(number, 2)]


def petals(chance: Chance, colours: Colours) -> Figure:
    """A petal on every axis, and often a sepal between two."""
    width, fullest = between(chance, 0.6, 0.85), between(chance, 0.45, 0.75)
    sepals, veined = chance() < 0.6, chance() < 0.5

    def cell(spot: Spot) -> Cell | None:
        rise = spot.height / fullest if spot.height < fullest else (1.0 - spot.height) / (1.0 - fullest)
        reach = max(min(width * spot.half, 2.3) * (0.25 + 0.75 * rise), 0.2)
        if spot.offset <= reach:
            inside = spot.column == 0 if veined else spot.offset <= 0.5 * reach
            return Cell(inside and spot.height < 0.7, colours.inner if inside and veined else colours.at(1.0 - spot.height))
        if sepals and spot.height < 0.6 and spot.half - spot.offset <= 0.6 * (1.0 - spot.height):
            return Cell(high=False, tint=colours.outer)
        return None

    return cell


def rays(chance: Chance, colours: Colours) -> Figure:
    """A disc, and rays that get narrower outward."""
    disc, width = between(chance, 0.3, 0.5), between(chance, 0.5, 0.85)
    short = chance() < 0.5

    def cell(spot: Spot) -> Cell | None:
        if spot.height <= disc:
            return Cell(spot.row == 0, colours.at(1.0 - 0.5 * spot.height / disc))
        outward = (spot.height - disc) / (1.0 - disc)
        if spot.column == 0 or spot.offset <= width * spot.half * (1.0 - outward):
            return Cell(outward < 0.5, colours.at(0.5 * (1.0 - outward)))
        return Cell(high=False, tint=colours.inner) if short and outward < 0.5 and spot.share > 0.9 else None

    return cell


def star(chance: Chance, colours: Colours) -> Figure:
    """A star with a tip on every axis: straight edges, bands of colour along them."""
    notch, band = between(chance, 0.25, 0.5), between(chance, 0.18, 0.3)

    def cell(spot: Spot) -> Cell | None:
        tip = notch / (notch + spot.share * (1.0 - notch))  # a straight line from the tip to the notch, in polar coordinates
        depth = tip - spot.height
        return None if depth < -0.04 else Cell(depth > 2.0 * band, colours.band(int(depth / band + 0.2)))

    return cell


def bloom(chance: Chance, colours: Colours) -> Figure:
    """A flower seen from above: round lobes, bands of colour along their edge, often a dark throat in every lobe."""
    notch, band = between(chance, 0.3, 0.6), between(chance, 0.18, 0.3)
    throat = between(chance, 0.4, 0.6) if chance() < 0.6 else 2.0

    def cell(spot: Spot) -> Cell | None:
        depth = notch + (1.0 - notch) * (1.0 - spot.share * spot.share) - spot.height
        if depth < -0.04 or (spot.share < 0.35 and abs(spot.height - throat) < 0.1):
            return None
        return Cell(depth > 2.0 * band, colours.band(int(depth / band + 0.2)))

    return cell


def circles(chance: Chance, colours: Colours) -> Figure:
    """A circle around a point on every axis, with a brick or more in its middle, as in a rose window."""
    distance, share = between(chance, 3.7, 4.1), between(chance, 0.85, 1.1)
    filled = chance() < 0.4

    def cell(spot: Spot) -> Cell | None:
        around = min(share * distance * direction(spot.angle / max(spot.share, 0.01)).imag if spot.share else 1.9, 1.9)
        away = length(direction(spot.angle) * spot.radius - distance)
        if away <= 0.45:
            return Cell(high=True, tint=colours.middle)
        if around - 0.75 <= away <= around:
            return Cell(high=False, tint=colours.outer)
        if away < around:
            return Cell(high=False, tint=colours.inner) if filled else None
        if spot.row == 0:
            return Cell(high=True, tint=colours.middle)
        return Cell(high=False, tint=colours.inner) if spot.height > 0.8 and spot.share > 0.8 else None

    return cell


def branches(chance: Chance, colours: Colours) -> Figure:
    """An arm on every axis, with pairs of branches that lean outward: a snowflake."""
    roots = (below(chance, 2), 3)
    longest = 2 + below(chance, 2)

    def cell(spot: Spot) -> Cell | None:
        if spot.column == 0 or spot.row == 0:
            return Cell(spot.height < 0.5, colours.at(1.0 - spot.height))
        if any([spot.column == spot.row - root <= longest for root in roots]):
            return Cell(high=False, tint=colours.outer)
        return Cell(high=True, tint=colours.inner) if spot.share > 0.9 and spot.row == roots[0] + 2 else None

    return cell


def chevrons(chance: Chance, colours: Colours) -> Figure:
    """Zigzag bands around the centre."""
    period, thick = 3 + below(chance, 2), 2
    lean = 1 if chance() < 0.6 else -1
    dots = chance() < 0.5

    def cell(spot: Spot) -> Cell | None:
        number, step = divmod(spot.row + lean * spot.column, period)
        if step < thick:
            return Cell(step == 0 and spot.height < 0.6, colours.band(number % 3 if step == 0 else (number + 1) % 3))
        return Cell(high=True, tint=colours.middle) if dots and spot.column == 0 and step == period - 1 else None

    return cell


def mosaic(chance: Chance, colours: Colours) -> Figure:
    """A disc in two colours that change from sector to sector and from ring to ring: a dart board."""
    rows, border = 1 + below(chance, 2), between(chance, 0.3, 0.6)
    open_rows = chance() < 0.5
    other = max(colours[1:], key=lambda tint: abs(tint - colours.outer))

    def cell(spot: Spot) -> Cell | None:
        even = (spot.share <= border) == (spot.row // rows % 2 == 0)
        if open_rows and not even and spot.row % 2 == 1:
            return None
        return Cell(even and spot.height < 0.5, colours.outer if even else other)

    return cell


def lace(chance: Chance, colours: Colours) -> Figure:
    """A random pattern, smoothed, and mirrored at every axis, as in a crystal."""
    width, height = 7, 9
    drawn = [[chance() < 0.58 for _ in range(width)] for _ in range(height)]

    def standing(row: int, column: int) -> bool:
        """Whether there is a brick: the majority among the draws of the spot and its neighbours."""
        spots = ((0, 0), (0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))
        votes = [drawn[(row + r) % height][abs(column + c) % width] for r, c in spots]
        return 2 * sum(votes) > len(votes)

    def cell(spot: Spot) -> Cell | None:
        if not standing(spot.row, spot.column):
            return None
        inside = all([standing(spot.row + r, spot.column + c) for r, c in ((1, 0), (-1, 0), (0, 1), (0, -1))])
        return Cell(inside or spot.row == 0, colours.middle if inside else colours.at(0.7 * (1.0 - spot.height)))

    return cell


def wheel(chance: Chance, colours: Colours) -> Figure:
    """Rims and spokes, with a high stack where they meet."""
    rims = (2, 5) if chance() < 0.5 else (3, 6)
    cabins = chance() < 0.6

    def cell(spot: Spot) -> Cell | None:
        if spot.row in rims:
            return Cell(spot.column == 0, colours.middle if spot.column == 0 else colours.outer)
        if spot.column == 0:
            return Cell(spot.height < 0.4, colours.inner)
        return Cell(high=False, tint=colours.middle) if cabins and spot.share > 0.9 and spot.row + 1 in rims else None

    return cell


def arcs(chance: Chance, colours: Colours) -> Figure:
    """Arcs that lie in each other's openings, two rings to every arc."""
    longer, shorter = between(chance, 0.62, 0.75), between(chance, 0.3, 0.45)
    turned = chance() < 0.5

    def cell(spot: Spot) -> Cell | None:
        number, second = divmod(spot.row, 2)
        share = 1.0 - spot.share if (number % 2 == 1) == turned else spot.share
        if share > (shorter if second else longer):
            return None
        return Cell(share < 0.2 and number == 0, colours.band(2 - number % 3) if not second else colours.inner)

    return cell


class Style(NamedTuple):
    """A kind of figure. make: its maker. folds: suitable repetitions. width: of bricks, least and greatest, world units.

    full: whether it begins at the core, without a ring between them. twists: whether its rings may be turned into a spiral.
    """

    make: Callable[[Chance, Colours], Figure]
    folds: tuple[int, ...]
    width: tuple[float, float]
    full: bool = False
    twists: bool = False


STYLES = (
    Style(petals, (3, 4, 5, 6, 7, 8), (0.72, 0.9), twists=True),
    Style(rays, (6, 7, 8), (0.75, 0.95), full=True, twists=True),
    Style(star, (4, 5, 6, 7, 8), (0.9, 1.15), full=True),
    Style(bloom, (4, 5, 6, 7, 8), (0.95, 1.2), full=True, twists=True),
    Style(circles, (2, 3, 4, 5, 6), (0.7, 0.85)),
    Style(branches, (4, 5, 6, 8), (0.62, 0.75), twists=True),
    Style(chevrons, (3, 4, 5, 6, 8), (0.85, 1.05)),
    Style(mosaic, (5, 6, 7, 8), (1.1, 1.5), full=True, twists=True),
    Style(lace, (3, 4, 5, 6, 8), (0.8, 1.0)),
    Style(wheel, (4, 5, 6, 7, 8), (0.72, 0.9)),
    Style(arcs, (2, 3, 4), (0.85, 1.1)),
)
"""All kinds. They are asked of rings of about 0.7 world units, from about 1.4 to 6.2 from the centre."""
