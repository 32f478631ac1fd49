"""A gamepad, the sounds and the music of the page, in a real browser."""

import numpy as np
import pytest

from game.sound.music.loops import composed
from game.sound.music.score import Layer
from tests.support.web_page import PAD

LOUDEST = """seconds => new Promise(done => {
  const { context, output } = polarBreakout.speaker, analyser = new AnalyserNode(context, { fftSize: 32768 });
  output.connect(analyser);
  const samples = new Float32Array(analyser.fftSize), until = performance.now() + 1000 * seconds;
  let loudest = 0;
  const look = () => {
    analyser.getFloatTimeDomainData(samples);
    for (const sample of samples) loudest = Math.max(loudest, Math.abs(sample));
    performance.now() < until ? setTimeout(look, 100) : done(loudest);
  };
  look();
})"""
"""The largest amplitude of all that is heard in some seconds."""
MIXED = """async number => {
  const { archived, undifferenced, unzipped } = await import('./archives.js'), { mixed } = await import('./music.js');
  const files = archived(await unzipped('music.packed'));
  const index = JSON.parse(new TextDecoder().decode(files.get('index')));
  const loop = await mixed(index.layers[number], undifferenced(files.get(`${number}`)));
  return [loop.sampleRate, ...[0, 1].map((ear) => Array.from(loop.getChannelData(ear).subarray(0, 2 * loop.sampleRate)))];
}"""
"""A layer as the page mixes it: samples per second, and those of the left and the right ear in the first two seconds."""


def test_a_gamepad_steers_serves_and_pauses(page):
    """The left stick takes a paddle along, A serves, the menu button pauses."""
    page.tab.evaluate(PAD)
    page.go("classic/1")
    before = page.standing()["paddle"]
    page.tab.evaluate("pad.axes[0] = 0.9")
    page.wait(lambda: page.standing()["paddle"] != before, page.standing)
    page.tab.evaluate("pad.axes[0] = 0")
    page.tab.evaluate("pad.buttons[0].value = 1")
    page.wait(lambda: page.standing()["phase"] == "PLAYING", page.standing)
    page.tab.evaluate("pad.buttons[0].value = 0")
    page.frames(2)
    page.tab.evaluate("pad.buttons[9].value = 1")
    page.wait(lambda: page.title() == "Paused")
    page.tab.evaluate("pad.buttons[9].value = 0")


def test_a_gamepad_alone_leads_through_the_menus(page):
    """The directional pad goes from control to control and changes values, A uses the focused control, B goes back."""
    page.tab.evaluate(PAD)

    def press(button):
        for value in (1, 0):
            page.tab.evaluate(f"pad.buttons[{button}].value = {value}")
            page.frames(2)

    press(13)
    press(0)
    page.wait(lambda: page.title() == "Levels")
    press(15)
    page.wait(lambda: page.tab.input_value("#item-difficulty") == "hard")
    press(14)
    press(1)
    page.wait(lambda: page.title() == "Polar Breakout")
    press(0)
    page.wait(lambda: page.standing().get("phase") == "SERVING")


def test_after_a_key_sounds_and_music_are_heard(page):
    """The context runs: the music's pad is heard before the serve, the bricks with the music off, and nothing without sound."""
    page.go("classic/1")
    page.tab.keyboard.press("ArrowRight")
    page.wait(lambda: page.tab.evaluate("polarBreakout.speaker.context?.state") == "running")
    page.wait(lambda: page.tab.evaluate(LOUDEST, 0.5) > 0.001)
    page.tab.keyboard.press("m")
    page.wait(lambda: page.tab.evaluate(LOUDEST, 0.5) == pytest.approx(0.0, abs=1e-6))
    page.tab.keyboard.press("m")
    with_music(page, "0")
    page.go("classic/1")
    page.use("pause")
    page.use("autopilot")
    page.use("go-on")
    page.wait(lambda: page.tab.evaluate(LOUDEST, 0.5) > 0.01)
    page.to_title()
    with_music(page, "60")


def with_music(page, volume):
    """Set the music's volume, from any screen."""
    page.to_title()
    page.use("settings")
    page.tab.fill("#item-music", volume)
    page.tab.keyboard.press("Tab")
    page.use("back")


@pytest.mark.parametrize("layer", [Layer.PAD, Layer.ARPEGGIO, Layer.DRUMS])
def test_a_layer_is_mixed_as_on_the_desktop(page, layer):
    """Both ears, and what rings on from the end of the loop: what is left of the difference is the samples' few bits."""
    rate, *ears = page.tab.evaluate(MIXED, int(layer))
    *_, loop = composed(layer, int(rate))
    expected = loop[:, : 2 * int(rate)]
    apart = np.array(ears) - expected
    assert np.sqrt(np.mean(apart**2)) < 0.05 * np.sqrt(np.mean(expected**2))


def test_a_key_released_while_ctrl_is_down_is_released(page):
    """The paddles come to rest: shortcuts of the browser are left to it, but no key stays down for them."""
    page.use("play")
    page.wait(lambda: page.standing().get("phase") == "SERVING")
    keyboard = page.tab.keyboard
    keyboard.down("ArrowLeft")
    page.frames(3)
    keyboard.down("Control")
    keyboard.up("ArrowLeft")
    keyboard.up("Control")
    page.frames(30)
    before = page.standing()["paddle"]
    page.frames(5)
    assert page.standing()["paddle"] == before
