"""Which sounds an event makes, how loud and where, and how many go together before it is too much. No mixer.

Values in, fresh values out: the mixer is told what was decided here. Nothing of it reaches the rules.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from game.rules import HARMFUL, Event, EventKind
from game.sound.notes import Note, brick
from game.sound.patches import Patch
from physics import Hit, dot, length

VOICES = 12
"""Sounds at once, at most."""
TAIL_STEP = 0.01
"""Seconds from one entry of a tail to the next."""

_PATCHES: dict[EventKind, Patch | None] = {
    EventKind.SERVED: Patch.SERVE,
    EventKind.PADDLE_HIT: Patch.PADDLE,
    EventKind.WALL_HIT: Patch.WALL,
    EventKind.NUDGED: Patch.NUDGE,
    EventKind.BALL_LOST: Patch.LOST,
    EventKind.LEVEL_CLEARED: Patch.CLEARED,
    EventKind.GAME_WON: Patch.WON,
    EventKind.GAME_OVER: Patch.OVER,
    EventKind.DROP_RELEASED: Patch.DROP,
    EventKind.DROP_CAUGHT: Patch.GIFT,
    EventKind.DROP_LOST: None,  # nothing happens
    EventKind.POWER_ENDED: Patch.POWER_OFF,
    EventKind.LIFE_GAINED: Patch.LIFE,
    EventKind.BALLS_MET: Patch.BALLS,
    EventKind.BALL_CAUGHT: Patch.CATCH,
    EventKind.BALL_RELEASED: Patch.RELEASE,
    EventKind.SPEED_UP: Patch.FASTER,
    EventKind.SHIELD_HIT: Patch.SHIELD,
    EventKind.BUMPER_HIT: Patch.BUMPER,
    EventKind.BRICK_REGROWN: Patch.REGROWN,
    EventKind.BRICK_CRUMBLED: Patch.CRUMBLED,
    EventKind.CORE_BROKEN: Patch.CORE,
    EventKind.AIMED: None,  # the paddle is heard
    EventKind.LEVEL_STARTED: None,  # the jingle of the level before has only just ended
}
"""What events sound like, but for bricks, whose sound depends on more."""
_REPLACED = {EventKind.GAME_WON: EventKind.LEVEL_CLEARED, EventKind.GAME_OVER: EventKind.BALL_LOST}
"""Where both happen at once, the first is heard and the second is not."""
_HITS = frozenset(
    {
        Patch.PADDLE,
        Patch.BRICK,
        Patch.WALL,
        Patch.NUDGE,
        Patch.BALLS,
        Patch.CATCH,
        Patch.RELEASE,
        Patch.BUMPER,
        Patch.REGROWN,
        Patch.CRUMBLED,
    }
)
"""Sounds that are many and small; all others are news, and hits leave room for them."""
_VOICES_FOR_HITS, _SCALE_FOR_HITS = 9, 0.8
"""Voices that hits may take, and share of full scale that they leave nothing above."""
_WIDTH = 0.8
"""How far to the side the rim is heard: at 1 the other ear would hear nothing."""
_SOFTEST = 0.5
"""Loudness of a hit that only grazes."""
_GAP = 0.05
"""Seconds before the same note is struck again: a ball that scrapes along a wall rattles, it does not buzz."""
_LAG = 0.03
"""Seconds that the mixer may be behind: two of its blocks."""
_LEAST = 0.3
"""A sound that there is room for only at this share of its loudness is left out."""


class Cue(NamedTuple):
    """A sound to be made.

    note: which one.
    gain: how loud, 0 to 1.
    side: where it is heard, -1 at the rim's left to 1 at its right.
    """

    note: Note
    gain: float
    side: float


class Voice(NamedTuple):
    """A sound being made.

    note: which one.
    start: since when, seconds.
    left, right: how loud in each ear, 0 to 1.
    """

    note: Note
    start: float
    left: float
    right: float


class Chorus(NamedTuple):
    """All that sounds after some cues.

    voices: per channel of the mixer, of which there are VOICES; None where it is free.
    new: channels whose voice has to be started.
    """

    voices: tuple[Voice | None, ...]
    new: tuple[int, ...]


Panning = Callable[[complex], float]
"""From a position in the world to where it is heard: -1 at the rim's left on the screen to 1 at its right."""

Tail = Sequence[float]
"""The largest amplitude that is still to come of a sound, every TAIL_STEP seconds."""

SILENCE: tuple[Voice | None, ...] = (None,) * VOICES


def cues(events: Sequence[Event], side: Panning, combo: int) -> list[Cue]:
    """The sounds of some events, in their order.

    side: where on the screen they are heard. combo: the game's, after the last of the events.
    """
    replaced = {_REPLACED.get(event.kind) for event in events}
    found: list[Cue] = []
    for event in reversed(events):
        note = _note(event, combo)
        if note is not None and event.kind not in replaced:
            found.append(Cue(note, _strength(event.hit), _limited(side(event.position))))
        combo = _combo_before(event, combo)
    return found[::-1]


def panned(side: float) -> tuple[float, float]:
    """Gains of the left and the right ear; the sum of their squares is 1. side: -1 left to 1 right."""
    angle = (1.0 + _WIDTH * min(max(side, -1.0), 1.0)) * (math.pi / 4.0)
    return math.cos(angle), math.sin(angle)


def chorus(voices: tuple[Voice | None, ...], wanted: Sequence[Cue], tails: Mapping[Note, Tail], now: float) -> Chorus:
    """The voices at a time `now` in seconds, with those of the cues that find room.

    News goes first. No ear is ever sent more than full scale: how loud the voices can still become is known from their tails,
    and a new voice gets what room they leave, or is left out where that is too little.
    """
    sounding = [voice if voice is not None and _to_come(voice, tails, now) > 0.0 else None for voice in voices]
    new: list[int] = []
    for cue in sorted(wanted, key=_is_hit):
        voice = _fitting(cue, sounding, tails, now)
        if voice is not None:
            channel = sounding.index(None)
            sounding[channel] = voice
            new.append(channel)
    return Chorus(tuple(sounding), tuple(new))


def _note(event: Event, combo: int) -> Note | None:
    """What an event sounds like; None if it makes no sound. combo: the game's, after it."""
    if event.kind == EventKind.BRICK_HIT:
        return brick(combo, 0 if event.hit is None else event.hit.layers)
    if event.power in HARMFUL and event.kind == EventKind.DROP_CAUGHT:
        return Note(Patch.TRAP)
    patch = _PATCHES[event.kind]
    return None if patch is None else Note(patch)


def _combo_before(event: Event, combo: int) -> int:
    """The combo before an event, given the one after it. After a paddle's hit it cannot be told; 0 is good enough."""
    return combo - 1 if event.kind == EventKind.BRICK_HIT and combo > 0 else combo


def _strength(hit: Hit | None) -> float:
    """How loud a hit is: _SOFTEST for a graze to 1 straight on, and 1 for what is no hit."""
    if hit is None:
        return 1.0
    squarely = abs(dot(hit.before, hit.contact.normal)) / max(length(hit.before), 1e-9)
    return _SOFTEST + (1.0 - _SOFTEST) * min(squarely, 1.0)


def _limited(side: float) -> float:
    """The nearest number from -1 to 1."""
    return min(max(side, -1.0), 1.0)


def _is_hit(cue: Cue) -> bool:
    """Whether a cue is one of the many small sounds."""
    return cue.note.patch in _HITS


def _to_come(voice: Voice, tails: Mapping[Note, Tail], now: float) -> float:
    """The largest amplitude that is still to come of a voice in either ear."""
    levels = tails[voice.note]
    passed = max(int((now - voice.start - _LAG) / TAIL_STEP), 0)
    return float(levels[min(passed, len(levels) - 1)]) * max(voice.left, voice.right)


def _fitting(cue: Cue, sounding: Sequence[Voice | None], tails: Mapping[Note, Tail], now: float) -> Voice | None:
    """The cue as a voice, softer if there is little room; None if there is too little, or the note has only just begun."""
    busy = [voice for voice in sounding if voice is not None]
    if any([voice.note == cue.note and now - voice.start < _GAP for voice in busy]):
        return None
    most, scale = (_VOICES_FOR_HITS, _SCALE_FOR_HITS) if _is_hit(cue) else (VOICES, 1.0)
    if len(busy) >= most:
        return None
    left, right = panned(cue.side)
    peak = float(tails[cue.note][0]) * cue.gain * max(left, right)
    room = scale - sum([_to_come(voice, tails, now) for voice in busy])
    share = min(room / peak, 1.0)
    return Voice(cue.note, now, cue.gain * share * left, cue.gain * share * right) if share > _LEAST else None
