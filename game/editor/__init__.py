"""The level editor: a level file's text is changed key by key, so that its comments and its order stay."""
