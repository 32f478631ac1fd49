"""An arena set in the lab as a level file of the game, and a level's numbers as a share line of the lab."""

import math
from collections.abc import Mapping
from typing import NamedTuple

from game.lab.kit.parameters import Given, Parameter, clamped, defaults, plain
from game.levels import Level, parse
from game.system.errors import BadInputError
from physics import Ring

ARENA = "own-arena"
"""Name of the scene."""
RINGS = (1, 2)
"""Numbers of the rings of bricks; the paddles are ring 0."""
_NAME = "arena"
_SHARE_OF_SPEED, _ACCELERATION = 0.8, 600.0
"""What a level says of paddles and the lab does not: their top speed at the outer radius, in the ball's; degrees per second².

Where the lab's paddles spin faster, that is their top speed.
"""
_MOST_WIDTH = 0.9
"""Of a ring's radius: its half width is cut down to this."""


class SavedArena(NamedTuple):
    """The level file of an arena.

    text: TOML. rings: those that the game makes of it, the paddles first; none where it is refused. problem: the rule that it
    breaks; empty for none.
    """

    text: str
    rings: tuple[Ring, ...]
    problem: str


def rings_of(given: Given) -> dict[int, Ring]:
    """The paddles, as ring 0, and the rings of bricks that have any."""
    count, radius = given.count("n_p"), given.number("r_p")
    half_angle = min(given.angle("h_p"), math.pi / count)
    rings = {0: Ring(radius, min(given.number("w_p"), _MOST_WIDTH * radius), half_angle, count, 0.0, given.angle("s_p"))}
    for number in RINGS:
        bricks = given.count(f"n_{number}")
        if bricks:
            rings[number] = _bricks(given, number, bricks)
    return rings


def saved_arena(given: Given) -> SavedArena:
    """The level that an arena is."""
    text = _toml(given)
    try:
        level = parse(text.encode(), _NAME)
    except BadInputError as error:
        return SavedArena(text, (), str(error).removeprefix(f"{_NAME}: "))
    return SavedArena(text, level.arena().rings, "")


def values_of(level: Level) -> dict[str, complex]:
    """The lab's numbers of a level: its paddles and its first rings; what the lab cannot show is left out."""
    paddles = level.paddles
    values: dict[str, complex] = {
        "r_g": level.ground_radius,
        "r": level.ball.radius,
        "speed": level.ball.speed,
        "ball": complex(0.0, -(paddles.radius - paddles.half_width) * 0.8),
        "n_p": paddles.count,
        "r_p": paddles.radius,
        "w_p": paddles.half_width,
        "h_p": paddles.half_angle,
        "s_p": 0.0,
        **{f"n_{number}": 0 for number in RINGS},
    }
    for number, ring in zip(RINGS, level.rings, strict=False):
        layers = ring.layers if isinstance(ring.layers, int) else max(ring.layers)
        values |= {
            f"n_{number}": ring.count,
            f"r_{number}": ring.radius,
            f"w_{number}": ring.half_width,
            f"f_{number}": ring.half_angle * ring.count / 180.0,
            f"s_{number}": ring.spin,
            f"l_{number}": max(layers, 1),
        }
    return values


def given_of(level: Level, parameters: tuple[Parameter, ...]) -> Given:
    """The lab's values of a level, brought into their ranges."""
    return clamped(parameters, defaults(parameters), values_of(level)).given


def _bricks(given: Given, number: int, count: int) -> Ring:
    """A ring of bricks, evenly spaced."""
    half_angle, radius = given.number(f"f_{number}") * math.pi / count, given.number(f"r_{number}")
    return Ring(
        radius, min(given.number(f"w_{number}"), _MOST_WIDTH * radius), half_angle, count, 0.0, given.angle(f"s_{number}")
    )


def _toml(given: Given) -> str:
    """The level file."""
    (_, paddles), *others = rings_of(given).items()
    usual = math.degrees(_SHARE_OF_SPEED * given.number("speed") / paddles.outer_radius)
    tables = [
        _table("", {"name": '"My arena"', "ground_radius": plain(given.number("r_g"))}),
        _table("[ball]", {"radius": plain(given.number("r")), "speed": plain(given.number("speed"))}),
        _table(
            "[paddles]",
            {
                **_ring_keys(paddles),
                "phase": "0.0",
                "top_speed": plain(max(abs(given.number("s_p")), usual)),
                "acceleration": plain(_ACCELERATION),
            },
        ),
    ]
    for number, ring in others:
        keys = {**_ring_keys(ring), "layers": str(given.count(f"l_{number}")), "spin": plain(given.number(f"s_{number}"))}
        tables.append(_table("[[rings]]", keys))
    return "\n".join(tables)


def _ring_keys(ring: Ring) -> dict[str, str]:
    """What a level says of any ring."""
    return {
        "radius": plain(ring.radius),
        "half_width": plain(ring.half_width),
        "half_angle": plain(math.degrees(ring.half_angle)),
        "count": str(ring.count),
    }


def _table(head: str, keys: Mapping[str, str]) -> str:
    """A table of a TOML file."""
    lines = [f"{key} = {value}" for key, value in keys.items()]
    return "\n".join([*([head] if head else []), *lines, ""])
