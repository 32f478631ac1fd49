"""Pictures to take home: a scene and its formula at the size of a slide, as PNG, SVG or GIF."""
