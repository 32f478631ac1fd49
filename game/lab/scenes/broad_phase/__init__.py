"""Broad phase: which obstacle, which sector."""
