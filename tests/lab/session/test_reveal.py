"""Scenes are revealed step by step; what is drawn by hand before a step is judged by a number."""

from itertools import combinations, pairwise

import pygame
import pytest

from game.drawing.palette import DARK
from game.drawing.text import Type
from game.lab.drawing.labels import placed_labels
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import defaults
from game.lab.kit.picture import Arrow, Prediction
from game.lab.kit.scene import picture_of, started
from game.lab.registry import chapters, scene_named, scenes
from game.lab.session import reveal
from game.lab.session.checks import lines
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.presenting import TEXT_SCALES
from game.lab.session.reveal import Reveal
from game.lab.window.dragging import drag_at
from game.lab.window.layout import layout_of
from game.lab.window.screen import SHOWN
from game.lab.window.view import letters_for, pane_canvas, pane_views
from game.lab.window.words import TextSheet
from tests.support.windows.dummy_window import FRAME
from tests.support.windows.lab_desk import LabDesk
from tools.crosscheck.second_engine import Pymunk

IN_CHAPTERS = ("angles", "broad phase", "narrow phase", "response", "time of impact")
IN_STEPS = [scene for name in IN_CHAPTERS for scene in chapters()[name]]
NAMES = ["v", "v_p", "Δv", "Δv_n", "Δv_t", "Δv'_n", "Δv'_t", "v_res", "v after"]
MAY_SHOW_NOTHING = {"inside-material", "impact-resting", "two-bricks"}
"""Where there is nothing to push out, to meet or to hit, a step says so by being empty."""


def seen(picture):
    """What a picture consists of: the marks of each pane, and its lines."""
    return [pane.marks for pane in picture.panes], picture.formula


@pytest.mark.parametrize("scene", IN_STEPS, ids=lambda scene: scene.name)
def test_every_step_adds_to_the_ones_before_and_the_last_is_the_whole_picture(scene):
    """At the defaults and every preset: each step begins with what the step before showed, and shows something new."""
    for given in lines(scene):
        picture = picture_of(scene, given, started(scene, given))
        pictures = [picture.revealed(count) for count in range(1, len(picture.steps) + 1)]
        assert len(pictures) >= 3
        assert pictures[-1] == picture
        for before, after in pairwise([seen(one) for one in pictures]):
            for less, more in zip([*before[0], before[1]], [*after[0], after[1]], strict=True):
                assert more[: len(less)] == less
            assert before != after or scene.name in MAY_SHOW_NOTHING
        assert len({step.name for step in picture.steps}) == len(picture.steps)


@pytest.mark.parametrize(("name", "vectors"), [("moving-surface", 9), ("response-paddle", 9), ("response-wall", 9)])
def test_the_response_is_built_vector_by_vector_as_on_the_slides(name, vectors):
    """v, v_p, Δv, its two parts, Δv'_n, Δv'_t, v_res and the final v appear in this order, each drawn and each in a formula."""
    scene = scene_named(name)
    picture = picture_of(scene, defaults(scene.parameters), None)
    arrows = [mark.label for step in picture.steps[1:] for mark in step.marks[0] if isinstance(mark, Arrow)]
    assert [label for label in arrows if label in NAMES][:vectors] == NAMES
    for step, begins in zip(
        picture.steps[1:9], ("v =", "v_p", "Δv =", "Δv · n", "Δv'_n", "Δv'_t", "v_res", "v :="), strict=True
    ):
        assert begins in step.formula[0]


@pytest.mark.parametrize(("name", "scale"), [("moving-surface", 0.4), ("response-paddle", 0.28), ("response-wall", 0.34)])
def test_the_numbers_in_a_formula_are_the_vector_that_is_drawn(name, scale):
    """At every preset each step writes the coordinates of every arrow that it draws; v and its two changes add up to v_res."""
    scene = scene_named(name)
    for given in lines(scene):
        picture = picture_of(scene, given, None)
        arrows = {}
        for step in [step for step in picture.steps[1:] if step.formula]:
            drawn = [mark for mark in step.marks[0] if isinstance(mark, Arrow) and mark.label in NAMES]
            arrows |= {mark.label: mark for mark in drawn}
            written = " ".join(step.formula)
            assert all([two_decimals(mark.vector / scale) in written or "= 0" in written for mark in drawn]), written
        if "Δv'_n" in arrows:
            v, bounce, friction = (arrows[label] for label in ("v", "Δv'_n", "Δv'_t"))
            assert abs(v.start + v.vector - bounce.start) < 1e-9
            assert abs(bounce.start + bounce.vector - friction.start) < 1e-9
            assert abs(arrows["v_res"].start + arrows["v_res"].vector - friction.start - friction.vector) < 1e-9


def test_a_prediction_is_where_its_step_then_draws_the_arrow():
    """Whoever predicts exactly is off by 0; the arrow that is asked for is one that the step shows."""
    for scene in IN_STEPS:
        picture = picture_of(scene, defaults(scene.parameters), started(scene, defaults(scene.parameters)))
        for step in [one for one in picture.steps if one.prediction is not None and one.prediction.start is not None]:
            drawn = [mark.start + mark.vector for mark in step.marks[0] if isinstance(mark, Arrow)]
            assert min([abs(tip - step.prediction.tip) for tip in drawn]) < 1e-9, (scene.name, step.name)
            assert "off by 0.00" in reveal.judgement(step.prediction, step.prediction.tip)


def test_the_error_of_a_prediction_is_in_the_units_of_what_was_asked():
    """An arrow drawn at 0.5 units per unit of speed and two units off is off by a speed of 4."""
    asked = Prediction("v", 1 + 1j, 3 + 1j, 0.5)
    assert reveal.judgement(asked, 1 + 3j) == "Your v is off by 5.66: turned by 90.00°, 1.00 times as long."
    assert reveal.judgement(asked, 5 + 1j) == "Your v is off by 4.00: turned by 0.00°, 2.00 times as long."


def test_space_reveals_and_backspace_takes_back_and_the_share_line_says_the_step():
    """Space begins with the first step and goes on, Backspace goes back; after the last step all is shown; V ends."""
    desk = LabDesk("moving-surface")
    count = len(desk.session.picture.steps)
    desk.press(pygame.K_SPACE)
    assert desk.screen._reveal.seen == 1
    desk.press(*[pygame.K_SPACE] * 3)
    assert desk.screen._line().endswith("&step=4")
    desk.press(pygame.K_BACKSPACE)
    assert desk.screen._reveal.seen == 3
    desk.press(*[pygame.K_SPACE] * (count - 2))
    assert desk.screen._reveal.seen is None
    desk.press(pygame.K_BACKSPACE)
    assert desk.screen._reveal.seen == count - 1
    desk.press(pygame.K_v)
    assert desk.screen._reveal.seen is None
    desk.close()


def test_a_scene_that_runs_waits_until_all_of_it_is_shown():
    """While its steps are revealed its clock stands still; then it runs, and Space pauses it."""
    desk = LabDesk("carried?step=1")
    desk.wait(0.3)
    assert desk.session.tick == 0
    desk.press(pygame.K_SPACE, pygame.K_SPACE, pygame.K_SPACE)
    desk.wait(0.3)
    assert desk.session.tick > 5
    desk.press(pygame.K_SPACE)
    assert not desk.session.playing
    desk.close()


def test_an_answer_is_dragged_and_then_judged():
    """With G, the next step's answer has a handle; Space shows the step, keeps the answer and says how far it is off."""
    desk = LabDesk("moving-surface?step=3")
    desk.press(pygame.K_g, pygame.K_SPACE, pygame.K_SPACE)
    asked = reveal.prediction(desk.screen._reveal, desk.session.picture)
    assert asked.asked == "Δv"
    before = desk.values
    desk.drag(desk.pixel(reveal.guess_tip(desk.screen._reveal, asked)), desk.pixel(asked.tip))
    assert desk.values == before
    assert abs(desk.screen._reveal.guess - asked.tip) < 0.05
    desk.press(pygame.K_SPACE)
    shown = desk.screen._seen()
    assert "your Δv" in [getattr(mark, "label", "") for mark in shown.panes[0].marks]
    assert shown.note.startswith("Your Δv is off by 0.0")
    desk.close()


def test_a_presenters_keys_go_through_steps_and_scenes():
    """While presenting, Page down shows every step, then the whole picture, then the next scene; Page up goes back."""
    desk = LabDesk("case-1")
    desk.press(pygame.K_p)
    steps = len(desk.session.picture.steps)
    desk.press(*[pygame.K_PAGEDOWN] * (steps + 1))
    assert (desk.session.scene.name, desk.screen._reveal.seen) == ("case-2", 1)
    desk.press(pygame.K_PAGEUP)
    assert desk.session.scene.name == "case-1"
    scale = desk.screen._scale
    desk.press(pygame.K_UP, pygame.K_UP)
    assert desk.screen._scale == scale + 1 == len(TEXT_SCALES) - 1
    desk.press(pygame.K_p)
    assert not desk.screen.presents
    desk.close()


def test_a_press_that_misses_a_handle_does_not_move_the_world():
    """Every handle is caught within at least 12 pixels; just beside it nothing is held; far from it the world is."""
    scene = scene_named("moving-surface")
    given = defaults(scene.parameters)
    for size, scale in (((640, 480), None), ((1280, 800), None), ((1920, 1080), 2.75)):
        layout = layout_of(size, scale)
        views = pane_views(layout, scene, picture_of(scene, given, None), PanZoom())
        tip = views[0].camera.project(scene.handles[1].position(given))
        assert drag_at(tip - 12.0, views, given, layout.pen).handle is scene.handles[1]
        assert drag_at(tip - 2.5 * max(1.2 * layout.pen, 12.0) * 0.8, views, given, layout.pen) is None
        assert drag_at(complex(*views[0].area.bottomright) - (5 + 5j), views, given, layout.pen).handle is None


def sheets():
    """The window at two sizes, and a lecture room's screen at two sizes of its text."""
    for size, scale in (((800, 600), None), ((1280, 800), None), ((1920, 1080), 2.75), ((1280, 800), 1.5)):
        layout = layout_of(size, scale)
        yield TextSheet(pygame.Surface(size, 0, 32), layout, DARK, Type())


LETTERS = []


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_no_two_labels_cover_each_other(scene):
    """At the defaults and two presets, at every size, labels are apart and in their pane; at the defaults none is left out."""
    LETTERS[:] = LETTERS or [letters_for(Type())]
    for sheet in sheets():
        lines_of_scene = lines(scene, Pymunk())[:3]
        for given in lines_of_scene:
            picture = picture_of(scene, given, started(scene, given))
            views = pane_views(sheet.layout, scene, picture, PanZoom.whole(scene, given))
            for pane, view in zip(picture.panes, views, strict=True):
                rings = [view.camera.project(handle.position(given)) for handle in view.handles]
                canvas = pane_canvas(sheet, LETTERS[0], view, SHOWN)
                boxes = [label.box for label in placed_labels(canvas, pane.marks, pane.title, rings)]
                assert not [pair for pair in combinations(boxes, 2) if pair[0].colliderect(pair[1])]
                alone = [label for mark in pane.marks for label in placed_labels(canvas, [mark])]
                assert len(boxes) == len(alone) + len(placed_labels(canvas, [], pane.title)) or given is not lines_of_scene[0]
                assert all([view.area.contains(box) for box in boxes])


def test_text_for_a_lecture_room_is_that_of_24_points_on_a_slide():
    """On 1080 lines a slide's 24 points are an em square of 48 pixels: capitals of plain text and of formulas are as high."""
    layout = layout_of((1920, 1080), 2.75)
    letters = letters_for(Type())
    plain = letters.around.words.rendered("H", layout.unit, (255, 255, 255)).get_bounding_rect().height
    formula = letters.around.formulas.rendered("A", layout.unit, (255, 255, 255)).get_bounding_rect().height
    assert plain >= 0.7 * 48
    assert formula >= 0.64 * 48


def test_revealing_survives_a_change_that_takes_steps_away():
    """A bounce that becomes a separation has fewer steps: what is shown is all of them, and nothing fails."""
    desk = LabDesk("moving-surface?step=8")
    assert desk.screen._reveal == Reveal(8)
    desk.type_into("heading", "60")
    desk.type_into("v_p", "0", 1)
    assert desk.screen._reveal.shown(desk.session.picture) == len(desk.session.picture.steps) == 6
    desk.wait(FRAME)
    desk.close()
