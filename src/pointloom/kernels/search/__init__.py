"""Bounding-box tree over points, and all its searches."""
