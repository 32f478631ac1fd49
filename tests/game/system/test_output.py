"""Streams that cannot fail, and messages that stay on one line."""

import errno
import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from game.system import output
from game.system.output import UnfailingStream
from game.system.wording import MOST_QUOTED, printable, quoted, quoted_message, quoted_path
from tests.support.paths import ROOT


class Raw(io.RawIOBase):
    """A raw stream that does with each write what it was told."""

    def __init__(self, *answers):
        self.answers, self.got = list(answers), b""

    def write(self, data):
        answer = self.answers.pop(0) if self.answers else len(data)
        if isinstance(answer, OSError):
            raise answer
        if answer is not None:
            self.got += bytes(data[:answer])
        return answer

    def fileno(self):
        return 1

    def isatty(self):
        return True


def test_everything_is_written_however_little_at_a_time():
    """A raw stream may take less than it is given."""
    raw = Raw(1, 2, 3)
    assert UnfailingStream(raw).write(b"0123456789") == 10
    assert raw.got == b"0123456789"


def test_a_stream_that_is_not_ready_is_waited_for(monkeypatch):
    """As a terminal that another program has made non-blocking."""
    waited = []
    monkeypatch.setattr(output.select, "select", lambda _, writing, __: waited.append(writing))
    raw = Raw(2, None, 1)
    assert UnfailingStream(raw).write(b"012345") == 6
    assert raw.got == b"012345"
    assert waited == [[raw]]


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EPIPE, errno.EBADF, errno.EIO])
def test_after_an_error_the_rest_is_dropped(number):
    """Nobody is told by an exception, and what follows is not tried again."""
    raw = Raw(3, OSError(number, os.strerror(number)))
    stream = UnfailingStream(raw)
    assert stream.write(b"012345") == 6
    assert stream.write(b"abc") == 3
    assert raw.got == b"012"
    assert stream.problem.errno == number


def program(text, **options):
    """A program with the streams of every command, run to its end."""
    imports = "import sys\nfrom game.system.output import open_output, output_problem, print_error, print_line"
    code = f"{imports}\nopen_output()\n{text}"
    return subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False, text=True, **options)


def test_a_character_that_cannot_be_encoded_is_written_as_its_escape():
    """In ASCII, a snowman and a name that is not UTF-8."""
    text = r"print_line('\u2603 \udcff')"
    done = program(text, capture_output=True, env={**os.environ, "PYTHONIOENCODING": "ascii"})
    assert (done.stdout, done.stderr, done.returncode) == ("\\u2603 \\udcff\n", "", 0)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is full")
def test_output_that_is_lost_is_known():
    """A full disk is a reason; a reader who has gone is none."""
    with Path("/dev/full").open("w") as full:
        done = program("print_line('x' * 100000)\nprint_error(output_problem())", stdout=full, stderr=subprocess.PIPE)
    assert (done.stderr, done.returncode) == ("No space left on device\n", 0)
    reading, writing = os.pipe()
    os.close(reading)
    done = program("print_line('x' * 100000)\nprint_error(str(output_problem()))", stdout=writing, stderr=subprocess.PIPE)
    os.close(writing)
    assert (done.stderr, done.returncode) == ("None\n", 0)


@pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")
@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&- 2>&-"])
def test_closed_streams_take_no_file(closed, tmp_path):
    """What is written to a stream that was closed lands in no file that is opened afterwards."""
    file = tmp_path / "file"
    code = (
        "import os; from game.system.output import open_output, print_error, print_line; open_output(); "
        f"file = os.open({str(file)!r}, os.O_CREAT | os.O_WRONLY); "
        "print_line('x'); print_error('y'); os.write(1, b'z'); os.write(2, b'z'); "
        "raise SystemExit(0 if file > 2 else 1)"
    )
    done = subprocess.run(["/bin/sh", "-c", f'exec "$0" -c "$1" {closed}', sys.executable, code], cwd=ROOT, check=False)
    assert done.returncode == 0
    assert file.read_bytes() == b""


def test_a_message_is_one_line(capsys):
    """Line breaks, control characters, and what turns the writing direction round are escaped; other letters stay."""
    output.print_error("a\nb\r\x1b[31m\u2028\u202e\udcff\0 ü☃")
    err = capsys.readouterr().err
    assert err == "a\\nb\\r\\x1b[31m\\u2028\\u202e\\udcff\\x00 ü☃\n"
    assert printable("plain 'words'") == "plain 'words'"


def test_an_input_is_quoted_in_part():
    """Both ends of what is longer than 80 characters; of a path, more."""
    assert quoted("x" * 80) == "x" * 80
    assert len(quoted("x" * 81)) == 80
    assert quoted("a" * 100 + "z") == "a" * 38 + "..." + "a" * 38 + "z"
    assert quoted_path("/" + "p" * 200) == "/" + "p" * 200
    assert len(quoted_path("/" + "p" * 4000)) == 240


@pytest.mark.parametrize(
    "message",
    [
        "No such option: --" + "x" * 5000,
        "Invalid value for '--seed': '" + "9 " * 3000 + "' is not a number",
        'unknown "' + "a b\n" * 900 + '"',
        "unknown field `" + "k" * 900 + "`",
    ],
)
def test_a_librarys_message_quotes_little(message):
    """Its own words stay; the input in it is cut to 80 characters."""
    found = quoted_message(message)
    assert found.isprintable()
    assert found.startswith(message[:9])
    assert len(found) <= MOST_QUOTED + 60
