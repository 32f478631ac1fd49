"""Circles about the arena's centre that run over the ground on great moments."""

from enum import Enum, auto
from typing import NamedTuple

from game.rules import PADDLES, Event, EventKind, Phase, Ticked

WAVE_TICKS = 150
_DELAY = 22
"""Ticks from one circle to the next."""
_CLEARED, _CLEARED_RADII = 5, (0.02, 0.98)
_LOST, _LOST_RADII = 2, (0.985, 0.9)
"""Circles on a cleared level and on a lost ball, and their first and last radii, in shares of the ground's."""
_STARTED = 3
"""Circles at the start of a level, from the wall to the paddles."""


class WaveTone(Enum):
    """What kind of news a circle is; it tells its colour."""

    START = auto()
    GOOD = auto()
    BAD = auto()


class Wave(NamedTuple):
    """One circle.

    tone: the kind of news.
    start, end: its radius when new and at last, world units.
    age: ticks; below 0 it has yet to begin.
    """

    tone: WaveTone
    start: float
    end: float
    age: int = 0

    @property
    def share(self) -> float:
        """Share of its path that the circle has run, 0 to 1: fast at first."""
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
        if event.kind != EventKind.BALL_LOST or not any([wave.tone is WaveTone.BAD for wave in waves]):  # no flashing
            waves = (*waves, *_waves(event, ticked))
    if ticked.game.tick == 1 and ticked.game.phase == Phase.SERVING:
        waves = _started(ticked)
    return waves


def _waves(event: Event, ticked: Ticked) -> tuple[Wave, ...]:
    """The circles of an event; most have none."""
    ground = ticked.game.level.ground_radius
    match event.kind:
        case EventKind.LEVEL_STARTED:
            return _started(ticked)
        case EventKind.LEVEL_CLEARED | EventKind.CORE_BROKEN:
            return _series(WaveTone.GOOD, _CLEARED, _CLEARED_RADII[0] * ground, _CLEARED_RADII[1] * ground)
        case EventKind.BALL_LOST:
            return _series(WaveTone.BAD, _LOST, _LOST_RADII[0] * ground, _LOST_RADII[1] * ground)
    return ()


def _started(ticked: Ticked) -> tuple[Wave, ...]:
    """The circles of a level's start, from the wall to the paddles: they show the player both."""
    rings = ticked.game.arena.rings
    track = rings[PADDLES].inner_radius
    wall = max([ring.outer_radius for ring in rings[PADDLES + 1 :] if ring.outer_radius < track], default=0.0)
    return _series(WaveTone.START, _STARTED, wall, track)


def _series(tone: WaveTone, count: int, start: float, end: float) -> tuple[Wave, ...]:
    """Circles that run the same path, one after the other. start, end: radii, world units."""
    return tuple([Wave(tone, start, end, -_DELAY * k) for k in range(count)])
