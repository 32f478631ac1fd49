"""Recorded games: the file, watching, verifying, the kept ones."""
