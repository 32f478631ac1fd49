"""The scenes, a folder for each chapter: first the source's, in its order, then what goes beyond it."""

from game.lab.scenes import angles, broad_phase, narrow_phase, response, runs, time_of_impact

SCENES = (
    *angles.SCENES,
    *broad_phase.SCENES,
    *narrow_phase.SCENES,
    *response.SCENES,
    *time_of_impact.SCENES,
    *runs.SCENES,
)
