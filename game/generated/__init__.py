"""Levels made from a seed: the same seed is the same sequence of levels for everyone, and a day has a seed of its own."""

from game.generated.seeds import SEQUENCE, daily_seed, generated, sequence

__all__ = ["SEQUENCE", "daily_seed", "generated", "sequence"]
