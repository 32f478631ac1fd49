"""Lines of text: where they are broken."""

import pytest

from game.drawing.text import Type

TEXT = "The ball's bearing lies within the sector, so an arc is nearest: n = ±p/|p|, and AV, To, φ_p are kerned or not."


@pytest.mark.parametrize("size", [6.0, 14.4, 31.0])
@pytest.mark.parametrize("width", [40.0, 173.0, 600.0])
def test_a_line_holds_the_words_that_fit(size, width):
    """As drawn, no line of several words is wider than it may be, and none has room for the next word."""
    type_ = Type()
    lines = type_.wrapped(TEXT, size, width)
    assert " ".join(lines) == TEXT
    for line, following in zip(lines, [*lines[1:], ""], strict=True):
        drawn = [type_.rendered(text, size, (0, 0, 0)).get_width() for text in (line, f"{line} {following.split(' ')[0]}")]
        assert drawn[0] <= width or " " not in line
        assert drawn[1] > width or not following
