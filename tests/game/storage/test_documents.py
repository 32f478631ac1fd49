"""Scores, progress and the window's box in files: whatever happens to these, the game goes on and nothing is lost."""

import json
import os
import subprocess
import sys

import pytest

from game.storage import progress, stored_file
from game.storage.folder import data_folder
from game.storage.progress import Best, Progress
from game.storage.scores import MOST, Score, Scores
from game.storage.storage import NO_FOLDER, Storage
from game.storage.stored_file import StoredFile
from tests.support.paths import ROOT


def names(folder):
    """The files in a folder that are no locks."""
    return sorted(path.name for path in folder.iterdir() if not path.name.endswith(".lock"))


def bests(folder):
    """The levels of the progress in a folder."""
    return [best.level for best in Storage(folder).progress.value.bests]


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b"\xff\xfe",
        b"[" * 100_000,
        b'{"version": 1, "bests": 3}',
        b'{"version": 1, "bests": [{"level": "A", "difficulty": "easy", "score": -1}]}',
        b'{"version": 1, "bests": [{"level": "A", "difficulty": "easy", "rank": 99}]}',
        b'{"version": 1, "bests": [{"level": "A", "difficulty": "easy", "score": 1e999}]}',
        b'{"version": 1, "bests": [{"level": "A", "difficulty": "easy", "sha256": "../../x"}]}',
        b'{"version": "one"}',
        json.dumps({"last_level": "x" * 1000}).encode(),
    ],
    ids=lambda data: data[:60].decode("latin-1"),
)
def test_a_damaged_file_is_put_aside(tmp_path, data):
    """The game starts as for the first time, the file is kept under another name, one line says so, and saving works."""
    (tmp_path / "progress.json").write_bytes(data)
    storage = Storage(tmp_path)
    assert storage.progress.value == Progress()
    (aside,) = [name for name in names(tmp_path) if ".bad-" in name]
    assert (tmp_path / aside).read_bytes() == data
    assert [line.startswith("progress not readable: moved to") for line in storage.problems] == [True]
    storage.level_done(Best("A", "easy", 7))
    assert bests(tmp_path) == ["A"]


def test_a_file_of_a_newer_version_is_left_alone(tmp_path):
    """It is not overwritten, what happens holds for the session, and one line says so."""
    newer = json.dumps({"version": progress.VERSION + 1, "bests": "another format"})
    (tmp_path / "progress.json").write_text(newer)
    storage = Storage(tmp_path)
    storage.level_done(Best("A", "easy", 7))
    assert storage.progress.value.finished("A")
    assert (tmp_path / "progress.json").read_text() == newer
    assert "newer version" in storage.problems[0]


def test_a_full_disk_loses_nothing_once_there_is_room_again(tmp_path, monkeypatch):
    """What could not be written holds for the session, is told, and is written with the next change."""
    storage = Storage(tmp_path)

    def full(_path, _data):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(stored_file, "write_atomically", full)
        storage.level_done(Best("A", "easy", 7))
    assert storage.progress.value.finished("A")
    assert "No space left" in storage.problems[0]
    assert bests(tmp_path) == []
    storage.level_done(Best("B", "easy", 7))
    assert bests(tmp_path) == ["A", "B"]


def test_without_a_folder_the_session_goes_on(tmp_path, monkeypatch):
    """Where the system knows no home, or the folder cannot be made, one line says that nothing is saved."""
    monkeypatch.setattr("platformdirs.user_data_path", lambda *_, **__: (_ for _ in ()).throw(RuntimeError("no home")))
    assert data_folder() is None
    (tmp_path / "file").write_text("")
    for storage in (Storage(None), Storage(tmp_path / "file" / "data")):
        storage.enter(Score("Ada", 10, "easy"))
        storage.level_done(Best("A", "easy", 7))
        assert [score.name for score in storage.scores.value.table("easy")] == ["Ada"]
        assert storage.progress.value.finished("A")
    assert Storage(None).problems == [NO_FOLDER]
    assert len(storage.problems) == 2


def test_a_folder_that_cannot_be_written_to_is_told(tmp_path):
    """Read-only: what is there is read, and changes hold for the session."""
    if os.geteuid() == 0:
        pytest.skip("nothing is read-only for root")
    Storage(tmp_path).enter(Score("Ada", 10, "easy"))
    tmp_path.chmod(0o500)
    try:
        storage = Storage(tmp_path)
        storage.enter(Score("Bea", 20, "easy"))
        assert [score.name for score in storage.scores.value.table("easy")] == ["Bea", "Ada"]
        assert "not saved" in storage.problems[0]
    finally:
        tmp_path.chmod(0o700)


def test_two_games_that_save_at_once_lose_nothing(tmp_path):
    """Two processes enter 40 levels each, in turns that nobody orders: all 80 are there."""
    program = (
        "import sys; from pathlib import Path\n"
        "from game.storage.storage import Storage; from game.storage.progress import Best\n"
        "storage = Storage(Path(sys.argv[1]))\n"
        "for number in range(40): storage.level_done(Best(f'{sys.argv[2]}{number}', 'easy', number))\n"
        "assert not storage.problems, storage.problems"
    )
    children = [subprocess.Popen([sys.executable, "-c", program, str(tmp_path), side], cwd=ROOT) for side in ("left", "right")]
    assert [child.wait(60) for child in children] == [0, 0]
    assert set(bests(tmp_path)) == {f"{side}{number}" for side in ("left", "right") for number in range(40)}


def test_the_best_of_a_level_is_the_best_of_each(tmp_path):
    """The higher score with its replay, the better rank and the shorter time stay, whatever run they come from."""
    runs = [Best("A", "easy", 50, 3, 900, "a", "0" * 64), Best("A", "easy", 80, 1, 700, "b"), Best("A", "easy", 60, 2, 500)]
    for order in (runs, runs[::-1]):
        found = Progress()
        for run in order:
            found = found.after(run)
        (best,) = found.bests
        assert (best.score, best.rank, best.ticks, best.replay) == (80, 3, 500, "b")
    assert Progress().after(Best("A", "hard", 1)).best("A", "easy") is None
    storage = Storage(tmp_path)
    assert storage.level_done(runs[0]) is None
    assert storage.level_done(runs[2]) == runs[0]


def test_levels_open_one_after_the_other():
    """The first, all that were finished, and the one after each."""
    held = Progress().after(Best("A", "hard", 1)).after(Best("C", "easy", 1))
    assert [held.is_open(index, ["A", "B", "C", "D", "E"]) for index in range(5)] == [True, True, True, True, False]


def test_the_table_keeps_the_ten_best_of_each_difficulty():
    """A score that would be eleventh does not qualify; of equal ones the first stays above."""
    scores = Scores()
    for number in range(MOST):
        assert scores.qualifies(100, "easy")
        scores = scores.after(Score(f"P{number}", 100, "easy"))
    assert not scores.qualifies(100, "easy")
    assert not scores.qualifies(0, "hard")
    assert scores.qualifies(1, "hard")
    scores = scores.after(Score("Best", 101, "easy")).after(Score("Hard", 5, "hard"))
    assert [score.name for score in scores.table("easy")] == ["Best", *[f"P{number}" for number in range(MOST - 1)]]
    assert len(scores.entries) == MOST + 1


def test_a_document_in_memory_reads_and_writes_nothing(tmp_path, monkeypatch):
    """Without a path there are no files, and no problems."""
    monkeypatch.chdir(tmp_path)
    held = StoredFile(None, Scores, 1)
    held.update(lambda scores: scores.after(Score("Ada", 1, "easy")))
    assert [score.name for score in held.value.entries] == ["Ada"]
    assert held.problem is None
    assert names(tmp_path) == []
