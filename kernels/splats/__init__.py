"""3D Gaussian splats."""
