"""What a hit leaves to be seen for a moment. A picture only: nothing here reaches the rules.

Values that follow the game tick by tick, so that they stand still in a pause and look the same in a replay. Every kind has
a file of its own; all of them are fed by the rules' events.
"""

from collections.abc import Iterable
from typing import NamedTuple

from game.effects import bursts, entry, falling, flashes, lights, pops, recoils, shakes, streaks, trails, waves
from game.effects.bursts import Burst
from game.effects.falling import FallingStack
from game.effects.flashes import FLASH_TICKS, Flash
from game.effects.kinds import ALL, MOVING, PLAIN, EffectKind, Shown
from game.effects.lights import Light, LightSource
from game.effects.pops import POP_TICKS, Pop
from game.effects.recoils import Recoil
from game.effects.shakes import Shake
from game.effects.streaks import NO_STREAK, Streak
from game.effects.trails import Trail
from game.effects.waves import Wave
from game.rules import EventKind, Ticked

__all__ = [
    "ALL",
    "FLASH_TICKS",
    "LONGEST",
    "MOVING",
    "NOTHING",
    "PLAIN",
    "POP_TICKS",
    "Burst",
    "EffectKind",
    "Effects",
    "FallingStack",
    "Flash",
    "Light",
    "LightSource",
    "Pop",
    "Recoil",
    "Shake",
    "Shown",
    "Streak",
    "Trail",
    "Wave",
    "after",
    "after_all",
    "at_start",
]

LONGEST = 240
"""Ticks after which nothing of an event is left to be seen, but for a streak of bricks that goes on."""


class Effects(NamedTuple):
    """All effects at a moment.

    trails: one for each ball, see `trails`.
    flashes, pops, falling, bursts, recoils, waves: those that have not faded, from old to new.
    shake: of the whole picture; None while it rests.
    streak: the bricks in a row.
    lights: those that have not faded.
    entry: ticks since the wall began to be built; None once it stands.
    steady: of what goes on without an event, swirls and the light of balls, what the player wants.
    """

    trails: tuple[Trail, ...] = ()
    flashes: tuple[Flash, ...] = ()
    pops: tuple[Pop, ...] = ()
    falling: tuple[FallingStack, ...] = ()
    bursts: tuple[Burst, ...] = ()
    recoils: tuple[Recoil, ...] = ()
    waves: tuple[Wave, ...] = ()
    shake: Shake | None = None
    streak: Streak = NO_STREAK
    lights: tuple[Light, ...] = ()
    entry: int | None = None
    steady: Shown = frozenset()


NOTHING = Effects()
_STEADY: Shown = frozenset({EffectKind.SWIRL, EffectKind.LIGHTS})


def at_start(shown: Shown) -> Effects:
    """The effects before a game's first tick. If the wall is to be built up, none of it is visible. shown: as in `after`."""
    return Effects(entry=0 if EffectKind.ENTRY in shown else None, steady=shown & _STEADY)


def after(effects: Effects, ticked: Ticked, shown: Shown = ALL) -> Effects:
    """The effects one tick later. shown: those that the player wants to see."""
    if any([event.kind == EventKind.LEVEL_STARTED for event in ticked.events]):
        effects = Effects()
    return Effects(
        trails.after_tick(effects.trails, ticked) if EffectKind.TRAIL in shown else (),
        flashes.after_tick(effects.flashes, ticked, shown),
        pops.after_tick(effects.pops, ticked) if EffectKind.POINTS in shown else (),
        falling.after_tick(effects.falling, ticked) if EffectKind.FALLING in shown else (),
        bursts.after_tick(effects.bursts, ticked, shown),
        recoils.after_tick(effects.recoils, ticked) if EffectKind.RECOIL in shown else (),
        waves.after_tick(effects.waves, ticked) if EffectKind.WAVES in shown else (),
        shakes.after_tick(effects.shake, ticked) if EffectKind.SHAKE in shown else None,
        streaks.after_tick(effects.streak, ticked) if EffectKind.COMBO in shown else NO_STREAK,
        lights.after_tick(effects.lights, ticked) if EffectKind.LIGHTS in shown else (),
        entry.after_tick(effects.entry, ticked) if EffectKind.ENTRY in shown else None,
        shown & _STEADY,
    )


def after_all(passed: Iterable[Ticked], shown: Shown = ALL) -> Effects:
    """The effects after some ticks in a row, nothing being seen before the first."""
    effects = Effects()
    for ticked in passed:
        effects = after(effects, ticked, shown)
    return effects
