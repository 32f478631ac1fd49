"""Pictures of scenes: marks become shapes in pixels, which are painted or written as SVG. Its letters are pygame's."""
