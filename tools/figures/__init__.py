"""The figures of the documentation, drawn from the numbers that the physics computes."""
