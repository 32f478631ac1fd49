"""The translations of the game's texts, compared with the texts."""
