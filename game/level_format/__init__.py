"""The level file: which keys it has (`specs`), and which levels can be played (`checks`)."""
