"""The lab's share line: what is printed parses to the same state, and a broken line says which part is wrong."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.lab.kit.parameters import Count, Given, Point, clamped, defaults
from game.lab.kit.scene import Motion
from game.lab.registry import scenes
from game.lab.session.share import SharedScene, parsed, share_line
from game.system.errors import BadInputError


def values_of(parameter):
    """Any value in a parameter's range."""
    low, high = parameter.low, parameter.high
    if isinstance(parameter, Count):
        return st.integers(low, high).map(float)
    floats = st.floats(low, high)
    return st.builds(complex, floats, floats) if isinstance(parameter, Point) else floats


@st.composite
def states(draw):
    """Any scene with any values, at any tick."""
    scene = draw(st.sampled_from(scenes()))
    requested = {parameter.name: draw(values_of(parameter)) for parameter in scene.parameters}
    given = clamped(scene.parameters, defaults(scene.parameters), requested).given
    tick = draw(st.integers(0, scene.shows.ticks)) if isinstance(scene.shows, Motion) else 0
    return SharedScene(scene, given, tick)


@given(states())
def test_a_line_opens_the_very_state_that_it_was_printed_from(shared):
    """A printed line parses to the same scene, values and tick, to the last bit."""
    assert parsed(share_line(shared)) == shared


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_what_a_line_leaves_out_has_its_default(scene):
    """A line with the name alone is the scene at its defaults."""
    for line in (scene.name, f"{scene.name}?"):
        assert parsed(line) == SharedScene(scene, defaults(scene.parameters), 0)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("cse-2", "no scene 'cse-2'; near: case-2"),
        ("qqqqqqq", "no scene 'qqqqqqq'; --list names them all"),
        ("?ball=1,2", "no scene ''"),
        ("case-2?ball", "part 'ball' of the share line: expected NAME=VALUE"),
        ("case-2?ball=1", "part 'ball=1' of the share line: expected two numbers X,Y"),
        ("case-2?ball=1,2,3", "expected two numbers X,Y"),
        ("case-2?half_angle=1,2", "expected one number"),
        ("case-2?half_angle=abc", "part 'half_angle=abc' of the share line: 'abc' is not a number"),
        ("case-2?half_angle=nan", "'nan' is not a number"),
        ("case-2?half_angle=1e999", "'1e999' is not a number"),
        ("case-2?half_angle=1_0", "'1_0' is not a number"),
        ("case-2?half_angle= 10", "' 10' is not a number"),
        ("case-2?half_angle=181", "part 'half_angle=181' of the share line: 181 is not from 0° to 180°"),
        ("case-2?ball=1,99", "99 is not from -15 to 15"),
        ("case-2?bell=1,2", "case-2 has no 'bell'; expected ball, r, radius"),
        ("case-2?r=1&r=1", "part 'r=1' of the share line: r is given twice"),
        ("case-2?r=1&&", "part '' of the share line"),
        ("case-2?tick=3", "case-2 has no 'tick'"),
        ("case-2?" + "r" * 5000, "expected at most 4096"),
    ],
)
def test_a_broken_line_names_the_part(line, reason):
    """A broken line raises a BadInputError, whose single line names the part."""
    with pytest.raises(BadInputError) as caught:
        parsed(line)
    assert reason in str(caught.value)
    assert "\n" not in str(caught.value)


@given(st.text(max_size=60))
def test_any_text_is_a_state_or_a_refusal(text):
    """Any text parses to a scene whose line parses to it again, or raises a BadInputError."""
    for line in (text, f"case-2?{text}", f"case-2?ball={text}"):
        try:
            shared = parsed(line)
        except BadInputError as error:
            assert str(error).startswith("lab: ")  # noqa: PT017  # either is fine, but no other exception
        else:
            assert parsed(share_line(shared)) == shared


def test_what_is_out_of_range_or_no_number_is_noted():
    """A number out of range is set to the border with a note; NaN and infinity are refused with a note."""
    parameters = parsed("case-2").scene.parameters
    before = defaults(parameters)
    too_large = clamped(parameters, before, {"half_angle": 400.0})
    assert too_large.given.number("half_angle") == 180.0
    assert too_large.notes == ("φ_p = 400° is beyond its range: set to 180°",)
    for bad in (math.nan, math.inf, -math.inf, complex(1.0, math.nan)):
        refused = clamped(parameters, before, {"ball": bad})
        assert refused.given == before
        assert "it stays (" in refused.notes[0]


def test_a_count_is_whole():
    """A count that is not whole is rounded, with a note."""
    bricks = Count("count", "n", 1, 12, 3)
    half = clamped((bricks,), Given({"count": 3.0}), {"count": 4.4})
    assert half.given.count("count") == 4
    assert half.notes == ("n = 4.4 is not a whole number: set to 4",)
