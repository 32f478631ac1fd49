"""The editor's window: the arena to paint in, and beside it everything that can be changed."""
