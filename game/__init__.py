"""The game: rules, levels, replays and the autopilot know no pygame; screens, drawing and controls do."""

VERSION = "0.1.0"
"""Of the game as a whole; a replay names the one that made it."""
