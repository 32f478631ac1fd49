"""Balls: what they are made of, what acts on them, what they leave behind."""
