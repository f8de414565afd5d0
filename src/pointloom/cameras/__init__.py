"""Cameras, images, lenses and trajectories."""
