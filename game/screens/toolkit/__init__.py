"""What panels, and the controls beside lab and editor, are built from: forms with items, used by every input device."""
