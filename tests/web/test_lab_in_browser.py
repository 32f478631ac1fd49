"""The lab on the page, in a real browser: every scene is the desktop's, to the last bit."""

import json

import msgspec
import pytest

from game.lab.kit.scene import EngineUse
from game.lab.registry import scenes
from game.lab.session import session as sessions
from game.lab.session.share import parsed
from game.lab.typeset.mathml import mathml_line
from game.web.client.messages import FrameRequest, LinkOpened, PointerChange
from game.web.client.page import Page
from tools.crosscheck.second_engine import Pymunk

TICK = 30
"""Of the running scenes: late enough for something to have happened."""


def lines():
    """A line for every scene; for one that runs, at a tick."""
    fresh = [sessions.fresh(scene, None) for scene in scenes()]
    return [f"{session.scene.name}?tick={TICK}" if session.runs else session.scene.name for session in fresh]


@pytest.mark.parametrize("line", lines())
def test_a_scene_is_the_desktops(page, line):
    """It has the same values and the same state hash, also in the scene that loads and runs pymunk."""
    page.go(f"lab/{line}")
    scene = parsed(line).scene
    expected = sessions.opened(parsed(line, Pymunk() if scene.engine_use is EngineUse.ALWAYS else None))
    page.wait(lambda: page.standing().get("line") == expected.line, page.standing)
    if expected.given.engine is not None:
        page.wait(lambda: page.standing()["engine"] == "pymunk", page.notification)
    assert page.standing()["hash"] == sessions.state_hash(expected)
    formulas = [row.inner_html() for row in page.tab.query_selector_all("#words > div > p")]
    assert formulas[0].count("<math>") == mathml_line(expected.picture.formula[0]).count("<math>")


@pytest.mark.parametrize("line", lines())
def test_a_handle_is_dragged_by_the_mouse(page, line):
    """From its middle by some pixels: the desktop's Python, given the same pixels, comes to the same values."""
    page.go(f"lab/{line}")
    page.wait(lambda: page.standing().get("line", "").startswith(line.partition("?")[0]))
    box = page.tab.locator("#picture").bounding_box()
    size = (round(box["width"]), round(box["height"]))
    desktop = page_here(size, line)
    pixel = handle_pixel(desktop, size)
    steps = [("down", pixel), ("move", pixel + 20 + 10j), ("move", pixel + 33 - 14j), ("up", pixel + 33 - 14j)]
    for phase, at in steps:
        message = PointerChange(phase, 1, False, at.real, at.imag, 1)
        desktop.frame(request(size, [message]))
        text = f"{{type: 'pointer', phase: '{phase}', id: 1, touch: false, x: {at.real!r}, y: {at.imag!r}, buttons: 1}}"
        page.tab.evaluate(f"polarBreakout.input.add({text})")
    page.frames(3)
    here, there = json.loads(desktop.probe()), page.standing()
    assert there["line"].partition("&tick")[0] == here["line"].partition("&tick")[0]


def request(size, signals=()):
    """A frame without time."""
    return msgspec.json.encode(FrameRequest(0.0, *size, list(signals))).decode()


def page_here(size, line):
    """The page's Python in this process, at a scene."""
    page = Page(b'{"rate": 1, "sounds": []}', "", calm=True)
    page.frame(request(size, [LinkOpened(f"lab/{line}")]))
    return page


def handle_pixel(page, size):
    """Where the first handle of a page's scene is, to a whole pixel."""
    screen = page._screen
    seen = screen._panes(screen._layout(size))[0]
    pixel = seen.camera.project(screen.session.scene.handles[0].position(screen.session.given))
    return complex(round(pixel.real), round(pixel.imag))


def test_a_scene_is_revealed_step_by_step_and_presented(page):
    """The step is in the address; to guess first begins again; in a lecture room the controls make room for the picture."""
    page.go("lab/case-2?step=4")
    page.wait(lambda: page.standing().get("line", "").endswith("step=4"), page.standing)
    assert page.tab.evaluate("location.hash").endswith("step=4")
    page.tab.check("#item-predict")
    page.frames(2)
    assert page.standing()["line"].endswith("step=1")
    narrow = page.tab.locator("#picture").bounding_box()["width"]
    page.tab.locator("#picture").focus()
    page.tab.keyboard.press("p")
    page.wait(lambda: not page.title())
    assert page.tab.locator("#picture").bounding_box()["width"] > narrow
    for _ in range(3):
        page.tab.keyboard.press("Space")
    page.wait(lambda: page.standing()["line"].endswith("step=4"), page.standing)
    page.use("present")
    page.wait(lambda: page.title().startswith("Narrow phase, case 2"))


_OTHER_SLIDER = """(() => {
  const slider = document.getElementById("item-value:ball.y").parentElement.querySelector("[type=range]");
  slider.value = 2;
  slider.dispatchEvent(new Event("input"));
})()"""


def test_a_number_that_is_being_typed_is_not_replaced(page):
    """It stays while another value changes, and is taken when its field is left."""
    page.go("lab/broad-phase")
    field = page.tab.locator("[id='item-value:ball.x']")
    field.fill("7.25")
    before = page.standing()["line"]
    page.tab.evaluate(_OTHER_SLIDER)
    page.wait(lambda: page.standing()["line"] != before)
    assert field.input_value() == "7.25"
    page.tab.keyboard.press("Tab")
    page.wait(lambda: "7.25" in page.standing()["line"], page.standing)


def test_the_course_asks_and_sees_a_goal_reached(page):
    """A question is answered; the exercise after it is solved by typed values, and is done after a reload."""
    page.go("lab/polar")
    page.use("course")
    page.use("answer:1")
    assert "Right." in page.tab.inner_text("#menu")
    page.use("next")
    assert "2 of 23" in page.tab.inner_text("#menu")
    for item, value in (("value:ball.x", "7.8"), ("value:ball.y", "0")):
        page.tab.fill(f"[id='item-{item}']", value)
        page.tab.keyboard.press("Tab")
    page.wait(lambda: "Reached!" in page.tab.inner_text("#menu"), lambda: page.tab.inner_text("#menu"))
    page.ask("save")
    page.open()
    page.go("lab/polar")
    page.use("course")
    assert "3 of 23" in page.tab.inner_text("#menu")
