"""What is to be seen for a moment, and that none of it reaches the rules."""

import cmath
import itertools
import math

import pytest

from game import effects
from game.autopilot import Autopilot
from game.effects import ALL, FLASH_TICKS, LONGEST, NOTHING, PLAIN, POP_TICKS, EffectKind, Effects, bursts
from game.effects.bursts import Matter
from game.effects.hit_stop import hit_stop_seconds
from game.effects.recoils import RECOIL_TICKS, Recoil
from game.effects.shakes import SHAKE_TICKS, Shake
from game.effects.streaks import BUMP_TICKS, ENDED_TICKS, NO_STREAK
from game.effects.waves import WaveTone
from game.levels import classic
from game.rules import BEST_COMBO, PADDLES, Controls, Drop, Event, EventKind, Phase, PowerUp, Ruleset, new_game, tick
from game.rules.crumbling import CRUMBLING_TICKS
from game.rules.powers import MOST_LIVES
from physics import PERMANENT, Hit, contact, direction


def played(count, shown=ALL, level=0, seed=5):
    """Pairs of a tick and the effects after it."""
    game, pilot, fading = new_game(classic()[level:], seed), Autopilot(), Effects()
    for _ in range(count):
        done = tick(game, pilot.controls(game))
        fading = effects.after(fading, done, shown)
        yield done, fading
        game = done.game


def lost(count=2400):
    """The same for a game whose player does nothing but serve and hold a key."""
    game, fading = new_game(classic(), 1), Effects()
    for number in range(count):
        done = tick(game, Controls(turn=1, serve=number > 200))
        fading = effects.after(fading, done)
        yield done, fading
        game = done.game


def happened(done, kind):
    """Whether something of a kind happened in a tick."""
    return any(event.kind == kind for event in done.events)


def test_a_hit_flashes_and_fades():
    """Every hit leaves a flash of its slot, which is gone after FLASH_TICKS."""
    since, hits = None, 0
    for done, fading in played(3000):
        if done.step.hits and done.game.phase == Phase.PLAYING:
            hit = done.step.hits[-1]
            assert (fading.flashes[-1].ring, fading.flashes[-1].slot) == (hit.ring, hit.slot)
            since, hits = done.game.tick, hits + 1
        elif since is not None and done.game.tick - since > FLASH_TICKS + 1:
            assert fading.flashes == ()
        assert all(0.0 <= flash.age < 1.0 for flash in fading.flashes)
    assert hits > 5


def test_a_ring_answers_only_when_a_brick_goes():
    """Hits of paddles and steel send no light around their ring; light around a ring can be seen without flashes."""
    answered = {True: 0, False: 0}
    for done, fading in played(4000, level=5):
        for hit in done.step.hits:
            answers = [flash.echoed for flash in fading.flashes if flash.age == 0.0 and flash.slot == hit.slot]
            assert answers == [hit.ring > 0 and hit.layers != PERMANENT] * len(answers)
            answered[answers[0]] += 1
    assert min(answered.values()) > 3
    assert any(fading.flashes for _, fading in played(1500, frozenset({EffectKind.RING})))
    assert all(not flash.lit for _, fading in played(1500, frozenset({EffectKind.RING})) for flash in fading.flashes)


def test_points_pop_where_the_brick_was_hit():
    """The words are the points of the event, at its position, and last for POP_TICKS."""
    for done, fading in played(3000):
        scored = [event for event in done.events if event.points]
        if scored:
            assert fading.pops[-1].text == f"+{scored[-1].points}"
            assert fading.pops[-1].position == scored[-1].position
            break
    ages = [fading.pops[0].age for _, fading in played(3000) if fading.pops]
    assert max(ages) > 1.0 - 2.0 / POP_TICKS


def test_points_weigh_more_the_longer_the_row():
    """The weight grows from the first brick to the best combo, and no two pops are too close to be read."""
    weights = {}
    for done, fading in played(6000, level=4):
        if happened(done, EventKind.BRICK_HIT):
            weights[min(done.game.combo, BEST_COMBO)] = fading.pops[-1].weight
        good = [pop.position for pop in fading.pops if not pop.bad]
        assert all(abs(one - other) > 1.0 for one, other in itertools.combinations(good, 2))
    assert weights == {combo: combo / BEST_COMBO for combo in weights}
    assert len(weights) > 4


def test_without_effects_only_the_trail_is_left():
    """For players who want no effects there is nothing but the trail."""
    trails = 0
    for _, fading in played(1500, PLAIN):
        assert fading == NOTHING._replace(trails=fading.trails, steady=frozenset())
        trails += bool(fading.trails)
    assert trails


ELSEWHERE = frozenset({EffectKind.HIT_STOP, EffectKind.SHAKE, EffectKind.SLOW_MOTION, EffectKind.DEPTH, EffectKind.SWIRL})
"""Effects that this shows nothing of: they change the clock, the colours, or how what is there moves."""


@pytest.mark.parametrize("kind", sorted(ALL - ELSEWHERE))
def test_each_effect_is_seen_only_when_it_is_wanted(kind):
    """An effect that is on alone shows something; with all others on and it off, its part is empty."""
    alone = [fading._replace(steady=frozenset()) for _, fading in played(1500, frozenset({kind}), level=3)]
    assert any(fading != NOTHING for fading in alone)
    seen = {name for fading in alone for name, part in fading._asdict().items() if part != getattr(NOTHING, name)}
    assert len(seen) == 1
    without = [fading for _, fading in played(1500, ALL - {kind}, level=3)]
    if kind not in {EffectKind.FLASH, EffectKind.RING, EffectKind.SHARDS, EffectKind.SPARKS}:  # these pairs share a part
        assert all(getattr(fading, name) == getattr(NOTHING, name) for fading in without for name in seen)


def test_a_trail_follows_its_ball_and_ends_with_it():
    """The trail's newest point is near the ball; there is none while no ball is in play."""
    for done, fading in played(2000):
        if done.game.phase != Phase.PLAYING:
            assert fading.trails == ()
        else:
            reach = done.game.level.ball.speed / 240.0 * 5
            for trail, ball in zip(fading.trails, done.game.arena.balls, strict=True):
                assert len(trail) <= 17
                assert abs(trail[-1] - ball.position) <= reach


def test_a_lost_ball_is_named_bursts_and_shakes():
    """A lost ball leaves bad news, pieces where it left, a shake away from the centre, and waves of bad news."""
    done, fading = next(pair for pair in lost() if pair[0].game.lives < 3)
    (event,) = [event for event in done.events if event.kind == EventKind.BALL_LOST]
    assert (fading.pops[-1].text, fading.pops[-1].bad) == ("lost", True)
    assert fading.bursts[-1].matter is Matter.BALL
    assert fading.shake.direction == pytest.approx(event.position / abs(event.position))
    assert {wave.tone for wave in fading.waves} == {WaveTone.BAD}
    assert hit_stop_seconds(done) > 0.0


def test_everything_fades():
    """LONGEST ticks after the last event nothing is left but a streak that goes on."""
    since = 0
    for done, fading in lost(6000):
        since = 0 if done.events else since + 1
        if since > LONGEST and done.game.phase != Phase.PLAYING:
            assert fading._replace(steady=frozenset()) == NOTHING
    assert since > LONGEST


def test_what_is_seen_does_not_depend_on_how_long_ago_one_began_to_look():
    """Effects that are followed for the last LONGEST ticks alone are the same as those followed from the game's start."""
    pairs = list(played(2600, level=4))
    for end in range(700, 2600, 380):
        late = effects.after_all([done for done, _ in pairs[end - LONGEST : end]])
        assert late._replace(streak=NO_STREAK, trails=()) == pairs[end - 1][1]._replace(streak=NO_STREAK, trails=())


def test_bursts_are_bounded_and_told_apart():
    """There are never more than MOST; each has its own seed; bricks give shards, steel and paddles give sparks."""
    seeds, matters = {}, set()
    for done, fading in played(6000, level=5):
        assert len(fading.bursts) <= bursts.MOST
        for burst in fading.bursts:
            assert 0 <= burst.age < bursts.lifetime(burst.matter)
            seeds.setdefault((burst.seed, burst.matter), done.game.tick - burst.age)
            assert seeds[(burst.seed, burst.matter)] == done.game.tick - burst.age
            matters.add(burst.matter)
            assert (burst.layer > 0) == (burst.matter is Matter.BRICK)
    assert matters == {Matter.BRICK, Matter.PADDLE, Matter.STEEL}


def test_a_struck_paddle_gives_way_outwards_and_comes_back():
    """A recoil goes outwards first, never far inwards, and ends at rest; the paddle of the rules does not move."""
    recoil = Recoil(0, 0.5)
    path = [recoil._replace(age=age).out for age in range(RECOIL_TICKS + 1)]
    assert path[0] == 0.0
    assert all(out > 0.0 for out in path[1:30])
    assert 0.15 < max(path) < 0.5
    assert min(path) > -0.2 * max(path)
    assert abs(path[-1]) < 0.02 * max(path)
    reaches = [recoil.strength for _, fading in played(2400) for recoil in fading.recoils]
    assert reaches
    assert all(0.0 <= reach <= 0.6 for reach in reaches)


def test_a_shake_dies_down():
    """The swings of a shake grow smaller, and at its end they are too small to be seen."""
    shake = Shake(1j, 0.03)
    sizes = [abs(shake._replace(age=age).offset) for age in range(SHAKE_TICKS + 1)]
    assert sizes[0] == 0.03
    peaks = [max(sizes[start : start + 20]) for start in range(0, SHAKE_TICKS, 20)]
    assert peaks == sorted(peaks, reverse=True)
    assert peaks[-1] < 0.002


def test_a_row_is_counted_and_remembered_for_a_moment_after_its_end():
    """A streak has the rules' combo and begins anew with each brick; after a paddle's hit it fades and is gone."""
    fresh = ended = 0
    for done, fading in played(6000, level=4):
        streak = fading.streak
        if happened(done, EventKind.BRICK_HIT) and done.game.combo:
            assert (streak.bricks, streak.age, streak.ended) == (done.game.combo, 0, False)
            fresh += 1
        elif streak.ended:
            assert streak.age <= ENDED_TICKS
            ended += 1
        else:
            assert streak.bricks == done.game.combo
    assert fresh > 10
    assert ended > 100
    assert BUMP_TICKS < ENDED_TICKS < LONGEST


def test_waves_stay_on_the_ground():
    """Over some games there are circles of every tone, and none is ever larger than the ground."""
    tones = set()
    for done, fading in itertools.chain(played(400), lost(3000), played(60_000)):
        for wave in fading.waves:
            assert 0.0 <= wave.radius <= done.game.level.ground_radius
            tones.add(wave.tone)
        if tones == set(WaveTone):
            break
    assert tones == set(WaveTone)


def test_the_game_stands_still_on_great_moments_alone():
    """It stands still for a lost ball, a cleared level and the best combo alone, and at most for a sixth of a second."""
    kinds = set()
    for done, _ in itertools.chain(lost(3000), played(40_000)):
        stop = hit_stop_seconds(done)
        assert 0.0 <= stop <= 1.0 / 6.0
        if stop:
            assert done.game.combo == BEST_COMBO or {event.kind for event in done.events} & {
                EventKind.BALL_LOST,
                EventKind.LEVEL_CLEARED,
                EventKind.GAME_OVER,
            }
            kinds.update(event.kind for event in done.events)
        else:
            assert not happened(done, EventKind.BALL_LOST)
            assert not happened(done, EventKind.LEVEL_CLEARED)
    assert {EventKind.BALL_LOST, EventKind.LEVEL_CLEARED} <= kinds


def test_a_recoil_is_as_strong_as_the_hit_is_square():
    """The strength is proportional to the share of the ball's speed that goes outwards."""
    seen = {}
    for done, fading in played(4000):
        for event in done.events:
            if event.kind == EventKind.PADDLE_HIT:
                outwards = (event.hit.before * event.position.conjugate()).real / abs(event.position) / abs(event.hit.before)
                seen[outwards] = fading.recoils[-1].strength
    shares = sorted(seen)
    assert len(shares) > 3
    assert [seen[share] for share in shares] == sorted(seen.values())
    assert math.isclose(seen[shares[-1]], shares[-1] * 0.055 * 10.0, rel_tol=1e-9)


SHOWN_OTHERWISE = {
    EventKind.AIMED: "the paddle's hit has been told",
    EventKind.BALL_CAUGHT: "the paddle's hit has been told",
    EventKind.DROP_RELEASED: "the drop itself",
    EventKind.POWER_ENDED: "its arc beyond the rim is gone",
    EventKind.GAME_WON: "the last level is cleared in the same tick",
}
"""Events that leave nothing of their own, and what is seen instead."""


@pytest.mark.parametrize("kind", sorted(set(EventKind) - set(SHOWN_OTHERWISE)))
def test_every_event_is_seen(kind):
    """An event leaves something that is not there without it."""
    game = tick(new_game(classic(), 1), Controls(serve=True)).game
    done = tick(game, Controls())
    struck = Hit(0.0, 0, PADDLES, 0, contact(game.arena.balls[0], game.arena.rings[PADDLES], 0), -1j, 1j, PERMANENT)
    hits = (EventKind.PADDLE_HIT, EventKind.BRICK_HIT, EventKind.WALL_HIT, EventKind.BUMPER_HIT)
    sector = (1, 0) if kind in (EventKind.BRICK_CRUMBLED, EventKind.BRICK_REGROWN) else None
    event = Event(kind, struck if kind in hits else None, 10, 5j, PowerUp.WIDE, sector)
    quiet, seen = done._replace(events=()), done._replace(events=(event,))
    assert effects.after(NOTHING, seen) != effects.after(NOTHING, quiet)


def test_a_layer_that_crumbles_is_seen_to_break():
    """Shards of its colour come from its sector, light falls around it, and the rest of its stack comes down."""
    game = tick(new_game(classic()[4:], 1, Ruleset()), Controls(serve=True)).game
    done = tick(game._replace(waited=CRUMBLING_TICKS), Controls())
    fading = effects.after(NOTHING, done)
    (event,) = [event for event in done.events if event.kind == EventKind.BRICK_CRUMBLED]
    ring, slot = event.sector
    left = done.game.arena.layers[ring][slot]
    assert left == game.arena.layers[ring][slot] - 1
    (burst,) = [burst for burst in fading.bursts if burst.matter is Matter.BRICK]
    assert burst.layer == left + 1
    assert abs(cmath.rect(burst.origin.radius, burst.origin.angle) - event.position) < 1e-9
    assert [light.layer for light in fading.lights if light.position == event.position] == [left + 1]
    assert [(stack.ring, stack.slot) for stack in fading.falling] == ([(ring, slot)] if left else [])


def test_a_won_game_has_more_fireworks():
    """Five times, one after the other, and then there is nothing left of them; a level that is not the last one has none."""
    for phase, times in ((Phase.WON, 5), (Phase.CLEARED, 0)):
        game, fading, seen = new_game(classic()[-2:], 1)._replace(phase=phase), NOTHING, 0
        for _ in range(1000):
            done = tick(game, Controls())
            game, fading = done.game, effects.after(fading, done)
            seen += any(burst.age == 0 for burst in fading.bursts)
        assert seen == times
        assert fading.bursts == ()


@pytest.mark.parametrize(("lives", "words"), [(3, ["extra life"]), (MOST_LIVES, [])])
def test_a_caught_life_is_told_once_and_only_if_there_is_one(lives, words):
    """Who has all lives that one may have is told nothing."""
    game = tick(new_game(classic(), 1, Ruleset()), Controls(serve=True)).game._replace(lives=lives)
    outward = direction(game.arena.rings[PADDLES].angle(0))
    drop = Drop(PowerUp.LIFE, outward * game.arena.rings[PADDLES].inner_radius, outward)
    done = tick(game._replace(drops=(drop,)), Controls())
    assert happened(done, EventKind.DROP_CAUGHT)
    assert [pop.text for pop in effects.after(NOTHING, done).pops] == words
