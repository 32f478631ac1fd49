"""What a batch refuses before anything is compiled: wrong shapes, a missing numba, a processor that rounds to 0."""

import ctypes
import math
import pickle
import platform
import subprocess
import sys

import numpy as np
import pytest

from physics import PERMANENT, Arena, Ball, Ring
from physics.batch import Batch
from physics.batch.compilation import check_numba, compile_cached, sources_hash
from tests.support.paths import ROOT

RING = Ring(5.0, 0.5, 0.3, 2, 0.0, 0.7)
ARENA = Arena((Ball(1j, 8 + 0j, 0.25),), (RING,), ((PERMANENT,) * 2,))


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ({"arenas": []}, "arenas must be at least one"),
        ({"arenas": ARENA}, "arenas must be a list of arenas, not Arena"),
        ({"arenas": None}, "arenas must be a list of arenas, not NoneType"),
        ({"arenas": [None]}, r"arenas\[0\] must be an arena, not NoneType"),
        ({"dt": "1"}, "dt must be finite and > 0, not '1'"),
        ({"ground_radius": None}, "ground_radius must be > 0, not None"),
        ({"arenas": [ARENA, ARENA._replace(balls=())]}, r"arenas\[1\] must have 1 balls, as the first, not 0"),
        ({"arenas": [ARENA, ARENA._replace(rings=())]}, r"arenas\[1\] must have 1 rings"),
        ({"arenas": [ARENA, ARENA._replace(rings=(RING._replace(radius=6.0),))]}, r"arenas\[1\]\.rings\[0\] must be the first"),
        ({"arenas": [ARENA._replace(layers=((1,),))]}, r"arenas\[0\]\.layers\[0\] must have 2 entries, not 1"),
        (
            {"arenas": [ARENA._replace(layers=((1, 2**40),))]},
            r"arenas\[0\]\.layers\[0\] must be whole numbers .* not 1099511627776",
        ),
        ({"arenas": [ARENA._replace(layers=((1, 0.5),))]}, r"arenas\[0\]\.layers\[0\] must be whole numbers .* not 0.5"),
        ({"dt": 0.0}, "dt must be finite and > 0, not 0.0"),
        ({"dt": math.nan}, "dt must be finite and > 0, not nan"),
        ({"speed": math.inf}, "speed must be finite and > 0, not inf"),
        ({"ground_radius": math.nan}, "ground_radius must be > 0, not nan"),
    ],
)
def test_a_wrong_argument_is_named(arguments, named):
    """ValueError says which, and what was expected."""
    with pytest.raises(ValueError, match=named):
        Batch(**({"arenas": [ARENA], "dt": 0.01, "speed": 8.0} | arguments))


def test_numbers_of_games_are_those_of_the_batch(monkeypatch):
    """Also where an array would count from its end; a single number is no array of games."""
    monkeypatch.setattr("physics.batch.batch.compiled", lambda: None)
    games = Batch([ARENA] * 3, dt=0.01, speed=8.0)
    for wrong in (3, -1, 1.0, "0"):
        with pytest.raises(ValueError, match="game must be a whole number from 0 to 2, not"):
            games.arena(wrong)
        with pytest.raises(ValueError, match="game must be a whole number from 0 to 2, not"):
            games.put(wrong, ARENA)
    with pytest.raises(ValueError, match="games must be a int64 array"):
        games.serve(1, np.zeros((1, 0), np.complex128), np.zeros((1, 0), np.complex128))
    assert games.arena(np.int64(0)) == ARENA


def test_without_numba_the_extra_is_named(monkeypatch):
    """Importing the package needs no numba; a batch says what to install."""
    monkeypatch.setitem(sys.modules, "numba", None)
    with pytest.raises(ImportError, match=r"numba.*python -m pip install 'polar-breakout\[batch\]'"):
        check_numba()
    with pytest.raises(ImportError, match="numba"):
        Batch([ARENA], dt=0.01, speed=8.0)


FLUSHED = """
import ctypes, sys
libm = ctypes.CDLL("libm.so.6")
environment = (ctypes.c_uint32 * 8)()
libm.fegetenv(environment)
environment[7] |= {bits}  # the SSE control word ends glibc's fenv_t
libm.fesetenv(environment)
from physics.batch.compilation import check_subnormals
try:
    check_subnormals()
except RuntimeError as error:
    sys.exit(str(error))
"""


@pytest.mark.skipif(sys.platform != "linux" or platform.machine() != "x86_64", reason="sets the SSE control word by glibc")
@pytest.mark.parametrize(("bits", "refused"), [(0, False), (1 << 15, True), (1 << 6, True), (1 << 15 | 1 << 6, True)])
def test_a_process_that_takes_subnormals_for_0_is_refused(bits, refused):
    """Flush-to-zero (bit 15) and denormals-are-zero (bit 6), alone and together."""
    assert ctypes.sizeof(ctypes.c_uint32 * 8) == 32
    code = FLUSHED.format(bits=bits)
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, "flush-to-zero" in done.stderr) == (int(refused), refused), done.stderr


def test_the_key_of_the_compiled_code_changes_with_any_source(monkeypatch, tmp_path):
    """A changed file, also one that only a called function is in, gives another key."""
    (tmp_path / "sweep").mkdir()
    for name in ("step.py", "sweep/band.py"):
        (tmp_path / name).write_text("a = 1\n", encoding="utf-8")
    monkeypatch.setattr("physics.batch.compilation.resources.files", lambda _package: tmp_path)
    keys = [sources_hash()]
    for name in ("step.py", "sweep/band.py"):
        (tmp_path / name).write_text("a = 2\n", encoding="utf-8")
        keys.append(sources_hash())
    assert len(set(keys)) == 3
    assert sources_hash() == keys[-1]


def one_function(path):
    """A function whose compiled code is kept on disk beside a file."""
    path.write_text("import numba\n\n@numba.njit(cache=True)\ndef doubled(x):\n    return 2.0 * x\n", encoding="utf-8")
    names = {}
    exec(compile(path.read_text(encoding="utf-8"), path, "exec"), names)  # noqa: S102  # the lines above
    return names["doubled"]


@pytest.mark.parametrize("gone", [b"cphysics.shapes\nGone\n.", b"cphysics.gone\nBall\n."])
def test_what_another_version_has_left_on_disk_is_compiled_anew(gone, tmp_path):
    """Its index may name a class that there is no more, which numba finds out before it compares the sources' times."""
    numba = pytest.importorskip("numba")
    doubled = one_function(tmp_path / "one.py")
    doubled.compile((numba.float64,))
    (index,) = tmp_path.rglob("*.nbi")
    index.write_bytes(pickle.dumps(numba.__version__) + gone)
    again = one_function(tmp_path / "one.py")
    compile_cached(again, (numba.float64,))
    assert again(1.5) == 3.0
    assert gone not in index.read_bytes()
