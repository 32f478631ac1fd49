"""Level files: what is accepted, and how everything else is refused in one line."""

import math
import re
from pathlib import Path

import msgspec
import pytest

from game import levels
from game.level_format import checks
from game.levels import built_in, campaign, chosen, classic, from_level, load_file, parse, reading
from game.rules import layers_left, new_game
from game.system.errors import BadInputError
from physics import PERMANENT, Arena, Ball, Ring, advance
from tests.support.level_text import GOOD, changed
from tests.support.paths import ROOT


def test_the_good_level_is_good():
    """Without a change, the level that the tests below break is accepted."""
    assert parse(GOOD, "x").rings[0].slots() == (1,) * 12


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (changed('name = "Test"', "name = 7"), r"name: Expected `str`, got `int`"),
        (changed('name = "Test"', ""), r"missing required field `name`"),
        (changed('name = "Test"', 'name = "Test"\nraduis = 3.0'), r"unknown field `raduis`; did you mean `radius`\?"),
        (changed("speed = 9.0", "speed = 9.0\nrings = 1"), "ball: .*unknown field `rings`$"),
        (changed("speed = 9.0", "speeed = 9.0"), r"ball: .*`speeed`; did you mean `speed`\?"),
        (changed("speed = 9.0", "speed = nan"), r"ball\.speed"),
        (changed("speed = 9.0", "speed = inf"), r"ball\.speed"),
        (changed("speed = 9.0", "speed = 1e400"), r"ball\.speed"),
        (changed("speed = 9.0", "speed = true"), r"ball\.speed: Expected `float`, got `bool`"),
        (changed("speed = 9.0", 'speed = "9"'), r"ball\.speed: Expected `float`, got `str`"),
        (changed("speed = 9.0", "speed = -9.0"), r"ball\.speed"),
        (changed("speed = 9.0", "speed = 2026-11-23"), r"ball\.speed"),
        (changed("top_speed = 50.0", "top_speed = 60.0"), r"paddles\.top_speed: must be below the ball's, 56\.05"),
        (changed("top_speed = 50.0", "top_speed = nan"), r"paddles\.top_speed: "),
        (changed("radius = 9.0", "radius = 9.9"), r"paddles\.radius: .*beyond ground_radius 10"),
        (changed("half_angle = 20.0", "half_angle = 60.0"), r"paddles\.half_angle: 3 paddles must leave gaps"),
        (changed("half_width = 0.2", "half_width = 9.0"), r"paddles\.(half_width|radius): "),
        (changed("radius = 3.0", "radius = 8.2"), r"rings\[0\]\.radius: reaches to 8\.6; .*fit below the paddles' track 8\.8"),
        (changed("radius = 0.25", "radius = 3.0"), r"rings\[0\]\.radius: .*6 across"),
        (changed("half_width = 0.4", "half_width = 3.0"), r"rings\[0\]\.half_width: must be below the ring's radius 3"),
        (changed("half_angle = 10.0", "half_angle = 15.1"), r"rings\[0\]\.half_angle: bricks overlap; at most 15"),
        (changed("count = 12", "count = 12\nlayers = [1, 2]"), r"rings\[0\]\.layers: must have one number per slot, 12, not 2"),
        (changed("count = 12", "count = 12\nlayers = 0"), r"rings: no bricks to break"),
        (changed("count = 12", "count = 12\nlayers = -1"), r"rings: no bricks to break"),
        (changed("count = 12", "count = 12\nlayers = -2"), r"rings\[0\]\.layers"),
        (changed("count = 12", "count = 0"), r"rings\[0\]\.count"),
        (changed("count = 12", "count = true"), r"rings\[0\]\.count: Expected `int`, got `bool`"),
        (changed("count = 12", "count = 12\nspin = 200.0"), r"rings\[0\]\.spin: must be below the ball's speed, 151\.7"),
        (changed("count = 12", "count = 12\nspin = nan"), r"rings\[0\]\.spin"),
        (
            GOOD + b"[[rings]]\nradius = 3.5\nhalf_width = 0.2\nhalf_angle = 10.0\ncount = 12\n",
            r"rings\[0\]: overlaps rings\[1\]",
        ),
        (
            GOOD + b"[[rings]]\nradius = 5.0\nhalf_width = 0.2\nhalf_angle = 14.0\ncount = 12\nlayers = -1\n",
            r"rings\[0\]: level cannot be completed: rings\[1\] lets no ball in",
        ),
        (b"name = \nb = 1", r"not valid TOML; .*line 1, column 8"),
        (b"a = 1\na = 2\n", r"not valid TOML; .*line 2"),
        (b"\xff\xfe", r"not UTF-8 at byte 0"),
        (b"a = 1\0", r"not valid TOML"),
        (b"a = " + b"9" * 990, r"Expected|missing|unknown|not valid"),
        (b"a = " + b"[" * 900, r"not valid TOML"),
        (b"a = [" + b"[\n" * 20000, r"not valid TOML; nested too deeply"),
        (b"x" * 2000, r"line 1: longer than 1000 characters"),
        (b"a" + b".a" * 20 + b" = 1", r"line 1: key with more than 8 dots"),
        (b"", r"missing required field"),
    ],
)
def test_bad_levels_are_refused_with_key_and_rule(data, expected):
    """Every broken level gives one line that names the file, the key and the rule."""
    with pytest.raises(BadInputError) as caught:
        parse(data, "level.toml")
    message = str(caught.value)
    assert message.startswith("level.toml: ")
    assert "\n" not in message
    assert re.search(expected, message), message


def test_files_that_cannot_be_read_are_refused(tmp_path: Path):
    """A missing file, a folder and a file over 64 KB are named."""
    large = tmp_path / "large.toml"
    large.write_bytes(b"#" * (64 * 1024 + 1))
    for path, reason in ((tmp_path / "none.toml", "cannot read"), (tmp_path, "not a folder"), (large, "too large")):
        with pytest.raises(BadInputError, match=reason):
            load_file(path)


def test_a_device_is_not_read():
    """An endless device is refused at once."""
    with pytest.raises(BadInputError, match="cannot read"):
        load_file(Path("/dev/zero"))


def test_levels_are_chosen_by_number_name_or_file(tmp_path: Path):
    """A number and a name start there and go on: the campaign's first, then the classic ones; a file stands alone."""
    assert chosen("3") == campaign()[2:]
    assert chosen(str(len(campaign()) + 3)) == classic()[2:]
    assert chosen("carousel") == classic()[3:]
    own = tmp_path / "own.toml"
    own.write_bytes(GOOD)
    assert [level.name for level in chosen(str(own))] == ["Test"]
    for wrong in ("0", "99", "-1", "", "nothing", "9" * 5000):
        with pytest.raises(BadInputError, match="no such level"):
            chosen(wrong)


def test_the_levels_differ_in_kind():
    """There are at least five levels: a single ring, several, gaps, turning rings, stacks of three and more, unbreakables."""
    kinds = {
        "single": [len(level.rings) == 1 for level in classic()],
        "several": [len(level.rings) >= 3 for level in classic()],
        "gaps": [any(0 in ring.slots() for ring in level.rings) for level in classic()],
        "turning": [any(ring.spin != 0.0 for ring in level.rings) for level in classic()],
        "stacks": [any(max(ring.slots()) >= 3 for ring in level.rings) for level in classic()],
        "unbreakable": [any(PERMANENT in ring.slots() for ring in level.rings) for level in classic()],
    }
    assert len(classic()) >= 5
    assert all(any(found) and not all(found) for found in kinds.values())


def test_the_arena_has_what_the_level_says():
    """Bricks and paddles of the arena are those of the file, in radians."""
    for number, level in enumerate(classic()):
        game = new_game(classic()[number:], 0)
        layers = [count for ring in level.rings for count in ring.slots()]
        assert layers_left(game) == sum(count for count in layers if count > 0)
        assert game.arena.rings[0].count == level.paddles.count
        assert len(game.arena.rings) == 1 + len(level.rings)


def test_what_editors_write_is_accepted(tmp_path: Path):
    """A byte order mark, as Notepad puts it before every file, and a name in capitals."""
    own = tmp_path / "UPPER.TOML"
    own.write_bytes(b"\xef\xbb\xbf" + GOOD.replace(b"\n", b"\r\n"))
    assert load_file(own) == parse(GOOD, "x")
    assert chosen(str(own)) == (parse(GOOD, "x"),)


def test_a_number_is_a_number():
    """With zeros before it, too; 99 is no level."""
    assert chosen("0003") == campaign()[2:]
    for wrong in ("00099", "0" * 8, "0" * 5000 + "3"):
        with pytest.raises(BadInputError, match="no such level"):
            chosen(wrong)


@pytest.mark.parametrize(
    ("old", "new", "rule"),
    [
        ("half_angle = 10.0", "half_angle = 5e-324", r"rings\[0\]\.half_angle: Expected `float` >= 0.01"),
        ("half_angle = 20.0", "half_angle = 5e-324", r"paddles\.half_angle: Expected `float` >= 0.01"),
        ("radius = 0.25", "radius = 1e-150", r"ball\.radius: Expected `float` >= 0.001"),
        ("radius = 0.25", "radius = 0.009", r"ball\.radius: must be at least 0.001 of ground_radius, 0.01"),
        ("speed = 9.0", "speed = 0.3", r"ball\.speed: must be at least 0.3333, to cross the ground in 60 s"),
        ("top_speed = 50.0", "top_speed = 1e-9", r"paddles\.top_speed: Expected `float` >= 1.0"),
        ("acceleration = 400.0", "acceleration = 5e-324", r"paddles\.acceleration: Expected `float` >= 1.0"),
    ],
)
def test_sizes_have_lower_bounds(old, new, rule):
    """What nobody could see or wait for is refused, and the message has the bound."""
    with pytest.raises(BadInputError, match=rule):
        parse(changed(old, new), "x")


def test_a_world_scaled_down_is_refused():
    """Every length of a level divided by 1e150: its shape is the same, and nothing in it could be played."""
    level = msgspec.to_builtins(parse(GOOD, "x"))

    def scaled(value, key=""):
        if isinstance(value, dict):
            return {name: scaled(item, name) for name, item in value.items()}
        if isinstance(value, list):
            return [scaled(item, key) for item in value]
        return value * 1e-150 if key in {"radius", "half_width", "speed", "ground_radius"} else value

    with pytest.raises(msgspec.ValidationError, match="radius"):
        msgspec.convert(scaled(level), levels.Level)


LANE = """
[[rings]]
radius = 5.0
half_width = 0.2
half_angle = 70.0
count = 2
layers = -1
[[rings]]
radius = %r
half_width = 0.2
half_angle = 70.0
count = 2
layers = -1
phase = 90.0
"""


def lane(play: float) -> bytes:
    """A level with a lane between unbreakable rings, that much wider than the ball."""
    return (
        GOOD.decode().replace("radius = 3.0\nhalf_width = 0.4", "radius = 1.5\nhalf_width = 0.4") + LANE % (5.9 + play)
    ).encode()


@pytest.mark.parametrize(("play", "refused"), [(1.01, False), (0.99, True), (0.0, True), (-0.99, True), (-1.01, False)])
def test_a_lane_that_the_ball_just_fits_into_is_refused(play, refused):
    """From as much too narrow to as much too wide; what is narrower lets no ball in, what is wider lets it play."""
    least = checks.least_play(parse(GOOD, "x").ball)
    assert least >= 1e-3 * 0.25
    found = [rule for rule in checks.broken_rules(parse_unchecked(lane(play * least))) if "the lane between" in rule.rule]
    assert bool(found) is refused
    assert not found or found[0].key == "rings[1]"


@pytest.mark.parametrize(("play", "dropped"), [(1.05, False), (0.95, True)])
def test_the_least_play_is_what_a_tick_can_hold(play, dropped):
    """A ball that flies straight across the narrowest lane loses no part of a tick; in a narrower one it does."""
    spec = parse(GOOD, "x").ball
    gap = 2 * spec.radius + play * checks.least_play(spec)
    rings = Ring(5.0, 0.2, math.pi, 1), Ring(5.4 + gap, 0.2, math.pi, 1)
    ball = Ball(complex(5.2 + gap / 2, 0.0), complex(spec.speed, 0.0), spec.radius)
    arena = Arena((ball,), rings, ((PERMANENT,), (PERMANENT,)))
    lost = 0
    for _ in range(20):
        step = advance(arena, 1 / 240, spec.speed)
        arena, lost = step.arena, lost + step.dropped
    assert bool(lost) is dropped


@pytest.mark.parametrize(
    ("key", "value", "what"),
    [("radius = 5.0", "radius = 0.45", "the hole inside it"), ("half_angle = 70.0", "half_angle = 87.014", "a gate between")],
)
def test_holes_and_gates_that_the_ball_just_fits_into_are_refused(key, value, what):
    """For the same reason as lanes."""
    ring = LANE.partition("[[rings]]\nradius = %r")[0].replace(key, value)
    if "radius" in key:
        ring = ring.replace("half_width = 0.2", "half_width = 0.2001")
    level = parse_unchecked(GOOD + ring.encode())
    assert [broken for broken in checks.broken_rules(level) if what in broken.rule]


def test_the_lane_below_the_paddles_track_leaves_the_ball_some_play():
    """Just as lanes between rings do."""
    outer = 8.8 - 2 * 0.25  # of a ring under which the ball would just fit
    for below, refused in ((0.5, True), (1.5, False)):
        radius = outer - below * checks.least_play(parse(GOOD, "x").ball) - 0.4
        level = parse_unchecked(changed("radius = 3.0", f"radius = {radius!r}"))
        assert bool([broken for broken in checks.broken_rules(level) if "must fit below" in broken.rule]) is refused


def test_a_narrow_gate_is_allowed_and_warned_of():
    """Narrower than 1.5 balls: one of 1.02 held a ball for ten minutes. Wider ones and the built-in levels are fine."""
    for balls, warned in ((1.02, True), (1.49, True), (1.51, False), (6.0, False)):
        half_angle = 90.0 - math.degrees(math.asin(balls * 0.25 / 4.8))
        ring = LANE.partition("[[rings]]\nradius = %r")[0].replace("half_angle = 70.0", f"half_angle = {half_angle!r}")
        found = levels.warnings(parse(GOOD + ring.encode(), "x"))
        assert bool(found) is warned
        assert not found or f"rings[1]: its widest gate is {balls} balls wide" in found[0]
    assert not [line for level in classic() for line in levels.warnings(level)]


@pytest.mark.parametrize(
    "data",
    [
        GOOD + b'"' + b"k" * 900 + b'" = 1',
        GOOD.replace(b'"Test"', b'"' + b"n" * 900 + b'"'),
        GOOD + b'"a\\nb\\u001b[31m" = 1',
        b"a = 1\n" + b"x" * 900 + b" = 1\n" + b"x" * 900 + b" = 1",
        GOOD.replace(b"9.0\n[paddles]", b'"' + b"9" * 900 + b'"\n[paddles]'),
    ],
)
def test_messages_quote_little_and_stay_on_one_line(data):
    """At most 80 characters of a bad input, its line breaks and control characters as escapes."""
    with pytest.raises(BadInputError) as caught:
        parse(data, "level.toml")
    message = str(caught.value)
    assert message.isprintable()
    assert max(len(run.group()) for run in re.finditer(r"(.)\1*", message)) <= 80
    assert len(message) < 250


def test_a_level_hash_is_of_the_content_not_of_the_file():
    """Comments and the order of keys leave the hash alone; a changed number does not."""
    same = parse(b"# a comment\n" + GOOD, "x")
    other = parse(changed("speed = 9.0", "speed = 9.000000000000002"), "x")
    assert parse(GOOD, "x").content_hash() == same.content_hash() != other.content_hash()


def test_a_gap_wider_than_the_ball_opens_a_wall():
    """An unbreakable ring closes off what is inside exactly when the chord of its widest gap is below the ball's diameter."""
    wall = b"[[rings]]\nradius = 5.0\nhalf_width = 0.2\nhalf_angle = %s\ncount = 12\nlayers = -1\n"
    gap = 2 * 0.25 / 4.8  # radians, to first order of the chord
    for half_angle, open_ in ((15 - gap * 57.3 / 2 - 0.1, True), (15 - gap * 57.3 / 2 + 0.1, False)):
        data = GOOD + wall % str(half_angle).encode()
        assert (not list(checks.broken_rules(parse_unchecked(data)))) is open_


def parse_unchecked(data: bytes) -> levels.Level:
    """A level whose arena nobody has looked at."""
    return reading.msgspec.convert(reading._toml(data, "x"), levels.Level)


def test_the_files_of_the_levels_are_called_as_the_levels():
    """A file's name is the level's number in its folder and its name, in lower case with hyphens."""
    for folder, part, digits in (("campaign", campaign(), 2), ("classic", classic(), 1)):
        names = [level.name.casefold().replace(" ", "-") for level in part]
        expected = [f"{number:0{digits}}-{name}.toml" for number, name in enumerate(names, 1)]
        assert sorted(file.name for file in (ROOT / "game" / "levels" / folder).iterdir()) == expected


def test_a_game_ends_with_its_part_of_the_levels():
    """The campaign does not go on with the classic levels; a list of one's own is played to its end."""
    assert from_level(30, built_in()) == campaign()[30:]
    assert from_level(33, built_in()) == classic()[1:]
    own = (parse(GOOD, "good"),)
    assert from_level(0, own) == own
