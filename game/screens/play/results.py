"""The panels after a level and after a game: figures, and buttons to go on; after a high score the player enters a name."""

import time
from collections.abc import Callable
from typing import Protocol

import msgspec

from game.language import decimal, grouped, ntr, tr
from game.levels.names import level_name
from game.overlay.readings import player_name
from game.rules import Game, Phase, winner
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.high_scores import HighScores
from game.screens.menus.results import Figure, ResultsPanel
from game.screens.play.record import PlayRecord
from game.screens.play.versus import verdict
from game.screens.toolkit.menu import Entry
from game.screens.toolkit.text_entry import TextEntry
from game.storage.progress import RANKS, Best
from game.storage.scores import LONGEST_NAME, Score


class PlayedGame(Screen, Protocol):
    """What the results ask of the game that they lead back to. endless: the seed of endless levels; None for other levels."""

    endless: int | None

    def went_on(self) -> Screen:
        """The game's screen at the next level."""

    def again(self) -> Screen:
        """A new game at the level that was played last."""

    def restarted(self) -> Screen:
        """A new game at the level where this one began."""


def clock(ticks: int) -> str:
    """Ticks as minutes, seconds and tenths."""
    tenths = ticks * 10 // 240
    return f"{tenths // 600}:{decimal(tenths % 600 / 10.0, 1).zfill(4)}"


def level_results(state: AppState, play: PlayedGame, game: Game, record: PlayRecord) -> ResultsPanel:
    """The panel after a level: its figures, and a button for the next level."""
    result = game.results[-1]
    before = record.before
    following = level_name(game.levels[game.number + 1].name)
    entries = (
        Entry(tr("Next: {level}").format(level=following), play.went_on),
        *ways_out(state)[:1],
    )
    figures = (
        Figure(tr("Points"), result.score, best=_is_better(before, result.score)),
        Figure(tr("Time"), result.ticks, clock, best=before is not None and result.ticks < before.ticks),
        Figure(tr("Best combo"), result.best_combo),
        Figure(tr("Balls lost"), result.balls_lost),
        *(_scores(game) if game.sides else (Figure(tr("Score so far"), game.score),)),
    )
    rank = "" if game.sides else RANKS[int(result.rank)]
    line = level_name(game.level.name)
    if (ahead := winner(game)) is not None:
        line = tr("{level}. {player} is ahead.").format(level=line, player=player_name(ahead))
    if record.earned:
        line = tr("{level}. Unlocked in the settings: {things}").format(level=line, things=", ".join(record.earned))
    return ResultsPanel(state, play, tr("Level cleared"), line, figures, entries, rank, back=play.went_on)


def game_results(state: AppState, play: PlayedGame, game: Game, record: PlayRecord) -> Screen:
    """The panel after a game: its figures, the entry of a name for a high score, and buttons to go on."""
    kept_game = state.storage.game_done() if record.counts else None
    state.tell_problem()
    won = game.phase == Phase.WON
    tally = game.statistics.game
    figures = (
        *_scores(game),
        Figure(tr("Levels cleared"), len(game.results)),
        Figure(tr("Bricks"), tally.bricks),
        Figure(tr("Best combo"), tally.best_combo),
        Figure(tr("Balls lost"), tally.balls_lost),
        Figure(tr("Time"), game.tick, clock),
    )
    title = verdict(game) if game.sides else tr("You won") if won else tr("Game over")
    line = (
        tr("Every level is cleared.")
        if won
        else tr("The last ball was lost in {level}.").format(level=level_name(game.level.name))
    )
    if game.sides and not won:
        loser = player_name([side.lives for side in game.sides].index(0))
        line = tr("{player} lost the last ball in {level}.").format(player=loser, level=level_name(game.level.name))
    if play.endless is not None:
        line = tr("{line} These levels have the number {seed}.").format(line=line, seed=play.endless)
    entries = _after_game(state, play, game)
    menu = ResultsPanel(state, play, title, line, figures, entries, back=lambda: state.open_title(state))
    if not record.ranked or not state.storage.scores.value.qualifies(game.score, record.table):
        return menu
    last = game.level.name if play.endless is None else f"{game.level.name} ({play.endless})"
    first, date = game.levels[0].name, time.strftime("%Y-%m-%d")
    score = Score("", game.score, record.table, first, last, won, record.speed, date)
    if kept_game is not None:
        score = msgspec.structs.replace(score, replay=kept_game.file, sha256=kept_game.sha256)
    entered = Entry(tr("Enter your name"), _name_entry(state, play, score, entries))
    return ResultsPanel(state, play, title, line, figures, (entered, *entries), back=lambda: state.open_title(state))


def _scores(game: Game) -> tuple[Figure, ...]:
    """The score, or those of two who play against each other."""
    if not game.sides:
        return (Figure(tr("Score"), game.score),)
    return tuple([Figure(player_name(index), side.score, _with_lives(side.lives)) for index, side in enumerate(game.sides)])


def _with_lives(lives: int) -> Callable[[int], str]:
    """A function that writes a player's points, with the lives that are left."""
    left = ntr("{count} life", "{count} lives", lives).format(count=lives)
    return lambda points: f"{grouped(points)}  ({left})"


def _after_game(state: AppState, play: PlayedGame, game: Game) -> tuple[Entry, ...]:
    """The buttons after a game."""
    again = Entry(tr("This level again"), play.again)
    first = Entry(tr("From the first level"), play.restarted)
    begin = (first,) if game.phase == Phase.WON else (again, first) if game.number else (again,)
    if play.endless is not None:
        begin = (Entry(tr("The same levels again"), play.restarted),)
    return (*begin, *ways_out(state))


def ways_out(state: AppState) -> tuple[Entry, ...]:
    """The entries that leave a game: to the choice of levels, if there is one, and to the title."""
    levels = (Entry(tr("All levels"), state.levels),) if state.open_levels is not None else ()
    return (*levels, Entry(tr(state.home), lambda: state.open_title(state)))


def _name_entry(state: AppState, play: PlayedGame, score: Score, entries: tuple[Entry, ...]) -> Callable[[], Screen]:
    """A function that opens the entry of the name, then the table of scores with the new line."""

    def opened() -> Screen:
        title = tr("A high score: {score}").format(score=grouped(score.score))
        return TextEntry(state, play, title, state.storage.scores.value.last_name, LONGEST_NAME, done)

    def done(name: str) -> Screen:
        entered = msgspec.structs.replace(score, name=name)
        state.storage.enter(entered)
        state.tell_problem()
        return HighScores(state, play, entered, entries)

    return opened


def _is_better(before: Best | None, score: int) -> bool:
    """Whether a score is higher than the best before; False if there was none."""
    return before is not None and score > before.score
