"""Scenes of the lab for tests: one that counts its ticks, and the state of any scene at a tick."""

from game.lab.kit.parameters import defaults
from game.lab.kit.scene import Motion, started, stepped
from game.lab.registry import scene_named


def counting_scene(limit=10):
    """A scene that runs; its state is the number of ticks since its start, and its note says it."""
    still = scene_named("polar")
    shown = still.shows(defaults(still.parameters))
    motion = Motion(lambda _: 0, lambda _, state: state + 1, lambda _, state: shown._replace(note=str(state)), ticks=limit)
    return still._replace(shows=motion)


def state_at(scene, given, tick):
    """The state of a scene at a tick."""
    state = started(scene, given)
    for _ in range(tick):
        state = stepped(scene, given, state)
    return state
