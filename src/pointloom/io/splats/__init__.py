"""Read and write 3D Gaussian splats."""
