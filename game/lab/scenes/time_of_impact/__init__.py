"""Time of impact: when does a moving ball first touch a sector?"""

from game.lab.scenes.time_of_impact import impact_resting, impact_turning, two_bricks

SCENES = (
    impact_resting.SCENE,
    impact_turning.SCENE,
    two_bricks.SCENE,
)
"""In the order of the lab's list."""
