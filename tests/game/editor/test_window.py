"""The editor's window: errors are marked, everything fits, and nothing is lost when it is closed."""

import pygame
import pytest

from game.editor.command import NEW, editing_session, file_to_edit, keep_unsaved
from game.editor.fields import PanelPart
from game.editor.file_watch import WatchedFile
from game.editor.window.layout import editor_layout
from game.editor.window.play_test import PlayTest
from game.editor.window.screen import Editor
from game.input.keys import Action
from game.input.signals import Pressed
from game.levels import classic, load_file
from game.screens.app_state import AppState
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from game.system.errors import BadInputError

SIZE = (1280, 800)


@pytest.fixture
def editor(tmp_path):
    """The editor on a new file."""
    pygame.font.init()
    file = WatchedFile(tmp_path / "mine.toml")
    return Editor(AppState(classic(), 0, 0, Title), editing_session(file), file)


def key(editor, code, text="", mod=0):
    """The screen after a key."""
    return editor.hear(pygame.Event(pygame.KEYDOWN, key=code, unicode=text, mod=mod), SIZE, 1 + 1j)


def click(editor, point, button=1):
    """The screen after a click."""
    screen = editor.hear(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=point, button=button), SIZE, 1 + 1j)
    editor.hear(pygame.Event(pygame.MOUSEBUTTONUP, pos=point, button=button), SIZE, 1 + 1j)
    return screen


def press(editor, label):
    """The screen after a click on a button."""
    items = editor.side(SIZE)._form_layout(SIZE).items
    return click(editor, next(positioned.box.center for positioned in items if getattr(positioned.item, "label", "") == label))


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("half_angle = 13.0", "half_angle = 170.0"),  # more than the physics takes
        ("radius = 9.2", "radius = 12.0"),
        ("radius = 4.0", "radius = 14.0"),
    ],
)
def test_a_file_that_cannot_be_played_is_opened_and_drawn(tmp_path, before, after):
    """Bricks that overlap, paddles beyond the rim, a ring beyond it: the problem is shown, and can be mended."""
    assert before in NEW
    pygame.font.init()
    (tmp_path / "mine.toml").write_text(NEW.replace(before, after))
    file = WatchedFile(tmp_path / "mine.toml")
    editor = Editor(AppState(classic(), 0, 0, Title), editing_session(file), file)
    surface = pygame.Surface(SIZE)
    editor.draw(surface)
    assert editor.session.document.problem
    for _ in range(2):
        editor.draw(surface)
        click(editor, (600, 400))


def test_a_saved_level_can_be_played_and_is_no_news(editor, tmp_path):
    key(editor, pygame.K_c)
    key(editor, pygame.K_s, mod=pygame.KMOD_CTRL)
    assert load_file(tmp_path / "mine.toml").rings[1].count == 12
    before = editor.session
    editor.advance(1.0, SIZE)
    assert editor.session == before
    assert press(editor, "Leave") is None


def test_what_another_program_writes_is_taken_over_and_an_error_keeps_the_last_good_state(editor, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(NEW.replace("layers = 1", "layers = 3"))
    editor.advance(1.0, SIZE)
    assert editor.session.document.level.rings[0].layers == 3
    path.write_text("name = ")
    editor.advance(1.0, SIZE)
    key(editor, pygame.K_RIGHT)
    assert "not valid TOML" in editor.session.file_error
    assert editor.session.document.level.rings[0].layers == 3
    key(editor, pygame.K_z, mod=pygame.KMOD_CTRL)
    assert editor.session.document.text == NEW
    key(editor, pygame.K_s, mod=pygame.KMOD_CTRL)
    assert not editor.session.file_error
    for text in ("name = ", NEW):
        path.write_text(text)
        editor.advance(1.0, SIZE)
        assert bool(editor.session.file_error) == (text != NEW)


def test_a_level_whose_file_was_removed_is_asked_about_and_the_same_file_is_news(editor, tmp_path):
    """Else the only copy of the level would go with the window, or the error would stay when the file is back."""
    path = tmp_path / "mine.toml"
    key(editor, pygame.K_s, mod=pygame.KMOD_CTRL)
    data = path.read_bytes()
    path.unlink()
    editor.advance(1.0, SIZE)
    assert "cannot read level" in editor.session.file_error
    assert isinstance(key(editor, pygame.K_ESCAPE), Menu)
    path.write_bytes(data)
    editor.advance(1.0, SIZE)
    assert not editor.session.file_error
    assert not editor.session.changed


def test_a_level_with_a_problem_is_neither_saved_nor_played(editor, tmp_path):
    key(editor, pygame.K_0, "0")
    key(editor, pygame.K_f)
    editor.draw(pygame.Surface(SIZE, 0, 32))
    assert key(editor, pygame.K_F5) is editor
    assert "no bricks" in editor.session.message
    press(editor, "Save")
    assert "not saved" in editor.session.message
    assert not (tmp_path / "mine.toml").exists()


def test_a_play_test_comes_back_to_the_editor(editor):
    """By Esc at once, by the only exit of the pause, and from the results; nothing of the game is stored."""
    playing = key(editor, pygame.K_F5)
    assert isinstance(playing, PlayTest)
    playing.advance(0.1, SIZE)
    playing.draw(pygame.Surface(SIZE, 0, 32))
    assert playing.answer(Pressed(Action.BACK), SIZE) is editor
    assert playing.answer(Pressed(Action.PAUSE), SIZE) is playing
    assert [entry.label for entry in playing._inner._entries][-1] == "Back to the editor"
    editor._state.change(editor._state.settings.other_colours())
    playing.advance(0.1, SIZE)
    assert playing._own.settings == editor._state.settings
    playing._own.change(playing._own.settings._replace(volume=3))
    playing.answer(Pressed(Action.UP), SIZE)
    assert playing.answer(Pressed(Action.CONFIRM), SIZE) is editor
    assert editor._state.settings.volume == 3
    assert playing._inner._state.storage.progress is not editor._state.storage.progress


def test_unsaved_changes_are_asked_about_and_kept_where_nobody_could_be_asked(editor, tmp_path, capsys):
    key(editor, pygame.K_c)
    asked = key(editor, pygame.K_ESCAPE)
    assert isinstance(asked, Menu)
    assert asked.answer(Pressed(Action.BACK), SIZE) is editor
    keep_unsaved(editor.session, tmp_path / "mine.toml")
    assert "mine.unsaved.toml" in capsys.readouterr().err
    assert (tmp_path / "mine.unsaved.toml").read_text() == editor.session.document.text
    assert asked.answer(Pressed(Action.CONFIRM), SIZE) is None
    assert (tmp_path / "mine.toml").exists()


@pytest.mark.parametrize("text_size", [100, 200])
@pytest.mark.parametrize("size", [(640, 480), (800, 600), (3840, 2160), (700, 900)])
def test_every_part_has_room_beside_the_arena(editor, size, text_size):
    """Arena, lines and controls do not overlap; some of the scrolled area is visible; Save is at one pixel in all parts."""
    editor._state.change(editor._state.settings._replace(text_size=text_size))
    seen, side = editor.layout(size), editor.side(size)
    assert pygame.Rect((0, 0), size).contains(seen.side.unionall([seen.arena, seen.foot]))
    assert seen.side.unionall([seen.side]).collidelist([seen.arena, seen.foot]) < 0
    assert seen.arena.bottom <= seen.foot.top
    assert seen.unit == pytest.approx(text_size / 100.0 * editor_layout(size, 10.0).unit)
    always = set()
    for part in PanelPart:
        side.open_part(part)
        layout = side._form_layout(size)
        assert layout.over == 0 or layout.body.height > 4.5 * seen.unit
        boxes = [
            positioned.box.clip(layout.body) if positioned.in_body else positioned.box
            for positioned in layout.items
            if positioned.item.focusable
        ]
        assert all([box.collidelist(boxes[:index]) < 0 for index, box in enumerate(boxes)])
        assert all([seen.side.contains(positioned.box) for positioned in layout.items if not positioned.in_body])
        always.add(tuple(side._form_layout(size).items[-4].box))
    assert len(always) == 1


def test_a_picture_that_would_be_the_same_is_not_drawn_again(editor):
    """The values that it depends on change with the level, the cursor, the focus and the mouse, and with nothing else."""
    editor.draw(pygame.Surface(SIZE, 0, 32))
    seen = [editor.appearance]
    editor.advance(0.1, SIZE)
    assert editor.appearance == seen[0]
    for code in (pygame.K_RIGHT, pygame.K_5, pygame.K_TAB, pygame.K_DOWN, pygame.K_PAGEDOWN):
        key(editor, code)
        assert editor.appearance not in seen
        seen.append(editor.appearance)


def test_a_bare_name_is_in_the_folder_of_own_levels(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    path = file_to_edit(None)
    assert path.name == "my-level.toml"
    assert path.parent.is_dir()
    with pytest.raises(BadInputError, match=r"\.toml"):
        file_to_edit(tmp_path / "x.txt")
