"""Parses the options for players, `150/2,220/5,autopilot`, and for their numbers of games, `8,24,8`."""

from game.system.errors import BadInputError
from game.system.wording import quoted
from tools.balance.human import Skill

AUTOPILOT = "autopilot"
_FASTEST, _SLOWEST, _WILDEST = 0, 2000, 90.0
"""Limits of a human: reaction in ms, error in degrees."""
_MOST_SEEDS = 10**4


def parsed_skills(text: str) -> tuple[Skill | None, ...]:
    """The players of an option, None for the autopilot; BadInputError for anything but MS/DEG in range."""
    return tuple([_skill(word) for word in text.split(",")])


def parsed_seeds(text: str, players: int) -> tuple[int, ...]:
    """The number of games of each player, from one number for all or one for each; BadInputError for anything else."""
    words = text.split(",")
    numbers = tuple([int(word) for word in words if word.isascii() and word.isdigit() and len(word) <= len(str(_MOST_SEEDS))])
    if len(numbers) != len(words) or len(numbers) not in {1, players} or not all([1 <= n <= _MOST_SEEDS for n in numbers]):
        raise BadInputError(
            f"--seeds {quoted(text)}: expected a number from 1 to {_MOST_SEEDS}, or one for each of {players} players"
        )
    return numbers * players if len(numbers) == 1 else numbers


def player_name(skill: Skill | None) -> str:
    """The name of a player in tables."""
    return AUTOPILOT if skill is None else f"{skill.reaction * 1000.0:g} ms, {skill.noise:g} deg"


def _skill(word: str) -> Skill | None:
    """The player of one word of the option."""
    if word == AUTOPILOT:
        return None
    milliseconds, _, degrees = word.partition("/")
    try:
        reaction, noise = float(milliseconds), float(degrees)
    except ValueError:
        reaction = noise = -1.0
    if not (_FASTEST <= reaction <= _SLOWEST and 0.0 <= noise <= _WILDEST):
        expected = f"expected MS/DEG, as in 220/5, up to {_SLOWEST} ms and {_WILDEST:g} degrees; or {AUTOPILOT}"
        raise BadInputError(f"--players {quoted(word)}: {expected}")
    return Skill(reaction / 1000.0, noise)
