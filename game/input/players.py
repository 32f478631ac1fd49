"""How many play on this machine, and how. Needs no pygame: the command line asks, too."""

from enum import IntEnum


class Players(IntEnum):
    """One; two who steer the same paddles; two who play against each other."""

    ONE = 0
    TOGETHER = 1
    VERSUS = 2
