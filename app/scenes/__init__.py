"""Made-up scenes with known truth: the room."""
