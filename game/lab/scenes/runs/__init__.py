"""Scenes that run: several ticks, whole games."""
