"""Comparison of two surfaces: Chamfer distance, Hausdorff distance, F-score, error map."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.checks import check_count, check_numeric, check_positive, check_seed
from ...core.devices import check_same_device
from ...kernels.arrays.concatenation import concatenate_points
from ...kernels.arrays.side_by_side import read_together
from ...kernels.extent.distance_sums import DistanceSums, summarize_distances
from ...kernels.meshes.surface_samples import SurfaceSamples
from ...kernels.rays.distance_colors import color_distances
from ...kernels.rays.surface_hausdorff import (
    FarthestSearch,
    distances_to,
    root_mean_square,
    search_farthest,
    sum_squares,
)
from ...kernels.rays.triangle_tree import TriangleTree, trees_over
from ...pcd.units import common_reference
from .mesh_arrays import Mesh, MeshArrays, check_mesh
from .mesh_checks import check_finite_corners
from .sampling import check_surface, draw_samples

UNREACHED = "mesh2: expected finite triangles at less than 1.8e19 m, got none"
HAUSDORFF_PRECISION = 1e-5  # of the meshes' size: precision of the Hausdorff bounds


class UnreachedError(ValueError):
    """Surfaces are too far apart for float32."""

    def __init__(self) -> None:
        super().__init__(UNREACHED)


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
    lower: float
    upper: float


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
            raise UnreachedError()
        self._count, shift = count, (mesh.origin, other.origin)
        cloud = draw_samples(mesh, surface, count, False, seed)
        sampled = distances_to(points_about(cloud.arrays["points"], *shift), tree)
        self._sums = DistanceSums(sampled, radii)
        vertices = points_about(mesh.arrays["vertices"], *shift)
        size = float(np.max(tree.high.astype(np.float64) - tree.low))
        triangles, known = mesh.arrays["triangles"], self._sums.largest
        self.farthest = FarthestSearch(vertices, triangles, tree, known, HAUSDORFF_PRECISION * size)
        self.arrays = [self._sums.buffer, sum_squares(sampled), self.farthest.known]

    def check(self, sums: NDArray[Any]) -> None:
        if self._sums.unpack(sums)[0] < self._count:
            raise UnreachedError()

    def result(self, sums: NDArray[Any], squares: NDArray[Any], bounds: tuple[float, float]) -> _OneWay:
        _, total, _, within = self._sums.unpack(sums)
        count = self._count
        return _OneWay(total / count, root_mean_square(squares, count), 100 * within / count, *bounds)


def _measured(one: Any, two: Any, radii: list[float], count: int, seed: int) -> list[_Measured]:
    """The measurements in both directions (sync)."""
    meshes = [(mesh.arrays["vertices"], mesh.arrays["triangles"]) for mesh in (one, two)]
    surfaces = [SurfaceSamples(*mesh) for mesh in meshes]
    trees, doubled = trees_over(meshes, [surface.doubled_area for surface in surfaces])  # sync
    for surface, values in zip(surfaces, doubled, strict=True):
        surface.area = surface.area_of(values)
    directions = []
    for mesh, other, surface, tree in ((one, two, surfaces[0], trees[1]), (two, one, surfaces[1], trees[0])):
        check_surface(mesh, surface, "compute_metrics")
        directions.append(_Measured(mesh, other, tree, surface, radii, count, seed))
    return directions


def measure_both_ways(one: Any, two: Any, radii: list[float], count: int, seed: int) -> tuple[_OneWay, _OneWay]:
    """Distances in both directions. Three syncs, rarely more."""
    directions = _measured(one, two, radii, count, seed)
    values = read_together([array for direction in directions for array in direction.arrays])  # sync
    parts = list(zip(values[::3], values[1::3], strict=True))
    for direction, (sums, _) in zip(directions, parts, strict=True):
        direction.check(sums)
    bounds = search_farthest([direction.farthest for direction in directions], values[2::3])  # sync
    there, back = (
        direction.result(*part, bound) for direction, part, bound in zip(directions, parts, bounds, strict=True)
    )
    return there, back


def fractions_beyond(one: Any, two: Any, distance: float, count: int, seed: int = 0) -> tuple[float, float]:
    """Fraction of each surface farther than `distance` [m] from the other one, by `count` points. Two syncs."""
    directions, beyond = _measured(one, two, [distance], count, seed), []
    values = read_together([array for direction in directions for array in direction.arrays[:2]])  # sync
    for direction, sums, squares in zip(directions, values[::2], values[1::2], strict=True):
        direction.check(sums)
        beyond.append(1 - float(direction.result(sums, squares, (0.0, 0.0)).within[0]) / 100)
    return beyond[0], beyond[1]


def points_about(points: wp.array, origin: NDArray[np.float64], target: NDArray[np.float64]) -> wp.array:
    shift = origin - target
    return concatenate_points([points], [shift]) if shift.any() else points


def compute_metrics(
    mesh: MeshArrays, mesh2: MeshArrays, fscore_radius: Sequence[float], n_sampled_points: int, *, seed: int
) -> SurfaceMetrics:
    """As `TriangleMesh.compute_metrics`."""
    check_mesh("mesh2", mesh2)
    check_same_device("mesh2", mesh.device, mesh2.device)
    common_reference("mesh, mesh2", (mesh, mesh2))
    given = check_numeric("fscore_radius", fscore_radius).reshape(-1).tolist()
    radii = [check_positive("fscore_radius", radius) for radius in given]
    count, seed = check_count("n_sampled_points", n_sampled_points), check_seed(seed)
    there, back = measure_both_ways(mesh, mesh2, radii, count, seed)
    both = there.within + back.within
    fscore = np.divide(2 * there.within * back.within, both, out=np.zeros_like(both), where=both > 0)
    return SurfaceMetrics(
        there.mean + back.mean,
        max(there.lower, back.lower),
        fscore,
        max(there.upper, back.upper),
        (there.mean, back.mean),
        (there.rms, back.rms),
        (there.lower, back.lower),
    )


def compute_error_map(mesh: Mesh, mesh2: MeshArrays, max_distance: float | None) -> tuple[Mesh, NDArray[np.float32]]:
    """As `TriangleMesh.compute_error_map`."""
    check_mesh("mesh2", mesh2)
    check_same_device("mesh2", mesh.device, mesh2.device)
    common_reference("mesh, mesh2", (mesh, mesh2))
    check_finite_corners("compute_error_map: mesh2", mesh2)
    largest = None if max_distance is None else check_positive("max_distance", max_distance)
    points = points_about(mesh.arrays["vertices"], mesh.arrays.origin, mesh2.origin)
    tree = TriangleTree(mesh2.arrays["vertices"], mesh2.arrays["triangles"])
    distances = distances_to(points, tree)
    if largest is None:
        largest = float(np.float32(summarize_distances(distances, [])[2]))  # sync
    colored = mesh.with_arrays(vertex_colors=color_distances(distances, largest))
    return colored, mesh.arrays.hand_out(distances, dtype=np.float32)
