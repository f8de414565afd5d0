"""Depth and color images."""
