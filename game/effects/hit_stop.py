"""How long the window's game holds its breath after a tick: real time, in which no tick runs. No tick is changed."""

from game.rules import BEST_COMBO, EventKind, Ticked

_SECONDS = {EventKind.LEVEL_CLEARED: 0.12, EventKind.BALL_LOST: 0.1, EventKind.GAME_OVER: 0.16}
_TOP_COMBO_SECONDS = 0.05


def breath(ticked: Ticked) -> float:
    """Seconds to stand still after a tick; 0 after most."""
    longest = max([_SECONDS.get(event.kind, 0.0) for event in ticked.events], default=0.0)
    reached = ticked.game.combo == BEST_COMBO and any([event.kind == EventKind.BRICK_HIT for event in ticked.events])
    return max(longest, _TOP_COMBO_SECONDS if reached else 0.0)
