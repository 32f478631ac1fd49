"""The player's own functions on the page: typed, graded, used in the lab and in the game."""
