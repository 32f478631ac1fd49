"""A picture of every screen, filled with made-up scores, to be looked at: nothing of the player's is read or written."""
