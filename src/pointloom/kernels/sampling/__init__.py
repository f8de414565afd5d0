"""Downsampling: voxels, farthest points, duplicates."""
