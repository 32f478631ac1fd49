"""Bricks that grow again, rings that turn round: what a boss and moving gaps are made of."""

import pytest

from game.levels import parse, warnings
from game.rules import EventKind, Phase, layers_left
from game.rules.crumbling import CRUMBLING_TICKS
from game.rules.regrow import play_ticks
from game.system.errors import BadInputError
from physics import direction
from tests.support.games.arcade import EVERYTHING, GOOD, after, arcade, kinds, until, with_balls

BOSS = GOOD + b"[[rings]]\nradius = 5.0\nhalf_width = 0.3\nhalf_angle = 9.0\ncount = 18\nregrow = 2.0\n"
QUIET = ((7.0j, 1.0 + 0.1j),)


def with_layers(game, ring, layers):
    """The game with other layers in a ring."""
    changed = (*game.arena.layers[:ring], tuple(layers), *game.arena.layers[ring + 1 :])
    return game._replace(arena=game.arena._replace(layers=changed))


def held_still(game, ticks, flights=QUIET):
    """The game some ticks later, its balls always at the same position, and the events."""
    seen = []
    for _ in range(ticks):
        number = game.phase_tick
        game, events = after(with_balls(game, *flights)._replace(phase_tick=number), 1)
        seen += events
    return game, seen


def test_missing_bricks_grow_again_one_after_the_other():
    """Every two seconds of play one layer of the first that is missing, not higher than at the start."""
    game = with_layers(arcade(parse(BOSS, "x")), 2, [1] * 5 + [0] * 3 + [1] * 10)
    game, events = held_still(with_balls(game, *QUIET), 479)
    assert EventKind.BRICK_REGROWN not in kinds(events)
    for grown in (6, 7, 8):
        game, events = held_still(game, 480 if grown > 6 else 1)
        assert kinds(events).count(EventKind.BRICK_REGROWN) == 1
        assert game.arena.layers[2] == (1,) * grown + (0,) * (8 - grown) + (1,) * 10
    game, events = held_still(game, 480)
    assert events == []


def test_gaps_of_the_level_stay_open():
    """Only what the level had grows: not its empty slots."""
    level = parse(
        BOSS.replace(b"regrow = 2.0", b"regrow = 2.0\nlayers = [0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"), "x"
    )
    game = with_layers(arcade(level), 2, [0] * 6 + [1] * 12)
    game, _ = held_still(with_balls(game, *QUIET), 480 * 4)
    assert game.arena.layers[2] == level.rings[1].slots()


def test_no_brick_grows_where_a_ball_is():
    """The next missing one grows instead."""
    game = with_layers(arcade(parse(BOSS, "x")), 2, [1] * 5 + [0] * 3 + [1] * 10)
    inside = direction(game.arena.rings[2].angle(5)) * 5.0
    game, _ = held_still(with_balls(game, *QUIET), 479)
    game, events = held_still(game, 1, ((inside, inside),))
    assert EventKind.BRICK_REGROWN in kinds(events)
    assert game.arena.layers[2][4:8] == (1, 0, 1, 0)


def test_the_wall_falls_with_what_it_guards():
    """The last brick of the others broken, all that would grow again is gone: the level is cleared."""
    game = arcade(parse(BOSS, "x"))
    game = with_layers(with_layers(game, 1, [1] + [0] * 11), 2, [0] + [1] * 17)
    done = until(with_balls(game, (4.0 + 0j, -1.0)), EventKind.CORE_BROKEN, 60)
    assert {EventKind.BRICK_HIT, EventKind.LEVEL_CLEARED} <= set(kinds(done.events))
    assert layers_left(done.game) == 0
    assert done.game.phase == Phase.WON
    assert done.game.statistics.level.bricks == 1


def test_a_ring_reverses():
    """Every so many seconds of play, in the tick that is due, and by nothing but the sign of its spin."""
    level = parse(GOOD.replace(b"count = 12", b"count = 12\nspin = 30.0\nreverse = 0.5"), "x")
    game = with_balls(arcade(level), *QUIET)
    spins = []
    for _ in range(360):
        game, _ = held_still(game, 1)
        spins.append(game.arena.rings[1].spin)
    first = spins[0]
    assert spins == [first] * 119 + [-first] * 120 + [first] * 120 + [-first]


def test_time_stands_still_between_balls():
    """Ticks of play are counted over all serves of a level; while the ball waits, nothing grows."""
    game = with_layers(arcade(parse(BOSS, "x")), 2, [0] * 18)
    game, _ = held_still(with_balls(game, *QUIET), 300)
    outward = direction(0.7)
    game, _ = after(with_balls(game, (outward * 10.3, outward))._replace(phase_tick=300), 1)
    assert (game.phase, play_ticks(game)) == (Phase.SERVING, 301)
    game, events = after(game, 1000)
    assert (events, play_ticks(game)) == ([], 301)
    game, events = held_still(with_balls(game, *QUIET), 179)
    assert kinds(events) == [EventKind.BRICK_REGROWN]


@pytest.mark.parametrize(
    ("old", "new", "rule"),
    [
        ("count = 12", "count = 12\nregrow = 1.0", r"rings\[0\].regrow: level cannot be completed"),
        ("count = 12", "count = 12\nreverse = 1.0", r"rings\[0\].reverse: the ring does not turn"),
        ("count = 12", "count = 12\nbumper = true", r"rings\[0\].layers: a bumper cannot break"),
        ("speed = 9.0", "speed = 9.0\ntop_speed = 8.0", "ball.top_speed: must be from ball.speed 9"),
        ("speed = 9.0", "speed = 9.0\ngrowth = 0.6", "ball.growth"),
        ("acceleration = 400.0", "acceleration = 400.0\nturn = 61", "paddles.turn"),
        ("count = 12", 'count = 12\n[drops]\nkinds = ["wide", "wide"]', "drops.kinds: names a power-up twice"),
        ("count = 12", 'count = 12\n[drops]\nkinds = ["wides"]', "drops.kinds.*'wides'"),
        ("count = 12", "count = 12\n[drops]\nchances = 0.5", "unknown field `chances`; did you mean `chance`"),
        ("count = 12", 'count = 12\n[look]\npalette = "mauve"', "look.palette"),
    ],
)
def test_what_cannot_be_played_is_refused(old, new, rule):
    """By key and rule."""
    with pytest.raises(BadInputError, match=rule):
        parse(GOOD.decode().replace(old, new, 1).encode(), "x")


def test_new_keys_leave_the_hash_of_old_levels_alone():
    """A level that does not use them has the hash that recorded games know; one that does has another."""
    plain = parse(GOOD, "x")
    assert plain.content_hash() == "280c729d6daa42d9f44765457bb5e3d07d44c6f3eb9ad71ad97a3ef75c91d58e"
    assert parse(GOOD + b"[drops]\nchance = 0.12\n", "x").content_hash() == plain.content_hash()
    for text in (b"[drops]\nchance = 0.2\n", b'[look]\npalette = "ember"\n'):
        assert parse(GOOD + text, "x").content_hash() != plain.content_hash()


def test_what_is_tedious_is_warned_of():
    """A line for each, and none for what is fine."""
    keys = [line.partition(":")[0] for line in warnings(EVERYTHING)]
    assert keys == ["drops.chance", "wells[0].reach", "wells[1].reach"]
    assert warnings(parse(BOSS.replace(b"regrow = 2.0", b"regrow = 0.4"), "x"))[0].startswith("rings[1].regrow: below 0.5 s")
    assert warnings(parse(BOSS, "x")) == []


def test_after_nine_seconds_without_a_brick_the_nearest_one_loses_a_layer():
    """It gives no points and is no part of a combo; the next one falls nine seconds later."""
    game = with_balls(arcade(parse(BOSS, "x")), *QUIET)._replace(waited=CRUMBLING_TICKS - 1)
    later, events = after(game, 1)
    assert kinds(events) == [EventKind.BRICK_CRUMBLED]
    assert layers_left(later) == layers_left(game) - 1
    assert (later.score, later.combo, later.waited) == (game.score, game.combo, 0)
    ring = game.arena.rings[1]
    nearest = min([abs(direction(ring.angle(slot)) * ring.radius - 7.0j) for slot in range(ring.count)])
    assert abs(events[0].position - 7.0j) == pytest.approx(nearest, abs=0.02), "of the ring that does not grow again"
    assert kinds(after(with_balls(later, *QUIET), 1)[1]) == []
