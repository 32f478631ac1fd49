"""Deliberate mistakes in the game's own code. A harness that cannot find them finds nothing."""
