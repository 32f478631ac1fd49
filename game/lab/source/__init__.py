"""The source taken literally, for the scenes that compare it with the physics: `from game.lab import source`."""

from game.lab.source.discrete import SourceBall, SourceGame, frame, game_frame
from game.lab.source.ends import end_normal, end_points, end_sign
from physics.source_mode import slides_closest_point_on_line as foot_on_line
from physics.source_mode import slides_normalize_angle as normalize_angle
from physics.source_mode import slides_on_left as on_left
from physics.source_mode import slides_response

__all__ = [
    "SourceBall",
    "SourceGame",
    "end_normal",
    "end_points",
    "end_sign",
    "foot_on_line",
    "frame",
    "game_frame",
    "normalize_angle",
    "on_left",
    "slides_response",
]
