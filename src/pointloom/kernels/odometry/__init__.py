"""LiDAR odometry: deskewing, voxel map, scan alignment."""
