"""The ground: its colours, its patterns, its picture."""
