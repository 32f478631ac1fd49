"""What a hit leaves to be seen for a moment. A picture only: nothing here reaches the rules.

Values that follow the game tick by tick, so that they stand still in a pause and look the same in a replay. Every kind has
a file of its own; all of them are fed by the rules' events.
"""

from collections.abc import Iterable
from typing import NamedTuple

from game.effects import bursts, flashes, pops, recoils, shakes, streaks, trails, waves
from game.effects import drops as falling
from game.effects.bursts import Burst
from game.effects.drops import Drop
from game.effects.flashes import FLASH_TICKS, Flash
from game.effects.kinds import ALL, MOVING, PLAIN, Kind, Shown
from game.effects.pops import POP_TICKS, Pop
from game.effects.recoils import Recoil
from game.effects.shakes import Shake
from game.effects.streaks import NO_ROW, Streak
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
    "Drop",
    "Effects",
    "Flash",
    "Kind",
    "Pop",
    "Recoil",
    "Shake",
    "Shown",
    "Streak",
    "Trail",
    "Wave",
    "after",
    "after_all",
]

LONGEST = 240
"""Ticks after which nothing of a moment is left to be seen, but for a row of bricks that goes on."""


class Effects(NamedTuple):
    """All that is fading."""

    trails: tuple[Trail, ...] = ()
    flashes: tuple[Flash, ...] = ()
    pops: tuple[Pop, ...] = ()
    drops: tuple[Drop, ...] = ()
    bursts: tuple[Burst, ...] = ()
    recoils: tuple[Recoil, ...] = ()
    waves: tuple[Wave, ...] = ()
    shake: Shake | None = None
    streak: Streak = NO_ROW


NOTHING = Effects()


def after(effects: Effects, ticked: Ticked, shown: Shown = ALL) -> Effects:
    """The effects one tick later. shown: those that the player wants to see."""
    if any([event.kind == EventKind.LEVEL_STARTED for event in ticked.events]):
        effects = Effects()
    return Effects(
        trails.after_tick(effects.trails, ticked) if Kind.TRAIL in shown else (),
        flashes.after_tick(effects.flashes, ticked, shown),
        pops.after_tick(effects.pops, ticked) if Kind.POINTS in shown else (),
        _drops(effects.drops, ticked) if Kind.FALLING in shown else (),
        bursts.after_tick(effects.bursts, ticked, shown),
        recoils.after_tick(effects.recoils, ticked) if Kind.RECOIL in shown else (),
        waves.after_tick(effects.waves, ticked) if Kind.WAVES in shown else (),
        shakes.after_tick(effects.shake, ticked) if Kind.SHAKE in shown else None,
        streaks.after_tick(effects.streak, ticked) if Kind.COMBO in shown else NO_ROW,
    )


def after_all(passed: Iterable[Ticked], shown: Shown = ALL) -> Effects:
    """The effects after some ticks in a row, nothing being seen before the first."""
    effects = Effects()
    for ticked in passed:
        effects = after(effects, ticked, shown)
    return effects


def _drops(drops: tuple[Drop, ...], ticked: Ticked) -> tuple[Drop, ...]:
    """The stacks that are still falling a tick later."""
    drops = falling.after_tick(drops)
    for event in ticked.events:
        if event.kind == EventKind.BRICK_HIT and event.hit is not None:
            drops = falling.after_hit(drops, event.hit.ring, event.hit.slot, event.hit.layers)
    return drops
