"""Giving up a ball that no paddle reaches: when it is offered, and what it costs."""

import pygame
import pytest

from game.levels import classic
from game.rules import LIVES, TICK, Controls, Event, EventKind, Phase, new_game, tick
from game.screens.play import screen as play
from game.screens.play.screen import PlayScreen
from tests.support.windows.dummy_window import FRAME, Desk, shared


def served():
    """A game with a ball in play."""
    return tick(new_game(classic(), 3), Controls(serve=True)).game


def test_a_ball_given_up_costs_a_life():
    """It counts as lost, once, where it was; the next one waits to be served."""
    game = served()
    done = tick(game, Controls(give_up=True))
    assert [event.kind for event in done.events] == [EventKind.BALL_LOST]
    assert abs(done.events[0].position - game.arena.balls[0].position) < 0.1
    assert (done.game.lives, done.game.phase) == (LIVES - 1, Phase.SERVING)


def test_the_last_ball_given_up_ends_the_game():
    """As the last ball lost does."""
    game = served()._replace(lives=1)
    done = tick(game, Controls(give_up=True))
    assert [event.kind for event in done.events] == [EventKind.BALL_LOST, EventKind.GAME_OVER]
    assert done.game.phase == Phase.OVER


@pytest.mark.parametrize("phase", [phase for phase in Phase if phase != Phase.PLAYING])
def test_without_a_ball_in_play_there_is_nothing_to_give_up(phase):
    """The tick is the same with and without it."""
    game = new_game(classic(), 3)._replace(phase=phase)
    assert tick(game, Controls(give_up=True)) == tick(game, Controls())


@pytest.fixture
def playing(monkeypatch):
    """A game in play whose offer comes after a tenth of a second, and what its recorder was told."""
    monkeypatch.setattr(play, "_OFFER_TICKS", 24)
    told = []
    kept = shared(recorder=lambda controls, after: told.append((controls, after)))
    desk = Desk(kept, PlayScreen(kept, classic()))
    desk.told = told
    desk.press(pygame.K_SPACE)
    yield desk
    desk.close()


def test_it_is_offered_after_twenty_seconds():
    """Of the game's time."""
    assert pytest.approx(20.0) == play._OFFER_TICKS * TICK


def test_the_key_does_nothing_before_it_is_offered(playing):
    """Nobody loses a ball by a wrong key."""
    playing.press(pygame.K_g)
    assert not any(controls.give_up for controls, _ in playing.told)
    assert playing.screen._may_give_up is False


def test_the_key_gives_up_the_ball_once_it_is_offered(playing):
    """The offer is on the screen, the recorder is told of one tick that gives up, and the count begins anew."""
    drawn = pygame.Surface((640, 400))
    playing.wait(0.15)
    assert playing.screen._may_give_up
    playing.screen.draw(drawn)
    offered = pygame.image.tobytes(drawn, "RGB")
    playing.screen._untouched = 0
    playing.screen.draw(drawn)
    assert pygame.image.tobytes(drawn, "RGB") != offered
    playing.screen._untouched = 24
    playing.press(pygame.K_g)
    playing.wait(FRAME)
    assert sum(controls.give_up for controls, _ in playing.told) == 1
    assert playing.told[-1][1].lives == LIVES - 1
    assert not playing.screen._may_give_up


def test_a_paddle_takes_the_offer_back(playing, monkeypatch):
    """A touch, and the ball is within reach again."""
    playing.wait(0.15)
    assert playing.screen._may_give_up
    hit = play.tick

    def touched(game, controls, advance):
        done = hit(game, controls, advance)
        return done._replace(events=(*done.events, Event(EventKind.PADDLE_HIT)))

    monkeypatch.setattr(play, "tick", touched)
    monkeypatch.setattr(play.effects, "after", lambda effects, *_: effects)
    playing.wait(FRAME)
    assert not playing.screen._may_give_up
