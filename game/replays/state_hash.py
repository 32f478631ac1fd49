"""What two games must share to be the same game: every number of the state, as bytes."""

import hashlib
import struct
import zlib
from collections.abc import Iterable

from game.rules import PADDLES, Game, Ruleset
from game.rules.state import paddle_rings

FIELDS = ("ball positions", "ball velocities", "paddles", "brick rings", "layers", "score and lives", "phase and chance")
"""What the state is divided into, to say where two games part."""
_ARCADE_FIELDS = ("speed and drops", "power-ups", "counts")
"""What the arcade rules add to it."""


def fields(ruleset: Ruleset) -> tuple[str, ...]:
    """What the state of a game under these rules is divided into."""
    return FIELDS + _ARCADE_FIELDS if ruleset.arcade else FIELDS


def state_hash(game: Game) -> str:
    """SHA-256 over the whole state: little-endian float64, -0.0 as 0.0, and 64-bit integers."""
    return hashlib.sha256(b"".join([*_packed(game), _integers((game.tick, game.seed))])).hexdigest()


def field_checks(game: Game) -> bytes:
    """One byte for each of `fields`: a tick's trace, small enough to keep for every tick."""
    return bytes([zlib.crc32(part) & 0xFF for part in _packed(game)])


def _packed(game: Game) -> tuple[bytes, ...]:
    """The state's bytes, one string for each of `fields`."""
    return (*_source_state(game), *_arcade_state(game)) if game.ruleset.arcade else _source_state(game)


def _source_state(game: Game) -> tuple[bytes, ...]:
    """What a game has under any rules."""
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


def _arcade_state(game: Game) -> tuple[bytes, ...]:
    """What the arcade rules add."""
    drops, powers, held = game.drops, game.powers, game.held
    moving = [game.speed, game.arena.rings[PADDLES].half_angle]
    moving += [x for drop in drops for x in (drop.position.real, drop.position.imag, drop.velocity.real, drop.velocity.imag)]
    lasting = [x for power in powers for x in (power if game.sides else power[:3])]  # who has it, where that can be asked
    lasting += [x for ball in held for x in (ball.ring, ball.slot, ball.ticks)]
    counts = [game.paddle_hits, game.waited, game.burst, game.aim_start, game.score_before, *game.statistics.level]
    counts += [game.server, game.last_player, *[x for side in game.sides for x in side]]
    counts += [*game.statistics.game, *[x for result in game.results for x in result]]
    others = [game.arena.rings[k].half_angle for k in paddle_rings(game)[1:]]
    return (
        _floats(moving) + _integers([len(drops), *[drop.kind for drop in drops]]),
        _integers([len(powers), len(held), *lasting]) + _floats([x for ball in held for x in (ball.offset, ball.radius)]),
        _integers([*game.ruleset, *counts]) + _floats(others),
    )


def _floats(values: list[float]) -> bytes:
    """Little-endian float64."""
    return struct.pack(f"<{len(values)}d", *[x + 0.0 for x in values])


def _integers(values: Iterable[int]) -> bytes:
    """Little-endian int64."""
    return b"".join([value.to_bytes(8, "little", signed=True) for value in values])
