"""What the player can switch off, one by one."""

from enum import StrEnum


class Kind(StrEnum):
    """An effect; its value is its name in the settings file."""

    TRAIL = "trail"
    FLASH = "flash"
    RING = "ring"
    SHARDS = "shards"
    SPARKS = "sparks"
    RECOIL = "recoil"
    FALLING = "falling"
    POINTS = "points"
    COMBO = "combo"
    WAVES = "waves"
    SHAKE = "shake"
    HIT_STOP = "hit_stop"


Shown = frozenset[Kind]

ALL: Shown = frozenset(Kind)
PLAIN: Shown = frozenset({Kind.TRAIL})
"""What is left for players who want no effects: the trail says where the ball goes."""
MOVING: Shown = frozenset({Kind.FLASH, Kind.RING, Kind.WAVES, Kind.SHAKE, Kind.HIT_STOP})
"""What reduced motion does without."""
