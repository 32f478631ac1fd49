"""Recorded games: their file, watching and verifying them, and the history of games played."""
