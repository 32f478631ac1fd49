"""The panels that stand over the title and over a game."""
