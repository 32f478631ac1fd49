"""What the player chose, and where it is kept."""
