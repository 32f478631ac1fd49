"""Programs that check and measure the game and its physics from outside."""
