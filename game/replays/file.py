r"""Recorded games: the inputs, and hashes to prove that playing them again gives the same game.

A replay file (.polar) is, in this order:

    "polar-breakout replay 3\n"    the format and its version
    32 bytes                      SHA-256 of all that follows
    a zlib stream                 of a MessagePack map with the fields of `Recording`

`ruleset` is new in format 3; older ones are read as games under the source's rules. `runs` holds the controls
(`game.replays.runs`). `hashes` holds the 32-byte state hash after every 60th tick and after the last. `trace` holds one byte
per tick for each of `state_hash.fields`, field by field: too weak to prove anything, strong enough to say at which tick and
where two games part.
"""

import hashlib
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta

from game import VERSION
from game.levels import Level, checked
from game.replays import runs as run_coding
from game.replays.state_hash import field_checks, fields, state_hash
from game.rules import SOURCE_RULES, Controls, Game, Ruleset, Ticked, new_game, tick
from game.system.errors import BadInputError
from game.system.files import read_input, write_atomically
from game.system.wording import quoted, quoted_message, quoted_path
from physics import PHYSICS_VERSION

BLOCK = 60
"""Ticks from one state hash to the next."""
MAX_TICKS = 240 * 3600
"""The longest recording: an hour."""

_FORMAT = 3
_MAGIC = b"polar-breakout replay "
_DIGEST = 32
_MAX_FILE_SIZE = 24 * 1024 * 1024
_MAX_BODY_SIZE = 32 * 1024 * 1024


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
    ruleset: Ruleset = SOURCE_RULES


class Recorder:
    """Collects a game while it is played."""

    def __init__(self, levels: tuple[Level, ...], seed: int, ruleset: Ruleset = SOURCE_RULES) -> None:
        """Start recording a new game."""
        self._levels, self._seed, self._ruleset = levels, seed, ruleset
        self._last: Controls | None = None
        self._length = 0
        self._runs = bytearray()
        self._hashes = bytearray()
        self._trace = bytearray()
        self._game = new_game(levels, seed, ruleset)
        self.ticks = 0

    def add(self, controls: Controls, after: Game) -> None:
        """Record the controls of one tick and the game after it; ticks beyond MAX_TICKS are left out."""
        if self.ticks >= MAX_TICKS:
            return
        if controls != self._last or self._length == run_coding.LONGEST_RUN:
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
        count = len(fields(self._ruleset))
        columns = b"".join([bytes(self._trace[field::count]) for field in range(count)])
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
            self._ruleset,
        )

    def _close_run(self) -> None:
        """Write the current run, if any."""
        self._runs += self._open_run()
        self._length = 0

    def _open_run(self) -> bytes:
        """The current run's bytes; none before the first tick."""
        if self._last is None or self._length == 0:
            return b""
        return run_coding.packed_run(self._length, self._last)


def controls_of(recording: Recording) -> Iterator[Controls]:
    """The controls, tick by tick."""
    return run_coding.unpacked(recording.runs)


def started(recording: Recording) -> Game:
    """The recorded game before its first tick."""
    return new_game(tuple(recording.levels), recording.seed, recording.ruleset)


def played(recording: Recording) -> Iterator[Ticked]:
    """The game played again, tick by tick."""
    game = started(recording)
    for controls in controls_of(recording):
        done = tick(game, controls)
        game = done.game
        yield done


def save(recording: Recording, path: Path) -> None:
    """Write a replay file, whole or not at all; BadInputError where it cannot be written."""
    try:
        write_atomically(path, encoded(recording))
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
    if not 1 <= int(version) <= _FORMAT:
        raise BadInputError(f"{source}: replay format {int(version)}; this game reads formats 1 to {_FORMAT}")
    start = len(header) + 1
    digest, body = data[start : start + _DIGEST], data[start + _DIGEST :]
    if hashlib.sha256(body).digest() != digest:
        raise BadInputError(f"{source}: damaged replay; its checksum does not fit")
    try:
        recording = msgspec.msgpack.decode(_inflated(body, source), type=Recording)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise BadInputError(f"{source}: damaged replay; {quoted_message(str(error))}") from None
    if int(version) < _FORMAT:
        recording = _in_this_format(recording, int(version), source)
    _check(recording, source)
    return recording


def _in_this_format(recording: Recording, version: int, source: str) -> Recording:
    """A recording of an older format as one of this."""
    runs = run_coding.from_older(recording.runs, version)
    if isinstance(runs, str):
        raise BadInputError(f"{source}: runs: {runs}")
    return msgspec.structs.replace(recording, runs=runs, ruleset=SOURCE_RULES)


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


def _check(recording: Recording, source: str) -> None:
    """Raise BadInputError for fields that contradict each other."""
    if recording.physics_version != PHYSICS_VERSION:
        made = f"version {quoted(recording.game_version)}, physics {recording.physics_version}"
        raise BadInputError(f"{source}: made by {made}; this game has physics {PHYSICS_VERSION} and would play it differently")
    for number, level in enumerate(recording.levels):
        checked(level, f"{source}: levels[{number}]")
    if levels_hash(tuple(recording.levels)) != recording.levels_hash:
        raise BadInputError(f"{source}: levels_hash: another level than the one the game was played on")
    if recording.ruleset.versus and not recording.ruleset.arcade:
        raise BadInputError(f"{source}: ruleset: two players need the arcade rules")
    problem = run_coding.problem_of(recording.runs, recording.ticks)
    if problem is not None:
        raise BadInputError(f"{source}: runs: {problem}")
    blocks = -(-recording.ticks // BLOCK)
    for name, expected, found in (
        ("hashes", blocks * _DIGEST, len(recording.hashes)),
        ("trace", recording.ticks * len(fields(recording.ruleset)), len(recording.trace)),
    ):
        if expected != found:
            raise BadInputError(f"{source}: {name}: {found} where {recording.ticks} ticks need {expected}")


def levels_hash(levels: tuple[Level, ...]) -> str:
    """One hash for all the levels of a game."""
    return hashlib.sha256("".join([level.content_hash() for level in levels]).encode()).hexdigest()
