"""Mistakes made in the game's own code: each is caught, by the comparison it concerns, and is gone afterwards."""

import math
import sys
import types

import pytest

import game.rules
from game.levels import Level
from physics import Ring
from tests.support.crosscheck import what
from tools.crosscheck.games.sources import AIMED, RANDOM, Source
from tools.crosscheck.results.measurements import Comparison
from tools.crosscheck.results.rows import ContactRows
from tools.crosscheck.run import Job, check_game
from tools.crosscheck.sabotage import in_bounces, in_ticks
from tools.crosscheck.sabotage.catalogue import MISTAKES
from tools.crosscheck.sabotage.replacing import constant, method, replaced
from tools.crosscheck.sabotage.suite import SabotageResult, suite_jobs

VISIBLE = [name for name, mistake in MISTAKES.items() if not mistake.invisible]
GAMES = (
    Source(None, AIMED, 1, 400),
    Source(None, "6", 3, 3000, "mouse"),
    Source(None, "4", 5, 3000),
    Source(None, RANDOM, 1, 2000),
)


def played_with(name, enough=3):
    """What the harness finds in the first game in which it finds anything."""
    rows = ContactRows()
    for source in GAMES:
        rows = check_game(Job(source, 8, None, name, enough=enough)).rows
        if rows.unexplained:
            break
    return rows


@pytest.mark.parametrize("name", VISIBLE)
def test_every_mistake_that_can_show_is_caught(name):
    """Within a few hundred aimed contacts, or a minute of a game."""
    assert played_with(name).unexplained > 0


def test_the_catalogue_has_what_it_promises():
    """At least 25 mistakes that must be caught; the others say why they cannot be; every one has a sentence."""
    assert len(VISIBLE) >= 25
    for mistake in MISTAKES.values():
        assert mistake.sentence.endswith(".")
        assert mistake.name == mistake.name.lower()
    assert sum(bool(mistake.invisible) for mistake in MISTAKES.values()) == len(MISTAKES) - len(VISIBLE) == 2


@pytest.mark.parametrize("name", sorted(set(MISTAKES) - set(VISIBLE)))
def test_a_mistake_that_is_called_invisible_is_made_and_not_seen(name):
    """Were it seen, the reason that stands in the catalogue would be wrong."""
    rows = check_game(Job(Source(None, AIMED, 1, 400), 8, None, name)).rows
    assert (rows.unexplained, rows.contacts > 500) == (0, True)


@pytest.mark.parametrize(
    ("name", "comparison", "said"),
    [
        ("rotated-normal", Comparison.NORMAL_EXACT, "the game's normal is turned by +0.1 degrees"),
        ("reversed-inner-normal", Comparison.NORMAL_EXACT, "the game's normal is the opposite of pymunk's"),
        ("swapped-end", Comparison.NORMAL_EXACT, "the game's normal is that of the sector's other end"),
        ("sources-end", Comparison.NORMAL_EXACT, "the game's normal is that of the sector's other end"),
        ("corner-as-end", Comparison.NORMAL_EXACT, "the game's normal is that of an end where pymunk has a corner"),
        ("face-called-inner", Comparison.TARGET, "the game names an inner face, pymunk an outer face"),
        ("late-touch", Comparison.TIME, "pymunk touches earlier than the game bounces (missed bounce)"),
        ("early-touch", Comparison.TIME, "the game bounced before pymunk touches (invented bounce)"),
        ("still-surface", Comparison.VELOCITY, "the game's velocity is that off a ring at rest (its spin is ignored)"),
        ("fast-rings", Comparison.PHASE, "the ring does not stand where its spins have turned it"),
        ("slower-bricks", Comparison.PHASE, "a ring of the game turns as no ring of the level does"),
        ("thicker-bricks", Comparison.PHASE, "a ring of the game has not the level's sizes"),
        ("dropped-bounce", Comparison.PRESENCE_TICK, "the ball is in material: the game missed a bounce"),
        ("jump-at-ends", Comparison.SET_FREE, "the ball overlapped nothing before it was put elsewhere"),
        ("rest-after-a-hit", Comparison.SET_FREE, "the physics freed 0 and dropped 1 balls, their flights show 0 and 0"),
    ],
)
def test_mistakes_are_named(name, comparison, said):
    """The harness says what is wrong, not only that something is."""
    assert said in what(played_with(name, enough=60), comparison)


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("two-layers", "the game leaves"),
        ("neighbours-brick", "the game names slot"),
        ("soft-walls", "the game leaves no brick, the level's numbers an unbreakable sector"),
        ("one-layer-more", "at the tick's end ring"),
    ],
)
def test_mistakes_about_bricks_are_named(name, part):
    """With the slots or the layers of both."""
    assert any(part in said for said in what(played_with(name, enough=50), Comparison.TARGET))


def test_a_mistake_is_made_in_the_code_path_and_not_in_the_report():
    """A game in which bricks lose two layers is over sooner: its score is another one."""

    def layers_left():
        tick = None
        current = game.rules.new_game(game.levels.chosen("1"), 3)
        pilot = game.autopilot.Autopilot()
        for _ in range(2400):
            tick = game.rules.tick(current, pilot.controls(current))
            current = tick.game
        return game.rules.layers_left(current)

    right = layers_left()
    with MISTAKES["two-layers"].change():
        assert layers_left() < right
    assert layers_left() == right


def patched():
    """Every function and number of the game's modules, and the methods that a mistake may replace."""
    modules = [module for name, module in sorted(sys.modules.items()) if name.partition(".")[0] in {"physics", "game"}]
    found = [
        (module.__name__, name, value)
        for module in modules
        for name, value in sorted(vars(module).items())
        if isinstance(value, float | types.FunctionType)
    ]
    return [*found, Ring.turned, Ring.surface_velocity, Level.arena]


def fail_within(mistake):
    """A block with a mistake that ends with an error."""
    right = patched()
    with mistake.change():
        assert patched() != right
        raise ZeroDivisionError


@pytest.mark.parametrize("mistake", MISTAKES.values(), ids=list(MISTAKES))
def test_everything_is_put_back(mistake):
    """Functions, methods and constants, also when the block ends with an error."""
    before = patched()
    with pytest.raises(ZeroDivisionError):
        fail_within(mistake)
    assert patched() == before


def test_a_mistake_that_cannot_be_made_is_an_error():
    """A function that nothing uses, a constant that nothing has: the suite would prove nothing."""
    with pytest.raises(LookupError), replaced(math.hypot, math.hypot):
        pass
    with pytest.raises(LookupError), constant("NO_SUCH_CONSTANT", 1.0):
        pass
    with pytest.raises(KeyError), method(Ring, "no_such_method", lambda ring: ring):
        pass


def test_the_suite_counts_a_missed_mistake_as_a_failure():
    """Caught and visible, or missed and invisible: the rest does not hold."""
    visible, hidden = MISTAKES["two-layers"], MISTAKES["early-stop"]
    assert SabotageResult(visible, 10, 3, {}, "", "").holds
    assert not SabotageResult(visible, 10, None, {}, "", "").holds
    assert SabotageResult(hidden, 10, None, {}, "", "").holds
    assert not SabotageResult(hidden, 10, 3, {}, "", "").holds
    assert not SabotageResult(visible, 10, 3, {}, "", "its process was killed by SIGKILL").holds


def test_the_suite_plays_every_mistake_on_every_kind_of_game():
    """Aimed contacts, levels and a random arena; no game goes on after a hundred findings."""
    jobs = suite_jobs(["two-layers", "early-stop"], 1, 64)
    assert [job.sabotage for job in jobs] == ["two-layers"] * 4 + ["early-stop"] * 4
    assert {job.source.level for job in jobs} == {AIMED, RANDOM, "4", "6"}
    assert {job.enough for job in jobs} == {100}


def test_the_number_of_contacts_before_the_first_finding_is_told():
    """Also over several games: those without a finding count in full."""
    clean, spoiled = ContactRows(), check_game(Job(Source(None, "4", 5, 1500), 8, None, "weak-mirror")).rows
    clean.contacts = 7
    assert spoiled.before_first == 0
    clean.merge(spoiled)
    assert clean.before_first == 7


def test_the_mistakes_in_two_files_have_one_name_each():
    """A name on the command line means one mistake."""
    names = [name for module in (in_bounces, in_ticks) for name in vars(module) if not name.startswith("_")]
    assert len(MISTAKES) == len(set(MISTAKES))
    assert {"two_layers", "still_surface"} <= set(names)
