"""A number that is typed into the editor's panel, key by key."""

from typing import NamedTuple

import pygame

_CHARACTERS = "0123456789.-"
_LONGEST = 12


class Typing(NamedTuple):
    """What a key has made of a number that is typed.

    text: as it stands; None: the typing has ended. value: of a number that Enter has taken. used: whether the key was for the
    number.
    """

    text: str | None
    value: float | None = None
    used: bool = True


def typed_after(text: str, event: pygame.Event) -> Typing:
    """The typing after a key. Enter takes the number, Esc drops it, and so does a key that is not for numbers."""
    if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER):
        return Typing(None, _value(text))
    if event.key == pygame.K_ESCAPE:
        return Typing(None)
    if event.key == pygame.K_BACKSPACE:
        return Typing(text[:-1])
    character = getattr(event, "unicode", "")
    if character and character in _CHARACTERS:
        return Typing((text + character)[:_LONGEST])
    return Typing(None, used=False)


def _value(text: str) -> float | None:
    """The number of a text; None where it is none."""
    try:
        return float(text)
    except ValueError:
        return None
