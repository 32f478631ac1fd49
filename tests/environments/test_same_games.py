"""An environment's game is the game of `game.rules`: every number after every tick, whatever the agent does."""

import numpy as np
import pytest

from game.levels import built_in
from game.replays.state_hash import state_hash
from game.rules import SOURCE_RULES, Controls, Phase, new_game, tick
from tools.autopilot.comparison import DECIDING
from tools.environments.many import EnvironmentOptions, ManyEnvironments, base_seed

pytestmark = pytest.mark.deep

COUNT, STEPS = 3, 400
EVERY = np.ones(COUNT, np.bool_)


def environments(level, actions):
    """So many environments of a level, at their first episode."""
    many = ManyEnvironments(COUNT, EnvironmentOptions(level, "state", actions, 1), resets=True)
    many.seed([base_seed(9, index) for index in range(COUNT)], EVERY)
    many.begin(EVERY)
    return many


def following(many, chance):
    """Actions that follow the ball, not well."""
    if many.options.actions == "discrete":
        return chance.integers(0, 3, COUNT)
    ahead = many.observations()[:, :2] + 0.3 * many.observations()[:, 2:4]
    return ahead + chance.normal(0.0, 0.2, (COUNT, 2))


def held_controls(episode):
    """What the game is asked in the one tick of a step."""
    pointer = int(episode["pointer"])
    return Controls(int(episode["turn"]), pointer if pointer >= 0 else None, bool(episode["served"] == episode["tick"]))


class Played:
    """Counts of what was gone through."""

    def __init__(self):
        self.scored = self.lost = self.nudged = self.won = self.over = 0


def play(many, steps, chance, played):
    """Play environments and, by the rules, their games, one tick a step; compare all that decides how they go on."""
    games = [many.game(index) for index in range(COUNT)]
    for game in games:
        fresh = new_game((many.level,), game.seed, SOURCE_RULES)
        assert game.tick > 0 or state_hash(fresh) == state_hash(game)
    for number in range(steps):
        begins = many.episodes["ended"] != 0
        actions = following(many, chance) if number % 5 == 0 else actions  # noqa: F821  # the first number is 0
        done = many.step(actions)
        for index, before in enumerate(games):
            mine = many.game(index)
            if begins[index]:
                games[index] = mine
                continue
            theirs = tick(before, held_controls(many.episodes[index])).game
            games[index] = theirs
            assert mine[DECIDING] == theirs[DECIDING]
            assert done.rewards[index] == theirs.score - before.score
            assert done.over[index] == (theirs.phase in {Phase.WON, Phase.OVER})
            played.scored += theirs.score > before.score
            played.lost += theirs.lives < before.lives
            played.nudged += theirs.draws > before.draws
            played.won += theirs.phase == Phase.WON
            played.over += theirs.phase == Phase.OVER
    assert [state_hash(many.game(index)) for index in range(COUNT)] == [state_hash(game) for game in games]


def thrown(many, distance, outward):
    """Put every ball in play on the x axis."""
    many._games.positions[:COUNT], many._games.velocities[:COUNT] = distance, outward
    many._games.known[:COUNT], many._games.free[:COUNT] = 0, 0
    many._episodes["phase"], many._episodes["ended"] = Phase.PLAYING, 0


@pytest.mark.parametrize("level", [str(number + 1) for number in range(0, len(built_in()), max(1, len(built_in()) // 7))])
def test_a_level_is_the_game_of_the_rules(level):
    """With both kinds of actions."""
    played = Played()
    for actions in ("discrete", "continuous"):
        play(environments(level, actions), STEPS, np.random.default_rng(int(level)), played)


def test_what_is_rare_is_the_same_too():
    """Nudges of a ball that loops, games that are won, games that are over: brought about by hand, then played by both."""
    played = Played()
    many = environments("First Wall", "continuous")
    play(many, 400, np.random.default_rng(1), played)
    many._episodes["idle"] = 11  # the next contact nudges
    play(many, 500, np.random.default_rng(2), played)
    thrown(many, 9.9, many.level.ball.speed)  # beyond the paddles, outward, with the last life
    many._episodes["lives"] = 1
    play(many, 100, np.random.default_rng(3), played)
    thrown(many, 7.0, -many.level.ball.speed)  # to the last brick
    many._games.layers[:COUNT, 1, 0] = 1
    many._games.layers[:COUNT, 1, 1:] = 0
    many._games.phases[:COUNT, 1] = 0
    many._episodes["left"] = 1
    play(many, 150, np.random.default_rng(4), played)
    assert min(played.scored, played.lost, played.nudged, played.won, played.over) >= 1, vars(played)
