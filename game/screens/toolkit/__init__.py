"""What all panels of the game, and the lab's side, are made of: items that are used by keys, mouse, touch and gamepad alike."""
