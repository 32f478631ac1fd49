"""When the display goes away under the game: on X11 the library below ends the whole program unless it is told not to."""

import ctypes
import os
from collections.abc import Callable

import pygame

EXIT_CODE = 3
_BAD_DRAWABLE = 9


class _Error(ctypes.Structure):
    """The beginning of Xlib's XErrorEvent."""

    _fields_ = (
        ("type", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("resource", ctypes.c_ulong),
        ("serial", ctypes.c_ulong),
        ("code", ctypes.c_ubyte),
    )


_ON_LOSS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)
_ON_ERROR = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.POINTER(_Error))


def on_display_lost(last_words: Callable[[], None]) -> object:
    """Have `last_words` called before the program ends with exit code 3 because its X server, or its window there, is gone.

    Nothing is left to go back to by then: Xlib ends the program when its handler returns, so this does it first. The result
    must be kept for as long as there is a window. Other systems report a lost display as an error, or close the window.
    """
    if pygame.display.get_driver() != "x11":
        return None
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return None

    def lost(_display: int | None) -> int:
        try:
            last_words()
        finally:
            os._exit(EXIT_CODE)

    def failed(display: int | None, error: "ctypes._Pointer[_Error]") -> int:
        return lost(display) if error.contents.code == _BAD_DRAWABLE else 0  # without the window there is nothing to draw on

    handlers = _ON_LOSS(lost), _ON_ERROR(failed)
    x11.XSetIOErrorHandler(handlers[0])
    x11.XSetErrorHandler(handlers[1])
    return handlers
