"""The kinds of sounds."""

from enum import Enum, auto


class Patch(Enum):
    """A kind of sound."""

    SERVE = auto()
    PADDLE = auto()
    BRICK = auto()
    WALL = auto()
    NUDGE = auto()
    LOST = auto()
    CLEARED = auto()
    WON = auto()
    OVER = auto()
    DROP = auto()
    GIFT = auto()
    TRAP = auto()
    POWER_OFF = auto()
    LIFE = auto()
    BALLS = auto()
    CATCH = auto()
    RELEASE = auto()
    FASTER = auto()
    SHIELD = auto()
    BUMPER = auto()
    REGROWN = auto()
    CRUMBLED = auto()
    CORE = auto()
