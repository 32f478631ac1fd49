"""The menus of the page: title, levels, scores, replays, help. Behind them the autopilot plays."""

import datetime as dt
from collections.abc import Callable, Iterable
from typing import NamedTuple

from game.generated import daily_seed
from game.input.actions import Action
from game.input.players import Players, players_words
from game.input.signals import Pressed, Signal
from game.language import grouped, tr
from game.levels import Level, classic
from game.levels.names import level_name
from game.picture.display_list import DisplayList
from game.screens.demo import Demo
from game.screens.difficulty_names import DIFFICULTIES, difficulty_name
from game.screens.endless_seeds import LONGEST_SEED, new_seed, seed_of
from game.storage.progress import RANKS
from game.storage.scores import ENDLESS
from game.web.client.functions.text import FunctionsText
from game.web.client.keys import PLAYERS_KEYS
from game.web.client.messages import PageItem, PageMenu
from game.web.client.state import PageScreen, PageState, Pictures

NAME = "Polar Breakout"
_DEMO_SEED = 5
_ASIDE = 0.17
"""How far to the right the demonstration is, in shares of a wide canvas: the menu stands at the left."""
_STILL_SECONDS = 6.0
"""With reduced motion: the moment of the demonstration that is shown."""


_GOES_ON = frozenset({"go-on", "next"})
"""Items with the same effect as going back: a menu with one of them has no further item for it."""


class Opened(NamedTuple):
    """An item of a menu, and what using it does: the screen that follows. Its argument is the control's value."""

    item: PageItem
    used: Callable[[str], PageScreen]


class MenuScreen:
    """A menu over a game that plays itself, or over another screen that stands still."""

    fragment = ""

    def __init__(
        self,
        state: PageState,
        title: str,
        contents: Callable[["MenuScreen"], tuple[Iterable[str], Iterable[Opened]]],
        back: Callable[[], PageScreen] | None = None,
        under: PageScreen | None = None,
    ) -> None:
        """contents: lines and items, asked for anew after every use. back: what Escape does. under: what stands behind it."""
        self.state, self._title, self._contents, self._back, self._under = state, title, contents, back, under
        self._demo = None if under is not None else Demo(state.levels[0], _DEMO_SEED)
        self._shown_still = False
        self._menu: PageMenu | None = None
        self._used: dict[str, Callable[[str], PageScreen]] = {}

    @property
    def menu(self) -> PageMenu:
        """Its title, lines and items."""
        if self._menu is None:
            lines, opened = self._contents(self)
            opened = list(opened)
            if self._back is not None and not _GOES_ON.intersection([one.item.id for one in opened]):
                back = self._back
                opened.append(Opened(PageItem("back", tr("Back")), lambda _value: back()))
            self._used = {one.item.id: one.used for one in opened}
            self._menu = PageMenu(self._title, tuple(lines), tuple([one.item for one in opened]))
        return self._menu

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """None: the menu has all."""
        return ()

    @property
    def described(self) -> str:
        """What is behind it."""
        return tr("A game that plays itself.") if self._under is None else self._under.described

    def answer(self, signal: Signal, size: tuple[int, int]) -> PageScreen:
        """Escape and the pause key lead back."""
        del size
        if isinstance(signal, Pressed) and signal.action in (Action.BACK, Action.PAUSE) and self._back is not None:
            return self._back()
        return self

    def choose(self, item: str, value: str) -> PageScreen:
        """What an item does; the menu is made anew."""
        if self._menu is None:
            _ = self.menu
        self._menu = None
        used = self._used.get(item)
        return self if used is None else used(value)

    def advance(self, seconds: float, size: tuple[int, int]) -> PageScreen:
        """Let the demonstration play; with reduced motion it stands still at some moment."""
        del size
        if self._demo is None:
            return self
        if self.state.settings.reduced_motion:
            if not self._shown_still:
                self._shown_still = True
                for _ in range(round(_STILL_SECONDS * 4)):
                    self._demo.advance(0.25, self.state.settings.shown)
        else:
            self._demo.advance(seconds, self.state.settings.shown)
        if self._demo.ended:
            self._demo = Demo(self.state.levels[0], _DEMO_SEED)
        return self

    def draw(self, out: Pictures, size: tuple[int, int]) -> None:
        """What is behind the menu."""
        if self._under is not None:
            self._under.draw(out, size)
        elif self._demo is not None:
            scene = self._demo.scene()
            seen = self.state.layout(size, scene.ground_radius)
            aside = _ASIDE * size[0] if seen.beside else 0.0
            self.state.draw_scene(out, scene, seen.camera._replace(centre=seen.camera.centre + aside), size)
        else:
            out.frame = DisplayList()


class Screens(NamedTuple):
    """The screens that menus lead to, handed in by the page: so no module of screens imports another in a circle."""

    title: Callable[[], PageScreen]
    game: Callable[[tuple[Level, ...]], PageScreen]
    replay: Callable[[str, bytes], PageScreen]
    lab: Callable[[str], PageScreen]
    flight: Callable[[FunctionsText], PageScreen]
    settings: Callable[[], PageScreen]
    endless: Callable[[int], PageScreen]


def title(state: PageState, screens: Screens) -> MenuScreen:
    """The first menu."""

    def contents(_menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        index = next_level(state)
        playing = tr("Play") if index == 0 else tr("Continue: {level}").format(level=level_name(state.levels[index].name))
        return (), (
            Opened(PageItem("play", playing), lambda _: screens.game(state.levels[index:])),
            Opened(PageItem("levels", tr("Levels")), lambda _: levels_menu(state, screens)),
            Opened(PageItem("endless", tr("Endless")), lambda _: endless_menu(state, screens)),
            Opened(PageItem("lab", tr("The lab")), lambda _: screens.lab("")),
            Opened(PageItem("replays", tr("Replays")), lambda _: replays_menu(state, screens)),
            Opened(PageItem("scores", tr("High scores")), lambda _: scores_menu(state, screens)),
            Opened(PageItem("settings", tr("Settings")), lambda _: screens.settings()),
            Opened(PageItem("help", tr("How to play")), lambda _: help_menu(state, screens.title)),
        )

    return MenuScreen(state, NAME, contents)


def next_level(state: PageState) -> int:
    """Index of the first level that is open and was not finished yet; the first where all are finished."""
    progress, names = state.storage.progress.value, [level.name for level in state.levels]
    return next((k for k, name in enumerate(names) if not progress.finished(name) and progress.is_open(k, names)), 0)


def levels_menu(state: PageState, screens: Screens) -> MenuScreen:
    """The choice of a level, and of the difficulty."""

    def contents(menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        progress, names = state.storage.progress.value, [level.name for level in state.levels]

        def chosen(value: str) -> PageScreen:
            state.choose_difficulty(value)
            return menu

        options = tuple([(name, difficulty_name(name)) for name in DIFFICULTIES])
        items = [
            Opened(PageItem("difficulty", tr("Difficulty"), "choice", state.difficulty, options), chosen),
            players_choice(state, menu),
        ]
        for index, level in enumerate(state.levels):
            best = progress.best(level.name, state.difficulty)
            is_open = progress.is_open(index, names)
            done = "" if best is None else f"  {RANKS[best.rank]}  {grouped(best.score)}"
            before = level_name(names[index - 1])
            hint = tr(level.description) if is_open else tr("Finish {level} to unlock this level.").format(level=before)
            label = f"{index + 1}  {level_name(level.name)}{done}"
            items.append(
                Opened(
                    PageItem(f"level-{index + 1}", label, hint=hint, disabled=not is_open),
                    _begins(state.levels, screens, index),
                )
            )
        for index, level in enumerate(classic()):
            item = PageItem(
                f"classic-{index + 1}", tr("Classic {level}").format(level=level_name(level.name)), hint=tr(level.description)
            )
            items.append(Opened(item, _begins(classic(), screens, index)))
        for name, own in state.own.items():
            items.append(Opened(PageItem(f"own-{name}", own.name, hint=name), _begins_own(screens, own)))
        return (), items

    return MenuScreen(state, tr("Levels"), contents, screens.title)


def players_choice(state: PageState, menu: MenuScreen) -> Opened:
    """The choice of the number of players."""

    def chosen(value: str) -> PageScreen:
        state.players = next((players for players in Players if players.name == value), state.players)
        return menu

    words = players_words(*PLAYERS_KEYS)
    options = tuple([(players.name, words[players][0]) for players in Players])
    tip = words[state.players][1]
    return Opened(PageItem("players", tr("Players"), "choice", state.players.name, options, hint=tip), chosen)


def endless_menu(state: PageState, screens: Screens) -> MenuScreen:
    """The choice of levels made from a seed: today's, or new ones."""

    def contents(_menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        day = dt.datetime.now(tz=dt.UTC).date()
        same = tr("Everyone gets the same levels on {day}.").format(day=day)
        return (tr("Levels made from a number: the same number gives everyone the same levels."),), (
            Opened(PageItem("today", tr("Today's levels"), hint=same), lambda _: screens.endless(daily_seed(day))),
            Opened(PageItem("new", tr("New levels")), lambda _: screens.endless(new_seed())),
            Opened(
                PageItem("number", tr("Levels from a number"), "text", "", high=LONGEST_SEED),
                lambda value: screens.endless(seed_of(value)),
            ),
        )

    return MenuScreen(state, tr("Endless"), contents, screens.title)


def _begins(levels: tuple[Level, ...], screens: Screens, index: int) -> Callable[[str], PageScreen]:
    """Starts some levels at one of them."""
    return lambda _value: screens.game(levels[index:])


def _begins_own(screens: Screens, level: Level) -> Callable[[str], PageScreen]:
    """Starts a level of the player's."""
    return lambda _value: screens.game((level,))


def scores_menu(state: PageState, screens: Screens) -> MenuScreen:
    """The best scores of every difficulty."""

    def contents(_menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        lines = []
        for name in (*DIFFICULTIES, ENDLESS):
            table = state.storage.scores.value.table(name)
            lines += [tr("Endless") if name == ENDLESS else difficulty_name(name)] if table else []
            lines += [
                f"{place}.  {grouped(score.score)}  {score.name}  {level_name(score.last)}"
                for place, score in enumerate(table, 1)
            ]
        return lines or [tr("No scores yet.")], ()

    return MenuScreen(state, tr("High scores"), contents, screens.title)


def replays_menu(state: PageState, screens: Screens) -> MenuScreen:
    """The games that were kept."""

    def contents(_menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        games = state.storage.games.listed()
        items = [
            Opened(
                PageItem(f"replay-{game.file}", f"{game.title or game.date}  {level_name(game.first)}  {grouped(game.score)}"),
                _watches(state, screens, game.file),
            )
            for game in games
        ]
        lines = (
            []
            if items
            else [tr("None yet: games of five seconds or more are kept when they end. A file can be dropped on this page.")]
        )
        return lines, items

    return MenuScreen(state, tr("Replays"), contents, screens.title)


def _watches(state: PageState, screens: Screens, file: str) -> Callable[[str], PageScreen]:
    """Opens a kept game."""

    def opened(_value: str) -> PageScreen:
        folder = state.storage.games.folder
        try:
            data = b"" if folder is None else (folder / file).read_bytes()
        except OSError as error:
            state.notifications.append(f"{file}: {error.strerror}")
            return screens.title()
        return screens.replay(file, data)

    return opened


def help_menu(state: PageState, back: Callable[[], PageScreen], under: PageScreen | None = None) -> MenuScreen:
    """How to play."""
    return MenuScreen(state, tr("How to play"), lambda _menu: (_help_lines(), ()), back, under)


def _help_lines() -> tuple[str, ...]:
    """Lines about the controls."""
    return (
        tr("Left and right arrows, or A and D: turn the paddles. The mouse or a finger: the nearest paddle follows it."),
        tr("Space, a click or a tap: serve along the arrow. G: give up a ball that is out of reach."),
        tr("P or Escape: pause. 1 and 2: the view from above, the view in 3D; the right button or two fingers turn it."),
        tr("M: sound. T: dark or light colours. O: settings. L: the lab."),
        tr("A gamepad's left stick points the paddles, A serves, Y changes the view; in menus its arrows move, A chooses."),
        tr("Drop a replay (.polar), a level (.toml) or functions of your own (.py) on this page to open them."),
    )
