"""What fades."""

from game import effects
from game.autopilot import Autopilot
from game.effects import ALL, FLASH_TICKS, PLAIN, POP_TICKS, Effects
from game.levels import built_in
from game.rules import Controls, Phase, new_game, tick


def played(count, shown=ALL):
    """Pairs of a tick and the effects after it."""
    game, pilot, fading = new_game(built_in(), 5), Autopilot(), Effects()
    for _ in range(count):
        done = tick(game, pilot.controls(game))
        fading = effects.after(fading, done, shown)
        yield done, fading
        game = done.game


def test_a_hit_flashes_and_fades():
    """Every hit leaves a flash of its slot, which is gone after its time."""
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


def test_points_pop_where_the_brick_was_hit():
    """The words are the points of the event, at its place, for their time."""
    for done, fading in played(3000):
        scored = [event for event in done.events if event.points]
        if scored:
            assert fading.pops[-1].text == f"+{scored[-1].points}"
            assert fading.pops[-1].position == scored[-1].position
            break
    ages = [fading.pops[0].age for _, fading in played(3000) if fading.pops]
    assert max(ages) > 1.0 - 2.0 / POP_TICKS


def test_without_effects_only_the_trail_is_left():
    """Players who want nothing to flash get nothing but the trail."""
    trails = 0
    for _, fading in played(1500, shown=PLAIN):
        assert fading.flashes == fading.pops == ()
        trails += bool(fading.trails)
    assert trails


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


def test_a_lost_ball_is_named():
    """A ball that leaves without a paddle in its way leaves a word of bad news."""
    game, fading = new_game(built_in(), 1), Effects()
    for number in range(2000):
        done = tick(game, Controls(turn=1, serve=number > 200))
        fading = effects.after(fading, done)
        game = done.game
        if game.lives < 3:
            assert fading.pops[-1].text == "lost"
            assert fading.pops[-1].bad
            return
    raise AssertionError("no ball was lost")
