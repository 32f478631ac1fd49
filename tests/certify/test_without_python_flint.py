"""A machine without python-flint: the command says what to install."""

import sys

from game.system.command_line import run
from tools.certify.commands import app


def test_without_python_flint_it_is_exit_code_3(monkeypatch, capsys):
    """One line that names the extra, and nothing on stdout."""
    monkeypatch.setitem(sys.modules, "flint", None)
    code = run(app, "python -m tools.certify", ["--impacts", "1"])
    out, err = capsys.readouterr()
    assert (code, out, len(err.splitlines())) == (3, "", 1)
    assert "[proof]" in err
