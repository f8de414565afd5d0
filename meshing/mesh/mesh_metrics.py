"""How alike two surfaces are: Chamfer distance, Hausdorff distance, F-score, and a picture of the error."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.checks import check_count, check_numeric, check_positive, check_seed
from ...core.devices import check_same_device
from ...core.dropped_results import returns_new
from ...core.units import common_unit
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
from .finite_corners import check_finite_corners
from .mesh_intersections import check_mesh
from .mesh_sampling import MeshSampling

if TYPE_CHECKING:
    from .mesh import TriangleMesh

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


class MeshMetrics(MeshSampling):
    """The part of TriangleMesh that compares it with another one."""

    def compute_metrics(
        self,
        mesh2: TriangleMesh,
        fscore_radius: Sequence[float] = (0.01,),
        n_sampled_points: int = 100_000,
        *,
        seed: int = 0,
    ) -> SurfaceMetrics:
        """Compare two surfaces: Chamfer distance, Hausdorff distance, F-scores, mean and RMS, in both directions.

        Distances are those of points to triangles, exact. Means and F-scores are taken over points drawn from either
        surface; the Hausdorff distance over all of it, by bounds that close in on each other, where Open3D takes the
        largest of the samples' distances.

        Args:
            mesh2: The other mesh, on the same device.
            fscore_radius: Radii of the F-scores [m], the boundary excluded.
            n_sampled_points: Points drawn from each surface.
            seed: Chooses them, 0..2^31 - 1.

        Returns:
            The SurfaceMetrics. `hausdorff` and `hausdorff_bound` are at most 1e-5 of the meshes' size apart; more only
            where that would take over four million pieces of the surface.

        Raises:
            TypeError: No mesh, or no numbers.
            ValueError: A mesh without area or with a triangle that has a corner which is not finite, meshes 1.8e19 m
                apart, a radius that is not positive, a count below 1.
            DeviceError: The meshes are on different devices.

        Notes:
            24 B of memory a sample, 60 B a triangle, and as much for the pieces of triangles that are looked at again.
            Same bits from run to run. Tang, Lee and Kim, SIGGRAPH 2009; F-score: Knapitsch et al., SIGGRAPH 2017.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> above = loom.TriangleMesh([[0, 0, 2], [1, 0, 2], [0, 1, 2]], [[0, 1, 2]])
            >>> found = floor.compute_metrics(above, fscore_radius=[1, 3], n_sampled_points=1000)
            >>> found.chamfer, found.hausdorff, found.fscore.tolist()
            (4.0, 2.0, [0.0, 100.0])
        """
        check_mesh("mesh2", mesh2)
        check_same_device("mesh2", self._device, mesh2.device)
        common_unit("mesh, mesh2", (self.unit, mesh2.unit))
        given = check_numeric("fscore_radius", fscore_radius).reshape(-1).tolist()
        radii = [check_positive("fscore_radius", radius) for radius in given]
        count, seed = check_count("n_sampled_points", n_sampled_points), check_seed(seed)
        there, back = _both_ways(self, mesh2, radii, count, seed)
        both = there.within + back.within
        fscore = np.divide(2 * there.within * back.within, both, out=np.zeros_like(both), where=both > 0)
        return SurfaceMetrics(
            there.mean + back.mean,
            max(there.least, back.least),
            fscore,
            max(there.most, back.most),
            (there.mean, back.mean),
            (there.rms, back.rms),
            (there.least, back.least),
        )

    @returns_new
    def compute_error_map(
        self, mesh2: TriangleMesh, max_distance: float | None = None
    ) -> tuple[Self, NDArray[np.float32]]:
        """Colour the vertices by their distances from another mesh.

        Args:
            mesh2: The other mesh, on the same device.
            max_distance: The distance [m] of the last colour, and beyond; None takes the largest.

        Returns:
            (mesh, distances): the mesh with `vertex_colors` from dark blue at 0 over green to yellow, grey where a
            vertex is not finite or there is nothing to measure to; and the distances [m], float32 [m], NaN or infinite
            there.

        Raises:
            TypeError: No mesh, or no number.
            ValueError: A distance that is not positive, or a triangle of `mesh2` has a corner that is not finite.
            DeviceError: The meshes are on different devices.

        Notes:
            Exact distances of points to triangles; 40 B of memory a vertex. Same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> slope = loom.TriangleMesh([[0, 0, 0], [1, 0, 1], [0, 1, 3]], [[0, 1, 2]])
            >>> colored, distances = slope.compute_error_map(floor)
            >>> distances.tolist(), colored.vertex_colors[2].round(2).tolist()
            ([0.0, 1.0, 3.0], [0.9900000095367432, 0.9100000262260437, 0.14000000059604645])
        """
        check_mesh("mesh2", mesh2)
        check_same_device("mesh2", self._device, mesh2.device)
        common_unit("mesh, mesh2", (self.unit, mesh2.unit))
        check_finite_corners("compute_error_map: mesh2", mesh2)
        largest = None if max_distance is None else check_positive("max_distance", max_distance)
        points = points_about(self._arrays["vertices"], self._origin, mesh2.origin)
        tree = TriangleTree(mesh2._device_arrays["vertices"], mesh2._device_arrays["triangles"])
        distances = distances_to(points, tree)
        if largest is None:
            largest = float(np.float32(summarize_distances(distances, [])[2]))  # sync
        colored = self._with_arrays(vertex_colors=color_distances(distances, largest))
        return colored, self._handed_out(distances, dtype=np.float32)


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


def _both_ways(one: Any, two: Any, radii: list[float], count: int, seed: int) -> tuple[_OneWay, _OneWay]:
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
