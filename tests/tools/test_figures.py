"""The documentation's figures are those that the committed script draws, and no others."""

import matplotlib as mpl
import pytest

from game.lab.session.share import parsed
from tools.figures.__main__ import FIGURES, FOLDER
from tools.figures.screenshots import SCREENSHOTS, draw_screenshot

MATHEMATICS = '<path class="mathematics"'
"""How a line begins that another version of matplotlib may set a hundredth of a point to the side."""


def drawn(name, folder):
    """The lines of a figure, drawn anew."""
    path = folder / f"{name}.svg"
    FIGURES[name]().save(path)
    return path.read_bytes().decode().splitlines()


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_is_drawn_again_byte_for_byte(name, tmp_path):
    """By the matplotlib that drew the committed one; by another, all but the outlines of mathematics."""
    committed = (FOLDER / f"{name}.svg").read_bytes().decode().splitlines()
    again = drawn(name, tmp_path)
    if f"matplotlib {mpl.__version__} " not in committed[1]:
        committed, again = (
            [line[: len(MATHEMATICS)] if line.startswith(MATHEMATICS) else line for line in [*lines[:1], *lines[2:]]]
            for lines in (committed, again)
        )
    assert again == committed


def test_every_figure_is_one_that_the_script_draws():
    """Nothing lies in the folder that could not be drawn again, and nothing is missing."""
    named = {f"{name}.svg" for name in FIGURES} | {f"{name}.png" for name in SCREENSHOTS}
    assert {path.name for path in FOLDER.iterdir()} == named


@pytest.mark.parametrize("name", [name for name, arguments in SCREENSHOTS.items() if arguments[0] == "lab"])
def test_every_picture_of_the_lab_shows_a_scene_that_opens(name):
    """Its line names a scene, and numbers within their ranges."""
    scene = SCREENSHOTS[name][1]
    assert parsed(scene).scene.name == scene.partition("?")[0]


def test_a_screenshot_can_be_drawn(tmp_path):
    """Without a window, by the game's own command."""
    path = tmp_path / "case-2.png"
    draw_screenshot("lab-case-2", path)
    assert path.read_bytes().startswith(b"\x89PNG")
