"""Every tolerance of the physics, with its unit, its reason and what breaks if it changes."""

TOUCH = 1e-14
"""Fraction of the distance from the centre to the ring's outer face plus the ball. A gap this small counts as touching.

Evaluating a gap in an arena of size 1 carries about 1e-15 of rounding. Below that, the search for a time of impact would
chase noise; above 1e-13, the promised accuracy of an impact would be lost. It is a fraction, so that an arena scaled by a
power of two plays the same game to the bit.
"""

OVERLAP = 1e-10
"""Fraction of the ball's radius. A deeper overlap was not left by a bounce: the ball was put there, and is pushed out.

Bounces leave at most about TOUCH of the arena's size; the promise is 1e-9 of the radius.
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

PARALLEL = 1e-6
"""Radians. Two surfaces touched at the same moment whose normals differ by less, or by pi less so much, are one, or a lane.

Smaller, and rounding of their normals decides how a ball bounces off both.
"""

MAX_IMPACTS = 32
"""Impacts of one ball in one tick. What is left of the tick after them is dropped, and counted.

A bounce off two sectors at once is one impact, with two hits.

The longest chain in a game's tick is 4; only a squeezed ball comes here.
"""

MAX_STEPS = 64
"""Steps of one search for the touch of a turning end. Searches built to be slow were seen to take 36, those of a game 8."""

ANGLE_GRID = 2.0**50
"""Grid lines per radian for every stored angle: see `physics.trig.on_angle_grid`."""

JOINT = 8.0 / ANGLE_GRID
"""Radians. Two sectors of a closed ring belong together up to so wide a gap: twice what rounding leaves at their joint.

Larger, and a real gap of a millionth of a millionth of a millimetre would be closed; smaller, and a flush joint has corners.
"""

ANGLE_SLACK = 1e-9
"""Radians. What is added to the angle that a ball may cover, to say how long it touches nothing: far above rounding."""

CLEARANCE = 1e-9
"""Fraction of the distances on a flight. How much larger a ball is taken to be, to say how long it touches nothing.

Far above the rounding of many ticks: a tick that is spared the search would have found nothing. Smaller than 1e-13,
it might have.
"""

LARGEST = 1e35
"""World units, units per second, or radians per second. No size, place or speed may exceed it.

The search for a touch multiplies up to eight such numbers: the product must stay below the largest float, 1.8e308.
"""

SMALLEST = 1e-35
"""World units, units per second, or radians per second. A radius, width or speed above 0 may not be smaller.

Products of up to eight such numbers must stay above the smallest float of full precision, 2.2e-308, or they would count as 0.
"""
