"""Which part of the world a pane shows: moved by dragging, zoomed about the pointer, and back to the whole."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol

from game.drawing.camera import Camera
from game.lab.kit.parameters import Given
from game.lab.kit.scene import LabScene, ViewBox

_STEP = 1.15
"""The zoom of one step of the wheel."""
_LEAST, _MOST = 0.05, 200.0
_MARGIN = 0.12
"""Around a position that is to be shown, in halves of the view box."""
_FARTHEST = 50.0
"""World units that the middle of what is shown may be away from the view box's."""


class Area(Protocol):
    """A rectangle of pixels, such as pygame's."""

    @property
    def width(self) -> float:
        """Pixels."""

    @property
    def height(self) -> float:
        """Pixels."""

    @property
    def center(self) -> tuple[float, float]:
        """Its middle, x and y."""


class PanZoom(NamedTuple):
    """How what is shown differs from the scene's view box. pan: its middle from the box's, world units."""

    pan: complex = 0j
    zoom: float = 1.0

    def camera(self, box: ViewBox, area: Area) -> Camera:
        """The camera for an area."""
        return camera_for(ViewBox(box.centre + self.pan, box.half / self.zoom), area)

    @classmethod
    def showing(cls, box: ViewBox, positions: Sequence[complex]) -> "PanZoom":
        """The view box, widened if need be to show these positions with a margin around them."""
        half = box.half
        low, high = box.centre - half, box.centre + half
        xs = [low.real, high.real, *[one.real + side * half.real for one in positions for side in (-_MARGIN, _MARGIN)]]
        ys = [low.imag, high.imag, *[one.imag + side * half.imag for one in positions for side in (-_MARGIN, _MARGIN)]]
        middle = complex(max(xs) + min(xs), max(ys) + min(ys)) / 2.0
        zoom = 2.0 * min(half.real / (max(xs) - min(xs)), half.imag / (max(ys) - min(ys)))
        return cls(middle - box.centre, zoom) if zoom < 1.0 else cls()

    @classmethod
    def whole(cls, scene: LabScene, given: Given) -> "PanZoom":
        """Shows a scene's view box, and the positions of its first two handles wherever they are."""
        return cls.showing(scene.view_box, [handle.position(given) for handle in scene.handles[:2]])

    def dragged(self, camera: Camera, pixels: complex) -> "PanZoom":
        """After the world was dragged by so many pixels."""
        return self._panned_to(self.pan - pixels.conjugate() / camera.scale)

    def zoomed(self, box: ViewBox, area: Area, pixel: complex, steps: float) -> "PanZoom":
        """After some steps of the wheel; what is under the pixel stays there."""
        zoom = min(max(self.zoom * _STEP ** min(max(steps, -20.0), 20.0), _LEAST), _MOST)
        nearer = PanZoom(self.pan, zoom)
        slipped = self.camera(box, area).unproject(pixel) - nearer.camera(box, area).unproject(pixel)
        return nearer._panned_to(self.pan + slipped)

    def _panned_to(self, pan: complex) -> "PanZoom":
        """With another pan, at most as far as the farthest."""
        return PanZoom(pan if abs(pan) <= _FARTHEST else pan / abs(pan) * _FARTHEST, self.zoom)


def camera_for(box: ViewBox, area: Area) -> Camera:
    """The camera that shows a part of the world in the middle of an area, as large as fits."""
    scale = max(min(area.width / (2.0 * box.half.real), area.height / (2.0 * box.half.imag)), 1e-3)
    return Camera(complex(*area.center) - box.centre.conjugate() * scale, scale)
