"""A fixed list of games whose contacts anyone can compare again: the parts, the manifest, and how they are rebuilt."""
