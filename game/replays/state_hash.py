"""What two games must share to be the same game: every number of the state, as bytes."""

import hashlib
import struct
import zlib
from collections.abc import Iterable

from game.rules import PADDLES, Game

FIELDS = ("ball positions", "ball velocities", "paddles", "brick rings", "layers", "score and lives", "phase and chance")
"""What the state is divided into, to say where two games part."""


def state_hash(game: Game) -> str:
    """SHA-256 over the whole state: little-endian float64, -0.0 as 0.0, and 64-bit integers."""
    return hashlib.sha256(b"".join([*_packed(game), _integers((game.tick, game.seed))])).hexdigest()


def field_checks(game: Game) -> bytes:
    """One byte for each of FIELDS: a tick's trace, small enough to keep for every tick."""
    return bytes([zlib.crc32(part) & 0xFF for part in _packed(game)])


def _packed(game: Game) -> tuple[bytes, ...]:
    """The state's bytes, one string for each of FIELDS."""
    balls, rings, layers = game.arena
    paddles = rings[PADDLES]
    return (
        _floats([x for ball in balls for x in (ball.position.real, ball.position.imag)]),
        _floats([x for ball in balls for x in (ball.velocity.real, ball.velocity.imag, ball.radius)]),
        _floats([paddles.phase, paddles.spin]),
        _floats([x for ring in rings[PADDLES + 1 :] for x in (ring.phase, ring.spin)]),
        b"".join([bytes([count & 0xFF for count in slots]) for slots in layers]),
        _integers((game.score, game.lives, game.combo, game.idle)),
        _integers((game.number, game.phase, game.phase_tick - game.tick, game.draws)),
    )


def _floats(values: list[float]) -> bytes:
    """Little-endian float64."""
    return struct.pack(f"<{len(values)}d", *[x + 0.0 for x in values])


def _integers(values: Iterable[int]) -> bytes:
    """Little-endian int64."""
    return b"".join([value.to_bytes(8, "little", signed=True) for value in values])
