"""Circles about the arena's centre that run over the ground on great moments."""

from enum import Enum, auto
from typing import NamedTuple

from game.rules import PADDLES, Event, EventKind, Phase, Ticked

WAVE_TICKS = 150
_APART = 22
"""Ticks from one circle to the next."""


class Tone(Enum):
    """What the news is."""

    START = auto()
    GOOD = auto()
    BAD = auto()


class Wave(NamedTuple):
    """One circle."""

    tone: Tone
    start: float  # radius when new, world units
    end: float
    age: int = 0  # ticks; below 0 it waits

    @property
    def share(self) -> float:
        """How far on its way it is, 0 to 1: fast first."""
        done = min(max(self.age / WAVE_TICKS, 0.0), 1.0)
        return 1.0 - (1.0 - done) ** 2

    @property
    def radius(self) -> float:
        """World units."""
        return self.start + (self.end - self.start) * self.share


def after_tick(waves: tuple[Wave, ...], ticked: Ticked) -> tuple[Wave, ...]:
    """The circles a tick later."""
    if waves:
        older = [wave._replace(age=wave.age + 1) for wave in waves]
        waves = tuple([wave for wave in older if wave.age < WAVE_TICKS])
    for event in ticked.events:
        waves = (*waves, *_waves(event, ticked))
    if ticked.game.tick == 1 and ticked.game.phase == Phase.SERVING:
        waves = _started(ticked)
    return waves


def _waves(event: Event, ticked: Ticked) -> tuple[Wave, ...]:
    """The circles of an event; none of most."""
    ground = ticked.game.level.ground_radius
    match event.kind:
        case EventKind.LEVEL_STARTED:
            return _started(ticked)
        case EventKind.LEVEL_CLEARED:
            return tuple([Wave(Tone.GOOD, 0.02 * ground, 0.98 * ground, -_APART * k) for k in range(5)])
        case EventKind.BALL_LOST:
            return tuple([Wave(Tone.BAD, 0.985 * ground, 0.9 * ground, -_APART * k) for k in range(2)])
    return ()


def _started(ticked: Ticked) -> tuple[Wave, ...]:
    """From the wall to the paddles: here we are, there you are."""
    rings = ticked.game.arena.rings
    wall = max([ring.outer_radius for ring in rings[PADDLES + 1 :]], default=0.0)
    return tuple([Wave(Tone.START, wall, rings[PADDLES].inner_radius, -_APART * k) for k in range(3)])
