"""Points that stand apart from the rest."""

from __future__ import annotations

from .selection import Selection


class Outliers(Selection):
    """The part of PointCloud that removes outliers."""
