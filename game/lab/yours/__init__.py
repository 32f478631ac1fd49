"""The player's own functions in the lab: what a scene asks them, and a pane that shows their answers."""
