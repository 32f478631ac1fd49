"""The files that a web host serves, without a browser and without the runtime."""

import gzip
import json
import socket
import struct
from urllib.parse import urlsplit
from urllib.request import urlopen

import numpy as np
import pytest

from game.system.errors import EnvironmentMissingError
from game.web import archives
from game.web import compiled as compiling
from game.web.archives import compressed, page_archive, zip_archive, zip_contents
from game.web.bundle import browser_sources, grading_sources
from game.web.compiled import compiled
from game.web.samples import differences
from game.web.server import served
from game.web.standard_library import needed


def test_the_sources_hold_what_the_page_imports_and_nothing_that_needs_pygame():
    """They are found by the imports alone; the levels are with them."""
    names = browser_sources()
    assert {"game/web/client/page.py", "game/lab/scenes/runs/nudge.py", "game/languages/de.mo"} <= names.keys()
    assert any([name.startswith("game/levels/classic/1-") for name in names])
    assert not [name for name in names if name.startswith(("game/loop/app.py", "game/drawing/painter", "physics/batch"))]


def test_the_worker_that_grades_needs_modules_of_the_tools_alone():
    """Whatever else it imports is in the page's archive."""
    names = grading_sources()
    assert "tools/grade/page.py" in names
    assert all([name.startswith("tools/") for name in names])


def test_archives_hold_the_files_and_are_the_same_whatever_the_order():
    """The page's archive has the lengths in front, four bytes for theirs."""
    files = {"b/c.py": b"xyz", "a.toml": b"\0\xff", "empty": b""}
    turned = dict(reversed(files.items()))
    assert zip_contents(zip_archive(files)) == files
    assert zip_archive(files) == zip_archive(turned)
    archive = page_archive(files)
    assert archive == page_archive(turned)
    start = 4 + int.from_bytes(archive[:4], "little")
    for name, length in json.loads(archive[4:start]):
        assert archive[start : start + length] == files[name]
        start += length
    assert start == len(archive)


@pytest.mark.parametrize("installed", [True, False], ids=["with zopfli", "without"])
def test_compressed_data_come_back_and_a_torn_result_is_not_used(monkeypatch, tmp_path, installed):
    """Compressing again gives the same bytes, from the cache or not."""
    if not installed:
        monkeypatch.setattr(archives, "zopfli", None)
    elif archives.zopfli is None:
        pytest.skip("zopfli is not installed")
    data = b"the same bytes, " * 50
    packed = compressed(data, tmp_path)
    assert gzip.decompress(packed) == data
    files = [*tmp_path.iterdir()]
    assert len(files) == installed
    for file in files:
        assert file.read_bytes() == packed
        file.write_bytes(packed[:-9])
    assert compressed(data, tmp_path) == packed
    assert compressed(data + b"!", tmp_path) != packed
    (tmp_path / "file").touch()
    assert compressed(data, tmp_path / "file") == packed


def test_samples_come_back_from_their_differences():
    """Every step from one 16-bit number to another, the largest too."""
    samples = np.array([0, 1, -1, 32767, -32768, 32767, 5, 5, 5, -300], dtype=np.int16)
    low, high = np.frombuffer(differences(samples), np.uint8).astype(np.int64).reshape(2, -1)
    folded = low | high << 8
    taken = (folded >> 1) ^ -(folded & 1)
    for _ in range(3):
        taken = np.cumsum(taken)
    assert taken.astype(np.int16).tolist() == samples.tolist()


def test_of_the_standard_library_there_is_what_computes():
    """Whole packages and single modules are left out."""
    served = {"math.py", "asyncio/base_events.py", "encodings/__init__.py", "encodings/utf_8.py", "logging/__init__.py"}
    left_out = {"http/client.py", "turtle.py", "encodings/koi8_r.py", "logging/handlers.py", "_sysconfigdata__emscripten.py"}
    assert needed(dict.fromkeys(served | left_out, b"")).keys() == served


def test_what_was_compiled_is_cached_and_a_torn_file_is_not_used(monkeypatch, tmp_path):
    """Node.js is asked again, and its absence said in one line."""
    sources = {"a.py": b"a = 1"}
    monkeypatch.setattr(compiling.shutil, "which", lambda _name: None)
    with pytest.raises(EnvironmentMissingError, match=r"^node is needed to compile the page's Python; install Node\.js$"):
        compiled(sources, {}, tmp_path)
    monkeypatch.setattr(compiling, "_by_node", lambda _script, archive, _runtime: archive)
    assert compiled(sources, {}, tmp_path) == sources
    monkeypatch.undo()
    monkeypatch.setattr(compiling.shutil, "which", lambda _name: None)
    assert compiled(sources, {}, tmp_path) == sources
    with pytest.raises(EnvironmentMissingError):
        compiled({"a.py": b"a = 2"}, {}, tmp_path)
    (path,) = tmp_path.glob("compiled-*.zip")
    path.write_bytes(path.read_bytes()[:-10])
    with pytest.raises(EnvironmentMissingError):
        compiled(sources, {}, tmp_path)


def test_a_browser_that_goes_away_leaves_the_terminal_quiet(capsys):
    """Its connection is reset while the server waits for the next request; the server goes on."""
    with served({"index.html": b"a page"}, 0) as address:
        where = urlsplit(address)
        connection = socket.create_connection((where.hostname, where.port))
        connection.sendall(b"GET / HTTP/1.1\r\nHost: here\r\n\r\n")
        assert connection.recv(1)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))  # a close is a reset
        connection.close()
        with urlopen(address) as answer:  # noqa: S310  # ours
            assert answer.read() == b"a page"
    assert capsys.readouterr() == ("", "")
