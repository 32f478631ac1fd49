"""The table of levels on a page: a row for each level, with the lives that every player lost and the time it took."""

from game.levels import Level
from tools.balance.human import Skill
from tools.balance.trial import Trial, summary

_FIRST_ROW = "| 1 "


def has_table(page: str) -> bool:
    """Whether a page has a table of levels."""
    return any([line.startswith(_FIRST_ROW) for line in page.splitlines()])


def with_table(page: str, levels: tuple[Level, ...], skills: tuple[Skill | None, ...], trials: list[Trial]) -> str:
    """The page with the rows of its table of levels replaced; the rest stays. The page must have the table (`has_table`)."""
    lines = page.splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith(_FIRST_ROW))
    last = next((k for k in range(first, len(lines)) if not lines[k].startswith("|")), len(lines))
    return "\n".join([*lines[:first], *rows(levels, skills, trials), *lines[last:]]) + "\n"


def rows(levels: tuple[Level, ...], skills: tuple[Skill | None, ...], trials: list[Trial]) -> list[str]:
    """A row for every level, and a last one for all levels: each player's lost lives with their standard error, and seconds.

    The last column is the longest wait for a brick in any game of the player in the middle.
    """
    found = []
    whole = [[0.0, 0.0] for _ in skills]
    for number, level in enumerate(levels, 1):
        cells = []
        for skill, sums in zip(skills, whole, strict=True):
            part = summary(_games(trials, level, skill))
            cells.append(f"{part.lost:.1f} ± {part.error:.1f}, {part.seconds:.0f} s")
            sums[0] += part.lost
            sums[1] += part.seconds
        wait = max([trial.longest_gap for trial in _games(trials, level, skills[len(skills) // 2])])
        found.append(f"| {number} {level.name} | {' | '.join(cells)} | {wait:.1f} s |")
    found.append(f"| all | {' | '.join([f'{lost:.1f}, {seconds / 60.0:.0f} min' for lost, seconds in whole])} | |")
    return found


def _games(trials: list[Trial], level: Level, skill: Skill | None) -> list[Trial]:
    """The games of a player in a level. skill: None for the autopilot."""
    return [trial for trial in trials if trial.level == level.name and trial.skill == skill]
