"""The wall of a level: a core, a figure around it, and further rings: bumpers, steel, bricks that turn or grow again."""

import math
from typing import NamedTuple

import msgspec

from game.generated.chance import Chance, below, between, one_of, rounded, sign
from game.generated.figures import Cell, Colours, Figure, Spot, Style
from game.levels import RingSpec
from physics import PERMANENT

_UP = 90.0
"""Degrees: where the first axis of a figure points."""
_CORE_RADIUS, _CORE_HALF_WIDTH = 0.78, 0.36
_HUB_RADIUS, _HUB_HALF_WIDTH = 1.58, 0.26
"""Of the ring around the core: bricks, or bumpers; world units."""
_ROW, _ROW_HALF_WIDTH = 0.68, 0.3
"""From one ring of a figure to the next, and half of its thickness, world units."""
_GAP, _LANE = 0.1, 0.34
"""World units between rings that turn together, and between others."""
_OUTER_HALF_WIDTH = 0.24
"""Of the ring outside of a figure, world units."""
_OUTERMOST = 6.3
"""Radius that no ring exceeds: closer to the paddles a player would have too little time to react."""
_FILL = 0.92
"""Share of its slot that a brick takes."""
_BRIGHT, _BRIGHTEST = 5, 8
"""The first and the last tint of a core."""
_REVERSAL = 5.0
"""Seconds after which a ring that turns to and fro reverses."""
_REGROWTH = 8.0
"""Seconds after which a brick grows again."""
_GRIP = 0.4
"""Friction of rings that turn."""


class Traits(NamedTuple):
    """What a wall may have. hardness: 0 to 1. The others: turning rings, steel, bumpers, bricks that grow again."""

    hardness: float
    turning: bool
    steel: bool
    bumpers: bool
    regrowing: bool


class _Band(NamedTuple):
    """How the rings of a figure turn. spin: degrees per second; reverse: seconds between reversals of the spin, 0 for never."""

    spin: float = 0.0
    reverse: float = 0.0

    def against(self, factor: float) -> "_Band":
        """The opposite spin, `factor` times as fast."""
        return _Band(rounded(-factor * self.spin), self.reverse)


def wall(chance: Chance, style: Style, traits: Traits) -> list[RingSpec]:
    """The rings of a wall, the innermost first."""
    colours = _colours(chance)
    fold = one_of(chance, style.folds)
    band = _band(chance, traits) if traits.turning else _Band()
    rings = [_core(chance, traits, fold, colours)]
    if traits.bumpers:
        rings.append(_bumpers(chance, traits))
    elif not style.full:
        rings.append(_hub(fold, colours, band.against(1.0)))
    framed = traits.steel or traits.regrowing or chance() < 0.35
    edge = _edge(rings[-1]) + (_LANE if traits.bumpers or traits.turning else _GAP)
    most = _OUTERMOST - (2.0 * _OUTER_HALF_WIDTH + _LANE if framed else 0.0)
    rows = int((most - edge + _ROW - 2.0 * _ROW_HALF_WIDTH) / _ROW)
    rings += _figure(chance, traits, style, fold, colours, edge, rows, band)
    if traits.steel:
        rings.append(_guard(chance, traits, fold, _edge(rings[-1])))
    elif framed:
        rings.append(_frame(chance, traits, fold, colours, _edge(rings[-1]), band.against(1.4)))
    return rings


def _edge(ring: RingSpec) -> float:
    """The radius of a ring's outer face."""
    return ring.radius + ring.half_width


def _colours(chance: Chance) -> Colours:
    """Random tints that go together: from dark to bright, from bright to dark, or two that differ strongly."""
    outer = below(chance, 3)
    return one_of(
        chance,
        (
            Colours(outer, outer + 2, outer + 5),
            Colours(outer, outer + 3, outer + 6),
            Colours(outer + 5, outer + 2, outer),
            Colours(outer, outer + 5, outer + 1),
        ),
    )


def _band(chance: Chance, traits: Traits) -> _Band:
    """How the rings of a figure turn."""
    spin = sign(chance) * between(chance, 5.0, 10.0 + 12.0 * traits.hardness)
    return _Band(rounded(spin), _REVERSAL if chance() < 0.2 else 0.0)


def _core(chance: Chance, traits: Traits, fold: int, colours: Colours) -> RingSpec:
    """The stacks at the centre, the highest of the level."""
    count = fold if 3 <= fold <= 5 else 4 if fold % 2 == 0 else 3
    layers = 2 + below(chance, 2) + round(2.0 * traits.hardness) + traits.regrowing
    return RingSpec(
        radius=_CORE_RADIUS,
        half_width=_CORE_HALF_WIDTH,
        half_angle=rounded(0.87 * 180.0 / count),
        count=count,
        layers=layers,
        phase=_UP,
        tint=min(max(colours.middle + 1, _BRIGHT), _BRIGHTEST),
    )


def _bumpers(chance: Chance, traits: Traits) -> RingSpec:
    """Bumpers around the core."""
    spin = sign(chance) * between(chance, 15.0, 30.0 + 15.0 * traits.hardness)
    return RingSpec(
        radius=_HUB_RADIUS,
        half_width=_HUB_HALF_WIDTH - 0.04,
        half_angle=rounded(between(chance, 14.0, 20.0)),
        count=one_of(chance, (3, 4)),
        layers=PERMANENT,
        phase=_UP,
        spin=rounded(spin) if traits.turning else 0.0,
        bumper=True,
    )


def _hub(fold: int, colours: Colours, band: _Band) -> RingSpec:
    """A ring of bricks around the core, which turns against the figure."""
    count = fold * max(round(11.0 / fold), 1)
    cells: list[Cell | None] = [Cell(high=False, tint=colours.middle)] * count
    return _moving(_ring(cells, (1, 1), _HUB_RADIUS, _HUB_HALF_WIDTH, _UP), band)


def _figure(
    chance: Chance, traits: Traits, style: Style, fold: int, colours: Colours, edge: float, rows: int, band: _Band
) -> list[RingSpec]:
    """The rings of a figure, from a radius outwards."""
    figure, width = style.make(chance, colours), between(chance, *style.width)
    twist = sign(chance) * between(chance, 3.0, 9.0) if style.twists and chance() < 0.5 else 0.0
    low = 1 + (chance() < 0.25 * traits.hardness)
    heights = (low, low + (chance() < 0.3 + traits.hardness) + (chance() < 0.4 * traits.hardness))
    parted = rows // 2 if traits.turning and chance() < 0.4 else rows
    rings = []
    for row in range(rows):
        radius = edge + _ROW_HALF_WIDTH + _ROW * row
        cells = _cells(figure, fold, width, radius, row, rows)
        if any(cells):
            ring = _ring(cells * fold, heights, radius, _ROW_HALF_WIDTH, _UP + twist * row)
            rings.append(_moving(ring, band if row < parted else band.against(0.8)))
    return rings


def _cells(figure: Figure, fold: int, width: float, radius: float, row: int, rows: int) -> list[Cell | None]:
    """The bricks of a ring's spots, from one axis to the next."""
    half = math.pi * radius / fold
    count = max(round(2.0 * half / width), 2)
    cells = []
    for slot in range(count):
        column = min(slot, count - slot)
        share = 2.0 * column / count
        cells.append(figure(Spot(radius, row / max(rows - 1, 1), row, column, share, share * math.pi / fold, half)))
    return cells


def _frame(chance: Chance, traits: Traits, fold: int, colours: Colours, edge: float, band: _Band) -> RingSpec:
    """A ring of bricks outside of the figure, turning against it: teeth, single bricks or arcs. It may grow again."""
    radius = edge + _LANE + _OUTER_HALF_WIDTH
    kind = below(chance, 3)
    count = max(round(2.0 * math.pi * radius / fold / (0.95, 0.6, 0.8)[kind] / 2.0) * 2, 4)
    standing = [(slot % 2 == 0, slot == 0, min(slot, count - slot) <= 0.28 * count)[kind] for slot in range(count)]
    cells = [Cell(kind == 1, colours.outer if kind else colours.inner) if stands else None for stands in standing] * fold
    ring = _ring(cells, (1, 2), radius, _OUTER_HALF_WIDTH, _UP)
    return msgspec.structs.replace(_moving(ring, band), regrow=_REGROWTH if traits.regrowing else 0.0)


def _guard(chance: Chance, traits: Traits, fold: int, edge: float) -> RingSpec:
    """Steel arcs outside of the figure, with wide gates between them."""
    count = fold if fold <= 5 else fold // 2 if fold % 2 == 0 else 3
    cover = between(chance, 0.25, 0.35 + 0.15 * traits.hardness)
    spin = sign(chance) * between(chance, 8.0, 14.0 + 10.0 * traits.hardness)
    return RingSpec(
        radius=rounded(edge + _LANE + _OUTER_HALF_WIDTH),
        half_width=_OUTER_HALF_WIDTH - 0.02,
        half_angle=rounded(cover * 180.0 / count),
        count=count,
        layers=PERMANENT,
        phase=_UP,
        spin=rounded(spin) if traits.turning else 0.0,
    )


def _ring(cells: list[Cell | None], heights: tuple[int, int], radius: float, half_width: float, phase: float) -> RingSpec:
    """A ring of cells. heights: layers of its lower and its higher stacks; phase: of the first cell, degrees."""
    layers = [heights[cell.high] if cell else 0 for cell in cells]
    tints = [cell.tint if cell else 0 for cell in cells]
    return RingSpec(
        radius=rounded(radius),
        half_width=half_width,
        half_angle=rounded(_FILL * 180.0 / len(cells)),
        count=len(cells),
        layers=layers[0] if len(set(layers)) == 1 else layers,
        phase=rounded(phase % 360.0),
        tint=tints[0] if len(set(tints)) == 1 else tints,
    )


def _moving(ring: RingSpec, band: _Band) -> RingSpec:
    """The ring, turning as a band."""
    if not band.spin:
        return ring
    return msgspec.structs.replace(ring, spin=band.spin, reverse=band.reverse, friction=_GRIP)
