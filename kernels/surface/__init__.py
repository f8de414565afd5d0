"""The surface that points lie on: normals, covariances, orientation, smoothing."""
