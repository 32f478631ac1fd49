"""Editing a level file: its text changes where it must and nowhere else."""

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.editor import session as editor
from game.editor.changes import described, redo_words, undo_words
from game.editor.command import NEW
from game.editor.document import Stack, opened, painted, ring_removed, saved_text, stacks, value_at, with_value, with_values
from game.editor.fields import NAME, PART_FIELDS, RING_FIELDS, TABLES, field_at
from game.editor.file_watch import WatchedFile
from game.editor.symmetry import FOLDS, Symmetry, images
from game.editor.wells import with_well_added, with_well_at, with_well_removed
from game.language import ENGLISH, choose
from game.levels import RingSpec, campaign
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


def ring_field(key):
    """A key of a ring as the editor shows it."""
    return next(field for field in RING_FIELDS if field.key == key)


def test_every_key_of_the_format_is_shown_and_can_be_changed_and_undone():
    """Every key by which a level of the campaign differs from a new one can be set in the editor, and undone."""
    shown = {(field.table, field.key) for fields in PART_FIELDS.values() for field in fields}
    assert shown == {
        (name, key) for name, table in TABLES.items() for key in table.__struct_fields__ if name or key not in TABLES
    }
    session = editor.begun(NEW, NEW)
    for field in [field_at(("ball", key)) for key in ("growth", "top_speed")] + list(RING_FIELDS[:9]):
        changed = editor.stepped(session, field, 1.0)
        assert editor.value_of(changed, field) != editor.value_of(session, field)
        assert editor.undone(changed).document == session.document


def test_a_level_of_the_campaign_is_made_from_a_new_one():
    """The panel's commands suffice: rings, strokes of layers and colours, wells, values."""
    wanted = min([level for level in campaign() if level.wells], key=lambda level: sum([ring.count for ring in level.rings]))
    session = editor.begun(NEW, NEW)
    while len(session.document.level.rings) < len(wanted.rings):
        session = editor.with_ring_copied(session)
    for index, ring in enumerate(wanted.rings):
        session = editor.entered(editor.with_ring(session, index), ring_field("count"), float(ring.count))
        for field in RING_FIELDS:
            value = getattr(ring, field.key)
            if value != editor.value_of(session, field):
                session = editor.entered(session, field, value)
        for stack in set(stacks(ring)):
            slots = [slot for slot, other in enumerate(stacks(ring)) if other == stack]
            session = editor.after(session, painted(session.document, index, slots, stack))
    for _ in wanted.wells:
        session = with_well_added(session)
    for fields in list(PART_FIELDS.values())[2:]:
        for field in fields:
            for index in range(len(wanted.wells) if field.table == "wells" else 1):
                session = session._replace(well=index)
                table = wanted.wells[index] if field.table == "wells" else getattr(wanted, field.table, wanted)
                session = editor.entered(session, field, getattr(table, field.key))
                assert not session.message
    assert saved_text(session.document)
    assert session.document.level.content_hash() == wanted.content_hash()


def test_undo_says_what_it_takes_back():
    """Strokes are described by their bricks, a number by its values, a changed file by the number of differences."""
    begun = editor.begun(TEXT, TEXT)
    spin = ring_field("spin")
    said = []
    for session in (
        editor.stroked(begun, 0, 1),
        editor.stroked(begun, 0, 1, stack=Stack(0)),
        editor.stroked(begun, 0, 1, stack=Stack(None, 3)),
        editor.stepped(editor.stepped(begun, spin, 1.0), spin, 1.0),
        editor.entered(begun, ring_field("count"), 6.0),
        editor.entered(begun, NAME, "Other"),
        editor.with_ring_copied(begun),
        with_well_added(begun),
        with_well_at(with_well_added(begun), 2 + 2j),
        with_well_removed(with_well_added(begun)),
        editor.reloaded(begun, TEXT.replace("radius = 3.2", "radius = 3.3").replace("speed = 8.0", "speed = 7.0")),
        editor.reloaded(begun, TEXT + "# a note"),
    ):
        said.append(undo_words(session.history))
        assert redo_words(editor.undone(session).history) == said[-1]
    assert said == [
        "paint 1 brick",
        "take 1 brick away",
        "colour 1 brick",
        "Spin: 0 to 2",
        "Slots: 12 to 6",
        "Name: Mine to Other",
        "add ring",
        "add well",
        "move well",
        "remove well",
        "2 changes",
        "notes in the file",
    ]
    assert described(campaign()[0], campaign()[-1]).endswith(" changes")


def test_steps_of_one_number_are_undone_as_a_whole():
    """Steps back to the first value leave nothing to undo; a step of another number begins a new change."""
    begun, spin, phase = editor.begun(TEXT, TEXT), ring_field("spin"), ring_field("phase")
    spun = editor.stepped(editor.stepped(begun, spin, 1.0), spin, 1.0)
    assert editor.undone(spun).document == begun.document
    assert editor.stepped(spun, spin, -2.0).history.past == ()
    other = editor.stepped(editor.stepped(spun, phase, 1.0), spin, 1.0)
    assert editor.undone(editor.undone(other)).document == spun.document


def test_new_tables_stand_apart_and_the_rest_of_the_file_stays():
    """Wells, drops and a look are added to a file without them; removed again, the text is the same as before."""
    more = with_values(opened(TEXT), {("look", "palette"): "gold", ("chapter",): "Mine", ("rings", 0, "tint"): [0, 1]})
    more = with_well_at(with_well_added(editor.EditorSession(editor.EditHistory(more), "")), 3j).document
    assert more.text.startswith(TEXT.partition("\n\n")[0] + '\nchapter = "Mine"\n\n')
    assert '\ntint = [0, 1]\n\n[look]\npalette = "gold"\n\n[[wells]]\ndistance = 3.0\n' in more.text
    again = with_values(more, {("look", "palette"): None, ("chapter",): None, ("rings", 0, "tint"): None})
    assert again.text.partition("\n[look]")[0] == TEXT


def test_one_number_changes_one_line_and_keeps_its_comment():
    changed = with_value(opened(TEXT), ("rings", 0, "radius"), 3.0 + 0.1 + 0.2)
    before, after = TEXT.splitlines(), changed.text.splitlines()
    assert [new for old, new in zip(before, after, strict=True) if old != new] == ["radius = 3.3  # the only one"]
    assert changed.level.rings[0].radius == 3.3


def test_a_painted_slot_turns_the_number_of_layers_into_a_list_and_back():
    gap = painted(opened(TEXT), 0, {3}, Stack(0))
    assert gap.level.rings[0].slots() == (2, 2, 2, 0, 2, 2, 2, 2, 2, 2, 2, 2)
    assert painted(gap, 0, {3}, Stack(2)).text == TEXT


def test_a_level_that_cannot_be_played_is_kept_with_its_problem_and_not_saved():
    empty = painted(opened(TEXT), 0, range(12), Stack(0))
    assert str(empty.problem) == "rings: no bricks to break"
    with pytest.raises(BadInputError, match="not saved: rings: no bricks"):
        saved_text(empty)


def test_the_player_reads_rules_in_the_language_of_the_game():
    """The values stand in the translation as in the English text, and the key is that of the file."""
    document = with_value(opened(TEXT), ("paddles", "half_angle"), 90.0)
    begun = editor.begun(TEXT, TEXT)
    choose("de")
    try:
        assert document.problem.translated == "paddles.half_angle: 3 Schläger müssen Lücken lassen: unter 60 Grad"
        refused = editor.entered(begun, ring_field("count"), 0.0)
        assert refused.message == "rings[0].count: 0 liegt nicht zwischen 1 und 2000"
    finally:
        choose(ENGLISH.code)
    assert str(document.problem) == "paddles.half_angle: 3 paddles must leave gaps: below 60 degrees"


def test_what_the_format_refuses_leaves_the_document_as_it_was():
    begun = editor.begun(TEXT, TEXT)
    refused = editor.entered(begun, ring_field("half_width"), -1.0)
    assert refused.document == begun.document
    assert "half_width" in refused.message


def test_undo_and_redo_return_the_same_texts():
    begun = editor.begun(TEXT, TEXT)
    copied = editor.with_ring_copied(begun)
    spun = editor.stepped(copied, ring_field("spin"), 3.0)
    assert not spun.document.problem
    assert spun.document.level.rings[1].spin == 3.0
    assert editor.undone(editor.undone(spun)).document.text == TEXT
    assert editor.redone(editor.redone(editor.undone(editor.undone(spun)))).document == spun.document
    assert not editor.undone(editor.undone(spun)).changed


def test_a_drag_is_undone_as_a_whole():
    """And nothing but the drag, even if it begins where its bricks are already."""
    filled = editor.stroked(editor.begun(TEXT, TEXT), 0, 0, stack=Stack(5))
    session = filled
    for slot in range(6):
        session = editor.stroked(session, 0, slot, stack=Stack(5), before=filled.history)
    assert session.document.level.rings[0].slots()[:7] == (5, 5, 5, 5, 5, 5, 2)
    assert editor.undone(session).document == filled.document


def test_another_number_of_slots_keeps_the_pattern_and_the_gaps_share():
    text = TEXT.replace("[[rings]]", "[[rings]]\ntint = [0, 8, 3]", 1)
    session = editor.stroked(editor.begun(text, text), 0, 0, stack=Stack(0))
    doubled = editor.entered(session, ring_field("count"), 24.0).document
    assert doubled.level.rings[0].slots() == (0, 0, *[2] * 22)
    assert doubled.level.rings[0].tints() == (0, 0, 8, 8, 3, 3) * 4
    assert doubled.level.rings[0].half_angle == 6.5


def test_a_ring_of_as_many_slots_as_there_may_be_can_be_painted_and_copied():
    """The list of its layers takes more than the 1,000 characters that a line may have."""
    session = editor.begun(TEXT, TEXT)
    session = editor.entered(session, ring_field("count"), 2000.0)
    session = editor.with_ring_copied(editor.stroked(session, 0, 5, stack=Stack(0)))
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
