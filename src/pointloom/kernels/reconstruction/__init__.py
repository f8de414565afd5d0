"""Surfaces from points: alpha shapes, ball pivoting, Poisson."""
