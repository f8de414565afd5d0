"""Surfaces from oriented points by the screened Poisson equation."""

from __future__ import annotations

import math
from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.checks import check_count, check_positive, check_progress
from ...core.devices import check_same_device
from ...core.told_arguments import told_arguments
from ...core.units import common_unit, warn_of_units
from ...kernels.algebra.transform import transform_points
from ...kernels.array_types import Indices
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.select import gather_rows
from ...kernels.reconstruction.envelope import Envelope
from ...kernels.reconstruction.poisson import reconstruct_poisson
from ...kernels.reconstruction.sample_cells import MAX_DEPTH, Cube, bound_samples, sample_rows
from ...kernels.reconstruction.sample_weights import mean_length
from ...kernels.search.nearest_point import find_nearest_rows
from ...pcd.cloud import PointCloud
from ...pcd.kept_tree import LARGEST_EXTENT, SMALLEST_EXTENT
from ...pcd.point_arrays import check_cloud
from .mesh_arrays import MeshArrays
from .mesh_measures import MeshMeasures

MIN_DEPTH = 2  # the level whose density is asked is two above the finest, and level 0 says nothing
MAX_POINT_WEIGHT = 1000.0  # ten times that, and the rounding of float32 makes bumps of a tenth of a cell and more
MAX_ENVELOPE = 10_000  # triangles: a minute for a million corners
OPPOSED = 0.1  # share of neighbours to opposite sides; seams of a good cloud stay below, random signs are 0.5
MIN_SAMPLES = 0.001  # depths of vertices come five levels below their points then
NO_NORMALS = "call cloud = cloud.estimate_normals()"  # what is said then


class NormalsWarning(UserWarning):
    """Near neighbours have normals to opposite sides, so that the surface is none of the points'.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.NormalsWarning)  # make it an error
    """


class Poisson(MeshArrays):
    """The part of TriangleMesh that makes surfaces by the Poisson equation."""

    @classmethod
    @told_arguments
    def create_from_point_cloud_poisson(
        cls,
        cloud: PointCloud,
        depth: int = 8,
        width: float = 0,
        scale: float = 1.1,
        linear_fit: bool = False,
        *,
        point_weight: float = 2.0,
        samples_per_node: float = 1.5,
        confidence: bool = False,
        envelope: MeshMeasures | None = None,
    ) -> tuple[Self, NDArray[np.float32]]:
        """The closed surface that follows a cloud's normals.

        Sought is a function whose gradient is the normals' field, with one value at all points; its surface at that
        value is the mesh. It closes over places without points, far from all of them too: cut by the densities there,
        `mesh.remove_vertices_by_mask(densities < np.quantile(densities, 0.01))`. Where the surface reaches the cube
        around the cloud it ends there. Normals have to be on one side of the surface throughout:
        `cloud.orient_normals_consistent_tangent_plane(30)`. Where more than 10 % of near neighbours have normals to
        opposite sides (`cloud.normal_disagreement()`) a NormalsWarning says so.

        Args:
            cloud: With normals. Points that are not finite and normals that are zero or NaN do not count.
            depth: The finest level that the octree may have, 2..20: 2^depth cells along the cube. It ends earlier where
                the points do: where a cell holds fewer than `samples_per_node`.
            width: Width of the finest cells [m]; above 0 it takes the place of `depth`.
            scale: Edge of the cube around the cloud over the longest edge of its box, 1 to 2^(depth - 1).
            linear_fit: Place vertices linearly between the corners of cells, else by a parabola through both slopes,
                which halves the error.
            point_weight: How much the points pull, up to 1000; 0 leaves the normals alone, more follows noise.
            samples_per_node: Points in the finest cells; 1.5 for clean points, up to 20 for noise. 0.001 or more.
            confidence: A normal's length, over the mean of all, is its point's weight; else all weigh the same.
            envelope: A closed mesh that the surface does not leave, on the cloud's device: keeps that of an open scan
                from bulging out where no point is. It has to leave the points some cells of room. Takes the time of
                corners of cells times its triangles, so up to 10,000 of those.

        Returns:
            (mesh, densities). The mesh has unit normals at its vertices (the function's gradient; Open3D's have lengths
            of .3 to 1), colours where the cloud has some (of the nearest point; Open3D's are black where it has none),
            and is edge-manifold and closed but for the cube's sides. `densities` is float32 [m], for each vertex the
            depth at which cells around would hold `samples_per_node` points: Open3D's meaning.

        Raises:
            TypeError: Not a PointCloud.
            ValueError: A cloud without normals, or without two places with a normal; an argument out of range, or more
                `samples_per_node` than there are points.
            MemoryError: The tree would not fit: refused, with the size, before it is allocated.

        Notes:
            Same bits from run to run, whatever the number of threads (Open3D's differ from two threads on). Positions
            are relative to the cloud's origin, so coordinates of any size do no harm. About 0.8 kB a block of eight
            cells: bunny, 100,000 points, 190 MB at depth 8, no more at 15.

            Each level is solved by four sweeps of eight-coloured Gauss-Seidel from the coarser one's solution, with
            trilinear functions at the corners of cells, as PoissonRecon's have been since 2018. Differs from Open3D in
            bits, not in distance to the true surface.

            Kazhdan and Hoppe, "Screened Poisson surface reconstruction", ACM TOG 32(3), 2013.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.random.default_rng(0).normal(size=(2000, 3))
            >>> points /= np.linalg.norm(points, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(points, normals=points)
            >>> ball, densities = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)
            >>> ball.is_watertight(), bool(abs(np.linalg.norm(ball.vertices, axis=1) - 1).max() < 0.02)
            (True, True)
        """
        check_cloud("cloud", cloud)
        points, normals = cloud._device_array("points"), cloud._required_array("normals", NO_NORMALS)
        deepest = check_count("depth", depth, minimum=MIN_DEPTH, maximum=MAX_DEPTH, because="codes of cells end there")
        edge, cell = check_positive("scale", scale), check_positive("width", width, allow_zero=True)
        pull = check_positive("point_weight", point_weight, allow_zero=True, maximum=MAX_POINT_WEIGHT)
        count = check_positive("samples_per_node", samples_per_node)
        if edge < 1:
            raise ValueError(f"scale: expected 1 or more, the cube holds the cloud, got {edge:g}")
        if confidence:
            normals = _weights_as_lengths(points, normals)
        cube, rows = _cube_around(points, normals, edge)
        _warn_of_sides(cloud, float(cube.side))
        deepest = _depth_of_width(float(cube.side), cell) if cell > 0 else deepest
        _check_reach(edge, deepest, count, points.size)
        surface = reconstruct_poisson(
            points,
            normals,
            rows,
            cube,
            deepest,
            is_linear=bool(linear_fit),
            point_weight=pull,
            samples_per_cell=count,
            by_length=bool(confidence),
            envelope=None if envelope is None else _check_envelope(envelope, cloud),
            progress=check_progress(None),
        )
        mesh = cls._from_device_arrays(
            surface.vertices,
            surface.triangles,
            vertex_normals=surface.normals,
            vertex_colors=_nearest_colors(cloud, surface.vertices),
            origin=cloud.origin,
            library=cloud.array_library,
        )
        mesh.unit = cloud.unit
        return mesh, mesh._handed_out(surface.densities)


def _check_reach(scale: float, depth: int, samples: float, point_count: int) -> None:
    """Hold that the cloud fills some cells of the tree, and that there are as many points as cells ask for.

    Raises:
        ValueError: It is too small in its cube, or there are fewer.
    """
    if scale > 2 ** (depth - 1):
        raise ValueError(
            f"scale: {scale:g} leaves the cloud in less than two of the 2^{depth} cells along the cube; "
            f"expected up to {2 ** (depth - 1)}, or a greater depth"
        )
    if not MIN_SAMPLES <= samples <= point_count:
        raise ValueError(
            f"samples_per_node: expected a number from {MIN_SAMPLES:g} to {point_count}, the cloud's points, got "
            f"{samples:g}"
        )


def _nearest_colors(cloud: PointCloud, vertices: wp.array) -> wp.array | None:
    """For each vertex the colour of the nearest point, where the cloud has colours."""
    if not cloud.has_colors or not vertices.size:
        return None
    return gather_rows(cloud.array("colors"), find_nearest_rows(cloud.search_tree(), vertices))


def _cube_around(points: wp.array, normals: wp.array, scale: float) -> tuple[Cube, Indices]:
    """The cube around the points that count, and their rows.

    Raises:
        ValueError: There are no two places among them.
    """
    rows, low, high = bound_samples(points, normals)  # sync
    extent = float((high.astype(np.float64) - low).max()) if rows.size else 0.0
    if not extent > 0:
        found = "all those with normals are one" if rows.size else "none is finite and has a normal that is not zero"
        raise ValueError(f"cloud: expected points at two places at least, {found} of {points.size:,}")
    side = extent * scale
    corner = (low.astype(np.float64) + high) / 2 - side / 2
    if not np.abs([corner, corner + side]).max() < np.finfo(np.float32).max:
        raise ValueError(
            f"cloud, scale: a cube of {side:g} m reaches beyond what float32 holds; take a smaller scale, or "
            "cloud.scale(1e-6) first"
        )
    return Cube(corner, side), rows


def _check_envelope(envelope: Any, cloud: PointCloud) -> Envelope:
    """The envelope about the cloud's origin.

    Raises:
        TypeError: No TriangleMesh.
        ValueError: Not closed, of too many triangles, or on another device.
    """
    if not isinstance(envelope, MeshMeasures):
        raise TypeError(f"envelope: expected a TriangleMesh, got {type(envelope).__name__}")
    check_same_device("envelope", cloud.device, envelope.device)
    common_unit("cloud, envelope", (cloud.unit, envelope.unit))
    if len(envelope) > MAX_ENVELOPE:
        raise ValueError(
            f"envelope: expected up to {MAX_ENVELOPE:,} triangles, got {len(envelope):,}; take a coarser mesh"
        )
    if not envelope.is_watertight():
        raise ValueError("envelope: expected a closed mesh, this one is not watertight")
    vertices = transform_points(envelope.array("vertices"), np.eye(3), envelope.origin - cloud.origin)
    low, high, _ = bound_points(vertices)
    return Envelope(vertices, envelope.array("triangles"), low, high)


def _warn_of_sides(cloud: PointCloud, side: float) -> None:
    """Say so where normals do not agree; where neighbours can be searched at all, which float32 decides."""
    if not SMALLEST_EXTENT < side < LARGEST_EXTENT:
        return
    share = cloud.normal_disagreement()
    if share > OPPOSED:
        warn_of_units(
            f"{100 * share:.0f} % of near neighbours have normals to opposite sides, so the surface is none of the "
            "points'; call cloud.orient_normals_consistent_tangent_plane(30) first",
            NormalsWarning,
        )


def _weights_as_lengths(points: wp.array, normals: wp.array) -> wp.array:
    """The normals, those that count with lengths of 1 on average."""
    mean = mean_length(normals, sample_rows(points, normals))
    return transform_points(normals, np.eye(3) / mean, np.zeros(3))


def _depth_of_width(side: float, width: float) -> int:
    """The level whose cells are no wider.

    Raises:
        ValueError: It would be deeper than codes of cells reach.
    """
    if width * 2.0**MAX_DEPTH < side:
        raise ValueError(
            f"width: expected {side / 2**MAX_DEPTH:g} m or more, so that a cube of {side:g} m has up to 2^{MAX_DEPTH} "
            f"cells along it, got {width:g}"
        )
    return max(MIN_DEPTH, math.ceil(math.log2(side / width)))
