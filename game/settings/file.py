"""The settings, kept in the user's configuration folder from one session to the next.

A JSON object with the fields of `Settings` and a version; `off` is a list of effects, `own_keys` has lists of numbers by
action. What is missing has its default, what is out of range is brought into it, and whatever cannot be read is moved aside: no
file keeps the game from starting.
"""

import time
from collections.abc import Container
from pathlib import Path
from typing import Any

import msgspec

from game.drawing.colour_vision import VISIONS
from game.effects import EffectKind
from game.language import CODES, SYSTEM
from game.settings.own_keys import decoded_keys, encoded_keys
from game.settings.values import LOUDEST, SPEEDS, TEXT_SIZES, THEMES, Settings
from game.system.files import remove_temporaries, write_atomically
from game.system.wording import quoted_path
from game.unlocks import BALLS, TRAILS

VERSION = 2
"""1 had no fields after `off`."""
_LARGEST = 64 * 1024


class SettingsFile:
    """One session's hold on the file. Nothing here raises; `problem` says in one line what went wrong last."""

    def __init__(self, path: Path) -> None:
        """path: of the file; it is not looked at yet."""
        self._path = path
        self._kept: Settings | None = None
        self._newer = False
        self.problem: str | None = None

    def load(self) -> Settings:
        """The settings that were kept; the defaults where there are none."""
        remove_temporaries(self._path.parent)
        self._kept = self._read()
        return self._kept

    def keep(self, settings: Settings) -> None:
        """Write the settings if they have changed, and no newer game has written the file."""
        if settings == self._kept or self._newer:
            return
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(self._path, encoded(settings))
            self._kept = settings
        except OSError as error:
            self.problem = f"settings not saved: {quoted_path(self._path)}: {error.strerror or error}"

    def _read(self) -> Settings:
        """What the file says."""
        try:
            if not self._path.exists():
                return Settings()
            if not self._path.is_file():
                self.problem = f"settings not read: {quoted_path(self._path)}: not a file; the defaults are used"
                return Settings()
            with self._path.open("rb") as file:
                data = file.read(_LARGEST + 1)
        except OSError as error:
            self.problem = f"settings not read: {quoted_path(self._path)}: {error.strerror or error}; the defaults are used"
            return Settings()
        try:
            stored = msgspec.json.decode(data, type=dict[str, Any]) if len(data) <= _LARGEST else None
        except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
            stored = None
        if stored is None:
            self._put_aside()
            return Settings()
        self._newer = not _is_known(stored.get("version", VERSION))
        if self._newer:
            self.problem = f"settings of a newer version in {quoted_path(self._path)}: changes will not be saved"
        return decoded(stored)

    def _put_aside(self) -> None:
        """Rename a file that cannot be read, so that it is not lost when the settings are saved."""
        aside = self._path.with_name(f"{self._path.name}.bad-{time.strftime('%Y%m%d-%H%M%S')}")
        try:
            self._path.replace(aside)
            self.problem = f"settings not readable: moved to {quoted_path(aside)}; the defaults are used"
        except OSError as error:
            self.problem = f"settings not readable: {quoted_path(self._path)}: {error.strerror or error}; the defaults are used"


def encoded(settings: Settings) -> bytes:
    """The file's bytes."""
    own_keys = encoded_keys(settings.own_keys)
    stored = {"version": VERSION, **settings._asdict(), "off": sorted(settings.off), "own_keys": own_keys}
    return msgspec.json.format(msgspec.json.encode(stored)) + b"\n"


def decoded(stored: dict[str, Any]) -> Settings:
    """The settings in a file, key by key: the default for what makes no sense, the nearest for what is out of range."""
    default = Settings()
    off = stored.get("off")
    return Settings(
        colours=_one_of(stored, "colours", THEMES, default.colours),
        sound=_flag(stored, "sound", default.sound),
        volume=_whole(stored, "volume", (0, LOUDEST), default.volume),
        reduced_motion=_flag(stored, "reduced_motion", default.reduced_motion),
        effects=_flag(stored, "effects", default.effects),
        off=frozenset([kind for kind in EffectKind if kind in off]) if isinstance(off, list) else default.off,
        speed=_whole(stored, "speed", SPEEDS, default.speed),
        text_size=_whole(stored, "text_size", TEXT_SIZES, default.text_size),
        one_button=_flag(stored, "one_button", default.one_button),
        captions=_flag(stored, "captions", default.captions),
        ghost=_flag(stored, "ghost", default.ghost),
        vision=_one_of(stored, "vision", VISIONS, default.vision),
        music=_whole(stored, "music", (0, LOUDEST), default.music),
        ball=_one_of(stored, "ball", BALLS, default.ball),
        trail=_one_of(stored, "trail", TRAILS, default.trail),
        language=_one_of(stored, "language", (SYSTEM, *CODES), default.language),
        own_keys=decoded_keys(stored.get("own_keys")),
    )


def _one_of(stored: dict[str, Any], key: str, known: Container[str], default: str) -> str:
    """One of some words."""
    wanted = stored.get(key)
    return wanted if isinstance(wanted, str) and wanted in known else default


def _whole(stored: dict[str, Any], key: str, limits: tuple[int, int], default: int) -> int:
    """A number, rounded and brought between its limits."""
    wanted = stored.get(key)
    if not isinstance(wanted, int | float) or isinstance(wanted, bool):
        return default
    return round(min(max(wanted, limits[0]), limits[1]))


def _flag(stored: dict[str, Any], key: str, default: bool) -> bool:  # noqa: FBT001  # the value of a key, not a switch
    """Yes or no."""
    wanted = stored.get(key)
    return wanted if isinstance(wanted, bool) else default


def _is_known(version: object) -> bool:
    """Whether this game understands all of a file of a version; of no version at all it makes what it can."""
    return not isinstance(version, int) or version <= VERSION
