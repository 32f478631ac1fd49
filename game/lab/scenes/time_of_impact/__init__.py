"""Time of impact: when a moving ball first touches."""
