"""The source's functions over whole boxes of inputs: how far their floats can be from their formulas."""
