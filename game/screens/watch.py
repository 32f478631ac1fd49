"""The screen of a recorded game: play, stop, step, seek. It is drawn like a game; its ticks come from the recording."""

from collections.abc import Callable
from typing import Protocol

import pygame

from game import effects
from game.drawing import contact_normals
from game.drawing.camera import Layout, layout, unit_of
from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_dot
from game.effects import LONGEST, Effects
from game.input.key_names import key_name, watch_help
from game.input.keys import Action
from game.input.signals import Clicked, FocusLost, Moved, Pressed, Signal
from game.language import decimal, tr
from game.loop.fixed_step import LONGEST_FRAME
from game.overlay import hud
from game.overlay.readings import readings
from game.overlay.toast_drawing import draw_bar
from game.rules import TICK, Game, Ticked
from game.scene import scene_at, still
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.help.panel import Help
from game.screens.menus.settings.control_rows import WIDE_TEXT
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play import buttons as play_buttons
from game.screens.toolkit.plate import write_fitting
from game.second_opinion import NormalPair

SPEEDS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
_SKIPPED_TICKS = 5 * 240
"""Ticks that an arrow key skips."""
# Lengths are in units of text.
_ROOM = 3.6
"""Height at the surface's lower edge that is left to the timeline and its words."""
_BAR_LEFT, _BAR_RIGHT, _BAR_BOTTOM, _BAR_HEIGHT = 7.0, 13.0, 2.4, 0.6
"""The timeline's bar: from the surface's edges, the last one to its top; and its height."""
_GRIP = (0.5, 0.8)
"""A click so far beside the bar, across and down, still means it."""
_EDGE, _TEXT, _KEYS, _KEYS_TOP = 0.8, 1.0, 0.9, 0.6
"""From the words to the surface's edges, sizes of letters, and from the bar to the keys below."""


class Frames(Protocol):
    """The ticks of a recorded game, by number."""

    @property
    def ticks(self) -> int:
        """The number of ticks."""

    def game(self, number: int) -> Game:
        """The game after `number` ticks, 0 to `ticks`."""

    def ticked(self, number: int) -> Ticked:
        """The tick that follows the first `number`, 0 to `ticks` - 1."""


class Watch:
    """Shows a recorded game. Its clock counts ticks, with a fraction, to draw moments between two ticks."""

    def __init__(self, state: AppState, frames: Frames, back: Callable[[], Screen | None] = lambda: None) -> None:
        """Start at the beginning, playing. back: the screen that it leads back to."""
        self._state, self._frames, self._back = state, frames, back
        self._hovered: Action | None = None  # what the button means that the mouse is on
        self._playing = True
        self._speed = SPEEDS.index(1.0)
        self._effects = Effects()
        self._normals: tuple[NormalPair, ...] = ()
        self._seek(0)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Play, stop, step, seek, or leave."""
        state = self._state
        signal = self._on_buttons(signal, size)
        leaves = isinstance(signal, Pressed) and signal.action in (Action.BACK, Action.HELP, Action.SETTINGS)
        state.view = state.view.after(FocusLost() if leaves else signal, unit_of(size))
        match signal:
            case Pressed(Action.BACK):
                return self._back()
            case Pressed(Action.HELP):
                return Help(state, self, tr("Watching a game"), watch_help())
            case Pressed(Action.SETTINGS):
                self._playing = False
                return SettingsPanel(state, self)
            case Pressed(Action.SERVE | Action.PAUSE | Action.CONFIRM):
                self._toggle()
            case Pressed(Action.LESS | Action.DOWN):
                self._speed = max(self._speed - 1, 0)
            case Pressed(Action.MORE | Action.UP):
                self._speed = min(self._speed + 1, len(SPEEDS) - 1)
            case Pressed(action):
                self._go(action)
            case Clicked(pixel) | Moved(pixel, True) if self._on_timeline(pixel, size):
                bar = self._timeline(size)
                share = (pixel.real - bar.left) / max(bar.width, 1)
                self._seek(round(min(max(share, 0.0), 1.0) * self._frames.ticks))
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Let the recording run at its speed."""
        self._state.view = self._state.view.later(seconds, smooth=not self._state.settings.reduced_motion)
        if self._playing:
            passed = self._run_to(self._at + min(max(seconds, 0.0), LONGEST_FRAME) / TICK * SPEEDS[self._speed])
            camera = self._layout(size).camera
            for ticked in passed:
                self._state.play_sounds(ticked, camera)
            self._playing = self._at < self._frames.ticks
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The arena, the figures and the timeline."""
        state, seen = self._state, self._layout(surface.get_size())
        canvas = state.canvas(surface, seen.camera)
        state.painter.paint(canvas, scene_at(self._shown, self._at - self._number, self._effects))
        if state.shows_normals:
            contact_normals.draw(canvas, self._normals)
        shown = readings(self._shown.game, self._effects.streak, muted=not state.settings.sound, badge=tr("replay"))
        hud.draw(state.words(canvas), shown, seen)
        play_buttons.draw(canvas, seen, self._hovered, play_buttons.WATCHING)
        self._draw_timeline(state.words(canvas))

    def _on_buttons(self, signal: Signal, size: tuple[int, int]) -> Signal:
        """What a signal means: a click on a button is its key; on the speed, the next speed; on the arena, play or stop."""
        seen = self._layout(size)
        match signal:
            case Moved(pixel):
                self._hovered = play_buttons.action_at(seen, pixel, play_buttons.WATCHING)
            case Clicked(pixel) if (action := play_buttons.action_at(seen, pixel, play_buttons.WATCHING)) is not None:
                return Pressed(action)
            case Clicked(pixel) if self._on_timeline(pixel, size):
                return signal
            case Clicked(pixel) if pixel.imag > size[1] - self._unit(size) * _ROOM and pixel.real > self._speed_left(size):
                self._speed = (self._speed + 1) % len(SPEEDS)
            case Clicked(pixel):
                return Pressed(Action.PAUSE)
        return signal

    def _toggle(self) -> None:
        """Play or stop; at the end, play from the beginning."""
        if self._at >= self._frames.ticks:
            self._seek(0)
        self._playing = not self._playing

    def _go(self, action: Action) -> None:
        """Move to another tick."""
        whole = int(self._at)
        match action:
            case Action.STEP | Action.STEP_BACK:
                self._playing = False
                self._seek(whole + (1 if action is Action.STEP else -1))
            case Action.LEFT:
                self._seek(whole - _SKIPPED_TICKS)
            case Action.RIGHT:
                self._seek(whole + _SKIPPED_TICKS)
            case Action.START | Action.RESTART:
                self._seek(0)
            case Action.END:
                self._seek(self._frames.ticks)

    def _seek(self, tick: int) -> None:
        """Show the moment after the given number of ticks, limited to those there are."""
        tick = min(max(tick, 0), self._frames.ticks)
        start = max(tick - LONGEST, 0)
        self._effects = Effects() if start else effects.at_start(self._state.settings.shown)
        self._normals = ()
        self._at, self._number = float(start), start
        self._shown = self._tick_from(start)
        self._run_to(float(tick))

    def _run_to(self, moment: float) -> list[Ticked]:
        """Play forward to a moment, in ticks. Returns the ticks completed on the way."""
        moment = min(moment, float(self._frames.ticks))
        passed = []
        while self._number < int(moment):
            self._effects = effects.after(self._effects, self._shown, self._state.settings.shown)
            self._normals = self._state.normals_after(self._normals, self._shown)
            passed.append(self._shown)
            self._number += 1
            self._shown = self._tick_from(self._number)
        self._at = moment
        return passed

    def _tick_from(self, number: int) -> Ticked:
        """The tick that follows the first `number`; after the last one, its game standing still."""
        return self._frames.ticked(number) if number < self._frames.ticks else still(self._frames.game(number))

    def _layout(self, size: tuple[int, int]) -> Layout:
        """The layout of the arena above the timeline."""
        flat = layout(size, self._shown.game.level.ground_radius, below=self._unit(size) * _ROOM)
        return self._state.view.seen(flat)

    def _unit(self, size: tuple[int, int]) -> float:
        """Size of the timeline's text, pixels."""
        return unit_of(size) * self._state.text_scale

    def _timeline(self, size: tuple[int, int]) -> pygame.Rect:
        """The timeline's bar, pixels."""
        unit = self._unit(size)
        left, right = (_EDGE, _EDGE) if self._has_large_text else (_BAR_LEFT, _BAR_RIGHT)
        width = max(round(size[0] - unit * (left + right)), 1)
        corner = (round(unit * left), round(size[1] - unit * _BAR_BOTTOM))
        return pygame.Rect(corner, (width, max(round(unit * _BAR_HEIGHT), 1)))

    @property
    def _has_large_text(self) -> bool:
        """Whether the text is so large that it stands below the bar, not beside it."""
        return self._state.text_scale > WIDE_TEXT

    def _speed_left(self, size: tuple[int, int]) -> float:
        """The left edge of the text with the speed, pixels."""
        return size[0] - self._unit(size) * _BAR_RIGHT

    def _on_timeline(self, pixel: complex, size: tuple[int, int]) -> bool:
        """Whether a pixel is on the bar, or near enough to mean it."""
        across, down = (round(2.0 * self._unit(size) * reach) for reach in _GRIP)
        return bool(self._timeline(size).inflate(across, down).collidepoint(pixel.real, pixel.imag))

    def _draw_timeline(self, canvas: Canvas) -> None:
        """Draw the timeline with the position, the speed and the main keys."""
        theme, unit, bar = canvas.theme, canvas.unit, self._timeline(canvas.size)
        share = self._at / max(self._frames.ticks, 1)
        draw_bar(canvas.surface, bar, share, theme)
        draw_dot(canvas.surface, complex(bar.left + bar.width * share, bar.centery), bar.height, theme.text)
        y = bar.bottom + unit * (_KEYS_TOP + 0.5 * _TEXT) if self._has_large_text else bar.centery
        left, right = complex(unit * _EDGE, y), complex(canvas.size[0] - unit * _EDGE, y)
        played = canvas.write(tr("playing") if self._playing else tr("stopped"), _TEXT, theme.text, left, "midleft")
        seconds = (
            f"{decimal(self._at * TICK, 1)} / {decimal(self._frames.ticks * TICK, 1)} s    {_speed_text(SPEEDS[self._speed])}"
        )
        speed = canvas.write(seconds, _TEXT, theme.text, right, "midright")
        if self._has_large_text:
            keys, room = complex(played.right + unit, y), speed.left - played.right - 2.0 * unit
            write_fitting(canvas, _help_key(), _KEYS, theme.faint, keys, "midleft", room)
            return
        below = complex(bar.left, bar.bottom + unit * _KEYS_TOP)
        write_fitting(canvas, _keys_help(), _KEYS, theme.faint, below, "topleft", right.real - below.real)


def _speed_text(speed: float) -> str:
    """A speed, slow ones as a fraction."""
    return f"{speed:g}×" if speed >= 1.0 else f"1/{1.0 / speed:g}×"


def _help_key() -> str:
    """The name of the key for help."""
    return f"{key_name(Action.HELP)}: {tr('help')}"


def _keys_help() -> str:
    """The main keys, as they are named on the player's keyboard layout."""
    told = (
        (tr("play / stop"), (Action.SERVE,)),
        (tr("one tick"), (Action.STEP_BACK, Action.STEP)),
        (tr("5 s"), (Action.LEFT, Action.RIGHT)),
        (tr("speed"), (Action.LESS, Action.MORE)),
        (tr("help"), (Action.HELP,)),
    )
    pairs = [f"{' / '.join([key_name(action) for action in actions])}: {words}" for words, actions in told]
    return "   ·   ".join(pairs)
