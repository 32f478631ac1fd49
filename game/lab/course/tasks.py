"""What the course asks: questions with a choice of answers, and exercises with a goal."""

from collections.abc import Callable
from typing import Any, NamedTuple

from game.lab.kit.parameters import Given


class Question(NamedTuple):
    """A question about a scene.

    name: in the file of progress. slide: of the source, which it is about. line: the share line that it begins with.
    choices: answers to choose from, of which `right` is the index of the right one. why: said afterwards.
    """

    name: str
    slide: int
    line: str
    text: str
    choices: tuple[str, ...]
    right: int
    why: str


class GoalState(NamedTuple):
    """How near a scene is to a goal. measured: in a few words, with a number."""

    reached: bool
    measured: str


class Exercise(NamedTuple):
    """A scene to be brought to a goal.

    name, slide, line: as of `Question`. goal: of the scene's values and its state. solution: a share line that reaches it.
    """

    name: str
    slide: int
    line: str
    text: str
    goal: Callable[[Given, Any], GoalState]
    solution: str


Task = Question | Exercise
