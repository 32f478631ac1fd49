"""What can be set: every row of the settings, what it means, and what using it does."""

from collections.abc import Callable
from typing import NamedTuple

from game.effects import EffectKind
from game.settings.values import Settings


class Row(NamedTuple):
    """One line of the settings.

    label: what it is called.
    meaning: what it does, in a sentence.
    on: whether its switch is on.
    change: the settings after it is used; by +1, or by -1 for less of it.
    kind: of the effect that it switches; None for all else.
    """

    label: str
    meaning: str
    on: Callable[[Settings], bool]
    change: Callable[[Settings, int], Settings]
    kind: EffectKind | None = None


def _effect(kind: EffectKind, label: str, meaning: str) -> Row:
    """The row of one effect."""
    return Row(label, meaning, lambda settings: kind not in settings.off, lambda settings, _step: settings.toggled(kind), kind)


GENERAL = (
    Row(
        "Volume",
        "Left and right change it; so do - and = at any time.",
        lambda settings: settings.volume > 0,
        lambda settings, step: settings.louder(step),
    ),
    Row(
        "Sound",
        "M turns it off and on at any time.",
        lambda settings: settings.sound,
        lambda settings, _step: settings._replace(sound=not settings.sound),
    ),
    Row(
        "Light colours",
        "T changes them at any time.",
        lambda settings: settings.colours == "light",
        lambda settings, _step: settings.other_colours(),
    ),
    Row(
        "Reduced motion",
        "No shake, flashes, waves or hit-stop, and the camera cuts instead of gliding.",
        lambda settings: settings.reduced_motion,
        lambda settings, _step: settings._replace(reduced_motion=not settings.reduced_motion),
    ),
    Row(
        "Effects",
        "All that is listed on the right, but for the trail; E turns them off and on at any time.",
        lambda settings: settings.effects,
        lambda settings, _step: settings._replace(effects=not settings.effects),
    ),
)
EFFECTS = (
    _effect(EffectKind.TRAIL, "Ball trail", "Where the ball has just been; it grows warmer with every brick in a row."),
    _effect(EffectKind.FLASH, "Flashes", "What is struck lights up."),
    _effect(EffectKind.RING, "Ring light", "Light runs around a ring when one of its bricks breaks."),
    _effect(EffectKind.SHARDS, "Shards", "Bricks break into pieces of their colour."),
    _effect(EffectKind.SPARKS, "Sparks", "Steel and paddles give off sparks; a lost ball bursts."),
    _effect(EffectKind.RECOIL, "Paddle recoil", "A struck paddle gives way and springs back."),
    _effect(EffectKind.FALLING, "Falling stacks", "In 3D, the rest of a stack comes down and bounces."),
    _effect(EffectKind.POINTS, "Points", "Points rise where they are made, larger the longer the row."),
    _effect(EffectKind.COMBO, "Combo counter", "The counter of bricks in a row springs with every brick."),
    _effect(EffectKind.WAVES, "Waves", "Circles run over the ground when a level begins or ends, or a ball is lost."),
    _effect(EffectKind.SHAKE, "Shake", "Great moments shake the arena."),
    _effect(EffectKind.DEPTH, "Light and shadow", "The arena has depth: bricks throw shadows, the rim glows."),
    _effect(EffectKind.LIGHTS, "Lights", "What is struck throws light on the arena; balls shine."),
    _effect(EffectKind.SWIRL, "Swirls", "Gravity wells turn, power-ups float."),
    _effect(EffectKind.ENTRY, "Entry", "The wall is built up when a level begins."),
    _effect(EffectKind.SLOW_MOTION, "Slow motion", "Time slows down before the last brick breaks."),
    _effect(EffectKind.HIT_STOP, "Hit-stop", "On great moments the game holds its breath for a tenth of a second."),
)
ROWS = (*GENERAL, *EFFECTS)
