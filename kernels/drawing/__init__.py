"""Pictures: points, lines and triangles in a z-buffer, their light and colour, text."""
