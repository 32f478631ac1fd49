"""The seeds of the games that are played one after the other in one session of the window."""

import hashlib


def game_seed(session_seed: int, number: int) -> int:
    """The seed of a session's game, 0 <= seed < 2**63. number: of the game, from 0.

    The first game has the session's own seed, so that it is the game that the same seed gives without a window. Each later one
    has the first 63 bits of the SHA-256 of the session's seed and the game's number, as decimal digits with a space between.
    """
    if number == 0:
        return session_seed
    return int.from_bytes(hashlib.sha256(f"{session_seed} {number}".encode()).digest()[:8], "big") >> 1
