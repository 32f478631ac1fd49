"""Good files made bad: bytes changed, numbers put out of range, fields of a replay exchanged, text that no encoding has."""

import contextlib
import hashlib
import math
import re
import zlib
from random import Random
from typing import Any

import msgspec

from game.levels import Level
from game.replays.file import levels_hash

_NUMBERS = (
    "0", "-0.0", "-1", "1", "5e-324", "1e-150", "1e-9", "0.3", "1e9", "1e150", "1e308", "1e400", "nan", "inf", "-inf",
    "00010", "9" * 400, "0x10", "1_000", "true", "[]", "{}", '"x"', "2026-11-23", "1979-05-27T07:32:00Z",
)  # fmt: skip
_TEXTS = (
    b"", b"\0", b"\n", b"\r", b"\xff", b"\xed\xa0\x80", b"\xef\xbb\xbf", "\u2028".encode(), "\u202e".encode(), b"\x1b[31m",
    b"%s%n", b"'" * 3, b'"' * 3, b"#", b"[", b"]]", b"=", b"&", b"?", b",", b"\\", "\u2603".encode(), b"x" * 5000, b"[" * 3000,
)  # fmt: skip
_NUMBER = re.compile(rb"(?<![\w.])-?\d+(\.\d+)?(?![\w.])")
_FACTORS = (-1.0, 0.0, 1e-12, 1e-3, 0.1, 0.5, 0.9, 0.99, 1.001, 1.01, 1.1, 1.5, 2.0, 3.0, 10.0, 1e3, 1e12)
_HEADERS = (b"polar-breakout replay 1\n", b"polar-breakout replay 2\n", b"polar-breakout replay 99999999\n", b"")


def mutated_text(good: bytes, chance: Random) -> bytes:
    """A text with one to four things changed: a number, a piece of a line, some bytes, a line more or less."""
    data = good
    if chance.random() < 0.6:  # well-formed, with numbers that are wrong or nearly right
        for _ in range(chance.randint(1, 3)):
            data = chance.choice((_scaled, _scaled, _other_number))(data, chance)
        return data
    for _ in range(chance.randint(1, 4)):
        data = chance.choice((_other_number, _other_number, _inserted, _cut, _doubled, _flipped))(data, chance)
    return data


def mutated_replay(good: bytes, chance: Random) -> bytes:
    """A replay damaged as a file, or well-formed with its checksum right and something in it exchanged."""
    if chance.random() < 0.25:
        return chance.choice((_inserted, _cut, _flipped))(good, chance)
    header, _, rest = good.partition(b"\n")
    body = zlib.decompress(rest[32:])
    if chance.random() < 0.3:
        body = chance.choice((_inserted, _cut, _flipped))(body, chance)
    else:
        fields = msgspec.msgpack.decode(body)
        name = chance.choice(sorted(fields))
        fields[name] = _other_value(fields[name], chance)
        with contextlib.suppress(msgspec.ValidationError):
            fields["levels_hash"] = levels_hash(tuple(msgspec.convert(fields["levels"], list[Level])))
        body = msgspec.msgpack.encode(fields)
    if chance.random() < 0.15:
        body = body.replace(b"0.1.0", b"\xff\xfe\x80..")  # invalid UTF-8 in a string
    packed = zlib.compress(body)
    start = chance.choice(_HEADERS) if chance.random() < 0.1 else header + b"\n"
    return start + hashlib.sha256(packed).digest() + packed


def _other_number(data: bytes, chance: Random) -> bytes:
    """One number of a text exchanged for another."""
    parts = data.split(b"=")
    if len(parts) < 2:
        return _inserted(data, chance)
    index = chance.randrange(1, len(parts))
    value, newline, rest = parts[index].partition(b"\n")
    value, mark, others = value.partition(b"&")
    number = chance.choice(_NUMBERS).encode()
    parts[index] = number + mark + others + newline + rest
    return b"=".join(parts)


def _scaled(data: bytes, chance: Random) -> bytes:
    """One number of a text made larger or smaller."""
    found = list(_NUMBER.finditer(data))
    if not found:
        return _inserted(data, chance)
    number = chance.choice(found)
    value = float(number.group()) * chance.choice(_FACTORS)
    whole = b"." not in number.group() and math.isfinite(value)
    text = str(round(value)) if whole else repr(value)
    return data[: number.start()] + text.encode() + data[number.end() :]


def _inserted(data: bytes, chance: Random) -> bytes:
    """Something in the middle."""
    at = chance.randint(0, len(data))
    return data[:at] + chance.choice(_TEXTS) + data[at:]


def _cut(data: bytes, chance: Random) -> bytes:
    """A piece left out."""
    start = chance.randint(0, len(data))
    return data[:start] + data[start + chance.randint(0, len(data) // 4) :]


def _doubled(data: bytes, chance: Random) -> bytes:
    """A line twice."""
    lines = data.split(b"\n")
    index = chance.randrange(len(lines))
    return b"\n".join([*lines[:index], lines[index], *lines[index:]])


def _flipped(data: bytes, chance: Random) -> bytes:
    """Some bits changed."""
    changed = bytearray(data)
    for _ in range(min(chance.randint(1, 8), len(changed))):
        changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _other_value(value: Any, chance: Random) -> Any:
    """Another value for a field of a replay: of another type, out of range, or the same one damaged."""
    if isinstance(value, bytes) and chance.random() < 0.7:
        return chance.choice((_inserted, _cut, _flipped))(value, chance)
    if isinstance(value, list) and value and chance.random() < 0.7:
        index = chance.randrange(len(value))
        return [*value[:index], _other_value(value[index], chance), *value[index + 1 :]]
    if isinstance(value, dict) and value and chance.random() < 0.8:
        name = chance.choice(sorted(value))
        return {**value, name: _other_value(value[name], chance)}
    return chance.choice(
        (None, -1, 0, 1, 2**62, 1.5, 5e-324, 1e300, float("nan"), "", "\n\x1b[31m", "x" * 5000, b"\xff", [], {}, True)
    )
