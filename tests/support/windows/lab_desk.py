"""A desk with the lab on it: its window on the dummy driver, and hands that work it."""

from typing import NamedTuple

import pygame

from game.input.actions import Action
from game.input.signals import Pressed, Released, pad_position
from game.lab.session import session
from game.lab.session.share import parsed
from game.lab.window.layout import layout_of, pane_areas
from game.lab.window.screen import Lab
from game.loop.app import frame
from tests.support.windows.dummy_window import FRAME, Desk, shared
from tools.crosscheck.second_engine import Pymunk

SIZE = (1000, 700)


class Slid(NamedTuple):
    """Where a slider is, in pixels, and its item."""

    item: object
    bar: pygame.Rect
    field: pygame.Rect
    knob: tuple[int, int]


class LabDesk(Desk):
    """A desk with the lab on it."""

    def __init__(self, line="case-2", size=SIZE):
        app = shared()
        super().__init__(app, None, size)
        named = parsed(line, Pymunk())
        self.screen = Lab(app, session.opened(named), step=named.step)
        self.size = size
        self.wait(FRAME)

    @property
    def session(self):
        """How the scene stands."""
        return self.screen.session

    @property
    def values(self):
        """What the scene is given."""
        return self.session.given

    def wait_once(self, seconds):
        """Let one picture take so many seconds."""
        self.screen = frame(self.window, self.shared, self.screen, seconds, self._keyboard)

    def pixel(self, world, pane=0):
        """The pixel of a point of the world."""
        areas = pane_areas(layout_of(self.size), len(self.session.picture.panes))
        pixel = self.screen._pan_zoom.camera(self.session.scene.view_box, areas[pane]).project(world)
        return round(pixel.real), round(pixel.imag)

    def drag(self, start, end, button=1):
        """Press, move, release, at pixels."""
        pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=start, rel=(0, 0), buttons=(0, 0, 0)))
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=start, button=button))
        middle = ((start[0] + end[0]) // 2, (start[1] + end[1]) // 2)
        for pixel in (middle, end):
            held = tuple([int(button == one) for one in (1, 2, 3)])
            pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=pixel, rel=(0, 0), buttons=held))
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=end, button=button))
        self.wait(2 * FRAME)

    def wheel(self, pixel, steps):
        """Turn the wheel over a pixel."""
        pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=pixel, rel=(0, 0), buttons=(0, 0, 0)))
        pygame.event.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=steps, precise_x=0.0, precise_y=float(steps)))
        self.wait(FRAME)

    @property
    def side(self):
        """The controls as they are now."""
        return self.screen._controls(self.size)

    def positioned(self, label):
        """The control that says something, and its box; of a point's two sliders the x."""
        return next(
            positioned
            for positioned in self.side._form_layout(self.size).items
            if getattr(positioned.item, "label", None) == label
        )

    def slider(self, name, coordinate=0):
        """The slider of a number: its item, its bar and its field's box, and the pixel of its knob."""
        items = [
            positioned
            for positioned in self.side._form_layout(self.size).items
            if getattr(positioned.item, "label", None) == name
        ]
        item, box, unit = items[coordinate].item, items[coordinate].box, self.side.unit(self.size)
        bar = item.bar(box, unit)
        return Slid(item, bar, item.field_box(box, unit), (round(bar.left + bar.width * item.level), bar.centery))

    def type_into(self, name, text, coordinate=0, end=pygame.K_RETURN):
        """Click a number's field, which selects what is in it, type and press Return."""
        self.click(self.slider(name, coordinate).field.center)
        for letter in text:
            key = pygame.key.key_code(letter) if letter.isalnum() else pygame.K_PERIOD
            pygame.event.post(pygame.Event(pygame.KEYDOWN, key=key, mod=0, unicode=letter))
            pygame.event.post(pygame.Event(pygame.TEXTINPUT, text=letter))
        pygame.event.post(pygame.Event(pygame.KEYDOWN, key=end, mod=0, unicode="\r"))
        self.wait(FRAME)

    def click(self, place):
        """Press and release."""
        for kind in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            pygame.event.post(pygame.Event(kind, pos=place, button=1))
        self.wait(FRAME)

    def click_on(self, label):
        """Click in the middle of the control that says something."""
        self.click(self.positioned(label).box.center)

    def pad(self, *actions, held=False):
        """Press a gamepad's buttons that mean some actions, and release them unless they are held."""
        for action in actions:
            position = pad_position(0, list(Action).index(action))
            for signal in (Pressed(action, position), Released(action, position))[: 1 if held else 2]:
                if self.screen is not None:
                    self.screen = self.screen.answer(signal, self.size)
