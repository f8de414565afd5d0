"""Surface estimation: normals, covariances, orientation, smoothing."""
