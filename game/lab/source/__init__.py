"""The source taken literally, for the scenes that compare it with the physics: `from game.lab import source`."""

from game.lab.source.discrete import SourceBall, SourceGame, frame, game_frame, normal_at, reset
from game.lab.source.functions import end_normal, end_points, end_sign, foot_on_line, normalize_angle, on_left
from game.lab.source.response_steps import ResponseSteps, response_steps

__all__ = [
    "ResponseSteps",
    "SourceBall",
    "SourceGame",
    "end_normal",
    "end_points",
    "end_sign",
    "foot_on_line",
    "frame",
    "game_frame",
    "normal_at",
    "normalize_angle",
    "on_left",
    "reset",
    "response_steps",
]
