"""The settings on the screen, by keys and by mouse."""

import numpy as np
import pygame
import pytest

from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.palette import LIGHT
from game.drawing.raster.primitives import draw_box
from game.drawing.text import Type
from game.effects import EffectKind
from game.screens.menus.settings.ball_preview import ball_preview
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.menus.settings.rows import PARTS, effect_names
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.items.basic import ChoiceItem, Switch
from game.screens.toolkit.items.slider import Slider
from game.screens.toolkit.menu import Menu
from game.settings.file import SettingsFile
from game.settings.values import Settings
from game.storage.progress import Best
from game.unlocks import BALLS, TRAILS
from tests.support.windows.dummy_window import FRAME, SIZE, Desk, shared


@pytest.fixture
def desk():
    """The app at its title."""
    state = shared()
    found = Desk(state, Title(state), (800, 600))
    found.wait(FRAME)
    yield found
    found.close()


def open_part(desk, name):
    """Open the settings at one of their parts."""
    desk.press(pygame.K_o)
    desk.screen.open_tab([part.name() for part in PARTS].index(name))
    desk.wait(FRAME)


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
    desk.press(pygame.K_p)
    desk.choose("Settings")
    assert isinstance(desk.screen, SettingsPanel)
    desk.press(pygame.K_ESCAPE)
    assert isinstance(desk.screen, Menu)


def test_every_row_changes_something_and_changes_it_back(desk, monkeypatch):
    """Whatever can be set on any part is reached by arrow keys, changed by Enter, and can be set back."""
    monkeypatch.setattr(SettingsPanel, "draw", lambda *_: None)  # what it looks like is not asked here
    for number in range(30):  # every ball and trail is earned
        desk.shared.storage.level_done(Best(f"level {number}", "hard", 5000, 3))
    changed = 0
    for index in range(len(PARTS)):
        desk.press(pygame.K_o)
        desk.screen.open_tab(index)
        panel = desk.screen
        for positioned in panel._form_layout(desk.window.size).items:
            if not isinstance(positioned.item, Switch | ChoiceItem | Slider) or positioned.item.label == "Full screen":
                continue
            if isinstance(positioned.item, ChoiceItem) and len(positioned.item.options) == 1:  # the others are not unlocked yet
                continue
            before = desk.shared.settings
            desk.focus(positioned.item.label)
            desk.press(
                pygame.K_LEFT if isinstance(positioned.item, Slider) and positioned.item.level == 1.0 else pygame.K_RETURN
            )
            assert desk.shared.settings != before, positioned.item.label
            options = len(positioned.item.options) if isinstance(positioned.item, ChoiceItem) else 2
            for _ in range(options - 1):
                back = pygame.K_RIGHT if before.speed > desk.shared.settings.speed else pygame.K_LEFT
                desk.press(back if isinstance(positioned.item, Slider) else pygame.K_RETURN)
            assert desk.shared.settings == before, positioned.item.label
            changed += 1
        desk.press(pygame.K_ESCAPE)
    assert changed >= 5 + len(EffectKind)
    assert set(effect_names()) == set(EffectKind)


def test_the_chosen_ball_and_trail_are_shown():
    """The preview below the choices looks different for every ball, and for every trail."""
    looks = set()
    for ball, trail in [*[(ball, "comet") for ball in BALLS], *[("pearl", trail) for trail in list(TRAILS)[1:]]]:
        canvas = Canvas(pygame.Surface((400, 80), 0, 32), Camera(0j, 1.0), LIGHT, Type(), 20.0, ball, trail)
        ball_preview().draw(canvas, canvas.surface.get_rect(), focused=False)
        looks.add(pygame.image.tobytes(canvas.surface, "RGB"))
    assert len(looks) == len(BALLS) + len(TRAILS) - 1


def test_the_volume_follows_keys_and_mouse(desk):
    """Left and right change it in its row, - and = everywhere, and a click or a drag on its bar sets it."""
    open_part(desk, "Sound")
    desk.focus("Volume")
    desk.press(pygame.K_LEFT, pygame.K_LEFT)
    assert desk.shared.settings.volume == 60
    desk.press(pygame.K_RIGHT, pygame.K_EQUALS, pygame.K_MINUS)
    assert desk.shared.settings.volume == 70
    positioned = next(
        positioned for positioned in desk.screen._form_layout(desk.window.size).items if isinstance(positioned.item, Slider)
    )
    bar = positioned.item.bar(positioned.box, desk.screen.unit(desk.window.size))
    desk.click((bar.left + bar.width // 4, bar.centery))
    assert desk.shared.settings.volume == pytest.approx(25, abs=1)
    desk.move((bar.right + 1, bar.centery), held=True)
    desk.wait(FRAME)
    assert desk.shared.settings.volume == 100


def test_the_mouse_selects_and_switches(desk):
    """A click on a row switches it, on the left half of a choice to the one before; beside the rows it does nothing."""
    open_part(desk, "Picture")
    desk.click_on("Colours")
    assert desk.shared.theme is LIGHT
    desk.click_on("Reduced motion")
    assert desk.shared.settings == Settings(colours="light", reduced_motion=True)
    desk.click((1, 1))
    assert desk.shared.settings == Settings(colours="light", reduced_motion=True)


def test_the_switch_of_the_full_screen_is_f11(desk):
    """It makes the window as large as the desktop, says so, and gives it its size back."""
    open_part(desk, "Picture")
    desktop, before = pygame.display.get_desktop_sizes()[0], (640, 480)
    desk.window.size = before
    desk.wait(FRAME)
    desk.click_on("Full screen")
    desk.wait(FRAME)
    assert desk.window.size == desktop
    assert desk.shared.full_screen
    desk.click_on("Full screen")
    desk.wait(FRAME)
    assert desk.window.size == before


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
    """A key that changes a setting shows words in the corner, which are gone two seconds later, on a still screen too."""
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
    open_part(desk, "Sound")
    desk.click_on("Sound")
    assert not (tmp_path / "settings.json").exists()
    desk.press(pygame.K_ESCAPE)
    assert SettingsFile(tmp_path / "settings.json").load() == desk.shared.settings == Settings(sound=False)


@pytest.mark.parametrize("size", [(1, 1), (40, 900), (900, 40), SIZE, (3840, 2160)])
def test_any_size_of_window(desk, size):
    """The panel can be drawn and used in a window of any size."""
    desk.window.size = size
    desk.press(pygame.K_o, pygame.K_DOWN, pygame.K_RETURN)
    assert isinstance(desk.screen, SettingsPanel)


@pytest.mark.parametrize("size", [(800, 600), (1280, 800), (3840, 2160), (700, 1200)])
def test_items_are_inside_the_panel_and_apart(desk, size):
    """No item is outside of the plate, the plate is not outside of the window, and no two items overlap."""
    panel = SettingsPanel(desk.shared, desk.screen)
    for index in range(len(PARTS)):
        panel.open_tab(index)
        layout = panel._form_layout(size)
        assert pygame.Rect(0, 0, *size).contains(layout.plate)
        assert layout.plate.contains(layout.body)
        for boxes in (
            [positioned.box for positioned in layout.items if positioned.in_body is inside] for inside in (True, False)
        ):
            assert all(layout.plate.contains(box) for box in boxes) or layout.over
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
