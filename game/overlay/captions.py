"""Captions: words for the sounds that matter, and from where on the screen they come. `game.picture.captions` shows them."""

import math
from collections.abc import Iterable
from typing import NamedTuple

from game.drawing.camera import Camera
from game.language import tr, tr_noop
from game.rules import Event, EventKind, Ticked

SECONDS = 2.2
"""For which a caption is shown."""
_MOST = 3
"""Captions at a time."""
_WORDS = {
    EventKind.SERVED: tr_noop("ball served"),
    EventKind.BRICK_HIT: tr_noop("brick struck"),
    EventKind.WALL_HIT: tr_noop("steel struck"),
    EventKind.BALL_LOST: tr_noop("ball lost"),
    EventKind.LEVEL_CLEARED: tr_noop("level cleared"),
    EventKind.GAME_WON: tr_noop("game won"),
    EventKind.GAME_OVER: tr_noop("game over"),
    EventKind.DROP_RELEASED: tr_noop("power-up on its way"),
    EventKind.DROP_CAUGHT: tr_noop("power-up caught"),
    EventKind.DROP_LOST: tr_noop("power-up missed"),
    EventKind.POWER_ENDED: tr_noop("power-up ended"),
    EventKind.LIFE_GAINED: tr_noop("extra life"),
    EventKind.BALL_CAUGHT: tr_noop("ball sticks to the paddle"),
    EventKind.SPEED_UP: tr_noop("balls faster"),
    EventKind.SHIELD_HIT: tr_noop("shield used up"),
    EventKind.BUMPER_HIT: tr_noop("bumper struck"),
    EventKind.BRICK_CRUMBLED: tr_noop("brick crumbled"),
    EventKind.BRICK_REGROWN: tr_noop("brick grew back"),
    EventKind.CORE_BROKEN: tr_noop("core broken"),
}
"""What sounds say, but for those that say only what is seen where one looks: paddles' hits, nudges, balls that meet."""
_ON_ITS_POSITION = frozenset(
    {
        EventKind.BALL_LOST,
        EventKind.DROP_RELEASED,
        EventKind.BRICK_CRUMBLED,
        EventKind.BRICK_REGROWN,
    }
)
"""Events of which it helps to know where."""
_DIRECTIONS = (
    tr_noop("right"),
    tr_noop("upper right"),
    tr_noop("above"),
    tr_noop("upper left"),
    tr_noop("left"),
    tr_noop("lower left"),
    tr_noop("below"),
    tr_noop("lower right"),
)
_RARE = frozenset(
    {
        EventKind.GAME_OVER,
        EventKind.DROP_CAUGHT,
        EventKind.POWER_ENDED,
        EventKind.LIFE_GAINED,
        EventKind.BALL_CAUGHT,
        EventKind.SHIELD_HIT,
        EventKind.CORE_BROKEN,
    }
)
"""Events that come once in many seconds; lost balls and finished levels are said in whole sentences."""


class Caption(NamedTuple):
    """A sound in words.

    kind: of its event. direction: index in _DIRECTIONS; None where that does not matter. times: how often it came in a row.
    left: seconds for which it is still shown.
    """

    kind: EventKind
    direction: int | None
    times: int = 1
    left: float = SECONDS

    @property
    def text(self) -> str:
        """In the player's language."""
        words = tr(_WORDS[self.kind])
        if self.direction is not None:
            words = tr("{sound}, {direction}").format(sound=words, direction=tr(_DIRECTIONS[self.direction]))
        return words if self.times == 1 else tr("{sound} ×{count}").format(sound=words, count=self.times)


def after(captions: tuple[Caption, ...], ticked: Ticked, camera: Camera) -> tuple[Caption, ...]:
    """The captions after a tick, the newest last; the same sound once more counts on."""
    for event in ticked.events:
        if event.kind in _WORDS:
            captions = _with(captions, event, camera)
    return captions


def rare(events: Iterable[Event]) -> list[str]:
    """Words for those events of a tick that come so seldom that a screen reader may say them all."""
    return [Caption(event.kind, None).text for event in events if event.kind in _RARE]


def later(captions: tuple[Caption, ...], seconds: float) -> tuple[Caption, ...]:
    """Those that are still shown some time later."""
    aged = [caption._replace(left=caption.left - max(seconds, 0.0)) for caption in captions]
    return tuple([caption for caption in aged if caption.left > 0.0])


def _with(captions: tuple[Caption, ...], event: Event, camera: Camera) -> tuple[Caption, ...]:
    """The captions with that of an event."""
    direction = _direction(event.position, camera) if event.kind in _ON_ITS_POSITION else None
    same = [one for one in captions if one[:2] == (event.kind, direction)]
    others = [one for one in captions if one not in same]
    times = same[0].times + 1 if same else 1
    return (*others, Caption(event.kind, direction, times))[-_MOST:]


def _direction(position: complex, camera: Camera) -> int:
    """Where on the screen a position is from the arena's centre, as an index in _DIRECTIONS."""
    offset = (camera.project(position) - camera.centre).conjugate()
    return round(math.atan2(offset.imag, offset.real) / (math.tau / len(_DIRECTIONS))) % len(_DIRECTIONS)
