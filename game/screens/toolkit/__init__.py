"""What all panels of the game are made of: items that are used by keys, mouse, touch and gamepad alike."""
