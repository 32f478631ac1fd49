"""The seeds of endless levels. Needs no pygame, since the page in the browser uses it, too."""

import random

LONGEST_SEED = 12
"""Greatest length of the text that a player may type."""
_SHARED_DIGITS = 6
"""Digits of a new seed: few enough to tell somebody."""


def seed_of(text: str) -> int:
    """The seed for a player's text: a number itself; any other text as the number that its bytes form."""
    return int(text) if text.isascii() and text.isdigit() else int.from_bytes(text.encode()[:7], "little")


def new_seed() -> int:
    """A random seed."""
    return random.SystemRandom().randrange(10 ** (_SHARED_DIGITS - 1), 10**_SHARED_DIGITS)
