"""Triangles found in space: by rays, by distance, by other triangles, by voxels."""
