"""The screens of the game: the title, a game, a recorded game, and the panels over them."""
