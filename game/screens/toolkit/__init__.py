"""The items of panels, and of the controls beside lab and editor, for keys, mouse, touch and gamepad."""
