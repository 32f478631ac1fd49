"""The game: rules, levels, replays and the autopilot know no pygame; screens, drawing and controls do."""

import os

VERSION = "0.1.0"
"""Of the game as a whole; a replay names the one that made it."""

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # stdout is for the game's own lines
