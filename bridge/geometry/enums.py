"""Choices under Open3D's names."""

from __future__ import annotations

import enum


class Choice(enum.Enum):
    """A choice whose name, in small letters, is ours."""


class FilterScope(Choice):
    """What a filter of a mesh changes."""

    All, Color, Normal, Vertex = range(4)


class SimplificationContraction(Choice):
    """Where the vertex of a cluster lies."""

    Average, Quadric = range(2)


class DeformAsRigidAsPossibleEnergy(Choice):
    """What a deformation keeps small."""

    Spokes, Smoothed = range(2)


class ImageFilterType(Choice):
    """Filters of images."""

    Gaussian3, Gaussian5, Gaussian7, Sobel3dx, Sobel3dy = range(5)


class VoxelPoolingMode(Choice):
    """What colour a voxel takes from its points."""

    AVG, MIN, MAX, SUM = range(4)
