"""Rays, distances and occupancy of triangles."""
