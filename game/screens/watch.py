"""A recorded game: played, stopped, stepped and sought in. Only the ticks come from elsewhere; the drawing is the game's."""

from typing import Protocol

import pygame

from game import effects
from game.drawing import contact_normals as normals
from game.drawing.camera import Layout, layout, unit_of
from game.drawing.primitives import draw_dot
from game.effects import LONGEST, Effects
from game.fixed_step import LONGEST_FRAME
from game.input.key_names import key_name, watch_help
from game.input.keys import Action
from game.input.signals import Clicked, Dragged, Moved, Pressed, Signal, Zoomed
from game.overlay import hud
from game.overlay.toast import draw_bar
from game.rules import TICK, Game, Ticked
from game.scene import scene_at, still
from game.screens.base import Screen, Shared
from game.screens.panels import Help
from game.screens.settings_panel import SettingsPanel
from game.second_opinion import Opinions

SPEEDS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
_SKIP = 5 * 240
"""Ticks that an arrow key skips."""


class Frames(Protocol):
    """A game that was played, tick by tick."""

    @property
    def ticks(self) -> int:
        """How many there are."""

    def game(self, number: int) -> Game:
        """The game after `number` ticks, 0 to `ticks`."""

    def ticked(self, number: int) -> Ticked:
        """The tick that follows the first `number`, 0 to `ticks` - 1."""


class Watch:
    """Shows a recorded game; its clock is a number of ticks, with a fraction to draw between them."""

    def __init__(self, shared: Shared, frames: Frames) -> None:
        """Start at the beginning, playing."""
        self._shared, self._frames = shared, frames
        self._playing = True
        self._speed = SPEEDS.index(1.0)
        self._effects = Effects()
        self._opinions: tuple[Opinions, ...] = ()
        self._seek(0)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Play, stop, step, seek, or leave."""
        shared = self._shared
        match signal:
            case Pressed(Action.BACK):
                return None
            case Pressed(Action.HELP):
                return Help(shared, self, "Watching a game", watch_help())
            case Pressed(Action.SETTINGS):
                self._playing = False
                return SettingsPanel(shared, self)
            case Pressed(Action.SERVE | Action.PAUSE | Action.CONFIRM):
                self._toggle()
            case Pressed(Action.LESS | Action.DOWN):
                self._speed = max(self._speed - 1, 0)
            case Pressed(Action.MORE | Action.UP):
                self._speed = min(self._speed + 1, len(SPEEDS) - 1)
            case Pressed(action):
                self._go(action)
                shared.view = shared.view.after(signal, unit_of(size))
            case Dragged() | Zoomed():
                shared.view = shared.view.after(signal, unit_of(size))
            case Clicked(place) | Moved(place, True) if self._on_timeline(place, size):
                bar = self._timeline(size)
                share = (place.real - bar.left) / max(bar.width, 1)
                self._seek(round(min(max(share, 0.0), 1.0) * self._frames.ticks))
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Let the recording run at its speed."""
        self._shared.view = self._shared.view.later(seconds, smooth=not self._shared.settings.reduced_motion)
        if self._playing:
            passed = self._run_to(self._at + min(max(seconds, 0.0), LONGEST_FRAME) / TICK * SPEEDS[self._speed])
            camera = self._layout(size).camera
            for ticked in passed:
                self._shared.heard(ticked, camera)
            self._playing = self._at < self._frames.ticks
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The arena, the figures and the timeline."""
        shared, place = self._shared, self._layout(surface.get_size())
        scene = scene_at(self._shown, self._at - self._number, self._effects)
        shared.painter.paint(surface, scene, place.camera, shared.type, place.unit)
        if shared.normals:
            normals.draw(surface, self._opinions, place.camera, shared.theme, shared.type, place.unit)
        shown = hud.readings(self._shown.game, self._effects.streak, muted=not shared.settings.sound, badge="replay")
        hud.draw(surface, place, shown, shared.theme, shared.type)
        self._draw_timeline(surface)

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
                self._seek(whole - _SKIP)
            case Action.RIGHT:
                self._seek(whole + _SKIP)
            case Action.START | Action.RESTART:
                self._seek(0)
            case Action.END:
                self._seek(self._frames.ticks)

    def _seek(self, tick: int) -> None:
        """Show the moment after the given number of ticks, limited to those there are."""
        tick = min(max(tick, 0), self._frames.ticks)
        start = max(tick - LONGEST, 0)
        self._effects, self._opinions = Effects(), ()
        self._at, self._number = float(start), start
        self._shown = self._tick_from(start)
        self._run_to(float(tick))

    def _run_to(self, moment: float) -> list[Ticked]:
        """Play forward to a moment, in ticks; the ticks that were completed on the way."""
        moment = min(moment, float(self._frames.ticks))
        passed = []
        while self._number < int(moment):
            self._effects = effects.after(self._effects, self._shown, self._shared.settings.shown)
            self._opinions = self._shared.opinions(self._opinions, self._shown)
            passed.append(self._shown)
            self._number += 1
            self._shown = self._tick_from(self._number)
        self._at = moment
        return passed

    def _tick_from(self, number: int) -> Ticked:
        """The tick to look into after the first `number`; behind the last there is none."""
        return self._frames.ticked(number) if number < self._frames.ticks else still(self._frames.game(number))

    def _layout(self, size: tuple[int, int]) -> Layout:
        """Where everything is, the timeline left out."""
        flat = layout(size, self._shown.game.level.ground_radius, below=unit_of(size) * 3.6)
        return self._shared.view.seen(flat)

    def _timeline(self, size: tuple[int, int]) -> pygame.Rect:
        """The timeline's bar, pixels."""
        unit = unit_of(size)
        return pygame.Rect(
            round(unit * 7.0), round(size[1] - unit * 2.4), max(round(size[0] - unit * 20.0), 1), max(round(unit * 0.6), 1)
        )

    def _on_timeline(self, place: complex, size: tuple[int, int]) -> bool:
        """Whether a pixel is on the bar, or near enough to mean it."""
        unit = unit_of(size)
        return bool(self._timeline(size).inflate(round(unit), round(unit * 1.6)).collidepoint(place.real, place.imag))

    def _draw_timeline(self, surface: pygame.Surface) -> None:
        """How far the recording is, how fast it runs, and the main keys."""
        theme, type_, size = self._shared.theme, self._shared.type, surface.get_size()
        unit, bar = unit_of(size), self._timeline(size)
        share = self._at / max(self._frames.ticks, 1)
        draw_bar(surface, bar, share, theme)
        draw_dot(surface, complex(bar.left + bar.width * share, bar.centery), bar.height, theme.text)
        state = "playing" if self._playing else "stopped"
        type_.write(surface, state, unit, theme.text, complex(unit * 0.8, bar.centery), "midleft")
        length = f"{self._at * TICK:.1f} / {self._frames.ticks * TICK:.1f} s    {_speed_text(SPEEDS[self._speed])}"
        type_.write(surface, length, unit, theme.text, complex(size[0] - unit * 0.8, bar.centery), "midright")
        keys = f"Space: play / stop    , . : one tick    Left Right: 5 s    + -: speed    {key_name(Action.HELP)}: help"
        type_.write(surface, keys, unit * 0.9, theme.faint, complex(bar.left, bar.bottom + unit * 0.6), "topleft")


def _speed_text(speed: float) -> str:
    """A speed as people write it."""
    return f"{speed:g}x" if speed >= 1.0 else f"1/{1.0 / speed:g}x"
