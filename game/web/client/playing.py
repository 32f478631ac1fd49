"""The game being played on the page."""

from game import effects
from game.autopilot import Autopilot
from game.drawing.camera import Layout, unit_of
from game.drawing.palette import Colour
from game.effects import EffectKind
from game.effects.hit_stop import hit_stop_seconds
from game.effects.slow_motion import pace
from game.input.actions import Action
from game.input.hands import Hands, controls_of_two
from game.input.key_names import key_name, players_keys, second_player_positions
from game.input.players import Players
from game.input.signals import FocusLost, Pointed, Pressed, Released, Signal, pad_of
from game.language import tr
from game.levels import Level, classic, number_of
from game.loop.fixed_step import Due, due
from game.overlay import captions
from game.overlay.captions import Caption
from game.overlay.notice_words import Notice, by_touch, notice, ready, to_newcomer, who_steers
from game.overlay.readings import readings
from game.picture.captions import add_captions
from game.picture.display_list import DisplayList
from game.picture.figures import Corners, add_figures, foot_height
from game.picture.ghost import add_ghost, add_lead
from game.picture.notice import add_notice, around
from game.rules import TICK, Controls, EventKind, Game, Phase, new_game, tick
from game.scene import scene_at, still
from game.settings import aids
from game.sound.music.mood import mood_of
from game.student.own_physics import OwnPhysics
from game.web.client.help import help_menu
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.menus import Screens
from game.web.client.messages import PageItem, PageMenu
from game.web.client.results import Counted, game_results, leaving, level_results, restart_menu
from game.web.client.settings_menu import settings_menu
from game.web.client.state import PageScreen, PageState, Pictures

_READY_SECONDS = 0.6
"""After a pause with a ball in play, until it flies on."""
_OFFER_TICKS = round(20.0 / TICK)
"""Without a paddle's touch, until the player may give up the ball."""
_END_TICKS, _WON_TICKS, _CLEARED_TICKS = 200, 500, 150
"""From the end of a game that is lost, of one that is won, whose fireworks are seen first, and of a level, to the results:
nobody who is still playing chooses an entry by accident."""
_NOTE, _NOTE_LETTER, _NOTE_UP, _NOTE_UP_NARROW = 0.9, 0.57, 0.8, 3.9
"""The line about the physics, in units: size of its letters, width of one in shares of that, height over the lower edge."""


class GameOnPage:
    """One game from its first serve on."""

    menu: PageMenu | None = None

    def __init__(
        self,
        state: PageState,
        screens: Screens,
        levels: tuple[Level, ...],
        physics: OwnPhysics | None = None,
        endless: int | None = None,
    ) -> None:
        """Start a new game at the first of the levels.

        physics: that computes the balls' flight; None for the game's own. endless: the seed of the levels; None for others.
        """
        self._physics, self._players = physics, state.players
        self._state, self._screens, self._levels, self.endless = state, screens, levels, endless
        self._ticked = still(new_game(levels, state.seed() if endless is None else endless, state.game_rules))
        self._effects = effects.at_start(state.settings.shown)
        self._hands = Hands()
        self._second = Hands()  # of the second player; unused if there is only one player
        self._due = Due(0, 0.0)
        self._ready = 0.0  # seconds until play goes on after a pause
        self._stop = 0.0  # seconds of hit-stop left
        self._pilot: Autopilot | None = None
        alone = physics is None and state.players == Players.ONE
        self._record = Counted(state, levels, counts=alone, endless=endless is not None)
        self._untouched = 0  # ticks with a ball in play since a paddle touched it
        self._last_results = -1  # number of the level whose results were shown last
        self._captions: tuple[Caption, ...] = ()
        state.end_game()
        self._record.begin_level(0, 0)

    @property
    def game(self) -> Game:
        """The game as it stands."""
        return self._ticked.game

    @property
    def ghost(self) -> Game | None:
        """The best run of the level as it is shown; None while it is not."""
        shown = self._state.settings.ghost and self._pilot is None
        return self._record.ghost.game if shown and self._record.ghost is not None else None

    @property
    def captions(self) -> list[str]:
        """The words for sounds that are shown."""
        return [caption.text for caption in self._captions]

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """What can be done at any time."""
        seen = tr("View from above") if self._state.view.goal else tr("View in 3D")
        sound = tr("Sound off") if self._state.settings.sound else tr("Sound on")
        return PageItem("pause", tr("Pause")), PageItem("view", seen), PageItem("sound", sound)

    @property
    def fragment(self) -> str:
        """The level, where it comes with the game."""
        if self._physics is not None:
            return "functions"
        if self.endless is not None:
            return f"endless/{self.endless}"
        number, _ = number_of(self.game.level, self.game.levels)
        if self.game.level in classic():
            return f"classic/{number}"
        return f"level/{number}" if self.game.level in self._state.levels else ""

    @property
    def described(self) -> str:
        """The figures."""
        shown = readings(self.game)
        words = tr("Level {number}, {name}. Score {score}, {lives} lives, {layers} layers left.")
        return words.format(
            number=shown.level_number, name=shown.level_name, score=shown.score, lives=shown.lives, layers=shown.layers
        )

    def answer(self, signal: Signal, size: tuple[int, int]) -> PageScreen:
        """Take the player's controls into account, or open a menu."""
        state = self._state
        opened = self._opened(signal)
        if opened is not None:
            self._let_go()
            return opened
        if isinstance(signal, Pressed) and signal.action is Action.GIVE_UP and self._untouched < _OFFER_TICKS:
            return self
        self._hold(signal)
        if not (isinstance(signal, Pointed) and signal.direction and self.game.phase == Phase.SERVING):  # then it aims
            state.view = state.view.after(signal, unit_of(size))
        return self

    def _hold(self, signal: Signal) -> None:
        """Note what a player holds down. If two play, the second player has keys and a gamepad of their own."""
        keys = isinstance(signal, Pressed | Released) and signal.position in second_player_positions()
        if self._players != Players.ONE and (keys or pad_of(signal) == 1):
            self._second = self._second.after(signal)
        else:
            self._hands = self._hands.after(signal)

    def _opened(self, signal: Signal) -> PageScreen | None:
        """What a signal opens; None for nothing."""
        match signal:
            case Pressed(Action.PAUSE | Action.BACK) | FocusLost():
                return self._paused()
            case Pressed(Action.RESTART):
                return restart_menu(self._state, self, lambda: self)
            case Pressed(Action.HELP):
                return help_menu(self._state, lambda: self, self)
            case Pressed(Action.SETTINGS):
                return settings_menu(self._state, lambda: self, self)
            case Pressed(Action.LAB):
                return self._screens.lab("")
            case _:
                return None

    def choose(self, item: str, value: str) -> PageScreen:
        """The toolbar."""
        del value
        state = self._state
        if item == "pause":
            return self._paused()
        if item == "view":
            state.view = state.view.after(Pressed(Action.TIP), 1.0)
        elif item == "sound":
            state.change(state.settings._replace(sound=not state.settings.sound))
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> PageScreen:
        """Run the ticks that are due; a menu when a level or the game has ended."""
        state = self._state
        state.view = state.view.later(seconds, smooth=not state.settings.reduced_motion)
        if self._ready > 0.0:
            self._ready -= seconds
            return self
        self._captions = captions.later(self._captions, seconds)
        if self._record.ghost is not None:
            self._record.ghost.prepare()
        stopped = min(self._stop, max(seconds, 0.0))
        self._stop -= stopped
        slowed = pace(self.game) if EffectKind.SLOW_MOTION in state.settings.shown else 1.0
        self._record.speed = min(self._record.speed, state.settings.speed)
        self._due = due(self._due.rest, (seconds - stopped) * slowed * state.settings.speed / 100.0)
        seen = self._layout(size)
        state.music.follow(mood_of(self.game))
        for _ in range(self._due.ticks):
            self._tick(seen)
            if EffectKind.HIT_STOP in state.settings.shown and (stop := hit_stop_seconds(self._ticked)):
                self._stop, self._due = stop, Due(0, 0.0)
                break
        return self._results() or self

    def draw(self, out: Pictures, size: tuple[int, int]) -> None:
        """The arena, the figures, and a line that says what to do."""
        state, seen, unit = self._state, self._layout(size), self._state.text_unit(size)
        scene = scene_at(self._ticked, self._due.alpha, self._effects)
        state.draw_scene(out, scene, seen.camera, size)
        badge = aids.badge(state.settings) if self._pilot is None else tr("autopilot")
        shown = readings(self.game, self._effects.streak, badge=badge)
        corners = Corners(seen, state.theme, unit)
        racing = self.ghost
        if racing is not None:
            add_ghost(out.frame, racing, seen.camera, state.theme, state.scene_unit(size))
            add_lead(out.frame, self.game, racing, seen, state.theme, unit, state.buttons_below(size))
        add_figures(out.frame, shown, corners)
        instruction = self._notice()
        if instruction is not None:
            add_notice(out.frame, instruction, seen, state.theme, unit, around(scene, seen.camera))
        foot = None if state.buttons_below(size) else foot_height(shown, corners)  # else the buttons are in the upper right
        add_captions(out.frame, self._captions, seen, state.theme, unit, foot)
        if self._physics is not None:
            _add_note(out.frame, self._physics.note, size, state.theme.accent, unit)

    def again(self) -> "GameOnPage":
        """A new game at the level being played; of endless ones at the first, as everybody begins there."""
        levels = self._levels if self.endless is not None else self._levels[self.game.number :]
        return GameOnPage(self._state, self._screens, levels, self._physics, self.endless)

    def restarted(self) -> "GameOnPage":
        """The same levels from their first serve."""
        return GameOnPage(self._state, self._screens, self._levels, self._physics, self.endless)

    def _notice(self) -> Notice | None:
        """What to tell the player."""
        if 0.0 < self._ready < _READY_SECONDS:
            return ready()
        if self.game.phase in (Phase.OVER, Phase.WON):
            return None
        serve = key_name(Action.SERVE)
        shown = notice(self.game, serve)
        if self._players != Players.ONE:
            shown = who_steers(self.game, *players_keys(), serve) or shown
        elif shown is not None:
            new = not self._state.storage.progress.value.bests
            if self._state.touched:
                shown = by_touch(shown, self.game, new=new)
            elif new:
                shown = to_newcomer(shown, key_name(Action.LEFT), key_name(Action.RIGHT))
        if shown is None and self._pilot is None and self._untouched >= _OFFER_TICKS:
            words = tr("{key}: give up this ball; it costs a life").format(key=key_name(Action.GIVE_UP))
            return Notice(tr("Out of reach?"), words)
        return shown

    def _tick(self, seen: Layout) -> None:
        """Run one tick, and record it."""
        state, game = self._state, self.game
        if self._pilot is not None:
            controls = self._pilot.controls(game)
        elif state.settings.one_button:
            controls = self._hands.one_button_controls(game)
        elif self._players != Players.ONE:
            controls = controls_of_two(self._hands, self._second, seen.camera, game)
        else:
            controls = self._hands.controls(seen.camera, game)
        self._hands, self._second = self._hands.after_tick(), self._second.after_tick()
        self._ticked = tick(game, controls) if self._physics is None else tick(game, controls, self._physics.advance)
        self._note_tick(controls, seen)

    def _note_tick(self, controls: Controls, seen: Layout) -> None:
        """Let everything that follows the game know of a tick. controls: that it was given."""
        state = self._state
        events = self._ticked.events
        if self._record.ghost is not None:
            self._record.ghost.after_tick(self.game)
        if state.settings.captions:
            self._captions = captions.after(self._captions, self._ticked, seen.camera)
            state.announcements += captions.rare(events)
        touched = self.game.phase != Phase.PLAYING or any(
            [event.kind in {EventKind.PADDLE_HIT, EventKind.SERVED} for event in events]
        )
        self._untouched = 0 if touched else self._untouched + 1
        self._effects = effects.after(self._effects, self._ticked, state.settings.shown)
        state.play_sounds(self._ticked, seen.camera)
        if self._record.counts:
            state.storage.games(controls, self.game)
        for event in events:
            if event.kind == EventKind.LEVEL_STARTED:
                self._record.begin_level(self.game.tick, self.game.number)
            elif event.kind == EventKind.LEVEL_CLEARED:
                self._record.note_level(self.game)
            elif event.kind == EventKind.BALL_LOST:
                state.announcements.append(tr("Ball lost. {lives} lives left.").format(lives=self.game.lives))

    def _results(self) -> PageScreen | None:
        """The menu after a level or the game, once its end has been seen for a moment."""
        game = self.game
        until = _WON_TICKS if game.phase == Phase.WON else _END_TICKS
        if game.phase in (Phase.OVER, Phase.WON) and game.phase_tick >= until:
            return game_results(self._state, self._screens, self, self._record)
        cleared = game.phase == Phase.CLEARED and game.phase_tick >= _CLEARED_TICKS
        if cleared and self._last_results < game.number and self._pilot is None:
            self._last_results = game.number
            return level_results(self._state, self._screens, self, self._record)
        return None

    def went_on(self) -> PageScreen:
        """Start the next level at once, and return this game."""
        self._hands = self._hands.after(Pressed(Action.SERVE))
        return self

    def _paused(self) -> PageScreen:
        """The menu of a game that was interrupted."""
        self._let_go()

        def contents(menu: MenuScreen) -> tuple[tuple[str, ...], tuple[Opened, ...]]:
            def let_play(value: str) -> PageScreen:
                self._pilot = Autopilot() if value == "True" else None
                self._record.counts = self._record.counts and self._pilot is None
                return menu

            pilot = PageItem("autopilot", tr("Let the program play"), "switch", str(self._pilot is not None))
            return (self.described,), (
                Opened(PageItem("go-on", tr("Continue")), lambda _: self),
                Opened(PageItem("restart", tr("Restart")), lambda _: restart_menu(self._state, self, lambda: menu)),
                Opened(PageItem("help", tr("How to play")), lambda _: help_menu(self._state, lambda: menu, self)),
                Opened(PageItem("settings", tr("Settings")), lambda _: settings_menu(self._state, lambda: menu, self)),
                Opened(pilot, let_play),
                *leaving(self._state, self._screens),
            )

        return MenuScreen(self._state, tr("Paused"), contents, lambda: self, self)

    def _let_go(self) -> None:
        """Keys that were held when a menu opened are let go; play goes on a moment after it."""
        self._hands, self._second = self._hands.after(FocusLost()), Hands()
        self._state.view = self._state.view.after(FocusLost(), 1.0)
        if self.game.phase == Phase.PLAYING:
            self._ready = _READY_SECONDS

    def _layout(self, size: tuple[int, int]) -> Layout:
        """Where everything is."""
        return self._state.layout(size, self.game.level.ground_radius)


def _add_note(out: DisplayList, note: str, size: tuple[int, int], colour: Colour, unit: float) -> None:
    """Add the line about the physics at the lower edge, on a narrow canvas above the figures; smaller if it would not fit."""
    letters = unit * min(_NOTE, size[0] / (unit * _NOTE_LETTER * (len(note) + 4)))
    up = _NOTE_UP if size[0] > size[1] else _NOTE_UP_NARROW
    out.text(note, letters, complex(size[0] / 2.0, size[1] - up * unit), colour, bold=0.0)
