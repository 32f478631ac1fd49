"""pymunk's normals beside the game's, as the player sees them."""

import math

import pytest

from game import second_opinion
from game.replays.file import played
from game.second_opinion import SHOWN_TICKS, NormalPair
from physics import Feature
from tests.support.games.players import KeyPlayer, MousePlayer
from tests.support.games.recordings import recorded
from tools.crosscheck import overlay


@pytest.fixture(scope="module")
def hits():
    """Every hit of two games, with both normals."""
    found = []
    for player in (MousePlayer(3), KeyPlayer(4)):
        for ticked in played(recorded(player, 4000)[0]):
            if ticked.step.hits:
                found.extend(zip(ticked.step.hits, overlay.opinions(ticked), strict=True))
    return found


def test_pymunk_agrees_on_every_contact(hits):
    """The two normals are the same to rounding, on every feature: pymunk has an exact shape for each."""
    assert len(hits) > 20
    for hit, opinion in hits:
        assert opinion.ours == hit.contact.normal
        assert opinion.point == hit.contact.point
        assert opinion.angle <= 1e-12, hit


def test_a_wrong_normal_is_seen(hits):
    """A normal turned by a degree is shown as a degree."""
    hit, pair = next(found for found in hits if found[0].contact.feature != Feature.INNER_FACE)
    turned = pair._replace(ours=hit.contact.normal * complex(math.cos(math.radians(1)), math.sin(math.radians(1))))
    assert turned.text == "1.00°"
    assert pair._replace(theirs=None).text == "pymunk: no contact"


def test_normals_are_shown_for_their_time(hits):
    """A contact's normals are shown for SHOWN_TICKS; the other engine is not asked about a tick without a hit."""

    def nobody(_):
        raise AssertionError

    quiet = next(ticked for ticked in played(recorded(MousePlayer(3), 10)[0]) if not ticked.step.hits)
    shown: tuple[NormalPair, ...] = (hits[0][1],)
    for _ in range(SHOWN_TICKS - 2):
        shown = second_opinion.after(shown, quiet, nobody)
    assert len(shown) == 1
    for _ in range(3):
        shown = second_opinion.after(shown, quiet, nobody)
    assert shown == ()
