"""The cost of a game on own functions is measured in milliseconds."""

from game.system.command_line import run
from tests.grade.wrong_files import RIGHT
from tools.measure.own_functions import app


def test_it_measures(capsys):
    """Three lines: the own functions, the slides', and a call that does nothing."""
    assert run(app, "measure", [str(RIGHT), "--ticks", "800"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split(":")[0] for line in lines] == ["own functions", "the slides'", "round trip"]
    assert all(float(line.split("median ")[1].split()[0]) > 0.0 for line in lines)
