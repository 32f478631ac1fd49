"""The page in a real browser: Chromium of the system, the site served on loopback, one page that most tests share."""

import importlib.util
import os
import shutil
from contextlib import contextmanager

import pytest

from game.input.key_names import use_layout
from game.input.keys import BINDINGS, KEYS
from game.input.scancodes import US_CODES
from game.system.errors import EnvironmentMissingError
from game.web.packages import Package, cache_folder, fetched
from game.web.server import served
from tests.support.paths import GOLDEN
from tests.support.web_page import WebPage

collect_ignore_glob = [] if os.environ.get("BROWSER_TESTS") else ["*_in_browser.py", "test_odd_browsers.py"]
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
AXE = Package(
    "axe-core",
    "4.10.3",
    "axe-core-4.10.3.tgz",
    "0f2b4d7dcdf7d1219df8d1959ad68e565f51d14c3f0d88bb71cd59abeb956292",
    "MPL-2.0",
    "https://github.com/dequelabs/axe-core",
    "npm",
)


@pytest.fixture(autouse=True)
def default_keys():
    """The desktop's keys, and the names of the US layout, after every test of a page."""
    yield
    KEYS.change(BINDINGS)
    use_layout(US_CODES)


@pytest.fixture(scope="session")
def browser():
    """Chromium; skipped with one line where these tests are not asked for, or cannot be run."""
    if CHROMIUM is None or importlib.util.find_spec("playwright") is None:
        pytest.skip("browser tests: no Chromium, or no playwright")
    from playwright.sync_api import sync_playwright  # noqa: PLC0415  # only where it is there

    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture(scope="session")
def site(browser):
    """The site's files, and the golden games beside them."""
    del browser
    from game.web.site import built_site  # noqa: PLC0415  # renders all sounds: only where it is needed

    try:
        files = built_site(cache_folder())
    except EnvironmentMissingError as error:
        pytest.skip(f"browser tests: {error}")
    return files | {f"golden/{file.name}": file.read_bytes() for file in GOLDEN.glob("*.polar")}


@pytest.fixture(scope="session")
def axe():
    """The source of axe-core, as npm has it."""
    import tarfile  # noqa: PLC0415

    try:
        with tarfile.open(fetched(AXE, cache_folder())) as packed:
            return packed.extractfile("package/axe.min.js").read().decode()
    except EnvironmentMissingError as error:
        pytest.skip(f"browser tests: {error}")


@pytest.fixture(scope="session")
def open_page(browser, site):
    """Opens pages in contexts of their own; none may log an error or ask another host."""

    @contextmanager
    def opened(prepare=lambda _page: None, **options):
        options = {"viewport": {"width": 1280, "height": 800}, "service_workers": "block", **options}
        with served(site, 0) as address:
            context = browser.new_context(**options)
            try:
                page = WebPage(context.new_page(), address)
                prepare(page)
                page.open()
                yield page
            finally:
                context.close()
        assert page.problems == []
        assert page.foreign == []

    return opened


@pytest.fixture(scope="session")
def shared_page(open_page):
    """One page for the tests that leave it usable. Its Python has come from the snapshot that a first visit has stored."""
    with open_page() as page:
        assert page.ask("snapshot") is True
        page.open()
        assert "memory copied" in page.timeline()
        yield page


@pytest.fixture
def page(shared_page):
    """The shared page, at its title."""
    shared_page.to_title()
    return shared_page
