"""Hostile files, hostile surroundings, signals and kills: what the program does when it is treated badly."""
