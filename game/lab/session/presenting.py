"""The text of a lecture room."""

TEXT_SCALES = (1.5, 2.0, 2.75, 3.0)
"""Sizes of the text in a lecture room, in that of the window's; the third is that of 24 points on a slide."""
DEFAULT_SCALE = TEXT_SCALES.index(2.75)
