"""The effects, each of which the player can switch off."""

from enum import StrEnum

from game.rules import EventKind


class EffectKind(StrEnum):
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
    DEPTH = "depth"
    LIGHTS = "lights"
    SWIRL = "swirl"
    ENTRY = "entry"
    SLOW_MOTION = "slow_motion"


RETOLD = frozenset({EventKind.BALL_CAUGHT, EventKind.AIMED})
"""Events that say more about a hit that another event has told already."""
Shown = frozenset[EffectKind]
"""The effects that the player wants to see."""

ALL: Shown = frozenset(EffectKind)
PLAIN: Shown = frozenset({EffectKind.TRAIL, EffectKind.DEPTH})
"""What is left for players who want no effects: the trail says where the ball goes, and light and shadow stand still."""
MOVING: Shown = frozenset(
    {
        EffectKind.FLASH,
        EffectKind.RING,
        EffectKind.WAVES,
        EffectKind.SHAKE,
        EffectKind.HIT_STOP,
        EffectKind.SWIRL,
        EffectKind.ENTRY,
        EffectKind.SLOW_MOTION,
    }
)
"""What reduced motion does without."""
