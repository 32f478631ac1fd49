"""The theme of the widgets: the game's colours and font, in the form that pygame_gui takes."""

from pathlib import Path
from typing import Any

import pygame

from game.drawing.palette import Colour, Theme, mixed

_FONT = "lab"
_LETTER, _SYMBOL = 0.69, 0.9
"""Sizes of the widgets' fonts in that of the lab's text: it draws larger than `pygame.font.Font(None)` does."""


def widget_theme(theme: Theme, pixels: int) -> dict[str, Any]:
    """A theme for pygame_gui. pixels: size of body text."""
    colours = _colours(theme)
    font = str(Path(pygame.__file__).parent / pygame.font.get_default_font())

    def share(units: float) -> str:
        return str(max(round(pixels * units), 1))

    flat = {
        "shape": "rounded_rectangle",
        "shape_corner_radius": share(0.25),
        "border_width": share(0.06),
        "shadow_width": "0",
        "text_horiz_alignment_padding": share(0.35),
    }
    letters = {"name": _FONT, "size": share(_LETTER), "regular_path": font, "bold_path": font, "antialiased": "1"}
    symbols = {"name": "fira_code_symbols", "size": share(_SYMBOL)}
    ground = {"dark_bg": _hex(theme.background), "normal_border": _hex(theme.panel_edge)}
    knob = {"normal_bg": _hex(theme.rim), "hovered_bg": _hex(theme.accent), "active_bg": _hex(theme.accent)}
    left = {"text_horiz_alignment": "left", "text_horiz_alignment_padding": share(0.35)}
    slider = {**flat, "sliding_button_width": share(0.9), "enable_arrow_buttons": "0"}
    listed = {**flat, "expand_direction": "down", "open_button_width": share(1.5)}
    return {
        "defaults": {"colours": colours, "font": letters},
        "button": {"misc": flat, "font": letters},
        "label": {"font": letters},
        "drop_down_menu": {"misc": listed, "colours": ground},
        "drop_down_menu.button": {"font": letters},
        "drop_down_menu.#expand_button": {"font": symbols},
        "drop_down_menu.#selected_option": {"misc": left},
        "selection_list": {"misc": {"list_item_height": share(1.7)}},
        "selection_list.button": {"misc": left, "font": letters},
        "horizontal_slider": {"misc": slider},
        "horizontal_slider.#sliding_button": {"misc": flat, "colours": knob},
        "text_entry_line": {"misc": {**flat, "padding": f"{share(0.3)},{share(0.1)}"}, "colours": ground, "font": letters},
        "check_box": {"font": symbols, "misc": {"text_offset": share(0.4)}, "colours": {"normal_bg": _hex(theme.background)}},
        "check_box.label": {"font": letters},
        "tool_tip": {"misc": {"rect_width": share(16.0)}},
        "tool_tip.text_box": {"misc": flat, "colours": {"dark_bg": _hex(theme.panel)}, "font": letters},
    }


def _colours(theme: Theme) -> dict[str, str]:
    """The colours that all widgets share."""
    chosen = mixed(theme.panel, theme.accent, 0.22)
    text, off = _hex(theme.text), _hex(mixed(theme.panel, theme.faint, 0.45))
    return {
        "normal_bg": _hex(theme.panel),
        "hovered_bg": _hex(mixed(theme.panel, theme.panel_edge, 0.35)),
        "disabled_bg": _hex(mixed(theme.panel, theme.background, 0.6)),
        "selected_bg": _hex(chosen),
        "active_bg": _hex(chosen),
        "dark_bg": _hex(theme.background),
        "disabled_dark_bg": _hex(theme.background),
        **dict.fromkeys(("normal_text", "hovered_text", "selected_text", "active_text", "text_cursor"), text),
        "disabled_text": off,
        "normal_border": _hex(theme.panel_edge),
        "hovered_border": _hex(theme.accent),
        "disabled_border": _hex(mixed(theme.panel_edge, theme.background, 0.6)),
        "selected_border": _hex(theme.accent),
        "active_border": _hex(theme.accent),
        "filled_bar": _hex(theme.accent),
        "unfilled_bar": _hex(theme.panel_edge),
    }


def _hex(colour: Colour) -> str:
    """A colour as #rrggbb."""
    return "#{:02x}{:02x}{:02x}".format(*colour)
