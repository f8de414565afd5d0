"""Arithmetic of arrays of any shape: elementwise functions with broadcasting, and reductions along an axis."""
