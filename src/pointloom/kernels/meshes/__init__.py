"""Triangle meshes: normals, adjacency, measures."""
