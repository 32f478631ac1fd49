"""What things cost: a tick, a frame, a start, memory."""
