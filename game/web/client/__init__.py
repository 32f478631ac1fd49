"""The game's Python in a browser: it decides and draws lists of primitives; the page shows them, listens, and plays samples.

Nothing here needs pygame or numpy.
"""
