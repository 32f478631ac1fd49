"""The regression suite: golden games play the same, bit for bit, wherever they are played.

`pytest tests/game/replays/test_golden.py --regen` records them anew; the changelog must then say why.
"""

import os
import platform
import subprocess
import sys

import pytest

from game.replays.file import load, save
from game.replays.verify import verified
from tests.support.games.golden import FOLDER, LEAST_TICKS, golden_games, recorded
from tests.support.paths import ROOT

GOLDEN = list(golden_games())
FILES = [FOLDER / f"{golden.name}.polar" for golden in GOLDEN]
NO_FMA = "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable"


@pytest.fixture(scope="module", autouse=True)
def regenerated(request):
    """With --regen, every golden game is recorded anew before it is looked at."""
    if request.config.getoption("--regen"):
        FOLDER.mkdir(exist_ok=True)
        for golden, file in zip(GOLDEN, FILES, strict=True):
            save(recorded(golden), file)


def test_there_are_at_least_twenty_different_games():
    """Twenty games and more, over all levels, all kinds of player, each with its own seed and each a minute or longer."""
    recordings = [load(file) for file in FILES]
    assert sorted(FOLDER.glob("*.polar")) == sorted(FILES)
    assert len(FILES) >= 20
    assert len({recording.seed for recording in recordings}) == len(FILES)
    assert len({recording.levels[0].name for recording in recordings}) == 7
    assert all(recording.ticks >= LEAST_TICKS for recording in recordings)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_golden_game(file):
    """A golden game still plays as it was recorded, in every block's hash."""
    assert verified(load(file)).divergence is None


def test_golden_games_elsewhere():
    """A game of each level gives the same hashes with assertions off, a fixed hash seed and without the C library's FMA code.

    All three at once: this process has assertions, a random hash seed and that code, and both give the recorded bits.
    """
    files = [FILES[3 * level + level % 3] for level in range(7)]  # three players took turns
    environment = {"PYTHONHASHSEED": "0"}
    if platform.libc_ver()[0] == "glibc":  # only glibc can switch its FMA code off
        environment["GLIBC_TUNABLES"] = NO_FMA
    command = [sys.executable, "-O", "-m", "game", "replay", "--verify", *map(str, files)]
    done = subprocess.run(command, cwd=ROOT, env=os.environ | environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    expected = [load(file).hashes[-32:].hex() for file in files]
    assert [line.rpartition("hash=")[2] for line in done.stdout.splitlines()] == expected
