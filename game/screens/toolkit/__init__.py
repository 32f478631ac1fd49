"""What panels, and the sides of lab and editor, are made of: items that are used by keys, mouse, touch and gamepad alike."""
