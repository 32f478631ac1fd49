"""The guided course: its goals can be reached, its questions have one right answer, and what is done is kept."""

import pygame
import pytest

from game.lab.course.attended import answered, attended, lines, observed, turned
from game.lab.course.course import TASKS
from game.lab.course.progress import course_progress, keep_done
from game.lab.course.tasks import Exercise, Question
from game.lab.kit.scene import picture_of, started
from game.lab.session.share import parsed
from game.lab.window import screen
from game.lab.window.lesson import Lesson
from tests.support.windows.dummy_window import FRAME
from tests.support.windows.lab_desk import LabDesk

EXERCISES = [task for task in TASKS if isinstance(task, Exercise)]
QUESTIONS = [task for task in TASKS if isinstance(task, Question)]


@pytest.mark.parametrize("task", EXERCISES, ids=lambda task: task.name)
def test_a_goal_is_not_reached_at_first_and_can_be_reached(task):
    """The exercise's own line does not reach its goal; its solution, in the same scene and in every range, does."""
    for line, reached in ((task.line, False), (task.solution, True)):
        shared = parsed(line)
        assert task.goal(shared.given, started(shared.scene, shared.given)).reached is reached
    assert parsed(task.solution).scene is parsed(task.line).scene


def test_the_course_follows_the_slides_and_has_enough_to_do():
    """Slides come in order, names are unique, 8 to 12 exercises have a goal, and the right answers are not all at one place."""
    assert [task.slide for task in TASKS] == sorted([task.slide for task in TASKS])
    assert len({task.name for task in TASKS}) == len(TASKS)
    assert 8 <= len(EXERCISES) <= 12
    assert {task.slide for task in QUESTIONS} >= {2, 3, 4, 5, 7, 8, 9, 10, 11}
    assert {task.right for task in QUESTIONS} == {0, 1, 2}


@pytest.mark.parametrize("task", QUESTIONS, ids=lambda task: task.name)
def test_a_question_is_asked_before_its_step_tells_the_answer(task):
    """A question about a picture in steps begins before the last of them."""
    shared = parsed(task.line)
    steps = picture_of(shared.scene, shared.given, started(shared.scene, shared.given)).steps
    assert not steps or shared.step < len(steps)


def test_only_the_right_answer_and_a_reached_goal_are_done():
    """A wrong answer is corrected and leaves the question to be asked again; the course begins where it is not done."""
    course = attended(frozenset())
    right = course.task.right
    wrong = answered(course, (right + 1) % 3)
    assert (wrong.done, "No, it is" in lines(wrong, None)[1]) == (frozenset(), True)
    done = answered(course, right)
    assert done.done == {TASKS[0].name}
    assert attended(done.done).number == 1
    exercise = turned(done, 1)
    solved = parsed(exercise.task.solution)
    assert observed(exercise, "polar", solved.given, None)[0].done == done.done
    assert observed(exercise, solved.scene.name, solved.given, None)[0].done == {TASKS[0].name, TASKS[1].name}


def test_progress_is_kept_and_a_damaged_file_is_put_aside(tmp_path):
    """What two sessions did is there in the next one; a file that is none is moved aside, and one line says so."""
    path = tmp_path / "folder" / "progress.json"
    one, other = course_progress(path), course_progress(path)
    keep_done(one, frozenset({"a"}))
    keep_done(other, frozenset({"b"}))
    assert course_progress(path).value.done == {"a", "b"}
    path.write_bytes(b"\xff{nonsense")
    damaged = Lesson(course_progress(path))
    assert damaged.problem.startswith("progress not readable: moved to ")
    assert "\n" not in damaged.problem
    assert damaged.line == TASKS[0].line
    (aside,) = [file for file in path.parent.iterdir() if ".bad-" in file.name]
    assert aside.read_bytes() == b"\xff{nonsense"


def test_the_course_in_the_window(tmp_path, monkeypatch):
    """E opens the first task, a digit answers, ] turns the page, a reached goal is written down."""
    path = tmp_path / "progress.json"
    monkeypatch.setattr(screen, "progress_path", lambda: path)
    desk = LabDesk("polar")
    desk.press(pygame.K_e)
    assert desk.session.scene.name == parsed(TASKS[0].line).scene.name
    desk.press(pygame.K_1 + TASKS[0].right)
    assert course_progress(path).value.done == {TASKS[0].name}
    desk.press(pygame.K_RIGHTBRACKET)
    desk.type_into("ball", "7.8")
    desk.type_into("ball", "0", 1)
    desk.wait(FRAME)
    assert course_progress(path).value.done == {TASKS[0].name, TASKS[1].name}
    desk.press(pygame.K_e, pygame.K_1)
    assert desk.screen._lesson is None
    desk.close()
