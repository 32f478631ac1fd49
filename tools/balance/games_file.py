"""Finished games in a JSON file, one a line, each with the hash of its level, so that a changed level is detected."""

from pathlib import Path
from typing import Any

import msgspec

from game.levels import Level
from game.system.errors import BadInputError
from game.system.files import read_input, write_text
from game.system.wording import quoted_message, quoted_path
from tools.balance.human import Skill
from tools.balance.trial import Trial, TrialJob

Known = dict[tuple[str, Skill | None, int], Trial]
"""Games by the hash of their level, their player and their seed."""

_MAX_FILE_SIZE = 16 * 1024 * 1024
_HASH_DIGITS = 16


class _SkillLine(msgspec.Struct, forbid_unknown_fields=True):
    """A `Skill` in a file."""

    reaction: float
    noise: float


class _Line(msgspec.Struct, forbid_unknown_fields=True):
    """A `Trial` in a file, and the first digits of its level's hash."""

    level: str
    skill: _SkillLine | None
    seed: int
    cleared: bool
    seconds: float
    lost: int
    given_up: int
    longest_gap: float
    score: int
    level_hash: str


def level_hash(level: Level) -> str:
    """The first digits of a level's hash: enough to distinguish versions of a level."""
    return level.content_hash()[:_HASH_DIGITS]


def known_game(known: Known, job: TrialJob) -> Trial | None:
    """The game of a job, if the file has it; else None. A level is known by its hash, whatever name the file gives it."""
    game = known.get((level_hash(job.level), job.skill, job.seed))
    return None if game is None else game._replace(level=job.level.name)


def saved_games(path: Path) -> Known:
    """The games of a file; BadInputError if the file does not contain games."""
    data = read_input(path, "file of games", _MAX_FILE_SIZE)
    try:
        lines = msgspec.json.decode(data, type=list[_Line])
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise BadInputError(f"{quoted_path(path)}: not a file of games; {quoted_message(str(error))}") from None
    known: Known = {}
    for line in lines:
        skill = None if line.skill is None else Skill(line.skill.reaction, line.skill.noise)
        fields: dict[str, Any] = {**msgspec.structs.asdict(line), "skill": skill}
        del fields["level_hash"]
        known[line.level_hash, skill, line.seed] = Trial(**fields)
    return known


def save_games(trials: list[Trial], levels: tuple[Level, ...], path: Path) -> None:
    """Write the games, those of the first level first."""
    numbers = {level.name: number for number, level in enumerate(levels)}
    lines = []
    for trial in sorted(trials, key=lambda trial: numbers[trial.level]):
        skill = None if trial.skill is None else _SkillLine(*trial.skill)
        line = _Line(**{**trial._asdict(), "skill": skill, "level_hash": level_hash(levels[numbers[trial.level]])})
        lines.append(msgspec.json.encode(line).decode())
    write_text(path, "[\n" + ",\n".join(lines) + "\n]\n")
