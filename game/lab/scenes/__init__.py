"""The scenes, a folder for each chapter: first the source's, in its order, then what goes beyond it."""

from game.lab.scenes import angles, broad_phase, narrow_phase, response, runs, time_of_impact

CHAPTERS = (angles, broad_phase, narrow_phase, response, time_of_impact, runs)
SCENES = tuple([scene for chapter in CHAPTERS for scene in chapter.SCENES])
