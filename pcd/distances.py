"""Distances between clouds and within one."""

from __future__ import annotations

from .selection import Selection


class Distances(Selection):
    """The part of PointCloud that measures distances."""
