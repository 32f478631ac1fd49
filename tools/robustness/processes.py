"""Every command in surroundings that a stranger may have, and every signal at a random moment. For Linux."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import IO, NamedTuple

from game.levels import classic
from game.replays.file import Recorder, load, save
from game.replays.verify import verified
from game.rules import Controls, new_game, tick
from game.system.ending import WORDS

_ROOT = Path(__file__).parents[2]
_FULL = "/dev/full"
_GAME, _MEASURE = "game", "tools.measure"
_CAUGHT = "SigCgt:"
_FIGURES = re.compile(r" *\d+ min: ")
_BAD, _MISSING = 2, 3
"""Exit codes: bad input, and something that the machine lacks."""
SIGNALS = tuple([signal.Signals[name] for name in WORDS if name in signal.Signals.__members__])
"""Those that end a command; Windows has no SIGHUP."""
_FROM_A_TERMINAL = 0.5
"""How often a signal goes to all processes of a command, as a terminal sends it, and not to the first alone."""
_LATEST = 3.0
"""Seconds after which a signal comes, at most, unless told otherwise."""
_GIVE_UP = 300.0
"""Seconds that a command may take to end."""


class CommandRun(NamedTuple):
    """One command.

    arguments: after `python -m`; {folder} stands for a folder of its own. codes: exit codes it may have by itself.
    ends: whether it does so within seconds; the others are for signals. Files it writes: game.polar.
    """

    arguments: tuple[str, ...]
    codes: frozenset[int] = frozenset({0})
    ends: bool = True

    @property
    def may_say_more(self) -> bool:
        """Whether it may have something to say on stderr even when all is well: no display, or a machine too slow."""
        return 1 in self.codes or self.arguments == _WITHOUT_DISPLAY

    @property
    def starts_processes(self) -> bool:
        """Whether it shares its work with processes of its own."""
        return self.arguments[0] == "tools.crosscheck" or "--workers" in self.arguments

    @property
    def name(self) -> str:
        """What is typed."""
        return " ".join(self.arguments)


_WITHOUT_DISPLAY = (_GAME, "--seed", "4")
_HEADLESS = (_GAME, "--headless", "--autopilot", "--seed", "5")
_TIMED = frozenset({0, 1})
"""Commands that measure answer 1 where the machine is too slow."""
COMMANDS = (
    CommandRun((_GAME, "--help")),
    CommandRun(_WITHOUT_DISPLAY),
    CommandRun((_GAME, "--version")),
    CommandRun((_GAME, "levels")),
    CommandRun((_GAME, "replays")),
    CommandRun((*_HEADLESS, "--ticks", "300")),
    CommandRun((*_HEADLESS, "--ticks", "300", "--record", "{folder}/game.polar")),
    CommandRun((*_HEADLESS, "--ticks", "300", "--screenshot", "{folder}/picture.png", "--size", "64x48")),
    CommandRun((_GAME, "replay", "--verify", "{folder}/w\u00fc\u2603.polar")),
    CommandRun((_GAME, "lab", "--list")),
    CommandRun((_GAME, "lab", "case-2", "--headless", "--drags", "20")),
    CommandRun((_GAME, "lab", "case-2", "--screenshot", "{folder}/picture.png", "--size", "64x48")),
    CommandRun((_GAME, "replay", "--verify", "{folder}/none\u2603.polar"), frozenset({_BAD})),
    CommandRun((_GAME, "--bogus"), frozenset({_BAD})),
    CommandRun(("tools.fuzz", "--steps", "300")),
    CommandRun(("tools.fuzz", "--impacts", "20")),
    CommandRun(("tools.fuzz", "--case", "1:1")),
    CommandRun(("tools.crosscheck", "--games", "1", "--ticks", "600", "--level", "1")),
    CommandRun(("tools.crosscheck", "--games", "1", "--ticks", "600", "--json", "{folder}/numbers.json")),
    CommandRun(("tools.bench", "--rounds", "1", "--ticks", "100")),
    CommandRun((f"{_MEASURE}.frame", "--count", "20", "--level", "1")),
    CommandRun((f"{_MEASURE}.lab", "--rounds", "1")),
    CommandRun((f"{_MEASURE}.startup", "--count", "1"), _TIMED),
    CommandRun((f"{_MEASURE}.memory", "--minutes", "1.1", "--width", "16", "--height", "16"), _TIMED),
    CommandRun((f"{_MEASURE}.tipping_gif", "{folder}", "--width", "32", "--height", "24")),
    CommandRun((*_HEADLESS, "--ticks", "800000", "--record", "{folder}/game.polar"), ends=False),
    CommandRun((_GAME, "--autopilot", "--seed", "5", "--record", "{folder}/game.polar"), ends=False),
    CommandRun((_GAME, "replay", "{folder}/w\u00fc\u2603.polar"), ends=False),
    CommandRun((_GAME, "lab"), ends=False),
    CommandRun((_GAME, "lab", "--headless", "--drags", "100000"), ends=False),
    CommandRun(("tools.fuzz", "--steps", "100000000"), ends=False),
    CommandRun(("tools.fuzz", "--steps", "100000000", "--workers", "2"), ends=False),
    CommandRun(("tools.fuzz", "--impacts", "100000000"), ends=False),
    CommandRun(("tools.crosscheck", "--games", "1000"), ends=False),
    CommandRun(("tools.crosscheck", "--games", "1000", "--workers", "2"), ends=False),
    CommandRun(("tools.bench", "--rounds", "1000"), ends=False),
    CommandRun((f"{_MEASURE}.frame", "--count", "100000"), ends=False),
    CommandRun((f"{_MEASURE}.lab", "--rounds", "100000"), ends=False),
    CommandRun((f"{_MEASURE}.startup", "--count", "1000"), _TIMED, ends=False),
    CommandRun((f"{_MEASURE}.memory", "--minutes", "1000"), _TIMED, ends=False),
    CommandRun((f"{_MEASURE}.tipping_gif", "{folder}", "--width", "4096", "--height", "4096"), ends=False),
)
"""All commands: short runs of each for the surroundings, long ones for signals."""

SURROUNDINGS = (
    "plain",
    "closed stdin",
    "closed stdout",
    "closed stderr",
    "all closed",
    "full stdout",
    "full stderr",
    "no reader",
    "home that cannot be written",
    "no home",
    "ascii locale",
    "ascii output",
    "deleted folder",
)
"""What a command is started in."""


def fault(command: CommandRun, surroundings: str) -> str | None:
    """What is wrong with how a command behaves there; None for its exit code, at most one line on stderr, no traceback."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _save_game(folder / "w\u00fc\u2603.polar")
        environment = _environment(folder, surroundings)
        if command.arguments == _WITHOUT_DISPLAY:
            del environment["SDL_VIDEODRIVER"]
        shell = _shell(command, folder, surroundings)
        done = subprocess.run(  # noqa: S603  # the commands above
            ["/bin/sh", "-c", shell],
            cwd=folder,
            env=environment,
            capture_output=True,
            check=False,
            timeout=_GIVE_UP,
        )
    err = done.stderr.decode(errors="replace")
    codes = _codes(command, surroundings)
    found = _wrong(
        err, done.stdout.decode(errors="replace"), 2 if surroundings == "full stdout" and command.may_say_more else 1
    )
    if found is None and done.returncode not in codes:
        found = f"exit code {done.returncode}: {err.strip()}"
    return None if found is None else f"{command.name} with {surroundings}: {found}"


class SignalAnswer(NamedTuple):
    """How a command answered a signal: the exit code, and what is wrong with it or None."""

    code: int
    fault: str | None


def ended(command: CommandRun, number: signal.Signals, chance: Random, latest: float = _LATEST) -> SignalAnswer:
    """Send a signal to a command at a random moment after the first line of the project's own code has run.

    latest: seconds from then on after which it comes, at most.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _save_game(folder / "w\u00fc\u2603.polar")
        child = subprocess.Popen(  # noqa: S603  # the commands above
            [sys.executable, "-m", *_filled(command, folder)],
            cwd=folder,
            env=_environment(folder, "plain"),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=_default_signals,  # noqa: PLW1509  # there are no threads
            start_new_session=True,
        )
        try:
            while child.poll() is None and not _catches(child.pid, number):
                time.sleep(0.001)
            time.sleep(chance.random() ** 2 * latest)
            if chance.random() < _FROM_A_TERMINAL:
                os.killpg(child.pid, number)
            else:
                os.kill(child.pid, number)
            out, err = child.communicate(timeout=_GIVE_UP)
        finally:
            _kill_group(child)
        found = _wrong(err.decode(errors="replace"), out.decode(errors="replace"))
        code = _as_in_a_shell(child.returncode)
        if found is None and code not in {128 + number, *(command.codes if command.ends else ())}:
            found = f"exit code {code}: {err.decode(errors='replace').strip()}"
        if found is None and (folder / "game.polar").exists():
            found = None if verified(load(folder / "game.polar")).divergence is None else "the kept game diverges"
        leftovers = [path.name for path in folder.rglob(".polar-breakout-*")]
        if found is None and leftovers:
            found = f"left behind: {leftovers}"
    return SignalAnswer(code, None if found is None else f"{command.name} with {number.name}: {found}")


def _as_in_a_shell(code: int) -> int:
    """The exit code of a process as a shell shows it: 128 + the number of the signal that killed it.

    Python's own end, after a command's work and its last line, takes the handlers away some milliseconds before the process is
    gone; a signal that comes then acts as if it had never been handled.
    """
    return code if code >= 0 else 128 - code


def ended_by_all(count: int, seed: int) -> Iterator[SignalAnswer]:
    """So many signals, over all commands and kinds of signal in turn."""
    chance = Random(seed)
    pairs = [(command, number) for number in SIGNALS for command in COMMANDS]
    for index in range(count):
        command, number = pairs[index % len(pairs)]
        yield ended(command, number, chance)


def _codes(command: CommandRun, surroundings: str) -> frozenset[int]:
    """The exit codes that a command may have there."""
    if surroundings == "full stdout" and _prints(command):
        return (command.codes - {0}) | {_MISSING}
    if surroundings == "deleted folder" and command.starts_processes:
        return frozenset({_MISSING})
    return command.codes


def _wrong(err: str, out: str, lines: int = 1) -> str | None:
    """What is wrong with what a command said. lines: that it may have said on stderr, a minute's figures left out."""
    err = "".join([line for line in err.splitlines(keepends=True) if not _FIGURES.match(line)])
    for text in (err, out):
        if "Traceback" in text or "Exception ignored" in text:
            return f"a traceback: {text[-400:]!r}"
    return f"{err.count(chr(10))} lines: {err[:400]!r}" if err.count("\n") > lines else None


def _filled(command: CommandRun, folder: Path) -> list[str]:
    """The arguments with the folder in them."""
    return [argument.replace("{folder}", str(folder)) for argument in command.arguments]


def _shell(command: CommandRun, folder: Path, surroundings: str) -> str:
    """A line for a shell that starts a command there."""
    quoted = " ".join([f"'{argument}'" for argument in (sys.executable, "-m", *_filled(command, folder))])
    redirected = {
        "closed stdin": "<&-",
        "closed stdout": ">&-",
        "closed stderr": "2>&-",
        "all closed": "<&- >&- 2>&-",
        "full stdout": f">{_FULL}",
        "full stderr": f"2>{_FULL}",
    }.get(surroundings, "")
    if surroundings == "no reader":
        code = f"'{folder}/code'"
        wait = f"while [ ! -s {code} ]; do sleep 0.1; done"
        return f"{{ {quoted}; echo $? >{code}; }} | true; {wait}; exit $(cat {code})"
    if surroundings == "deleted folder":
        return f"mkdir '{folder}/gone'; cd '{folder}/gone'; rmdir '{folder}/gone'; exec {quoted}"
    return f"exec {quoted} {redirected}"


def _environment(folder: Path, surroundings: str) -> dict[str, str]:
    """The variables of a command's process."""
    kept = {name: value for name, value in os.environ.items() if name in {"PATH", "VIRTUAL_ENV", "LD_LIBRARY_PATH"}}
    found = {
        **kept,
        "PYTHONPATH": str(_ROOT),
        "SDL_VIDEODRIVER": "dummy",
        "SDL_AUDIODRIVER": "dummy",
        "HOME": str(folder),
        "LC_ALL": "C.UTF-8",
    }
    if surroundings == "home that cannot be written":
        found["HOME"] = "/proc"
    elif surroundings == "no home":
        del found["HOME"]
    elif surroundings == "ascii locale":
        found |= {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
    elif surroundings == "ascii output":
        found["PYTHONIOENCODING"] = "ascii"
    return found


def _prints(command: CommandRun) -> bool:
    """Whether a command writes anything to stdout when all is well."""
    silent = command.arguments[0].endswith("tipping_gif") or command.arguments[1:] == ("replays",) or _BAD in command.codes
    return not silent and ("--screenshot" not in command.arguments or "--headless" in command.arguments)


def _save_game(path: Path) -> None:
    """A replay of half a second."""
    levels = classic()
    game, recorder = new_game(levels, 1), Recorder(levels, 1)
    for number in range(120):
        controls = Controls(serve=number == 10)
        game = tick(game, controls).game
        recorder.add(controls, game)
    save(recorder.recording(), path)


def _default_signals() -> None:
    """Signals as a program has them at a terminal: a shell's background jobs ignore some."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_DFL)


def _catches(process: int, number: int) -> bool:
    """Whether a process has a handler for SIGTERM and for the signal: Python itself has one for SIGINT alone."""
    lines = _lines(Path(f"/proc/{process}/status"))
    caught = next((int(line.split()[1], 16) for line in lines if line.startswith(_CAUGHT)), 0)
    return all([caught >> (each - 1) & 1 for each in (*SIGNALS, number)])


def _lines(path: Path) -> list[str]:
    """The lines of a file of the system; none once the process is gone."""
    try:
        return path.read_text(encoding="ascii").splitlines()
    except OSError:
        return []


def _kill_group(child: "subprocess.Popen[bytes]") -> None:
    """End what a child may have left running."""
    try:
        os.killpg(child.pid, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        return
    finally:
        child.wait()
        streams: tuple[IO[bytes] | None, ...] = (child.stdout, child.stderr)
        for stream in streams:
            if stream is not None:
                stream.close()
