"""The lab's formulas as TeX, set by matplotlib's mathtext: no pygame, and matplotlib only when something is set."""
