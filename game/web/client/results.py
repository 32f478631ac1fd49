"""Records of a game on the page, and the menus after a level and after a game."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import msgspec

from game.language import grouped, tr
from game.levels import Level
from game.levels.names import level_name
from game.overlay.readings import player_name
from game.rules import Game, Phase, winner
from game.screens.earned import earned
from game.screens.play.versus import verdict
from game.storage.ghost import Ghost, ghost_of
from game.storage.progress import RANKS, Best, is_built_in, record_name
from game.storage.scores import ENDLESS, LONGEST_NAME, Score
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.menus import Screens, levels_menu
from game.web.client.messages import PageItem
from game.web.client.state import PageScreen, PageState


class Played(PageScreen, Protocol):
    """A game on the page, as the menus of its results use it. endless: the seed of its levels, None for others."""

    endless: int | None

    @property
    def game(self) -> Game:
        """The present state of the game."""

    def went_on(self) -> PageScreen:
        """Start the next level at once, and return the game."""

    def again(self) -> PageScreen:
        """A new game at the level that is played."""

    def restarted(self) -> PageScreen:
        """A new game on the same levels."""


@dataclass
class Counted:
    """What is recorded of a game.

    levels: of the game. counts: whether bests, scores and the replay are stored: only for a single player without the
    autopilot.
    endless: whether its levels are made from a seed. start: tick at which the level began. speed: lowest game speed so far, per
    cent. ghost: the best run of the level that is played; None without one. unlocked: names of the balls and trails that were
    unlocked by the level finished last.
    """

    state: PageState
    levels: tuple[Level, ...]
    counts: bool
    endless: bool
    start: int = 0
    speed: int = 100
    ghost: Ghost | None = None
    unlocked: tuple[str, ...] = ()

    @property
    def ranked(self) -> bool:
        """Whether the game's score may enter a table: not on a player's own levels, which may be easy."""
        return self.counts and (self.endless or all([is_built_in(level) for level in self.levels]))

    def begin_level(self, tick: int, number: int) -> None:
        """A level begins. tick: of the game. number: of the level in the game."""
        self.start, self.ghost = tick, None
        if self.counts and not self.endless:
            self.ghost = ghost_of(self.state.storage, self.levels[number], self.state.difficulty, number)

    def note_level(self, game: Game) -> None:
        """Record a finished level, if the game counts."""
        state, result = self.state, game.results[-1]
        state.announcements.append(tr("Level cleared"))
        if self.counts and not self.endless:
            name, rank = record_name(game.level), int(result.rank)
            done = Best(name, state.difficulty, result.score, rank, result.ticks, start=self.start)
            before = earned(state.storage.progress.value)
            state.storage.level_done(done)
            self.unlocked = tuple([name for name in earned(state.storage.progress.value) if name not in before])
            state.changed = True
            state.notify_problems()


def restart_menu(state: PageState, play: Played, back: Callable[[], PageScreen]) -> PageScreen:
    """The question before a game is thrown away. back: makes the screen that follows if it is not."""
    items = (
        Opened(PageItem("go-on", tr("Continue")), lambda _value: back()),
        Opened(PageItem("level", tr("This level again")), lambda _value: play.again()),
        Opened(PageItem("first", tr("From the first level")), lambda _value: play.restarted()),
    )
    return MenuScreen(state, tr("Restart?"), lambda _menu: ((tr("This game ends; the score is lost."),), items), back, play)


def level_results(state: PageState, screens: Screens, play: Played, record: Counted) -> PageScreen:
    """The menu after a level: its results, and the next level."""
    game = play.game
    result = game.results[-1]
    points = tr("{score} points, {lost} balls lost, best combo {combo}")
    lines = [points.format(score=grouped(result.score), lost=result.balls_lost, combo=result.best_combo)]
    if not game.sides:
        lines.insert(0, tr("Rank {rank}").format(rank=RANKS[int(result.rank)]))
    elif (ahead := winner(game)) is not None:
        lines.insert(0, tr("{level}. {player} is ahead.").format(level=level_name(game.level.name), player=player_name(ahead)))
    if record.unlocked:
        things = ", ".join(record.unlocked)
        lines.append(tr("{level}. Unlocked in the settings: {things}").format(level=level_name(game.level.name), things=things))
    following = tr("Next: {level}").format(level=level_name(game.levels[game.number + 1].name))
    items = (Opened(PageItem("next", following), lambda _value: play.went_on()), *leaving(state, screens))
    return MenuScreen(state, tr("Level cleared"), lambda _menu: (lines, items), play.went_on, play)


def game_results(state: PageState, screens: Screens, play: Played, record: Counted) -> PageScreen:
    """The menu after a game: its results, the entry of a name for a high score, its replay, and where to go next."""
    game, won = play.game, play.game.phase == Phase.WON
    last = state.storage.game_done() if record.counts else None
    state.changed = True
    state.notify_problems()
    lines = [tr("Score {score}").format(score=grouped(game.score))]
    if game.sides:
        lines = [f"{player_name(index)}: {grouped(side.score)}" for index, side in enumerate(game.sides)]
    items: list[Opened] = []
    table = ENDLESS if record.endless else state.difficulty
    if record.ranked and state.storage.scores.value.qualifies(game.score, table):
        proof = (last.file, last.sha256) if last is not None else ()
        to = game.level.name if play.endless is None else f"{game.level.name} ({play.endless})"
        first, date = game.levels[0].name, time.strftime("%Y-%m-%d")
        items.append(_name_item(state, screens, Score("", game.score, table, first, to, won, record.speed, date, *proof)))
    if last is not None and state.storage.games.folder is not None:
        path = state.storage.games.folder / last.file
        items.append(Opened(PageItem("watch", tr("Watch the replay")), lambda _: screens.replay(path.name, path.read_bytes())))
    items += _begin_again(play)
    items += leaving(state, screens)
    heading = verdict(game) if game.sides else tr("You won") if won else tr("Game over")
    return MenuScreen(state, heading, lambda _menu: (lines, items), under=play)


def _begin_again(play: Played) -> list[Opened]:
    """The entries that begin a new game after one."""
    again = Opened(PageItem("again", tr("This level again")), _leads_to(play.again))
    first = Opened(PageItem("first", tr("From the first level")), _leads_to(play.restarted))
    if play.endless is not None:
        return [Opened(PageItem("again", tr("The same levels again")), _leads_to(play.restarted))]
    if play.game.phase == Phase.WON:
        return [first]
    return [again, first] if play.game.number else [again]


def _leads_to(opens: Callable[[], PageScreen]) -> Callable[[str], PageScreen]:
    """Opens a screen, whatever the control's value is."""
    return lambda _value: opens()


def _name_item(state: PageState, screens: Screens, score: Score) -> Opened:
    """The field for the name of the player with a high score."""

    def entered(value: str) -> PageScreen:
        state.storage.enter(msgspec.structs.replace(score, name=value.strip()[:LONGEST_NAME]))
        state.changed = True
        state.notify_problems()
        return screens.title()

    held = state.storage.scores.value.last_name
    return Opened(PageItem("name", tr("A high score. Your name"), "text", held, high=LONGEST_NAME), entered)


def leaving(state: PageState, screens: Screens) -> tuple[Opened, ...]:
    """The entries that leave a game."""
    return (
        Opened(PageItem("levels", tr("All levels")), _ends(state, lambda: levels_menu(state, screens))),
        Opened(PageItem("title", tr("Main menu")), _ends(state, screens.title)),
    )


def _ends(state: PageState, opens: Callable[[], PageScreen]) -> Callable[[str], PageScreen]:
    """Stores the game, and opens a screen."""

    def ended(_value: str) -> PageScreen:
        state.end_game()
        return opens()

    return ended
