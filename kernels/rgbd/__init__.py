"""Depth and colour frames: their pyramids, and what brings one onto another."""
