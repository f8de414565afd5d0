"""Comparison of two surfaces: Chamfer distance, Hausdorff distance, F-score, error map."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.arrays.concatenation import concatenate_points
from ...kernels.arrays.side_by_side import read_together
from ...kernels.extent.distance_sums import DistanceSums
from ...kernels.meshes.surface_samples import SurfaceSamples
from ...kernels.rays.surface_hausdorff import (
    FarthestSearch,
    distances_to,
    root_mean_square,
    search_farthest,
    sum_squares,
)
from ...kernels.rays.triangle_tree import TriangleTree, trees_over

if TYPE_CHECKING:
    pass

UNREACHED = "mesh2: has no finite triangle, or lies 1.8e19 m away or farther"
CLOSE = 1e-5  # of the meshes' size: precision of the Hausdorff bounds


class SurfaceMetrics(NamedTuple):
    """Distances between two surfaces.

    Attributes:
        chamfer: Sum of the mean distances in both directions [m].
        hausdorff, hausdorff_bound: Maximum distance that a point has, and its upper bound [m].
        fscore: Harmonic mean of the percentages of surface within each radius, 0..100, float64.
        mean, rms, max: Distances in each direction [m].
    """

    chamfer: float
    hausdorff: float
    fscore: NDArray[np.float64]
    hausdorff_bound: float
    mean: tuple[float, float]
    rms: tuple[float, float]
    max: tuple[float, float]


class _OneWay(NamedTuple):
    """Distances from one surface to another; `within` in percent."""

    mean: float
    rms: float
    within: NDArray[np.float64]
    least: float
    most: float


class _Measured:
    """Device measurements from one surface to another; `arrays` are to be downloaded."""

    def __init__(
        self,
        mesh: Any,
        other: Any,
        tree: TriangleTree,
        surface: SurfaceSamples,
        radii: list[float],
        count: int,
        seed: int,
    ) -> None:
        if not tree.count:
            raise ValueError(UNREACHED)
        self._count, shift = count, (mesh.origin, other.origin)
        cloud = mesh._draw(surface, count, False, seed)
        sampled = distances_to(points_about(cloud._device_arrays["points"], *shift), tree)
        self._sums = DistanceSums(sampled, radii)
        vertices = points_about(mesh._device_arrays["vertices"], *shift)
        size = float(np.max(tree.high.astype(np.float64) - tree.low))
        triangles, known = mesh._device_arrays["triangles"], self._sums.largest
        self.farthest = FarthestSearch(vertices, triangles, tree, known, CLOSE * size)
        self.arrays = [self._sums.buffer, sum_squares(sampled), self.farthest.known]

    def check(self, whole: NDArray[Any]) -> None:
        if self._sums.unpack(whole)[0] < self._count:
            raise ValueError(UNREACHED)

    def told(self, whole: NDArray[Any], squares: NDArray[Any], bounds: tuple[float, float]) -> _OneWay:
        _, total, _, within = self._sums.unpack(whole)
        count = self._count
        return _OneWay(total / count, root_mean_square(squares, count), 100 * within / count, *bounds)


def measure_both_ways(one: Any, two: Any, radii: list[float], count: int, seed: int) -> tuple[_OneWay, _OneWay]:
    """Distances in both directions. Three syncs, rarely more."""
    meshes = [(mesh._device_arrays["vertices"], mesh._device_arrays["triangles"]) for mesh in (one, two)]
    surfaces = [SurfaceSamples(*mesh) for mesh in meshes]
    trees, doubled = trees_over(meshes, [surface.doubled_area for surface in surfaces])  # sync
    for surface, found in zip(surfaces, doubled, strict=True):
        surface.area = surface.area_of(found)
    ways = []
    for mesh, other, surface, tree in ((one, two, surfaces[0], trees[1]), (two, one, surfaces[1], trees[0])):
        mesh._check_surface(surface, "compute_metrics")
        ways.append(_Measured(mesh, other, tree, surface, radii, count, seed))
    found = read_together([array for way in ways for array in way.arrays])  # sync
    parts = list(zip(found[::3], found[1::3], strict=True))
    for way, (whole, _) in zip(ways, parts, strict=True):
        way.check(whole)
    bounds = search_farthest([way.farthest for way in ways], found[2::3])  # sync
    there, back = (way.told(*part, bound) for way, part, bound in zip(ways, parts, bounds, strict=True))
    return there, back


def points_about(points: wp.array, origin: NDArray[np.float64], target: NDArray[np.float64]) -> wp.array:
    shift = origin - target
    return concatenate_points([points], [shift]) if shift.any() else points
