"""Editing a level file: its text changes where it must and nowhere else."""

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.editor import session as editor
from game.editor.document import opened, painted, ring_removed, saved_text, value_at, with_value
from game.editor.file_watch import WatchedFile
from game.editor.symmetry import FOLDS, Symmetry, images
from game.levels import RingSpec
from game.system.errors import BadInputError

TEXT = """# My level
name = "Mine"  # its name
ground_radius = 10.0

[ball]
radius = 0.25
speed = 8.0

[paddles]  # three of them
radius = 9.2
half_width = 0.2
half_angle = 24.0
top_speed = 46.0
acceleration = 600.0

[[rings]]
radius = 3.2  # the only one
half_width = 0.4
half_angle = 13.0
count = 12
layers = 2
"""


def test_one_number_changes_one_line_and_keeps_its_comment():
    changed = with_value(opened(TEXT), ("rings", 0, "radius"), 3.0 + 0.1 + 0.2)
    before, after = TEXT.splitlines(), changed.text.splitlines()
    assert [new for old, new in zip(before, after, strict=True) if old != new] == ["radius = 3.3  # the only one"]
    assert changed.level.rings[0].radius == 3.3


def test_a_painted_slot_turns_the_number_of_layers_into_a_list_and_back():
    gap = painted(opened(TEXT), 0, {3}, 0)
    assert gap.level.rings[0].slots() == (2, 2, 2, 0, 2, 2, 2, 2, 2, 2, 2, 2)
    assert painted(gap, 0, {3}, 2).text == TEXT


def test_a_level_that_cannot_be_played_is_kept_with_its_problem_and_not_saved():
    empty = painted(opened(TEXT), 0, range(12), 0)
    assert "no bricks to break" in empty.problem
    with pytest.raises(BadInputError, match="not saved: rings: no bricks"):
        saved_text(empty)


def test_what_the_format_refuses_leaves_the_document_as_it_was():
    begun = editor.begun(TEXT, TEXT)
    row = next(row for row in editor.rows(begun) if row.name == "half_width")
    refused = editor.entered(begun, row, -1.0)
    assert refused.document == begun.document
    assert "half_width" in refused.message


def test_undo_and_redo_return_the_same_texts():
    begun = editor.begun(TEXT, TEXT)
    copied = editor.with_ring_copied(begun)
    spun = editor.stepped(copied, next(row for row in editor.rows(copied) if row.name == "spin"), 3.0)
    assert not spun.document.problem
    assert spun.document.level.rings[1].spin == 3.0
    assert editor.undone(editor.undone(spun)).document.text == TEXT
    assert editor.redone(editor.redone(editor.undone(editor.undone(spun)))).document == spun.document
    assert not editor.undone(editor.undone(spun)).changed


def test_a_drag_is_undone_as_a_whole():
    """And nothing but the drag, even if it begins where its bricks are already."""
    filled = editor.stroked(editor.begun(TEXT, TEXT), 0, 0, layers=5)
    session = filled
    for slot in range(6):
        session = editor.stroked(session, 0, slot, layers=5, before=filled.history)
    assert session.document.level.rings[0].slots()[:7] == (5, 5, 5, 5, 5, 5, 2)
    assert editor.undone(session).document == filled.document


def test_another_number_of_slots_keeps_the_pattern_and_the_gaps_share():
    text = TEXT.replace("[[rings]]", "[[rings]]\ntint = [0, 8, 3]", 1)
    session = editor.stroked(editor.begun(text, text), 0, 0, layers=0)
    row = next(row for row in editor.rows(session) if row.name == "count")
    doubled = editor.entered(session, row, 24).document
    assert doubled.level.rings[0].slots() == (0, 0, *[2] * 22)
    assert doubled.level.rings[0].tints() == (0, 0, 8, 8, 3, 3) * 4
    assert doubled.level.rings[0].half_angle == 6.5


def test_a_ring_of_as_many_slots_as_there_may_be_can_be_painted_and_copied():
    """The list of its layers takes more than the 1,000 characters that a line may have."""
    session = editor.begun(TEXT, TEXT)
    row = next(row for row in editor.rows(session) if row.name == "count")
    session = editor.with_ring_copied(editor.stroked(editor.entered(session, row, 2000), 0, 5, layers=0))
    assert not session.message
    assert [ring.slots()[4:7] for ring in session.document.level.rings] == [(2, 0, 2)] * 2
    assert editor.begun(session.document.text, "").document.level == session.document.level


def test_the_last_ring_stays():
    with pytest.raises(BadInputError, match="at least one ring"):
        ring_removed(opened(TEXT), 0)


def test_a_value_that_the_file_leaves_out_is_the_formats_default():
    assert value_at(opened(TEXT), ("paddles", "count")) == 3
    assert tomllib.loads(with_value(opened(TEXT), ("paddles", "count"), 4).text)["paddles"]["count"] == 4


@given(st.integers(1, 40), st.integers(0, 39), st.sampled_from(FOLDS), st.booleans(), st.integers(-80, 80))
def test_an_image_of_a_stroke_has_the_same_images(count, slot, fold, mirrored, half_pitches):
    slots = count * fold  # so that no image falls between two slots
    ring = RingSpec(3.0, 0.2, 0.01, slots, phase=90.0 + half_pitches * 180.0 / slots)
    symmetry = Symmetry(fold, mirrored)
    found = images(ring, slot % slots, symmetry)
    assert len(found) in {fold, 2 * fold}
    assert all([images(ring, image, symmetry) == found for image in found])


def test_a_file_changed_elsewhere_is_news_once_and_ones_own_writing_is_none(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(TEXT)
    watched = WatchedFile(path)
    assert watched.read() == TEXT
    assert watched.news() is None
    path.write_text(TEXT + "# more\n")
    assert watched.news() == TEXT + "# more\n"
    assert watched.news() is None
    path.write_text(TEXT)
    watched.written(TEXT)
    assert watched.news() is None
    path.unlink()
    with pytest.raises(BadInputError, match=r"mine\.toml"):
        watched.news()
    assert watched.news() is None
