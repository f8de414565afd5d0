"""Groups of points that lie close together."""

from __future__ import annotations

from .selection import Selection


class Clusters(Selection):
    """The part of PointCloud that finds clusters."""
