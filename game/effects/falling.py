"""How the rest of a stack comes down after a hit took its lowest layer. A picture only: the rules have moved on at once.

Heights count layers. What is left of a stack falls as one piece; it bounces once or more, and then it is at rest.
"""

from typing import NamedTuple

from game.rules import TICK, EventKind, Ticked

GRAVITY = 26.0
"""Layers per second, per second."""
BOUNCE = 0.3
"""Share of its speed that a landing stack keeps."""
_REST = 0.9
"""Layers per second; a stack that lands more slowly stays."""


class FallingStack(NamedTuple):
    """A stack that is still above its slot.

    ring, slot: where.
    height: layers above where it will rest, >= 0.
    speed: layers per second, upwards.
    """

    ring: int
    slot: int
    height: float
    speed: float


def after_tick(falling: tuple[FallingStack, ...], ticked: Ticked) -> tuple[FallingStack, ...]:
    """The falling stacks a tick later, with those whose lowest layer has just gone."""
    falling = fallen(falling)
    for event in ticked.events:
        if event.kind == EventKind.BRICK_HIT and event.hit is not None:
            falling = after_hit(falling, event.hit.ring, event.hit.slot, event.hit.layers)
        elif event.kind == EventKind.BRICK_CRUMBLED and event.sector is not None:
            ring, slot = event.sector
            falling = after_hit(falling, ring, slot, ticked.game.arena.layers[ring][slot])
    return falling


def after_hit(falling: tuple[FallingStack, ...], ring: int, slot: int, layers: int) -> tuple[FallingStack, ...]:
    """The falling stacks after a slot lost its lowest layer. layers: left; with none left nothing falls."""
    others = tuple([stack for stack in falling if (stack.ring, stack.slot) != (ring, slot)])
    if layers <= 0:
        return others
    before = next((stack for stack in falling if (stack.ring, stack.slot) == (ring, slot)), FallingStack(ring, slot, 0.0, 0.0))
    return (*others, before._replace(height=before.height + 1.0))


def fallen(falling: tuple[FallingStack, ...]) -> tuple[FallingStack, ...]:
    """The falling stacks a tick later; those that came to rest are gone."""
    moved = [_moved(stack) for stack in falling]
    return tuple([stack for stack in moved if stack.height > 0.0 or stack.speed > 0.0])


def _moved(stack: FallingStack) -> FallingStack:
    """One stack a tick later; where it would sink into the ground it lands, and bounces or rests."""
    speed = stack.speed - GRAVITY * TICK
    height = stack.height + speed * TICK
    if height > 0.0:
        return stack._replace(height=height, speed=speed)
    speed = -BOUNCE * speed
    return stack._replace(height=0.0, speed=speed if speed > _REST else 0.0)
