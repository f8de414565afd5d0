"""How alike two surfaces are: Chamfer distance, Hausdorff distance, F-score, and a picture of the error."""

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
CLOSE = 1e-5  # of the meshes' size: how far the bounds of a Hausdorff distance may be apart


class SurfaceMetrics(NamedTuple):
    """Distances between two surfaces; `chamfer`, `hausdorff` and `fscore` stand as in a cloud's metrics.

    Attributes:
        chamfer: The mean distance from each surface to the other, the two added [m].
        hausdorff: The largest distance from a point of either surface to the other one [m]: some point has it.
        fscore: For each radius, the harmonic mean of the percentages of either surface that have the other one within
            the radius; 0..100, float64.
        hausdorff_bound: What no point's distance exceeds [m].
        mean: The mean distances [m] from the first surface to the second, and back.
        rms: The roots of the mean squared distances [m], likewise.
        max: The largest distances [m], likewise.
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
    """What is measured from one surface to another one, where it is measured.

    Args:
        mesh: The surface.
        other: The other one.
        tree: Its tree.
        surface: The surface to draw from.
        radii, count, seed: As of `compute_metrics`.

    Attributes:
        arrays: What the host has to read.
    """

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
        self.arrays = [self._sums.whole, sum_squares(sampled), self.farthest.known]

    def check(self, whole: NDArray[Any]) -> None:
        """Refuse surfaces that are too far apart."""
        if self._sums.told(whole)[0] < self._count:
            raise ValueError(UNREACHED)

    def told(self, whole: NDArray[Any], squares: NDArray[Any], bounds: tuple[float, float]) -> _OneWay:
        """The numbers, of what the host has read."""
        _, total, _, within = self._sums.told(whole)
        count = self._count
        return _OneWay(total / count, root_mean_square(squares, count), 100 * within / count, *bounds)


def measure_both_ways(one: Any, two: Any, radii: list[float], count: int, seed: int) -> tuple[_OneWay, _OneWay]:
    """Distances from one surface to the other one, and back; three syncs, rarely more."""
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
    """Points about one origin, about another one."""
    shift = origin - target
    return concatenate_points([points], [shift]) if shift.any() else points
