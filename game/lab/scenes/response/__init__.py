"""Collision response."""
