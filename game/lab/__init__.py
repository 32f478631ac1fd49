"""The lab: scenes that show one idea of the collision detection each, for a window, for a check and for a picture."""
