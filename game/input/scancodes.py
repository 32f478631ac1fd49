"""Keys by number: where they are (scancodes), and what is written on them (codes), as SDL counts both.

A *position* is SDL's scancode, which is the number of USB's keyboard page; browsers have names for the same positions. A *code*
is the character on a key, or for a key without one its position with `NAMED_KEY` set.
"""

import string
from collections.abc import Mapping
from itertools import chain


def _numbered(first: int, names: str) -> dict[str, int]:
    """Numbers for names, one after the other."""
    return {name: first + number for number, name in enumerate(names.split())}


SCANCODES: Mapping[str, int] = {
    **_numbered(4, " ".join([f"Key{letter}" for letter in string.ascii_uppercase])),
    **_numbered(30, " ".join([f"Digit{digit}" for digit in "1234567890"])),
    **_numbered(40, "Enter Escape Backspace Tab Space Minus Equal BracketLeft BracketRight Backslash"),
    **_numbered(51, "Semicolon Quote Backquote Comma Period Slash CapsLock F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12"),
    **_numbered(70, "PrintScreen ScrollLock Pause Insert Home PageUp Delete End PageDown"),
    **_numbered(79, "ArrowRight ArrowLeft ArrowDown ArrowUp NumLock"),
    **_numbered(84, "NumpadDivide NumpadMultiply NumpadSubtract NumpadAdd NumpadEnter"),
    **_numbered(89, " ".join([f"Numpad{digit}" for digit in "1234567890"])),
    **_numbered(99, "NumpadDecimal IntlBackslash"),
    **_numbered(135, "IntlRo KanaMode IntlYen"),
    **_numbered(224, "ControlLeft ShiftLeft AltLeft MetaLeft ControlRight ShiftRight AltRight MetaRight"),
}
"""Positions by the browsers' names for them (`KeyboardEvent.code`)."""

US_CODES: Mapping[int, int] = {
    **{SCANCODES[f"Key{letter}"]: ord(letter.lower()) for letter in string.ascii_uppercase},
    **{SCANCODES[f"Digit{digit}"]: ord(digit) for digit in string.digits},
    **dict(zip(range(SCANCODES["Minus"], SCANCODES["Backslash"] + 1), map(ord, "-=[]\\"), strict=True)),
    **dict(zip(range(SCANCODES["Semicolon"], SCANCODES["Slash"] + 1), map(ord, ";'`,./"), strict=True)),
}
"""Position to code of the keys with a character, on the US layout."""

_CONTROLS = {"Enter": "\r", "Escape": "\x1b", "Backspace": "\b", "Tab": "\t", "Space": " ", "Delete": "\x7f"}
CONTROL_CODES: Mapping[int, int] = {SCANCODES[name]: ord(character) for name, character in _CONTROLS.items()}
"""Position to code of the keys whose codes are below those of characters: the same on all layouts."""

NAMED_KEY = 1 << 30
"""Set in the code of a key without a character; the rest of such a code is the key's position."""


def code_at(position: int, layout: Mapping[int, int] = {}) -> int:
    """The code of the key at a position. layout: codes of the keys with a character; without it no key has one."""
    return CONTROL_CODES.get(position) or layout.get(position, position | NAMED_KEY)


def position_of(code: int) -> int:
    """Where the US layout has a code; 0 where that is not known."""
    if code & NAMED_KEY:
        return code & ~NAMED_KEY
    known = chain(CONTROL_CODES.items(), US_CODES.items())
    return next((position for position, written in known if written == code), 0)
