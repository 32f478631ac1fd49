"""What the player does: keys, pointer, and the view they steer."""
