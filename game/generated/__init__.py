"""Levels generated from a seed: the same seed gives the same sequence of levels to everyone, and every day has a seed."""

from game.generated.seeds import SEQUENCE, daily_seed, generated, sequence

__all__ = ["SEQUENCE", "daily_seed", "generated", "sequence"]
