"""Terrain grids with fixed cells: ground, and rasters."""
