"""Pictures of scenes: marks become shapes on the screen, which are painted or written as SVG. It needs pygame for its letters."""
