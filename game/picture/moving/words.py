"""Words that rise and fade where something happened."""

import math

from game.drawing.letter_sizes import stepped
from game.drawing.palette import mixed
from game.effects import Pop
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene

_RISE = 0.9
"""World units that words rise in their life."""
_SPRING, _CALM = 0.9, 24.0
"""Share by which new words are larger than at rest, and how fast that dies away, per life."""
_SMALLEST, _LARGEST, _BAD_NEWS = 0.9, 1.7, 1.3
"""Sizes of words at rest, in units: for a single brick, for a brick of the best combo, and for bad news."""
_SEAM = 0.07
"""Width of the seam around words, in units; at least a pixel."""
_MARGIN = complex(2.0, 1.0)
"""Units from the picture's edges, across and down, that words stay away from."""
_PLATE_MARGIN, _PLATE_EDGE = (0.7, 0.25), 0.07
"""From words to the ends of their plate, across and down, and the width of its edge, in units."""
_FADING_AGE = 0.5
"""Words fade in the rest of their life from this age on."""


def add_words(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add all words, each with a seam in the ground's colour, none beyond the picture's edge."""
    for pop in scene.pops:
        _add_pop(out, pop, view)


def _add_pop(out: DisplayList, pop: Pop, view: ArenaView) -> None:
    """Add the words of one event."""
    theme, unit, size, pixel = view.theme, view.unit, _size(pop) * view.unit, _pixel(pop, view)
    own = theme.danger if pop.bad else mixed(theme.text, theme.accent, pop.weight)
    fading = mixed(own, theme.ground, max(0.0, (pop.age - _FADING_AGE) / (1.0 - _FADING_AGE)))
    if pop.plate and pop.age < _FADING_AGE:  # so that nothing strikes them through
        margin = (_PLATE_MARGIN[0] * unit, _PLATE_MARGIN[1] * unit)
        out.plate(pop.text, size, pixel, theme.ground, margin, (_PLATE_EDGE * unit, theme.ground_line))
    seam = max(1.0, _SEAM * unit)
    for offset in (-1.0, 1.0, -1j, 1j):
        out.text(pop.text, size, pixel + offset * seam, theme.ground)
    out.text(pop.text, size, pixel, fading)


def _pixel(pop: Pop, view: ArenaView) -> complex:
    """Where the words' middle is by now."""
    risen = view.camera.project(pop.position) - 1j * _RISE * pop.age * view.camera.scale
    (width, height), margin = view.size, _MARGIN * view.unit
    x = min(max(risen.real, margin.real), width - margin.real)
    return complex(x, min(max(risen.imag, margin.imag), height - margin.imag))


def _size(pop: Pop) -> float:
    """Size of the words in units: they spring up, larger the more they mean, and settle."""
    at_rest = _BAD_NEWS if pop.bad else _SMALLEST + (_LARGEST - _SMALLEST) * pop.weight
    spring = 1.0 + _SPRING * math.exp(-pop.age * _CALM) * math.sin(min(pop.age * _CALM, math.pi))
    return stepped(at_rest * spring)
