"""The solid view as primitives: shadows, then blocks, balls and flying pieces from back to front."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.light import LIGHT, shadow_offset, side_shares
from game.drawing.palette import Theme
from game.picture.display_list import DisplayList
from game.picture.moving.balls import add_ball, ball_outline
from game.picture.moving.bursts import Flying
from game.picture.slots.contents import Contents, pushed_out
from game.picture.solid.order import Span, among_rings, back_to_front
from game.picture.solid.prisms import SlotPrisms, part_of
from game.picture.solid.rings import RingPrisms, SlotShadow, SolidRing, ring_prisms, solid_rings
from game.scene import Scene


class _Moving(NamedTuple):
    """A ball or a piece in the air, sorted among spans. rank, nearness: as in `Span`. number: its index."""

    rank: float
    nearness: float
    number: int


class SolidBlocks:
    """Adds the solid view to lists. Caches every ring's primitives, which depend neither on its angle nor on the camera's."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._rings: dict[int, _RingLists] = {}

    def add(
        self,
        out: DisplayList,
        scene: Scene,
        camera: Camera,
        theme: Theme,
        contents: Contents,
        texture: int,
        flying: Sequence[Flying],
    ) -> None:
        """Add the shadows, then all that stands, lies or flies from back to front. texture: of balls."""
        rings = [self._ring_lists(k, ring) for k, ring in enumerate(solid_rings(scene, contents, theme, camera.scale))]
        out.camera(camera, LIGHT, side_shares(theme), shadow_offset(camera))
        pushed = [pushed_out(scene, k) for k in range(len(rings))]
        for k, lists in enumerate(rings):
            lists.add_shadows(out, scene.rings[k].phase, pushed[k])
        moving = list(flying)
        out.slot(0.0)
        for ball in scene.balls:
            out.shadows(ball_outline(ball), [(0.0, ball.radius, ball.radius)], theme.shadow)
            moving.append((ball.position, DisplayList()))
            add_ball(moving[-1][1], ball, camera, texture)
        ranks = among_rings([position for position, _ in moving], scene.rings, camera)
        spans = back_to_front(scene.rings, [lists.wedges for lists in rings], camera)
        order: list[Span | _Moving] = [*spans, *[_Moving(*rank, number) for number, rank in enumerate(ranks)]]
        for item in sorted(order):
            if isinstance(item, _Moving):
                out.extend(moving[item.number][1])
            elif (picture := rings[item.ring].span(item)).numbers:
                ring = scene.rings[item.ring]
                out.slot(ring.phase + math.tau * item.slot / ring.count, pushed[item.ring].get(item.slot, 0.0))
                out.extend(picture)

    def _ring_lists(self, k: int, ring: SolidRing) -> "_RingLists":
        """The primitives of a ring."""
        cached = self._rings.get(k)
        if cached is None or cached.ring != ring:
            cached = self._rings[k] = _RingLists(ring, cached)
        return cached


class _RingLists:
    """The primitives of a ring's slots at angle 0."""

    def __init__(self, ring: SolidRing, before: "_RingLists | None") -> None:
        """Make those of whole slots. before: of the ring before it changed; most of its slots have not."""
        self.ring, self.wedges, self._prisms = ring, ring.division.wedges, ring_prisms(ring)
        self.whole: dict[int, tuple[SlotPrisms, DisplayList]] = {}  # by the identity of what stands there
        cached = {} if before is None else before.whole
        for stands in self._prisms.slots:
            if id(stands) not in self.whole:
                self.whole[id(stands)] = cached.get(id(stands)) or (stands, self._listed(stands, 0, self.wedges - 1))
        self._slots = [self.whole[id(stands)][1] for stands in self._prisms.slots]
        self._parts: dict[tuple[int, int, int], DisplayList] = {}
        self._shadows = _shadows(self._prisms, ring.theme)

    def add_shadows(self, out: DisplayList, phase: float, pushed: dict[int, float]) -> None:
        """Add the shadows of the ring's slots. pushed: as of `pushed_out`."""
        if not pushed:
            if self._shadows.numbers:
                out.slot(phase)
                out.extend(self._shadows)
            return
        count = len(self._prisms.slots)
        for slot, shadow in enumerate(self._prisms.shadows):
            if shadow is not None:
                out.slot(phase + math.tau * slot / count, pushed.get(slot, 0.0))
                standing = [(0.0, shadow.low, shadow.high)]
                out.shadows(shadow.outline, standing, self.ring.theme.shadow, shadow.casting, shadow.ends)

    def span(self, span: Span) -> DisplayList:
        """What wedges of a slot have.

        Far wedges are drawn with the next ones, which near ones then cover: a gap between two smooth edges would show.
        """
        _, _, _, slot, first, last = span
        if last - first + 1 == self.wedges:
            return self._slots[slot]
        if span.rank < 0.0:
            first, last = self._widened(first, last)
        key = slot, first, last
        if key not in self._parts:
            self._parts[key] = self._listed(self._prisms.slots[slot], first, last)
        return self._parts[key]

    def _widened(self, first: int, last: int) -> tuple[int, int]:
        """The first and the last wedge of a span that is wider by one at both ends, where the slot goes on there."""
        if self._prisms.ends:
            return max(first - 1, 0), min(last + 1, self.wedges - 1)
        most = (last - first) % self.wedges + 3 > self.wedges
        return (0, self.wedges - 1) if most else ((first - 1) % self.wedges, (last + 1) % self.wedges)

    def _listed(self, stands: SlotPrisms, first: int, last: int) -> DisplayList:
        """What wedges of a slot have, from the lowest prism to the highest."""
        out, ends, even = DisplayList(), self._prisms.ends, self._prisms.evenly_lit
        sides = int(ends and first == 0) + 2 * int(ends and last == self.wedges - 1)
        for prism in stands.prisms:
            part = part_of(prism, self.ring.division, first, last)
            if part is not None:
                out.prism(part.outline, part.bottom, part.top, part.colour, sides, even=even)
        return out


def _shadows(ring: RingPrisms, theme: Theme) -> DisplayList:
    """The shadows of a ring at phase 0. Those of slots with the same outlines are one primitive."""
    out, count = DisplayList(), len(ring.slots)
    alike: dict[SlotShadow, list[tuple[float, float, float]]] = {}
    for slot, shadow in enumerate(ring.shadows):
        if shadow is not None:
            key = shadow._replace(low=0.0, high=0.0)
            alike.setdefault(key, []).append((math.tau * slot / count, shadow.low, shadow.high))
    for shadow, standing in alike.items():
        out.shadows(shadow.outline, standing, theme.shadow, shadow.casting, shadow.ends)
    return out
