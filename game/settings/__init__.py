"""The player's settings, the file that holds them, and the keys that change them."""
