"""The game on the page, played in a real browser."""

import io
import subprocess
import sys

import numpy as np
import pygame
import pytest

from game.input.view import FLAT, SOLID
from game.levels import classic, parse
from game.rules import TICK, Ruleset, new_game
from game.screenshot import save_screenshot
from tests.support.paths import GOLDEN, ROOT

TOLERANCE = {FLAT: (0.4, 12.0), SOLID: (1.5, 25.0)}
"""Of a picture's mean difference and of its worst block's, of 255."""
SENT = """keys => {
  const post = Worker.prototype.postMessage, sent = [];
  Worker.prototype.postMessage = function (message, ...rest) {
    sent.push(message.request?.signals.filter(signal => signal.type === "key").length ?? 0);
    return post.call(this, message, ...rest);
  };
  for (let k = 0; k < keys; k++) document.getElementById("picture").dispatchEvent(
    new KeyboardEvent(k % 2 ? "keyup" : "keydown", { code: "ArrowLeft", key: "ArrowLeft", bubbles: true }));
  Worker.prototype.postMessage = post;
  return sent;
}"""
"""How many keys were in each message that was sent to the worker before their events had ended."""
SMALL = b"""
name = "Small"
description = "A few bricks."
ground_radius = 10.0
[ball]
radius = 0.3
speed = 12.0
[paddles]
count = 3
radius = 9.0
half_width = 0.2
half_angle = 25.0
top_speed = 60.0
acceleration = 2000.0
[[rings]]
radius = 4.0
half_width = 0.4
half_angle = 25.0
count = 6
layers = [1, 0, 1, 0, 1, 0]
"""


@pytest.mark.parametrize("name", sorted([file.name for file in GOLDEN.glob("*.polar")]))
def test_every_golden_game_has_the_same_hashes(page, name):
    """WebAssembly computes the same bits as every desktop."""
    words = page.ask("verify", f"new Uint8Array(await (await fetch('golden/{name}')).arrayBuffer())")
    assert words.endswith("every hash agrees"), words


def test_a_key_moves_the_paddles(page):
    """The right arrow turns them one way, the left arrow back."""
    page.go("classic/1")
    before = page.standing()
    assert before["level"] == "First Wall"
    assert before["phase"] == "SERVING"
    page.tab.keyboard.down("ArrowRight")
    moved = page.wait(lambda: (now := page.standing())["paddle"] != before["paddle"] and now)
    page.tab.keyboard.up("ArrowRight")
    page.tab.keyboard.down("ArrowLeft")
    page.wait(lambda: (page.standing()["paddle"] - moved["paddle"]) * (moved["paddle"] - before["paddle"]) < 0.0)
    page.tab.keyboard.up("ArrowLeft")


def test_keys_are_sent_at_once_but_no_more_than_three_wait_for_pictures(page):
    """They wait neither for the browser's next frame nor for a picture. The rest is sent later: the last turns the paddles."""
    page.go("classic/1")
    before = page.standing()["paddle"]
    sent = page.tab.evaluate(SENT, 9)
    assert set(sent) == {1}
    assert 2 <= len(sent) <= 3
    page.wait(lambda: abs(page.standing()["paddle"] - before) > 0.1)
    page.tab.evaluate(SENT, 10)


def test_the_mouse_serves_and_the_nearest_paddle_follows_it(page):
    """A click serves; a pointer at the rim takes the paddles along."""
    page.go("classic/1")
    page.tab.mouse.click(640, 400)
    page.wait(lambda: page.standing()["phase"] == "PLAYING", page.standing)
    before = page.standing()["paddle"]
    page.tab.mouse.move(1000, 560)
    page.wait(lambda: page.standing()["paddle"] != before)


def test_a_level_file_is_dropped_and_the_autopilot_wins_it(page):
    """The game is over, won, and its results are there."""
    page.drop("small.toml", SMALL)
    assert page.standing()["level"] == "Small"
    page.use("pause")
    assert page.title() == "Paused"
    page.use("autopilot")
    page.use("go-on")
    page.wait(lambda: page.title() == "You won", page.standing)


def test_a_finished_game_is_kept_and_the_desktop_verifies_its_download(page, tmp_path):
    """Three balls are lost; the replay is watched, verified, downloaded, and it plays again to the same hashes elsewhere."""
    page.go("classic/2")
    page.wait(lambda: page.standing()["tick"] > 5.5 / TICK, page.standing)  # shorter games are not kept
    page.tab.keyboard.down("ArrowRight")
    page.wait(lambda: page.tab.keyboard.press("Space") or page.title() == "Game over", page.standing)
    page.tab.keyboard.up("ArrowRight")
    page.use("watch")
    page.use("verify")
    page.wait(lambda: "every hash agrees" in page.tab.inner_text("#menu"))
    with page.tab.expect_download() as download:
        page.use("download")
    file = tmp_path / "game.polar"
    download.value.save_as(file)
    command = [sys.executable, "-m", "game", "replay", "--verify", str(file)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    page.to_title()
    page.use("replays")
    assert page.tab.locator("[id^='item-replay-']").count() == 1


def test_what_is_stored_outlives_the_page(page):
    """The replay of the test before is there after the page was loaded again, and so is a setting."""
    page.use("settings")
    page.tab.select_option("#item-colours", "light")
    page.frames(2)
    assert page.ask("save") is True
    page.open()
    page.use("settings")
    assert page.tab.input_value("#item-colours") == "light"
    page.tab.select_option("#item-colours", "dark")
    page.frames(2)
    page.use("back")
    page.use("replays")
    assert page.tab.locator("[id^='item-replay-']").count() >= 1


def test_both_views_are_drawn_and_the_tab_pauses_when_it_is_hidden(page):
    """Key 2 tips the camera: the picture is another. A page that is hidden pauses, and loses nothing."""
    page.go("classic/5")
    flat = page.tab.screenshot()
    page.tab.keyboard.press("2")
    page.tab.wait_for_timeout(1500)
    assert page.tab.screenshot() != flat
    page.tab.keyboard.press("1")
    page.tab.keyboard.press("Space")
    page.wait(lambda: page.standing()["phase"] == "PLAYING")
    page.tab.evaluate("polarBreakout.input.add({type: 'away'})")
    page.wait(lambda: page.title() == "Paused")


@pytest.mark.parametrize(
    ("fragment", "words"),
    [
        ("level/99", "expected #level/NUMBER"),
        ("lab/nothing", "no scene 'nothing'"),
        ("lab/case-2?ball=x", "expected two numbers"),
        ("%E0%A4", "broken"),
    ],
)
def test_a_broken_link_is_refused_in_one_line_and_the_rest_works(page, fragment, words):
    """The title stays."""
    page.go(fragment)
    page.wait(lambda: words in page.notification(), page.notification)
    assert page.title() == "Polar Breakout"


@pytest.mark.parametrize(("name", "data"), [("a.polar", b"nothing"), ("a.toml", b"name = 1"), ("a.txt", b"")])
def test_a_broken_file_is_refused_in_one_line(page, name, data):
    """It is named."""
    page.tab.evaluate("document.getElementById('notification').hidden = true")
    page.drop(name, data)
    page.wait(lambda: name in page.notification(), page.notification)
    assert page.title() == "Polar Breakout"


def test_the_keyboard_alone_leads_from_the_title_into_the_game_and_back(page):
    """Arrows move in menus, Enter chooses, Space serves, Escape pauses; what was in focus stays there."""
    assert page.tab.evaluate("document.activeElement.id") == "item-play"
    page.tab.keyboard.press("ArrowDown")
    assert page.tab.evaluate("document.activeElement.id") == "item-levels"
    page.tab.keyboard.press("ArrowUp")
    page.tab.keyboard.press("Enter")
    page.wait(lambda: page.standing().get("phase") == "SERVING")
    assert page.tab.evaluate("document.activeElement.id") == "picture"
    page.tab.keyboard.press("Space")
    page.wait(lambda: page.standing()["phase"] == "PLAYING")
    page.tab.keyboard.press("Escape")
    page.wait(lambda: page.title() == "Paused")
    assert page.tab.evaluate("document.activeElement.id") == "item-go-on"


def test_axe_finds_nothing(page, axe):
    """Title, settings, keys, levels, help, credits, game, pause, lab: every control has a name, and every text can be read."""

    def violations():
        found = page.tab.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
        return [(one["id"], [node["html"][:200] for node in one["nodes"]]) for one in found]

    page.tab.evaluate(axe)
    assert violations() == []
    for items in (("settings", "keys", "key-left-0"), ("levels",), ("help",), ("credits",)):
        for item in items:
            page.use(item)
            assert violations() == [], item
        for _ in items:
            page.use("back")
    page.go("classic/1")
    assert violations() == []
    page.use("pause")
    assert violations() == []
    page.go("lab/case-2")
    assert violations() == []


def blocks(picture):
    """Means over blocks of 8 by 8 pixels: what anti-aliasing does to an edge does not count."""
    pixels = pygame.surfarray.array3d(picture).astype(np.float64)
    width, height = (side // 8 for side in pixels.shape[:2])
    return pixels[: width * 8, : height * 8].reshape(width, 8, height, 8, 3).mean(axis=(1, 3))


@pytest.mark.parametrize(("key", "view", "part"), [("1", FLAT, (440, 200, 400, 400)), ("2", SOLID, (400, 206, 432, 284))])
def test_the_wall_looks_as_on_the_desktop(page, tmp_path, key, view, part):
    """The canvas' picture and pygame's of the same scene, below the notice: mean difference of 255, and of the worst block."""
    page.go("classic/1")
    page.tab.keyboard.press(key)
    page.tab.wait_for_timeout(3000)  # the camera has come, the wall stands, the first waves are gone
    page.frames(2)
    shown = pygame.image.load(io.BytesIO(page.tab.screenshot()))
    save_screenshot(new_game(classic(), 1, Ruleset()), tmp_path / "desktop.png", (1280, 800), view=view)
    desktop = pygame.image.load(tmp_path / "desktop.png")
    apart = np.abs(blocks(shown.subsurface(part)) - blocks(desktop.subsurface(part)))
    page.tab.keyboard.press("1")
    assert apart.mean() < TOLERANCE[view][0]
    assert apart.max() < TOLERANCE[view][1]


def test_the_ground_has_the_desktops_pattern(page, tmp_path):
    """Dots, between the wall and the paddles: the steps from pixel to pixel are pygame's."""
    dotted = SMALL + b'[look]\npalette = "ember"\nground = "dots"\n'
    page.drop("dotted.toml", dotted)
    page.tab.wait_for_timeout(3000)
    page.frames(2)
    shown = pygame.image.load(io.BytesIO(page.tab.screenshot()))
    level = parse(dotted, "dotted.toml")
    save_screenshot(new_game((level,), 1, Ruleset()), tmp_path / "desktop.png", (1280, 800), view=FLAT)
    desktop = pygame.image.load(tmp_path / "desktop.png")
    part = (335, 340, 90, 120)
    steps = [
        np.diff(pygame.surfarray.array3d(picture.subsurface(part)).sum(axis=2, dtype=float), axis=0).ravel()
        for picture in (shown, desktop)
    ]
    assert np.corrcoef(*steps)[0, 1] > 0.6
