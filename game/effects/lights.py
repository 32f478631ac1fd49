"""Light that a hit throws on the arena around it, for a moment."""

import cmath
from enum import Enum, auto
from typing import NamedTuple

from game.rules import BEST_COMBO, PADDLES, Event, EventKind, Game, Phase, PowerUp, Ticked, layers_left


class LightSource(Enum):
    """What shines; it tells the light's colour."""

    PADDLE = auto()
    BRICK = auto()
    STEEL = auto()
    GOOD = auto()
    BAD = auto()
    POWER = auto()


class Light(NamedTuple):
    """A light that fades.

    reach: how far it is seen, in ground radii.
    strength: 0 to 1, when new.
    ticks: that it is seen.
    layer: of a brick, 1 the lowest, its tint added; 0 of all else. power: of a power-up.
    """

    source: LightSource
    position: complex
    reach: float
    strength: float
    ticks: int
    layer: int = 0
    power: PowerUp | None = None
    age: int = 0

    @property
    def now(self) -> float:
        """Strength at its age: it fades fast at first."""
        return self.strength * (1.0 - self.age / self.ticks) ** 2


MOST = 12
"""Lights at once; the oldest make room."""
_BRICK, _BRICK_PER_COMBO, _BRICK_REACH, _BRICK_TICKS = 0.7, 0.04, 0.34, 120
"""Strength of a brick's light, what every brick in a row adds to it up to the best combo, its reach and its ticks."""
_LIGHTS = {
    EventKind.PADDLE_HIT: Light(LightSource.PADDLE, 0j, 0.34, 0.8, 100),
    EventKind.SHIELD_HIT: Light(LightSource.PADDLE, 0j, 0.5, 1.0, 130),
    EventKind.WALL_HIT: Light(LightSource.STEEL, 0j, 0.16, 0.5, 50),
    EventKind.BALLS_MET: Light(LightSource.STEEL, 0j, 0.16, 0.5, 50),
    EventKind.BUMPER_HIT: Light(LightSource.GOOD, 0j, 0.36, 0.9, 110),
    EventKind.LIFE_GAINED: Light(LightSource.GOOD, 0j, 0.36, 0.9, 110),
    EventKind.BALL_LOST: Light(LightSource.BAD, 0j, 0.4, 1.0, 200),
    EventKind.BRICK_REGROWN: Light(LightSource.GOOD, 0j, 0.16, 0.6, 90),
    EventKind.DROP_CAUGHT: Light(LightSource.POWER, 0j, 0.4, 0.9, 120),
    EventKind.DROP_LOST: Light(LightSource.POWER, 0j, 0.2, 0.5, 90),
    EventKind.BALL_RELEASED: Light(LightSource.PADDLE, 0j, 0.34, 0.8, 100),
}
"""The lights of events but for bricks, whose light depends on more."""


_LAST = Light(LightSource.GOOD, 0j, 0.24, 0.7, 150)
_LAST_EVERY = 180
"""The light that shows where a level's last brick is, and ticks from one to the next."""


def after_tick(lights: tuple[Light, ...], ticked: Ticked) -> tuple[Light, ...]:
    """The lights a tick later."""
    if ticked.game.tick % _LAST_EVERY == 0 and (last := _last_brick(ticked.game)) is not None:
        lights = (*lights, _LAST._replace(position=last))[-MOST:]
    if lights:
        older = [light._replace(age=light.age + 1) for light in lights]
        lights = tuple([light for light in older if light.age < light.ticks])
    new = [light for event in ticked.events if (light := _light(event, ticked)) is not None]
    return (*[light for light in lights if not _covered(light, new, ticked)], *new)[-MOST:] if new else lights


def _last_brick(game: Game) -> complex | None:
    """The position of the last layer of a level; None if there are more, or no ball is in play."""
    if game.phase != Phase.PLAYING or layers_left(game) != 1:
        return None
    for k in range(PADDLES + 1, len(game.level.rings) + 1):
        if 1 in game.arena.layers[k]:
            ring = game.arena.rings[k]
            return cmath.rect(ring.radius, ring.angle(game.arena.layers[k].index(1)))
    return None


def _covered(light: Light, new: list[Light], ticked: Ticked) -> bool:
    """Whether a light makes room for a new one of its kind that is close: two together would be glaring."""
    room = 0.5 * light.reach * ticked.game.level.ground_radius
    return any([other.source is light.source and abs(other.position - light.position) < room for other in new])


def _light(event: Event, ticked: Ticked) -> Light | None:
    """The light of an event; None for those that are dark."""
    if event.kind == EventKind.BRICK_HIT:
        hit = event.hit
        layer = 1 if hit is None else max(hit.layers, 0) + 1 + ticked.game.level.rings[hit.ring - PADDLES - 1].tint_at(hit.slot)
        strength = min(_BRICK + _BRICK_PER_COMBO * min(ticked.game.combo, BEST_COMBO), 1.0)
        return Light(LightSource.BRICK, event.position, _BRICK_REACH, strength, _BRICK_TICKS, layer)
    if event.kind == EventKind.BRICK_CRUMBLED and event.sector is not None:
        ring, slot = event.sector
        layer = ticked.game.arena.layers[ring][slot] + 1
        return Light(LightSource.BRICK, event.position, _BRICK_REACH, _BRICK, _BRICK_TICKS, layer)
    light = _LIGHTS.get(event.kind)
    return None if light is None else light._replace(position=event.position, power=event.power)
