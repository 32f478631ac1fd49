"""The translations of the game's texts: a .po file for each language but English."""
