"""The menus of the page: title, levels, scores."""

import datetime as dt
from collections.abc import Callable, Iterable
from typing import NamedTuple

from game.generated import daily_seed
from game.input.key_names import players_keys
from game.input.players import Players, players_words
from game.language import grouped, tr
from game.levels import Level, classic
from game.levels.names import level_name
from game.screens.difficulty_names import DIFFICULTIES, difficulty_name
from game.screens.endless_seeds import LONGEST_SEED, new_seed, seed_of
from game.storage.progress import RANKS
from game.storage.scores import ENDLESS
from game.web.client.functions.text import FunctionsText
from game.web.client.help import credits_menu, help_menu
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.messages import PageItem
from game.web.client.state import PageScreen, PageState
from game.web.client.stored_games import replays_menu

NAME = "Polar Breakout"


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
            Opened(PageItem("replays", tr("Replays")), lambda _: replays_menu(state, screens.replay, screens.title)),
            Opened(PageItem("scores", tr("High scores")), lambda _: scores_menu(state, screens)),
            Opened(PageItem("settings", tr("Settings")), lambda _: screens.settings()),
            Opened(PageItem("help", tr("How to play")), lambda _: help_menu(state, screens.title)),
            Opened(PageItem("credits", tr("Credits")), lambda _: credits_menu(state, screens.title)),
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
                    _begins(screens, state.levels[index:]),
                )
            )
        for index, level in enumerate(classic()):
            item = PageItem(
                f"classic-{index + 1}", tr("Classic {level}").format(level=level_name(level.name)), hint=tr(level.description)
            )
            items.append(Opened(item, _begins(screens, classic()[index:])))
        for name, own in state.own.items():
            items.append(Opened(PageItem(f"own-{name}", own.name, hint=name), _begins(screens, (own,))))
        return (), items

    return MenuScreen(state, tr("Levels"), contents, screens.title)


def players_choice(state: PageState, menu: MenuScreen) -> Opened:
    """The choice of the number of players."""

    def chosen(value: str) -> PageScreen:
        state.players = next((players for players in Players if players.name == value), state.players)
        return menu

    words = players_words(*players_keys())
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


def _begins(screens: Screens, levels: tuple[Level, ...]) -> Callable[[str], PageScreen]:
    """Starts a game of some levels."""
    return lambda _value: screens.game(levels)


def scores_menu(state: PageState, screens: Screens) -> MenuScreen:
    """The best scores of every difficulty."""

    def contents(_menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        lines = []
        for name in (*DIFFICULTIES, ENDLESS):
            table = state.storage.scores.value.table(name)
            lines += [tr("Endless") if name == ENDLESS else difficulty_name(name)] if table else []
            lines += [
                f"{number}.  {grouped(score.score)}  {score.name}  {level_name(score.last)}"
                for number, score in enumerate(table, 1)
            ]
        return lines or [tr("No scores yet.")], ()

    return MenuScreen(state, tr("High scores"), contents, screens.title)
