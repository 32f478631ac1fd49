"""How long the window's game stands still after a great moment: real time, in which no tick runs. No tick is changed."""

from game.rules import BEST_COMBO, EventKind, Ticked

SECONDS = {EventKind.LEVEL_CLEARED: 0.12, EventKind.BALL_LOST: 0.1, EventKind.GAME_OVER: 0.16}
_BEST_COMBO_SECONDS = 0.05


def hit_stop_seconds(ticked: Ticked) -> float:
    """Seconds to stand still after a tick; 0 after most."""
    longest = max([SECONDS.get(event.kind, 0.0) for event in ticked.events], default=0.0)
    reached = ticked.game.combo == BEST_COMBO and any([event.kind == EventKind.BRICK_HIT for event in ticked.events])
    return max(longest, _BEST_COMBO_SECONDS if reached else 0.0)
