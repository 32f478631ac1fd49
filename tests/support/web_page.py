"""A page of the game in a browser, as the tests drive it."""

import json
import time

_PATIENCE = 60.0
"""Seconds until something has to have happened, on a busy machine."""

PAD = """
  const buttons = Array.from({ length: 17 }, () => ({ value: 0 }));
  window.pad = { connected: true, mapping: 'standard', axes: [0, 0, 0, 0], buttons };
  navigator.getGamepads = () => [null, window.pad];
"""
"""Plugs a gamepad in, whose state is `pad`."""


class WebPage:
    """One tab. problems: what it logged as errors. foreign: addresses of other hosts that it asked."""

    def __init__(self, tab, address):
        """tab: Playwright's; address: of the site."""
        self.tab, self.address = tab, address
        self.problems, self.foreign = [], []
        tab.on("console", self._logged)
        tab.on("pageerror", lambda error: self.problems.append(str(error)))
        tab.on("request", self._asked)

    def open(self, until="window.polarBreakout.firstFrame > 0"):
        """Load the page and wait for its first frame."""
        self.tab.goto(self.address)
        self.wait(lambda: self.tab.evaluate(until), lambda: self.tab.inner_text("body"))

    def wait(self, reached, told=lambda: ""):
        """Wait until something holds; AssertionError with some words where it does not."""
        until = time.monotonic() + _PATIENCE
        while not (found := reached()):
            assert time.monotonic() < until, told()
            self.tab.wait_for_timeout(50)
        return found

    def ask(self, what, argument="undefined"):
        """What the game's Python answers. argument: an expression of JavaScript."""
        return self.tab.evaluate(f"(async () => polarBreakout.ask({what!r}, {argument}))()")

    def timeline(self):
        """The names of the steps in which Python has started."""
        return [name for name, _moment in self.ask("timeline")]

    def standing(self):
        """How the game or the lab's scene stands."""
        return json.loads(self.ask("probe"))

    def go(self, fragment):
        """Open what a fragment names, and wait until it has been heard."""
        self.tab.evaluate(f"history.replaceState(null, '', '#'); location.hash = {'#' + fragment!r}")
        self.frames(3)

    def frames(self, count):
        """Wait for some frames."""
        before = self.tab.evaluate("polarBreakout.frames")
        self.wait(lambda: self.tab.evaluate("polarBreakout.frames") >= before + count)

    def use(self, item):
        """Click a control."""
        self.wait(lambda: self.tab.query_selector(f"[id='item-{item}']"), lambda: self.tab.inner_text("body"))
        self.tab.click(f"[id='item-{item}']")
        self.frames(2)

    def begin_with(self, script, text):
        """Serve one of the page's scripts with some text before it. script: the end of its address."""

        def answered(route):
            answer = route.fetch()
            route.fulfill(response=answer, body=f"{text}\n{answer.text()}")

        self.tab.route(f"**/{script}", answered)

    def title(self):
        """The heading of the menu that is open; "" for none."""
        # One question: between two, the menu may be closed.
        return self.tab.evaluate(
            "(() => { const h = document.getElementById('menu-title'); return h?.checkVisibility() ? h.innerText : '' })()"
        )

    def to_title(self):
        """Leave whatever is open."""
        if self.title() == "Polar Breakout":
            return
        if self.tab.query_selector("#item-close"):
            self.use("close")
        self.tab.locator("#picture").focus()
        if not self.title():
            self.tab.keyboard.press("p")
            self.wait(self.title)
        while self.title() != "Polar Breakout":
            self.use("title" if self.tab.query_selector("#item-title") else "back")
        self.wait(lambda: self.title() == "Polar Breakout", self.title)

    def drop(self, name, data):
        """Give the page a file, as if it was dropped there."""
        letters = list(data)
        self.tab.evaluate(f"polarBreakout.give(new File([new Uint8Array({letters})], {name!r}))")
        self.frames(3)

    def notification(self):
        """The line that is shown for a moment; "" for none."""
        return self.tab.inner_text("#notification") if self.tab.is_visible("#notification") else ""

    def _logged(self, message):
        """Note an error."""
        if message.type == "error":
            self.problems.append(message.text)

    def _asked(self, request):
        """Note an address of another host."""
        if not request.url.startswith((self.address, "data:", "blob:")):
            self.foreign.append(request.url)
