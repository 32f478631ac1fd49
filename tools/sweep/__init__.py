"""Levels played many times, with other paddles, frictions and speeds: a table for who balances a level."""
