"""Descriptors of points, and their matching."""
