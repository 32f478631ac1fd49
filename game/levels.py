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
from physics import PERMANENT, Arena, Ring

MAX_FILE_SIZE = 64 * 1024
_MAX_LINE = 1000
_MAX_KEY_DOTS = 8
_MAX_BRICKS = 5000
_FOLDER = files("game") / "levels"
"""Inside an archive or a frozen application this is no folder of the file system."""

Size = Annotated[float, Meta(gt=0.0, le=1000.0)]
Degrees = Annotated[float, Meta(gt=0.0, le=180.0)]
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
    top_speed: Annotated[float, Meta(gt=0.0, le=36000.0)]
    acceleration: Annotated[float, Meta(gt=0.0, le=360000.0)]
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
        """SHA-256 of what the level says, whatever the file looks like."""
        return hashlib.sha256(msgspec.json.encode(self)).hexdigest()


@cache
def built_in() -> tuple[Level, ...]:
    """The levels that come with the game, in order."""
    found = sorted([file for file in _FOLDER.iterdir() if file.name.endswith(".toml")], key=lambda file: file.name)
    return tuple([parse(file.read_bytes(), file.name) for file in found])


def chosen(wanted: str) -> tuple[Level, ...]:
    """The levels to play from a name, a number or a file on: the rest of the built-in ones, or the file's alone."""
    levels = built_in()
    if wanted.endswith(".toml") or len(Path(wanted).parts) > 1:
        return (load_file(Path(wanted)),)
    names = [level.name.casefold() for level in levels]
    if wanted.isdecimal() and 1 <= int(wanted[:4]) <= len(levels):
        return levels[int(wanted) - 1 :]
    if wanted.casefold() in names:
        return levels[names.index(wanted.casefold()) :]
    known = ", ".join([f"{number} {level.name!r}" for number, level in enumerate(levels, 1)])
    raise BadInputError(f"--level {wanted}: no such level; expected one of {known}, or a .toml file")


def load_file(path: Path) -> Level:
    """A level from a TOML file; BadInputError, naming file, key and rule, for anything that cannot be played."""
    return parse(_read(path), str(path))


def parse(data: bytes, source: str) -> Level:
    """A level from the bytes of a TOML file; `source` names it in errors."""
    try:
        level = msgspec.convert(_toml(data, source), Level)
    except msgspec.ValidationError as error:
        what, _, where = str(error).partition(" - at ")
        key = where.strip("`").removeprefix("$.")
        raise BadInputError(f"{source}: {key + ': ' if key else ''}{what}{_suggestion(what)}") from None
    return checked(level, source)


def checked(level: Level, source: str) -> Level:
    """The level itself, if it describes a possible arena; else BadInputError with the first rule it breaks."""
    for key, rule in _broken_rules(level):
        raise BadInputError(f"{source}: {key}: {rule}")
    return level


def _suggestion(what: str) -> str:
    """The known key most like the unknown one that an error names."""
    unknown = what.partition("unknown field `")[2].rstrip("`")
    known = [field for table in (Level, BallSpec, PaddleSpec, RingSpec) for field in table.__struct_fields__]
    near = difflib.get_close_matches(unknown, known, 1) if unknown else []
    return f"; did you mean `{near[0]}`?" if near else ""


def _read(path: Path) -> bytes:
    """A file's bytes, if it is a plain file of reasonable size."""
    try:
        if not path.is_file():
            raise BadInputError(f"{path}: cannot read level; expected a file" + (", not a folder" if path.is_dir() else ""))
        with path.open("rb") as file:
            data = file.read(MAX_FILE_SIZE + 1)
    except (OSError, ValueError) as error:
        raise BadInputError(f"{path}: cannot read level; {getattr(error, 'strerror', None) or error}") from None
    if len(data) > MAX_FILE_SIZE:
        raise BadInputError(f"{path}: level too large; expected at most {MAX_FILE_SIZE // 1024} KB")
    return data


def _toml(data: bytes, source: str) -> dict[str, Any]:
    """The tables of a TOML file. Long lines and deep keys are refused first: they take the parser seconds and gigabytes."""
    try:
        text = data.decode()
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
        raise BadInputError(f"{source}: not valid TOML; {error}") from None
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
    paddles, speed = level.paddles, level.ball.speed
    outer = paddles.radius + paddles.half_width
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
    if outer + 2.0 * level.ball.radius >= track:
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
    barrier: int | None = None
    for number, ring in outside_in:
        if barrier is not None and max(ring.slots()) > 0:
            yield f"rings[{number}]", f"level cannot be completed: rings[{barrier}] leaves the ball no way in"
        if barrier is None and _is_barrier(ring, level.ball.radius):
            barrier = number


def _is_barrier(ring: RingSpec, ball_radius: float) -> bool:
    """Whether the unbreakable sectors leave no gap that the ball fits through, all bricks gone."""
    fixed = [slot for slot, layers in enumerate(ring.slots()) if layers == PERMANENT]
    if not fixed:
        return False
    following = [*fixed[1:], fixed[0] + ring.count]
    steps = max([after - slot for slot, after in zip(fixed, following, strict=True)])
    gap = math.radians(steps * 360.0 / ring.count - 2.0 * ring.half_angle)
    inner = ring.radius - ring.half_width
    chord = 2.0 * inner * math.sin(gap / 2.0) if gap < math.pi else 2.0 * inner
    return chord <= 2.0 * ball_radius
