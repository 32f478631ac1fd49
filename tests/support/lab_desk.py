"""A desk with the lab on it: its window on the dummy driver, and hands that work it."""

import pygame

from game.app import frame
from game.lab.session import session
from game.lab.session.share import parsed
from game.lab.window.layout import layout_of, pane_areas
from game.lab.window.screen import Lab
from tests.support.dummy_window import FRAME, Desk, shared
from tools.crosscheck.second_engine import Pymunk

SIZE = (1000, 700)


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
            pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=pixel, rel=(0, 0), buttons=(1, 0, 0)))
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=end, button=button))
        self.wait(2 * FRAME)

    def wheel(self, pixel, steps):
        """Turn the wheel over a pixel."""
        pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=pixel, rel=(0, 0), buttons=(0, 0, 0)))
        pygame.event.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=steps, precise_x=0.0, precise_y=float(steps)))
        self.wait(FRAME)

    def row(self, name, coordinate=0):
        """The slider and field of a number."""
        return next(
            row for row in self.screen._widgets(self.size)._rows if (row.parameter.name, row.coordinate) == (name, coordinate)
        )

    def type_into(self, field, text):
        """Click a field, clear it, type and press Return."""
        pixel = field.rect.center
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=pixel, button=1))
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=pixel, button=1))
        self.wait(FRAME)
        field.set_text("")
        for letter in text:
            key = pygame.key.key_code(letter) if letter.isalnum() else pygame.K_PERIOD
            pygame.event.post(pygame.Event(pygame.KEYDOWN, key=key, mod=0, unicode=letter))
            pygame.event.post(pygame.Event(pygame.TEXTINPUT, text=letter))
        self.wait(FRAME)
        pygame.event.post(pygame.Event(pygame.KEYDOWN, key=pygame.K_RETURN, mod=0, unicode="\r"))
        self.wait(3 * FRAME)

    def click_on(self, button):
        """Click in the middle of a widget."""
        pixel = button.rect.center
        button.hovered = True
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=pixel, button=1))
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=pixel, button=1))
        self.wait(3 * FRAME)
