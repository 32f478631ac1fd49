"""The course in the window: what it asks stands on a plate over the picture."""

import pygame

from game.drawing.text import Type
from game.lab.course.attended import AttendedCourse, answered, attended, lines, observed, turned
from game.lab.course.progress import CourseProgress, keep_done
from game.lab.course.tasks import GoalState, Question
from game.lab.session.session import Session
from game.lab.window.layout import WindowLayout
from game.lab.window.words import TextSheet
from game.storage.stored_file import StoredFile

_LINE, _EDGE = 1.3, 0.5
"""Height of a line, and the space around all of them, in units."""
_OPACITY = 236
"""Of the plate, of 255."""


class Lesson:
    """The course as it is attended, and the file with what is done."""

    def __init__(self, file: StoredFile[CourseProgress]) -> None:
        """Begin at the first task that is not done."""
        self._file = file
        self._course: AttendedCourse = attended(file.value.done)
        self._goal: GoalState | None = None

    @property
    def line(self) -> str:
        """The share line that the open task begins with."""
        return self._course.task.line

    @property
    def problem(self) -> str:
        """What went wrong with the file, in one line; empty for nothing."""
        return "" if self._file.problem is None else f"progress {self._file.problem}"

    def turn(self, step: int) -> str:
        """Open the task so many after this one; its share line."""
        self._course, self._goal = turned(self._course, step), None
        return self.line

    def answer(self, choice: int) -> bool:
        """Answer the open task with a choice, counted from 0; whether it is a question."""
        if not isinstance(self._course.task, Question):
            return False
        self._follow(answered(self._course, choice))
        return True

    def observe(self, session: Session) -> None:
        """Look whether the goal of the open task is reached."""
        course, self._goal = observed(self._course, session.scene.name, session.given, session.states[session.tick])
        self._follow(course)

    def lowered(self, layout: WindowLayout, type_: Type) -> WindowLayout:
        """A division of the window whose scene is shown whole below the plate."""
        height = self._plate(layout, type_).height
        focus = pygame.Rect(layout.focus.left, layout.focus.top + height, layout.focus.width, layout.focus.height - height)
        return layout._replace(focus=focus) if focus.height > height else layout

    def draw(self, sheet: TextSheet) -> None:
        """What is asked, on a plate at the top of the picture."""
        unit, theme, area = sheet.unit, sheet.theme, self._plate(sheet.layout, sheet.type)
        plate = pygame.Surface(area.size, pygame.SRCALPHA)
        plate.fill((*theme.panel, _OPACITY))
        sheet.surface.blit(plate, area.topleft)
        width = max(1, round(unit * 0.08))
        pygame.draw.line(sheet.surface, theme.accent, area.bottomleft, area.bottomright, width)
        for number, row in enumerate(self._rows(sheet.layout, sheet.type)):
            pixel = complex(area.left + 2.0 * _EDGE * unit, area.top + unit * (_EDGE + _LINE * number))
            sheet.type.write(sheet.surface, row, unit, theme.text if number else theme.accent, pixel)

    def _plate(self, layout: WindowLayout, type_: Type) -> pygame.Rect:
        """Where the words stand."""
        rows = self._rows(layout, type_)
        height = round(layout.unit * (_LINE * len(rows) + 2.0 * _EDGE))
        top = layout.head.bottom
        return pygame.Rect(layout.world.left, top, layout.world.width, height)

    def _rows(self, layout: WindowLayout, type_: Type) -> list[str]:
        """What is to be read, as wide as the picture."""
        width = layout.world.width - 4.0 * _EDGE * layout.unit
        return [row for line in lines(self._course, self._goal) for row in type_.wrapped(line, layout.unit, width)]

    def _follow(self, course: AttendedCourse) -> None:
        """Go on with the course as it is now, and write down what is newly done."""
        if course.done != self._course.done:
            keep_done(self._file, course.done)
        self._course = course
