"""The blocks of all rings as a camera sees them, from back to front. Caches what an orbit or a turning ring does not change."""

import operator
from collections import OrderedDict
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from game.drawing.camera import Camera
from game.drawing.solid.blocks import Blocks, Integers, recoloured, ring_blocks
from game.drawing.solid.faces import ProjectedBlocks, projected
from game.picture.slots.contents import ContentKind, SlotContent, pushed_out
from game.picture.solid.order import Span, back_to_front
from game.picture.solid.prisms import wedges_between
from game.picture.solid.rings import SolidRing, ring_prisms
from game.scene import Scene

_MOST_RINGS = 64
"""Rings whose blocks are cached."""


class _JoinedBlocks(NamedTuple):
    """The blocks of several rings.

    parts: of each ring.
    blocks: of all; their wedges are counted through all rings.
    ring: index of each one's ring.
    first: number of each ring's first wedge; at last the number of all wedges.
    """

    parts: list[Blocks]
    blocks: Blocks
    ring: Integers
    first: list[int]


class ArenaBlocks:
    """The blocks of scenes on the screen."""

    def __init__(self) -> None:
        """Start with nothing cached."""
        self._rings: OrderedDict[SolidRing, Blocks] = OrderedDict()
        self._joined: _JoinedBlocks | None = None

    def seen(self, scene: Scene, rings: Sequence[SolidRing], camera: Camera) -> ProjectedBlocks:
        """The blocks of a scene as a camera sees them. rings: of the scene."""
        parts = [self._ring_blocks(ring) for ring in rings]
        wedges = [ring.division.wedges for ring in rings]
        joined = self._joined
        if joined is None or len(joined.parts) != len(parts) or any(map(operator.is_not, joined.parts, parts)):
            joined = self._joined = _joined(parts, [len(ring.contents) * ring.division.wedges for ring in rings])
        order = _order(joined, back_to_front(scene.rings, wedges, camera), wedges)
        phase = np.array([ring.phase for ring in scene.rings])[joined.ring]
        return projected(_pushed(joined, scene), phase, order, camera)

    def _ring_blocks(self, ring: SolidRing) -> Blocks:
        """The blocks of one ring, cached; if only the light of hits differs, cached shapes get new colours."""
        found = self._rings.get(ring)
        if found is None:
            unlit, prisms = ring._replace(contents=_unlit(ring.contents)), ring_prisms(ring)
            found = ring_blocks(prisms) if unlit == ring else recoloured(self._ring_blocks(unlit), prisms)
            self._rings[ring] = found
            if len(self._rings) > _MOST_RINGS:
                self._rings.popitem(last=False)
        else:
            self._rings.move_to_end(ring)
        return found


def _joined(parts: list[Blocks], counts: list[int]) -> _JoinedBlocks:
    """The blocks of several rings. counts: wedges of each."""
    first = np.cumsum([0, *counts])
    ring = np.repeat(np.arange(len(parts)), [len(part.slot) for part in parts])
    columns: list[Any] = [np.concatenate(column) for column in zip(*parts, strict=True)]
    blocks = Blocks(*columns)
    return _JoinedBlocks(parts, blocks._replace(wedges=blocks.wedges + first[ring, None]), ring, first.tolist())


def _pushed(joined: _JoinedBlocks, scene: Scene) -> Blocks:
    """The blocks of a scene, those of some slots farther out."""
    blocks, moved = joined.blocks, joined.blocks
    for k in range(len(scene.rings)):
        for slot, out in pushed_out(scene, k).items():
            rows = np.flatnonzero((joined.ring == k) & (blocks.slot == slot))
            if moved is blocks:
                moved = blocks._replace(foot=blocks.foot.copy(), shadow_foot=blocks.shadow_foot.copy())
            for foot in (moved.foot, moved.shadow_foot):
                foot[rows] *= 1.0 + out / np.abs(foot[rows])
    return moved


def _order(joined: _JoinedBlocks, spans: Sequence[Span], wedges: Sequence[int]) -> Integers:
    """Numbers of the blocks from back to front. wedges: of the slots of each ring.

    Blocks of a span are in the order of their prisms. What lies on several wedges comes with the last one of them.
    """
    position = [0] * joined.first[-1]
    for number, (_, _, k, slot, begin, end) in enumerate(spans):
        first = joined.first[k] + slot * wedges[k]
        if begin == end:
            position[first + begin] = number
        else:
            for wedge in wedges_between(begin, end, wedges[k]):
                position[first + wedge] = number
    of_wedges = np.array(position, dtype=np.int16)[joined.blocks.wedges]
    return np.argsort(np.maximum(of_wedges[:, 0], of_wedges[:, 1]), kind="stable")


@lru_cache(maxsize=256)
def _unlit(contents: tuple[SlotContent, ...]) -> tuple[SlotContent, ...]:
    """The contents of a ring without the light of hits; contents that consist of light only stay."""
    return tuple([one if one.kind is ContentKind.GHOST else one._replace(glow=0) for one in contents])
