"""Triangle searches: rays, distances, intersections, voxels."""
