"""Rendering: points, lines and triangles in a z-buffer, shading, text."""
