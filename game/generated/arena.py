"""A level's arena: ball, paddles, wells, power-ups and look, around its wall."""

import math
from typing import get_args

from game.generated.chance import Chance, below, between, one_of, rounded
from game.generated.figures import Style
from game.generated.wall import Traits, wall
from game.language import tr_noop
from game.level_format.specs import DropKind, GroundPattern, Palette
from game.levels import BallSpec, DropSpec, Level, LookSpec, PaddleSpec, WellSpec
from game.levels.names import GENERATED

_GROUND_RADIUS = 10.0
_BALL_RADIUS = 0.25
_SLOWEST, _FASTER = 6.1, 1.3
"""Speed of the ball in the easiest level, and how much faster it is in the hardest; world units per second."""
_TRACK, _TRACK_HALF_WIDTH = 9.3, 0.22
_COVER, _LESS_COVER = 0.87, 0.17
"""Share of the track that paddles cover in the easiest level, and how much less in the hardest."""
_SPEED_SHARE = 0.9
"""Top speed of the paddles' outer faces, as a share of the ball's speed."""
_TURNING_FROM, _BUMPERS_FROM, _WELLS_FROM, _STEEL_FROM, _ALL_DROPS_FROM = 1, 2, 3, 4, 6
"""Numbers of the first levels that may have turning rings, bumpers, wells, steel, and all power-ups."""
_GUARDED = 5
"""One level among this many has a ring that grows again."""
_CENTRAL_REACH = 4.8
_OUTER_DISTANCE, _OUTER_REACH = 4.0, 2.4
"""Reach of a well at the centre; distance from the centre and reach of the wells around it; world units."""
_GOOD_DROPS: list[DropKind] = ["wide", "slow", "multi_ball", "shield", "life", "sticky", "pierce"]
_GROUNDS: tuple[GroundPattern, ...] = get_args(GroundPattern)


def drawn(chance: Chance, number: int, hardness: float, style: Style, palette: Palette) -> Level:
    """A level that may still break a rule. number: from 0, decides what it may have; hardness: 0 to 1; style: of its figure."""
    traits = Traits(
        hardness,
        turning=number >= _TURNING_FROM and chance() < 0.4 + 0.4 * hardness,
        steel=number >= _STEEL_FROM and chance() < 0.15 + 0.25 * hardness,
        bumpers=number >= _BUMPERS_FROM and chance() < 0.25,
        regrowing=number % _GUARDED == _GUARDED - 1,
    )
    speed = rounded(_SLOWEST + _FASTER * hardness + 0.2 * chance())
    return Level(
        name=GENERATED.format(number=number + 1),
        ground_radius=_GROUND_RADIUS,
        ball=BallSpec(_BALL_RADIUS, speed),
        paddles=_paddles(chance, hardness, speed),
        rings=wall(chance, style, traits),
        description=tr_noop("A level from a seed: the same for everyone who plays it."),
        drops=_drops(chance, number),
        wells=_wells(chance, speed) if number >= _WELLS_FROM and chance() < 0.25 else [],
        look=LookSpec(palette, one_of(chance, _GROUNDS)),
    )


def _paddles(chance: Chance, hardness: float, speed: float) -> PaddleSpec:
    """The paddles: most often four. The harder the level, the less of the track they cover."""
    count = one_of(chance, (3, 4, 4, 4, 5))
    cover = _COVER - _LESS_COVER * hardness
    fastest = math.degrees(speed / (_TRACK + _TRACK_HALF_WIDTH))
    return PaddleSpec(
        radius=_TRACK,
        half_width=_TRACK_HALF_WIDTH,
        half_angle=rounded(cover * 180.0 / count),
        top_speed=float(int(_SPEED_SHARE * fastest)),
        acceleration=900.0,
        count=count,
    )


def _drops(chance: Chance, number: int) -> DropSpec:
    """The power-ups of broken bricks: in the first levels no harmful ones."""
    share = rounded(between(chance, 0.1, 0.18))
    return DropSpec(share, _GOOD_DROPS) if number < _ALL_DROPS_FROM else DropSpec(share)


def _wells(chance: Chance, speed: float) -> list[WellSpec]:
    """A well at the centre, which may push, or two to four wells around it."""
    pull = between(chance, 0.5, 0.95) * speed * speed
    if chance() < 0.5:
        strength = rounded(pull / _CENTRAL_REACH)
        return [WellSpec(0.0, -strength if chance() < 0.3 else strength, _CENTRAL_REACH)]
    count, strength = 2 + below(chance, 3), rounded(pull / _OUTER_REACH)
    return [WellSpec(_OUTER_DISTANCE, strength, _OUTER_REACH, rounded(90.0 + k * 360.0 / count)) for k in range(count)]
