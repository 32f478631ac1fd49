"""The state hash of arcade games has every number that decides how they go on."""

import pytest

from game.replays.state_hash import field_checks, fields, state_hash
from game.rules import (
    ActivePower,
    Difficulty,
    Drop,
    Game,
    HeldBall,
    LevelResult,
    PowerUp,
    Rank,
    Ruleset,
    Side,
    Statistics,
    Tally,
)
from tests.support.games.arcade import arcade

DROP = Drop(PowerUp.WIDE, 6j, 1j)
POWER = ActivePower(PowerUp.SLOW, 9, 10)
HELD = HeldBall(1, 0.1, 0.25, 3)
RESULT = LevelResult(0, 10, 20, 0, 3, Rank.B)
START = arcade()._replace(drops=(DROP,), powers=(POWER,), held=(HELD,), results=(RESULT,), sides=(Side(1, 2), Side(3, 4)))
CHANGES = [
    ("speed", 9.0 * (1.0 + 2.0**-52)),
    *[
        ("drops", (DROP._replace(**{name: value}),))
        for name, value in (("kind", PowerUp.FAST), ("position", 5j), ("velocity", 2j))
    ],
    ("drops", (DROP, DROP)),
    *[("powers", (POWER._replace(**{name: 8}),)) for name in POWER._fields],
    ("powers", ()),
    *[("held", (HELD._replace(**{name: 2}),)) for name in HELD._fields],
    *[("results", (RESULT._replace(**{name: 99}),)) for name in RESULT._fields],
    *[("statistics", Statistics(Tally(**{name: 1}))) for name in Tally._fields],
    *[("statistics", Statistics(game=Tally(**{name: 1}))) for name in Tally._fields],
    *[("sides", (Side(1, 2), Side(3, 4)._replace(**{name: 9}))) for name in Side._fields],
    *[(name, 7) for name in ("paddle_hits", "waited", "burst", "aim_start", "score_before", "server", "last_player")],
    ("ruleset", Ruleset(Difficulty.HARD)),
    ("ruleset", Ruleset(versus=True)),
]


@pytest.mark.parametrize(("field", "value"), CHANGES)
def test_a_change_of_any_number_changes_the_hash(field, value):
    """And one byte of the trace, of what the arcade rules add."""
    other = START._replace(**{field: value})
    assert state_hash(other) != state_hash(START)
    differing = [name for name, a, b in zip(fields(Ruleset()), field_checks(START), field_checks(other), strict=True) if a != b]
    assert len(differing) == 1
    assert differing[0] in fields(Ruleset())[-3:]


def test_the_width_of_the_paddles_is_in_it():
    """It changes in play, as no level's does."""
    arena = START.arena
    wider = START._replace(arena=arena._replace(rings=(arena.rings[0]._replace(half_angle=0.3), *arena.rings[1:])))
    assert state_hash(wider) != state_hash(START)


def test_every_field_is_looked_at():
    """A field that is added to a game is added here, unless it is hashed under any rules or decides nothing."""
    always = {"levels", "number", "seed", "draws", "tick", "phase", "phase_tick", "arena", "score", "lives", "combo", "idle"}
    assert set(Game._fields) - always - {"flight"} == {field for field, _ in CHANGES}
