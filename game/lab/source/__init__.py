"""The source taken literally, for the scenes that compare."""
