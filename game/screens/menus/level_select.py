"""The choice of a level: chapters of pictures, with the best score and rank of each."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import pygame

from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.drawing.text import Type
from game.language import grouped, ntr, tr
from game.levels import Level, from_level
from game.levels.names import level_name
from game.overlay.toast import Toast
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.difficulty_names import difficulty_name
from game.screens.menus.difficulty import difficulty_choice, players_choice
from game.screens.menus.settings.control_rows import WIDE_TEXT
from game.screens.play.screen import PlayScreen
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.icons import draw_lock
from game.screens.toolkit.items.basic import ButtonItem, Heading, Item
from game.screens.toolkit.layout import Content, Row
from game.screens.toolkit.menu import Entry, Menu
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.plate import draw_focus, write_fitting
from game.storage.progress import RANKS, Best, record_name
from game.system.errors import BadInputError

_COLUMNS, _FEW_COLUMNS = 4, 3
"""Cards beside each other, as many as a chapter has; and where the player wants large texts."""
_CARD_MARGIN, _CARD_TEXT = 0.45, 2.9
"""From a card's edges to its picture, and the height of the words below it; units of text."""
_NAME, _NAME_LINES, _LINE = 1.05, 2, 1.2
"""Size of a name's letters, the lines that it may take where texts are large, and from line to line; units of text."""
_WIDTH = 40.0
"""Of the plate, units of text."""
_LOCKED, _LOCK = 110, 2.6
"""How much of a locked level's picture is seen, of 255; and the padlock's size, units of text."""


@dataclass(frozen=True)
class Card(Item):
    """A level to be begun. number: from 1, 0 for none; best: at this difficulty; is_open: whether it may be begun."""

    state: AppState
    level: Level
    number: int
    best: Best | None
    is_open: bool
    chosen: Callable[[], Screen | None]
    tip: str = ""

    @property
    def focusable(self) -> bool:
        """True for a locked level, too: its tip says how to unlock it."""
        return True

    def height(self, _type: Type, unit: float, width: float) -> float:
        """A square picture, the name and a line."""
        return width / unit + _CARD_TEXT + _LINE * (self._most_lines - 1)

    @property
    def _most_lines(self) -> int:
        """Lines that the name may take."""
        return _NAME_LINES if self.state.text_scale > WIDE_TEXT else 1

    def draw(self, canvas: Canvas, box: pygame.Rect, *, focused: bool) -> None:
        """Picture, number and name, best score and rank."""
        theme, unit = canvas.theme, canvas.unit
        draw_focus(canvas, box, focused=focused, resting=True)
        margin = round(unit * _CARD_MARGIN)
        side = max(box.width - 2 * margin, 1)
        hole = pygame.Rect(box.left + margin, box.top + margin, side, side)
        draw_box(canvas.surface, hole, unit * 0.3, theme.panel)
        picture = self.state.pictures.picture(self.level, side, theme)
        if picture is not None:
            picture.set_alpha(None if self.is_open else _LOCKED)
            canvas.surface.blit(picture, hole)
            picture.set_alpha(None)
        if not self.is_open:
            lock = pygame.Rect(0, 0, round(unit * _LOCK), round(unit * _LOCK))
            lock.center = hole.center
            draw_lock(canvas, lock, theme.text)
        colour = theme.accent if focused else theme.text if self.is_open else theme.faint
        left, room = complex(hole.left, hole.bottom + unit * 0.25), float(side)
        name = f"{self.number}  {level_name(self.level.name)}" if self.number else level_name(self.level.name)
        lines = canvas.type.wrapped(name, unit * _NAME, room) if self._most_lines > 1 else (name,)
        for index, line in enumerate(lines if len(lines) <= self._most_lines else (name,)):
            write_fitting(canvas, line, _NAME, colour, left + 1j * unit * _LINE * index, "topleft", room)
        foot = hole.bottom + unit * (1.55 + _LINE * (self._most_lines - 1))
        if self.best is not None:
            canvas.write(grouped(self.best.score), 0.95, theme.faint, complex(hole.left, foot))
            _draw_rank(canvas, RANKS[self.best.rank], complex(hole.right, foot + unit * 0.35))

    def accepted(self, panel: Screen) -> Screen | None:
        """Begin the level, if it is unlocked."""
        return self.chosen() if self.is_open else panel


class LevelSelect(Panel):
    """All levels, in chapters."""

    def __init__(self, state: AppState, under: Screen) -> None:
        """Open over a screen, at the level to be played next."""
        super().__init__(state, under)
        self._shows_next = True
        self._own = state.own_levels()

    @property
    def appearance(self) -> tuple[object, ...]:
        """As of every panel, and the choices above the levels."""
        return *super().appearance, self.state.difficulty, self.state.players

    def content(self) -> Content:
        """The difficulty, and the chapters."""
        state = self.state
        choices = difficulty_choice(state), players_choice(state)
        rows: list[Row] = [(choice,) for choice in choices] if self.has_large_text else [choices]
        cards = [self._card(index) for index in range(len(state.catalogue))]
        for chapter, group in groupby(cards, key=lambda card: chapter_of(card.level)):
            found = list(group)
            finished = len([card for card in found if state.storage.progress.value.finished(card.level.name)])
            note = tr("{finished} of {count} finished").format(finished=finished, count=len(found))
            rows.append((Heading(tr(chapter) if chapter else tr("Levels"), note),))
            for start in range(0, len(found), self._columns):
                row: list[Item] = list(found[start : start + self._columns])
                rows.append((*row, *[Item()] * (self._columns - len(row))))
        return Content(tr("Levels"), (*rows, *self._own_rows()), width=_WIDTH)

    def first(self) -> Focus | None:
        """The level to be played next."""
        wanted = next_level(self.state) + 1
        for number, row in enumerate(self.content().body):
            for column, item in enumerate(row):
                if isinstance(item, Card) and item.number == wanted:
                    return Focus(number, column)
        return None

    @property
    def _columns(self) -> int:
        """The number of cards in a row."""
        return _FEW_COLUMNS if self.has_large_text else _COLUMNS

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Draw one more picture, if one is missing."""
        if self._shows_next:
            self._shows_next = False
            self._settled(self._form_layout(size))
            self._show_focus(size)
        if self.state.pictures.next_frame():
            self._changes += 1
        return super().advance(seconds, size)

    def _card(self, index: int) -> Card:
        """A level's card."""
        state, level = self.state, self.state.catalogue[index]
        progress, names = state.storage.progress.value, [level.name for level in state.catalogue]
        best, is_open = progress.best(level.name, state.difficulty), progress.is_open(index, names)
        tip = (
            tr(level.description)
            if is_open
            else tr("Finish {level} to unlock this level.").format(level=level_name(names[index - 1]))
        )
        if best is not None:
            words = tr("Best at {difficulty}: {score} points, rank {rank}, {time}")
            told = words.format(
                difficulty=difficulty_name(state.difficulty),
                score=grouped(best.score),
                rank=RANKS[best.rank],
                time=clock(best.ticks),
            )
            tip = f"{tip} {told}"
        return Card(state, level, index + 1, best, is_open, lambda: self._begun(index), tip)

    def _own_rows(self) -> tuple[Row, ...]:
        """The player's own levels and a button for the editor; no rows if there is no editor."""
        if self.state.open_editor is None:
            return ()
        count = len(self._own.problems)
        note = ntr("{count} file cannot be read", "{count} files cannot be read", count).format(count=count) if count else ""
        cards: list[Item] = [self._own_card(level, path) for level, path in zip(self._own.levels, self._own.paths, strict=True)]
        rows: list[Row] = [(Heading(tr("Your own levels"), note),)]
        for start in range(0, len(cards), self._columns):
            row = cards[start : start + self._columns]
            rows.append((*row, *[Item()] * (self._columns - len(row))))
        tip = tr("Opens the editor. Your levels are files in a folder of their own.")
        return (*rows, (ButtonItem(tr("Make a new level"), lambda: self._edited(None), tip=tip, centred=True),))

    def _own_card(self, level: Level, path: Path) -> Card:
        """A level of the player's."""
        best = self.state.storage.progress.value.best(record_name(level), self.state.difficulty)
        entries = (
            Entry(tr("Play"), lambda: PlayScreen(self.state, (level,))),
            Entry(tr("Edit"), lambda: self._edited(path)),
            Entry(tr("Back"), lambda: self),
        )

        def chosen() -> Screen:
            return Menu(self.state, self, level.name, (path.name,), entries, back=lambda: self)

        return Card(self.state, level, 0, best, is_open=True, chosen=chosen, tip=level.description or path.name)

    def _edited(self, path: Path | None) -> Screen:
        """The editor, which leads back to a new choice of levels."""
        state = self.state
        if state.open_editor is None:
            return self
        try:
            return state.open_editor(state, lambda: LevelSelect(state, self._under or self), path)
        except BadInputError as error:
            state.toast = Toast(str(error))
            return self

    def _begun(self, index: int) -> Screen:
        """A game that begins with a level of the list."""
        self.state.chosen = index
        return PlayScreen(self.state, from_level(index, self.state.catalogue))


def next_level(state: AppState) -> int:
    """Index of the first level that is open and was not finished yet, or of the one chosen last if it comes later.

    That one may be locked: `--level` on the command line opens any.
    """
    progress, names = state.storage.progress.value, [level.name for level in state.catalogue]
    for index, name in enumerate(names):
        if not progress.finished(name) and progress.is_open(index, names):
            return max(index, state.chosen)
    return state.chosen


def chapter_of(level: Level) -> str:
    """The chapter that a level belongs to; empty for none."""
    return str(getattr(level, "chapter", ""))


def clock(ticks: int) -> str:
    """Ticks as minutes and seconds."""
    seconds = ticks // 240
    return f"{seconds // 60}:{seconds % 60:02}"


def _draw_rank(canvas: Canvas, rank: str, right: complex) -> None:
    """A rank's letter on a small plate. right: pixel at the middle of its right edge."""
    theme, unit = canvas.theme, canvas.unit
    plate = pygame.Rect(0, 0, round(unit * 1.3), round(unit * 1.2))
    plate.midright = (round(right.real), round(right.imag))
    best = rank == RANKS[-1]
    draw_box(canvas.surface, plate, unit * 0.3, theme.accent if best else theme.panel_edge)
    canvas.write(rank, 1.0, theme.panel if best else theme.text, complex(*plate.center), "center")
