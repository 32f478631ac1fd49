"""What the page costs in Chromium: `python -m tools.measure.web`. Start, download, frames, input, memory.

Needs the extra `web`, Chromium and npm. The first visit is to loopback with empty caches; before the second one the page has
stored its files and Python's memory. Times count only on an idle machine.
"""

import bisect
import importlib.util
import itertools
import json
import random
import shutil
import statistics
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from game.system.command_line import run
from game.system.errors import EnvironmentMissingError
from game.system.output import print_line
from game.system.start import prepare

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PROGRAM = "python -m tools.measure.web"
app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)
_PATIENCE = 120.0
"""Seconds that the first frame is waited for."""
_SETTLING, _SECONDS = 2.0, 10.0
"""Seconds before frames are counted, and in which they are."""
_WATCH = """(() => {
  const seen = window.measured = { on: false, frames: [], painted: [], pictures: [] }, requests = [], workers = new Set();
  const next = window.requestAnimationFrame, post = Worker.prototype.postMessage;
  let key = null;
  window.requestAnimationFrame = callback => next(moment => {
    if (seen.on) seen.frames.push(performance.timeOrigin + moment);
    callback(moment);
  });
  addEventListener("keydown", event => { if (seen.on) key ??= performance.timeOrigin + event.timeStamp; }, true);
  Worker.prototype.postMessage = function (message, ...rest) {
    if (!workers.has(this)) {
      workers.add(this);
      this.addEventListener("message", ({ data }) => {
        if (data.kind !== "painted") return;
        if (seen.on) seen.painted.push(data.time);
        const pressed = requests.shift();
        if (pressed) seen.pictures.push([pressed, data.time]);
      });
    }
    if (message.kind === "frame") {
      const holds = message.request.signals.some(signal => signal.type === "key" && signal.down);
      requests.push(holds ? key : null);
      if (holds) key = null;
    }
    return post.call(this, message, ...rest);
  };
})()"""
"""Notes when the browser's frames begin, when pictures are painted, and which picture was the first that heeds a key.

Pictures are painted in the order of their requests. Times are in milliseconds.
"""
_START = "Object.assign(measured, { on: true, frames: [], painted: [], pictures: [] })"
_STOP = "Object.assign(measured, { on: false })"
_PRESSES, _PRESS_SECONDS = 400, (0.08, 0.14)
"""How many keys are pressed, and the shortest and the longest time between two of them: they come at any time of a frame."""
_VIEWS = (("1", "from above"), ("2", "in 3D"))
"""The views, each after its key."""
_LOOK_SECONDS, _MINUTE = 5.0, 60.0
"""How often a game that has ended is looked for, to begin another one."""


def main() -> None:
    """Run the command line and exit."""
    prepare(PROGRAM)
    sys.exit(run(app, PROGRAM))


@app.command()
def web(
    level: int = typer.Option(8, min=1, help="Number of the campaign's level that is played by the program."),
    visits: int = typer.Option(3, min=1, help="How often the page is opened with nothing stored, and then again."),
    minutes: float = typer.Option(1.0, min=0.0, help="How long the program plays before memory is measured."),
    recording: Annotated[
        Path | None,
        typer.Option(exists=True, dir_okay=False, help="Replay to watch, too; there the program plans nothing."),
    ] = None,
) -> int:
    """Open the page in Chromium and measure it. Exit code 3 where the extra `web`, Chromium or npm is missing."""
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if chromium is None or importlib.util.find_spec("playwright") is None:
        raise EnvironmentMissingError("Chromium and the extra `web` are needed")
    from playwright.sync_api import sync_playwright  # noqa: PLC0415  # only where it is there

    from game.web.packages import cache_folder  # noqa: PLC0415  # numpy and the sounds, only now
    from game.web.server import served  # noqa: PLC0415
    from game.web.site import built_site  # noqa: PLC0415

    site = built_site(cache_folder())
    print_line(f"download: {sum(map(len, site.values())) / 1e6:.2f} MB in {len(site)} files")
    for name, data in sorted(site.items(), key=lambda file: -len(file[1]))[:5]:
        print_line(f"  {len(data) / 1e6:.2f} MB {name}")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for _ in range(visits - 1):
            with served(site, 0) as address:
                _two_visits(browser, address).context.close()
        with served(site, 0) as address:
            page = _two_visits(browser, address)
            _play(page, level)
            for key, view in _VIEWS:
                page.keyboard.press(key)
                print_line(f"{view}: {_rate(page)}")
                print_line(f"{view}, from a key to its picture: {_input_delay(page)}")
            for more in (min(1.0, minutes), max(minutes - 1.0, 0.0)):
                _play_on(page, more)
                print_line(f"memory after {more:g} more minutes: {_memory(browser, page)}")
            if recording is not None:
                page.evaluate(f"polarBreakout.give(new File([new Uint8Array({[*recording.read_bytes()]})], 'watched.polar'))")
                for key, view in _VIEWS:
                    page.keyboard.press(key)
                    print_line(f"{recording.name} is watched, {view}: {_rate(page)}")
        browser.close()
    return 0


def _two_visits(browser: "Browser", address: str) -> "Page":
    """Visit the page with nothing stored, wait until it has stored what it does, and visit it again."""
    page = browser.new_context(viewport={"width": 1280, "height": 800}).new_page()
    page.add_init_script(_WATCH)
    print_line(f"first frame: {_visit(page, address)}")
    page.evaluate("polarBreakout.ask('snapshot')")
    page.evaluate("navigator.serviceWorker.ready.then(() => true)")
    print_line(f"first frame, second visit: {_visit(page, address)}")
    return page


def _visit(page: "Page", address: str) -> str:
    """Milliseconds from opening the page to its first frame, and of what came before."""
    page.goto(address)
    until = time.monotonic() + _PATIENCE
    while not page.evaluate("polarBreakout.firstFrame"):
        if time.monotonic() > until:
            raise EnvironmentMissingError(f"no frame in {_PATIENCE:.0f} s: {page.inner_text('#loading')}")
        page.wait_for_timeout(20)
    opened = page.evaluate("performance.timeOrigin")
    steps = ", ".join([f"{name} {moment - opened:.0f}" for name, moment in page.evaluate("polarBreakout.ask('timeline')")])
    return f"{page.evaluate('polarBreakout.firstFrame'):.0f} ms ({steps})"


def _play(page: "Page", level: int) -> None:
    """Let the program play from a level on."""
    page.evaluate(f"location.hash = '#level/{level}'")
    page.wait_for_timeout(500.0)
    _let_play(page)


def _let_play(page: "Page") -> None:
    """Let the program play the game that has been opened."""
    page.keyboard.press("Escape")
    for item in ("autopilot", "go-on"):
        page.click(f"#item-{item}")


def _rate(page: "Page") -> str:
    """How many of the browser's frames a second show a new picture, and how far apart they are."""
    page.wait_for_timeout(1000.0 * _SETTLING)
    page.evaluate(_START)
    page.wait_for_timeout(1000.0 * _SECONDS)
    seen = page.evaluate(_STOP)
    shown = new_pictures(seen["painted"], seen["frames"])
    gaps = sorted([later - sooner for sooner, later in itertools.pairwise(shown)])
    rate = 1000.0 * len(gaps) / (shown[-1] - shown[0])
    return (
        f"{rate:.1f} pictures a second, 99 % within {gaps[int(0.99 * len(gaps))]:.1f} ms of the one before,"
        f" all within {gaps[-1]:.1f} ms"
    )


def new_pictures(painted: list[float], frames: list[float]) -> list[float]:
    """The frames of the browser that show another picture than the frame before. Both lists are of times, in order."""
    return [
        frame
        for before, frame in itertools.pairwise(frames)
        if bisect.bisect_right(painted, before) < bisect.bisect_right(painted, frame)
    ]


def _input_delay(page: "Page") -> str:
    """Frames of the browser, and milliseconds, from keys to the pictures that heed them."""
    chance = random.Random(1)
    page.evaluate(_START)
    for _ in range(_PRESSES):
        page.keyboard.press("ArrowLeft")
        page.wait_for_timeout(1000.0 * chance.uniform(*_PRESS_SECONDS))
    seen = page.evaluate(_STOP)
    frames = sorted([shown_by(pressed, painted, seen["frames"]) for pressed, painted in seen["pictures"]])
    delays = sorted([painted - pressed for pressed, painted in seen["pictures"]])
    shares = ", ".join([f"{sum(count <= most for count in frames) / len(frames):.2%} within {most}" for most in (1, 2)])
    return (
        f"{shares} frames of {len(frames)} keys, at most {frames[-1]}; painted after {statistics.median(delays):.1f} ms,"
        f" 99 % within {delays[int(0.99 * len(delays))]:.1f} ms, all within {delays[-1]:.1f} ms"
    )


def shown_by(pressed: float, painted: float, frames: list[float]) -> int:
    """The number of the frame that shows a picture: 1 is the first frame of the browser that begins after the key's event.

    A picture is shown by the first frame that begins after it was painted. frames: when they began, in order. All in ms.
    """
    return bisect.bisect_right(frames, painted) - bisect.bisect_right(frames, pressed) + 1


def _play_on(page: "Page", minutes: float) -> None:
    """Let the program play for some time, and begin again whenever its game has ended."""
    until = time.monotonic() + _MINUTE * minutes
    while time.monotonic() < until:
        page.wait_for_timeout(1000.0 * _LOOK_SECONDS)
        if page.query_selector("#item-again"):
            page.click("#item-again")
            _let_play(page)


def _memory(browser: "Browser", page: "Page") -> str:
    """Python's memory, the page's own JavaScript, and what the whole process of the tab has for itself."""
    python = page.evaluate("polarBreakout.ask('memory')")
    script = page.evaluate("performance.memory.usedJSHeapSize")
    state = json.loads(page.evaluate("polarBreakout.ask('probe')"))
    session = browser.new_browser_cdp_session()
    processes = session.send("SystemInfo.getProcessInfo")["processInfo"]
    busiest = max([process for process in processes if process["type"] == "renderer"], key=lambda process: process["cpuTime"])
    return (
        f"Python's memory {python / 1e6:.1f} MB, JavaScript of the page {script / 1e6:.1f} MB, process of the tab"
        f" {_own_bytes(busiest['id']) / 1e6:.0f} MB; {state.get('level', 'no game')}"
    )


def _own_bytes(process: int) -> int:
    """Bytes of memory that a process has for itself alone; 0 where the system does not tell."""
    try:
        lines = Path(f"/proc/{process}/smaps_rollup").read_text(encoding="ascii").splitlines()
    except OSError:
        return 0
    return sum(1024 * int(line.split()[1]) for line in lines if line.startswith("Private_"))


if __name__ == "__main__":
    main()
