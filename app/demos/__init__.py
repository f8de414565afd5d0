"""Demos that measure themselves against the truth."""
