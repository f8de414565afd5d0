"""Made-up scenes with known truth: the room, a street, a figure, a stretch of country."""
