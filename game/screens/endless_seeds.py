"""The seeds of levels that a player asks for. Needs no pygame: the page asks, too."""

import random

LONGEST_SEED = 12
"""Letters of what a player may type."""
_SHARED_DIGITS = 6
"""Digits of a new seed: few enough to be told to somebody."""


def seed_of(text: str) -> int:
    """The seed that a player means: a number as it is, anything else as the number that its bytes are."""
    return int(text) if text.isascii() and text.isdigit() else int.from_bytes(text.encode()[:7], "little")


def new_seed() -> int:
    """A seed that nobody has asked for."""
    return random.SystemRandom().randrange(10 ** (_SHARED_DIGITS - 1), 10**_SHARED_DIGITS)
