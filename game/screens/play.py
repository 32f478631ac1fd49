"""The game being played."""

import pygame

from game import effects
from game.autopilot import Autopilot
from game.drawing import contact_normals
from game.drawing.camera import Camera, Layout, layout, unit_of
from game.drawing.canvas import Canvas
from game.effects import EffectKind, Effects
from game.effects.hit_stop import hit_stop_seconds
from game.fixed_step import Due, due
from game.input.hands import Hands
from game.input.key_names import key_name
from game.input.keys import Action
from game.input.signals import FocusLost, Pressed, Signal
from game.levels import Level
from game.overlay import hud, notice
from game.rules import TICK, EventKind, Phase, new_game, tick
from game.scene import scene_at, still
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.help import Help
from game.screens.menu import Entry, Menu
from game.screens.settings_panel import SettingsPanel
from game.second_opinion import NormalPair

_READY_SECONDS = 0.6
"""After a pause with a ball in play, until it flies on."""
_OFFER_TICKS = round(20.0 / TICK)
"""Without a paddle's touch, until the player may give up the ball."""
_END_TICKS = 200
"""From the end of the game to the menu that says so: nobody who is still playing chooses an entry by accident."""
# Lengths are in units of text.
_NOTE, _NOTE_ROOM, _NOTE_BOTTOM, _NOTE_MARGIN = 0.95, 1.6, 0.3, 0.8
"""The line about the physics: size of its letters, height left to it, from it to the lower edge and to the sides."""


class PlayScreen:
    """One game from its first serve on."""

    def __init__(self, state: AppState, levels: tuple[Level, ...]) -> None:
        """Start a new game at the first of the levels."""
        self._state, self._levels = state, levels
        self._ticked = still(new_game(levels, state.seed, state.ruleset))
        self._effects = Effects()
        self._normals: tuple[NormalPair, ...] = ()
        self._hands = Hands()
        self._due = Due(0, 0.0)
        self._ready = 0.0  # seconds until play goes on after a pause
        self._stop = 0.0  # seconds of hit-stop left
        self._pilot = Autopilot() if state.autopilot else None
        self._untouched = 0  # ticks with a ball in play since a paddle touched it

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Take the player's controls into account, or open a panel."""
        match signal:
            case Pressed(Action.PAUSE | Action.BACK) | FocusLost():
                return self._paused(_pause_menu(self._state, self))
            case Pressed(Action.RESTART):
                return self._paused(_restart_menu(self._state, self))
            case Pressed(Action.HELP):
                return self._paused(Help(self._state, self))
            case Pressed(Action.SETTINGS):
                return self._paused(SettingsPanel(self._state, self))
            case Pressed(Action.GIVE_UP) if not self._may_give_up:
                return self
        self._hands = self._hands.after(signal)
        self._state.view = self._state.view.after(signal, unit_of(size))
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Run the ticks that are due; a panel when the game has ended."""
        self._state.view = self._state.view.later(seconds, smooth=not self._state.settings.reduced_motion)
        if self._ready > 0.0:
            self._ready -= seconds
            return self
        stopped = min(self._stop, max(seconds, 0.0))
        self._stop -= stopped
        self._due = due(self._due.rest, seconds - stopped)
        camera = self._layout(size).camera
        for _ in range(self._due.ticks):
            self._tick(camera)
            if EffectKind.HIT_STOP in self._state.settings.shown and (stop := hit_stop_seconds(self._ticked)):
                self._stop, self._due = stop, Due(0, 0.0)
                break
        game = self._ticked.game
        if game.phase in (Phase.OVER, Phase.WON) and game.phase_tick >= _END_TICKS:
            return _end_menu(self._state, self, won=game.phase == Phase.WON, score=game.score)
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The arena, the figures, and a line that says what to do."""
        state, seen = self._state, self._layout(surface.get_size())
        canvas = state.canvas(surface, seen.camera)
        scene = scene_at(self._ticked, self._due.alpha, self._effects)
        state.painter.paint(canvas, scene)
        if state.shows_normals:
            contact_normals.draw(canvas, self._normals)
        badge = "" if self._pilot is None else "autopilot"
        shown = hud.readings(self._ticked.game, self._effects.streak, muted=not state.settings.sound, badge=badge)
        hud.draw(canvas, shown, seen)
        told = notice.READY if self._ready > 0.0 else notice.notice(self._ticked.game)
        if told is None and self._may_give_up:
            told = notice.Notice("Out of reach?", f"{key_name(Action.GIVE_UP)}: give up this ball; it costs a life")
        if told is not None:
            notice.draw(canvas, told, scene)
        if state.physics.note:
            _draw_note(canvas, state.physics.note)

    @property
    def _may_give_up(self) -> bool:
        """Whether the ball has been out of reach for so long that the player may do without it."""
        return self._pilot is None and self._untouched >= _OFFER_TICKS

    def restarted(self) -> Screen:
        """The same levels from their first serve."""
        return PlayScreen(self._state, self._levels)

    def _tick(self, camera: Camera) -> None:
        """Run one tick and tell the recorder."""
        game = self._ticked.game
        controls = self._hands.controls(camera) if self._pilot is None else self._pilot.controls(game)
        self._hands = self._hands.after_tick()
        self._ticked = tick(game, controls, self._state.physics.advance)
        touched = self._ticked.game.phase != Phase.PLAYING or any(
            [event.kind in {EventKind.PADDLE_HIT, EventKind.SERVED} for event in self._ticked.events]
        )
        self._untouched = 0 if touched else self._untouched + 1
        self._effects = effects.after(self._effects, self._ticked, self._state.settings.shown)
        self._normals = self._state.normals_after(self._normals, self._ticked)
        self._state.play_sounds(self._ticked, camera)
        if self._state.recorder is not None:
            self._state.recorder(controls, self._ticked.game)

    def _paused(self, panel: Screen) -> Screen:
        """A panel over the game; keys that were held when it opened are let go."""
        self._hands = self._hands.after(FocusLost())
        if self._ticked.game.phase == Phase.PLAYING:
            self._ready = _READY_SECONDS
        return panel

    def _layout(self, size: tuple[int, int]) -> Layout:
        """Where everything is on a surface of some size."""
        below = unit_of(size) * _NOTE_ROOM if self._state.physics.note else 0.0
        return self._state.view.seen(layout(size, self._ticked.game.level.ground_radius, below))


def _draw_note(canvas: Canvas, note: str) -> None:
    """A line at the lower edge of the surface, smaller where it would not fit into the width."""
    width, height = canvas.size
    length = canvas.type.rendered(note, canvas.unit * _NOTE, canvas.theme.accent).get_width()
    size = _NOTE * min((width - 2.0 * _NOTE_MARGIN * canvas.unit) / length, 1.0)
    pixel = complex(width / 2.0, height - canvas.unit * _NOTE_BOTTOM)
    canvas.write(note, size, canvas.theme.accent, pixel, "midbottom")


def _pause_menu(state: AppState, play: PlayScreen) -> Menu:
    """What to do with a game that was interrupted."""
    entries = (
        Entry("Go on", lambda: play, Action.PAUSE),
        Entry("Restart", play.restarted, Action.RESTART),
        Entry("Settings", lambda: SettingsPanel(state, menu), Action.SETTINGS),
        Entry("All levels", lambda: state.open_title(state)),
        Entry("Quit", lambda: None),
    )
    menu = Menu(state, play, "Paused", (), entries, back=lambda: play)
    return menu


def _restart_menu(state: AppState, play: PlayScreen) -> Menu:
    """The question before a game is thrown away."""
    entries = (Entry("Restart", play.restarted, Action.RESTART), Entry("Go on", lambda: play, Action.PAUSE))
    return Menu(state, play, "Restart?", ("This game ends; the score is lost.",), entries, back=lambda: play)


def _end_menu(state: AppState, play: PlayScreen, *, won: bool, score: int) -> Menu:
    """The end of a game."""
    entries = (
        Entry("Play again", play.restarted, Action.RESTART),
        Entry("All levels", lambda: state.open_title(state)),
        Entry("Quit", lambda: None),
    )
    title, line = ("You won", "Every level is cleared.") if won else ("Game over", "The last ball is gone.")
    return Menu(state, play, title, (line, f"Score {score:,}"), entries, back=lambda: state.open_title(state))
