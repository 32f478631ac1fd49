"""The screen of the game being played."""

import pygame

from game import effects
from game.autopilot import Autopilot
from game.drawing import contact_normals
from game.drawing.camera import Camera, Layout, layout, unit_of
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.effects import EffectKind
from game.effects.hit_stop import hit_stop_seconds
from game.effects.slow_motion import pace
from game.input.hands import Hands, controls_of_two
from game.input.key_names import key_name, players_keys, second_player_positions
from game.input.keys import Action
from game.input.players import Players
from game.input.signals import Clicked, FocusLost, KeyboardState, Moved, Pointed, Pressed, Released, Signal, pad_of
from game.language import tr
from game.levels import Level, number_of
from game.levels.names import level_name
from game.loop.fixed_step import Due, due
from game.overlay import captions, hud, notice
from game.overlay.captions import Caption
from game.overlay.notice_words import Notice, ready, to_newcomer, who_steers
from game.overlay.notice_words import notice as words_now
from game.overlay.readings import readings
from game.overlay.toast import Toast
from game.picture.captions import add_captions
from game.picture.display_list import DisplayList
from game.picture.ghost import add_ghost, add_lead
from game.rules import TICK, Controls, EventKind, Game, Phase, new_game, tick
from game.scene import scene_at, still
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.help.panel import Help
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play import buttons as play_buttons
from game.screens.play.record import PlayRecord
from game.screens.play.results import game_results, level_results, ways_out
from game.screens.toolkit.menu import Entry, Menu
from game.second_opinion import NormalPair
from game.settings import aids

_READY_SECONDS = 0.6
"""After a pause with a ball in play, until it flies on."""
_OFFER_TICKS = round(20.0 / TICK)
"""Without a paddle's touch, until the player may give up the ball."""
_END_TICKS = 200
"""From the end of the game to the results: nobody who is still playing chooses an entry by accident."""
_WON_TICKS = 500
"""From the end of a game that is won to the results: its fireworks are seen first."""
_CLEARED_TICKS = 150
"""From the last brick of a level to its results: it is seen breaking first."""
_NEWS_SECONDS = 5.0
"""How long news of the physics is shown."""
# Lengths are in units of text.
_NOTE, _NOTE_ROOM, _NOTE_BOTTOM, _NOTE_MARGIN = 0.95, 1.6, 0.3, 0.8
"""The line about the physics: size of its letters, height left to it, from it to the lower edge and to the sides."""


class PlayScreen:
    """One game from its first serve on."""

    def __init__(self, state: AppState, levels: tuple[Level, ...], endless: int | None = None) -> None:
        """Start a new game at the first of the levels. endless: the seed that they were made from; None for others."""
        self._state, self._levels, self.endless = state, levels, endless
        self._ticked = still(new_game(levels, state.next_seed() if endless is None else endless, state.game_rules))
        self._effects = effects.at_start(state.settings.shown)
        self._normals: tuple[NormalPair, ...] = ()
        self._hands = Hands()
        self._second = Hands()  # of the second player; empty where there is one
        self._due = Due(0, 0.0)
        self._ready = 0.0  # seconds until play goes on after a pause
        self._stop = 0.0  # seconds of hit-stop left
        self._pilot = Autopilot() if state.autopilot else None
        self._captions: tuple[Caption, ...] = ()
        self._untouched = 0  # ticks with a ball in play since a paddle touched it
        self._hovered: Action | None = None  # what the button means that the mouse is on
        self._told = -1  # number of the level whose results were shown last
        self._record = PlayRecord(state, levels, endless=endless is not None)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Take the player's controls into account, or open a panel."""
        match signal:
            case Moved(pixel):
                self._hovered = play_buttons.action_at(self._layout(size), pixel)
            case Clicked(pixel) if (action := play_buttons.action_at(self._layout(size), pixel)) is not None:
                signal = Pressed(action)
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
        self._hold(signal)
        if not (isinstance(signal, Pointed) and signal.direction and self._ticked.game.phase == Phase.SERVING):  # it aims
            self._state.view = self._state.view.after(signal, unit_of(size))
        return self

    def _hold(self, signal: Signal) -> None:
        """Note what a player holds down. If two play, each has keys and a gamepad of their own."""
        if self._state.players == Players.ONE:
            self._hands = self._hands.after(signal)
            return
        keys = isinstance(signal, Pressed | Released) and signal.position in second_player_positions()
        keys = keys or pad_of(signal) == 1
        if keys or isinstance(signal, KeyboardState):
            self._second = self._second.after(signal)
        if not keys:
            self._hands = self._hands.after(signal)

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Run the ticks that are due. Returns a panel when a level or the game has ended."""
        self._state.view = self._state.view.later(seconds, smooth=not self._state.settings.reduced_motion)
        if news := self._state.physics.news():
            self._state.toast = Toast(news, left=_NEWS_SECONDS)
        if self._ready > 0.0:
            self._ready -= seconds
            return self
        self._captions = captions.later(self._captions, seconds)
        stopped = min(self._stop, max(seconds, 0.0))
        self._stop -= stopped
        slowed = pace(self._ticked.game) if EffectKind.SLOW_MOTION in self._state.settings.shown else 1.0
        self._due = due(self._due.rest, (seconds - stopped) * slowed * self._state.settings.speed / 100.0)
        self._record.prepare()
        camera = self._layout(size).camera
        for _ in range(self._due.ticks):
            self._tick(camera)
            if EffectKind.HIT_STOP in self._state.settings.shown and (stop := hit_stop_seconds(self._ticked)):
                self._stop, self._due = stop, Due(0, 0.0)
                break
        return self._results() or self

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the arena, the figures, and a line that says what to do."""
        state, seen = self._state, self._layout(surface.get_size())
        canvas = state.canvas(surface, seen.camera)
        scene = scene_at(self._ticked, self._due.alpha, self._effects)
        state.painter.paint(canvas, scene)
        racing = None if self._record.ghost is None or not state.settings.ghost else self._record.ghost.game
        if racing is not None:
            _paint_ghost(canvas, self._ticked.game, racing, seen, state.words(canvas).unit)
        if state.shows_normals:
            contact_normals.draw(canvas, self._normals)
        badge = aids.badge(state.settings) if self._pilot is None else tr("autopilot")
        shown = readings(self._ticked.game, self._effects.streak, muted=not state.settings.sound, badge=badge)
        words = state.words(canvas)
        hud.draw(words, shown, seen)
        play_buttons.draw(canvas, seen, self._hovered)
        told = self._notice()
        if told is not None:
            notice.draw(words, told, scene, seen)
        if self._captions:
            picture = DisplayList()
            add_captions(picture, self._captions, seen, state.theme, words.unit)
            DisplayListPainter().paint(surface, words.type, picture)
        if state.physics.note:
            _draw_note(canvas, tr(state.physics.note))

    @property
    def _may_give_up(self) -> bool:
        """Whether the ball has been out of reach for so long that the player may give it up."""
        return self._pilot is None and self._untouched >= _OFFER_TICKS

    def _notice(self) -> Notice | None:
        """The notice for the player; None if the results are about to say the same."""
        if 0.0 < self._ready < _READY_SECONDS:
            return ready()
        game = self._ticked.game
        if game.phase in (Phase.OVER, Phase.WON) or (game.phase == Phase.CLEARED and self._told == game.number):
            return None
        told = words_now(game, key_name(Action.SERVE))
        if self._state.players != Players.ONE:
            told = who_steers(game, *players_keys(), key_name(Action.SERVE)) or told
        elif told is not None and not self._state.storage.progress.value.bests:
            told = to_newcomer(told, key_name(Action.LEFT), key_name(Action.RIGHT))
        if told is None and self._may_give_up:
            words = tr("{key}: give up this ball; it costs a life").format(key=key_name(Action.GIVE_UP))
            return Notice(tr("Out of reach?"), words)
        return told

    @property
    def standing(self) -> str:
        """A line that names the level being played."""
        game = self._ticked.game
        number, _ = number_of(game.level, game.levels)
        if self.endless is not None:
            return tr("{name}, levels from number {seed}").format(name=level_name(game.level.name), seed=self.endless)
        return tr("Level {number}: {name}").format(number=number, name=level_name(game.level.name))

    def restarted(self) -> Screen:
        """The same levels from their first serve."""
        return PlayScreen(self._state, self._levels, self.endless)

    def again(self) -> Screen:
        """A new game at the level being played; of endless ones at the first, as everybody begins there."""
        if self.endless is not None:
            return self.restarted()
        return PlayScreen(self._state, self._levels[self._ticked.game.number :])

    def went_on(self) -> Screen:
        """This screen, at the next level."""
        self._let_go()
        self._hands = self._hands.after(Pressed(Action.SERVE))
        return self

    def _results(self) -> Screen | None:
        """The panel after a level or the game, shown a moment after its end."""
        game = self._ticked.game
        if game.phase in (Phase.OVER, Phase.WON) and game.phase_tick >= (_WON_TICKS if game.phase == Phase.WON else _END_TICKS):
            return game_results(self._state, self, game, self._record)
        if (
            game.phase == Phase.CLEARED
            and game.phase_tick >= _CLEARED_TICKS
            and self._told < game.number
            and self._pilot is None
        ):
            self._told = game.number
            return level_results(self._state, self, game, self._record)
        return None

    def _tick(self, camera: Camera) -> None:
        """Run one tick and tell the recorder."""
        game = self._ticked.game
        controls = self._controls(camera) if self._pilot is None else self._pilot.controls(game)
        self._hands, self._second = self._hands.after_tick(), self._second.after_tick()
        self._ticked = tick(game, controls, self._state.physics.advance)
        touched = self._ticked.game.phase != Phase.PLAYING or any(
            [event.kind in {EventKind.PADDLE_HIT, EventKind.SERVED} for event in self._ticked.events]
        )
        self._untouched = 0 if touched else self._untouched + 1
        self._effects = effects.after(self._effects, self._ticked, self._state.settings.shown)
        self._normals = self._state.normals_after(self._normals, self._ticked)
        self._state.play_sounds(self._ticked, camera)
        if self._state.settings.captions:
            self._captions = captions.after(self._captions, self._ticked, camera)
        if self._state.recorder is not None:
            self._state.recorder(controls, self._ticked.game)
        self._record.after_tick(self._ticked)

    def _controls(self, camera: Camera) -> Controls:
        """What the player asks for in the next tick."""
        if self._state.settings.one_button:
            return self._hands.one_button_controls(self._ticked.game)
        game = self._ticked.game
        if self._state.players == Players.ONE:
            return self._hands.controls(camera, game)
        return controls_of_two(self._hands, self._second, camera, game)

    def _paused(self, panel: Screen) -> Screen:
        """A panel over the game; keys that are held count as released."""
        self._let_go()
        if self._ticked.game.phase == Phase.PLAYING:
            self._ready = _READY_SECONDS
        return panel

    def _let_go(self) -> None:
        """Count everything as released: a key that comes up while another screen is open is not reported here."""
        self._hands, self._second, self._hovered = self._hands.after(FocusLost()), Hands(), None
        self._state.view = self._state.view.after(FocusLost(), 1.0)

    def _layout(self, size: tuple[int, int]) -> Layout:
        """The layout of a surface of some size."""
        below = unit_of(size) * _NOTE_ROOM if self._state.physics.note else 0.0
        return self._state.view.seen(layout(size, self._ticked.game.level.ground_radius, below))


def _paint_ghost(canvas: Canvas, game: Game, ghost: Game, seen: Layout, text_unit: float) -> None:
    """The ghost, and how far ahead of it the player is."""
    picture = DisplayList()
    add_ghost(picture, ghost, canvas.camera, canvas.theme, canvas.unit)
    add_lead(picture, game, ghost, seen, canvas.theme, text_unit)
    DisplayListPainter().paint(canvas.surface, canvas.type, picture)


def _draw_note(canvas: Canvas, note: str) -> None:
    """Write a line at the lower edge of the surface, in smaller letters if it would not fit into the width."""
    width, height = canvas.size
    length = canvas.type.rendered(note, canvas.unit * _NOTE, canvas.theme.accent).get_width()
    size = _NOTE * min((width - 2.0 * _NOTE_MARGIN * canvas.unit) / length, 1.0)
    pixel = complex(width / 2.0, height - canvas.unit * _NOTE_BOTTOM)
    canvas.write(note, size, canvas.theme.accent, pixel, "midbottom")


def _pause_menu(state: AppState, play: PlayScreen) -> Menu:
    """The menu of a paused game."""
    entries = (
        Entry(tr("Continue"), lambda: play, Action.PAUSE),
        Entry(tr("Restart"), lambda: _restart_menu(state, play), Action.RESTART),
        Entry(tr("How to play"), lambda: Help(state, menu), Action.HELP),
        Entry(tr("Settings"), lambda: SettingsPanel(state, menu), Action.SETTINGS),
        *ways_out(state),
        *((Entry(tr("Quit"), lambda: None),) if state.open_levels is not None else ()),
    )
    menu = Menu(state, play, tr("Paused"), (play.standing,), entries, back=lambda: play)
    return menu


def _restart_menu(state: AppState, play: PlayScreen) -> Menu:
    """The question before a game is abandoned; the safe answer is selected."""
    entries = (
        Entry(tr("Continue"), lambda: play, Action.PAUSE),
        Entry(tr("This level again"), play.again, Action.RESTART),
        Entry(tr("From the first level"), play.restarted),
    )
    return Menu(state, play, tr("Restart?"), (tr("This game ends; the score is lost."),), entries, back=lambda: play)
