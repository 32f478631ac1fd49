"""What the game adds to a mirror, as its description says it. Stated here once more, so that a change there is noticed."""

import math

MOST_BOUNCES = 32
"""Bounces of one ball in one tick; what is left of the tick after them is dropped."""

LEAST_SEPARATION = 1e-3
"""Fraction of the ball's speed by which it leaves an inner face, or a turning end, faster than the surface."""

LEAST_GRAZE = 1e-9
"""The same for outer faces and ends at rest, which cannot meet the ball again."""

STOPPED = 1e-12
"""Fraction of the ball's speed. A shorter velocity has no direction: the ball leaves along the normal."""

MOST_LEANING = math.radians(75.0)
"""Radians from the straight line to the centre that the arcade rules' turn of a returned ball does not exceed."""

AIM_MOST = math.radians(60.0)
"""Radians: the most that they turn it further, towards a brick, after a long wait."""

WIDEST = 0.8
"""Share of the circle that paddles cover at most, unless those of the level's file cover more."""

TURN_NOISE = 1e-12
"""Radians: rounding of three angles, far above 1e-15 and far below anything that could be seen."""

TOGETHER = 1e-10
"""Fraction of the ball's radius. Two sectors that the ball touches to within this much at once are answered by one bounce."""
