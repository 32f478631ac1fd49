"""Captions: the sounds that matter, in words."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pytest

from game.drawing.camera import Camera
from game.levels import classic
from game.overlay import captions
from game.overlay.captions import SECONDS, Caption
from game.rules import Event, EventKind, new_game
from game.scene import still
from game.sound.voices import _PATCHES

CAMERA = Camera(400 + 300j, 30.0)


def after(*events, shown=()):
    """The captions after a tick with some events."""
    ticked = still(new_game(classic(), 1))
    return captions.after(shown, ticked._replace(events=tuple(events)), CAMERA)


def test_the_same_sound_counts_on_and_the_newest_is_last():
    """Bricks are counted in one line, and each caption is shown for its time after the last of them."""
    brick = Event(EventKind.BRICK_HIT, position=1 + 1j)
    shown = captions.later(after(brick), 2.0)
    assert [one.left for one in shown] == [pytest.approx(SECONDS - 2.0)]
    shown = after(brick, Event(EventKind.LIFE_GAINED), shown=shown)
    assert [one.text for one in shown] == ["brick struck ×2", "extra life"]
    assert captions.later(shown, SECONDS) == ()


@pytest.mark.parametrize(("position", "where"), [(5, "right"), (5j, "above"), (-5 - 5j, "lower left"), (-5j, "below")])
def test_a_lost_ball_says_where(position, where):
    """On the screen, from the arena's centre."""
    assert after(Event(EventKind.BALL_LOST, position=complex(position)))[0].text == f"ball lost, {where}"


def test_every_event_that_sounds_has_words_or_is_seen_at_the_paddle():
    """What is left out is what one looks at all the time."""
    quiet = {EventKind.PADDLE_HIT, EventKind.NUDGED, EventKind.LEVEL_STARTED, EventKind.BALLS_MET, EventKind.AIMED}
    sounding = {*_PATCHES, EventKind.BRICK_HIT} - quiet - {EventKind.BALL_RELEASED}
    for kind in sounding:
        assert Caption(kind, None).text
