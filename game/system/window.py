"""Opening a window, and saying so when there is nothing to open it on."""

import os

import pygame

from game.system.errors import EnvironmentMissingError
from game.system.quiet_stderr import quiet_libraries

START_SIZE = (1280, 800)
_INVISIBLE = ("offscreen", "dummy", "evdev")
"""Drivers that SDL falls back to without a word, and that show nothing."""


_BARS = (0.12, 96)
"""Of the desktop's height, a share or so many pixels, whichever is more, may go to task bars and the window's own title bar."""
_SIDES = 0.04
"""Of the desktop's width, this share is left free."""


def open_window(title: str, size: tuple[int, int] | None = None, position: tuple[int, int] | None = None) -> pygame.Window:
    """A resizable window in the display's own pixels; EnvironmentMissingError where nobody could see it.

    size: that it had in the last session; None for the first one, which gets one that fits between the desktop's bars.
    position: that it had then; used where the whole window is on a desktop there.
    An invisible driver is fine if SDL_VIDEODRIVER asks for it by name, as tests do.
    """
    os.environ.setdefault("SDL_WINDOWS_DPI_AWARENESS", "permonitorv2")
    os.environ.setdefault("SDL_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR", "0")
    try:
        with quiet_libraries():
            pygame.display.init()
    except pygame.error as error:
        raise EnvironmentMissingError(f"no display: {error}; use --headless") from None
    driver = pygame.display.get_driver()
    if driver in _INVISIBLE and os.environ.get("SDL_VIDEODRIVER") != driver:
        pygame.display.quit()
        raise EnvironmentMissingError("no display found: set DISPLAY or WAYLAND_DISPLAY, or use --headless")
    if driver == "x11":  # measured: 0.4 ms a picture by shared memory, 12 ms by OpenGL where that is done in software
        os.environ.setdefault("SDL_FRAMEBUFFER_ACCELERATION", "0")
    try:
        fitting = _fitting(size)
        window = pygame.Window(title, fitting, resizable=True, allow_high_dpi=True)
        if position is not None and size is not None and _is_on_desktop(position, fitting):
            window.position = position
        window.get_surface()
    except pygame.error as error:
        pygame.display.quit()
        raise EnvironmentMissingError(f"cannot open a window: {error}; use --headless") from None
    return window


def refresh_rate() -> int:
    """Pictures per second worth drawing."""
    rates = [rate for rate in pygame.display.get_desktop_refresh_rates() if rate > 0]
    return min(max(rates, default=60), 240)


def _fitting(size: tuple[int, int] | None) -> tuple[int, int]:
    """The size, or less where the desktop is smaller; of the first window, so much less that all bars have room."""
    desktops = pygame.display.get_desktop_sizes()
    width, height = size or START_SIZE
    if not desktops:
        return width, height
    wide, tall = desktops[0]
    if size is None:
        return min(width, round(wide * (1.0 - _SIDES))), min(height, tall - max(round(tall * _BARS[0]), _BARS[1]))
    return min(width, wide), min(height, tall)


def _is_on_desktop(position: tuple[int, int], size: tuple[int, int]) -> bool:
    """Whether a window would be on the first desktop as a whole."""
    desktops = pygame.display.get_desktop_sizes()
    if not desktops:
        return False
    (left, top), (width, height), (wide, tall) = position, size, desktops[0]
    return left >= 0 and top >= 0 and left + width <= wide and top + height <= tall
