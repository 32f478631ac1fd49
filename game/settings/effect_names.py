"""Names of the effects in the player's language. Needs no pygame, since the page in the browser uses them, too."""

from game.effects import EffectKind
from game.language import tr


def effect_names() -> dict[EffectKind, tuple[str, str]]:
    """Name and description of every effect."""
    return {
        EffectKind.TRAIL: (tr("Ball trail"), tr("Where the ball has just been; it grows warmer with every brick in a row.")),
        EffectKind.FLASH: (tr("Flashes"), tr("What is struck lights up.")),
        EffectKind.RING: (tr("Ring light"), tr("Light runs around a ring when one of its bricks breaks.")),
        EffectKind.SHARDS: (tr("Shards"), tr("Bricks break into pieces of their colour.")),
        EffectKind.SPARKS: (tr("Sparks"), tr("Steel and paddles give off sparks; a lost ball bursts.")),
        EffectKind.RECOIL: (tr("Paddle recoil"), tr("A struck paddle gives way and springs back.")),
        EffectKind.FALLING: (tr("Falling stacks"), tr("In 3D, the rest of a stack comes down and bounces.")),
        EffectKind.POINTS: (tr("Points"), tr("Points rise where you make them, larger with every brick in a row.")),
        EffectKind.COMBO: (tr("Combo counter"), tr("The counter of bricks in a row jumps with every brick.")),
        EffectKind.WAVES: (tr("Waves"), tr("Circles run over the ground when a level begins or ends, or a ball is lost.")),
        EffectKind.SHAKE: (tr("Shake"), tr("Great moments shake the arena.")),
        EffectKind.DEPTH: (tr("Light and shadow"), tr("The arena has depth: bricks throw shadows, the rim glows.")),
        EffectKind.LIGHTS: (tr("Lights"), tr("What is struck throws light on the arena, and balls shine.")),
        EffectKind.SWIRL: (tr("Swirls"), tr("Gravity wells turn, power-ups float.")),
        EffectKind.ENTRY: (tr("Entry"), tr("The wall is built up when a level begins.")),
        EffectKind.SLOW_MOTION: (tr("Slow motion"), tr("Time slows down before the last brick breaks.")),
        EffectKind.HIT_STOP: (tr("Hit-stop"), tr("At great moments the game holds its breath for a tenth of a second.")),
    }
