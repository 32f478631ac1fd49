r"""Recorded games: the inputs, and hashes to prove that playing them again gives the same game.

A replay file (.polar) is, in this order:

    "polar-breakout replay 2\n"    the format and its version
    32 bytes                      SHA-256 of all that follows
    a zlib stream                 of a MessagePack map with the fields of `Recording`

`runs` packs the controls run-length coded, five bytes a run, little-endian: uint16 ticks (1 to 65535), uint8 flags (bits
0-1 turn + 1, bit 2 serve, bit 3 pointer present, bit 4 give up), uint16 pointer (0 where absent). Format 1 had no bit 4, and
is still read. `hashes` holds the 32-byte
state hash after every 60th tick and after the last. `trace` holds one byte per tick for each of `state_hash.FIELDS`,
field by field: too weak to prove anything, strong enough to say at which tick and where two games part.
"""

import hashlib
import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta

from game import VERSION
from game.levels import Level, checked
from game.replays.state_hash import FIELDS, field_checks, state_hash
from game.rules import Controls, Game, Ticked, new_game, tick
from game.system.errors import BadInputError
from game.system.files import read_input, write_whole
from game.system.wording import quoted, quoted_message, quoted_path
from physics import PHYSICS_VERSION

BLOCK = 60
"""Ticks from one state hash to the next."""
MAX_TICKS = 240 * 3600
"""The longest recording: an hour."""

_FORMAT = 2
_FLAGS = {1: 0b01111, 2: 0b11111}
"""The flags that each format knows."""
_MAGIC = b"polar-breakout replay "
_DIGEST = 32
_MAX_FILE_SIZE = 16 * 1024 * 1024
_MAX_BODY_SIZE = 32 * 1024 * 1024
_RUN = struct.Struct("<HBH")
_LONGEST_RUN = 65535


class Recording(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A whole game as its inputs and what they led to."""

    game_version: Annotated[str, Meta(max_length=40)]
    physics_version: int
    levels: Annotated[list[Level], Meta(min_length=1, max_length=100)]
    levels_hash: str
    seed: Annotated[int, Meta(ge=0, le=2**63 - 1)]
    ticks: Annotated[int, Meta(ge=0, le=MAX_TICKS)]
    runs: bytes
    hashes: bytes
    trace: bytes


class Recorder:
    """Collects a game while it is played."""

    def __init__(self, levels: tuple[Level, ...], seed: int) -> None:
        """Start recording a new game."""
        self._levels, self._seed = levels, seed
        self._last: Controls | None = None
        self._length = 0
        self._runs = bytearray()
        self._hashes = bytearray()
        self._trace = bytearray()
        self._game = new_game(levels, seed)
        self.ticks = 0

    def add(self, controls: Controls, after: Game) -> None:
        """Record the controls of one tick and the game after it; ticks beyond MAX_TICKS are left out."""
        if self.ticks >= MAX_TICKS:
            return
        if controls != self._last or self._length == _LONGEST_RUN:
            self._close_run()
            self._last = controls
        self._length += 1
        self.ticks += 1
        self._game = after
        self._trace += field_checks(after)
        if self.ticks % BLOCK == 0:
            self._hashes += bytes.fromhex(state_hash(after))

    def recording(self) -> Recording:
        """What has been recorded so far."""
        runs = self._runs + self._open_run()
        hashes = self._hashes if self.ticks % BLOCK == 0 else self._hashes + bytes.fromhex(state_hash(self._game))
        columns = b"".join([bytes(self._trace[field :: len(FIELDS)]) for field in range(len(FIELDS))])
        return Recording(
            VERSION,
            PHYSICS_VERSION,
            list(self._levels),
            levels_hash(self._levels),
            self._seed,
            self.ticks,
            bytes(runs),
            bytes(hashes),
            columns,
        )

    def _close_run(self) -> None:
        """Write the current run, if any."""
        self._runs += self._open_run()
        self._length = 0

    def _open_run(self) -> bytes:
        """The current run's bytes; none before the first tick."""
        if self._last is None or self._length == 0:
            return b""
        turn, pointer, serve, give_up = self._last
        flags = (turn + 1) | serve << 2 | (pointer is not None) << 3 | give_up << 4
        return _RUN.pack(self._length, flags, pointer or 0)


def controls_of(recording: Recording) -> Iterator[Controls]:
    """The controls, tick by tick."""
    for length, flags, pointer in _RUN.iter_unpack(recording.runs):
        controls = Controls((flags & 3) - 1, pointer if flags & 8 else None, bool(flags & 4), bool(flags & 16))
        for _ in range(length):
            yield controls


def played(recording: Recording) -> Iterator[Ticked]:
    """The game played again, tick by tick."""
    game = new_game(tuple(recording.levels), recording.seed)
    for controls in controls_of(recording):
        done = tick(game, controls)
        game = done.game
        yield done


def save(recording: Recording, path: Path) -> None:
    """Write a replay file, whole or not at all; BadInputError where it cannot be written."""
    try:
        write_whole(path, encoded(recording))
    except OSError as error:
        raise BadInputError(f"{quoted_path(path)}: cannot write replay; {error.strerror or error}") from None


def encoded(recording: Recording) -> bytes:
    """The bytes of a replay file."""
    body = zlib.compress(msgspec.msgpack.encode(recording), 9)
    return _MAGIC + b"%d\n" % _FORMAT + hashlib.sha256(body).digest() + body


def load(path: Path) -> Recording:
    """The recording in a file; BadInputError, in one line, for everything that is not one of this version."""
    return decoded(read_input(path, "replay", _MAX_FILE_SIZE), quoted_path(path))


def decoded(data: bytes, source: str) -> Recording:
    """A recording from a file's bytes; `source` names it in errors."""
    header = data[: len(_MAGIC) + 8].partition(b"\n")[0]
    version = header.removeprefix(_MAGIC)
    if not header.startswith(_MAGIC) or not version.isdigit():
        raise BadInputError(f"{source}: not a replay of the polar breakout")
    if int(version) not in _FLAGS:
        raise BadInputError(f"{source}: replay format {int(version)}; this game reads formats 1 to {_FORMAT}")
    start = len(header) + 1
    digest, body = data[start : start + _DIGEST], data[start + _DIGEST :]
    if hashlib.sha256(body).digest() != digest:
        raise BadInputError(f"{source}: damaged replay; its checksum does not fit")
    try:
        recording = msgspec.msgpack.decode(_inflated(body, source), type=Recording)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise BadInputError(f"{source}: damaged replay; {quoted_message(str(error))}") from None
    _check(recording, source, _FLAGS[int(version)])
    return recording


def _inflated(body: bytes, source: str) -> bytes:
    """The body decompressed, never to more than a recording can need."""
    stream = zlib.decompressobj()
    try:
        raw = stream.decompress(body, _MAX_BODY_SIZE)
    except zlib.error:
        raise BadInputError(f"{source}: damaged replay; not a zlib stream") from None
    if not stream.eof:
        raise BadInputError(f"{source}: damaged replay; its body is cut off or larger than {_MAX_BODY_SIZE // 2**20} MB")
    if stream.unused_data:
        raise BadInputError(f"{source}: damaged replay; something follows its body")
    return raw


def _check(recording: Recording, source: str, known: int) -> None:
    """Raise BadInputError for fields that contradict each other. known: flags of a run."""
    if recording.physics_version != PHYSICS_VERSION:
        made = f"version {quoted(recording.game_version)}, physics {recording.physics_version}"
        raise BadInputError(f"{source}: made by {made}; this game has physics {PHYSICS_VERSION} and would play it differently")
    for number, level in enumerate(recording.levels):
        checked(level, f"{source}: levels[{number}]")
    if levels_hash(tuple(recording.levels)) != recording.levels_hash:
        raise BadInputError(f"{source}: levels_hash: another level than the one the game was played on")
    if len(recording.runs) % _RUN.size:
        raise BadInputError(f"{source}: runs: cut off in the middle of a run")
    total = 0
    for length, flags, pointer in _RUN.iter_unpack(recording.runs):
        if length == 0 or flags & 3 == 3 or flags & ~known or (pointer and not flags & 8):
            raise BadInputError(f"{source}: runs: unknown action {flags} at tick {total}")
        total += length
    blocks = -(-recording.ticks // BLOCK)
    for name, expected, found in (
        ("runs", recording.ticks, total),
        ("hashes", blocks * _DIGEST, len(recording.hashes)),
        ("trace", recording.ticks * len(FIELDS), len(recording.trace)),
    ):
        if expected != found:
            raise BadInputError(f"{source}: {name}: {found} where {recording.ticks} ticks need {expected}")


def levels_hash(levels: tuple[Level, ...]) -> str:
    """One hash for all the levels of a game."""
    return hashlib.sha256("".join([level.content_hash() for level in levels]).encode()).hexdigest()
