"""The loop: events in, ticks due, one picture out."""
