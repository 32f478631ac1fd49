"""What the arcade rules add to the picture: power-ups, their gauges, gravity wells."""
