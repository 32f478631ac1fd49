"""The game as environments for reinforcement learning, by Gymnasium's interface: needs the extra [rl].

`gymnasium.make("tools.environments:PolarBreakout-v0", level="2")` makes one environment, `gymnasium.make_vec` many that are
played together. Both are played by compiled code that has the bits of `game.rules`.
"""

try:
    import gymnasium
except ImportError as error:
    wanted = "install the extra [rl]: python -m pip install 'polar-breakout[rl]'"
    raise ImportError(f"tools.environments needs gymnasium, which cannot be imported ({error}); {wanted}") from None

from tools.environments.single import PolarBreakoutEnv
from tools.environments.vector import PolarBreakoutVectorEnv

__all__ = ["ENVIRONMENT", "PolarBreakoutEnv", "PolarBreakoutVectorEnv"]

ENVIRONMENT = "PolarBreakout-v0"

if ENVIRONMENT not in gymnasium.registry:
    gymnasium.register(
        ENVIRONMENT,
        entry_point="tools.environments.single:PolarBreakoutEnv",
        vector_entry_point="tools.environments.vector:PolarBreakoutVectorEnv",
    )
