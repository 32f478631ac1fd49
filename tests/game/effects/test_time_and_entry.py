"""Slow motion before the last brick, and the wall that is built up at a level's start."""

from game.autopilot import Autopilot
from game.effects import ALL, EffectKind, Effects, LightSource, after, at_start
from game.effects.entry import ENTRY_TICKS
from game.effects.slow_motion import SLOWEST, pace
from game.levels import classic
from game.picture.slots.contents import ContentKind, slot_contents
from game.rules import (
    ActivePower,
    Controls,
    EventKind,
    Phase,
    PowerUp,
    Ruleset,
    layers_left,
    new_game,
    tick,
)
from game.scene import scene_at, still


def test_time_slows_down_only_just_before_the_last_brick():
    """With more than one layer left the pace is 1; then it is slow for less than a quarter of a second."""
    game, pilot = new_game(classic()[:2], 3, Ruleset()), Autopilot()
    slow = 0
    while game.phase != Phase.CLEARED:
        now = pace(game)
        assert now == 1.0 or layers_left(game) == 1
        slow = slow + 1 if now == SLOWEST else 0
        game = tick(game, pilot.controls(game)).game
    assert 5 < slow <= 0.22 * 240 + 1
    assert pace(game) == 1.0


def entering(ticks, shown=ALL, controls=Controls()):  # noqa: B008  # immutable
    """A level's first ticks: the scene at the end."""
    game, effects = new_game(classic()[4:], 1), Effects()
    for _ in range(ticks):
        done = tick(game, controls)
        game, effects = done.game, after(effects, done, shown)
    return scene_at(done, 1.0, effects)


def standing(scene):
    """How many bricks are to be seen."""
    return sum(content.kind is ContentKind.BRICKS for ring in slot_contents(scene)[1:] for content in ring)


def test_the_wall_is_built_up_brick_by_brick():
    """More and more bricks are seen, at last all of them without any glow; to the rules they are there from the first tick."""
    seen = [standing(entering(ticks)) for ticks in range(1, ENTRY_TICKS + 60, 20)]
    whole = sum(count > 0 for ring in entering(1).layers[1:] for count in ring)
    assert seen == sorted(seen)
    assert (seen[0], seen[-1]) == (1, whole) or (seen[0] < 3 and seen[-1] == whole)
    assert not any(content.glow for ring in slot_contents(entering(ENTRY_TICKS + 60)) for content in ring)


def test_before_the_first_tick_nothing_of_the_wall_is_seen():
    """The first picture of a new game does not show the wall before it is built up."""
    game = new_game(classic()[4:], 1)
    assert standing(scene_at(still(game), 1.0, at_start(ALL))) <= standing(entering(1))
    assert standing(scene_at(still(game), 1.0, at_start(ALL - {EffectKind.ENTRY}))) == 18


def test_the_last_brick_shines():
    """The last layer has a light, again and again; no layer before it has one."""
    game, pilot, shown, lit = new_game(classic()[:2], 3, Ruleset()), Autopilot(), Effects(), []
    while game.phase != Phase.CLEARED:
        done = tick(game, pilot.controls(game))
        game, shown = done.game, after(shown, done, frozenset({EffectKind.LIGHTS}))
        good = [light for light in shown.lights if light.source is LightSource.GOOD]
        assert not good or layers_left(game) <= 1
        lit += [light.position for light in good if light.age == 1]
    ring = game.arena.rings[1]
    assert lit
    assert all(abs(abs(position) - ring.radius) < 1e-9 for position in lit)


def test_nobody_waits_for_the_wall():
    """With the first serve it stands; and for players who want no entry it stands from the beginning."""
    whole = sum(count > 0 for ring in entering(1).layers[1:] for count in ring)
    assert standing(entering(40, controls=Controls(serve=True))) == whole
    assert standing(entering(5, ALL - {EffectKind.ENTRY})) == whole


def test_a_hit_that_two_events_tell_is_shown_once():
    """A ball that sticks to a paddle is a hit and a catch; one paddle flashes, and one burst of sparks flies."""
    game, pilot, shown = new_game(classic(), 1, Ruleset()), Autopilot(), Effects()
    for _ in range(4000):
        sticky = game._replace(powers=(ActivePower(PowerUp.STICKY, 900, 900),)) if game.phase == Phase.PLAYING else game
        done = tick(sticky, pilot.controls(game))
        game, shown = done.game, after(Effects(), done)
        if any(event.kind == EventKind.BALL_CAUGHT for event in done.events):
            break
    assert any(event.kind == EventKind.PADDLE_HIT for event in done.events)
    assert (len(shown.flashes), len(shown.bursts), len(shown.lights)) == (1, 1, 1)
