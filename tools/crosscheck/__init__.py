"""The same trajectories seen by a second engine: every contact of a game, cross-checked with pymunk's circles and segments."""
