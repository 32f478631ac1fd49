"""What a scene of the lab is about does happen in it: at its defaults and in the presets that say so."""

import pytest

from game.lab.kit.end_bounce import end_bounce
from game.lab.kit.picture import Arrow, Stroke, Toggle
from game.lab.registry import scene_named
from game.lab.scenes.narrow_phase import inside_material
from game.lab.scenes.response import axis_slip, carried, friction, stopped_dead
from game.lab.scenes.runs import discrete_swept, falling_stack, free_run, source_game
from game.lab.scenes.time_of_impact import impact_resting, impact_turning, two_bricks
from game.lab.session.share import parsed, preset
from physics import Feature
from tests.support.lab_scenes import state_at
from tools.crosscheck.second_engine import Pymunk


def values(scene, label):
    """The values of a preset, found by the beginning of its label."""
    (found,) = [one for one in scene.presets if one.label.startswith(label)]
    return preset(scene, found.line)


@pytest.mark.parametrize("label", ["half the speed", "rough and slanting"])
def test_the_ball_is_stopped_dead(label):
    """The source's answer is 0 / 0; with an end a little slower or faster it is not."""
    assert end_bounce(values(stopped_dead.SCENE, label)).found.stopped
    assert not end_bounce(values(stopped_dead.SCENE, "a little less")).found.stopped
    assert end_bounce(values(stopped_dead.SCENE, "a little more")).found.overtaken


@pytest.mark.parametrize("label", ["carried", "inward along", "a retreating end"])
def test_the_ball_is_carried(label):
    """The end would overtake the source's ball, and the two balls part at once."""
    given = values(carried.SCENE, label)
    assert end_bounce(given).found.overtaken
    states = [state_at(carried.SCENE, given, tick) for tick in (1, 10)]
    assert all([abs(state.by_physics.position - state.by_source.position) > 1e-4 for state in states])


@pytest.mark.parametrize("label", ["hit from behind", "met head-on"])
def test_the_ball_gets_away(label):
    """The end meets it, and both answers are the same."""
    after = end_bounce(values(carried.SCENE, label))
    assert not after.found.separates
    assert not after.found.overtaken
    assert abs(after.by_source - after.found.steps.velocity) < 1e-12


@pytest.mark.parametrize(
    ("label", "feature"),
    [
        ("the inner face", Feature.INNER_FACE),
        ("the outer face", Feature.OUTER_FACE),
        ("an end", Feature.END),
        ("a corner", Feature.CORNER),
        ("past it", None),
        ("at rest", None),
    ],
)
def test_what_the_resting_sector_is_touched_with(label, feature):
    """The ball of each preset first touches the feature that the preset names."""
    impact = impact_resting._flight_past(values(impact_resting.SCENE, label)).impact
    assert (None if impact is None else impact.contact.feature) == feature


def test_the_search_for_the_turning_end_is_one_to_be_seen():
    """The search takes at least eight steps at the defaults, one for an end at rest, none for a touch at time 0."""
    steps = {
        one.label: len(impact_turning._search(preset(impact_turning.SCENE, one.line)).times) - 1
        for one in impact_turning.SCENE.presets
    }
    assert steps["across the end's path"] >= 8
    assert steps["the end at rest"] == 1
    assert steps["touching at t = 0"] == 0


def test_the_ball_tunnels_before_ones_eyes():
    """The source's ball passes the wall at 20 tests a second, but not at 60 or 240."""
    scene = discrete_swept.SCENE
    for label, through in (("20 tests", True), ("60 tests", False), ("240 tests", False), ("a thin wall", True)):
        given = values(scene, label)
        end = state_at(scene, given, 480)
        assert discrete_swept._is_out(discrete_swept._ball_and_wall(given), end) is through
        assert end.hits >= 2


def test_both_bricks_are_touched():
    """Both bricks are touched, at the same time in one preset and one after the other in another."""
    scene = two_bricks.SCENE
    tie, later = (two_bricks._notch(values(scene, label)) for label in ("both at the same", "one after"))
    assert (tie.tie, later.tie) == (True, False)
    assert {hit.slot for hit in tie.hits} == {hit.slot for hit in later.hits} == {0, 3}
    assert len(two_bricks._notch(values(scene, "down into")).hits) > 8


def test_which_way_is_out():
    """The ball leaves through the side that the preset names."""
    labels = {"near an end": Feature.END, "near the outer": Feature.OUTER_FACE, "near the inner": Feature.INNER_FACE}
    for label, feature in labels.items():
        start = inside_material._ball_inside(values(inside_material.SCENE, label))
        assert (start.inside, start.found.feature, start.step.freed) == (True, feature, 1)


def test_the_ball_is_squeezed_and_put_outward():
    """Where the ends close on the ball there is a tick of 32 bounces, and the ball is put outward; elsewhere there is not."""
    scene = scene_named("squeezed")
    for label, squeezed in (
        ("closing slowly", True),
        ("closing fast", True),
        ("it gets out", False),
        ("nothing closes", False),
    ):
        end = state_at(scene, values(scene, label), 240)
        assert (end.most == 32, end.dropped > 0, end.freed > 0) == (squeezed,) * 3


def test_the_game_ends_once_while_the_source_ends_it_again_and_again():
    """Three balls are lost and the game ends once, while the source's rule holds in hundreds of ticks."""
    scene = scene_named("game-over-once")
    end = state_at(scene, values(scene, "out at once"), 480)
    assert (end.lost, end.ended, end.game.lives) == (3, 1, 0)
    assert end.over > 400
    assert state_at(scene, values(scene, "hit by the"), 240).lost == 0


def test_the_nudge_comes():
    """In every preset the first nudge comes with the twelfth contact; the ball without nudges goes on bouncing."""
    scene = scene_named("nudge")
    for one in scene.presets:
        end = state_at(scene, preset(scene, one.line), 960)
        assert end.nudges >= 1
        assert end.contacts == 12
        assert end.bounces > 12


def test_the_two_engines_part_at_the_first_bounce():
    """Both paths differ from the first bounce on, and by less if the second engine takes more steps in a tick."""
    scene = free_run.SCENE
    apart = []
    for label in ("one step", "eight steps"):
        (found,) = [one for one in scene.presets if one.label.startswith(label)]
        end = state_at(scene, preset(scene, found.line, Pymunk()), 240)
        assert end.bounces == len(end.apart) >= 2
        apart.append(end.apart[0])
    assert apart[0] > 2.0 * apart[1] > 1e-3


def test_friction_bends_the_path():
    """At the defaults all three bounces differ; straight on a paddle at rest they are the same."""
    for label, different in (("against", True), ("straight on", False)):
        presets = [one for one in friction.SCENE.presets if one.label.startswith(label)]
        bounces = friction._friction_bounces(preset(friction.SCENE, presets[0].line)).bounces
        angles = [friction._angle_to_normal(found.steps.velocity) for found in bounces]
        assert (len(set(angles)) == 3) is different


def test_friction_is_drawn_with_its_normal():
    """The toggle "normals" hides n and nothing else; the change by friction is a whole line, however short it is."""
    (_, middle, _) = friction._picture(preset(friction.SCENE, "spin=0.4")).panes
    arrows = {mark.label: mark for mark in middle.marks if isinstance(mark, Arrow)}
    assert [label for label, mark in arrows.items() if mark.toggle is Toggle.NORMALS] == ["n"]
    assert arrows["n"].vector == pytest.approx(friction._NORMAL_LENGTH * 1j)
    assert arrows["Δv'_t"].stroke is not Stroke.DASHED


def test_the_angle_after_friction_is_above_0_clockwise():
    """A ball that leaves to the right of the normal has turned clockwise from it."""
    assert friction._angle_to_normal(1 + 1j) == 45.0
    assert friction._angle_to_normal(-1 + 1j) == -45.0


def test_the_axes_of_the_slides_do_not_fit():
    """Read literally, the ball leaves the ground, flies into the wall, or bounces off a wall that it leaves."""
    scene = axis_slip.SCENE
    assert axis_slip._two_readings(values(scene, "off the ground")).three.y > 5.0
    same = axis_slip._two_readings(values(scene, "n along x"))
    assert abs(complex(same.three.x, same.three.z) - same.found.steps.velocity) < 1e-9
    for label, literally in (("n along the other", False), ("approaching", False), ("leaving", True)):
        both = axis_slip._two_readings(values(scene, label))
        assert (both.literal_approach < 0.0, both.found.approach < 0.0) == (literally, not literally)


def test_the_stack_falls_layer_by_layer():
    """Each hit takes one layer until the slot is empty. The rest falls from one layer high, from higher if hit again."""
    scene = falling_stack.SCENE
    given = values(scene, "four layers")
    states = [state_at(scene, given, tick) for tick in range(0, 721, 8)]
    assert [falling_stack._layers(state) for state in (states[0], states[-1])] == [4, 0]
    slow, fast = (parsed(f"falling-stack?layers=8&speed={speed}").given for speed in (5, 40))
    heights = [max([falling_stack._height(state_at(scene, one, tick)) for tick in range(0, 361, 8)]) for one in (slow, fast)]
    assert 0.5 < heights[0] <= 1.0 < heights[1]


@pytest.mark.parametrize("rate", [20, 60, 240])
def test_the_sources_game_overlaps_before_it_answers(rate):
    """At every rate its ball overlaps something at a test, and two seconds later it is elsewhere than ours."""
    scene = source_game.SCENE
    given = parsed(f"source-game?rate={rate}").given
    end = state_at(scene, given, 480)
    assert end.deepest > 0.01
    assert end.theirs.ball.position != end.ours.balls[0].position
