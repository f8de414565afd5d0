"""Point cloud formats: PLY, PCD, text, NPZ, LAS, E57, KITTI."""
