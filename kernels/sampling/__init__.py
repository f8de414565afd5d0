"""Fewer points: voxels, farthest points, duplicates."""
