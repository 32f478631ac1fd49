"""`--with`: a student's normals and bounces beside pymunk's."""

import pytest

from game.system.command_line import run
from tests.grade.wrong_files import RIGHT, WRONG_FILES
from tools.crosscheck.commands import app

FEW = ("--level", "aimed", "--games", "1", "--ticks", "60")


def compared(capsys, mine, *more):
    """Exit code, the table's rows by their names, and stderr."""
    code = run(app, "polar-crosscheck", ["--with", str(mine), *FEW, *more])
    out, err = capsys.readouterr()
    rows = {
        line[:19].strip(): [int(number) for number in line.split()[-4:]] for line in out.splitlines() if line[-1:].isdigit()
    }
    return code, rows, err


def test_the_right_file(capsys):
    """Faces, narrow ends and bounces are pymunk's; corners and wide sectors are the slides'; nothing differs."""
    code, rows, err = compared(capsys, RIGHT)
    assert (code, err) == (0, "")
    assert set(rows) == {"bounce", *[f"normal, {feature}" for feature in ("outer face", "inner face", "end", "corner")]}
    assert [row for name, row in rows.items() if row[0] == 0] == [rows["normal, corner"]]
    assert rows["normal, end"][0] > 3 * rows["normal, end"][1]
    assert [row[3] for row in rows.values()] == [0] * 5


@pytest.mark.parametrize(("number", "row"), [(0, "normal, inner face"), (6, "bounce"), (10, "normal, end")])
def test_a_wrong_file(capsys, tmp_path, number, row):
    """The contacts that show the mistake, each kind with a command that shows one of them; exit code 1."""
    mine = tmp_path / "mine.py"
    mine.write_text(WRONG_FILES[number].text(), encoding="utf-8")
    code, rows, err = compared(capsys, mine)
    assert code == 1
    assert rows[row][3] > 0
    assert f"polar-crosscheck: {row}: " in err
    assert " --level aimed --seed 1 --games 1 --ticks 60 --tick " in err


def test_a_fault_ends_nothing(capsys, tmp_path):
    """One line says which line failed."""
    mine = tmp_path / "mine.py"
    mine.write_text("import os\ndef on_left(a, b):\n    os.kill(os.getpid(), 9)\n")
    code, _, err = compared(capsys, mine)
    assert code == 1
    assert "mine.py: the program ended (SIGKILL)" in err.splitlines()[-1]


def test_it_goes_with_no_other_report(capsys):
    """One line, exit code 2."""
    code, rows, err = compared(capsys, RIGHT, "--convergence")
    assert (code, rows, err) == (2, {}, "polar-crosscheck: --convergence: does nothing beside --with\n")
