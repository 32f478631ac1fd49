"""What shows on a ball which power-ups act on it: marks around it that differ in shape as well as in colour."""

import cmath
import math
from collections.abc import Callable, Iterator

from game.drawing.arcade.signs import power_colour
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.rules import PowerUp
from game.scene import Scene

_SPIKE, _SPIKE_FOOT, _SPIKE_HALF = 1.75, 1.12, 0.34
"""Of a ball that pierces: tip and foot of a spike, and half its foot's angle: radii of the ball, and radians."""
_SPIKES = 4
_CHEVRON, _CHEVRON_APART, _CHEVRON_ARM = 1.5, 0.55, 0.55
"""Of a fast ball: from its middle back to the first chevron, to the second, and half the chevron's width."""
_RING, _RING_PIECES = 1.55, 6
"""Of a slow ball: radius of the broken ring around it, and its pieces."""
_LEAST_LINE, _LINE = 1.5, 0.16
"""Width of lines: pixels, and radii of the ball."""


def add_marks(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add the marks of every power-up that acts on balls, around every ball."""
    camera = view.camera
    acting = [
        (outlines, power_colour(power.kind, view.theme)) for power in scene.powers if (outlines := _MARKS.get(power.kind))
    ]
    for ball in scene.balls if acting else ():
        middle = camera.project(ball.position, ball.radius)
        radius = ball.radius * camera.scale_at(ball.position, ball.radius)
        ahead = camera.project(ball.position + ball.velocity * 1e-3, ball.radius) - middle
        heading = radius * (ahead / abs(ahead) if ahead else 1 + 0j)
        for outlines, colour in acting:
            for outline in outlines(radius):
                out.polygon([middle + heading * point for point in outline], colour)


def _spikes(_radius: float) -> Iterator[list[complex]]:
    """Spikes all around, one of them ahead. Outlines are in radii of the ball, which flies along the real axis."""
    for k in range(_SPIKES):
        out = cmath.exp(2j * math.pi * k / _SPIKES)
        yield [out * _SPIKE, *[out * _SPIKE_FOOT * cmath.exp(1j * side * _SPIKE_HALF) for side in (-1.0, 1.0)]]


def _chevrons(radius: float) -> Iterator[list[complex]]:
    """Two arrows behind the ball that point ahead. radius: of the ball, pixels, here and below."""
    thick = max(_LINE * 1.6, _LEAST_LINE / max(radius, 1.0))
    for away in (_CHEVRON, _CHEVRON + _CHEVRON_APART):
        arm = [-away + 0j, -away - 0.5 + _CHEVRON_ARM * 1j, -away - 0.5 - thick + _CHEVRON_ARM * 1j, -away - thick + 0j]
        yield arm
        yield [point.conjugate() for point in arm]


def _broken_ring(radius: float) -> Iterator[list[complex]]:
    """A ring in pieces around the ball."""
    half = max(_LINE, _LEAST_LINE / max(radius, 1.0)) / 2.0
    span = math.tau / _RING_PIECES
    for k in range(_RING_PIECES):
        around = [cmath.exp(1j * (k * span + span * 0.6 * step / 4.0)) for step in range(5)]
        yield [*[out * (_RING + half) for out in around], *[out * (_RING - half) for out in reversed(around)]]


_MARKS: dict[PowerUp, Callable[[float], Iterator[list[complex]]]] = {
    PowerUp.PIERCE: _spikes,
    PowerUp.FAST: _chevrons,
    PowerUp.SLOW: _broken_ring,
}
