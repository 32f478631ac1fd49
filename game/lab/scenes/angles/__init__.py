"""Angles: polar coordinates, differences, sides."""
