"""A moving LiDAR: deskewing, the map of voxels, scans against it."""
