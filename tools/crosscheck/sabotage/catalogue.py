"""Every deliberate mistake by its name, and those that no game can show."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from inspect import getdoc
from typing import NamedTuple

from tools.crosscheck.sabotage import in_bounces, in_contacts, in_levels, in_ticks

Change = Callable[[], AbstractContextManager[None]]


class Mistake(NamedTuple):
    """One deliberate mistake.

    change: makes it while its block runs. invisible: why no comparison can see it; empty for those that must be caught.
    """

    name: str
    change: Change
    invisible: str = ""

    @property
    def sentence(self) -> str:
        """What is wrong."""
        return getdoc(self.change) or self.name


_INVISIBLE = {
    in_bounces.far_graze: (
        "the rule acts only where a bounce leaves a convex surface with less than 1e-8 of the speed along the normal, and the "
        "velocity then changes by less than that: a graze that no game and no aimed contact comes near"
    ),
    in_bounces.early_stop: (
        "a resulting velocity of 1e-10 of the speed needs a surface that retreats at exactly half the ball's speed, to 1e-10"
    ),
}

_CHANGES: tuple[Change, ...] = (
    in_contacts.rotated_normal,
    in_contacts.reversed_inner_normal,
    in_contacts.swapped_end,
    in_contacts.sources_end,
    in_contacts.corner_as_end,
    in_contacts.point_of_the_middle,
    in_contacts.face_called_inner,
    in_contacts.late_touch,
    in_contacts.early_touch,
    in_contacts.wrong_inner_border,
    in_contacts.narrower_sectors,
    in_contacts.resting_rings,
    in_contacts.larger_ball,
    in_contacts.no_corners,
    in_contacts.no_turning_ends,
    in_contacts.slanted_hits_only,
    in_contacts.ghost_bricks,
    in_contacts.fast_rings,
    in_bounces.still_surface,
    in_bounces.weak_mirror,
    in_bounces.reversed_friction,
    in_bounces.no_friction,
    in_bounces.more_friction_inside,
    in_bounces.less_friction_on_ends,
    in_bounces.lossy_speed,
    in_bounces.stale_speed,
    in_bounces.speed_at_the_centre,
    in_bounces.reversed_spin,
    in_bounces.one_of_two,
    in_bounces.crooked_double_bounce,
    in_bounces.far_separation,
    in_bounces.no_separation,
    in_bounces.far_graze,
    in_bounces.early_stop,
    in_ticks.two_layers,
    in_ticks.lasting_bricks,
    in_ticks.soft_walls,
    in_ticks.neighbours_brick,
    in_ticks.quiet_break,
    in_ticks.dropped_bounce,
    in_ticks.long_clear_time,
    in_ticks.jump_at_ends,
    in_ticks.silent_jump,
    in_ticks.rest_after_a_hit,
    in_ticks.unrecorded_hit,
    in_ticks.doubled_hit,
    in_levels.slippery_paddles,
    in_levels.thicker_bricks,
    in_levels.slower_bricks,
    in_levels.one_layer_more,
)


def _mistake(change: Change) -> Mistake:
    """A mistake named after the function that makes it."""
    return Mistake(change.__name__.replace("_", "-"), change, _INVISIBLE.get(change, ""))


MISTAKES = {mistake.name: mistake for mistake in map(_mistake, _CHANGES)}
"""By the name on the command line."""
