"""Functions of the player's own, under the source's names: their file runs in a child process, which is asked from here."""
