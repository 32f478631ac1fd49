"""Trains a small agent to play a level, by the cross-entropy method: `python docs/examples/train_agent.py`.

The agent is a linear function of four numbers of the state, the ball's position and velocity. It says in which direction the
nearest paddle shall go. Every environment of a generation is played by another agent; the next generation is drawn around the
best. Needs the project installed with the extra [rl], and numpy, nothing else.
"""

import argparse

import gymnasium
import numpy as np

NUMBERS = 4
"""Of the state: position and velocity."""
SECONDS = 90
"""Of an episode at most."""
BEST = 8
"""One in so many agents is among the best of its generation."""


def points(env: gymnasium.vector.VectorEnv, weights: np.ndarray | None, seed: int) -> np.ndarray:
    """The points of agents, each in its environment, in an episode. weights: (agents, 2, NUMBERS); None for random actions."""
    state, _ = env.reset(seed=seed)
    env.action_space.seed(seed)
    total, playing = np.zeros(env.num_envs), np.ones(env.num_envs, bool)
    while playing.any():
        if weights is None:
            actions = env.action_space.sample()
        else:
            actions = np.einsum("anm,am->an", weights, state[:, :NUMBERS]).astype(np.float32)
        state, rewards, over, cut_off, _ = env.step(actions)
        total += rewards * playing
        playing &= ~(over | cut_off)
    return total


def main() -> None:
    """Train, print the curve, and compare with an agent that acts at random."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--level", default="First Wall")
    parser.add_argument("--generations", type=int, default=20)
    parser.add_argument("--agents", type=int, default=256)
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    env = gymnasium.make_vec(
        "tools.environments:PolarBreakout-v0",
        num_envs=chosen.agents,
        level=chosen.level,
        actions="continuous",
        frame_skip=8,
        max_ticks=240 * SECONDS,
    )
    at_random = points(env, None, chosen.seed).mean()
    print(f"at random: {at_random:.0f} points a game, of at most {SECONDS} s")
    chance = np.random.default_rng(chosen.seed)
    mean, spread = np.zeros((2, NUMBERS)), np.ones((2, NUMBERS))
    for generation in range(chosen.generations):
        weights = mean + spread * chance.normal(size=(chosen.agents, 2, NUMBERS))
        scored = points(env, weights, chosen.seed + generation)
        best = weights[np.argsort(scored)[-chosen.agents // BEST :]]
        mean, spread = best.mean(axis=0), best.std(axis=0) + 0.02
        bar = "#" * int(scored.mean() / 20)
        print(f"generation {generation + 1:2d}: mean {scored.mean():5.0f}, best {scored.max():5.0f}  {bar}")
    trained = points(env, np.broadcast_to(mean, (chosen.agents, 2, NUMBERS)), chosen.seed + 10_000).mean()
    print(
        f"trained, in {chosen.agents} games that it has not seen: {trained:.0f} points, {trained / at_random:.1f} times as many"
    )
    env.close()


if __name__ == "__main__":
    main()
