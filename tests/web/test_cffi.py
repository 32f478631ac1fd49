"""pymunk without cffi: its library read and called by game/web/cffi, as in a browser, but on this machine."""

import json
import subprocess
import sys

import pytest

from game.web.cffi.backend import DESTRUCTION, Pointer

ASKED = """
import gc, json, sys
if sys.argv[1:]:
    from game.web.cffi.backend import load_library
    load_library("pymunk", "_chipmunk")
from physics import Ball, Ring
from tools.crosscheck.second_engine import Pymunk
ring, engine = Ring(6.0, 1.0, 0.5, 3, 0.1, 0.3), Pymunk()
contact = engine.touch(Ball(7.2 + 0.6j, -8.0 - 1.0j, 0.5), ring, range(3))
positions = engine.flight(Ball(9.0 + 0.5j, -8.0 - 1.0j, 0.5), [ring, ring._replace(radius=12.0)], 1 / 240, 120)
gc.collect()
is_cffi = hasattr(sys.modules["_cffi_backend"], "__file__")
print(json.dumps([repr(contact), repr(engine.shapes(ring, (1,))), repr(positions), is_cffi]))
"""


@pytest.fixture(scope="module")
def answers():
    """pymunk's answers with cffi, and without."""
    commands = [[sys.executable, "-c", ASKED, *argument] for argument in ([], ["without"])]
    children = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for command in commands]
    try:
        return [json.loads(child.communicate(timeout=60)[0]) for child in children]
    finally:
        for child in children:
            child.kill()
            child.wait()


def test_pymunk_answers_the_same_to_the_last_bit(answers):
    """Contacts, shapes and a flight with bounces; Chipmunk's callbacks and its memory work, too."""
    with_cffi, without = answers
    assert without[:3] == with_cffi[:3]
    assert "EngineContact" in without[0]
    assert [with_cffi[3], without[3]] == [True, False]


def test_a_destructor_waits_until_no_function_of_the_library_runs():
    """Garbage may be collected at any moment; removing an entry from a list over which the library iterates is a crash."""
    done = []
    pointer = Pointer(None, 7).destroyed_by(lambda one: done.append(one.address))
    DESTRUCTION.begin()
    del pointer
    early = list(done)
    DESTRUCTION.end()
    assert (early, done) == ([], [7])
