"""Pictures of scenes as PNG, SVG and GIF, and arenas as levels."""

import io
import re
from xml.etree import ElementTree as ET

import pygame
import pytest
from matplotlib.mathtext import MathTextParser
from PIL import Image

from game.drawing.palette import LIGHT
from game.drawing.text import Type
from game.lab.export import files
from game.lab.export.files import file_of
from game.lab.export.slide import SLIDE_SIZE, SlideStyle, slide_of
from game.lab.export.svg import svg_of
from game.lab.registry import scenes
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.reveal import Reveal
from game.lab.session.session import opened
from game.lab.session.share import parsed
from game.lab.typeset.mathtext import set_line
from game.lab.typeset.tex import has_symbols, tex_line
from game.lab.window import saving
from game.lab.window.screen import SHOWN
from game.lab.window.view import letters_for
from game.levels import load_file
from tests.support.command_line import polar
from tests.support.windows.lab_desk import LabDesk

pytestmark = pytest.mark.deep

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def style():
    """Slides at a quarter of their size."""
    pygame.font.init()
    return SlideStyle((SLIDE_SIZE[0] // 4, SLIDE_SIZE[1] // 4), LIGHT, letters_for(Type()), SHOWN)


def exported(style, line, kind, step=None):
    """A scene's file."""
    session = opened(parsed(line))
    return file_of(kind, style, session, Reveal(step), PanZoom.whole(session.scene, session.given))


def document(data):
    """An SVG file as a tree."""
    return ET.fromstring(data)  # noqa: S314  # written a moment ago


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_every_scene_is_an_svg_of_the_same_shapes(style, scene, monkeypatch):
    """The document is XML of the slide's size with the title, a clip for each pane, and no number that is not finite."""
    monkeypatch.setattr("game.lab.drawing.formula_type.can_typeset", lambda: False)  # plain text takes a tenth of the time
    text = exported(style._replace(letters=letters_for(Type())), scene.name, "svg").decode()
    root = document(text)
    assert root.get("viewBox") == "0 0 640 480"
    assert re.search(r"\b(nan|inf)\b", re.sub(r">[^<]*<", "><", text)) is None
    assert scene.title in {element.text for element in root.iter(f"{SVG}text")}
    assert len(list(root.iter(f"{SVG}clipPath"))) == len(opened(parsed(scene.name)).picture.panes)


def test_a_step_is_exported_as_it_is_shown(style):
    """At step 4 of the response the picture has Δv in it and not yet its parts; PNG and SVG have the same size."""
    text = exported(style, "moving-surface", "svg", 4).decode()
    titles = [element.text for element in document(text).iter(f"{SVG}title")]
    assert "Δv" in titles
    assert "Δv_n" not in titles
    assert "4 of 9: Δv, the relative velocity" in titles
    png = pygame.image.load(io.BytesIO(exported(style, "moving-surface", "png", 4)), "a.png")
    assert png.get_size() == (640, 480)


def test_a_formula_of_the_svg_lies_where_the_picture_has_it(style):
    """The outline of a label, as its transformation puts it, fills the box of the painted one to two pixels."""
    session = opened(parsed("moving-surface"))
    slide = slide_of(style, session.scene, session.picture, PanZoom())
    boxes = {label.text: label.box for label in slide.panes[0].labels}
    checked = 0
    for group in document(svg_of(slide, style.letters.labels.sets)).iter(f"{SVG}g"):
        title, path = group.find(f"{SVG}title"), group.find(f"{SVG}path")
        if title is not None and title.text in boxes:
            x, y, across, up = map(float, re.findall(r"-?[\d.]+", path.get("transform")))
            numbers = [float(number) for number in re.findall(r"-?[\d.]+", path.get("d"))]
            rows, columns = [y + up * number for number in numbers[1::2]], [x + across * number for number in numbers[::2]]
            box = boxes[title.text].inflate(4, 4)
            assert box.top <= min(rows) <= max(rows) <= box.bottom, title.text
            assert box.left <= min(columns) <= max(columns) <= box.right, title.text
            checked += 1
    assert checked >= 10


def test_a_gif_has_a_frame_for_each_step_or_shows_the_run(style, monkeypatch):
    """A picture of nine steps is nine frames; a scene that runs is shown from its start to its end."""
    monkeypatch.setattr(files, "_FRAMES", 6)
    steps = Image.open(io.BytesIO(exported(style, "moving-surface", "gif")))
    assert steps.n_frames == 9
    assert steps.info["duration"] == 1500
    assert Image.open(io.BytesIO(exported(style, "game-over-once", "gif"))).n_frames == 6


def test_every_formula_of_every_scene_can_be_set():
    """No line of any scene is more than mathtext can set: it would fall back to plain text."""
    found = {
        re.sub(r"\d+(\.\d+)?", "1", line): line for scene in scenes() for line in opened(parsed(scene.name)).picture.formula
    }
    parser = MathTextParser("path")
    assert all([parser.parse(tex_line(line)).width > 0.0 for line in found.values()])


@pytest.mark.parametrize(
    ("line", "tex"),
    [
        ("v_res", r"$\mathbf{v}_{\mathrm{res}}$"),
        ("Δv'_n = -2 Δv_n", "$\\Delta \\mathbf{v}\\prime _{n}=\\mathrm{\u2013}2\\,\\Delta \\mathbf{v}_{n}$"),
        ("v_0 v_res / |v_res|", r"${v}_{0}\,\dfrac{\mathbf{v}_{\mathrm{res}}}{|\mathbf{v}_{\mathrm{res}}|}$"),
        ("(p - A) · (B - A) / |B - A|²", r"$\dfrac{(\mathbf{p}-{A})\cdot ({B}-{A})}{|{B}-{A}|^2}$"),
        ("2 π / n", r"$2\,\dfrac{{\pi}}{{n}}$"),
        ("sqrt(v_0² - u²)", r"$\sqrt{{v}_{0}^2-{u}^2}$"),
        ("10 rad/s", r"$10\ \mathrm{rad/s}$"),
        ("q", r"$\hat{\mathbf{q}}$"),
        ("a corner", r"$\mathrm{a}\ \mathrm{corner}$"),
    ],
)
def test_a_formula_becomes_tex(line, tex):
    """Vectors are bold, words upright, what is divided stands above what divides it; v_0 and a count n are no vectors."""
    assert tex_line(line) == tex
    assert has_symbols(line) == (line not in {"10 rad/s", "a corner"})


def test_only_numbers_are_set_anew_when_only_numbers_change():
    """Two lines that differ in a number have the same height and baseline: nothing jumps while something is dragged."""
    one, other = (set_line(f"Δv · n = {number}", 24.0) for number in ("-9.37", "-9.38"))
    assert one.baseline == other.baseline
    assert one.shades.shape[0] == other.shades.shape[0]
    before = one.shades.shape[1] - 15  # the last digit's columns
    assert (one.shades[:, :before] == other.shades[:, :before]).all()


def test_without_matplotlib_formulas_are_plain_text_and_a_gif_says_what_is_missing(style, monkeypatch):
    """The frozen application has neither matplotlib nor Pillow: it writes the other pictures all the same."""
    monkeypatch.setattr("game.lab.drawing.formula_type.can_typeset", lambda: False)
    monkeypatch.setattr(files, "can_animate", lambda: False)
    plain = style._replace(letters=letters_for(Type()))
    words = [element.text for element in document(exported(plain, "case-2", "svg")).iter(f"{SVG}text")]
    assert "A" in words
    session = opened(parsed("case-2"))
    said = saving.saved_picture("gif", plain, session, Reveal(), PanZoom())
    assert said == "a GIF needs Pillow: pip install pillow"


def test_the_command_writes_the_scene_and_its_steps(tmp_path, capsys):
    """`--export` makes the folder, writes a file for the scene and with --steps one for each step, and says how many."""
    folder = tmp_path / "slides"
    code, out, err = polar(capsys, "lab", "closest-point", "--export", str(folder), "--format", "svg", "--steps")
    assert (code, err) == (0, "")
    assert out == f"4 pictures in {folder}\n"
    names = sorted([path.name for path in folder.iterdir()])
    assert names == [*[f"closest-point-{step}.svg" for step in (1, 2, 3)], "closest-point.svg"]
    (tmp_path / "file").write_text("")
    code, _, err = polar(capsys, "lab", "closest-point", "--export", str(tmp_path / "file"))
    assert code == 2
    assert re.fullmatch(r"polar-breakout: --export [^\n]+: cannot be written; [^\n]+\n", err)


def test_an_arena_of_ones_own_is_saved_as_a_level_that_the_game_plays_and_opened_again(tmp_path, monkeypatch, capsys):
    """W writes a level file that the game loads; --arena opens it; a refused arena says which rule it breaks."""
    monkeypatch.setattr(saving, "own_levels_folder", lambda: tmp_path)
    desk = LabDesk("own-arena?r_1=5.5&l_1=3&n_2=0")
    said = saving.saved_level(desk.session)
    path = tmp_path / "my-arena.toml"
    assert said == f"saved: python -m game --level {path}"
    level = load_file(path)
    assert [(ring.radius, ring.layers, ring.count) for ring in level.rings] == [(5.5, 3, 12)]
    desk.close()
    code, _, err = polar(capsys, "lab", "--arena", str(path), "--headless", "--drags", "0")
    assert (code, err) == (0, "")
    refused = saving.saved_level(opened(parsed("own-arena?r_1=11")))
    assert refused.startswith("no level yet: rings[0].radius: reaches to 11.5")
    assert saving.saved_level(opened(parsed("case-2"))) == "only the scene own-arena is saved as a level"
