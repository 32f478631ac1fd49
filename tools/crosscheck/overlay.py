"""What pymunk says of the contacts of one tick: for the game to draw beside its own normals."""

import cmath

from game.rules import TICK, Ticked
from game.second_opinion import NormalPair
from physics import Hit
from tools.crosscheck.comparisons.hit_frame import geometry_of
from tools.crosscheck.comparisons.rules import MOST_BOUNCES
from tools.crosscheck.games.level_numbers import numbers_of_level
from tools.crosscheck.games.trajectory import Leg, Tick, flight_paths
from tools.crosscheck.pymunk_model.ring_model import ring_model

_FACETS = 3
"""Per arc: the exact shapes answer, and no chord is made."""


def opinions(ticked: Ticked) -> tuple[NormalPair, ...]:
    """Both normals at every hit of a tick, in the order of time. The ball's position comes from its flight alone."""
    tick = Tick(ticked.game.tick, ticked.moving, TICK, ticked.step, numbers_of_level(ticked.game.level))
    legs = {id(leg.hit): leg for path in flight_paths(tick, MOST_BOUNCES) for leg in path.legs if leg.hit is not None}
    layers = [list(slots) for slots in tick.arena.layers]
    found = []
    for hit in ticked.step.hits:
        found.append(_opinion(tick, hit, legs[id(hit)], layers[hit.ring]))
        layers[hit.ring][hit.slot] = hit.layers
    return tuple(found)


def _opinion(tick: Tick, hit: Hit, leg: Leg, layers: list[int]) -> NormalPair:
    """Both normals at one hit. layers: of the ring's slots just before it."""
    ring = tick.arena.rings[hit.ring]
    model = ring_model(geometry_of(ring), _FACETS)
    model.set_alive(layers)
    turn = cmath.rect(1.0, ring.phase + ring.spin * hit.time)
    touch = model.exact(leg.end * turn.conjugate(), 1.5 * tick.arena.balls[hit.ball].radius)
    return NormalPair(hit.contact.point, hit.contact.normal, None if touch is None else touch.normal * turn)
