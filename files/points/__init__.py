"""Formats of point clouds: PLY, PCD, text, NPZ, LAS, E57, KITTI."""
