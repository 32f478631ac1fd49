"""The pages of the documentation: their links lead somewhere, and what they repeat is what the program says."""

import re
import subprocess
import sys

import pytest

import game
import physics
from game.levels import BallSpec, DropSpec, Level, LookSpec, PaddleSpec, RingSpec, WellSpec
from tests.support.paths import ROOT

PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])
LINK = re.compile(r"\]\(([^)\s]+)\)")
"""Where a link or a picture leads."""

ALGORITHM = (ROOT / "docs" / "algorithm.md").read_text(encoding="utf-8")
STAGE = re.compile(r"^\*File: \[physics/(\w+\.py)\]", re.MULTILINE)
STAGE_WITH_NAMES = re.compile(r"^\*File: \[physics/(\w+\.py)\]\S*((?:.|\n(?!\n))*)", re.MULTILINE)
NAME = re.compile(r"`(\w+)`")


def headings(page):
    """The anchors of a page's headings, as GitHub and mkdocs name them."""
    titles = re.findall(r"^#+ (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_link_leads_somewhere(page):
    """To a file of the checkout, and where it names a heading, to one that the file has."""
    broken = []
    for link in LINK.findall(page.read_text(encoding="utf-8")):
        if "://" in link:
            continue
        name, _, anchor = link.replace("\\", "").partition("#")
        target = page.parent / name if name else page
        if not target.is_file() or (anchor and anchor not in headings(target)):
            broken.append(link)
    assert broken == []


@pytest.mark.parametrize("module", sorted(set(STAGE.findall(ALGORITHM))))
def test_a_stage_names_functions_of_its_file(module):
    """A function that was renamed, or moved, is renamed on the page that explains it."""
    named = [name for found, names in STAGE_WITH_NAMES.findall(ALGORITHM) if found == module for name in NAME.findall(names)]
    text = (ROOT / "physics" / module).read_text(encoding="utf-8")
    assert [name for name in named if f"def {name}(" not in text] == []


def test_the_pages_are_found():
    """The README, how to contribute, and everything in docs/."""
    assert {"README.md", "CONTRIBUTING.md", "algorithm.md", "architecture.md"} <= {page.name for page in PAGES}


def test_every_figure_is_shown_on_a_page():
    """A figure that nobody sees is not drawn."""
    shown = {link.rpartition("/")[2] for page in PAGES for link in LINK.findall(page.read_text(encoding="utf-8"))}
    assert {path.name for path in (ROOT / "docs" / "figures").iterdir()} <= shown


def test_every_public_name_of_the_physics_is_described():
    """On the page made of its docstrings; mkdocs refuses a name that the physics does not have."""
    page = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    described = {path.rpartition(".")[2] for path in re.findall(r"^::: (\S+)$", page, re.MULTILINE)}
    assert set(physics.__all__) <= described


def test_every_page_of_the_documentation_is_in_the_sites_contents():
    """A page that nothing leads to is not found."""
    contents = (ROOT / "mkdocs.yml").read_text(encoding="utf-8").partition("\nnav:")[2].partition("\ntheme:")[0]
    assert {page.name for page in (ROOT / "docs").glob("*.md")} <= set(re.findall(r": (\S+\.md)$", contents, re.MULTILINE))


def test_the_readme_starts_with_the_two_commands():
    """The first plays, the second tests; the build runs the second, word for word."""
    first, second = re.findall(
        r"^```sh\n(.*?)^```$", (ROOT / "README.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )[:2]
    install = "python3 -m venv .venv && .venv/bin/python -m pip install --quiet --editable"
    assert first == f"{install} . && .venv/bin/python -m game\n"
    assert second == f"{install} '.[test]' && .venv/bin/python -m pytest -n auto\n"


def test_the_example_of_the_readme_runs():
    """As it stands, in a Python of its own."""
    (example,) = re.findall(
        r"^```python\n(.*?)^```$", (ROOT / "README.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )
    finished = subprocess.run([sys.executable, "-c", example], cwd=ROOT, capture_output=True, text=True, check=True)
    time, slot, *_ = finished.stdout.split()
    assert 0.0 < float(time) < 1.0
    assert slot.isdigit()


@pytest.mark.parametrize("name", ["README.md", "docs/algorithm.md", "CITATION.cff"])
def test_the_source_is_named(name):
    """Its author, its course, its university and its title."""
    text = " ".join((ROOT / name).read_text(encoding="utf-8").split())
    assert all(part in text for part in ("Marek", "Trtík", "PA199", "Masaryk University"))
    assert "Collision detection and response in the assignment" in text


def test_the_citation_names_this_version():
    """The one that the program prints."""
    cited = re.search(r"^version: (.+)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    assert cited
    assert cited.group(1) == game.VERSION


@pytest.mark.parametrize("table", [Level, BallSpec, PaddleSpec, RingSpec, WellSpec, DropSpec, LookSpec])
def test_the_page_of_levels_names_every_key(table):
    """A key that a level's file may have has its row, or its part of one."""
    rows = [line for line in (ROOT / "docs" / "levels.md").read_text(encoding="utf-8").splitlines() if line.startswith("| `")]
    named = {name for row in rows for name in re.findall(r"[a-z_]+", row.split("|")[1])}
    assert set(table.__struct_fields__) <= named
