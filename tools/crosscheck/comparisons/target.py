"""Comparison e: what was hit? Which ring, slot and feature, and how many layers are left, by pymunk's shapes and the level."""

import cmath
from collections.abc import Sequence

from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.diagnosis import with_article
from tools.crosscheck.comparisons.hit_frame import CheckedTick, Moment, angle_between
from tools.crosscheck.games.level_numbers import UNBREAKABLE, LevelNumbers
from tools.crosscheck.pymunk_model import rounding
from tools.crosscheck.pymunk_model.ring_model import ModelShape, Part
from tools.crosscheck.results.measurements import FEATURE_OF_PART, Compared, Comparison, ContactVerdict


class LayerBook:
    """How many layers every slot must have: the level's, less those that hits took where pymunk touches.

    layers: per ring and slot.
    """

    def __init__(self, level: LevelNumbers) -> None:
        """At the start of a level."""
        self.layers = [list(ring.layers) for ring in level.rings]

    def take_one(self, ring: int, slot: int) -> int:
        """Take a layer from a slot; how many are left."""
        left = self.layers[ring][slot]
        if left > 0:
            left -= 1
            self.layers[ring][slot] = left
        return left

    def differs_from(self, layers: Sequence[Sequence[int]]) -> str | None:
        """The first slot whose layers are not those of the game, in words."""
        for ring, (own, games) in enumerate(zip(self.layers, layers, strict=True)):
            for slot, (left, claimed) in enumerate(zip(own, games, strict=True)):
                if left != claimed:
                    return f"ring {ring}, slot {slot} has {_words(claimed)} in the game, {_words(left)} by the hits"
        return None

    def take_over(self, layers: Sequence[Sequence[int]]) -> None:
        """The game's own layers, after a difference has been reported."""
        self.layers = [list(ring) for ring in layers]


def compare_target(check: ContactCheck, checked: CheckedTick, book: LayerBook) -> None:
    """Compare the game's ring, slot and feature with the shapes that pymunk finds nearest, and take a layer from the slot."""
    assert check.touched is not None
    moment, hit, touched = check.moment, check.moment.hit, check.touched
    near = moment.model.exact_near(moment.local, touched.distance + moment.contact_noise)
    slots = {shape.slot for shape, _ in near} | {touched.shape.slot}
    slot = hit.slot if hit.slot in slots else touched.shape.slot
    wrong = []
    other = _nearer_ring(checked, moment, touched.distance)
    if other is not None:
        wrong.append(f"the game names ring {hit.ring}, pymunk touches ring {other} first")
    if hit.slot != slot:
        wrong.append(f"the game names slot {hit.slot}, pymunk touches slot {slot}")
    feature = moment.claimed_feature
    if feature != FEATURE_OF_PART[touched.shape.part] and not _on_a_border(moment, near, feature):
        pymunks = with_article(FEATURE_OF_PART[touched.shape.part])
        wrong.append(f"the game names {with_article(feature)}, pymunk {pymunks}")
    left = book.take_one(hit.ring, slot)
    if hit.layers != left:
        wrong.append(f"the game leaves {_words(hit.layers)}, the level's numbers {_words(left)}")
    verdict = ContactVerdict.UNEXPLAINED if wrong else ContactVerdict.EXACT
    what = "; ".join(wrong) or "ring, slot, feature and layers"
    check.measure(Compared(Comparison.TARGET, verdict, what, float(len(wrong)), 0.0))


def _nearer_ring(checked: CheckedTick, moment: Moment, distance: float) -> int | None:
    """Another ring that pymunk finds certainly nearer to the ball than the one that the game names."""
    tick, hit = checked.tick, moment.hit
    from_centre = abs(moment.position)
    for k, model in enumerate(checked.models):
        geometry = model.geometry
        noise = rounding.contact_noise(max(geometry.outer, moment.model.geometry.outer), moment.ball_radius)
        nearer = distance - noise
        if k == hit.ring or not model.living or abs(from_centre - geometry.radius) - geometry.half_width >= nearer:
            continue
        ring = tick.arena.rings[k]
        local = moment.position * cmath.rect(1.0, -(ring.phase + ring.spin * hit.time))
        found = model.nearest_exact(local, distance)
        if found is not None and found[1] < nearer:
            return k
    return None


def _on_a_border(moment: Moment, near: list[tuple[ModelShape, float]], feature: str) -> bool:
    """Whether a shape of the feature that the game names is as near, and its normal is the game's."""
    ours = moment.hit.contact.normal
    for shape, distance in near:
        if FEATURE_OF_PART[shape.part] == feature:
            normal = moment.model.contact(moment.local, distance, shape).normal
            if angle_between(ours, moment.world(normal)) <= moment.normal_noise:
                return shape.part != Part.END or _beside_the_end(moment, shape, normal)
    return False


def _beside_the_end(moment: Moment, shape: ModelShape, normal: complex) -> bool:
    """Whether a normal is that of an end's own line, and not that of its corner, which pymunk gives beyond the line."""
    own = complex(*shape.shape.normal)
    return min(angle_between(normal, own), angle_between(normal, -own)) <= moment.normal_noise


def _words(layers: int) -> str:
    """Layers as people say it."""
    return "no brick" if layers == 0 else "an unbreakable sector" if layers == UNBREAKABLE else f"{layers} layers"
