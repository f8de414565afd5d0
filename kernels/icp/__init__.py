"""Poses from nearest points: correspondences, rows, steps, the loop."""
