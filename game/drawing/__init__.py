"""The picture of a scene: what both views share."""
