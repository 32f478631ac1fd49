"""The course as it is being attended: the task that is open, the answer that was given, what is done."""

from typing import Any, NamedTuple

from game.lab.course.course import TASKS
from game.lab.course.tasks import Exercise, GoalState, Question, Task
from game.lab.kit.parameters import Given


class AttendedCourse(NamedTuple):
    """How far somebody is.

    number: of the task that is open. done: names of tasks. chosen: the answer to the question; None before it is answered.
    """

    number: int
    done: frozenset[str]
    chosen: int | None = None

    @property
    def task(self) -> Task:
        """The one that is open."""
        return TASKS[self.number]


def attended(done: frozenset[str]) -> AttendedCourse:
    """The course at its first task that is not done; at the first where all are."""
    return AttendedCourse(next((number for number, task in enumerate(TASKS) if task.name not in done), 0), done)


def turned(course: AttendedCourse, step: int) -> AttendedCourse:
    """So many tasks on, round the end."""
    return AttendedCourse((course.number + step) % len(TASKS), course.done)


def answered(course: AttendedCourse, choice: int) -> AttendedCourse:
    """After an answer to the open question; a choice that there is not changes nothing."""
    task = course.task
    if not isinstance(task, Question) or choice >= len(task.choices):
        return course
    right = choice == task.right
    return course._replace(chosen=choice, done=course.done | {task.name} if right else course.done)


def observed(course: AttendedCourse, scene: str, given: Given, state: Any) -> tuple[AttendedCourse, GoalState | None]:
    """After a look at the scene: an exercise whose goal is reached is done. scene: the name of the one that is open."""
    task = course.task
    if not isinstance(task, Exercise) or scene != task.line.partition("?")[0]:
        return course, None
    state_of_goal = task.goal(given, state)
    return (course._replace(done=course.done | {task.name}) if state_of_goal.reached else course), state_of_goal


def lines(course: AttendedCourse, goal: GoalState | None) -> tuple[str, ...]:
    """What is to be read: the task, its choices or how near its goal is, and what follows from an answer."""
    task = course.task
    head = f"{course.number + 1} of {len(TASKS)}, slide {task.slide}.  {task.text}"
    if isinstance(task, Exercise):
        now = "" if goal is None else f"now: {goal.measured}"
        reached = task.name in course.done
        return (head, f"{'Reached!  ' if reached else ''}{now}", *(("] goes on",) if reached else ()))
    choices = [f"{place + 1}  {choice}" for place, choice in enumerate(task.choices)]
    if course.chosen is None:
        return (head, *choices)
    verdict = "Right." if course.chosen == task.right else f"No, it is: {task.choices[task.right]}."
    return (head, f"{verdict}  {task.why}", "] goes on")
