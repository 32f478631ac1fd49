"""The lab's window, worked by posted events on the dummy driver."""

import random

import pygame
import pytest

from game.app import _lab_opener
from game.drawing.palette import DARK
from game.input.key_names import play_help
from game.lab.kit.parameters import defaults
from game.lab.kit.scene import Motion, picture_of
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.session.checks import lines, run_to
from game.lab.session.share import Shared as SharedLine
from game.lab.session.share import parsed
from game.lab.window import screen
from game.lab.window.commands import KEYS, Command, command_of
from game.lab.window.lens import Lens
from game.lab.window.page import draw_head, draw_words, page
from game.lab.window.screen import Lab
from game.lab.window.screenshot import save_screenshot
from game.screens.panels import Menu
from game.screens.play import Play
from game.screens.title import Title
from game.settings.values import THEMES
from tests.lab.test_session import run  # noqa: F401  # a fixture
from tests.support.dummy_window import FRAME, Desk, shared
from tests.support.lab_desk import SIZE, LabDesk
from tools.crosscheck.second_engine import Pymunk


@pytest.fixture
def desk():
    """The lab at case 2."""
    found = LabDesk()
    yield found
    found.close()


def test_the_ball_is_dragged_where_the_hand_goes(desk):
    """Taken hold of anywhere on it, it does not jump; the values are rounded to their step."""
    start, end = 9.4 + 3.9j, 10.4 + 4.4j
    aside = 0.4 + 0.3j
    desk.drag(desk.pixel(start + aside), desk.pixel(end + aside))
    assert abs(desk.values.point("ball") - end) < 0.02
    assert desk.values.point("ball").real == round(desk.values.point("ball").real, 2)


def test_a_drag_on_nothing_moves_the_view_and_home_brings_it_back(desk):
    """The values stay; the whole view is the first one."""
    before = desk.values
    start = desk.pixel(7 + 4j)
    desk.drag(start, (start[0] + 100, start[1] + 50))
    assert desk.values == before
    assert desk.pixel(7 + 4j) == (start[0] + 100, start[1] + 50)
    desk.press(pygame.K_HOME)
    assert desk.pixel(7 + 4j) == start


def test_the_wheel_zooms_about_the_pointer(desk):
    """What is under it stays."""
    place = desk.pixel(10 + 4j)
    scale = desk.pixel(11 + 4j)[0] - place[0]
    desk.wheel(place, 3)
    assert all([abs(a - b) <= 1 for a, b in zip(desk.pixel(10 + 4j), place, strict=True)])
    assert desk.pixel(11 + 4j)[0] - place[0] > 1.3 * scale


def test_the_view_shows_the_ball_wherever_it_is():
    """A share line may put the ball far away: the view is wider then, and Home comes back to it."""
    desk = LabDesk("case-2?ball=-12,-9")
    area = page(desk.size).world
    for _ in range(2):
        assert area.collidepoint(desk.pixel(-12 - 9j))
        desk.wheel(area.center, 5)
        desk.press(pygame.K_HOME)
    desk.close()


def test_a_drag_beyond_the_range_stops_at_its_border_and_says_so(desk):
    """Visibly."""
    desk.screen._lens = Lens(zoom=0.3)
    desk.drag(desk.pixel(9.4 + 3.9j), desk.pixel(16 + 3.9j))
    assert desk.values.point("ball").real == 15.0
    assert "is beyond its range" in desk.session.notes[0]


def test_every_scene_is_one_key_away(desk):
    """] goes through all of them and comes round; [ goes back."""
    names = []
    for _ in scenes():
        names.append(desk.session.scene.name)
        desk.press(pygame.K_RIGHTBRACKET)
    assert sorted(names) == sorted([scene.name for scene in scenes()])
    assert desk.session.scene.name == names[0]
    desk.press(pygame.K_LEFTBRACKET)
    assert desk.session.scene.name == names[-1]


def test_defaults_and_restart(desk):
    """D forgets the settings, R keeps them."""
    desk.type_into(desk.row("half_angle").field, "50")
    desk.press(pygame.K_r)
    assert desk.values.number("half_angle") == 50.0
    desk.press(pygame.K_d)
    assert desk.values.values == defaults(desk.session.scene.parameters).values


def test_copy_and_save_say_what_became_of_it(desk, tmp_path, monkeypatch):
    """The saved line is the one that is shown, and pytest would run it."""
    file = tmp_path / "cases.txt"
    monkeypatch.setattr(screen, "case_file", lambda: file)
    desk.press(pygame.K_s)
    assert file.read_text() == f"{desk.session.line}\n"
    assert desk.screen._notes() == (f"saved in {file}",)
    desk.press(pygame.K_c)
    assert "line" in desk.screen._notes()[-1]
    monkeypatch.setattr(screen, "case_file", lambda: tmp_path)
    desk.press(pygame.K_s)
    assert "case not saved" in desk.screen._notes()[-1]
    desk.screen.advance(6.0, SIZE)
    assert desk.screen._notes() == ()


def test_help_opens_and_any_key_closes_it(desk):
    """That key does nothing else."""
    desk.press(pygame.K_h)
    assert desk.screen._help
    desk.press(pygame.K_ESCAPE)
    assert desk.screen is not None
    assert not desk.screen._help


def test_a_scene_in_motion(desk, run):  # noqa: F811
    """Runs, pauses, steps forward and back, slows down; a share line's tick is where it opens."""
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
    opened = session.opened(SharedLine(run.scene, run.given, 7))
    assert (opened.tick, opened.playing) == (7, False)


def test_every_command_has_a_key_and_no_key_two():
    """The help lists them all."""
    assert {key.command for key in KEYS} == set(Command)
    bound = [code for key in KEYS for code in key.keys]
    assert len(bound) == len(set(bound))
    assert command_of(pygame.K_F12) is None


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
@pytest.mark.parametrize("size", [(800, 600), (1280, 800), (3840, 2160), (900, 1600)])
def test_the_words_fit_their_places(scene, size):
    """The head above the world, formula and notes below it, at every preset: nothing is cut off."""
    kept, place = shared(), page(size)
    surface = pygame.Surface(size)
    assert draw_head(surface, place, scene, DARK, kept.type) <= place.head.bottom
    for given in lines(scene, Pymunk()):
        ends = [run_to(scene, given, tick) for tick in ((0, scene.shows.ticks) if isinstance(scene.shows, Motion) else (0,))]
        for state in ends:
            assert draw_words(surface, place, picture_of(scene, given, state), DARK, kept.type) <= place.words.bottom


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_every_scene_is_drawn_in_both_themes(scene, tmp_path):
    """At its start, and half way through where it runs."""
    tick = scene.shows.ticks // 2 if isinstance(scene.shows, Motion) else 0
    given = defaults(scene.parameters, Pymunk())
    assert run_to(scene, given, 0) is not None or tick == 0
    pictures = []
    for theme in THEMES:
        file = tmp_path / "scene.png"
        save_screenshot(SharedLine(scene, given, tick), file, (800, 600), theme)
        pictures.append(pygame.image.load(file))
    assert pygame.transform.average_color(pictures[0])[0] + 100 < pygame.transform.average_color(pictures[1])[0]


def random_event(chance, size):
    """Something that hands may do."""
    place = (int(chance.random() * size[0]), int(chance.random() * size[1]))
    kind = int(chance.random() * 6)
    if kind == 0:
        codes = [code for key in KEYS for code in key.keys if key.command is not Command.LEAVE]
        code = chance.choice([*codes, pygame.K_1, pygame.K_7, pygame.K_RETURN, pygame.K_BACKSPACE, pygame.K_TAB, pygame.K_F5])
        return pygame.Event(pygame.KEYDOWN, key=code, mod=0, unicode=chance.choice("a9.-"))
    if kind == 1:
        return pygame.Event(pygame.TEXTINPUT, text=chance.choice(["1", "-", "e", "nan", "°", "\u4e2d"]))
    if kind == 2:
        return pygame.Event(pygame.MOUSEWHEEL, x=0, y=1, precise_x=0.0, precise_y=chance.choice([-30.0, -1.0, 0.5, 30.0]))
    if kind == 3:
        return pygame.Event(pygame.MOUSEBUTTONDOWN, pos=place, button=chance.choice([1, 1, 1, 2, 3, 8]))
    if kind == 4:
        return pygame.Event(pygame.MOUSEBUTTONUP, pos=place, button=1)
    return pygame.Event(pygame.MOUSEMOTION, pos=place, rel=(0, 0), buttons=(1, 0, 0))


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_no_hands_break_it(scene, tmp_path, monkeypatch):
    """Keys, clicks, drags and letters at random: the window goes on, and every value stays in its range."""
    monkeypatch.setattr(screen, "case_file", lambda: tmp_path / "cases.txt")
    chance = random.Random(scene.name)
    desk = LabDesk(scene.name, (800, 600))
    for _ in range(20):
        for _ in range(10):
            pygame.event.post(random_event(chance, desk.size))
        desk.wait(FRAME)
        shown = parsed(desk.session.line)
        assert shown.given.values == desk.session.given.values
    desk.close()


def test_l_opens_the_lab_over_the_game_and_esc_comes_back():
    """A game in play pauses."""
    kept = shared()
    kept.lab = _lab_opener(Pymunk)
    assert "L" in [keys for keys, _ in play_help()]
    desk = Desk(kept, Title(kept))
    desk.press(pygame.K_RETURN)
    assert isinstance(desk.screen, Play)
    desk.press(pygame.K_l)
    assert isinstance(desk.screen, Lab)
    desk.press(pygame.K_ESCAPE)
    assert isinstance(desk.screen, Menu)
    desk.close()
