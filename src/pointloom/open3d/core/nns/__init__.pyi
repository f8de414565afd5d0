"""The names of `open3d.core.nns`."""

from .search import NearestNeighborSearch as NearestNeighborSearch
