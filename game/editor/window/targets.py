"""What keys and gamepads can choose in the panel: a number, the brush, the rotation, or a command; and what is beside it."""

from enum import Enum, auto
from typing import NamedTuple

import pygame

from game.editor.window.layout import BUTTONS, EditorLayout

COLUMNS = 2
"""Commands beside each other."""
_AROUND = 0.7
"""Units of text that the frame around several chips is wider than they are."""


class TargetKind(Enum):
    """What a target is."""

    NUMBER = auto()
    BRUSH = auto()
    FOLD = auto()
    COMMAND = auto()


class Target(NamedTuple):
    """Something to choose in the panel. number: of a number or a command, from 0."""

    kind: TargetKind
    number: int = 0


def target_below(target: Target, steps: int, numbers: int) -> Target:
    """The target some lines further down, round at the end. numbers: how many the panel shows."""
    lines = [
        *[Target(TargetKind.NUMBER, index) for index in range(numbers)],
        Target(TargetKind.BRUSH),
        Target(TargetKind.FOLD),
        *[Target(TargetKind.COMMAND, index) for index in range(0, len(BUTTONS), COLUMNS)],
    ]
    column = target.number % COLUMNS if target.kind is TargetKind.COMMAND else 0
    below = lines[(lines.index(target._replace(number=target.number - column)) + steps) % len(lines)]
    return below._replace(number=below.number + column) if below.kind is TargetKind.COMMAND else below


def beside(target: Target) -> Target:
    """The command beside a command."""
    return target._replace(number=target.number ^ 1)


def box_of(target: Target, seen: EditorLayout) -> pygame.Rect:
    """The box of a target in the panel."""
    match target.kind:
        case TargetKind.NUMBER:
            return seen.rows[target.number][1]
        case TargetKind.COMMAND:
            return seen.buttons[target.number][1]
        case TargetKind.BRUSH:
            return _around(seen.brush_heading.union(seen.chips[-1][1]), seen)
        case TargetKind.FOLD:
            return _around(seen.fold_heading.union(seen.folds[-1][1]), seen)


def _around(box: pygame.Rect, seen: EditorLayout) -> pygame.Rect:
    """A box a little larger than what is in it."""
    return box.inflate(round(seen.unit * _AROUND), round(seen.unit * _AROUND / 2.0))
