"""The environments as Gymnasium takes them: its checker, ours for many at once, states, replays, and what is refused."""

import gymnasium
import numpy as np
import pytest
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode

from game.replays.file import load
from game.replays.verify import verified
from game.system.command_line import run
from tools.environments import ENVIRONMENT, PolarBreakoutEnv, PolarBreakoutVectorEnv
from tools.environments.checker import check_vector_env
from tools.measure.environments import app

pytestmark = pytest.mark.deep


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"level": "Sunflower", "observation": "rings", "actions": "continuous", "frame_skip": 1},
        {"observation": "pixels", "repeat_action_probability": 0.25},
    ],
)
def test_gymnasiums_checker_has_nothing_to_say(options, recwarn):
    """No error and no warning, through `gymnasium.make` with its wrappers, too."""
    env = gymnasium.make(ENVIRONMENT, **options)
    check_env(env.unwrapped)
    env.reset(seed=1)
    for _ in range(20):
        env.step(env.action_space.sample())
    env.close()
    assert [str(warning.message) for warning in recwarn] == []


SHORT = {"max_ticks": 500, "frame_skip": 4}


@pytest.mark.parametrize("options", [{}, {"level": "Sunflower", "actions": "continuous", "repeat_action_probability": 0.5}])
def test_many_environments_answer_as_single_ones_do(options):
    """In all autoreset modes: observations, rewards, ends and infos are those of Gymnasium's own vector environment."""
    options = SHORT | options
    check_vector_env(
        lambda count, mode: PolarBreakoutVectorEnv(count, autoreset_mode=mode, **options),
        lambda: PolarBreakoutEnv(**options),
        280,
    )


class ForgetsToReset(PolarBreakoutVectorEnv):
    """Plays on after an episode's end, with the last observation."""

    def step(self, actions):
        if self._mode is AutoresetMode.NEXT_STEP:
            self._environments._numbers = self._environments._numbers._replace(resets=0)
        return super().step(actions)


def test_the_checker_finds_an_environment_that_forgets_to_reset():
    """It names the mode and the step."""
    with pytest.raises(AssertionError, match=r"NEXT_STEP, step \d+: observations"):
        check_vector_env(
            lambda count, mode: ForgetsToReset(count, autoreset_mode=mode, **SHORT), lambda: PolarBreakoutEnv(**SHORT), 280
        )


def played(env, steps):
    """Some steps with the actions of a space that was seeded."""
    return [env.step(env.action_space.sample()) for _ in range(steps)]


def test_a_state_that_is_set_goes_on_as_it_did():
    """Also in another object; the actions held by chance are the same, too."""
    options = {"level": "Towers", "actions": "continuous", "repeat_action_probability": 0.5, "recorded": [1]}
    first, second = [PolarBreakoutVectorEnv(3, **options) for _ in range(2)]
    first.reset(seed=2)
    first.action_space.seed(2)
    played(first, 200)
    state = first.get_state()
    first.action_space.seed(3)
    then = played(first, 200)
    for env in (first, second):
        seen = env.set_state(state)
        assert (seen == state_observations(state)).all()
        env.action_space.seed(3)
        for before, now in zip(then, played(env, 200), strict=True):
            assert all((a == b).all() for a, b in zip(before[:4], now[:4], strict=True))


def test_what_has_changed_is_observed():
    """A step writes only the numbers that changed; its rows equal those of environments that write all of them."""
    env, anew = [PolarBreakoutVectorEnv(8, level="Three Rings", max_ticks=900) for _ in range(2)]
    env.reset(seed=6)
    env.action_space.seed(6)
    for seen, *_ in (env.step(env.action_space.sample()) for _ in range(400)):
        assert (anew.set_state(env.get_state()) == seen).all()


def state_observations(state):
    """What an environment sees that has been given a state."""
    env = PolarBreakoutVectorEnv(3, level="Towers", recorded=[1])
    return env.set_state(state)


@pytest.mark.parametrize("actions", ["discrete", "continuous"])
def test_a_recorded_game_is_played_and_verified_by_the_game(tmp_path, actions):
    """A game that is over, written after the next has begun; and that next one, unfinished."""
    env = PolarBreakoutVectorEnv(2, level="Three Rings", actions=actions, recorded=[1], frame_skip=3)
    env.reset(seed=4)
    env.action_space.seed(4)
    while not env.step(env.action_space.sample())[2][1]:
        ended = env.game(1)
    path = tmp_path / "game.polar"
    env.step(env.action_space.sample())
    env.record(1, path)
    over = verified(load(path))
    assert over.divergence is None
    assert over.game.lives == 0
    assert over.game.seed == ended.seed
    played(env, 50)
    env.record(1, path)
    now = verified(load(path))
    assert now.divergence is None
    assert now.game.arena == env.game(1).arena
    assert now.game.tick == 150


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ({"level": "99"}, "level: .*99"),
        ({"observation": "smell"}, "observation must be 'state', 'rings' or 'pixels', not 'smell'"),
        ({"actions": "both"}, "actions must be 'discrete', 'continuous' or 'autopilot', not 'both'"),
        ({"frame_skip": 0}, "frame_skip must be a whole number from 1 up, not 0"),
        ({"max_ticks": 1.5}, "max_ticks must be a whole number from 1 up, not 1.5"),
        ({"repeat_action_probability": 1.5}, r"repeat_action_probability must lie in \[0, 1\], not be 1.5"),
        ({"num_envs": 0}, "num_envs must be a whole number from 1 up, not 0"),
        ({"max_ticks": 2**63}, "max_ticks must be at most 2147483647, not 9223372036854775808"),
        ({"recorded": [2]}, "recorded must be numbers of environments, from 0 to 1, not 2"),
        ({"recorded": [0.5]}, "recorded must be numbers of environments, from 0 to 1, not 0.5"),
        ({"render_mode": "human"}, "render_mode must be one of"),
    ],
)
def test_a_wrong_argument_is_named(arguments, named):
    """ValueError says which, and what was expected."""
    with pytest.raises(ValueError, match=named):
        PolarBreakoutVectorEnv(**({"num_envs": 2} | arguments))


@pytest.mark.parametrize(
    ("options", "actions", "named"),
    [
        ({}, np.zeros(3, np.int64), r"actions must be whole numbers of shape \(2,\), not int64 of shape \(3,\)"),
        ({}, np.zeros(2), "actions must be whole numbers .* not float64"),
        ({}, np.array([0, 3]), "actions must be from 0 to 2, not 0 to 3"),
        ({"actions": "continuous"}, np.zeros((2, 2), np.int64), "actions must be floats of shape"),
        ({"actions": "continuous"}, np.full((2, 2), np.nan), "actions must be finite"),
    ],
)
def test_wrong_actions_change_nothing(options, actions, named):
    """ValueError; the games stay as they are."""
    env = PolarBreakoutVectorEnv(2, **options)
    env.reset(seed=1)
    before = [env.game(index) for index in range(2)]
    with pytest.raises(ValueError, match=named):
        env.step(actions)
    assert [env.game(index) for index in range(2)] == before


@pytest.mark.parametrize(
    ("seed", "named"),
    [
        ([1, 2, 3], r"seed must be one whole number, or 2 of them, not \[1, 2, 3\]"),
        (1.5, "seed must be one whole number"),
        (-1, "seed must be one whole number"),
        (np.array(5), r"seed must be one whole number, or 2 of them, not array\(5\)"),
        ([1, -2], "seed must be whole numbers from 0 up, or None, not -2"),
        ([None, 0.5], "seed must be whole numbers from 0 up, or None, not 0.5"),
    ],
)
def test_a_wrong_seed_is_named(seed, named):
    """The ValueError says what was expected."""
    with pytest.raises(ValueError, match=named):
        PolarBreakoutVectorEnv(2).reset(seed=seed)


def test_numpys_numbers_are_seeds():
    """A seed of numpy gives the same games as Python's, alone and in an array."""
    env = PolarBreakoutVectorEnv(2)
    assert (env.reset(seed=np.int64(3))[0] == env.reset(seed=3)[0]).all()
    env.reset(seed=np.array([4, 5]))
    seeds = [env.game(index).seed for index in range(2)]
    env.reset(seed=[4, 5])
    assert seeds == [env.game(index).seed for index in range(2)]


@pytest.mark.parametrize(
    ("options", "action", "named"),
    [
        ({}, 3, "actions must be from 0 to 2, not 3 to 3"),
        ({}, [1], r"action must be of shape \(\), not \[1\]"),
        ({"actions": "continuous"}, 1.0, r"action must be of shape \(2,\), not 1.0"),
    ],
)
def test_a_wrong_action_of_a_single_environment_is_named(options, action, named):
    """The ValueError names the shape of one action."""
    env = PolarBreakoutEnv(**options)
    env.reset(seed=1)
    with pytest.raises(ValueError, match=named):
        env.step(action)


def test_a_step_without_an_episode_asks_for_a_reset():
    """Before the first, and after an end that nothing resets."""
    single, many = PolarBreakoutEnv(max_ticks=4), PolarBreakoutVectorEnv(2, max_ticks=4, autoreset_mode=AutoresetMode.DISABLED)
    for env, action in ((single, 0), (many, np.zeros(2, np.int64))):
        with pytest.raises(ResetNeeded):
            env.step(action)
        env.reset()
        assert np.all(env.step(action)[3])
        with pytest.raises(ResetNeeded):
            env.step(action)


def test_only_recorded_environments_write_replays(tmp_path):
    """And only where something was played."""
    env = PolarBreakoutVectorEnv(2, recorded=[0])
    env.reset(seed=1)
    with pytest.raises(ValueError, match=r"index must be one of the recorded environments \[0\], not 1"):
        env.record(1, tmp_path / "game.polar")
    with pytest.raises(ValueError, match="nothing to record"):
        env.record(0, tmp_path / "game.polar")


def test_a_picture_shows_ball_paddles_and_bricks():
    """Each at its grey, where the game has it; the unrolled ground has the ball at its distance and angle."""
    env = PolarBreakoutVectorEnv(1, observation="rings", level="First Wall")
    seen = env.reset(seed=1)[0][0, :, :, 0]
    ball, ground = env.game(0).arena.balls[0], env._environments.level.ground_radius
    row, column = int(abs(ball.position) / ground * 48), int(np.angle(ball.position) % (2 * np.pi) / (2 * np.pi) * 96)
    assert seen[row, column] == 255
    assert {0, 200, 255} < set(seen.ravel().tolist())


def test_a_level_that_is_none_is_refused_by_the_measurement(capsys):
    """In one line, as every command does."""
    assert run(app, "measure", ["--level", "99"]) == 2
    assert "--level 99: no such level" in capsys.readouterr().err
