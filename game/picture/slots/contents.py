"""What stands in every slot of a scene's rings at a moment, and how brightly it glows after a hit."""

import math
from enum import IntEnum, auto
from functools import lru_cache
from typing import NamedTuple

from game.effects import Flash
from game.effects.entry import GLOW, arrival, order
from game.rules import PADDLES, PowerUp
from game.scene import Scene
from physics import PERMANENT

GLOW_STEPS = 6
"""Steps from no glow to the full one: pictures of slots are cached, and every step is another picture."""
_ECHO_GLOW = 2
"""Glow of a slot while the front of the light that runs around its ring is passing."""


class ContentKind(IntEnum):
    """What a slot can hold."""

    EMPTY = auto()
    PADDLE = auto()
    STICKY_PADDLE = auto()
    SECOND_PADDLE = auto()
    """Of the second player, where two play against each other."""
    STICKY_SECOND_PADDLE = auto()
    BRICKS = auto()
    STEEL = auto()
    BUMPER = auto()
    SHIELD = auto()
    GROWING = auto()
    """Bricks that grow again."""
    GHOST = auto()
    """An empty slot whose last brick has just gone: its light is left for a moment."""


class SlotContent(NamedTuple):
    """What stands in one slot.

    kind: what it is.
    layers: of a stack of bricks; 0 of everything else.
    glow: 0 none to GLOW_STEPS full.
    tint: how many of the palette's colours for layers the lowest one skips.
    """

    kind: ContentKind
    layers: int = 0
    glow: int = 0
    tint: int = 0


_FLAT_KINDS = frozenset({ContentKind.EMPTY, ContentKind.GHOST})
"""Contents without height."""
Contents = tuple[tuple[SlotContent, ...], ...]
"""What stands in the slots, per ring and slot."""

_PADDLE_KINDS = (
    (ContentKind.PADDLE, ContentKind.STICKY_PADDLE),
    (ContentKind.SECOND_PADDLE, ContentKind.STICKY_SECOND_PADDLE),
)
"""Of each player: without and with glue."""
_EMPTY, _STEEL = SlotContent(ContentKind.EMPTY), SlotContent(ContentKind.STEEL)


def casts_shadow(content: SlotContent) -> bool:
    """Whether what stands in a slot has a height, and so a shadow."""
    return content.kind not in _FLAT_KINDS


def slot_contents(scene: Scene) -> Contents:
    """What stands in all slots of a scene."""
    flashes: dict[int, list[Flash]] = {}
    for flash in scene.flashes:
        flashes.setdefault(flash.ring, []).append(flash)
    return tuple([_ring_contents(scene, k, flashes.get(k, [])) for k in range(len(scene.layers))])


@lru_cache(maxsize=8)
def resting_contents(layers: tuple[tuple[int, ...], ...], tints: tuple[tuple[int, ...], ...] = ()) -> Contents:
    """What stands in the slots while nothing glows. layers: per ring and slot, as in `physics.Arena`; tints: as in `Scene`."""
    wall = [_tinted(_resting(ring), _tints_of(k, tints)) for k, ring in enumerate(layers[PADDLES + 1 :], PADDLES + 1)]
    return (_paddles(len(layers[PADDLES]), _PADDLE_KINDS[0][0]), *wall)


def pushed_out(scene: Scene, k: int) -> dict[int, float]:
    """How far the contents of some slots of a ring are pushed away from the arena's centre, by slot, world units."""
    return {recoil.slot: recoil.out for recoil in scene.recoils} if k == PADDLES else {}


def _ring_contents(scene: Scene, k: int, flashes: list[Flash]) -> tuple[SlotContent, ...]:
    """What stands in the slots of one ring. flashes: of this ring."""
    layers = scene.layers[k]
    if k in (PADDLES, scene.second_paddle):
        player = int(k != PADDLES)
        sticky = any([power.kind == PowerUp.STICKY and power.player == player for power in scene.powers])
        return _paddles(len(layers), _PADDLE_KINDS[player][sticky])
    contents = wall_contents(layers, flashes)
    if scene.entry is not None:
        contents = _entering(scene, k, contents, scene.entry)
    contents = _tinted(contents, _tints_of(k, scene.tints))
    if k == scene.shield:
        return _renamed(contents, ContentKind.BRICKS, ContentKind.SHIELD)
    if k in scene.bumpers:
        return _renamed(contents, ContentKind.STEEL, ContentKind.BUMPER)
    return _renamed(contents, ContentKind.BRICKS, ContentKind.GROWING) if k in scene.growing else contents


def _entering(scene: Scene, k: int, contents: tuple[SlotContent, ...], entry: int) -> tuple[SlotContent, ...]:
    """The contents of a ring while the wall is built up. entry: ticks since that began."""
    numbers = order(tuple([ring.radius for ring in scene.rings]))
    come = [arrival(entry, numbers[k], len(numbers) - 1, slot, len(contents)) for slot in range(len(contents))]
    return tuple([_arrived(content, share) for content, share in zip(contents, come, strict=True)])


def _arrived(content: SlotContent, come: float) -> SlotContent:
    """The content of a slot whose brick has come so far. come: as `arrival` says."""
    if come < 0.0 or content.kind is ContentKind.EMPTY:
        return _EMPTY
    return content._replace(glow=max(content.glow, math.ceil(GLOW * (1.0 - come) * GLOW_STEPS)))


def _tints_of(k: int, tints: tuple[tuple[int, ...], ...]) -> tuple[int, ...]:
    """The tints of a ring that is not the paddles' one; 0 for a ring that the level does not name. tints: as in `Scene`."""
    number = k - PADDLES - 1
    return tints[number] if number < len(tints) else (0,)


@lru_cache(maxsize=256)
def _tinted(contents: tuple[SlotContent, ...], tints: tuple[int, ...]) -> tuple[SlotContent, ...]:
    """The contents with the tints of their slots. tints: repeated around the ring."""
    if not any(tints):
        return contents
    return tuple([content._replace(tint=tints[slot % len(tints)]) for slot, content in enumerate(contents)])


@lru_cache(maxsize=64)
def _renamed(contents: tuple[SlotContent, ...], before: ContentKind, after: ContentKind) -> tuple[SlotContent, ...]:
    """The contents with another kind in place of one."""
    return tuple([content._replace(kind=after) if content.kind is before else content for content in contents])


@lru_cache(maxsize=16)
def _paddles(count: int, kind: ContentKind) -> tuple[SlotContent, ...]:
    """The contents of the paddles' ring, without the light of hits: `game.picture.moving.glints` adds it where a ball hit."""
    return (SlotContent(kind),) * count


def wall_contents(layers: tuple[int, ...], flashes: list[Flash]) -> tuple[SlotContent, ...]:
    """The contents of a ring of bricks. layers: per slot; flashes: of this ring."""
    resting = _resting(layers)
    if not flashes:
        return resting
    contents = list(resting)
    for flash in flashes:
        if flash.echoed:
            _add_echo(contents, flash)
    for flash in flashes:
        if flash.lit:
            kind, count = contents[flash.slot][:2]
            contents[flash.slot] = SlotContent(ContentKind.GHOST if kind is ContentKind.EMPTY else kind, count, _glow(flash))
    return tuple(contents)


@lru_cache(maxsize=64)
def _resting(layers: tuple[int, ...]) -> tuple[SlotContent, ...]:
    """The contents of a ring of bricks while nothing glows."""
    return tuple([_standing(count) for count in layers])


def _standing(layers: int) -> SlotContent:
    """What a number of layers stands for."""
    if layers == PERMANENT:
        return _STEEL
    return SlotContent(ContentKind.BRICKS, layers) if layers else _EMPTY


def _glow(flash: Flash) -> int:
    """The glow of a slot that was hit: it fades with the flash's age."""
    return math.ceil((1.0 - flash.age) * GLOW_STEPS)


def _add_echo(contents: list[SlotContent], flash: Flash) -> None:
    """Light that runs around the ring from a hit, in both directions, and meets on the far side.

    It moves on only when the flash's own glow changes, so that it needs no more pictures than the flash does.
    """
    count = len(contents)
    front = (GLOW_STEPS - _glow(flash) + 1) / GLOW_STEPS * (count / 2.0)
    width = count / (2.0 * GLOW_STEPS)
    for slot, (kind, layers, glow, _) in enumerate(contents):
        distance = abs((slot - flash.slot + count // 2) % count - count // 2)
        if kind is not ContentKind.EMPTY and front - 2.0 * width < distance <= front:
            echo = _ECHO_GLOW if distance > front - width else 1
            contents[slot] = SlotContent(kind, layers, max(glow, echo))
