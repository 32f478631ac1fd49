"""The page on phones, without storage, without WebAssembly, without a network."""

import pytest

from game.web.server import served
from tests.support.web_page import WebPage

GONE = "Object.defineProperty(self, 'indexedDB', { value: undefined });"


def test_a_phone_plays_by_touch(open_page):
    """The page fits; a tap serves, a finger turns the paddles."""
    phone = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True, "device_scale_factor": 2}
    with open_page(**phone) as page:
        assert page.tab.evaluate("document.documentElement.scrollWidth <= innerWidth")
        page.tab.tap("#item-play")
        page.wait(lambda: page.standing().get("phase") == "SERVING")
        before = page.standing()["paddle"]
        page.tab.touchscreen.tap(195, 300)
        page.wait(lambda: page.standing()["phase"] == "PLAYING")
        page.tab.touchscreen.tap(360, 430)
        page.wait(lambda: page.standing()["paddle"] != before)
        page.tab.tap("#item-pause")
        page.wait(lambda: page.title() == "Paused")
        for button in page.tab.locator("#menu button").all():
            assert button.bounding_box()["height"] >= 44


def test_without_storage_it_plays_on_and_says_so(open_page):
    """IndexedDB is gone from the worker."""
    with open_page(lambda page: page.begin_with("worker.js", GONE)) as page:
        page.wait(lambda: "nothing can be stored" in page.notification(), page.notification)
        page.use("play")
        page.wait(lambda: page.standing().get("phase") == "SERVING")


def test_a_second_tab_stores_nothing_over_the_first(open_page):
    """It has what was stored until it was opened, and says that it adds nothing; what the first stores is there afterwards."""
    with open_page() as page:
        second = WebPage(page.tab.context.new_page(), page.address)
        second.open()
        second.wait(lambda: "another tab" in second.notification(), second.notification)
        page.use("settings")
        page.tab.select_option("#item-colours", "light")
        page.frames(2)
        assert page.ask("save") is True
        second.use("settings")
        second.tab.uncheck("#item-sound")
        second.frames(2)
        assert second.ask("save") is False
        page.open()
        page.use("settings")
        assert page.tab.input_value("#item-colours") == "light"
        assert page.tab.is_checked("#item-sound")
        assert page.ask("save") is True


@pytest.mark.parametrize(
    "missing",
    ["WebAssembly", "DecompressionStream", "OffscreenCanvas", "HTMLCanvasElement.prototype.transferControlToOffscreen"],
)
def test_without_what_it_needs_it_says_so(browser, site, missing):
    """One line, no error."""
    with served(site, 0) as address:
        context = browser.new_context(service_workers="block")
        page = WebPage(context.new_page(), address)
        page.tab.add_init_script(f"delete globalThis.{missing}")
        page.open("document.getElementById('loading').textContent.includes('needs a browser')")
        assert page.problems == []
        context.close()


def test_it_works_offline_after_the_first_visit(browser, site):
    """The service worker has stored all files: the page plays, grades functions in its editor, and calls pymunk."""
    context = browser.new_context()
    try:
        with served(site, 0) as address:
            page = WebPage(context.new_page(), address)
            page.open()
            page.wait(lambda: page.tab.evaluate("navigator.serviceWorker.getRegistration().then((one) => !!one?.active)"))
        page.open()
        page.use("play")
        page.wait(lambda: page.standing().get("phase") == "SERVING")
        page.go("functions")
        page.wait(lambda: page.tab.query_selector(".CodeMirror"))
        page.drop("mine.py", b"def on_left(a, b):\n    return a > b\n")
        page.use("grade")
        page.wait(lambda: "no wrap" in page.tab.inner_text("#menu"), lambda: page.tab.inner_text("#menu"))
        page.go("lab/free-run")
        page.wait(lambda: page.standing().get("engine") == "pymunk", page.notification)
        assert page.foreign == []
    finally:
        context.close()
