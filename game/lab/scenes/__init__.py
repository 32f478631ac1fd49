"""One scene each. A module here with a `SCENE` is found by itself."""
