"""The palettes that levels are drawn in, each with a version for the dark and for the light theme.

A palette replaces the arena's colours of a theme; text and panels keep theirs. Within a palette the bricks' hues are close
together, and the paddles' is far from them. `tests/game/drawing/test_palette.py` holds every palette to the rules of `palette`.
"""

from functools import cache
from typing import NamedTuple

from game.drawing.palette import DARK, LIGHT, Colour, Theme

CLASSIC = "classic"
"""The palette of the themes themselves."""


class _ArenaColours(NamedTuple):
    """A palette's colours for one theme, in hexadecimal and parted by blanks.

    plain: background, ground, ground_line, rim, accent, paddle, paddle_top, trail; layers: as in `Theme`.
    """

    plain: str
    layers: str


_PALETTES: dict[str, tuple[_ArenaColours, _ArenaColours]] = {
    "ember": (
        _ArenaColours(
            "100504 230e0a 3b1f1a a6593e fbca59 069898 2cd9d9 d28948",
            "ca2135 db3a29 ec5117 f27003 f88c0a fca91d fac74e ffe286 fdfcf3",
        ),
        _ArenaColours(
            "e7dbd9 fcf5f3 f0e3e0 ac6c55 725504 076767 018f8f ac6621",
            "e95b09 dd4409 ce2e08 bc1a08 a80807 900610 760518 5c0412 0d0304",
        ),
    ),
    "ocean": (
        _ArenaColours(
            "000a11 001823 012c3d 017994 f6ce5a b57f26 f7ba5e 07acb2",
            "1f69bd 077ebe 0391c0 08a5c3 02bac9 32cfcf 6ce3d4 99f7dd f5fffa",
        ),
        _ArenaColours(
            "d1e1e9 eff9fe d8e9f3 0788a4 6e5703 7f5404 ad7506 06858a",
            "3f8be6 0381ca 0375a2 056883 035b6b 014e54 004142 00322f 000806",
        ),
    ),
    "forest": (
        _ArenaColours(
            "020b06 031a0f 112e20 2b7e4f f7ce5a c3773e ffb583 7fa754",
            "037a36 0c8b27 409a2a 65a92b 89b741 abc759 cbd875 e9eb95 fdfcf3",
        ),
        _ArenaColours(
            "d7e1db f2f9f5 dee9e3 4a8961 6e5703 924901 be6b2a 5c822e",
            "019f48 008f2c 0e7f03 2c6e02 345d00 344e01 303f01 282f00 060601",
        ),
    ),
    "violet": (
        _ArenaColours(
            "0a0514 190e2a 2d1f43 815aba edcf58 079b79 54d9b2 bf85cc",
            "6751d9 895ae4 aa64ec cb6ff1 e781ed ff96e9 ffbae0 fedbe3 fefbfb",
        ),
        _ArenaColours(
            "e0dbea f8f5fe e8e3f3 8b6dbc 695803 056951 089171 9a61a7",
            "8676fe 8a5ef0 8b48d8 8a32bf 8619a5 7c0285 6b0161 560042 0b0406",
        ),
    ),
    "ice": (
        _ArenaColours(
            "05090d 0c161e 1c2934 3c7594 ffc96a cc6e67 feb1a9 14a8ca",
            "436aa2 487ab0 4e8cbe 559ecc 67b1d6 7cc5df 94daeb b2effb f5feff",
        ),
        _ArenaColours(
            "dadfe3 f4f7fa e1e7ec 53829d 765303 99403c c6625c 00829e",
            "618bc9 4b7eb7 3371a6 186495 00587e 014b68 023e50 00303b 00070a",
        ),
    ),
    "gold": (
        _ArenaColours(
            "0c0703 1c1306 312515 8a692d eed059 1293c0 69d0fe bd9435",
            "b04905 bc5c00 c87007 d58400 db9c35 e4b357 edcb77 fae49a fefcf3",
        ),
        _ArenaColours(
            "e2ddd7 f9f6f2 ebe5de 937848 695803 056484 008ab6 967102",
            "c8760a c25f0a b94909 ad3509 9e2408 8b1607 740d06 5c0705 0d0303",
        ),
    ),
    "dusk": (
        _ArenaColours(
            "10050a 220c19 3a1c2d a05388 ffc865 02979d 2ad8e0 c882c1",
            "5059d7 825ee0 af64e0 d96bd9 f97cc7 ff9db8 febebc ffdcd1 fefbf9",
        ),
        _ArenaColours(
            "e6dae0 fcf4f8 efe2e9 a76792 765201 05676b 0b8e93 a25f9c",
            "6e7cff 8162ed 8c4ad0 9231af 92138b 870161 73013b 5c011d 0c0403",
        ),
    ),
}
"""For every palette but the classic one, its colours for the dark and for the light theme."""
NAMES = (CLASSIC, *_PALETTES)
"""The names of all palettes."""


@cache
def themed(theme: Theme, palette: str) -> Theme:
    """A theme with a level's palette; one whose bricks have colours for a purpose, as it is. palette: one of `NAMES`."""
    base = next((base for base in (DARK, LIGHT) if base.layers == theme.layers), None)
    if palette == CLASSIC or base is None:
        return theme
    own = _PALETTES[palette][0 if base is DARK else 1]
    background, ground, line, rim, accent, paddle, paddle_top, trail = [_colour(digits) for digits in own.plain.split()]
    layers = tuple([_colour(digits) for digits in own.layers.split()])
    if theme.background == base.background:  # and not that of a card which the arena is drawn on
        theme = theme._replace(background=background)
    theme = theme._replace(ground=ground, ground_line=line, rim=rim, accent=accent)
    return theme._replace(paddle=paddle, paddle_top=paddle_top, trail=trail, layers=layers)


def _colour(digits: str) -> Colour:
    """A colour of six hexadecimal digits."""
    red, green, blue = bytes.fromhex(digits)
    return red, green, blue
