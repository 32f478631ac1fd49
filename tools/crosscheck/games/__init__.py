"""The games that are compared."""
