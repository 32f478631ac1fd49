"""Pictures as values: flat lists of primitives in pixels, for any painter that can fill discs, sectors and polygons.

A browser's canvas paints them. Nothing here needs pygame or numpy. `primitives` documents every primitive.
"""
