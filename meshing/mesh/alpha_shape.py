"""Surfaces around points: alpha shapes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Literal, Self, overload

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.checks import check_list, check_positive, shown
from ...core.units import warn_of_units
from ...kernels.arrays.prefix_sum import scan_together
from ...kernels.arrays.quantiles import median_above_zero
from ...kernels.arrays.select import gather_rows
from ...kernels.extent.mean_covariance import mean_and_covariance
from ...kernels.lang import int32, launch, vec3i
from ...kernels.linear_algebra import eigvalsh
from ...kernels.memory import download, empty
from ...kernels.meshes.mesh_edits import keep_counted, list_rows_kernel, mark_referenced
from ...kernels.reconstruction.alpha_faces import TOGETHER, find_alpha_shapes
from ...kernels.sampling.duplicates import first_occurrences
from ...kernels.search.neighbor_distances import nearest_distances
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from .mesh_arrays import MeshArrays

ADVISED = 3.0  # such medians, for who gave an alpha that leaves nothing: detail stays, and even samples are closed
AUTO = 10.0  # medians of the distance to the nearest point: the least at which the scanned bunny hangs together
CORNERS = 4  # points of a tetrahedron
SHORT = 0.02  # of the usual alpha, a fifth of the distance to the nearest: no tetrahedron is so small
FLAT = 2e-7  # of the largest standard deviation: what rounding to float32 leaves of a plane's thickness
FLAT_REMEDY = "ball pivoting makes a surface of a flat cloud with normals"
MOST_ALPHAS = 1000  # a tetrahedron is asked about each


class AlphaShapes(MeshArrays):
    """The part of TriangleMesh that makes alpha shapes."""

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: float | str = ..., *, return_tetrahedra: Literal[False] = ...
    ) -> Self: ...

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: float | str = ..., *, return_tetrahedra: Literal[True]
    ) -> tuple[Self, NDArray[np.int32], NDArray[np.int32]]: ...

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: Sequence[float] | NDArray[Any], *, return_tetrahedra: Literal[False] = ...
    ) -> list[Self]: ...

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: Sequence[float] | NDArray[Any], *, return_tetrahedra: Literal[True]
    ) -> list[tuple[Self, NDArray[np.int32], NDArray[np.int32]]]: ...

    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: Any = "auto", *, return_tetrahedra: bool = False
    ) -> Any:
        """The alpha shape of a cloud: the boundary of its Delaunay tetrahedra whose circumradius is at most alpha.

        Where points are denser than alpha the shape is filled; hollows and gaps wider than 2 alpha stay open. The
        surface is closed, and an even number of triangles meets at each edge.

        Args:
            cloud: The points; those that are not finite are left out, and of equal ones the first counts.
            alpha: Largest circumradius [m]. Infinity gives the convex hull. "auto" takes 10 times the median distance
                of a point to its nearest: about the least at which the tetrahedra along a scanned surface hang together
                in one shape (of the bunny's 35,947 points all, of 8,171 of them 99.9 %). A list, in any order, makes
                one shape of each for little more than the cost of the largest.
            return_tetrahedra: Return the kept tetrahedra and the point map, too.

        Returns:
            The mesh, or a list of them in the order of the alphas. Vertices are the points that a triangle uses, in the
            cloud's order, with their normals and colours; triangles turn counter-clockwise seen from the side that is
            not kept, and come by their points. With `return_tetrahedra` (mesh, tetrahedra, point_map) in its place:
            int32 [k, 4] rows of the cloud with det(b - a, c - a, d - a) > 0, and int32 [m] the row of each vertex.

            Where no tetrahedron is kept the mesh is empty: `len(mesh)` is 0.

        Raises:
            TypeError: No cloud, or an alpha that is no number.
            ValueError: An alpha that is not above zero, no alpha at all, or more than 1,000.

        Warns:
            UserWarning: The mesh is empty whatever the alpha: fewer than four points, or all on one line or plane.
            UnitWarning: The mesh is empty since alpha is far below the spacing of the points.

        Notes:
            Exact for the float32 coordinates that the cloud holds, at any distance from zero, as it keeps an origin:
            every question is answered in float64 with a bound of its error and, where that leaves it open, by whole
            numbers. The Delaunay triangulation of points on one sphere (grids) is made unique by their order in the
            cloud, with no flat tetrahedra. Same bits on every device and from run to run.

            Each point finds its own tetrahedra among the points within 2 alpha, so there is no triangulation of the
            whole; about 300 B a point for the time of the call, and scratch memory of up to 500 MB. The work grows with
            the points near the empty spheres at a point, not with all within 2 alpha; an alpha of the size of the
            cloud is dear where many points lie on its hull.

            Open3D rounds: it leaves grids open and finds nothing at UTM coordinates. Edelsbrunner and Muecke,
            "Three-dimensional alpha shapes", TOG 1994, regularised.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> grid = np.stack(np.meshgrid(*[np.arange(8.0)] * 3), -1).reshape(-1, 3)
            >>> mesh = loom.TriangleMesh.create_from_point_cloud_alpha_shape(loom.PointCloud(grid), 0.9)
            >>> len(mesh), mesh.is_watertight(), round(mesh.get_volume(), 3)
            (588, True, 343.0)
        """
        check_cloud("cloud", cloud)
        chosen, is_list = _check_alphas(alpha)
        rows = first_occurrences(cloud._device_arrays["points"])
        unique = cloud if rows.size == len(cloud) else cloud._select_rows(rows)
        tree = unique.search_tree()
        if chosen is None:
            chosen = [_choose_alpha(tree, unique._device_arrays["points"])]
        found = _find_shapes(tree, rows, len(cloud), chosen, bool(return_tetrahedra))
        answers, bare = [], []
        used = _used_points([triangles for triangles, _ in found], len(cloud))
        for size, (triangles, tetrahedra), (mask, places, count) in zip(chosen, found, used, strict=True):
            mesh = cls._over_points(cloud, triangles, mask, places, count)
            if not triangles.size:
                bare.append(size)
            answers.append((mesh, tetrahedra, _used_rows(mask, places, count)) if return_tetrahedra else mesh)
        flat = _flat_reason(tree.count, unique._device_arrays["points"]) if bare else None
        if flat is not None:
            warn_of_units(f"cloud: {flat}, so no alpha gives a surface; {FLAT_REMEDY}", UserWarning)
        elif bare and not isinstance(alpha, str):
            usual = _choose_alpha(tree, unique._device_arrays["points"])
            if max(bare) < SHORT * usual:
                told = ", ".join(f"{size:g}" for size in bare)
                usual *= ADVISED / AUTO
                m = "" if cloud.unit is None else f" {cloud.unit.symbol}"
                warn_of_units(f"alpha: nothing is left at {told}{m}; the points' spacing asks for some {usual:.2g}{m}")
        return answers if is_list else answers[0]

    @classmethod
    def _over_points(cls, cloud: PointCloud, triangles: wp.array, used: wp.array, places: wp.array, count: int) -> Self:
        """A mesh of the points that some triangles use: so many, marked, each with its place among them."""
        names = {"vertices": "points", "vertex_normals": "normals", "vertex_colors": "colors"}
        arrays = {name: cloud._device_arrays[given] for name, given in names.items() if given in cloud._device_arrays}
        corners, kept = keep_counted(triangles, used, places, count, list(arrays.values()))
        rows = dict(zip(arrays, kept, strict=True))
        mesh = cls._from_device_arrays(triangles=corners, **rows, origin=cloud.origin, library=cloud.array_library)
        mesh.unit = cloud.unit
        return mesh


def why_flat(cloud: PointCloud) -> str | None:
    """Why no alpha shape of a cloud has a tetrahedron, as a clause of a sentence; None if some alpha gives one."""
    points = cloud._device_arrays["points"]
    return _flat_reason(cloud._select_rows(first_occurrences(points)).search_tree().count, points)


def _flat_reason(distinct: int, points: wp.array) -> str | None:
    if distinct < CORNERS:
        return f"there are {distinct} distinct finite points, fewer than {CORNERS}"
    _, _, covariance = mean_and_covariance(points)
    deviations = np.sqrt(np.maximum(eigvalsh(covariance), 0))  # ascending
    if deviations[1] <= FLAT * deviations[2]:
        return "the points lie on one line"
    return "the points lie in one plane" if deviations[0] <= FLAT * deviations[2] else None


def _used_points(shapes: list[wp.array], count: int) -> Iterator[tuple[wp.array, wp.array, int]]:
    """For each shape its points, marked; the place of each among them; and how many they are. One sync for some."""
    for first in range(0, len(shapes), TOGETHER):
        used = [mark_referenced(triangles, count) for triangles in shapes[first : first + TOGETHER]]
        for mask, (places, (total,)) in zip(used, scan_together([(mask, [count]) for mask in used]), strict=True):
            yield mask, places, total


def _used_rows(used: wp.array, places: wp.array, count: int) -> NDArray[np.int32]:
    """The rows of the points that are marked, ascending."""
    rows = empty(count, int32, used.device)
    launch(list_rows_kernel, used.size, [used, places, rows])
    return download(rows).copy()  # sync


def _check_alphas(alpha: Any) -> tuple[list[float] | None, bool]:
    """The alphas, None for "auto", and whether they are several."""
    if isinstance(alpha, str) and alpha == "auto":
        return None, False
    if isinstance(alpha, str):
        raise ValueError(f'alpha: expected a length [m], "auto" or a list of lengths, got {shown(alpha)}')
    is_list = isinstance(alpha, list | tuple) or getattr(alpha, "ndim", 0) == 1
    alphas = check_list("alpha", alpha, "lengths") if is_list else [alpha]
    if not 1 <= len(alphas) <= MOST_ALPHAS:
        raise ValueError(f"alpha: expected a list of 1 to {MOST_ALPHAS:,} lengths, got {len(alphas)}")
    return [check_positive("alpha", value, allow_infinite=True) for value in alphas], is_list


def _choose_alpha(tree: Any, points: wp.array) -> float:
    """AUTO medians of the distance to the nearest point; any length where there are fewer than two."""
    median = median_above_zero(nearest_distances(tree, points, others=True, missing=0.0))  # sync
    return 1.0 if median is None else AUTO * median


def _find_shapes(
    tree: Any, rows: wp.array, owners: int, alphas: list[float], with_tetrahedra: bool
) -> list[tuple[wp.array, NDArray[np.int32] | None]]:
    """Triangles and tetrahedra for each alpha, as rows of the cloud."""
    ascending = sorted(set(alphas))
    if tree.count < 4:
        none = np.zeros((0, 4), np.int32) if with_tetrahedra else None
        return [(empty(0, vec3i, tree.device), none) for _ in alphas]
    places = gather_rows(rows, tree.order[: tree.count])
    found = find_alpha_shapes(tree, places, owners, ascending, with_tetrahedra)
    shapes = [
        (triangles, None if corners is None else download(corners).reshape(-1, 4).copy())
        for triangles, corners in found
    ]
    return [shapes[ascending.index(alpha)] for alpha in alphas]
