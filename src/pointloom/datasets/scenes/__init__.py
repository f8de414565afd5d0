"""Synthetic scenes with ground truth: room, street, figure, landscape."""
