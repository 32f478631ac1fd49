"""The game being played: its screen, what it records, and the panels after a level and after a game."""
