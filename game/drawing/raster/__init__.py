"""Pixels and shapes on a surface: nothing here knows the arena."""
