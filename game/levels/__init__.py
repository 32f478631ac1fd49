"""Levels: the files that come with the game, the player's own, and what reads them."""

from game.level_format.checks import warnings
from game.level_format.specs import BallSpec, DropSpec, Level, LookSpec, PaddleSpec, RingSpec, WellSpec
from game.levels.built_in import built_in, campaign, chosen, classic, from_level, number_of
from game.levels.reading import MAX_FILE_SIZE, checked, draft, first_problem, level_schema, load_file, parse

__all__ = [
    "MAX_FILE_SIZE",
    "BallSpec",
    "DropSpec",
    "Level",
    "LookSpec",
    "PaddleSpec",
    "RingSpec",
    "WellSpec",
    "built_in",
    "campaign",
    "checked",
    "chosen",
    "classic",
    "draft",
    "first_problem",
    "from_level",
    "level_schema",
    "load_file",
    "number_of",
    "parse",
    "warnings",
]
