"""The course on the page: what it asks, and what is done."""

from game.lab.course.attended import AttendedCourse, answered, attended, lines, observed, turned
from game.lab.course.progress import NAME, course_progress, keep_done
from game.lab.course.tasks import GoalState, Question
from game.lab.session.session import Session
from game.web.client.messages import PageItem
from game.web.client.state import PageState


class LessonOnPage:
    """The course as it is attended, and the file with what is done."""

    def __init__(self, state: PageState) -> None:
        """Begin at the first task that is not done."""
        self._state = state
        self._file = course_progress(None if state.folder is None else state.folder / NAME)
        self._course: AttendedCourse = attended(self._file.value.done)
        self._goal: GoalState | None = None
        self._tell()

    @property
    def line(self) -> str:
        """The share line that the open task begins with."""
        return self._course.task.line

    @property
    def lines(self) -> tuple[str, ...]:
        """The task, how near its goal is, and what follows from an answer."""
        task, said = self._course.task, lines(self._course, self._goal)
        if isinstance(task, Question):
            said = said[:1] if self._course.chosen is None else said[:2]
        return tuple([line for line in said if line and not line.startswith("] ")])

    @property
    def items(self) -> tuple[PageItem, ...]:
        """The answers to choose from, and the way to other tasks."""
        task = self._course.task
        open_ = isinstance(task, Question) and self._course.chosen is None
        answers = enumerate(task.choices) if isinstance(task, Question) and open_ else ()
        return (
            *[PageItem(f"answer:{number}", choice) for number, choice in answers],
            PageItem("next", "Next task"),
            PageItem("previous", "Task before"),
            PageItem("course", "Leave the course"),
        )

    def turn(self, step: int) -> str:
        """Open the task so many after this one; its share line."""
        self._course, self._goal = turned(self._course, step), None
        return self.line

    def answer(self, choice: int) -> None:
        """Answer the open task with a choice, counted from 0."""
        self._follow(answered(self._course, choice))

    def observe(self, session: Session) -> None:
        """Look whether the goal of the open task is reached."""
        course, self._goal = observed(self._course, session.scene.name, session.given, session.states[session.tick])
        self._follow(course)

    def _follow(self, course: AttendedCourse) -> None:
        """Go on with the course as it is now, and write down what is newly done."""
        if course.done != self._course.done:
            keep_done(self._file, course.done)
            self._state.changed = True
            self._tell()
        self._course = course

    def _tell(self) -> None:
        """Say what went wrong with the file."""
        if self._file.problem is not None:
            self._state.notifications.append(f"progress {self._file.problem}")
