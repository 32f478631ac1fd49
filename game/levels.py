"""Levels as data: TOML files, degrees for people, checked on load."""

import difflib
import hashlib
import itertools
import math
import tomllib
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Any

import msgspec
from msgspec import Meta

from game.system.errors import BadInputError
from game.system.files import read_input
from game.system.wording import quoted, quoted_message, quoted_path
from physics import PERMANENT, Arena, Ring
from physics.tolerances import MAX_IMPACTS

MAX_FILE_SIZE = 64 * 1024
_MAX_LINE = 1000
_MAX_KEY_DOTS = 8
_MAX_BRICKS = 5000
_MAX_DIGITS = 9
_FOLDER = files("game") / "levels"
"""Inside an archive or a frozen application this is no folder of the file system."""

_LEAST_PLAY = 1e-3
"""Of the ball's radius: what a lane or a gate must at least be wider than the ball. In less it bounces on the spot."""
_TICKS_PER_SECOND = 240.0
_EASY_GATE = 1.5
"""Diameters of the ball: a ball finds through a narrower gate only by luck, and may stay behind it for minutes."""
_LEAST_BALL = 1e-3
"""Of the ground's radius: a smaller ball cannot be seen."""
_LONGEST_CROSSING = 60.0
"""Seconds that a ball may take across the ground; nobody waits for a slower one."""

Size = Annotated[float, Meta(ge=0.001, le=1000.0)]
Degrees = Annotated[float, Meta(ge=0.01, le=180.0)]
Fraction = Annotated[float, Meta(ge=0.0, le=1.0)]
Angle = Annotated[float, Meta(ge=-360.0, le=360.0)]
Layers = Annotated[int, Meta(ge=PERMANENT, le=9)]


class BallSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The ball: radius in world units, speed in units per second."""

    radius: Size
    speed: Size


class PaddleSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The paddles: degrees, degrees per second, degrees per second squared."""

    radius: Size
    half_width: Size
    half_angle: Degrees
    top_speed: Annotated[float, Meta(ge=1.0, le=36000.0)]
    acceleration: Annotated[float, Meta(ge=1.0, le=360000.0)]
    friction: Fraction = 0.5
    count: Annotated[int, Meta(ge=1, le=12)] = 3
    phase: Angle = 270.0


class RingSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One ring of bricks. layers: one number for all slots, or one per slot; 0 empty, -1 unbreakable."""

    radius: Size
    half_width: Size
    half_angle: Degrees
    count: Annotated[int, Meta(ge=1, le=2000)]
    layers: Layers | list[Layers] = 1
    phase: Angle = 0.0
    spin: Annotated[float, Meta(ge=-36000.0, le=36000.0)] = 0.0
    friction: Fraction = 0.0

    def slots(self) -> tuple[int, ...]:
        """Layers of each slot."""
        return tuple(self.layers) if isinstance(self.layers, list) else (self.layers,) * self.count


class Level(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One arena and its bricks; world units, degrees."""

    name: Annotated[str, Meta(min_length=1, max_length=40)]
    ground_radius: Size
    ball: BallSpec
    paddles: PaddleSpec
    rings: Annotated[list[RingSpec], Meta(min_length=1, max_length=32)]
    description: Annotated[str, Meta(max_length=200)] = ""

    def arena(self) -> Arena:
        """The arena before the first serve: ring 0 is the paddles, no ball yet."""
        paddles = self.paddles
        sizes = (paddles.radius, paddles.half_width, math.radians(paddles.half_angle), paddles.count)
        rings = [Ring(*sizes, math.radians(paddles.phase), 0.0, paddles.friction)]
        layers = [(PERMANENT,) * paddles.count]
        for ring in self.rings:
            sizes = (ring.radius, ring.half_width, math.radians(ring.half_angle), ring.count)
            rings.append(Ring(*sizes, math.radians(ring.phase), math.radians(ring.spin), ring.friction))
            layers.append(ring.slots())
        return Arena((), tuple(rings), tuple(layers))

    def content_hash(self) -> str:
        """SHA-256 of what the level says, however its file is written."""
        return hashlib.sha256(msgspec.json.encode(self)).hexdigest()


@cache
def built_in() -> tuple[Level, ...]:
    """The levels that come with the game, in order."""
    found = sorted([file for file in _FOLDER.iterdir() if file.name.endswith(".toml")], key=lambda file: file.name)
    return tuple([parse(file.read_bytes(), file.name) for file in found])


def number_of(level: Level, levels: tuple[Level, ...]) -> tuple[int, int]:
    """A level's number, from 1, and the number of levels: of those that come with the game, else of the levels being played."""
    known = built_in() if level in built_in() else levels
    return known.index(level) + 1, len(known)


def chosen(wanted: str) -> tuple[Level, ...]:
    """The levels to play from a name, a number or a file on: the rest of the built-in ones, or the file's alone."""
    levels = built_in()
    if wanted.casefold().endswith(".toml") or len(Path(wanted).parts) > 1:
        return (load_file(Path(wanted)),)
    names = [level.name.casefold() for level in levels]
    number = int(wanted) if wanted.isdecimal() and len(wanted) <= _MAX_DIGITS else 0
    if 1 <= number <= len(levels):
        return levels[number - 1 :]
    if wanted.casefold() in names:
        return levels[names.index(wanted.casefold()) :]
    known = ", ".join([f"{number} {level.name!r}" for number, level in enumerate(levels, 1)])
    raise BadInputError(f"--level {quoted(wanted)}: no such level; expected one of {known}, or a .toml file")


def load_file(path: Path) -> Level:
    """A level from a TOML file; BadInputError, naming file, key and rule, for anything that cannot be played."""
    return parse(read_input(path, "level", MAX_FILE_SIZE), quoted_path(path))


def parse(data: bytes, source: str) -> Level:
    """A level from the bytes of a TOML file; `source` names it in errors."""
    return checked(draft(data, source), source)


def draft(data: bytes, source: str) -> Level:
    """A level that fits the format, and need not be a possible arena: what is on the way to one in the editor."""
    try:
        return msgspec.convert(_toml(data, source), Level)
    except msgspec.ValidationError as error:
        what, _, where = str(error).partition(" - at ")
        key = where.strip("`").removeprefix("$.")
        named = f"{quoted(key)}: " if key else ""
        raise BadInputError(f"{source}: {named}{quoted_message(what)}{_suggestion(what)}") from None


def checked(level: Level, source: str) -> Level:
    """The level itself, if it describes a possible arena; else BadInputError with the first rule it breaks."""
    for key, rule in _broken_rules(level):
        raise BadInputError(f"{source}: {key}: {rule}")
    try:
        level.arena()
    except ValueError as error:  # a size that the physics does not take
        raise BadInputError(f"{source}: {error}") from None
    return level


def level_schema() -> str:
    """The JSON schema of level files: keys, types, ranges. The rules between the numbers are those of `checked`."""
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Polar Breakout level",
        **msgspec.json.schema(Level),
    }
    return msgspec.json.format(msgspec.json.encode(schema), indent=2).decode()


def warnings(level: Level) -> list[str]:
    """What is allowed in a level and yet makes it tedious to play: key and reason, a line each."""
    widths = [(number, _widest_gate(ring)) for number, ring in enumerate(level.rings)]
    across = 2.0 * level.ball.radius
    return [
        f"rings[{number}]: its widest gate is {width / across:.3g} balls wide; the ball may stay behind it for minutes "
        f"where a gate is narrower than {_EASY_GATE}"
        for number, width in widths
        if width is not None and across < width < _EASY_GATE * across
    ]


def _suggestion(what: str) -> str:
    """The known key most like the unknown one that an error names."""
    unknown = what.partition("unknown field `")[2].rstrip("`")
    known = [field for table in (Level, BallSpec, PaddleSpec, RingSpec) for field in table.__struct_fields__]
    near = difflib.get_close_matches(unknown, known, 1) if unknown else []
    return f"; did you mean `{near[0]}`?" if near else ""


def _toml(data: bytes, source: str) -> dict[str, Any]:
    """The tables of a TOML file. Long lines and deep keys are refused first: they take the parser seconds and gigabytes."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInputError(f"{source}: not UTF-8 at byte {error.start}") from None
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > _MAX_LINE:
            raise BadInputError(f"{source}: line {number}: longer than {_MAX_LINE} characters")
        if line.partition("=")[0].count(".") > _MAX_KEY_DOTS:
            raise BadInputError(f"{source}: line {number}: key with more than {_MAX_KEY_DOTS} dots")
    try:
        return tomllib.loads(text)
    except ValueError as error:
        raise BadInputError(f"{source}: not valid TOML; {quoted_message(str(error))}") from None
    except RecursionError:
        raise BadInputError(f"{source}: not valid TOML; nested too deeply") from None


def _broken_rules(level: Level) -> Iterator[tuple[str, str]]:
    """(key, rule) of every rule of a possible arena that the level breaks."""
    numbers_fine = True
    for key, value in _numbers(msgspec.to_builtins(level)):
        if not math.isfinite(value):
            numbers_fine = False
            yield key, f"must be finite, not {value}"
    if not numbers_fine:
        return
    yield from _broken_track_rules(level)
    for number, ring in enumerate(level.rings):
        yield from _broken_ring_rules(f"rings[{number}]", ring, level)
    yield from _broken_wall_rules(level)


def _numbers(value: Any, key: str = "") -> Iterator[tuple[str, float]]:
    """Every number in nested tables with its key."""
    if isinstance(value, dict):
        for name, item in value.items():
            yield from _numbers(item, f"{key}.{name}" if key else name)
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _numbers(item, f"{key}[{index}]")
    elif isinstance(value, int | float):
        yield key, value


def _broken_track_rules(level: Level) -> Iterator[tuple[str, str]]:
    """Rules of the ground, the ball and the paddles."""
    paddles, speed, ground = level.paddles, level.ball.speed, level.ground_radius
    outer = paddles.radius + paddles.half_width
    if level.ball.radius < _LEAST_BALL * ground:
        yield "ball.radius", f"must be at least {_LEAST_BALL:g} of ground_radius, {_LEAST_BALL * ground:g}"
    if speed < 2.0 * ground / _LONGEST_CROSSING:
        slowest = 2.0 * ground / _LONGEST_CROSSING
        yield "ball.speed", f"must be at least {slowest:.4g}, to cross the ground in {_LONGEST_CROSSING:g} s"
    if outer > level.ground_radius:
        yield "paddles.radius", f"the paddles reach to {outer:g}, beyond ground_radius {level.ground_radius:g}"
    if paddles.half_width >= paddles.radius:
        yield "paddles.half_width", f"must be below paddles.radius {paddles.radius:g}"
    if paddles.half_angle * paddles.count >= 180.0:
        yield "paddles.half_angle", f"{paddles.count} paddles must leave gaps: below {180.0 / paddles.count:g} degrees"
    fastest = math.degrees(speed / outer)
    if paddles.top_speed >= fastest:
        yield "paddles.top_speed", f"must be below the ball's, {fastest:.4g} degrees per second at the paddles' outer radius"


def _broken_ring_rules(key: str, ring: RingSpec, level: Level) -> Iterator[tuple[str, str]]:
    """Rules of one ring of bricks."""
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    if inner <= 0.0:
        yield f"{key}.half_width", f"must be below the ring's radius {ring.radius:g}"
    if ring.half_angle * ring.count > 180.0 * (1.0 + 1e-12):
        yield f"{key}.half_angle", f"bricks overlap; at most {180.0 / ring.count:g} degrees for {ring.count} of them"
    if isinstance(ring.layers, list) and len(ring.layers) != ring.count:
        yield f"{key}.layers", f"must have one number per slot, {ring.count}, not {len(ring.layers)}"
    if math.radians(abs(ring.spin)) * outer >= level.ball.speed:
        fastest = math.degrees(level.ball.speed / outer)
        yield f"{key}.spin", f"must be below the ball's speed, {fastest:.4g} degrees per second at the ring's outer radius"
    track = level.paddles.radius - level.paddles.half_width
    if outer + 2.0 * level.ball.radius + _least_play(level.ball) >= track:
        yield (
            f"{key}.radius",
            f"reaches to {outer:g}; the ball ({2.0 * level.ball.radius:g} across) must fit below the paddles' track {track:g}",
        )


def _broken_wall_rules(level: Level) -> Iterator[tuple[str, str]]:
    """Rules that concern the rings together: no overlap, something to break, everything within reach."""
    bricks = sum([layers > 0 for ring in level.rings for layers in ring.slots()])
    if bricks == 0:
        yield "rings", "no bricks to break"
    if bricks > _MAX_BRICKS:
        yield "rings", f"{bricks} bricks; at most {_MAX_BRICKS}"
    outside_in = sorted(enumerate(level.rings), key=lambda pair: -pair[1].radius)
    for (number, ring), (below_number, below) in itertools.pairwise(outside_in):
        if below.radius + below.half_width > ring.radius - ring.half_width:
            yield f"rings[{below_number}]", f"overlaps rings[{number}]"
    yield from _broken_play_rules(outside_in, level.ball)
    barrier: int | None = None
    for number, ring in outside_in:
        if barrier is not None and max(ring.slots()) > 0:
            yield f"rings[{number}]", f"level cannot be completed: rings[{barrier}] lets no ball in"
        if barrier is None and _is_barrier(ring, level.ball.radius):
            barrier = number


def _broken_play_rules(outside_in: list[tuple[int, RingSpec]], ball: BallSpec) -> Iterator[tuple[str, str]]:
    """Rules against unbreakable walls that the ball just fits between: it would bounce to and fro for ever."""
    rule = f"leaves the ball less than {_least_play(ball):.3g} to move; make it wider, or too narrow for the ball"
    fixed = [(number, ring) for number, ring in outside_in if PERMANENT in ring.slots()]
    for number, ring in fixed:
        if any([_is_tight(width, ball) for width in _gates(ring)]):
            yield f"rings[{number}]", f"a gate between its unbreakable sectors {rule}"
        if _is_tight(2.0 * (ring.radius - ring.half_width), ball):
            yield f"rings[{number}]", f"the hole inside it {rule}"
    for (number, ring), (below_number, below) in itertools.combinations(fixed, 2):
        if _is_tight(ring.radius - ring.half_width - below.radius - below.half_width, ball):
            yield f"rings[{below_number}]", f"the lane between it and rings[{number}] {rule}"


def _is_tight(width: float, ball: BallSpec) -> bool:
    """Whether the ball just fits into a width."""
    return abs(width - 2.0 * ball.radius) < _least_play(ball)


def _least_play(ball: BallSpec) -> float:
    """World units by which a lane must be wider than the ball, for a tick to hold all impacts of a flight across it."""
    return max(_LEAST_PLAY * ball.radius, ball.speed / _TICKS_PER_SECOND / MAX_IMPACTS)


def _is_barrier(ring: RingSpec, ball_radius: float) -> bool:
    """Whether the unbreakable sectors leave no gap that the ball fits through, all bricks gone."""
    widest = _widest_gate(ring)
    return widest is not None and widest <= 2.0 * ball_radius


def _widest_gate(ring: RingSpec) -> float | None:
    """Width of the widest gap between unbreakable sectors, all bricks gone, world units; None where there are none."""
    return max(_gates(ring), default=None)


def _gates(ring: RingSpec) -> list[float]:
    """Widths of the gaps between neighbouring unbreakable sectors, all bricks gone: the chords at the inner radius."""
    fixed = [slot for slot, layers in enumerate(ring.slots()) if layers == PERMANENT]
    following = [*fixed[1:], *[slot + ring.count for slot in fixed[:1]]]
    inner = ring.radius - ring.half_width
    widths = []
    for slot, after in zip(fixed, following, strict=True):
        gap = math.radians((after - slot) * 360.0 / ring.count - 2.0 * ring.half_angle)
        widths.append(2.0 * inner * math.sin(gap / 2.0) if gap < math.pi else 2.0 * inner)
    return widths
