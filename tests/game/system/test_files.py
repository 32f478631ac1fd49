"""Files: whole or not at all, whatever is at the path, and nothing left behind."""

import errno
import os
import stat
from pathlib import Path

import pytest

from game.system import files
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import (
    check_target,
    check_working_directory,
    free_path,
    read_input,
    remove_temporaries,
    write_atomically,
    write_new,
)

fcntl = pytest.importorskip("fcntl")  # Windows has other locks

OLD, NEW = b"old", b"new" * 100_000


def names(folder):
    """What is in a folder."""
    return sorted(path.name for path in folder.iterdir())


def mode(path):
    """A file's permissions."""
    return stat.S_IMODE(path.stat().st_mode)


@pytest.fixture
def umask():
    """Sets the umask for one test."""
    before = os.umask(0o022)
    yield os.umask
    os.umask(before)


def test_a_file_is_replaced_whole(tmp_path):
    """The new bytes, and no other file."""
    file = tmp_path / "file"
    for data in (OLD, NEW):
        write_atomically(file, data)
        assert file.read_bytes() == data
    assert names(tmp_path) == ["file"]


@pytest.mark.parametrize("failing", ["write", "fsync", "replace"])
def test_what_cannot_be_written_leaves_the_old_file(tmp_path, monkeypatch, failing):
    """On a full disk, and when the last step fails; the temporary file is gone."""
    file = tmp_path / "file"
    write_atomically(file, OLD)

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    class Full:
        def __init__(self, file):
            self._file, self.write, self.flush, self.fileno, self.close = file, full, file.flush, file.fileno, file.close

    if failing == "write":
        fdopen = os.fdopen
        monkeypatch.setattr(files.os, "fdopen", lambda *arguments: Full(fdopen(*arguments)))
    elif failing == "fsync":
        monkeypatch.setattr(files.os, "fsync", full)
    else:
        monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="No space left"):
        write_atomically(file, NEW)
    if failing != "replace":
        with pytest.raises(OSError, match="No space left"):
            write_new(tmp_path, "other", NEW)
    assert file.read_bytes() == OLD
    assert names(tmp_path) == ["file"]


@pytest.mark.parametrize(("mask", "expected"), [(0o022, 0o644), (0o077, 0o600), (0o002, 0o664)])
def test_the_umask_is_respected(tmp_path, umask, mask, expected):
    """A new file has the permissions that any program's would have."""
    umask(mask)
    write_atomically(tmp_path / "file", NEW)
    write_new(tmp_path, "new", NEW)
    assert [mode(tmp_path / name) for name in ("file", "new")] == [expected, expected]


def test_permissions_of_a_file_that_exists_are_kept(tmp_path):
    """Whatever the umask."""
    file = tmp_path / "file"
    write_atomically(file, OLD)
    file.chmod(0o640)
    write_atomically(file, NEW)
    assert mode(file) == 0o640


@pytest.mark.parametrize("there", [True, False])
def test_a_link_stays_and_its_target_is_written(tmp_path, there):
    """As dotfile managers need it: in another folder, the temporary file beside the target; also where there is none yet."""
    kept, home = tmp_path / "kept", tmp_path / "home"
    kept.mkdir()
    home.mkdir()
    if there:
        (kept / "settings").write_bytes(OLD)
    link = home / "settings"
    link.symlink_to("../kept/settings")
    write_atomically(link, NEW)
    assert link.is_symlink()
    assert (kept / "settings").read_bytes() == NEW
    assert (names(kept), names(home)) == (["settings"], ["settings"])


def special(folder, kind):
    """A path at which there is something that is no regular file."""
    path = folder / "special"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "device":
        path.symlink_to("/dev/null")
    elif kind == "folder":
        path.mkdir()
    else:
        path.symlink_to("nothing")
    return path


@pytest.mark.parametrize("kind", ["pipe", "device", "folder"])
def test_what_is_no_file_is_not_replaced(tmp_path, kind):
    """A pipe, a device and a folder stay what they are, and are not waited for."""
    path = special(tmp_path, kind)
    before = path.lstat()
    with pytest.raises(OSError, match="not a regular file"):
        write_atomically(path, NEW)
    assert path.lstat().st_ino == before.st_ino
    assert names(tmp_path) == ["special"]


@pytest.mark.parametrize(
    ("kind", "reason"),
    [
        ("pipe", "cannot be written; a pipe, not a regular file"),
        ("device", "cannot be written; a device, not a regular file"),
        ("folder", "a folder; expected a file"),
        ("link", "a link to nothing"),
    ],
)
def test_a_target_that_is_no_file_is_refused_before_the_work(tmp_path, kind, reason):
    """In one line that names the option."""
    path = special(tmp_path, kind)
    with pytest.raises(BadInputError, match=f"--record .*{reason}"):
        check_target(path, "--record")


def test_a_folder_that_cannot_be_written_is_refused_before_the_work(tmp_path, monkeypatch):
    """Found out by trying, as permissions alone do not tell: not of a read-only disk, and not to root."""
    with pytest.raises(BadInputError, match="there is no folder"):
        check_target(tmp_path / "none" / "file", "--record")
    with pytest.raises(BadInputError, match="/proc/file: cannot be written; "):
        check_target(Path("/proc/file"), "--record")
    file = tmp_path / "file"
    file.write_bytes(OLD)
    monkeypatch.setattr(files.os, "access", lambda *_: False)
    with pytest.raises(BadInputError, match="cannot be written; Permission denied"):
        check_target(file, "--record")


def test_a_target_that_can_be_written_is_left_as_it_is(tmp_path):
    """Nothing is made where there was nothing, and nothing is changed."""
    file = tmp_path / "file"
    check_target(file, "--record")
    assert names(tmp_path) == []
    file.write_bytes(OLD)
    check_target(file, "--record")
    check_target(None, "--record")
    assert (names(tmp_path), file.read_bytes()) == (["file"], OLD)


@pytest.mark.parametrize(("name", "fine"), [("a.png", True), ("A.PNG", True), ("a.txt", False), ("a", False), (".png", False)])
def test_a_pictures_name_says_that_it_is_one(tmp_path, name, fine):
    """Nobody finds a PNG in a file called a.txt."""
    if fine:
        check_target(tmp_path / name, "--screenshot", ".png")
    else:
        with pytest.raises(BadInputError, match=r"expected a name that ends in \.png"):
            check_target(tmp_path / name, "--screenshot", ".png")


def test_a_name_that_is_taken_is_not_taken_again(tmp_path):
    """By a file, a folder, or a link to nothing: the next number is tried, and nothing is replaced."""
    (tmp_path / "a.polar").write_bytes(OLD)
    (tmp_path / "a-2.polar").mkdir()
    (tmp_path / "a-3.polar").symlink_to("nothing")
    assert free_path(tmp_path, "a.polar").name == "a-4.polar"
    assert [write_new(tmp_path, "a.polar", NEW).name for _ in range(2)] == ["a-4.polar", "a-5.polar"]
    assert (tmp_path / "a.polar").read_bytes() == OLD
    assert len(names(tmp_path)) == 5


def test_a_name_is_taken_once_by_many_at_the_same_time(tmp_path):
    """Forty processes write under one name: there are forty files in the end, each whole."""
    children = []
    for number in range(40):
        child = os.fork()
        if child == 0:
            write_new(tmp_path, "a.polar", b"%02d" % number * 1000)
            os._exit(0)
        children.append(child)
    assert [os.waitpid(child, 0)[1] for child in children] == [0] * 40
    assert {path.read_bytes() for path in tmp_path.iterdir()} == {b"%02d" % number * 1000 for number in range(40)}


def test_where_there_are_no_links_the_name_is_still_taken_once(tmp_path, monkeypatch):
    """On some disks for cameras and the like."""

    def impossible(*_):
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(files.os, "link", impossible)
    assert [write_new(tmp_path, "a.polar", NEW).name for _ in range(2)] == ["a.polar", "a-2.polar"]
    assert (tmp_path / "a-2.polar").read_bytes() == NEW
    monkeypatch.setattr(Path, "replace", impossible)
    with pytest.raises(PermissionError):
        write_new(tmp_path, "b.polar", NEW)
    assert names(tmp_path) == ["a-2.polar", "a.polar"]


def test_leftovers_are_swept_and_nothing_else(tmp_path):
    """What a killed process left goes; what a living one is writing, and what is not ours, stays."""
    left, used = tmp_path / ".polar-breakout-0123.tmp", tmp_path / ".polar-breakout-4567.tmp"
    for path in (left, used, tmp_path / ".other.tmp", tmp_path / "polar-breakout-1.tmp", tmp_path / ".polar-breakout-9"):
        path.write_bytes(OLD)
    with used.open("wb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        remove_temporaries(tmp_path)
        assert names(tmp_path) == [".other.tmp", ".polar-breakout-4567.tmp", ".polar-breakout-9", "polar-breakout-1.tmp"]
    remove_temporaries(tmp_path)
    assert not used.exists()
    remove_temporaries(tmp_path / "none")


def test_a_file_swept_before_it_is_locked_is_made_again(tmp_path, monkeypatch):
    """Another process may look at it in the moment between."""
    flock, swept = fcntl.flock, []

    def late(file, operation):
        if not swept:
            swept.append(True)
            remove_temporaries(tmp_path)
        flock(file, operation)

    monkeypatch.setattr(files.fcntl, "flock", late)
    write_atomically(tmp_path / "file", NEW)
    assert (tmp_path / "file").read_bytes() == NEW
    assert names(tmp_path) == ["file"]


@pytest.mark.parametrize(
    ("kind", "reason"),
    [("pipe", "not a pipe"), ("device", "not a device"), ("folder", "not a folder"), ("link", "No such file")],
)
def test_what_is_no_file_is_not_read(tmp_path, kind, reason):
    """And nobody waits for a pipe."""
    with pytest.raises(BadInputError, match=f"cannot read level; .*{reason}"):
        read_input(special(tmp_path, kind), "level", 100)


def test_a_working_directory_that_is_gone_is_one_line(tmp_path, monkeypatch):
    """New processes could not start in it; a file in it cannot be written."""
    check_working_directory()
    folder = tmp_path / "gone"
    folder.mkdir()
    monkeypatch.chdir(folder)
    folder.rmdir()
    with pytest.raises(EnvironmentMissingError, match="no working directory"):
        check_working_directory()
    with pytest.raises(BadInputError, match="--record file: cannot be written; No such file"):
        check_target(Path("file"), "--record")


def test_a_file_is_read_up_to_a_size(tmp_path):
    """Larger ones are refused with the size."""
    file = tmp_path / "file"
    file.write_bytes(b"x" * 2048)
    assert read_input(file, "level", 2048) == b"x" * 2048
    with pytest.raises(BadInputError, match="file: level too large; expected at most 1 KB"):
        read_input(file, "level", 1024)
    with pytest.raises(BadInputError, match="cannot read level; embedded null"):
        read_input(Path("a\0b"), "level", 100)
