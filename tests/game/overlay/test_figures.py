"""The figures in the corners."""

import pytest

from game.drawing.camera import layout, unit_of
from game.drawing.letter_sizes import width
from game.drawing.palette import DARK
from game.input.view import FLAT, SOLID
from game.language import CODES, choose
from game.levels import chosen
from game.overlay.readings import Readings
from game.picture.display_list import DisplayList
from game.picture.figures import Corners, add_figures
from game.picture.primitives import Primitive, primitives

RADIUS = chosen("5")[0].ground_radius


@pytest.mark.parametrize("view", [FLAT, SOLID])
@pytest.mark.parametrize("language", CODES)
def test_the_combo_overlaps_neither_the_score_nor_its_caption(language, view):
    """Beside a score of two digits the caption may be the longer one of both, as in German."""
    choose(language)
    for size in ((1280, 800), (800, 600), (1600, 700), (500, 300)):
        out = DisplayList()
        add_figures(out, Readings(90, 2, 3, 5, 32, "Name", 118), Corners(view.seen(layout(size, RADIUS)), DARK, unit_of(size)))
        texts = [numbers for code, _, _, numbers in primitives(out.numbers) if code == Primitive.TEXT]
        (caption, score, combo) = [(x, x + height * width(out.texts[int(n)]), y, height) for n, height, x, y, *_ in texts[:3]]
        for left, right, middle, height in (caption, score):
            below = combo[2] - middle > 0.45 * (height + combo[3])
            assert below or right < combo[0], (size, left, right, combo)
    choose("en")
