"""Sizes of the game's letters, estimated without a font: width of texts, and sizes that change from frame to frame."""

import unicodedata

LINE = 0.75
"""Height of a line in shares of its letters' size."""
_WIDTHS = {
    0.163: "'",
    0.191: " ,./I\\ijl|",
    0.229: "!()-:;[]`ft",
    0.267: "*r{}",
    0.334: 'z"',
    0.382: "#$0123456789J_acekvxys",
    0.401: "+<=>^~",
    0.420: "?FLTZbdhnopqug",
    0.458: "EPSVXY",
    0.496: "&ABCDKNRUH",
    0.534: "OQwG",
    0.572: "M",
    0.611: "%m",
    0.649: "W",
    0.669: "@",
}
"""Widths of letters of pygame's own font, in shares of their size."""
_BY_LETTER = {letter: width for width, letters in _WIDTHS.items() for letter in letters}
_OTHERS = 0.44
"""Estimated width of any other letter."""
_HINTING = 1.04
"""Factor for the widths: those of small letters are rounded to whole pixels, so that small texts are wider."""


def width(words: str) -> float:
    """Width of a text divided by the size of its letters: a few hundredths more than on the screen, never less."""
    plain = [letter for letter in unicodedata.normalize("NFD", words) if not unicodedata.combining(letter)]
    return _HINTING * sum([_BY_LETTER.get(letter, _OTHERS) for letter in plain])


def stepped(size: float) -> float:
    """A size rounded to quarters, for words whose size changes from frame to frame: every size costs a font and a picture."""
    return round(4.0 * size) / 4.0
