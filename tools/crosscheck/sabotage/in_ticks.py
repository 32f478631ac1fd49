"""Mistakes in what a tick leaves behind: put around `physics.advance`, whose arena the game goes on with."""

from collections.abc import Callable
from contextlib import AbstractContextManager

import physics
from physics import PERMANENT, Arena, Ball, Feature, Hit, Step
from tools.crosscheck.sabotage.replacing import replaced

_right = physics.advance
_DROPPED = 3
"""Every so many bounces, one is dropped."""
_JUMP = 1e-6
"""World units."""
_UNCHECKED = 3
"""Ticks that a ball flies unchecked after it was looked at."""

Change = Callable[[Arena, float, Step], Step]


def two_layers() -> AbstractContextManager[None]:
    """A hit takes two layers."""
    return _other_layers(lambda hit, left: hit._replace(layers=max(left - 1, 0)) if left > 0 else hit)


def lasting_bricks() -> AbstractContextManager[None]:
    """A hit takes no layer."""
    return _other_layers(lambda hit, left: hit._replace(layers=left + 1) if left >= 0 else hit)


def soft_walls() -> AbstractContextManager[None]:
    """An unbreakable sector breaks, unless it is a paddle."""
    return _other_layers(lambda hit, left: hit._replace(layers=0) if left == PERMANENT and hit.ring else hit)


def neighbours_brick() -> AbstractContextManager[None]:
    """The brick beside the one that was hit loses a layer."""

    def change(arena: Arena, _: float, step: Step) -> Step:
        layers = [list(ring) for ring in arena.layers]
        hits = []
        for hit in step.hits:
            ring = layers[hit.ring]
            slot = (hit.slot + 1) % len(ring)
            ring[slot] -= ring[slot] > 0
            hits.append(hit._replace(slot=slot, layers=ring[slot]))
        return _with(step, hits=tuple(hits), layers=layers)

    return _changed(change)


def quiet_break() -> AbstractContextManager[None]:
    """A brick breaks, and the hit says that a layer is left."""

    def change(_: Arena, __: float, step: Step) -> Step:
        hits = tuple([hit._replace(layers=1) if hit.layers == 0 else hit for hit in step.hits])
        return step._replace(hits=hits)

    return _changed(change)


def dropped_bounce() -> AbstractContextManager[None]:
    """Every third bounce does not happen: the ball flies on."""
    bounces = [0]

    def change(arena: Arena, dt: float, step: Step) -> Step:
        bounces[0] += len(step.hits)
        if len(step.hits) != 1 or bounces[0] % _DROPPED:
            return step
        return _unbounced(arena, dt, step)

    return _changed(change)


def long_clear_time() -> AbstractContextManager[None]:
    """A ball that touches nothing in a tick is not looked at for the next three."""
    unchecked = [0]

    def change(arena: Arena, dt: float, step: Step) -> Step:
        unchecked[0] = _UNCHECKED if unchecked[0] == 0 else unchecked[0] - 1
        return _unbounced(arena, dt, step) if step.hits and unchecked[0] else step

    return _changed(change)


def jump_at_ends() -> AbstractContextManager[None]:
    """A ball that hits an end is put a millionth of a unit away from it, and counted as freed."""

    def change(_: Arena, __: float, step: Step) -> Step:
        balls = list(step.arena.balls)
        freed = 0
        for hit in step.hits:
            if hit.contact.feature == Feature.END:
                ball = balls[hit.ball]
                balls[hit.ball] = Ball(ball.position + hit.contact.normal * _JUMP, ball.velocity, ball.radius)
                freed += 1
        if not freed:
            return step
        return step._replace(arena=step.arena._replace(balls=tuple(balls)), freed=step.freed + freed)

    return _changed(change)


def silent_jump() -> AbstractContextManager[None]:
    """A ball that was hit ends its tick a thousand-millionth of a unit off."""

    def change(_: Arena, __: float, step: Step) -> Step:
        balls = list(step.arena.balls)
        for index in {hit.ball for hit in step.hits}:
            ball = balls[index]
            balls[index] = Ball(ball.position + 1e-9, ball.velocity, ball.radius)
        return step._replace(arena=step.arena._replace(balls=tuple(balls))) if step.hits else step

    return _changed(change)


def rest_after_a_hit() -> AbstractContextManager[None]:
    """A ball rests for what is left of the tick after a hit, and is counted as dropped."""

    def change(_: Arena, dt: float, step: Step) -> Step:
        balls = list(step.arena.balls)
        last = {hit.ball: hit for hit in step.hits}
        for index, hit in last.items():
            ball = balls[index]
            balls[index] = Ball(ball.position - ball.velocity * (dt - hit.time), ball.velocity, ball.radius)
        dropped = step.dropped + len(last)
        return step._replace(arena=step.arena._replace(balls=tuple(balls)), dropped=dropped) if last else step

    return _changed(change)


def unrecorded_hit() -> AbstractContextManager[None]:
    """A ball bounces off a paddle or a wall, and no hit says so."""

    def change(_: Arena, __: float, step: Step) -> Step:
        return step._replace(hits=tuple([hit for hit in step.hits if hit.layers != PERMANENT]))

    return _changed(change)


def doubled_hit() -> AbstractContextManager[None]:
    """Every hit is reported twice."""

    def change(_: Arena, __: float, step: Step) -> Step:
        return step._replace(hits=tuple([hit for hit in step.hits for _ in range(2)]))

    return _changed(change)


def _changed(change: Change) -> AbstractContextManager[None]:
    """The tick with its result changed."""

    def advance(arena: Arena, dt: float, speed: float, *_: object) -> Step:
        step = _right(arena, dt, speed)
        return change(arena, dt, step) if arena.balls else step

    return replaced(_right, advance)


def _other_layers(change: Callable[[Hit, int], Hit]) -> AbstractContextManager[None]:
    """The tick with other layers left by its hits; the change gets a hit and the layers that it rightly leaves."""

    def changed(_: Arena, __: float, step: Step) -> Step:
        layers = [list(ring) for ring in step.arena.layers]
        hits = []
        for hit in step.hits:
            other = change(hit, hit.layers)
            layers[hit.ring][hit.slot] = other.layers
            hits.append(other)
        return _with(step, hits=tuple(hits), layers=layers)

    return _changed(changed)


def _with(step: Step, hits: tuple[Hit, ...], layers: list[list[int]]) -> Step:
    """The tick with other hits and layers; itself where it has no hits."""
    if not hits:
        return step
    return step._replace(hits=hits, arena=step.arena._replace(layers=tuple([tuple(ring) for ring in layers])))


def _unbounced(arena: Arena, dt: float, step: Step) -> Step:
    """The tick as if nothing had been touched."""
    moved = tuple([ball.moved(dt) for ball in arena.balls])
    return step._replace(arena=step.arena._replace(balls=moved, layers=arena.layers), hits=())
