"""Convex hulls and the points that a camera sees."""

from __future__ import annotations

from .selection import Selection


class Hulls(Selection):
    """The part of PointCloud that deals with convex hulls."""
