"""What a run says: terminal, JSON, page."""
