"""The game as a web site."""
