"""How hard the levels are for a human: simulated players play them, and what they lose is counted."""
