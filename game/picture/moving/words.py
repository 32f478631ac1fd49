"""Words that rise and fade where something happened."""

import math

from game.drawing.letter_sizes import stepped
from game.drawing.palette import mixed
from game.effects import Pop
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene

_RISE, _PLATED_RISE = 0.9, 0.3
"""World units that words rise during their life, and words on a plate, which rise less so that the plate hides less."""
_SPRING, _CALM = 0.9, 24.0
"""Share by which new words are larger than at rest, and how fast that dies away, per life."""
_SMALLEST, _LARGEST, _PLATED = 0.9, 1.7, 1.2
"""Sizes of words at rest, in units: for a single brick, for a brick of the best combo, and on a plate."""
_SEAM = 0.07
"""Width of the seam around words, in units; at least a pixel."""
_MARGIN, _LETTER = complex(1.0, 1.0), 0.26
"""Units from the picture's edges, across and down, that words stay away from, and half the width of a letter in its size."""
_PLATE_MARGIN, _PLATE_EDGE = (0.7, 0.25), 0.07
"""From words to the ends of their plate, across and down, and the width of its edge, in units."""
_PLATE_EDGE_TINT = 0.35
"""Colour of the plate's edge: share of the words' colour in a mixture with that of lines on the ground."""
_FADING_AGE = 0.6
"""Age from which words and their plate fade until the end of their life."""


def add_words(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add all words, each on a plate or with an outline in the ground's colour, none beyond the picture's edge."""
    for pop in scene.pops:
        _add_pop(out, pop, view)


def _add_pop(out: DisplayList, pop: Pop, view: ArenaView) -> None:
    """Add the words of one event."""
    theme, unit, size, pixel = view.theme, view.unit, _size(pop) * view.unit, _pixel(pop, view)
    own = theme.danger if pop.bad else mixed(theme.text, theme.accent, pop.weight)
    opacity = min(1.0, (1.0 - pop.age) / (1.0 - _FADING_AGE))
    if pop.plate:  # so that no line behind them crosses them
        margin, edge = (_PLATE_MARGIN[0] * unit, _PLATE_MARGIN[1] * unit), mixed(theme.ground_line, own, _PLATE_EDGE_TINT)
        out.plate(pop.text, size, pixel, theme.ground, margin, (_PLATE_EDGE * unit, edge), opacity)
    else:
        seam = max(1.0, _SEAM * unit)
        for offset in (-1.0, 1.0, -1j, 1j):
            out.text(pop.text, size, pixel + offset * seam, theme.ground, opacity=opacity)
    out.text(pop.text, size, pixel, own, opacity=opacity)


def _pixel(pop: Pop, view: ArenaView) -> complex:
    """Where the words' middle is by now."""
    risen = view.camera.project(pop.position) - 1j * (_PLATED_RISE if pop.plate else _RISE) * pop.age * view.camera.scale
    (width, height), margin = view.size, _MARGIN * view.unit
    margin += min(_LETTER * len(pop.text) * _size(pop) * view.unit, width / 2.0 - margin.real)
    x = min(max(risen.real, margin.real), width - margin.real)
    return complex(x, min(max(risen.imag, margin.imag), height - margin.imag))


def _size(pop: Pop) -> float:
    """Size of the words in units: they grow, overshoot and settle; the more points, the larger."""
    at_rest = _PLATED if pop.plate else _SMALLEST + (_LARGEST - _SMALLEST) * pop.weight
    spring = 1.0 + _SPRING * math.exp(-pop.age * _CALM) * math.sin(min(pop.age * _CALM, math.pi))
    return stepped(at_rest * spring)
