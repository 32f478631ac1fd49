"""Which sounds an event makes, how loud and where, and that they never add up to too much."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from game.rules import HARMFUL, Event, EventKind, PowerUp
from game.sound.notes import Note, brick, every_note
from game.sound.patches import Patch
from game.sound.synth import waveform
from game.sound.tails import tail
from game.sound.voices import SILENCE, TAIL_STEP, VOICES, Cue, chorus, cues, panned
from physics import Contact, Feature, Hit

RATE = 8000
WAVES = {note: waveform(note, RATE) for note in every_note()}
TAILS = {note: tail(wave, RATE) for note, wave in WAVES.items()}
HITS = {EventKind.PADDLE_HIT, EventKind.BRICK_HIT, EventKind.WALL_HIT}

SILENT = frozenset({EventKind.LEVEL_STARTED, EventKind.DROP_LOST, EventKind.AIMED})

sides = st.floats(-1.0, 1.0)
some_cues = st.builds(Cue, st.sampled_from(every_note()), st.floats(0.5, 1.0), sides)
storms = st.lists(st.tuples(st.floats(0.0, 0.2), st.lists(some_cues, max_size=12)), max_size=12)


def side(position):
    """Where a position is heard, in an arena of ten units."""
    return position.real / 10.0


def hit(before=-5j, layers=0):
    return Hit(0.0, 0, 1, 0, Contact(1j, 0j, 0.0, Feature.OUTER_FACE), before, -before, layers)


def event(kind, position=0j, **of_hit):
    return Event(kind, hit(**of_hit) if kind in HITS else None, position=position)


def played(storm):
    """What the two ears are sent when cues come, each after a pause; and the most voices at once."""
    voices, now, ears, most = SILENCE, 0.0, np.zeros((2, 6 * RATE)), 0
    for pause, wanted in storm:
        now += pause
        voices, new = chorus(voices, wanted, TAILS, now)
        most = max(most, sum(voice is not None for voice in voices))
        for voice in [voices[channel] for channel in new]:
            wave, start = WAVES[voice.note], round(now * RATE)
            ears[:, start : start + len(wave)] += np.outer((voice.left, voice.right), wave)
    return ears, most


@pytest.mark.parametrize("kind", EventKind)
def test_every_event_but_a_few_has_a_sound(kind):
    """Every kind of event makes one sound; the start of a level, a drop that is lost and a turn that helps make none."""
    assert len(cues([event(kind)], side, 1)) == (kind not in SILENT)


def test_different_events_sound_different():
    """No two kinds of events share a sound."""
    notes = [cue.note for kind in EventKind for cue in cues([event(kind)], side, 1)]
    assert len(set(notes)) == len(notes) == len(EventKind) - len(SILENT)


def test_a_drop_that_harms_sounds_unlike_one_that_helps():
    """Caught narrow paddles and a fast ball have the sound of a trap, all else that of a gift."""
    for kind in PowerUp:
        (cue,) = cues([event(EventKind.DROP_CAUGHT)._replace(power=kind)], side, 1)
        assert cue.note.patch is (Patch.TRAP if kind in HARMFUL else Patch.GIFT)


def test_a_brick_sounds_of_its_number_in_the_row_and_of_what_is_left():
    """Two bricks in one frame are two steps of the scale, the later one as high as the combo says."""
    events = [event(EventKind.BRICK_HIT, layers=2), event(EventKind.BRICK_HIT, layers=0)]
    assert [cue.note for cue in cues(events, side, 5)] == [brick(4, 2), brick(5, 0)]


def test_a_row_ends_at_the_paddle():
    """A brick after the paddle is the first of a new row. How long the row before it was cannot be told: it counts as 1."""
    events = [event(EventKind.BRICK_HIT), event(EventKind.PADDLE_HIT), event(EventKind.BRICK_HIT)]
    assert [cue.note for cue in cues(events, side, 1)] == [brick(1, 0), Note(Patch.PADDLE), brick(1, 0)]


@pytest.mark.parametrize(
    ("small", "great", "patch"),
    [
        (EventKind.LEVEL_CLEARED, EventKind.GAME_WON, Patch.WON),
        (EventKind.BALL_LOST, EventKind.GAME_OVER, Patch.OVER),
    ],
)
def test_the_greater_news_is_heard_alone(small, great, patch):
    """Winning replaces the sound of the cleared level, the end of the game that of the lost ball; a brick is still heard."""
    events = [event(EventKind.BRICK_HIT), event(small), event(great)]
    assert [cue.note.patch for cue in cues(events, side, 1)] == [Patch.BRICK, patch]


def test_a_graze_is_softer_than_a_hit_straight_on():
    """A graze has half the gain of a hit straight on, and at 45 degrees it is in between."""
    gains = [cues([event(EventKind.WALL_HIT, before=v)], side, 0)[0].gain for v in (5.0, 5.0 - 5.0j, -5j)]
    assert gains == pytest.approx([0.5, 0.5 + 0.5 * math.sqrt(0.5), 1.0])


@given(sides)
def test_panning_keeps_the_power_and_mirrors(side):
    """Left and right squared are 1 together everywhere; the other side swaps the ears."""
    left, right = panned(side)
    assert left**2 + right**2 == pytest.approx(1.0)
    assert panned(-side) == pytest.approx((right, left))
    assert (right > left) == (side > 0.0) or side == pytest.approx(0.0)


def test_panning_follows_the_position():
    """The further right, the louder in the right ear; at the rim both ears still hear it, and beyond it is as at the rim."""
    xs = [-1000.0, -10.0, -5.0, 0.0, 5.0, 10.0, 1000.0]
    rights = [panned(cues([event(EventKind.BALL_LOST, x + 3j)], side, 0)[0].side)[1] for x in xs]
    assert all(less < more for less, more in itertools.pairwise(rights[1:-1]))
    assert rights[0] == rights[1] > 0.1
    assert rights[-1] == rights[-2] < 0.99


@pytest.mark.parametrize("note", [Note(Patch.WON), Note(Patch.NUDGE), brick(3, 1)])
def test_a_tail_bounds_what_is_still_to_come(note):
    """No later sample is larger than the tail says; the tail begins at the peak, never rises and ends at 0."""
    wave, levels = WAVES[note], np.array(TAILS[note])
    at = (np.arange(len(wave)) / (RATE * TAIL_STEP)).astype(int)
    assert np.all(np.abs(wave) <= levels[at])
    assert levels[0] == np.max(np.abs(wave))
    assert np.all(np.diff(levels) <= 0.0)
    assert levels[-1] == 0.0


@settings(max_examples=50)
@given(storms)
@example([(0.0, [Cue(note, 1.0, -1.0) for note in every_note()])] * 8)
def test_no_storm_of_sounds_clips(storm):
    """Whatever comes at once, neither ear is sent more than full scale, and no more than VOICES voices sound."""
    ears, most = played(storm)
    assert np.max(np.abs(ears)) <= 1.0
    assert most <= VOICES


def test_three_bricks_at_once_are_heard_in_full():
    """Three bricks in one instant have full gain; a fourth is softer, a fifth is left out."""
    wanted = [Cue(brick(combo, 0), 1.0, side) for combo, side in ((1, -0.5), (2, 0.0), (3, 0.3), (4, 0.5), (5, 0.0))]
    voices, new = chorus(SILENCE, wanted, TAILS, 0.0)
    powers = [voices[channel].left ** 2 + voices[channel].right ** 2 for channel in new]
    assert powers[:3] == pytest.approx([1.0, 1.0, 1.0])
    assert len(powers) == 4
    assert 0.09 < powers[3] < 0.5


def test_news_is_heard_through_any_number_of_hits():
    """A lost ball is heard in full while bricks sound, and before the hits of its own frame."""
    hits = [Cue(note, 1.0, 0.0) for note in every_note() if note.patch is Patch.BRICK]
    crowd = chorus(SILENCE, hits, TAILS, 0.0).voices
    news = Cue(Note(Patch.LOST), 1.0, 0.0)
    for before, wanted in ((crowd, [news]), (SILENCE, [*hits, news])):
        voices, new = chorus(before, wanted, TAILS, 0.005)
        first = voices[new[0]]
        assert first.note == Note(Patch.LOST)
        assert first.left == pytest.approx(math.sqrt(0.5))


def test_one_note_is_not_struck_twice_at_once():
    """Two hits of walls in a frame make one sound, and none 20 ms later; 60 ms later there is another."""
    wanted = [Cue(Note(Patch.WALL), 1.0, 0.0)]
    voices, new = chorus(SILENCE, wanted * 2, TAILS, 0.0)
    assert len(new) == 1
    assert chorus(voices, wanted, TAILS, 0.02).new == ()
    assert len(chorus(voices, wanted, TAILS, 0.06).new) == 1


def test_a_voice_is_free_again_when_its_sound_has_ended():
    """While the sound lasts its voice is taken; afterwards all voices are free."""
    wanted = [Cue(brick(1, 3), 1.0, 0.0)]
    voices, _ = chorus(SILENCE, wanted, TAILS, 0.0)
    assert chorus(voices, [], TAILS, 0.15).voices == voices
    assert chorus(voices, [], TAILS, 0.25).voices == SILENCE
