"""Normals oriented to the concave side of the surface, independent of the pose of the cloud.

The mean of a wider neighborhood is on the concave side (the sign rule of Tombari, Salti and Di Stefano 2010). On a
plane the sign is random, which does not affect features.
"""

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..algebra.eigen import largest_entry, smallest_eigenvector, sorted_eigenvalues
from ..algebra.moments import add_rounded_difference, covariance_of, moments
from ..array_types import Points, Vectors
from ..arrays.select import gather_rows, positions_of_each
from ..extent.masks import mask_finite
from ..lang import NAN, array, float64, kernel, launch, tid, vec3, vec3d
from ..memory import contiguous, download, full
from ..search.bucket_walk import points_within
from ..search.point_tree import BUCKET, PointTree, trees_of
from ..search.tree_search import squared_radius

MIN_NEIGHBORS = 5.0  # neighbors, including the point, that determine a surface
SAMPLE_POINTS = 64
MIN_VARIANCE_RATIO = 1.0e-3  # ratio of variances below which they are collinear, and the plane is arbitrary


@kernel(max_registers=128)
def find_sides_kernel(tree: PointTree, narrow: float, wide: float, normals: array(dtype=vec3)):
    """Normal of each narrow neighborhood, oriented to the mean of the wide one."""
    i = tid()
    p = tree.points[i]
    total = moments(0.0)
    middle = vec3d(0.0, 0.0, 0.0)
    for j, sqdist in points_within(i // BUCKET, p, wide, tree):
        q = tree.points[j]
        middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))
        if sqdist <= narrow:
            total = add_rounded_difference(total, p, q)
    n = vec3(NAN, NAN, NAN)
    if total[0] >= float64(MIN_NEIGHBORS):
        covariance = covariance_of(total)
        size = largest_entry(covariance)
        if size > 0.0:
            values = sorted_eigenvalues(covariance * (1.0 / size))
            if values[1] > float64(MIN_VARIANCE_RATIO) * values[2]:
                v = smallest_eigenvector(covariance)
                if v[0] * middle[0] + v[1] * middle[1] + v[2] * middle[2] < 0.0:
                    v = -v
                n = vec3(float(v[0]), float(v[1]), float(v[2]))
    normals[tree.order[i]] = n


def find_sides(tree: PointTree, narrow: float, wide: float) -> Vectors:
    """Unit normals on the concave side, from a plane fit within `narrow` and the mean within `wide` [m], or NaN."""
    normals = full(tree.source.size, vec3(NAN, NAN, NAN), vec3, tree.device)
    launch(find_sides_kernel, tree.count, [tree, squared_radius(narrow), squared_radius(wide), normals])
    return normals


class Surface:
    """Points with valid normals: `points`, `normals` (vec3, in the cloud's order, no NaN), and their `tree`."""

    @classmethod
    def select_each(cls, clouds: Sequence[Points], narrow: Sequence[float], wide: Sequence[float]) -> "list[Surface]":
        """Select the points of device arrays of vec3. Radii [m] as of `find_sides`, by array. Three syncs for all."""
        normals = list(map(find_sides, trees_of(clouds), narrow, wide))  # sync
        rows = positions_of_each(*(mask_finite(vectors, 1, 1) for vectors in normals))  # sync
        points = [gather_rows(values, chosen) for values, chosen in zip(clouds, rows, strict=True)]
        normals = [gather_rows(values, chosen) for values, chosen in zip(normals, rows, strict=True)]
        return [cls(*parts) for parts in zip(points, normals, trees_of(points), strict=True)]  # sync

    def __init__(self, points: Points, normals: Vectors, tree: PointTree | None = None) -> None:
        self.points, self.normals = points, normals
        self.tree, self.device = PointTree(points) if tree is None else tree, points.device

    def __len__(self) -> int:
        return self.points.size

    @cached_property
    def sample(self) -> NDArray[np.float64]:
        """About SAMPLE_POINTS of the points, to compare poses in meters, float64 (p, 3). One sync, the first time."""
        some = self.points[:: max(1, len(self) // SAMPLE_POINTS)]
        return download(contiguous(some)).astype(np.float64)  # sync
