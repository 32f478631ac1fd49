"""Every key of a level file, with its range and default."""

import hashlib
import math
from typing import Annotated, Any, Literal, get_args

import msgspec
from msgspec import Meta

from physics import PERMANENT, Arena, Ring

Size = Annotated[float, Meta(ge=0.001, le=1000.0)]
Degrees = Annotated[float, Meta(ge=0.01, le=180.0)]
Fraction = Annotated[float, Meta(ge=0.0, le=1.0)]
Angle = Annotated[float, Meta(ge=-360.0, le=360.0)]
Layers = Annotated[int, Meta(ge=PERMANENT, le=9)]
Tint = Annotated[int, Meta(ge=0, le=8)]
Seconds = Annotated[float, Meta(ge=0.0, le=600.0)]
DropKind = Literal["multi_ball", "wide", "narrow", "slow", "fast", "sticky", "life", "shield", "pierce"]
DROP_KINDS: tuple[DropKind, ...] = get_args(DropKind)
Palette = Literal["classic", "ember", "ocean", "forest", "violet", "ice", "gold", "dusk"]
GroundPattern = Literal["plain", "rings", "rays", "dots", "spiral"]


class BallSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The ball: radius in world units, speed in units per second.

    growth: share of `speed` by which the ball gets faster with every few hits of a paddle; top_speed: until it has this speed,
    None for 1.4 times `speed`. Both are for the arcade rules.
    """

    radius: Size
    speed: Size
    growth: Annotated[float, Meta(ge=0.0, le=0.5)] = 0.04
    top_speed: Size | None = None


class PaddleSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The paddles: degrees, degrees per second, degrees per second squared.

    turn: the most, in degrees, by which the arcade rules turn a ball by where it meets the paddle.
    """

    radius: Size
    half_width: Size
    half_angle: Degrees
    top_speed: Annotated[float, Meta(ge=1.0, le=36000.0)]
    acceleration: Annotated[float, Meta(ge=1.0, le=360000.0)]
    friction: Fraction = 0.5
    count: Annotated[int, Meta(ge=1, le=12)] = 3
    phase: Angle = 270.0
    turn: Annotated[float, Meta(ge=0.0, le=60.0)] = 25.0


class RingSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One ring of bricks. layers: one number for all slots, or one per slot; 0 empty, -1 unbreakable.

    For the arcade rules: bumper: whether its sectors, all unbreakable, give points and a short burst of speed. regrow: seconds
    after which the next of its missing bricks grows again, as long as there are bricks elsewhere; 0 for never. reverse: seconds
    after which it turns the other way round, again and again; 0 for never.
    tint: how many colours of the palette its lowest layers skip; a list is repeated around the ring. It decides nothing.
    """

    radius: Size
    half_width: Size
    half_angle: Degrees
    count: Annotated[int, Meta(ge=1, le=2000)]
    layers: Layers | list[Layers] = 1
    phase: Angle = 0.0
    spin: Annotated[float, Meta(ge=-36000.0, le=36000.0)] = 0.0
    friction: Fraction = 0.0
    bumper: bool = False
    regrow: Seconds = 0.0
    reverse: Seconds = 0.0
    tint: Tint | Annotated[list[Tint], Meta(min_length=1, max_length=2000)] = 0

    def slots(self) -> tuple[int, ...]:
        """Layers of each slot."""
        return tuple(self.layers) if isinstance(self.layers, list) else (self.layers,) * self.count

    def tints(self) -> tuple[int, ...]:
        """Tints of the slots, to be repeated around the ring."""
        return tuple(self.tint) if isinstance(self.tint, list) else (self.tint,)

    def tint_at(self, slot: int) -> int:
        """Tint of one slot."""
        return self.tint[slot % len(self.tint)] if isinstance(self.tint, list) else self.tint


class WellSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A gravity well of the arcade rules: it turns the flight of balls near it.

    distance: from the arena's centre, world units. strength: acceleration at its middle, world units per second squared; below
    0 it pushes. The pull falls evenly to 0 at `reach`, world units.
    """

    distance: Annotated[float, Meta(ge=0.0, le=1000.0)]
    strength: Annotated[float, Meta(ge=-1e6, le=1e6)]
    reach: Size
    angle: Angle = 0.0


class DropSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What broken bricks of the arcade rules leave: how often, and which power-ups."""

    chance: Fraction = 0.12
    kinds: Annotated[list[DropKind], Meta(min_length=1, max_length=9)] = msgspec.field(default_factory=lambda: [*DROP_KINDS])


class LookSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the level is drawn; it decides nothing."""

    palette: Palette = "classic"
    ground: GroundPattern = "plain"


class Level(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One arena and its bricks; world units, degrees."""

    name: Annotated[str, Meta(min_length=1, max_length=40)]
    ground_radius: Size
    ball: BallSpec
    paddles: PaddleSpec
    rings: Annotated[list[RingSpec], Meta(min_length=1, max_length=32)]
    description: Annotated[str, Meta(max_length=200)] = ""
    chapter: Annotated[str, Meta(max_length=40)] = ""
    drops: DropSpec = DropSpec()
    wells: Annotated[list[WellSpec], Meta(max_length=8)] = []
    look: LookSpec = LookSpec()

    def arena(self) -> Arena:
        """The arena before the first serve: ring 0 is the paddles, no ball yet."""
        paddles = self.paddles
        sizes = (paddles.radius, paddles.half_width, math.radians(paddles.half_angle), paddles.count)
        rings = [Ring(*sizes, math.radians(paddles.phase), 0.0, paddles.friction)]
        layers = [(PERMANENT,) * paddles.count]
        for ring in self.rings:
            sizes = (ring.radius, ring.half_width, math.radians(ring.half_angle), ring.count)
            rings.append(Ring(*sizes, math.radians(ring.phase), math.radians(ring.spin), ring.friction))
            layers.append(ring.slots())
        return Arena((), tuple(rings), tuple(layers))

    def content_hash(self) -> str:
        """SHA-256 of what the level says, however its file is written.

        Keys that came after the first recorded games count only where they are not at their defaults: so a level without them
        has the hash that it always had.
        """
        return hashlib.sha256(msgspec.json.encode(_counted(self))).hexdigest()


_LATER = {"growth", "top_speed", "turn", "bumper", "regrow", "reverse", "chapter", "drops", "wells", "look", "tint"}
"""Keys that came after replay format 2."""


def _counted(value: Any) -> Any:
    """A level, or a part of one, as tables: without later keys at their defaults."""
    if isinstance(value, list):
        return [_counted(item) for item in value]
    if not isinstance(value, msgspec.Struct):
        return value
    found = {}
    for field in msgspec.structs.fields(value):
        item = getattr(value, field.name)
        default = field.default if field.default_factory is msgspec.NODEFAULT else field.default_factory()
        if field.name not in _LATER or item != default:
            found[field.name] = _counted(item)
    return found
