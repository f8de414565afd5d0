"""Planes in a cloud."""

from __future__ import annotations

from .selection import Selection


class Planes(Selection):
    """The part of PointCloud that finds planes."""
