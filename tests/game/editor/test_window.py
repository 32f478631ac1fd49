"""The editor's window: every command by key and by mouse, and nothing lost when it is left."""

import pygame
import pytest

from game.editor.command import NEW, editing_session, file_to_edit, keep_unsaved
from game.editor.file_watch import WatchedFile
from game.editor.window.help import EditorHelp
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


def press(editor, name):
    """The screen after a click on a button."""
    return click(editor, next(box.center for button, box in editor_layout(SIZE, editor.session).buttons if button.name == name))


def slot_pixel(editor, radius):
    """A pixel on the bricks to the right of the centre."""
    camera = editor_layout(SIZE, editor.session).camera
    pixel = camera.project(complex(radius, 0.0))
    return round(pixel.real), round(pixel.imag)


def test_the_mouse_paints_takes_away_and_repeats(editor):
    click(editor, next(box.center for layers, box in editor_layout(SIZE, editor.session).chips if layers == 5))
    click(editor, next(box.center for fold, box in editor_layout(SIZE, editor.session).folds if fold == 3))
    click(editor, slot_pixel(editor, 4.0))
    assert editor.session.document.level.rings[0].slots() == (5, 1, 1, 1) * 3
    click(editor, slot_pixel(editor, 4.0), button=3)
    assert editor.session.document.level.rings[0].slots() == (0, 1, 1, 1) * 3
    press(editor, "undo")
    press(editor, "undo")
    assert editor.session.document.text == NEW
    press(editor, "redo")
    assert editor.session.document.level.rings[0].slots() == (5, 1, 1, 1) * 3


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


def test_a_number_is_typed_and_wheeled_and_stepped(editor):
    row, box = editor_layout(SIZE, editor.session).rows[0]
    assert row.name == "radius"
    click(editor, box.center)
    for letter in "3.5":
        key(editor, ord(letter), letter)
    key(editor, pygame.K_RETURN)
    assert editor.session.document.level.rings[0].radius == 3.5
    editor.hear(pygame.Event(pygame.MOUSEWHEEL, precise_y=-2.0), SIZE, 1 + 1j)
    assert editor.session.document.level.rings[0].radius == 3.3
    click(editor, (box.right - 2, box.centery))
    assert editor.session.document.level.rings[0].radius == 3.4
    key(editor, pygame.K_RIGHT, mod=pygame.KMOD_SHIFT)
    assert editor.session.document.level.rings[0].radius == 4.4


def test_a_saved_level_can_be_played_and_is_no_news(editor, tmp_path):
    key(editor, pygame.K_c)
    key(editor, pygame.K_s, mod=pygame.KMOD_CTRL)
    assert load_file(tmp_path / "mine.toml").rings[1].count == 12
    before = editor.session
    editor.advance(1.0, SIZE)
    assert editor.session == before
    assert press(editor, "leave") is None


def test_what_another_program_writes_is_taken_over_and_an_error_keeps_the_last_good_state(editor, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(NEW.replace("layers = 1", "layers = 3"))
    editor.advance(1.0, SIZE)
    assert editor.session.document.level.rings[0].layers == 3
    path.write_text("name = ")
    editor.advance(1.0, SIZE)
    assert "not valid TOML" in editor.session.message
    assert editor.session.document.level.rings[0].layers == 3
    key(editor, pygame.K_z, mod=pygame.KMOD_CTRL)
    assert editor.session.document.text == NEW


def test_a_level_with_a_problem_is_neither_saved_nor_played(editor, tmp_path):
    key(editor, pygame.K_0, "0")
    key(editor, pygame.K_f)
    editor.draw(pygame.Surface(SIZE, 0, 32))
    assert key(editor, pygame.K_F5) is editor
    assert "no bricks" in editor.session.message
    press(editor, "save")
    assert "not saved" in editor.session.message
    assert not (tmp_path / "mine.toml").exists()


def test_a_play_test_comes_back_to_the_editor(editor):
    playing = key(editor, pygame.K_F5)
    assert isinstance(playing, PlayTest)
    playing.advance(0.1, SIZE)
    playing.draw(pygame.Surface(SIZE, 0, 32))
    menu = playing.answer(Pressed(Action.BACK), SIZE)
    for _ in range(12):
        if menu is editor:
            break
        menu = menu.answer(Pressed(Action.UP), SIZE)
        menu = menu.answer(Pressed(Action.CONFIRM), SIZE)
    assert menu is editor


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


@pytest.mark.parametrize("size", [(640, 480), (800, 600), (1280, 800), (1920, 1080), (3840, 2160), (700, 900)])
def test_everything_is_within_the_window_and_beside_each_other(editor, size):
    seen = editor_layout(size, editor.session)
    boxes = [box for _, box in (*seen.rows, *seen.chips, *seen.folds, *seen.buttons)]
    whole = pygame.Rect((0, 0), size)
    assert all([whole.contains(box) for box in [*boxes, seen.arena, seen.foot]])
    assert all([box.collidelist(boxes[:index]) < 0 for index, box in enumerate(boxes)])
    surface = pygame.Surface(size, 0, 32)
    editor.draw(surface)
    EditorHelp(AppState(classic(), 0, 0, Title), editor).draw(surface)


def test_a_bare_name_is_in_the_folder_of_own_levels(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    path = file_to_edit(None)
    assert path.name == "my-level.toml"
    assert path.parent.is_dir()
    with pytest.raises(BadInputError, match=r"\.toml"):
        file_to_edit(tmp_path / "x.txt")
