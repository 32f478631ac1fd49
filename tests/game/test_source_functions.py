"""The source's own functions run the game: every one of them is called by play, and a change of one changes the game."""

import sys
from collections import Counter

import pytest

import physics
from game.autopilot import Autopilot
from game.levels import classic
from game.replays.state_hash import state_hash
from game.rules import new_game, tick
from physics import source_mode
from physics.narrow_phase import contact_above

SWEPT = [
    "normalize_angle",
    "add_angles",
    "subtract_angles",
    "min_difference",
    "on_left",
    "to_polar",
    "to_cartesian",
    "closest_point_on_line",
    "broad_phase_outcome",
    "in_band",
    "nearest_slot",
    "narrow_phase_case_1",
    "narrow_phase_case_2",
    "collision_response",
]
"""Functions named after the source that the swept engine calls."""

LISTED = ["broad_phase"]
"""The search over a list: the source mode flies on it; for the swept engine it is the oracle of `nearest_slot`."""


def played(advance, level=4, ticks=6000, seed=7):
    """The state after a game of the autopilot."""
    game, pilot = new_game(classic()[level - 1 :], seed), Autopilot()
    for _ in range(ticks):
        game = tick(game, pilot.controls(game), advance).game
    return game


def calls_of(advance):
    """How often each function of physics, by its name, is called during a game."""
    seen = Counter()

    def count(frame, event, _):
        if event == "call":
            seen[frame.f_code] += 1

    sys.setprofile(count)
    try:
        played(advance)
    finally:
        sys.setprofile(None)
    return {name: seen[getattr(physics, name).__code__] for name in [*SWEPT, *LISTED]}


def test_the_swept_game_calls_every_function_of_the_source():
    """All but the search over a list, which the arithmetic of `nearest_slot` replaces."""
    calls = calls_of(physics.advance)
    assert [name for name in SWEPT if calls[name] == 0] == []
    assert [name for name in LISTED if calls[name] != 0] == []


def test_the_source_mode_calls_the_search_over_a_list():
    """And case 1 through it; the rules call the outcome of the broad phase."""
    calls = calls_of(source_mode.advance)
    for name in ("broad_phase", "min_difference", "narrow_phase_case_1", "in_band", "broad_phase_outcome", "to_polar"):
        assert calls[name] > 0, name


def test_every_function_is_accounted_for():
    """The two lists above hold the functions that the lecture names, and the engine's own names for its questions."""
    lecture = "normalize_angle min_difference on_left to_cartesian to_polar closest_point_on_line broad_phase"
    lecture += " narrow_phase_case_1 narrow_phase_case_2 collision_response"
    assert set(lecture.split()) <= set(SWEPT + LISTED)


STAND_INS = {
    "physics.time_of_impact.nearest_slot": lambda ring, _: ring.count - 1,
    "physics.time_of_impact.contact_above": lambda *given: contact_above(*given)._replace(normal=-1j),
    "physics.step.in_band": lambda *_: False,
    "physics.narrow_phase.min_difference": lambda *_: 0.0,
    "physics.narrow_phase.narrow_phase_case_1": lambda *_: 1 + 0j,
    "physics.bounce.collision_response": lambda v, *_: -v,
    "game.rules.playing.broad_phase_outcome": lambda *_: physics.Outcome.GAME_OVER,
}


@pytest.fixture(scope="module")
def right():
    """The state after a game in which nothing was changed."""
    return state_hash(played(physics.advance, ticks=3000))


@pytest.mark.parametrize("name", STAND_INS)
def test_a_change_of_one_function_changes_the_game(monkeypatch, name, right):
    """Whatever stands under that name in the engine decides how the game goes on."""
    module, _, function = name.rpartition(".")
    monkeypatch.setattr(sys.modules[module], function, STAND_INS[name])
    try:
        wrong = state_hash(played(physics.advance, ticks=3000))
    except (AssertionError, IndexError, ValueError):
        return  # so wrong that a later stage refuses it
    assert wrong != right
