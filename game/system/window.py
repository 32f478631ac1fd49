"""Opening a window, and saying so when there is nothing to open it on."""

import os

import pygame

from game.system.errors import EnvironmentMissingError
from game.system.quiet_stderr import quiet_libraries

START_SIZE = (1280, 800)
_INVISIBLE = ("offscreen", "dummy", "evdev")
"""Drivers that SDL falls back to without a word, and that show nothing."""


def open_window(title: str, size: tuple[int, int] = START_SIZE) -> pygame.Window:
    """A resizable window in the display's own pixels; EnvironmentMissingError where nobody could see it.

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
        window = pygame.Window(title, _fitting(size), resizable=True, allow_high_dpi=True)
        window.get_surface()
    except pygame.error as error:
        pygame.display.quit()
        raise EnvironmentMissingError(f"cannot open a window: {error}; use --headless") from None
    return window


def refresh_rate() -> int:
    """Pictures per second worth drawing."""
    rates = [rate for rate in pygame.display.get_desktop_refresh_rates() if rate > 0]
    return min(max(rates, default=60), 240)


def _fitting(size: tuple[int, int]) -> tuple[int, int]:
    """The size, or less where the desktop is smaller."""
    desktops = pygame.display.get_desktop_sizes()
    if not desktops:
        return size
    return min(size[0], desktops[0][0]), min(size[1], desktops[0][1])
