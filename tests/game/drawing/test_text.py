"""Lines of text: where they are wrapped, and their height."""

import pygame
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


@pytest.mark.parametrize("spacing", [0.0, 0.03])
@pytest.mark.parametrize("accented", ["Čas", "sČa", "Úhel"])
def test_accents_on_capitals_do_not_move_a_line(accented, spacing):
    """The letters are at the same height as in a line without accents, measured from the line's middle."""
    plain = accented.replace("Č", "C").replace("Ú", "U")
    lowest = []
    for text in (plain, accented):
        surface = pygame.Surface((120, 60), 0, 32)
        Type().write(surface, text, 23.0, (255, 255, 255), 60 + 30j, "center", spacing)
        rows = pygame.surfarray.array3d(surface).max(axis=(0, 2))
        lowest.append(max([row for row in range(60) if rows[row] > 60]))
    assert lowest[0] == lowest[1]


def test_a_null_character_is_drawn_as_the_replacement_character():
    """A level's name may have one; pygame draws none."""
    type_ = Type()
    for spacing in (0.0, 0.03):
        drawn, replaced = [type_.rendered(text, 20.0, (0, 0, 0), spacing) for text in ("a\0b", "a\N{REPLACEMENT CHARACTER}b")]
        assert drawn.get_size() == replaced.get_size()
    assert type_.wrapped("a\0b", 20.0, 100.0) == ["a\N{REPLACEMENT CHARACTER}b"]
    type_.write(pygame.Surface((60, 40), 0, 32), "\0Č", 20.0, (0, 0, 0), 0j)
