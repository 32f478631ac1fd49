"""What a hit leaves to be seen for a moment: trails, flashes and points. A picture only: nothing here reaches the rules.

A value that follows the game tick by tick, so that it stands still in a pause and looks the same in a replay.
"""

from typing import NamedTuple

from game.falling import Drop, after_hit, after_tick
from game.rules import Event, EventKind, Phase, Ticked

FLASH_TICKS = 40
POP_TICKS = 190
_TRAIL_LENGTH = 16
_TRAIL_EVERY = 3
"""Ticks from one point of a trail to the next."""

_WORDS = {EventKind.NUDGED: "nudged", EventKind.BALL_LOST: "lost"}


class Flash(NamedTuple):
    """A sector that was just hit."""

    ring: int
    slot: int
    layers: int  # left after the hit
    age: float  # 0 new to 1 gone


class Pop(NamedTuple):
    """A few words where something happened."""

    position: complex
    text: str
    bad: bool  # news
    age: float  # 0 new to 1 gone


class Effects(NamedTuple):
    """All that is fading."""

    trails: tuple[tuple[complex, ...], ...] = ()
    flashes: tuple[Flash, ...] = ()
    pops: tuple[Pop, ...] = ()
    drops: tuple[Drop, ...] = ()


def after(effects: Effects, ticked: Ticked, *, full: bool = True) -> Effects:
    """The effects one tick later. full: False leaves the trail alone to show, for players who want nothing to flash."""
    trails = _trails(effects.trails, ticked)
    if not full:
        return Effects(trails)
    flashes, pops, drops = effects.flashes, effects.pops, after_tick(effects.drops)
    if flashes:
        older = [flash._replace(age=flash.age + 1.0 / FLASH_TICKS) for flash in flashes]
        flashes = tuple([flash for flash in older if flash.age < 1.0])
    if pops:
        risen = [pop._replace(age=pop.age + 1.0 / POP_TICKS) for pop in pops]
        pops = tuple([pop for pop in risen if pop.age < 1.0])
    for event in ticked.events:
        if event.kind == EventKind.LEVEL_STARTED:
            return Effects()
        if event.hit is not None:
            flashes = (*flashes, Flash(event.hit.ring, event.hit.slot, event.hit.layers, 0.0))
            if event.kind == EventKind.BRICK_HIT:
                drops = after_hit(drops, event.hit.ring, event.hit.slot, event.hit.layers)
        if text := _pop_text(event):
            pops = (*pops, Pop(event.position, text, event.kind == EventKind.BALL_LOST, 0.0))
    return Effects(trails, flashes, pops, drops)


def _pop_text(event: Event) -> str:
    """The words for an event; none for most."""
    if event.kind == EventKind.BRICK_HIT:
        return f"+{event.points}"
    if event.kind == EventKind.LEVEL_CLEARED:
        return f"+{event.points} for the lives left"
    return _WORDS.get(event.kind, "")


def _trails(trails: tuple[tuple[complex, ...], ...], ticked: Ticked) -> tuple[tuple[complex, ...], ...]:
    """A line of recent places behind each ball in play; it starts anew when the number of balls changes."""
    game = ticked.game
    if game.phase != Phase.PLAYING:
        return ()
    balls = game.arena.balls
    if len(trails) != len(balls):
        return tuple([(ball.position,) for ball in balls])
    if game.tick % _TRAIL_EVERY and not ticked.step.hits:
        return trails
    return tuple([(*trail[1 - _TRAIL_LENGTH :], ball.position) for trail, ball in zip(trails, balls, strict=True)])
