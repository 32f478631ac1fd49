"""A label divided into runs of letters of one style, for canvases: v_p is a bold v, then a small lowered p."""

from functools import lru_cache

from game.lab.typeset.tex import has_symbols, symbol_of, tokens_of

UPRIGHT, SLANTED, BOLD, INDEX, WORD_INDEX, PRIME = "\x10\x11\x12\x13\x14\x15"
"""The sign at the beginning of a run, for its style; the last three are small: two lowered, one raised."""
_MOST_LABELS = 512
_SIGNS = {"-": "\u2212"}
_HAT = "\u0302"


@lru_cache(maxsize=_MOST_LABELS)
def runs(label: str) -> str:
    """A label with a variable as runs, each after the sign of its style; any other label unchanged."""
    if not has_symbols(label):
        return label
    found, before, words = "", "", False
    for token in tokens_of(label):
        if token.kind == "symbol":
            found += _symbol(token.text, before)
        else:
            found += ("" if words else UPRIGHT) + _SIGNS.get(token.text, token.text)
        words = token.kind != "symbol"
        before = token.text if token.kind != "space" else before
    return found


def _symbol(text: str, before: str) -> str:
    """The runs of a variable."""
    letter, is_vector, is_change, primes, index = symbol_of(text, before)
    hat = _HAT if is_vector and letter == "q" else ""
    base = f"{BOLD if is_vector else SLANTED}{letter}{hat}"
    prime = f"{PRIME}{chr(0x2032) * primes}" if primes else ""
    below = f"{INDEX if len(index) == 1 else WORD_INDEX}{index}" if index else ""
    return (f"{UPRIGHT}Δ" if is_change else "") + base + prime + below
