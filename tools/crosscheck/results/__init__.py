"""What was found: rows, cases, findings."""
