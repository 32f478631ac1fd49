"""When the display goes away under the game: on X11 the library below ends the whole program unless it is told not to."""

import ctypes
import os
from collections.abc import Callable

import pygame

_HANDLER = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)
EXIT_CODE = 3


def on_display_lost(last_words: Callable[[], None]) -> object:
    """Have `last_words` called before the program ends with exit code 3 because its X server is gone.

    Nothing is left to go back to by then: Xlib ends the program when its handler returns, so this does it first. The result
    must be kept for as long as there is a window. Other systems report a lost display as an error, or close the window.
    """
    if pygame.display.get_driver() != "x11":
        return None
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return None

    def handler(_display: int | None) -> int:
        try:
            last_words()
        finally:
            os._exit(EXIT_CODE)

    kept = _HANDLER(handler)
    x11.XSetIOErrorHandler(kept)
    return kept
