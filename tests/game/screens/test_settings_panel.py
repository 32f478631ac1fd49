"""The settings on the screen, by keys and by mouse."""

import numpy as np
import pygame
import pytest

from game.drawing.camera import unit_of
from game.drawing.palette import LIGHT
from game.drawing.raster.primitives import draw_box
from game.effects import EffectKind
from game.screens.menus.settings_panel import SettingsPanel, _boxes, _volume_bar
from game.screens.menus.settings_rows import EFFECTS, ROWS
from game.screens.play import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from game.settings.file import SettingsFile
from game.settings.values import Settings
from tests.support.dummy_window import FRAME, SIZE, Desk, shared


@pytest.fixture
def desk():
    """The app at its title."""
    state = shared()
    found = Desk(state, Title(state), (1280, 800))
    found.wait(FRAME)
    yield found
    found.close()


def test_they_open_from_the_title_the_game_and_its_pause(desk):
    """O opens them over the title and a game, an entry over the pause menu; closing them leads back to that screen."""
    desk.press(pygame.K_o)
    assert isinstance(desk.screen, SettingsPanel)
    desk.press(pygame.K_ESCAPE)
    assert isinstance(desk.screen, Title)
    desk.press(pygame.K_RETURN, pygame.K_o)
    assert isinstance(desk.screen, SettingsPanel)
    desk.press(pygame.K_o)
    assert isinstance(desk.screen, PlayScreen)
    desk.press(pygame.K_p, pygame.K_DOWN, pygame.K_DOWN, pygame.K_RETURN)
    assert isinstance(desk.screen, SettingsPanel)
    desk.press(pygame.K_ESCAPE)
    assert isinstance(desk.screen, Menu)


def test_every_row_changes_something_and_changes_it_back(desk):
    """Enter changes a row's setting, and again changes it back; each effect has its row."""
    desk.press(pygame.K_o)
    seen = set()
    for row in ROWS[1:]:
        desk.press(pygame.K_DOWN, pygame.K_RETURN)
        assert row.on(desk.shared.settings) != row.on(Settings())
        seen.add(desk.shared.settings)
        desk.press(pygame.K_RETURN)
        assert desk.shared.settings == Settings()
    assert len(seen) == len(ROWS) - 1
    assert {row.kind for row in EFFECTS} == set(EffectKind)


def test_the_volume_follows_keys_and_mouse(desk):
    """Left and right change it in its row, - and = everywhere, and a click or a drag on its bar sets it."""
    desk.press(pygame.K_o, pygame.K_LEFT, pygame.K_LEFT)
    assert desk.shared.settings.volume == 60
    desk.press(pygame.K_RIGHT, pygame.K_EQUALS, pygame.K_MINUS)
    assert desk.shared.settings.volume == 70
    bar = _volume_bar(_boxes(desk.window.size)[1][0], unit_of(desk.window.size))
    desk.click((bar.left + bar.width // 4, bar.centery))
    assert desk.shared.settings.volume == pytest.approx(25, abs=1)
    desk.move((bar.right + 1, bar.centery), held=True)
    desk.wait(FRAME)
    assert desk.shared.settings.volume == 100


def test_the_mouse_selects_and_switches(desk):
    """Moving over a row selects it, a click on it switches it, and a click beside the rows does nothing."""
    desk.press(pygame.K_o)
    box = _boxes(desk.window.size)[1][2]
    desk.move(box.center)
    desk.wait(FRAME)
    assert desk.screen._selected == 2
    desk.click(box.center)
    assert desk.shared.theme is LIGHT
    desk.click((1, 1))
    assert desk.shared.settings == Settings(colours="light")


def test_what_is_changed_reaches_what_sounds_now(desk):
    """The mixer's volume and mute follow the settings in the same frame."""

    class Card:
        volume, muted = 1.0, False

        def prepare(self):
            """Nothing to draw."""

    desk.shared.audio = card = Card()
    desk.press(pygame.K_MINUS)
    assert card.volume == pytest.approx(0.7)
    desk.press(pygame.K_m)
    assert card.muted
    desk.press(pygame.K_EQUALS)
    assert not card.muted


def corner(surface):
    """The lower left of the picture."""
    width, height = surface.get_size()
    return surface.subsurface((0, height * 2 // 3, width // 3, height // 3))


def test_a_change_by_key_is_told_for_a_moment(desk):
    """A key that changes a setting shows words in the corner, which are gone two seconds later."""
    desk.press(pygame.K_o)
    surface = desk.window.get_surface()
    before = pygame.image.tobytes(corner(surface), "RGB")
    desk.press(pygame.K_m)
    assert desk.shared.toast.text == "Sound off"
    assert pygame.image.tobytes(corner(surface), "RGB") != before
    desk.wait(2.0)
    assert desk.shared.toast is None
    assert pygame.image.tobytes(corner(surface), "RGB") == before


def test_closing_the_panel_writes_the_settings(desk, tmp_path):
    """Changed settings are in the file once the panel is closed, and not before."""
    desk.shared.settings_file = SettingsFile(tmp_path / "settings.json")
    desk.shared.settings_file.load()
    desk.press(pygame.K_o, pygame.K_LEFT)
    assert not (tmp_path / "settings.json").exists()
    desk.press(pygame.K_ESCAPE)
    assert SettingsFile(tmp_path / "settings.json").load() == desk.shared.settings


@pytest.mark.parametrize("size", [(1, 1), (40, 900), (900, 40), SIZE, (7680, 4320)])
def test_any_size_of_window(desk, size):
    """The panel can be drawn and used in a window of any size."""
    desk.window.size = size
    desk.press(pygame.K_o, pygame.K_DOWN, pygame.K_RETURN)
    assert not desk.shared.settings.sound


def test_rows_are_inside_the_panel_and_apart():
    """No row is outside the panel, the panel is not outside the window, and no two rows overlap."""
    for size in ((800, 600), (1280, 800), (3840, 2160), (700, 1200)):
        panel, boxes = _boxes(size)
        assert pygame.Rect(0, 0, *size).contains(panel)
        assert all(panel.contains(box) for box in boxes)
        assert all(len(box.collidelistall(boxes)) == 1 for box in boxes)


def test_reduced_motion_lets_the_camera_cut(desk):
    """A frame after Tab the camera is tipped with reduced motion, and on its path there without."""
    desk.press(pygame.K_RETURN, pygame.K_TAB)
    assert 0.0 < desk.shared.view.tipped < 1.0
    desk.shared.change(Settings(reduced_motion=True))
    desk.press(pygame.K_TAB)
    assert desk.shared.view.tipped == 0.0


@pytest.mark.parametrize("size", [(1, 1), (2, 9), (9, 2), (30, 30), (31, 12), (200, 40)])
def test_a_box_covers_its_rectangle_but_for_its_corners(size):
    """No pixel outside is covered, the middle row and column are, and the corners are rounded the same on all sides."""
    surface = pygame.Surface((260, 90), 0, 32)
    box = pygame.Rect((20, 20), size)
    draw_box(surface, box, 8.0, (255, 255, 255))
    inside = pygame.surfarray.array3d(surface)[:, :, 0].astype(int)
    covered = inside[box.left : box.right, box.top : box.bottom].copy()
    inside[box.left : box.right, box.top : box.bottom] = 0
    assert not inside.any()
    assert np.array_equal(covered, covered[::-1])
    assert np.array_equal(covered, covered[:, ::-1])
    assert (covered[size[0] // 2] == 255).all()
    assert (covered[:, size[1] // 2] == 255).all()
    if min(size) > 20:
        assert covered[0, 0] == 0
