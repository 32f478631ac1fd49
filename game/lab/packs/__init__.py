"""Scene packs: one file with scenes that a lecturer hands out, in Python or in TOML. docs/lab.md has an example of each."""
