"""Sounds: made, chosen, mixed."""
