"""The lab's window, worked by posted events on the dummy driver."""

import random

import pygame
import pytest

from game.drawing.palette import DARK
from game.drawing.text import Type
from game.input.key_names import play_help
from game.lab.kit.parameters import defaults
from game.lab.kit.scene import Motion, picture_of
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.session.checks import lines
from game.lab.session.commands import Command
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.share import SharedScene, parsed
from game.lab.window import saving, screen
from game.lab.window.commands import KEYS, MORE_HELP, command_of
from game.lab.window.layout import layout_of
from game.lab.window.screen import Lab
from game.lab.window.words import TextSheet, draw_head, draw_words
from game.loop.app import _lab_opener
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.items.drop_down import OptionList
from game.screens.toolkit.key_help import KeyHelp
from game.screens.toolkit.menu import Menu
from game.settings.values import THEMES
from tests.support.lab_scenes import state_at
from tests.support.paths import ROOT
from tests.support.windows.dummy_window import FRAME, Desk, shared
from tests.support.windows.lab_desk import SIZE, LabDesk
from tools.crosscheck.second_engine import Pymunk


def test_the_ball_is_dragged_where_the_hand_goes(desk):
    """A ball that is taken hold of beside its centre does not jump; its values are rounded to their step."""
    start, end = 9.4 + 3.9j, 10.4 + 4.4j
    aside = 0.4 + 0.3j
    desk.drag(desk.pixel(start + aside), desk.pixel(end + aside))
    assert abs(desk.values.point("ball") - end) < 0.02
    assert desk.values.point("ball").real == round(desk.values.point("ball").real, 2)


def test_a_drag_on_nothing_moves_the_view_and_home_brings_it_back(desk):
    """A drag on nothing moves the world, wherever the mouse goes, and no value; Home shows what was shown at first."""
    before = desk.values
    start = desk.pixel(7 + 4j)
    for button, across in ((1, 100), (2, 700)):
        desk.drag(start, (start[0] + across, start[1] + 50), button)
        assert desk.values == before
        assert desk.pixel(7 + 4j) == (start[0] + across, start[1] + 50)
        desk.press(pygame.K_HOME)
        assert desk.pixel(7 + 4j) == start


def test_handles_are_dragged_only_in_panes_that_have_them():
    """In the turned game of `symmetry` a drag at the ball's position in the first game moves the world."""
    desk = LabDesk("symmetry")
    desk.press(pygame.K_SPACE)
    before = desk.values.point("ball")
    start = desk.pixel(before, pane=1)
    desk.drag(start, (start[0] + 20, start[1] + 10))
    assert desk.values.point("ball") == before
    desk.press(pygame.K_HOME)
    start = desk.pixel(before)
    desk.drag(start, (start[0] + 20, start[1] + 10))
    assert desk.values.point("ball") != before
    desk.close()


def test_the_wheel_zooms_about_the_pointer(desk):
    """The wheel zooms; the point under the pointer stays there."""
    pixel = desk.pixel(10 + 4j)
    scale = desk.pixel(11 + 4j)[0] - pixel[0]
    desk.wheel(pixel, 3)
    assert all([abs(a - b) <= 1 for a, b in zip(desk.pixel(10 + 4j), pixel, strict=True)])
    assert desk.pixel(11 + 4j)[0] - pixel[0] > 1.3 * scale


def test_the_view_shows_the_ball_wherever_it_is():
    """Where a share line puts the ball far away, more of the world is shown, and again after Home."""
    desk = LabDesk("case-2?ball=-12,-9")
    area = layout_of(desk.size).world
    for _ in range(2):
        assert area.collidepoint(desk.pixel(-12 - 9j))
        desk.wheel(area.center, 5)
        desk.press(pygame.K_HOME)
    desk.close()


def test_a_drag_beyond_the_range_stops_at_its_border_and_says_so(desk):
    """A drag beyond a parameter's range sets it to the border, and a note says so."""
    desk.screen._pan_zoom = PanZoom(zoom=0.3)
    desk.drag(desk.pixel(9.4 + 3.9j), desk.pixel(16 + 3.9j))
    assert desk.values.point("ball").real == 15.0
    assert "is beyond its range" in desk.session.notes[0]


@pytest.mark.usefixtures("unseen")
def test_every_scene_is_one_key_away(desk):
    """] opens every scene once and then the first one again; [ goes back."""
    names = []
    for _ in scenes():
        names.append(desk.session.scene.name)
        desk.press(pygame.K_RIGHTBRACKET)
    assert sorted(names) == sorted([scene.name for scene in scenes()])
    assert desk.session.scene.name == names[0]
    desk.press(pygame.K_LEFTBRACKET)
    assert desk.session.scene.name == names[-1]


def test_defaults_and_restart(desk):
    """R leaves the settings as they are; D sets the defaults."""
    desk.type_into("half_angle", "50")
    desk.press(pygame.K_r)
    assert desk.values.number("half_angle") == 50.0
    desk.press(pygame.K_d)
    assert desk.values.values == defaults(desk.session.scene.parameters).values


def test_copy_and_save_say_what_became_of_it(desk, tmp_path, monkeypatch):
    """S saves the line of the scene as it stands, C copies it, and a notice says so for five seconds."""
    file = tmp_path / "cases.txt"
    monkeypatch.setattr(saving, "case_file", lambda: file)
    desk.press(pygame.K_s)
    assert file.read_text() == f"{desk.session.line}\n"
    assert desk.screen._notes() == (f"saved in {file}",)
    desk.press(pygame.K_c)
    assert "line" in desk.screen._notes()[-1]
    monkeypatch.setattr(saving, "case_file", lambda: tmp_path)
    desk.press(pygame.K_s)
    assert "case not saved" in desk.screen._notes()[-1]
    desk.screen.advance(6.0, SIZE)
    assert desk.screen._notes() == ()


def test_help_opens_and_the_same_key_closes_it(desk):
    """The help lists every key of the lab; letters do nothing there."""
    lab, theme = desk.screen, desk.shared.theme
    desk.press(pygame.K_h)
    assert isinstance(desk.screen, KeyHelp)
    listed = {row[1].text for row in desk.screen.content().body}
    assert listed == {meaning for _, meaning in MORE_HELP} | {key.meaning for key in KEYS}
    desk.press(pygame.K_t, pygame.K_l)
    assert isinstance(desk.screen, KeyHelp)
    assert desk.shared.theme is theme
    desk.press(pygame.K_h)
    assert desk.screen is lab


@pytest.mark.usefixtures("unseen")
def test_a_scene_in_motion(desk, run):
    """A scene runs, pauses, steps forward and back, slows down, restarts, and opens at a share line's tick."""
    desk.screen._session = run
    desk.wait(0.2)
    assert 8 <= desk.session.tick <= 16
    desk.press(pygame.K_SPACE)
    stopped = desk.session.tick
    desk.wait(0.5)
    assert desk.session.tick == stopped
    desk.press(pygame.K_PERIOD, pygame.K_PERIOD, pygame.K_COMMA)
    assert desk.session.tick == stopped + 1
    desk.press(pygame.K_MINUS)
    assert desk.session.pace == run.pace - 1
    desk.press(pygame.K_r)
    assert desk.session.playing
    assert desk.session.tick <= 2
    opened = session.opened(SharedScene(run.scene, run.given, 7))
    assert (opened.tick, opened.playing) == (7, False)


@pytest.mark.parametrize(("key", "mod"), [(pygame.K_F11, 0), (pygame.K_RETURN, pygame.KMOD_LALT)], ids=["F11", "Alt+Enter"])
def test_full_screen_comes_with_the_press_and_stays_when_the_key_comes_up(desk, key, mod):
    """Each press of the key changes to or from full screen once; its release changes nothing."""
    for on in (True, False):
        desk.press(key, mod=mod)
        assert desk.shared.full_screen is on
        desk.wait(FRAME)
        assert desk.shared.full_screen is on
    assert isinstance(desk.screen, Lab)


@pytest.mark.usefixtures("unseen")
def test_a_tap_under_load_goes_on_by_one_scene(desk):
    """However long pictures take between the press and the release of the key, it counts once."""
    names = [scene.name for scene in scenes()]
    before = names.index(desk.session.scene.name)
    desk.hold(pygame.K_RIGHTBRACKET)
    for _ in range(3):
        desk.wait_once(1.0)
    desk.release(pygame.K_RIGHTBRACKET)
    desk.wait_once(1.0)
    assert names.index(desk.session.scene.name) == before + 1
    assert pygame.key.get_repeat() == (0, 0)


@pytest.mark.usefixtures("unseen")
def test_a_held_key_repeats_steps_but_a_tap_is_one_step(desk, run):
    """A held key steps again after 0.4 s, until it is released or the window loses the focus; a tap is one step."""
    desk.screen._session = session.toggled(run)
    desk.hold(pygame.K_PERIOD)
    desk.wait_once(5.0)
    desk.release(pygame.K_PERIOD)
    desk.wait_once(5.0)
    assert desk.session.tick == 1
    desk.hold(pygame.K_PERIOD)
    desk.wait(1.0)
    held = desk.session.tick
    assert 8 <= held <= 16
    desk.release(pygame.K_PERIOD)
    desk.wait(1.0)
    assert desk.session.tick == held
    desk.hold(pygame.K_COMMA)
    desk.post(pygame.WINDOWFOCUSLOST)
    desk.wait(1.0)
    assert desk.session.tick == held - 1


def test_every_command_has_a_key_and_no_key_two():
    """Every command has a key, and no key has two commands."""
    assert {key.command for key in KEYS} == set(Command)
    bound = [code for key in KEYS for code in key.keys]
    assert len(bound) == len(set(bound))
    assert command_of(pygame.K_F12) is None


def test_the_labs_page_says_every_key():
    """The table of keys on the page has the first key of every command."""
    page = (ROOT / "docs" / "lab.md").read_text(encoding="utf-8").partition("## Keys")[2].partition("\n\nIn a field")[0]
    named = " ".join([row.split("|")[1].casefold().replace(",", " ") for row in page.splitlines() if row.count("|") > 2])
    written = {"up": "↑", "down": "↓", "escape": "esc", ",": ".", "f6": "f5"}
    keys = [written.get(key, key) for key in [pygame.key.name(binding.keys[0]) for binding in KEYS]]
    assert [key for key in keys if f" {key} " not in f" {named} "] == []


def preset_pictures(scene):
    """What a scene shows at every preset, of one that runs the first picture and the last."""
    ticks = (0, scene.shows.ticks) if isinstance(scene.shows, Motion) else (0,)
    every = [(given, state_at(scene, given, tick)) for given in lines(scene, Pymunk()) for tick in ticks]
    return [picture_of(scene, given, state) for given, state in every]


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_the_words_fit_their_places(scene):
    """At every preset, title, idea, formula and note end inside their parts of the window, of every common size."""
    pictures, type_ = preset_pictures(scene), Type()
    for size in ((800, 600), (1280, 800), (3840, 2160), (900, 1600)):
        layout = layout_of(size)
        sheet = TextSheet(pygame.Surface(size), layout, DARK, type_)
        assert draw_head(sheet, scene) <= layout.head.bottom
        for picture in pictures:
            assert draw_words(sheet, picture) <= layout.words.bottom


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_every_scene_is_drawn_in_both_themes(scene):
    """A scene can be drawn in dark and in light colours, one that runs halfway through."""
    tick = scene.shows.ticks // 2 if isinstance(scene.shows, Motion) else 0
    given = defaults(scene.parameters, Pymunk())
    assert state_at(scene, given, 0) is not None or tick == 0
    app, surface, means = shared(), pygame.Surface((800, 600), 0, 32), []
    lab = Lab(app, session.opened(SharedScene(scene, given, tick)))
    for theme in THEMES:
        app.settings = app.settings._replace(colours=theme)
        lab.draw(surface)
        means.append(pygame.transform.average_color(surface)[0])
    assert means[0] + 100 < means[1]


def random_event(chance, size):
    """Any event of keyboard or mouse."""
    pixel = (int(chance.random() * size[0]), int(chance.random() * size[1]))
    kind = int(chance.random() * 6)
    if kind == 0:
        codes = [code for key in KEYS for code in key.keys if key.command not in {Command.LEAVE, *saving.PICTURES}]
        code = chance.choice([*codes, pygame.K_1, pygame.K_7, pygame.K_RETURN, pygame.K_BACKSPACE, pygame.K_TAB, pygame.K_F8])
        return pygame.Event(pygame.KEYDOWN, key=code, mod=0, unicode=chance.choice("a9.-"))
    if kind == 1:
        return pygame.Event(pygame.TEXTINPUT, text=chance.choice(["1", "-", "e", "nan", "°", "\u4e2d"]))
    if kind == 2:
        return pygame.Event(pygame.MOUSEWHEEL, x=0, y=1, precise_x=0.0, precise_y=chance.choice([-30.0, -1.0, 0.5, 30.0]))
    if kind == 3:
        return pygame.Event(pygame.MOUSEBUTTONDOWN, pos=pixel, button=chance.choice([1, 1, 1, 2, 3, 8]))
    if kind == 4:
        return pygame.Event(pygame.MOUSEBUTTONUP, pos=pixel, button=1)
    return pygame.Event(pygame.MOUSEMOTION, pos=pixel, rel=(0, 0), buttons=(1, 0, 0))


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_no_hands_break_it(scene, tmp_path, monkeypatch):
    """After random keys, clicks, drags and letters the lab goes on, and every value is in its range."""
    monkeypatch.setattr(saving, "case_file", lambda: tmp_path / "cases.txt")
    monkeypatch.setattr(saving, "own_levels_folder", lambda: tmp_path)
    monkeypatch.setattr("game.lab.drawing.formula_type.can_typeset", lambda: False)  # plain text takes a tenth of the time
    monkeypatch.setattr(screen, "progress_path", lambda: tmp_path / "progress.json")
    chance = random.Random(scene.name)
    desk = LabDesk(scene.name, (800, 600))
    lab = desk.screen
    for _ in range(6):
        for _ in range(25):
            pygame.event.post(random_event(chance, desk.size))
        desk.wait(FRAME)
        shown = parsed(lab.session.line)
        assert shown.given.values == lab.session.given.values
        if isinstance(desk.screen, OptionList | KeyHelp):
            desk.press(pygame.K_ESCAPE)
        assert desk.screen is lab
    desk.close()


def test_l_opens_the_lab_over_the_game_and_esc_comes_back():
    """L opens the lab over a game, which is paused; Esc comes back to its menu."""
    app = shared()
    app.open_lab = _lab_opener(Pymunk)
    assert "L" in [keys for keys, _ in play_help()]
    desk = Desk(app, Title(app))
    desk.press(pygame.K_RETURN)
    assert isinstance(desk.screen, PlayScreen)
    desk.press(pygame.K_l)
    assert isinstance(desk.screen, Lab)
    desk.press(pygame.K_ESCAPE)
    assert isinstance(desk.screen, Menu)
    desk.close()
