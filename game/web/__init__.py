"""The game in a browser: what a web host serves, and how it is made (docs/web.md)."""
