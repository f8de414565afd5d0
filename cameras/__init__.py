"""Cameras, their images and lenses, and the paths that they take."""
