"""A moving LiDAR: deskewing, scan to map."""
