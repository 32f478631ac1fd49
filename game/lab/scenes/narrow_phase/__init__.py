"""Narrow phase: case 1, case 2, closest points."""
