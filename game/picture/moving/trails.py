"""The tail behind each ball: where it has just been."""

from collections.abc import Callable, Sequence
from functools import lru_cache

from game.drawing.palette import Colour, mixed
from game.effects import Trail
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene

_WIDTH = 0.85
"""Half the tail's width at the ball, in the ball's radii."""
_LEAST_RADIUS = 0.5
"""Pixels; half the tail's width where it is thinnest."""
_RIBBON = 0.42
"""Half a ribbon's width, in shares of half a tail's at the ball."""
_BEAD, _BEADS_EVERY = 0.6, 3
"""Radius of the bead at the ball, in the same shares, and positions of a trail from one bead to the next."""
_STRENGTH = 0.5
"""At the ball, the tail's colour is this share of the way from the ground's to its own."""


def add_trails(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add tails that grow and brighten towards their balls, warmer with every brick in a row."""
    for trail in scene.trails if scene.balls else ():
        add_trail(out, trail, scene.balls[0].radius, scene.heat, view)


def add_trail(out: DisplayList, trail: Trail, radius: float, heat: float, view: ArenaView) -> None:
    """Add one ball's tail. radius: of the ball, world units; heat: as in `Scene`."""
    hottest = mixed(view.theme.trail, view.theme.accent, heat)
    _STYLES[view.trail](out, view, view.camera.pixels(trail), _WIDTH * radius * view.camera.scale, hottest)


def _comet(out: DisplayList, view: ArenaView, pixels: list[complex], width: float, hottest: Colour) -> None:
    """A tail from its thin end on, wider towards the ball. pixels: of the trail; width: half the tail's at the ball, pixels."""
    out.band(_growing(pixels, width, _shades(view.theme.ground, hottest, len(pixels))))


def _spectrum(out: DisplayList, view: ArenaView, pixels: list[complex], width: float, _hottest: Colour) -> None:
    """A tail in the colours of a stack's layers."""
    count, colours = len(pixels) + 1, view.theme.layers
    shades = [_fading(view, colours[min(int(7.0 * k / count), 6)], 0.4 + 0.6 * k / count) for k in range(1, count)]
    out.band(_growing(pixels, width, shades))


def _ribbon(out: DisplayList, view: ArenaView, pixels: list[complex], width: float, hottest: Colour) -> None:
    """A band of one width."""
    half, shades = max(_RIBBON * width, _LEAST_RADIUS), _shades(view.theme.ground, hottest, len(pixels))
    out.band([(pixel, half, shade) for pixel, shade in zip(pixels, shades, strict=True)])


def _beads(out: DisplayList, view: ArenaView, pixels: list[complex], width: float, hottest: Colour) -> None:
    """Dots that grow towards the ball."""
    for share, pixel in _sparse(pixels):
        radius = max(_BEAD * width * share, 2.0 * _LEAST_RADIUS)
        out.disc(pixel, radius, _fading(view, hottest, 0.3 + 0.7 * share))


def _rings(out: DisplayList, view: ArenaView, pixels: list[complex], width: float, hottest: Colour) -> None:
    """Circles that grow away from the ball, as on water."""
    line = max(width * 0.16, 1.0)
    for share, pixel in _sparse(pixels):
        radius = max(width * (1.5 - 0.9 * share), 2.0)
        out.circle(pixel, radius - line / 2.0, line, _fading(view, hottest, share))


_STYLES: dict[str, Callable[[DisplayList, ArenaView, list[complex], float, Colour], None]] = {
    "comet": _comet,
    "ribbon": _ribbon,
    "beads": _beads,
    "rings": _rings,
    "spectrum": _spectrum,
}


def _sparse(pixels: list[complex]) -> list[tuple[float, complex]]:
    """Every third position of a trail, the ball's last, with its share of the way to the ball."""
    count = len(pixels) + 1
    return [(k * _BEADS_EVERY / count, pixel) for k, pixel in enumerate(pixels[::-_BEADS_EVERY][::-1], 1)]


def _growing(pixels: list[complex], width: float, shades: Sequence[Colour]) -> list[tuple[complex, float, Colour]]:
    """The points of a band that grows wider towards the ball."""
    step = width / (len(pixels) + 1)
    return [
        (pixel, max(_LEAST_RADIUS, step * k), shade) for k, (pixel, shade) in enumerate(zip(pixels, shades, strict=True), 1)
    ]


@lru_cache(maxsize=256)
def _shades(ground: Colour, hottest: Colour, count: int) -> tuple[Colour, ...]:
    """The colours of so many points of a tail, which brightens towards the ball."""
    return tuple([mixed(ground, hottest, _STRENGTH * k / (count + 1)) for k in range(1, count + 1)])


def _fading(view: ArenaView, colour: Colour, share: float) -> Colour:
    """A tail's colour at a share, 0 to 1, of the way to the ball."""
    return mixed(view.theme.ground, colour, _STRENGTH * min(share, 1.0))
