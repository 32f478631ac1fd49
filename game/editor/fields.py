"""Every key of the level format as the editor shows it: label, meaning, and range of numbers."""

from enum import Enum
from functools import cache
from typing import NamedTuple

import msgspec
from msgspec import inspect

from game.editor.document import Path
from game.language import tr, tr_noop
from game.level_format.specs import BallSpec, DropSpec, Level, LookSpec, PaddleSpec, RingSpec, WellSpec

TABLES: dict[str, type[msgspec.Struct]] = {
    "": Level,
    "ball": BallSpec,
    "paddles": PaddleSpec,
    "rings": RingSpec,
    "wells": WellSpec,
    "drops": DropSpec,
    "look": LookSpec,
}
"""The tables of a level file by name; the first is the file itself."""


class PanelPart(Enum):
    """A part of the panel beside the arena; its value is the part's name."""

    BRICKS = tr_noop("Bricks")
    RING = tr_noop("Ring")
    WELLS = tr_noop("Wells")
    PADDLES = tr_noop("Paddles")
    DROPS = tr_noop("Drops")
    LEVEL = tr_noop("Level")


class Field(NamedTuple):
    """One key of a table.

    table: its name, as in `TABLES`. key: as in the file. label: what the player reads. meaning: a sentence, or "".
    step: by which one press of a key changes a number; 0 if the value is no number.
    """

    table: str
    key: str
    label: str
    meaning: str = ""
    step: float = 0.0

    def path(self, index: int = 0) -> Path:
        """The path of the value in a level. index: of the ring or well."""
        if self.table in ("rings", "wells"):
            return self.table, index, self.key
        return (self.table, self.key) if self.table else (self.key,)

    def tip(self, path: Path) -> str:
        """A line with the meaning, the key and the range. path: of the value in the level."""
        limits = range_of(self.table, self.key)
        key = named(path) + (
            "" if limits is None else tr(": {low} to {high}").format(low=f"{limits[0]:.10g}", high=f"{limits[1]:.10g}")
        )
        return f"{tr(self.meaning)} ({key})" if self.meaning else key


RING_FIELDS = (
    Field("rings", "radius", tr_noop("Radius"), tr_noop("From the arena's centre to the middle of the ring."), 0.05),
    Field("rings", "half_width", tr_noop("Half thickness"), "", 0.01),
    Field("rings", "count", tr_noop("Slots"), tr_noop("Bricks keep their share of the turn."), 1.0),
    Field("rings", "half_angle", tr_noop("Half angle"), tr_noop("Of one brick, in degrees."), 0.1),
    Field("rings", "phase", tr_noop("Angle of slot 0"), tr_noop("In degrees, from the right counter-clockwise."), 0.5),
    Field("rings", "spin", tr_noop("Spin"), tr_noop("Degrees per second, above 0 counter-clockwise."), 1.0),
    Field("rings", "reverse", tr_noop("Turns round after"), tr_noop("Seconds; 0 for never."), 0.5),
    Field("rings", "regrow", tr_noop("Regrows after"), tr_noop("Seconds until a missing brick grows again; 0 for never."), 0.5),
    Field("rings", "friction", tr_noop("Friction"), tr_noop("How much of its own motion it hands to the ball."), 0.05),
    Field("rings", "bumper", tr_noop("Bumper"), tr_noop("Unbreakable sectors give points and a burst of speed.")),
)
WELL_FIELDS = (
    Field("wells", "distance", tr_noop("Distance"), tr_noop("From the arena's centre to the well's."), 0.1),
    Field("wells", "angle", tr_noop("Angle"), tr_noop("In degrees, from the right counter-clockwise."), 1.0),
    Field("wells", "strength", tr_noop("Strength"), tr_noop("Pull at its middle; below 0 it pushes."), 0.5),
    Field("wells", "reach", tr_noop("Reach"), tr_noop("Where the pull has fallen to 0."), 0.1),
)
BALL_FIELDS = (
    Field("ball", "radius", tr_noop("Radius"), tr_noop("Of the ball."), 0.01),
    Field("ball", "speed", tr_noop("Speed"), tr_noop("At the serve, units per second."), 0.1),
    Field("ball", "growth", tr_noop("Growth"), tr_noop("Share of the speed that every sixth hit of a paddle adds."), 0.01),
    Field("ball", "top_speed", tr_noop("Top speed"), tr_noop("Where that ends. Empty: 1.4 times the speed at the serve."), 0.1),
)
PADDLE_FIELDS = (
    Field("paddles", "count", tr_noop("Number"), tr_noop("How many paddles there are."), 1.0),
    Field("paddles", "half_angle", tr_noop("Half angle"), tr_noop("Of one paddle, in degrees."), 0.2),
    Field("paddles", "half_width", tr_noop("Half thickness"), "", 0.01),
    Field("paddles", "radius", tr_noop("Radius"), tr_noop("From the arena's centre to the middle of the track."), 0.05),
    Field("paddles", "phase", tr_noop("Angle of the first"), tr_noop("In degrees, from the right counter-clockwise."), 1.0),
    Field("paddles", "top_speed", tr_noop("Top speed"), tr_noop("Degrees per second."), 1.0),
    Field("paddles", "acceleration", tr_noop("Acceleration"), tr_noop("By the keys, degrees per second squared."), 50.0),
    Field("paddles", "friction", tr_noop("Friction"), tr_noop("How much of its own motion a paddle hands to the ball."), 0.05),
    Field("paddles", "turn", tr_noop("Turn"), tr_noop("The most by which the position of a hit turns the ball, degrees."), 1.0),
)
CHANCE = Field("drops", "chance", tr_noop("Chance"), tr_noop("How often a broken brick leaves a power-up."), 0.01)
KINDS = Field("drops", "kinds", tr_noop("Power-ups"), tr_noop("Which power-ups bricks leave."))
NAME = Field("", "name", tr_noop("Name"))
DESCRIPTION = Field("", "description", tr_noop("Description"), tr_noop("One sentence, for the list of levels."))
CHAPTER = Field("", "chapter", tr_noop("Chapter"), tr_noop("Levels of one chapter follow each other."))
GROUND_RADIUS = Field("", "ground_radius", tr_noop("Ground radius"), tr_noop("A ball that leaves this circle is lost."), 0.1)
PALETTE = Field("look", "palette", tr_noop("Palette"), tr_noop("The colours of the arena."))
GROUND = Field("look", "ground", tr_noop("Ground"), tr_noop("The pattern of the ground."))
LAYERS = Field(
    "rings", "layers", tr_noop("Layers"), tr_noop("1 to 9 layers; 0 is a gap, - never breaks, = leaves the layers as they are.")
)
TINT = Field(
    "rings", "tint", tr_noop("Colour"), tr_noop("How many of the palette's colours the lowest layer skips; = leaves it.")
)
PART_FIELDS = {
    PanelPart.BRICKS: (LAYERS, TINT),
    PanelPart.RING: RING_FIELDS,
    PanelPart.WELLS: WELL_FIELDS,
    PanelPart.PADDLES: (*BALL_FIELDS, *PADDLE_FIELDS),
    PanelPart.DROPS: (CHANCE, KINDS),
    PanelPart.LEVEL: (NAME, DESCRIPTION, CHAPTER, GROUND_RADIUS, PALETTE, GROUND),
}
"""The fields of each part of the panel: together, every key of the format."""


def named(path: Path) -> str:
    """A path as messages name it: "rings[0].radius"."""
    return "".join([f"[{key}]" if isinstance(key, int) else f".{key}" for key in path]).removeprefix(".")


def field_at(path: Path) -> Field | None:
    """The key at a path; None if the format has no such key."""
    table = str(path[0]) if len(path) > 1 else ""
    every = [field for fields in PART_FIELDS.values() for field in fields]
    return next((field for field in every if (field.table, field.key) == (table, path[-1])), None)


@cache
def range_of(table: str, key: str) -> tuple[float, float] | None:
    """The least and the greatest number of a key; None if its value is no number or has no limits."""
    kind = _type_of(table, key)
    if not isinstance(kind, inspect.FloatType | inspect.IntType) or kind.ge is None or kind.le is None:
        return None
    return float(kind.ge), float(kind.le)


@cache
def longest(table: str, key: str) -> int:
    """The greatest number of characters of a text; 0 if the value is no text."""
    kind = _type_of(table, key)
    return kind.max_length or 0 if isinstance(kind, inspect.StrType) else 0


def is_whole(table: str, key: str) -> bool:
    """Whether the value of a key is a whole number."""
    return isinstance(_type_of(table, key), inspect.IntType)


@cache
def is_optional(table: str, key: str) -> bool:
    """Whether a file may leave a key out."""
    return not _field_of(table, key).required


@cache
def _type_of(table: str, key: str) -> inspect.Type:
    """The type that the format has for a key's values; the first one of several."""
    kind = _field_of(table, key).type
    while isinstance(kind, inspect.Metadata | inspect.UnionType):
        kind = kind.type if isinstance(kind, inspect.Metadata) else kind.types[0]
    return kind


def _field_of(table: str, key: str) -> inspect.Field:
    """The format's description of a key."""
    struct = inspect.type_info(TABLES[table])
    assert isinstance(struct, inspect.StructType)
    return next(field for field in struct.fields if field.name == key)
