"""The panel of the settings, and the rows of its tabs."""
