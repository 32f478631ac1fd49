"""What is dragged on a form: knobs of sliders, the scroll bar, the body."""

import pytest

from game.input.signals import Clicked, Moved
from game.screens.toolkit.items.slider import Slider
from game.screens.toolkit.layout import Content
from game.screens.toolkit.panel import Panel
from tests.support.windows.dummy_window import shared

SIZE = (640, 400)


class Sliders(Panel):
    """Forty sliders."""

    def __init__(self):
        super().__init__(shared(), None)
        self.levels = [0.5] * 40

    def content(self):
        return Content("Sliders", tuple([(self._slider(index),) for index in range(40)]))

    def _slider(self, index):
        def put(level):
            self.levels[index] = level

        return Slider(str(index), self.levels[index], "", lambda _: None, put)


@pytest.fixture
def sliders():
    """A panel that scrolls."""
    return Sliders()


def bar(panel, index):
    """A slider's bar."""
    positioned = panel._form_layout(SIZE).items[index]
    return positioned.item.bar(positioned.box, panel.unit(SIZE))


def put(panel, *signals):
    """Let it answer."""
    for signal in signals:
        assert panel.answer(signal, SIZE) is panel


def test_a_finger_drags_the_knob_that_it_came_down_on(sliders):
    """It is held wherever the finger goes; the next one, after a tap, holds another; on no knob it scrolls."""
    first, second = (complex(*bar(sliders, index).center) for index in (0, 1))
    put(sliders, Moved(first, held=False), Moved(first + 3.0, held=True), Moved(second + 23.0, held=True))
    assert sliders.levels[0] == pytest.approx(0.5 + 20.0 / bar(sliders, 0).width)
    assert sliders.levels[1] == 0.5
    before = sliders.levels[0]
    put(sliders, Clicked(second), Moved(second, held=False), Moved(second, held=True), Moved(second - 10.0, held=True))
    assert sliders.levels[0] == before
    assert sliders.levels[1] == pytest.approx(0.5 - 10.0 / bar(sliders, 1).width)
    label = complex(sliders._form_layout(SIZE).body.left + 5, second.imag)
    put(sliders, Moved(label, held=False), Moved(label - 20j, held=True), Moved(label - 30j, held=True))
    assert sliders._scroll == 30.0
    assert sliders.levels[2:] == [0.5] * 38


def test_the_scroll_bar_is_held_wherever_the_mouse_goes(sliders):
    """Pressed on the bar and moved away from it sideways, the mouse still scrolls along it."""
    layout = sliders._form_layout(SIZE)
    x = layout.bar - 1
    put(sliders, Clicked(complex(x, layout.body.top + 1)), Moved(complex(x - 200, layout.body.bottom), held=True))
    assert sliders._scroll == layout.over > 0
    put(sliders, Moved(complex(x - 200, layout.body.top), held=True))
    assert sliders._scroll == 0.0
    assert sliders.levels == [0.5] * 40
