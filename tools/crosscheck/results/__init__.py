"""What was found: measurements, the rows of the table, coverage, and the whole result of a run."""
