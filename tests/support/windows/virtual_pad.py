"""A gamepad that is not there: SDL's virtual joystick, which the game hears as it hears any other."""

import ctypes
from pathlib import Path

import pygame

_GAMEPAD, _AXES, _BUTTONS = 1, 6, 15
_WHERE = ("../pygame_ce.libs/libSDL2-2*", "SDL2.dll", ".dylibs/libSDL2-2*", "../pygame_ce.libs/SDL2.dll")


def library():
    """The SDL that pygame runs on; None where it is not found."""
    found = [path for pattern in _WHERE for path in Path(pygame.__file__).parent.glob(pattern)]
    if not found:
        return None
    sdl = ctypes.CDLL(str(found[0]))
    sdl.SDL_JoystickOpen.restype = sdl.SDL_JoystickFromInstanceID.restype = ctypes.c_void_p
    return sdl


class VirtualPad:
    """Plugged in from the beginning. Buttons and axes are pygame.CONTROLLER_*."""

    def __init__(self, sdl):
        self._sdl = sdl
        self._index = sdl.SDL_JoystickAttachVirtual(_GAMEPAD, _AXES, _BUTTONS, 0)
        assert self._index >= 0
        self._joystick = ctypes.c_void_p(sdl.SDL_JoystickOpen(self._index))
        for trigger in (pygame.CONTROLLER_AXIS_TRIGGERLEFT, pygame.CONTROLLER_AXIS_TRIGGERRIGHT):
            self.push(trigger, -1.0)

    def press(self, button):
        """Hold a button down."""
        self._sdl.SDL_JoystickSetVirtualButton(self._joystick, button, 1)

    def release(self, button):
        """Let a button go."""
        self._sdl.SDL_JoystickSetVirtualButton(self._joystick, button, 0)

    def push(self, axis, share):
        """Move an axis to -1.0 to 1.0; a trigger that is let go is at -1.0."""
        self._sdl.SDL_JoystickSetVirtualAxis(self._joystick, axis, ctypes.c_int16(round(share * 32767)))

    def pull_out(self):
        """Take it away; nothing happens if it is gone already."""
        if self._joystick:
            self._sdl.SDL_JoystickClose(self._joystick)
            self._sdl.SDL_JoystickDetachVirtual(self._index)
            self._joystick = None
