"""Circles that run over the ground."""

import cmath
import math

from game.drawing.palette import mixed
from game.effects.waves import WaveTone
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene

_WIDTH = 0.014
"""Width of a new circle's line, in shares of the ground's radius."""
_THINNING = 0.6
"""Share of its width that the line loses by the end."""
_LEAST_HALF_WIDTH = 0.5
"""Pixels."""
_FAINTEST = 0.06
"""Strength below which a circle is not drawn: 1 new to 0 gone."""
_AROUND = tuple([cmath.rect(1.0, math.tau * k / 120) for k in range(121)])


def add_waves(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add the circles that are running, fainter and fainter."""
    theme, camera = view.theme, view.camera
    colours = {WaveTone.START: theme.rim, WaveTone.GOOD: theme.accent, WaveTone.BAD: theme.danger}
    for wave in scene.waves:
        strength = 1.0 - wave.share
        if wave.age < 0 or strength < _FAINTEST:
            continue
        half = max(0.5 * _WIDTH * scene.ground_radius * (1.0 - _THINNING * wave.share), _LEAST_HALF_WIDTH / camera.scale)
        outer, inner = wave.radius + half, max(wave.radius - half, 0.0)
        left, right = (camera.pixels([point * radius for point in _AROUND]) for radius in (outer, inner))
        out.strip(left, right, mixed(theme.ground, colours[wave.tone], strength))
