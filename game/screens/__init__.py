"""What can be on the screen: the title, a game, a recorded game, and panels over them."""
