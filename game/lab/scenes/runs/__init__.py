"""Scenes that run: whole flights, tick by tick."""

from game.lab.scenes.runs import (
    discrete_swept,
    falling_stack,
    free_run,
    game_over_once,
    nudge,
    own_arena,
    source_game,
    squeezed,
    symmetry,
)

SCENES = (
    discrete_swept.SCENE,
    source_game.SCENE,
    falling_stack.SCENE,
    squeezed.SCENE,
    symmetry.SCENE,
    free_run.SCENE,
    game_over_once.SCENE,
    nudge.SCENE,
    own_arena.SCENE,
)
"""In the order of the lab's list."""
