"""Hostile inputs, each given to what reads it: accepted and used, or refused in one line."""

from collections.abc import Callable, Iterator
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from random import Random
from typing import NamedTuple

from game.headless import autopilot_game, result_line
from game.lab.registry import scenes
from game.lab.session.session import opened
from game.lab.session.share import parsed
from game.levels import classic, load_file, warnings
from game.replays.file import Recorder, encoded, load
from game.replays.verify import verified
from game.rules import Controls, new_game, tick
from game.settings import file as settings_file
from game.settings.file import SettingsFile
from game.settings.values import Settings
from game.system.errors import BadInputError
from tools.robustness.mutations import mutated_replay, mutated_text

_LEVELS = files("game") / "levels"
_LONGEST_LINE = 700
"""Characters of a message: a path, a key and a rule."""
_TICKS = 60


def _name(file: Traversable) -> str:
    """What files are sorted by."""
    return file.name


class InputKind(NamedTuple):
    """One kind of input.

    name: for the report. made: a case, from a seeded generator. tried: what is wrong with how the program takes a case, None
    if nothing is; it may use a folder of its own.
    """

    name: str
    made: Callable[[Random], bytes]
    tried: Callable[[bytes, Path], str | None]


def kinds() -> tuple[InputKind, ...]:
    """Levels, replays, share lines and settings."""
    levels = [file.read_bytes() for part in ("campaign", "classic") for file in sorted((_LEVELS / part).iterdir(), key=_name)]
    replays = [_short_game(seed) for seed in range(4)]
    lines = [opened(parsed(scene.name)).line.encode() for scene in scenes()]
    settings = settings_file.encoded(Settings())
    return (
        InputKind("levels", lambda chance: mutated_text(chance.choice(levels), chance), _try_level),
        InputKind("replays", lambda chance: mutated_replay(chance.choice(replays), chance), _try_replay),
        InputKind("share lines", lambda chance: mutated_text(chance.choice(lines), chance), _try_line),
        InputKind(
            "settings", lambda chance: mutated_text(settings.replace(b":", b"="), chance).replace(b"=", b":"), _try_settings
        ),
    )


def faults(kind: InputKind, seed: int, count: int, folder: Path) -> Iterator[str | None]:
    """What is wrong with each of so many cases, or None; the case of a fault is left in the folder."""
    for number in range(count):
        data = kind.made(Random(f"{kind.name} {seed} {number}"))
        try:
            fault = kind.tried(data, folder)
        except Exception as error:  # noqa: BLE001  # whatever it is, it is a fault
            fault = f"{type(error).__name__}: {error}"
        if fault is not None:
            (folder / f"fault-{kind.name}-{seed}-{number}").write_bytes(data)
        yield None if fault is None else f"{kind.name} {seed}:{number}: {fault}"


def wrong_line(line: str) -> str | None:
    """What is wrong with a message; None for one line that can be read."""
    if not line.isprintable():
        return f"a message that is no printable line: {line!r}"
    return f"a message of {len(line)} characters" if len(line) > _LONGEST_LINE else None


def _try_level(data: bytes, folder: Path) -> str | None:
    """Play a level for a quarter of a second."""
    file = folder / "level.toml"
    file.write_bytes(data)
    try:
        level = load_file(file)
    except BadInputError as error:
        return wrong_line(str(error))
    lines = [result_line(autopilot_game((level,), 1, _TICKS)), *warnings(level)]
    return next((wrong for line in lines if (wrong := wrong_line(line))), None)


def _try_replay(data: bytes, folder: Path) -> str | None:
    """Verify a replay; it may well diverge."""
    file = folder / "game.polar"
    file.write_bytes(data)
    try:
        divergence = verified(load(file)).divergence
    except BadInputError as error:
        return wrong_line(str(error))
    return None if divergence is None else wrong_line(str(divergence))


def _try_line(data: bytes, _folder: Path) -> str | None:
    """Open the lab with a share line."""
    try:
        session = opened(parsed(data.decode("utf-8", "surrogateescape")))
    except BadInputError as error:
        return wrong_line(str(error))
    assert session.picture.panes
    return None


def _try_settings(data: bytes, folder: Path) -> str | None:
    """Load settings, and save them again."""
    file = folder / "settings" / "settings.json"
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(data)
    hold = SettingsFile(file)
    loaded = hold.load()
    hold.keep(loaded.other_colours())
    return None if hold.problem is None else wrong_line(hold.problem)


def _short_game(seed: int) -> bytes:
    """A replay of a second and a half."""
    levels = classic()[seed:]
    game, recorder = new_game(levels, seed), Recorder(levels, seed)
    for number in range(360):
        controls = Controls(turn=number // 60 % 3 - 1, serve=number == 30)
        game = tick(game, controls).game
        recorder.add(controls, game)
    return encoded(recorder.recording())
