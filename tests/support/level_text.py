"""A small level as a file's text, to be changed by tests."""

GOOD = b"""
name = "Test"
ground_radius = 10.0
[ball]
radius = 0.25
speed = 9.0
[paddles]
radius = 9.0
half_width = 0.2
half_angle = 20.0
top_speed = 50.0
acceleration = 400.0
[[rings]]
radius = 3.0
half_width = 0.4
half_angle = 10.0
count = 12
"""


def changed(old: str, new: str) -> bytes:
    """The good level with one thing changed."""
    assert GOOD.decode().count(old) == 1, old
    return GOOD.decode().replace(old, new).encode()
