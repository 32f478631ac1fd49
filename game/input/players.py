"""How many play on this machine, and how. Needs no pygame: the command line asks, too."""

from enum import IntEnum

from game.language import tr


class Players(IntEnum):
    """One; two who steer the same paddles; two who play against each other."""

    ONE = 0
    TOGETHER = 1
    VERSUS = 2


def players_words(first: str, second: str) -> tuple[tuple[str, str], ...]:
    """Label and meaning of each choice, in their order. first, second: names of the players' keys."""
    return (
        (tr("One"), tr("Scores and ranks count for a single player only.")),
        (
            tr("Two together"),
            tr("One uses {first}, mouse or gamepad, the other {second} or a second gamepad; both steer all paddles.").format(
                first=first, second=second
            ),
        ),
        (
            tr("Two against each other"),
            tr("The lower player uses {first}, mouse or gamepad, the upper one {second} or a second gamepad.").format(
                first=first, second=second
            ),
        ),
    )
