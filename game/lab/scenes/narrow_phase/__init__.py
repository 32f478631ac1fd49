"""Narrow phase: where are the ball and one sector nearest?"""

from game.lab.scenes.narrow_phase import case_1, case_2, closest_point, gap_field, inside_material

SCENES = (
    closest_point.SCENE,
    case_1.SCENE,
    case_2.SCENE,
    gap_field.SCENE,
    inside_material.SCENE,
)
"""In the order of the lab's list."""
