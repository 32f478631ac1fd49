"""Where a point of the world is on the screen, and back: the one projection, from straight above to a perspective.

The one place that knows the screen's y grows downwards. A point of the ground is turned by the azimuth, tipped about the
screen's horizontal axis, and divided by its distance from the eye. With q the turned point, z its height, t the tilt and
k the closeness:

    w = 1 + k (q.imag sin t - z cos t)        1 in the plane of the world's origin, larger farther away
    x = q.real / w,   y = (q.imag cos t + z sin t) / w

Seen from straight above and from infinitely far (t = k = 0) a height changes nothing.
"""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:  # in a browser there is no numpy: who projects many points at once brings it along
    from game.drawing.raster.arrays import Points, Reals

_MARGIN = 0.035
"""Around the arena, in shares of the room it has."""
_SQUARE = 1.2
"""Aspect ratios up to this leave no room beside the arena: the head-up display gets bands above and below."""
_BAND = 0.11
"""Height of each band, in shares of the surface's."""
_CENTRE = 4.0
"""Pixels; nearer to the arena's centre there is no bearing."""
_HORIZON = 1e-4
"""Lines of sight are taken to be at least as steep as this share of the one straight ahead: pixels on the horizon and above it
then mean far points."""


class Camera(NamedTuple):
    """Looks at the world's origin. Pixels are continuous: the first pixel's centre is at (0.5, 0.5).

    centre: pixel of the world's origin; x to the right, y down.
    scale: pixels per world unit, at the world's origin.
    azimuth: radians; this bearing of the world points right on the screen.
    tilt: radians from straight down, below pi/2.
    closeness: 1 / the eye's distance from the origin, in world units; 0 has parallel lines of sight.
    """

    centre: complex
    scale: float
    azimuth: float = 0.0
    tilt: float = 0.0
    closeness: float = 0.0

    @property
    def flat(self) -> bool:
        """Whether it looks straight down along parallel lines, nothing turned."""
        return self[2:] == (0.0, 0.0, 0.0)

    def project(self, point: complex, height: float = 0.0) -> complex:
        """Pixel of a point of the world."""
        if self.flat:
            return self.centre + point.conjugate() * self.scale
        turned = point * complex(math.cos(self.azimuth), -math.sin(self.azimuth))
        up = turned.imag * math.cos(self.tilt) + height * math.sin(self.tilt)
        return self.centre + complex(turned.real, -up) * self.scale_at(point, height)

    def pixels(self, points: Iterable[complex]) -> list[complex]:
        """Pixels of many points of the ground: as `project` one by one, but faster."""
        centre, scale = self.centre, self.scale
        if self.flat:
            return [centre + point.conjugate() * scale for point in points]
        turning, lean, cosine = self.turning, self.closeness * math.sin(self.tilt), math.cos(self.tilt)
        found = []
        for point in points:
            turned = point * turning
            here = scale / (1.0 + lean * turned.imag)
            found.append(centre + complex(turned.real * here, -turned.imag * cosine * here))
        return found

    def pixels_above(self, points: Iterable[tuple[float, float, float]]) -> list[complex]:
        """Pixels of many points above the ground, each x, y and height: as `project` one by one, but faster."""
        centre, scale = self.centre, self.scale
        if self.flat:
            return [centre + complex(x, -y) * scale for x, y, _ in points]
        right, up = math.cos(self.azimuth), math.sin(self.azimuth)
        sine, cosine, closeness = math.sin(self.tilt), math.cos(self.tilt), self.closeness
        found = []
        for x, y, height in points:
            away = y * right - x * up
            here = scale / (1.0 + closeness * (away * sine - height * cosine))
            found.append(centre + complex((x * right + y * up) * here, -(away * cosine + height * sine) * here))
        return found

    def side(self, point: complex, reach: float) -> float:
        """How far a point of the ground is to the right on the screen. reach: world units that count as 1."""
        return (self.project(point) - self.centre).real / (self.scale * reach)

    def scale_at(self, point: complex, height: float = 0.0) -> float:
        """Pixels per world unit at a point, along the screen."""
        away = point.imag * math.cos(self.azimuth) - point.real * math.sin(self.azimuth)
        return self.scale / (1.0 + self.closeness * (away * math.sin(self.tilt) - height * math.cos(self.tilt)))

    def projected(self, turned: "Points", height: "float | Reals") -> "Points":
        """Pixels of many points at once, already turned by `turning`. height: one, or one for each point."""
        sine, cosine = math.sin(self.tilt), math.cos(self.tilt)
        away = turned.imag
        scale = self.scale / (1.0 + self.closeness * (away * sine - height * cosine))
        pixels = scale.astype("complex128")
        pixels.real = turned.real * scale + self.centre.real
        pixels.imag = (away * -cosine - height * sine) * scale + self.centre.imag
        return pixels

    @property
    def turning(self) -> complex:
        """What a point of the world is multiplied by, so that the screen's right is its real axis."""
        return complex(math.cos(self.azimuth), -math.sin(self.azimuth))

    def unproject(self, pixel: complex) -> complex:
        """Point of the ground at a pixel; beyond the horizon, a far one in the same direction."""
        right, up = (pixel.real - self.centre.real) / self.scale, (self.centre.imag - pixel.imag) / self.scale
        if self.flat:
            return complex(right, up)
        sine, cosine = math.sin(self.tilt), math.cos(self.tilt)
        away = up / max(cosine - up * self.closeness * sine, _HORIZON * cosine)
        turned = complex(right * (1.0 + self.closeness * away * sine), away)
        return turned / self.turning

    def nearer(self, one: "Points", normal: "Points") -> "Reals":
        """Positive where the eye is on the side of a vertical plane that its normal points to.

        one: a point of the plane's foot; normal: horizontal, of the foot; both turned by `turning`. The eye stands above
        the ground's point -i sin(tilt) / closeness, which may be infinitely far.
        """
        return -math.sin(self.tilt) * normal.imag - self.closeness * (one.real * normal.real + one.imag * normal.imag)


class Layout(NamedTuple):
    """How a surface is divided.

    size: of the part that the arena and the head-up display share, pixels.
    camera: a flat one that shows the arena in the middle of it.
    unit: pixels; text and spacing are multiples of it.
    ground_radius: world units.
    beside: whether the head-up display stands beside the arena, else above and below.
    """

    size: tuple[int, int]
    camera: Camera
    unit: float
    ground_radius: float
    beside: bool

    def right_edge(self, y: float) -> float:
        """Where the flat arena ends to the right at a height of the surface, pixels; its middle where it is not."""
        return self.camera.centre.real + self._half_chord(y)

    def left_edge(self, y: float) -> float:
        """Where it ends to the left."""
        return self.camera.centre.real - self._half_chord(y)

    def _half_chord(self, y: float) -> float:
        """Half the arena's width at a height of the surface, pixels."""
        radius, away = self.ground_radius * self.camera.scale, y - self.camera.centre.imag
        return math.sqrt(max(radius**2 - away**2, 0.0))


def layout(size: tuple[int, int], ground_radius: float, below: float = 0.0) -> Layout:
    """The arena as large as the surface allows, with room for the head-up display.

    below: pixels at the bottom to leave free for something else.
    """
    width, height = max(size[0], 1), max(round(size[1] - below), 1)
    beside = width / height > _SQUARE
    free = height if beside else height * (1.0 - 2.0 * _BAND)
    diameter = min(width, free) * (1.0 - 2.0 * _MARGIN)
    camera = Camera(complex(width, height) / 2.0, max(diameter / 2.0 / ground_radius, 1e-3))
    return Layout((width, height), camera, unit_of(size), ground_radius, beside)


def unit_of(size: tuple[int, int]) -> float:
    """Size of body text, pixels: a 34th of the height, less where the window is narrow."""
    return max(min(size[1] / 34.0, size[0] / 44.0), 4.0)


def bearing(camera: Camera, pixel: complex) -> float | None:
    """Angle of the direction from the arena's centre to a pixel, radians; None too near to the centre to tell."""
    point = camera.unproject(pixel)
    if abs(point) * camera.scale < _CENTRE:
        return None
    return math.atan2(point.imag, point.real)
