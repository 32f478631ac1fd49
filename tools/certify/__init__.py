"""Proofs in ball arithmetic: every impact and every free flight of a game, from the exact values of its floats."""
