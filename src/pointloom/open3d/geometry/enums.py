"""Enumerations under Open3D's names."""

from __future__ import annotations

import enum


class Choice(enum.Enum):
    """An enumeration whose lowercase names are pointloom's values."""


class FilterScope(Choice):
    All, Color, Normal, Vertex = range(4)


class SimplificationContraction(Choice):
    Average, Quadric = range(2)


class DeformAsRigidAsPossibleEnergy(Choice):
    Spokes, Smoothed = range(2)


class ImageFilterType(Choice):
    Gaussian3, Gaussian5, Gaussian7, Sobel3dx, Sobel3dy = range(5)


class VoxelPoolingMode(Choice):
    """Color of a voxel from its points."""

    AVG, MIN, MAX, SUM = range(4)
