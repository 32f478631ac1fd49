"""The ground: its colours, its dimensions, its patterns, and the lists of primitives that they make."""
