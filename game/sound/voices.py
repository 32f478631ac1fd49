"""Which sounds an event makes, how loud and where, and how many go together before it is too much. No mixer.

Values in, fresh values out: the mixer is told what was decided here. Nothing of it reaches the rules.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.rules import Event, EventKind
from game.sound.synth import Note, Patch, Wave, brick
from physics import Hit, dot, length

VOICES = 12
"""Sounds at once, at most."""
SILENT = frozenset({EventKind.LEVEL_STARTED})
"""Events that make no sound: the cleared level's jingle has only just ended."""
TAIL_STEP = 0.01
"""Seconds from one entry of a tail to the next."""

_PATCHES = {
    EventKind.SERVED: Patch.SERVE,
    EventKind.PADDLE_HIT: Patch.PADDLE,
    EventKind.WALL_HIT: Patch.WALL,
    EventKind.NUDGED: Patch.NUDGE,
    EventKind.BALL_LOST: Patch.LOST,
    EventKind.LEVEL_CLEARED: Patch.CLEARED,
    EventKind.GAME_WON: Patch.WON,
    EventKind.GAME_OVER: Patch.OVER,
}
_SPOKEN_FOR = {EventKind.GAME_WON: EventKind.LEVEL_CLEARED, EventKind.GAME_OVER: EventKind.BALL_LOST}
"""The greater news is told alone."""
_HITS = frozenset({Patch.PADDLE, Patch.BRICK, Patch.WALL, Patch.NUDGE})
"""Many and small: they leave room for the others, which are news."""
_VOICES_FOR_HITS = 9
_SCALE_FOR_HITS = 0.8
_WIDTH = 0.8
"""How far to the side the rim is heard: at 1 the other ear would hear nothing."""
_SOFTEST = 0.5
"""Loudness of a hit that only grazes."""
_GAP = 0.05
"""Seconds before the same note is struck again: a ball that scrapes along a wall rattles, it does not buzz."""
_LAG = 0.03
"""Seconds that the mixer may be behind: two of its blocks."""
_LEAST = 0.3
"""A sound that fits in only this much softer is left out."""


class Cue(NamedTuple):
    """A sound to be made."""

    note: Note
    gain: float  # 0 to 1
    side: float  # -1 left to 1 right, at the rim


class Voice(NamedTuple):
    """A sound being made."""

    note: Note
    start: float  # seconds
    left: float  # gain, 0 to 1
    right: float


class Chorus(NamedTuple):
    """All that sounds after some cues, and which of it is new."""

    voices: tuple[Voice | None, ...]  # VOICES of them
    new: tuple[int, ...]  # places in `voices`


Side = Callable[[complex], float]
"""Where on the screen a place of the world is heard: -1 at the rim's left to 1 at its right."""

Tail = NDArray[np.float64]
"""The loudest that is still to come of a sound, every TAIL_STEP seconds."""

SILENCE: tuple[Voice | None, ...] = (None,) * VOICES


def cues(events: Sequence[Event], side: Side, combo: int) -> list[Cue]:
    """The sounds of some events, in their order.

    side: where on the screen a place of the world is. combo: the game's, after the last of the events.
    """
    told = {_SPOKEN_FOR.get(event.kind) for event in events}
    found: list[Cue] = []
    for event in reversed(events):
        note = _note(event, combo)
        if note is not None and event.kind not in told:
            found.append(Cue(note, _strength(event.hit), _limited(side(event.position))))
        combo = _combo_before(event, combo)
    return found[::-1]


def panned(side: float) -> tuple[float, float]:
    """Gains of the left and the right ear; the sum of their squares is 1. side: -1 left to 1 right."""
    angle = (1.0 + _WIDTH * min(max(side, -1.0), 1.0)) * (math.pi / 4.0)
    return math.cos(angle), math.sin(angle)


def tail(wave: Wave, rate: int) -> Tail:
    """The loudest that is still to come, every TAIL_STEP seconds, and a last 0."""
    starts = np.arange(0, len(wave), max(round(TAIL_STEP * rate), 1))
    loudest = np.maximum.reduceat(np.abs(wave), starts)
    return np.append(np.maximum.accumulate(loudest[::-1])[::-1], 0.0)


def chorus(voices: tuple[Voice | None, ...], wanted: Sequence[Cue], tails: Mapping[Note, Tail], now: float) -> Chorus:
    """The voices at a time `now` in seconds, with those of the cues that find room.

    News goes first. No ear is ever sent more than full scale: what is still to come of all voices is known, and a new
    one gets what is left, or is left out where that would be next to nothing.
    """
    sounding = [voice if voice is not None and _to_come(voice, tails, now) > 0.0 else None for voice in voices]
    new: list[int] = []
    for cue in sorted(wanted, key=_is_hit):
        voice = _fitting(cue, sounding, tails, now)
        if voice is not None:
            place = sounding.index(None)
            sounding[place] = voice
            new.append(place)
    return Chorus(tuple(sounding), tuple(new))


def _note(event: Event, combo: int) -> Note | None:
    """What an event sounds like; None where nothing. combo: after it."""
    if event.kind == EventKind.BRICK_HIT:
        return brick(combo, 0 if event.hit is None else event.hit.layers)
    patch = _PATCHES.get(event.kind)
    return None if patch is None else Note(patch)


def _combo_before(event: Event, combo: int) -> int:
    """The combo before an event, given the one after it; what a paddle ended is not known, and 0 will do."""
    return combo - 1 if event.kind == EventKind.BRICK_HIT and combo > 0 else combo


def _strength(hit: Hit | None) -> float:
    """How hard a hit is, from a graze to straight on: 0.5 to 1."""
    if hit is None:
        return 1.0
    squarely = abs(dot(hit.before, hit.contact.normal)) / max(length(hit.before), 1e-9)
    return _SOFTEST + (1.0 - _SOFTEST) * min(squarely, 1.0)


def _limited(side: float) -> float:
    """From -1 to 1."""
    return min(max(side, -1.0), 1.0)


def _is_hit(cue: Cue) -> bool:
    """Whether it is one of the many small sounds."""
    return cue.note.patch in _HITS


def _to_come(voice: Voice, tails: Mapping[Note, Tail], now: float) -> float:
    """The loudest that is still to come of a voice in either ear."""
    levels = tails[voice.note]
    passed = max(int((now - voice.start - _LAG) / TAIL_STEP), 0)
    return float(levels[min(passed, len(levels) - 1)]) * max(voice.left, voice.right)


def _fitting(cue: Cue, sounding: Sequence[Voice | None], tails: Mapping[Note, Tail], now: float) -> Voice | None:
    """The cue as a voice, softer if there is little room; None if there is too little, or it has only just been struck."""
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
