"""The app on the dummy driver, played with a gamepad that is not there."""

from types import MappingProxyType

import pygame
import pytest

from tests.support.windows.dummy_window import FRAME, Desk
from tests.support.windows.virtual_pad import VirtualPad, library


class PadDesk(Desk):
    """The app, played with a gamepad alone: what would be a key press is a button."""

    BUTTONS = MappingProxyType(
        {
            pygame.K_RETURN: pygame.CONTROLLER_BUTTON_A,
            pygame.K_SPACE: pygame.CONTROLLER_BUTTON_A,
            pygame.K_ESCAPE: pygame.CONTROLLER_BUTTON_B,
            pygame.K_p: pygame.CONTROLLER_BUTTON_START,
            pygame.K_g: pygame.CONTROLLER_BUTTON_X,
            pygame.K_h: pygame.CONTROLLER_BUTTON_BACK,
            pygame.K_TAB: pygame.CONTROLLER_BUTTON_Y,
            pygame.K_COMMA: pygame.CONTROLLER_BUTTON_LEFTSHOULDER,
            pygame.K_PERIOD: pygame.CONTROLLER_BUTTON_RIGHTSHOULDER,
            pygame.K_LEFT: pygame.CONTROLLER_BUTTON_DPAD_LEFT,
            pygame.K_RIGHT: pygame.CONTROLLER_BUTTON_DPAD_RIGHT,
            pygame.K_UP: pygame.CONTROLLER_BUTTON_DPAD_UP,
            pygame.K_DOWN: pygame.CONTROLLER_BUTTON_DPAD_DOWN,
        }
    )

    def __init__(self, state, screen, size):
        if library() is None:
            pytest.skip("no SDL library to plug a virtual gamepad into")
        super().__init__(state, screen, size)
        state.devices.pads.listen()
        self.pad = VirtualPad(library())
        self.wait(4 * FRAME)

    def press(self, *keys, mod=0):
        """Press and release the buttons that do what keys do."""
        assert not mod
        for key in keys:
            for act in (self.pad.press, self.pad.release):
                act(self.BUTTONS[key])
                self.wait(FRAME)

    def close(self):
        """Pull the gamepad out, and take the window away."""
        self.pad.pull_out()
        self.shared.devices.pads.close()
        super().close()
