"""The page's Python, its lists of primitives, its files: without a browser."""

import json
import os
import sys
from pathlib import Path

import pygame
import pytest

from game.input.actions import Action, OwnKeys
from game.input.events import system_layout
from game.input.keys import BINDINGS, KeyTable
from game.input.scancodes import CONTROL_CODES, NAMED_KEY, SCANCODES
from game.picture.display_list import DisplayList
from game.picture.primitives import Primitive, primitives
from game.system.errors import EnvironmentMissingError
from game.web import packages
from game.web.client.keys import LEFT_ALONE, NOT_ON_PAGES, code_of, page_bindings, position_at
from game.web.client.page import Page
from tools.grade.page import PageGrader

NAMED = {"space": " ", "return": "Enter", "escape": "Escape", "up": "ArrowUp", "down": "ArrowDown", "pause": "Pause"}
NAMED |= {"break": "Pause", "home": "Home", "end": "End", "f1": "F1", "page up": "PageUp", "page down": "PageDown"}
"""What browsers call what is written on a key, by pygame's name for it."""


def test_keys_mean_what_they_mean_on_the_desktop():
    """Every key of the US layout: by what a browser says where it is and what is written on it; Tab is the browser's."""
    desktop, on_page = KeyTable(BINDINGS), KeyTable(page_bindings(OwnKeys()))
    pygame.display.init()
    layout = system_layout()
    names = {position: pygame.key.name(pygame.key.key_code(pygame.key.name(code))) for position, code in layout.items()}
    pygame.display.quit()
    meant = set()
    for name, position in SCANCODES.items():
        code = CONTROL_CODES.get(position) or layout.get(position) or position | NAMED_KEY
        key = names.get(position) or NAMED.get(pygame.key.name(code), name)
        expected = None if name in LEFT_ALONE else desktop.action(position, code)
        action = on_page.action(position_at(name, key), code_of(name, key))
        assert action is (None if expected in NOT_ON_PAGES else expected), name
        meant.add(action)
    assert {one.action for one in BINDINGS} - meant == {Action.TIP, Action.FULL_SCREEN, Action.NORMALS}
    assert on_page.action(position_at("Digit0", "+"), code_of("Digit0", "+")) is Action.MORE


def page_playing():
    """A page in a game."""
    page = Page(b'{"rate": 1, "sounds": []}', "", calm=False)
    frame(page, {"type": "link", "fragment": "classic/4"})
    return page


def frame(page, *signals, seconds=0.0):
    """The reply to some signals."""
    return json.loads(page.frame(json.dumps({"seconds": seconds, "width": 1280, "height": 800, "signals": signals})))


def codes(numbers):
    """The codes of a list, each primitive being as long as it is documented to be."""
    found = list(primitives(numbers))
    assert sum([3 + len(own) for *_, own in found]) == len(numbers)
    assert all([0.0 <= opacity <= 1.0 for _, _, opacity, _ in found])
    return [code for code, *_ in found]


def test_both_views_are_lists_of_the_documented_primitives():
    """The flat view has sectors, the solid view has prisms; texts are referred to by index."""
    page = page_playing()
    flat, reply = codes(page.numbers), frame(page)
    assert Primitive.SECTOR in flat
    assert len(reply["texts"]) == flat.count(Primitive.TEXT)
    frame(page, {"type": "key", "code": "Digit2", "key": "2", "down": True})
    for _ in range(12):
        frame(page, seconds=0.1)
    solid = codes(page.numbers)
    assert Primitive.SECTOR not in solid
    assert solid.count(Primitive.PRISM) > 50
    assert solid.index(Primitive.CAMERA) < solid.index(Primitive.SHADOWS) < solid.index(Primitive.PRISM)


def test_the_backdrop_is_sent_only_when_it_changes():
    """Not from frame to frame, but after a resize."""
    page = page_playing()
    for _ in range(400):
        if not frame(page, seconds=0.02).get("backdrop"):
            break
    assert not frame(page, seconds=0.01).get("backdrop")
    resized = json.loads(page.frame('{"seconds": 0.0, "width": 900, "height": 800}'))
    assert resized["backdrop"]


def test_a_function_that_is_given_up_is_not_asked_again():
    """A worker that had to be ended: the request comes again without the function, and the text does not run in the page."""
    page = Page(b'{"rate": 1, "sounds": []}', "", calm=True)
    frame(page, {"type": "link", "fragment": "functions"}, {"type": "code", "text": "def on_left(a, b):\n    return a > b\n"})
    first = frame(page, {"type": "choose", "id": "grade"})["grading"]
    second = frame(page, {"type": "graded", "number": first["number"], "function": "on_left", "call": 7})["grading"]
    assert second["given_up"] == {"on_left": 7}
    reply = PageGrader().grade(json.dumps(second), lambda *_call: None)
    menu = frame(page, {"type": "graded", "number": second["number"], "reply": reply})["menu"]
    words = " ".join([*menu["lines"], *[item["label"] for item in menu["items"]]])
    assert "no answer to on_left(a=" in words
    assert "not used in the lab and in the game" in words
    assert next(item for item in menu["items"] if item["id"] == "fly")["disabled"]


def test_without_npm_one_line_says_what_is_needed(monkeypatch, tmp_path):
    """The program ends with exit code 3 for this error."""
    monkeypatch.setattr(packages.shutil, "which", lambda _name: None)
    with pytest.raises(EnvironmentMissingError, match=r"^npm is needed to fetch pyodide 314\.0\.7; install Node\.js$"):
        packages.fetched(packages.RUNTIME, tmp_path)


def test_another_file_than_recorded_is_refused_and_not_cached(monkeypatch, tmp_path):
    """What a client brings is held to its hash."""

    def brings(package, folder):
        Path(folder, package.file).write_bytes(b"another")

    monkeypatch.setitem(packages._CLIENTS, "pip", brings)
    with pytest.raises(EnvironmentMissingError, match="brought another file than recorded"):
        packages.fetched(packages.MSGSPEC, tmp_path / "cache")
    assert not (tmp_path / "cache").exists()


def test_a_client_that_fails_is_said_in_one_line(monkeypatch, tmp_path):
    """No network, no registry."""
    monkeypatch.setattr(sys, "executable", str(tmp_path / "no-python"))
    with pytest.raises(EnvironmentMissingError, match=r"pip cannot fetch msgspec 0\.22\.0; a connection"):
        packages.fetched(packages.MSGSPEC, tmp_path)


def test_a_colour_survives_a_float():
    """Every colour is exact in 32 bits."""
    out = DisplayList()
    out.disc(0j, 1.0, (255, 254, 253))
    assert int(out.numbers[1]) == 0xFFFEFD


@pytest.mark.skipif(not os.environ.get("BROWSER_TESTS"), reason="the tests in a browser: `.ci/run web` runs them")
def test_the_tests_in_a_browser_are_asked_for():
    """Elsewhere this one line says that they are left out."""
    assert os.environ["BROWSER_TESTS"]
