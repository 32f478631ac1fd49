"""What the page costs in Chromium: `python -m tools.measure.web`. First frame, download, frames a second, memory.

Needs the extra `web`, Chromium and npm. The first visit is to loopback with empty caches; the second one has them filled by the
service worker. Times count only on an idle machine.
"""

import importlib.util
import itertools
import shutil
import sys
import time

import typer

from game.system.command_line import run
from game.system.errors import EnvironmentMissingError
from game.system.output import tell
from game.system.start import prepare

PROGRAM = "python -m tools.measure.web"
app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)
_PATIENCE = 120.0
"""Seconds that the first frame is waited for."""
_COUNT = """seconds => new Promise(done => {
  const times = [];
  const tick = now => { times.push(now); now - times[0] < 1000 * seconds ? requestAnimationFrame(tick) : done(times); };
  requestAnimationFrame(tick);
})"""
"""The times of the browser's frames for some seconds."""
_SETTLING, _SECONDS = 2.0, 10.0
"""Seconds before frames are counted, and in which they are."""


def main() -> None:
    """Run the command line and exit."""
    prepare(PROGRAM)
    sys.exit(run(app, PROGRAM))


@app.command()
def web(level: int = typer.Option(8, min=1, help="Number of the campaign's level that is played by the program.")) -> int:
    """Open the page in Chromium and measure it. Exit code 3 where the extra `web`, Chromium or npm is missing."""
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if chromium is None or importlib.util.find_spec("playwright") is None:
        raise EnvironmentMissingError("Chromium and the extra `web` are needed")
    from playwright.sync_api import Page, sync_playwright  # noqa: PLC0415  # only where they are there

    from game.web.packages import cache_folder  # noqa: PLC0415  # numpy and the sounds, only now
    from game.web.server import served  # noqa: PLC0415
    from game.web.site import built_site  # noqa: PLC0415

    def visit(page: Page, address: str) -> float:
        """Milliseconds to the first frame."""
        page.goto(address)
        until = time.monotonic() + _PATIENCE
        while not page.evaluate("polarBreakout.firstFrame"):
            if time.monotonic() > until:
                raise EnvironmentMissingError(f"no frame in {_PATIENCE:.0f} s: {page.inner_text('#loading')}")
            page.wait_for_timeout(20)
        return float(page.evaluate("polarBreakout.firstFrame"))

    def rate(page: Page) -> str:
        """Pictures a second, and how late the slowest hundredth of the browser's frames was."""
        page.wait_for_timeout(1000.0 * _SETTLING)
        before = page.evaluate("polarBreakout.frames")
        times = page.evaluate(_COUNT, _SECONDS)
        pictures = page.evaluate("polarBreakout.frames") - before
        gaps = sorted([later - sooner for sooner, later in itertools.pairwise(times)])
        return f"{pictures / _SECONDS:.1f} pictures a second, 99 % of frames within {gaps[int(0.99 * len(gaps))]:.1f} ms"

    site = built_site(cache_folder())
    tell(f"download: {sum(map(len, site.values())) / 1e6:.2f} MB in {len(site)} files")
    with served(site, 0) as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_context(viewport={"width": 1280, "height": 800}).new_page()
        tell(f"first frame: {visit(page, address):.0f} ms")
        page.wait_for_timeout(5000.0)  # the service worker stores the files
        tell(f"first frame, second visit: {visit(page, address):.0f} ms")
        page.evaluate(f"location.hash = '#level/{level}'")
        page.wait_for_timeout(500.0)
        page.keyboard.press("Escape")
        for item in ("autopilot", "go-on"):
            page.click(f"#item-{item}")
        tell(f"from above: {rate(page)}")
        page.keyboard.press("2")
        tell(f"in 3D: {rate(page)}")
        tell(f"Python's memory: {page.evaluate('polarBreakout.ask(`memory`)') / 1e6:.1f} MB")
        browser.close()
    return 0


if __name__ == "__main__":
    main()
