"""The game being played."""

import pygame

from game import effects
from game.autopilot import Autopilot
from game.drawing import contact_normals as normals
from game.drawing.camera import Camera, Layout, layout, unit_of
from game.effects import Effects, Kind, hit_stop
from game.fixed_step import Due, due
from game.input.hands import Hands
from game.input.key_names import key_name
from game.input.keys import Action
from game.input.signals import FocusLost, Pressed, Signal
from game.levels import Level
from game.overlay import hud, notice
from game.rules import TICK, EventKind, Phase, new_game, tick
from game.scene import scene_at, still
from game.screens.base import Screen, Shared
from game.screens.panels import Entry, Help, Menu
from game.screens.settings_panel import SettingsPanel
from game.second_opinion import Opinions

_READY_SECONDS = 0.6
"""After a pause with a ball in play, before it flies on."""
_OFFER_TICKS = round(20.0 / TICK)
"""Without a paddle's touch, until the player may give up the ball."""
_END_TICKS = 200
"""From the last ball's loss, or the last brick, to the panel that says so."""


class Play:
    """One game from its first serve on."""

    def __init__(self, shared: Shared, levels: tuple[Level, ...]) -> None:
        """Start a new game at the first of the levels."""
        self._shared, self._levels = shared, levels
        self._ticked = still(new_game(levels, shared.seed))
        self._effects = Effects()
        self._opinions: tuple[Opinions, ...] = ()
        self._hands = Hands()
        self._due = Due(0, 0.0)
        self._ready = 0.0
        self._breath = 0.0  # seconds to hold it
        self._pilot = Autopilot() if shared.autopilot else None
        self._untouched = 0  # ticks with a ball in play since a paddle touched it

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Take the player's hands into account, or open a panel."""
        match signal:
            case Pressed(Action.PAUSE | Action.BACK) | FocusLost():
                return self._held(_pause_menu(self._shared, self))
            case Pressed(Action.RESTART):
                return self._held(_restart_menu(self._shared, self))
            case Pressed(Action.HELP):
                return self._held(Help(self._shared, self))
            case Pressed(Action.SETTINGS):
                return self._held(SettingsPanel(self._shared, self))
            case Pressed(Action.GIVE_UP) if not self._may_give_up:
                return self
        self._hands = self._hands.after(signal)
        self._shared.view = self._shared.view.after(signal, unit_of(size))
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Run the ticks that are due; a panel when the game has ended."""
        self._shared.view = self._shared.view.later(seconds, smooth=not self._shared.settings.reduced_motion)
        if self._ready > 0.0:
            self._ready -= seconds
            return self
        held = min(self._breath, max(seconds, 0.0))
        self._breath -= held
        self._due = due(self._due.rest, seconds - held)
        camera = self._layout(size).camera
        for _ in range(self._due.ticks):
            self._tick(camera)
            if Kind.HIT_STOP in self._shared.settings.shown and (breath := hit_stop.breath(self._ticked)):
                self._breath, self._due = breath, Due(0, 0.0)
                break
        game = self._ticked.game
        if game.phase in (Phase.OVER, Phase.WON) and game.phase_tick >= _END_TICKS:
            return _end_menu(self._shared, self, won=game.phase == Phase.WON, score=game.score)
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The arena, the figures, and a line that says what to do."""
        place, shared = self._layout(surface.get_size()), self._shared
        scene = scene_at(self._ticked, self._due.alpha, self._effects)
        shared.painter.paint(surface, scene, place.camera, shared.type, place.unit)
        if shared.normals:
            normals.draw(surface, self._opinions, place.camera, shared.theme, shared.type, place.unit)
        badge = "" if self._pilot is None else "autopilot"
        shown = hud.readings(self._ticked.game, self._effects.streak, muted=not shared.settings.sound, badge=badge)
        hud.draw(surface, place, shown, shared.theme, shared.type)
        told = notice.READY if self._ready > 0.0 else notice.notice(self._ticked.game)
        if told is None and self._may_give_up:
            told = notice.Notice("Out of reach?", f"{key_name(Action.GIVE_UP)}: give up this ball; it costs a life")
        if told is not None:
            notice.draw(surface, place, told, scene, shared.theme, shared.type)

    @property
    def _may_give_up(self) -> bool:
        """Whether the ball has been out of reach for so long that the player may do without it."""
        return self._pilot is None and self._untouched >= _OFFER_TICKS

    def restarted(self) -> Screen:
        """The same levels from their first serve."""
        return Play(self._shared, self._levels)

    def _tick(self, camera: Camera) -> None:
        """Run one tick and tell the recorder."""
        game = self._ticked.game
        controls = self._hands.controls(camera) if self._pilot is None else self._pilot.controls(game)
        self._hands = self._hands.after_tick()
        self._ticked = tick(game, controls)
        touched = self._ticked.game.phase != Phase.PLAYING or any(
            [event.kind in {EventKind.PADDLE_HIT, EventKind.SERVED} for event in self._ticked.events]
        )
        self._untouched = 0 if touched else self._untouched + 1
        self._effects = effects.after(self._effects, self._ticked, self._shared.settings.shown)
        self._opinions = self._shared.opinions(self._opinions, self._ticked)
        self._shared.heard(self._ticked, camera)
        if self._shared.recorder is not None:
            self._shared.recorder(controls, self._ticked.game)

    def _held(self, panel: Screen) -> Screen:
        """A panel over the game; what was held when it opened is let go."""
        self._hands = self._hands.after(FocusLost())
        if self._ticked.game.phase == Phase.PLAYING:
            self._ready = _READY_SECONDS
        return panel

    def _layout(self, size: tuple[int, int]) -> Layout:
        """Where everything is on a surface of some size."""
        return self._shared.view.seen(layout(size, self._ticked.game.level.ground_radius))


def _pause_menu(shared: Shared, play: Play) -> Menu:
    """What to do with a game that was interrupted."""
    entries = (
        Entry("Go on", lambda: play, Action.PAUSE),
        Entry("Restart", play.restarted, Action.RESTART),
        Entry("Settings", lambda: SettingsPanel(shared, menu), Action.SETTINGS),
        Entry("All levels", lambda: shared.home(shared)),
        Entry("Quit", lambda: None),
    )
    menu = Menu(shared, play, "Paused", (), entries, back=lambda: play)
    return menu


def _restart_menu(shared: Shared, play: Play) -> Menu:
    """The question before a game is thrown away."""
    entries = (Entry("Restart", play.restarted, Action.RESTART), Entry("Go on", lambda: play, Action.PAUSE))
    return Menu(shared, play, "Restart?", ("This game ends; the score is lost.",), entries, back=lambda: play)


def _end_menu(shared: Shared, play: Play, *, won: bool, score: int) -> Menu:
    """The end of a game."""
    entries = (
        Entry("Play again", play.restarted, Action.RESTART),
        Entry("All levels", lambda: shared.home(shared)),
        Entry("Quit", lambda: None),
    )
    title, line = ("You won", "Every level is cleared.") if won else ("Game over", "The last ball is gone.")
    return Menu(shared, play, title, (line, f"Score {score:,}"), entries, back=lambda: shared.home(shared))
