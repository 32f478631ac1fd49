"""Broad phase: which ring, and which of its sectors, can the ball touch?"""

from game.lab.scenes.broad_phase import broad_phase, nearest_sector

SCENES = (
    broad_phase.SCENE,
    nearest_sector.SCENE,
)
"""In the order of the lab's list."""
