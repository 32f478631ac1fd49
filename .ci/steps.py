"""What must hold on a clean checkout. `.ci/run` does everything, `.ci/run STEP ...` some steps.

test      the README's own test line, in a fresh environment
deep      the tests that take minutes: compiled loops, compilers, every known mistake
window    whole sessions in a real window: where Xvfb and xdotool are, else one line that says what is missing
lint      lint, format, types, who imports whom
docs      the documentation site, its warnings as errors
package   sdist and wheel: both are checked, every command of the wheel runs, the sdist is complete and passes some tests
frozen    an application that needs no Python: it plays a level and holds the lab's claims
web       the page in a real browser: where Chromium and npm are, else one line that says what is missing
"""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import venv
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
WINDOWS = sys.platform == "win32"
PROGRAMS = "Scripts" if WINDOWS else "bin"
ENVIRONMENT = ROOT / ".venv"
RUNS = os.environ | {"CI": "true", "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"}
GAME = ("--headless", "--autopilot", "--seed", "7", "--level", "4", "--ticks", "3000")


class Where(NamedTuple):
    """Which programs are run, and in which folder."""

    programs: Path
    folder: Path


HERE = Where(ENVIRONMENT / PROGRAMS, ROOT)


def main(steps: list[str]) -> None:
    """Do these steps, or all; the first failure ends it."""
    known = {
        "test": test,
        "deep": deep,
        "window": window,
        "lint": lint,
        "docs": docs,
        "package": package,
        "frozen": frozen,
        "web": web,
    }
    for step in steps:
        if step not in known:
            sys.exit(f".ci/run: no step {step!r}; expected some of {', '.join(known)}")
    try:
        for step in steps or known:
            known[step]()
    except subprocess.CalledProcessError as error:
        sys.exit(f".ci/run: exit code {error.returncode}: {error.cmd}")


def test() -> None:
    """The test line is the README's, word for word; the Python in it is the one that runs this."""
    shutil.rmtree(ENVIRONMENT, ignore_errors=True)
    line = test_line()
    print(f"+ {line}", flush=True)
    path = os.pathsep.join([str(Path(sys.executable).parent), RUNS["PATH"]])
    chosen = {"PATH": path, "PY_PYTHON3": f"{sys.version_info.major}.{sys.version_info.minor}"}  # for python3, for py -3
    subprocess.run(line, shell=True, cwd=ROOT, env=RUNS | chosen, check=True)


def deep() -> None:
    """What the README's test line leaves out."""
    install("test")
    run(HERE, "python", "-m", "pytest", "-n", "auto", "-m", "deep")


def window() -> None:
    """Sessions by keys, by mouse and by gamepad, in windows of a display server of their own."""
    if lacks("window", "Xvfb", "xdotool"):
        return
    install("test")
    run(HERE, "python", "-m", "pytest", "-m", "window")


def test_line() -> str:
    """The first line with pytest of the README's blocks for this system's shell."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    blocks = re.findall(rf"^```{'bat' if WINDOWS else 'sh'}\n(.*?)^```$", readme, re.MULTILINE | re.DOTALL)
    return next(line for block in blocks for line in block.splitlines() if "pytest" in line)


def lint() -> None:
    """Everything that is said about the source without running it."""
    install("test")
    run(HERE, "ruff", "check", ".")
    run(HERE, "ruff", "format", "--check", ".")
    run(HERE, "mypy")
    run(HERE, "lint-imports", "--no-cache")


def docs() -> None:
    """The site builds, and no link in it is broken."""
    if (ROOT / "mkdocs.yml").is_file():
        install("docs")
        run(HERE, "mkdocs", "build", "--strict", "--quiet", NO_MKDOCS_2_WARNING="1")


def package() -> None:
    """What would be uploaded, tried as those who download it will."""
    install("test", "package")
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder)
        run(HERE, "python", "-m", "build", "--outdir", made)
        (sdist,), (wheel,) = made.glob("*.tar.gz"), made.glob("*.whl")
        run(HERE, "twine", "check", "--strict", sdist, wheel)
        run(HERE, "check-wheel-contents", wheel)
        try_wheel(wheel, made / "empty")
        with tarfile.open(sdist) as archive:
            archive.extractall(made, filter="data")
        unpacked = made / sdist.name.removesuffix(".tar.gz")
        complete(unpacked)
        some = (
            "tests/physics",
            "tests/game/replays",
            "tests/test_documentation.py",
            "tests/test_imports.py",
        )  # all of them take minutes
        run(HERE._replace(folder=unpacked), "python", "-m", "pytest", "-n", "auto", "-q", *some)


def complete(unpacked: Path) -> None:
    """Whatever the checkout has for its tests and its documentation, the sdist has too."""
    listing = ["git", "ls-files", "tests", "docs", "tools", "physics", "game"]
    kept = subprocess.run(listing, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    missing = [name for name in kept if not (unpacked / name).is_file()]
    if missing:
        sys.exit(f".ci/run: the sdist lacks {len(missing)} files, the first {missing[0]}")


def try_wheel(wheel: Path, folder: Path) -> None:
    """Every command of the wheel says its help and does something, in an environment and a folder with nothing else."""
    venv.create(folder, with_pip=True)
    there = Where(folder / PROGRAMS, folder)
    run(there, "python", "-m", "pip", "install", "--quiet", wheel)
    for command in ((), ("levels",), ("replays",), ("replay",), ("lab",)):
        run(there, "polar-breakout", *command, "--help", silent=True)
    run(there, "polar-crosscheck", "--help", silent=True)
    for module in tools():
        run(there, "python", "-m", module, "--help", silent=True)
    run(there, "polar-breakout", *GAME, "--record", "game.polar", "--screenshot", "game.png")
    run(there, "polar-breakout", "replay", "--verify", "game.polar")
    run(there, "polar-breakout", "lab", "case-2", "--headless", "--drags", "100")
    run(there, "polar-crosscheck", "game.polar")


def tools() -> Iterator[str]:
    """The modules that are commands, as `python -m` takes them."""
    for file in sorted((ROOT / "tools").rglob("*.py")):
        parts = file.relative_to(ROOT).with_suffix("").parts
        if "packaging" not in parts and "typer.Typer(" in file.read_text("utf-8"):
            yield ".".join(parts).removesuffix(".__main__").removesuffix(".commands")


def frozen() -> None:
    """The application has its levels, scenes and source lines with it; its game is the same, to the hash."""
    install("package")
    with tempfile.TemporaryDirectory() as folder:
        run(HERE, "python", "-m", "tools.packaging.freeze", "--output", folder)
        there = Where(Path(folder, "polar-breakout"), Path(folder))
        played = [run(where, "polar-breakout", *GAME, silent=True) for where in (there, HERE)]
        if played[0] != played[1]:
            sys.exit(f".ci/run: frozen, the game is another: {played}")
        run(there, "polar-breakout", "lab", "--headless", "--drags", "20")
        for picture in (("lab", "case-2"), GAME):
            run(there, "polar-breakout", *picture, "--screenshot", "picture.png")


def web() -> None:
    """The page's tests, which need a browser, and npm for the runtime."""
    if lacks("web", "chromium", "npm"):
        return
    install("test", "web")
    node = shutil.which("node") or "node"  # npm's own
    for script in sorted((ROOT / "game" / "web" / "page").glob("*.js")):
        subprocess.run([node, "--check", script], check=True)
    run(HERE, "python", "-m", "pytest", "-q", "tests/web", BROWSER_TESTS="1")


def lacks(step: str, *programs: str) -> bool:
    """Whether a step has to be skipped for want of programs; one line says so."""
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        print(f".ci/run: {step} skipped: no {' and no '.join(missing)}", flush=True)
    return bool(missing)


def install(*extras: str) -> None:
    """See to an environment that has the checkout, and what these extras name."""
    if not ENVIRONMENT.is_dir():
        venv.create(ENVIRONMENT, with_pip=True)
    run(HERE, "python", "-m", "pip", "install", "--quiet", "--editable", f".[{','.join(extras)}]")


def run(where: Where, program: str, *arguments: str | Path, silent: bool = False, **variables: str) -> str:
    """Run a program; what it wrote, if that is not to be seen. Any exit code but 0 is the end."""
    path = shutil.which(program, path=where.programs)
    if path is None:
        sys.exit(f".ci/run: no {program} in {where.programs}")
    print("+", program, *arguments, flush=True)
    out = subprocess.PIPE if silent else None
    done = subprocess.run([path, *arguments], cwd=where.folder, env=RUNS | variables, stdout=out, text=True, check=True)
    return done.stdout or ""


if __name__ == "__main__":
    main(sys.argv[1:])
