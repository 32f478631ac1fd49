"""A scene of the lab in time, and its saved cases."""

import pytest

from game.lab.kit.parameters import Clamped, clamped
from game.lab.kit.scene import Motion
from game.lab.registry import scenes
from game.lab.session import cases, session
from game.lab.session.checks import failures
from game.lab.session.share import parsed
from game.system.errors import BadInputError
from tests.support.paths import LAB_CASES as CASES


def other(run):
    """The values with the first one changed."""
    parameter = run.scene.parameters[0]
    return clamped(run.scene.parameters, run.given, {parameter.name: parameter.default + 0.5})


def test_a_scene_that_runs_runs_at_once_and_pauses(run):
    """A scene starts at a quarter of real time, so half a second is thirty ticks; paused, it does not go on."""
    assert run.playing
    run = session.later(run, 0.5)
    assert run.tick == 30
    run = session.toggled(run)
    assert session.later(run, 1.0).tick == 30


def test_no_time_is_lost_between_frames(run):
    """Many short frames are as long as one: the rest of a tick is carried over to the next frame."""
    for _ in range(128):
        run = session.later(run, 1 / 256)
    assert run.tick == 30


def test_one_step_forward_and_back_is_where_one_was(run):
    """A step back shows the state that was there; forward again, the hash is the same."""
    run = session.moved(run, 5)
    assert (run.tick, run.states[run.tick], run.playing) == (5, 5, False)
    hashes = [session.state_hash(session.moved(run, ticks)) for ticks in (0, -1, -5)]
    assert len(set(hashes)) == 3
    assert session.state_hash(session.moved(session.moved(run, -3), 3)) == hashes[0]
    assert session.moved(run, -99).tick == 0
    assert session.moved(run, 999).tick == run.last


def test_it_stands_still_at_its_end(run):
    """At its last tick a scene stops; started again, it is at tick 0."""
    run = session.later(session.at_tick(run, 99), 1.0)
    assert (run.tick, run.playing) == (100, False)
    again = session.toggled(run)
    assert (again.tick, again.playing) == (0, True)


def test_a_change_begins_anew(run):
    """A changed value takes the scene back to tick 0 and forgets the states of the values before."""
    run = session.moved(run, 9)
    after = session.changed(run, other(run))
    assert (after.tick, after.states) == (0, (0,))
    assert session.changed(run, Clamped(run.given, ("a note",))) == run._replace(notes=("a note",))


def test_restart_keeps_the_values(run):
    """Restart goes back to tick 0 and does not change the values."""
    run = session.moved(session.changed(run, other(run)), 9)
    again = session.restarted(run)
    assert (again.tick, again.given) == (0, run.given)


def test_slow_motion(run):
    """A step of the pace is a factor of two, between the slowest pace and real time."""
    assert session.later(session.paced(run, -1), 0.5).tick == 15
    assert session.paced(run, -99).pace == 0
    assert session.later(session.paced(run, 99), 0.125).tick == 30


def test_the_hash_sees_every_value():
    """Another value or another scene has another hash; -0.0 has the hash of 0.0."""
    scene = scenes()[0]
    base = session.fresh(scene, None)
    name = next(parameter.name for parameter in scene.parameters)
    zero, minus = (
        session.state_hash(base._replace(given=base.given._replace(values={**base.given.values, name: value})))
        for value in (complex(0.0, 0.0), complex(-0.0, -0.0))
    )
    assert zero == minus
    assert len({session.state_hash(base), zero, session.state_hash(session.fresh(scenes()[1], None))}) == 3


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_a_still_scene_has_no_time(scene):
    """Stepping changes the tick of a scene that runs, and of no other."""
    found = session.fresh(scene, None)
    assert found.runs == found.playing == isinstance(scene.shows, Motion)
    assert (session.moved(found, 3).tick == 3) == found.runs


@pytest.mark.parametrize("line", cases.saved_cases(CASES))
def test_the_claims_of_a_saved_case_hold(line):
    """At every saved case all claims hold, and the case opens at its tick."""
    shared = parsed(line)
    assert failures(shared.scene, shared.given) == ()
    assert session.opened(shared).tick == shared.tick


def test_a_case_is_saved_once(tmp_path):
    """A case is appended once; its folder is made if need be; comments are skipped; a failed write is a BadInputError."""
    file = tmp_path / "data" / "cases.txt"
    assert cases.saved_cases(file) == []
    assert cases.save_case("case-2?r=1", file) == f"saved in {file}"
    assert cases.save_case("case-2?r=1", file) == f"already in {file}"
    file.write_text(f"# why\n\n{file.read_text()}")
    assert cases.saved_cases(file) == ["case-2?r=1"]
    with pytest.raises(BadInputError, match="case not saved"):
        cases.save_case("case-2?r=2", tmp_path)


def test_this_checkout_keeps_its_cases_with_its_tests():
    """In a checkout the cases are saved where pytest finds them."""
    assert cases.case_file() == CASES
