"""Collision response: the velocity after a bounce."""

from game.lab.scenes.response import axis_slip, carried, friction, moving_surface, response_paddle, response_wall, stopped_dead

SCENES = (
    response_wall.SCENE,
    moving_surface.SCENE,
    response_paddle.SCENE,
    friction.SCENE,
    axis_slip.SCENE,
    stopped_dead.SCENE,
    carried.SCENE,
)
"""In the order of the lab's list."""
