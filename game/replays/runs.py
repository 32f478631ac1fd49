"""The controls of a recorded game, run-length coded: ten bytes for every stretch of ticks with the same controls.

Little-endian: uint16 ticks (1 to 65535), uint16 flags, uint16 pointer, uint16 aim, uint16 second pointer; the last three are
0 where they are absent. Flags: bits 0-1 turn + 1, bit 2 serve, bit 3 pointer present, bit 4 give up, bit 5 aim present, bits
6-7 second turn + 1, bit 8 second pointer present.

Formats 1 and 2 had five bytes: uint16 ticks, uint8 flags, uint16 pointer. They are read as runs of today's format.
"""

import struct
from collections.abc import Iterator

from game.rules import Controls

LONGEST_RUN = 65535
"""Ticks."""
_RUN = struct.Struct("<HHHHH")
_OLD_RUN = struct.Struct("<HBH")
_POSSIBLE = frozenset([flags for flags in range(0b10_0000_0000) if flags & 3 != 3 and flags >> 6 & 3 != 3])
_OLD_KNOWN = {1: 0b01111, 2: 0b11111}
"""The flags that each older format knows."""
_NO_SECOND_TURN = 1 << 6


def packed_run(ticks: int, controls: Controls) -> bytes:
    """One run. ticks: 1 to LONGEST_RUN."""
    turn, pointer, serve, give_up, aim, second_turn, second_pointer = controls
    flags = (turn + 1) | serve << 2 | (pointer is not None) << 3 | give_up << 4
    flags |= (aim is not None) << 5 | (second_turn + 1) << 6 | (second_pointer is not None) << 8
    return _RUN.pack(ticks, flags, pointer or 0, aim or 0, second_pointer or 0)


def unpacked(runs: bytes) -> Iterator[Controls]:
    """The controls, tick by tick."""
    for ticks, flags, pointer, aim, second_pointer in _RUN.iter_unpack(runs):
        controls = Controls(
            (flags & 3) - 1,
            pointer if flags & 8 else None,
            bool(flags & 4),
            bool(flags & 16),
            aim if flags & 32 else None,
            (flags >> 6 & 3) - 1,
            second_pointer if flags & 256 else None,
        )
        for _ in range(ticks):
            yield controls


def problem_of(runs: bytes, ticks: int) -> str | None:
    """What is wrong with runs that should have so many ticks; None where nothing is."""
    if len(runs) % _RUN.size:
        return "cut off in the middle of a run"
    total = 0
    for length, flags, pointer, aim, second_pointer in _RUN.iter_unpack(runs):
        absent = (pointer and not flags & 8) or (aim and not flags & 32) or (second_pointer and not flags & 256)
        if length == 0 or flags not in _POSSIBLE or absent:
            return f"unknown action {flags} at tick {total}"
        total += length
    return None if total == ticks else f"{total} where {ticks} ticks need {ticks}"


def from_older(runs: bytes, version: int) -> bytes | str:
    """Runs of format 1 or 2 in today's; or, as text, what is wrong with them."""
    if len(runs) % _OLD_RUN.size:
        return "cut off in the middle of a run"
    now, total = bytearray(), 0
    for length, flags, pointer in _OLD_RUN.iter_unpack(runs):
        if flags & ~_OLD_KNOWN[version]:
            return f"unknown action {flags} at tick {total}"
        now += _RUN.pack(length, flags | _NO_SECOND_TURN, pointer, 0, 0)
        total += length
    return bytes(now)
