"""Synthetic scenes and images for the demo."""
