"""Clouds without their noise."""

from __future__ import annotations

from .selection import Selection


class Smoothing(Selection):
    """The part of PointCloud that smooths."""
