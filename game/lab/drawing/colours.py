"""The theme's colour for each role of a mark, and for words of that role."""

from functools import cache

from game.drawing.palette import Colour, Theme, contrast, mixed
from game.lab.kit.picture import Role

_READABLE = 4.5
"""Contrast ratio of text, by WCAG 2."""


def role_colour(theme: Theme, role: Role) -> Colour:
    """The colour of marks of a role."""
    return {
        Role.PLAIN: theme.text,
        Role.FAINT: mixed(theme.ground, theme.faint, 0.6),
        Role.BALL: theme.ball,
        Role.GHOST: theme.faint,
        Role.SECTOR: theme.paddle,
        Role.OTHER: mixed(theme.paddle, theme.ground, 0.55),
        Role.OURS: theme.accent,
        Role.SOURCE: theme.danger,
        Role.PYMUNK: theme.layers[2],
        Role.GOOD: theme.paddle_top,
        Role.ONE: theme.layers[0],
        Role.TWO: theme.layers[3],
        Role.THREE: theme.layers[1],
        Role.FOUR: theme.layers[5],
        Role.GUESS: theme.trail,
    }[role]


@cache
def text_colour(theme: Theme, role: Role) -> Colour:
    """The colour of words of a role: the role's own, mixed with that of text until it can be read on the ground."""
    own = role_colour(theme, role)
    shades = [mixed(own, theme.text, share / 8.0) for share in range(9)]
    return next(shade for shade in shades if contrast(shade, theme.ground) >= _READABLE)
