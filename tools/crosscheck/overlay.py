"""What pymunk says of the contacts of one tick: for the game to draw beside its own normals."""

import cmath

from game.rules import TICK, Ticked
from game.second_opinion import NormalPair
from physics import Hit
from tools.crosscheck.comparisons.hit_frame import geometry_of
from tools.crosscheck.games.trajectory import Leg, Tick, layers_before, paths
from tools.crosscheck.pymunk_model.ring_model import RingModel, ring_model

FACETS = 64
"""Per arc, where no exact shape exists: the inner faces."""


def opinions(ticked: Ticked) -> tuple[NormalPair, ...]:
    """Both normals at every hit of a tick, in the order of time. The ball's place comes from its flight alone."""
    tick = Tick(ticked.game.tick, ticked.moving, TICK, ticked.game.level.ball.speed, ticked.step)
    legs = {id(leg.hit): leg for path in paths(tick) for leg in path.legs if leg.hit is not None}
    return tuple([_opinion(tick, hit, legs[id(hit)]) for hit in ticked.step.hits])


def _opinion(tick: Tick, hit: Hit, leg: Leg) -> NormalPair:
    """Both normals at one hit."""
    ring = tick.arena.rings[hit.ring]
    model: RingModel = ring_model(geometry_of(ring), FACETS)
    model.set_alive(layers_before(tick, hit)[hit.ring])
    turn = cmath.rect(1.0, ring.phase + ring.spin * hit.time)
    place, reach = leg.end * turn.conjugate(), 1.5 * tick.arena.balls[hit.ball].radius
    touch = model.exact(place, reach) or model.faceted(place, reach)
    return NormalPair(hit.contact.point, hit.contact.normal, None if touch is None else touch.normal * turn)
