"""What the game keeps from one session to the next in the user's data folder: scores, progress, finished games, the window."""
