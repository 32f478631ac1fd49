"""The golden games: who plays what, and how they are recorded. `pytest --regen` writes them anew."""

from collections.abc import Iterator
from typing import NamedTuple, Protocol

from game.autopilot import Autopilot
from game.levels import classic
from game.replays.file import Recorder, Recording
from game.rules import Controls, Game, Phase, new_game, tick
from tests.support.games.players import KeyPlayer, MousePlayer
from tests.support.paths import GOLDEN

FOLDER = GOLDEN
LEAST_TICKS = 60 * 240
PLAYERS = ("autopilot", "mouse", "keys")
_FIRST_SEED = 100
_SEEDS_PER_PLAYER = 30


class Player(Protocol):
    """Anything that answers a game with controls."""

    def controls(self, game: Game) -> Controls: ...


class Golden(NamedTuple):
    """One golden game, before it is recorded."""

    name: str
    level: int  # from 1
    player: str


def golden_games() -> Iterator[Golden]:
    """Every level, by every kind of player."""
    for number in range(1, len(classic()) + 1):
        for player in PLAYERS:
            yield Golden(f"{number}-{player}", number, player)


def recorded(golden: Golden) -> Recording:
    """The first game, counting the seed up, that is still going on after a minute."""
    levels = classic()[golden.level - 1 :]
    seed = _FIRST_SEED * golden.level + _SEEDS_PER_PLAYER * PLAYERS.index(golden.player)
    while True:
        seed += 1
        player: Player = {"autopilot": Autopilot(), "mouse": MousePlayer(seed), "keys": KeyPlayer(seed)}[golden.player]
        game, recorder = new_game(levels, seed), Recorder(levels, seed)
        while game.tick < LEAST_TICKS and game.phase not in {Phase.OVER, Phase.WON}:
            controls = player.controls(game)
            game = tick(game, controls).game
            recorder.add(controls, game)
        if recorder.ticks >= LEAST_TICKS:
            return recorder.recording()
