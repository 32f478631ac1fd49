"""Polar coordinates and angles."""

from game.lab.scenes.angles import angle_difference, on_left, polar

SCENES = (
    polar.SCENE,
    angle_difference.SCENE,
    on_left.SCENE,
)
"""In the order of the lab's list."""
