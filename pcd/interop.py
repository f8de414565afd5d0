"""Clouds from and to other libraries."""

from __future__ import annotations

from .selection import Selection


class Interop(Selection):
    """The part of PointCloud that speaks with other libraries."""
