"""Rings and bounces in pymunk, made from numbers alone: imports nothing of the project."""
