"""The lab's window: the only part of it that knows pygame."""
