"""The game: rules, levels, replays and the autopilot know no pygame; screens, drawing and controls do."""
