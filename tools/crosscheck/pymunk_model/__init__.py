"""Rings and bounces in pymunk, built from numbers alone: nothing here imports the project's own code."""
