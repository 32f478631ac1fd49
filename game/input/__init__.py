"""What the player does: keys, pointer, and the camera position that they control."""
