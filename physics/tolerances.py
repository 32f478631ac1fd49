"""Every tolerance of the physics, with its unit, its reason and what breaks if it changes."""

TOUCH = 1e-13
"""World units. A gap this small counts as touching, so the search for a time of impact may stop.

Evaluating a gap in an arena of size 10 carries about 1e-14 of rounding: below that, the search would chase
noise; above 1e-12, the promised accuracy of an impact would be lost.
"""

OVERLAP = 1e-10
"""Fraction of the ball's radius. A deeper overlap was not left by a bounce: the ball was put there, and is pushed out.

Bounces leave at most about TOUCH; the promise is 1e-9 of the radius.
"""

STOPPED = 1e-12
"""Fraction of the ball's speed. A shorter resulting velocity is rounding noise around 0: its direction means nothing.

Too small, and a ball stopped dead by a retreating paddle leaves in a random direction.
"""

LEAST_SEPARATION = 1e-3
"""Fraction of the ball's speed. A ball leaves an inner face, or a turning end, at least this much faster than the surface.

Slower than that, a ball that rolls along a concave arc, or is carried by the end of a paddle, would touch
infinitely often in a finite time (Zeno). It bends a grazing bounce by less than 0.06 degrees.
"""

LEAST_GRAZE = 1e-9
"""Fraction of the ball's speed. As LEAST_SEPARATION, for surfaces that cannot meet the ball again: outer faces, ends at rest.

Without it, rounding can leave a grazing ball approaching after its bounce, and it would bounce again at once.
"""

MAX_IMPACTS = 32
"""Impacts of one ball in one tick. What is left of the tick after them is dropped, and counted.

The longest chain in a game's tick is 4; only a squeezed ball comes here.
"""

MAX_STEPS = 64
"""Steps of one search for the touch of a turning end. Searches built to be slow were seen to take 36, those of a game 8."""

ANGLE_GRID = 2.0**50
"""Grid lines per radian for a ring's stored phase.

2 pi as a float lies on this grid and so does every float from 4 to 8, so -phase is exact: a mirrored arena stays
mirrored to the bit.
"""

ANGLE_SLACK = 1e-9
"""Radians. What is added to the angle that a ball may cover, to say how long it touches nothing: far above rounding."""

CLEARANCE = 1e-9
"""Fraction of the distances on a flight. How much larger a ball is taken to be, to say how long it touches nothing.

Far above the rounding of many ticks: a tick that is spared the search would have found nothing. Smaller than 1e-13,
it might have.
"""

LARGEST = 1e100
"""World units, or units per second. Squares of larger numbers would overflow; no size, place or speed may exceed it."""
