"""Depth and colour images."""
