"""Words and numbers over the picture."""
