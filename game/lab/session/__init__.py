"""A scene in use: its state, its claims, its share line, saved cases."""
