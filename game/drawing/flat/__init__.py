"""The flat view: rings seen from straight above."""
