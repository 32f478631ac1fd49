"""Level files: what is accepted, and how everything else is refused in one line."""

import re
from pathlib import Path

import pytest

from game import levels
from game.levels import built_in, chosen, load_file, parse
from game.rules import bricks_left, new_game
from game.system.errors import BadInputError
from physics import PERMANENT
from tests.support.level_text import GOOD, changed


def test_the_good_level_is_good():
    """Without a change, the level that the tests below break is accepted."""
    assert parse(GOOD, "x").rings[0].slots() == (1,) * 12


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (changed('name = "Test"', "name = 7"), r"name: Expected `str`, got `int`"),
        (changed('name = "Test"', ""), r"missing required field `name`"),
        (changed('name = "Test"', 'name = "Test"\nraduis = 3.0'), r"unknown field `raduis`; did you mean `radius`\?"),
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
            r"rings\[0\]: level cannot be completed: rings\[1\] leaves the ball no way in",
        ),
        (b"name = \nb = 1", r"not valid TOML; .*line 1, column 8"),
        (b"a = 1\na = 2\n", r"not valid TOML; .*line 2"),
        (b"\xff\xfe", r"not UTF-8 at byte 0"),
        (b"\xef\xbb\xbf" + GOOD, r"not valid TOML"),
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
    """A number and a name start there and go on; a file stands alone."""
    assert chosen("3") == built_in()[2:]
    assert chosen("carousel") == built_in()[3:]
    own = tmp_path / "own.toml"
    own.write_bytes(GOOD)
    assert [level.name for level in chosen(str(own))] == ["Test"]
    for wrong in ("0", "99", "-1", "", "nothing", "9" * 5000):
        with pytest.raises(BadInputError, match="no such level"):
            chosen(wrong)


def test_the_levels_differ_in_kind():
    """There are at least five levels: a single ring, several, gaps, turning rings, stacks of three and more, unbreakables."""
    kinds = {
        "single": [len(level.rings) == 1 for level in built_in()],
        "several": [len(level.rings) >= 3 for level in built_in()],
        "gaps": [any(0 in ring.slots() for ring in level.rings) for level in built_in()],
        "turning": [any(ring.spin != 0.0 for ring in level.rings) for level in built_in()],
        "stacks": [any(max(ring.slots()) >= 3 for ring in level.rings) for level in built_in()],
        "unbreakable": [any(PERMANENT in ring.slots() for ring in level.rings) for level in built_in()],
    }
    assert len(built_in()) >= 5
    assert all(any(found) and not all(found) for found in kinds.values())


def test_the_arena_has_what_the_level_says():
    """Bricks and paddles of the arena are those of the file, in radians."""
    for number, level in enumerate(built_in()):
        game = new_game(built_in()[number:], 0)
        layers = [count for ring in level.rings for count in ring.slots()]
        assert bricks_left(game) == sum(count for count in layers if count > 0)
        assert game.arena.rings[0].count == level.paddles.count
        assert len(game.arena.rings) == 1 + len(level.rings)


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
        assert (not list(levels._broken_rules(parse_unchecked(data)))) is open_


def parse_unchecked(data: bytes) -> levels.Level:
    """A level whose arena nobody has looked at."""
    return levels.msgspec.convert(levels._toml(data, "x"), levels.Level)
