"""The music: a piece of the game's own, in layers that come and go with the play."""
