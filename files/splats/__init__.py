"""3D Gaussian splats from and to files."""
