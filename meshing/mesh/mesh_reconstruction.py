"""Surface reconstruction from points and volumes: Poisson, ball pivoting, alpha shapes, isosurfaces."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, Literal, Self, overload

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_count,
    check_finite,
    check_list,
    check_number,
    check_numeric,
    check_positive,
    check_progress,
    check_shape,
    shown,
)
from ...core.coordinates import choose_origin
from ...core.devices import check_same_device, resolve_device
from ...core.told_arguments import told_arguments
from ...core.units import common_unit, warn_of_units
from ...kernels.algebra.transform import transform_points
from ...kernels.array_types import Indices
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.prefix_sum import scan_together
from ...kernels.arrays.quantiles import median_above_zero, quantiles_of
from ...kernels.arrays.select import gather_rows
from ...kernels.extent.mean_covariance import mean_and_covariance
from ...kernels.lang import int32, launch, vec3i
from ...kernels.language.device_lock import lock
from ...kernels.linear_algebra import eigvalsh
from ...kernels.memory import cast, contiguous, download, empty, upload
from ...kernels.meshes.mesh_edits import flip_triangles, keep_counted, list_rows_kernel, mark_referenced
from ...kernels.reconstruction.alpha_faces import TOGETHER, find_alpha_shapes
from ...kernels.reconstruction.ball_surface import RollingBall, count_around
from ...kernels.reconstruction.envelope import Envelope
from ...kernels.reconstruction.poisson import mean_length, reconstruct_poisson
from ...kernels.reconstruction.sample_cells import MAX_DEPTH, Cube, bound_samples, sample_rows
from ...kernels.sampling.duplicates import first_occurrences
from ...kernels.search.nearest_point import find_nearest_rows
from ...kernels.search.neighbor_distances import nearest_distances
from ...kernels.volumes.marching_cubes import extract_surface
from ...pcd.cloud import PointCloud
from ...pcd.kept_tree import LARGEST_EXTENT, SMALLEST_EXTENT
from ...pcd.point_arrays import check_cloud
from .mesh_measures import MeshMeasures

MIN_DEPTH = 2  # the level whose density is asked is two above the finest, and level 0 says nothing
MAX_POINT_WEIGHT = 1000.0  # ten times that, and the rounding of float32 makes bumps of a tenth of a cell and more
MAX_ENVELOPE = 10_000  # triangles: a minute for a million corners
OPPOSED = 0.1  # share of neighbours to opposite sides; seams of a good cloud stay below, random signs are 0.5
MIN_SAMPLES = 0.001  # depths of vertices come five levels below their points then
NO_NORMALS = "call cloud = cloud.estimate_normals()"  # what is said then
FIRST_RADIUS = 1.5  # spacings: the ball bridges the cells of a grid, whose circles have 0.7 of one, and some gaps
LEAST_RADII, MOST_RADII = 3, 6  # taken from the cloud, each twice the one before
WIDE_SHARE = 0.98  # of the points: the last radius is for those farthest from the others, but not for strays
MOST_NEIGHBORS = 2**33  # of all points together, some ten minutes of two cores
LARGEST_SHARE = 1e4  # times the box: beyond it the ball is flat to what float64 tells apart
TRIANGLE_CORNERS = 3  # points of a triangle
SHORT_RADIUS = 0.1  # of the usual radius: below that a ball hardly touches two points
ADVISED = 3.0  # such medians, for who gave an alpha that leaves nothing: detail stays, and even samples are closed
AUTO = 10.0  # medians of the distance to the nearest point: the least at which the scanned bunny hangs together
TETRAHEDRON_CORNERS = 4  # points of a tetrahedron
SHORT_ALPHA = 0.02  # of the usual alpha, a fifth of the distance to the nearest: no tetrahedron is so small
FLAT = 2e-7  # of the largest standard deviation: what rounding to float32 leaves of a plane's thickness
FLAT_REMEDY = "ball pivoting makes a surface of a flat cloud with normals"
MOST_ALPHAS = 1000  # a tetrahedron is asked about each
_FLOAT_MAX = float(np.finfo(np.float32).max)
_FLOAT_TINY = float(np.finfo(np.float32).tiny)


class NormalsWarning(UserWarning):
    """Near neighbours have normals to opposite sides, so that the surface is none of the points'.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.NormalsWarning)  # make it an error
    """


class MeshReconstruction(MeshMeasures):
    """The part of TriangleMesh that reconstructs surfaces from points and volumes."""

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

    create_from_point_cloud_poisson = create_from_point_cloud_poisson

    @classmethod
    @told_arguments
    def create_from_point_cloud_ball_pivoting(cls, cloud: PointCloud, radii: Any = None) -> Self:
        """A mesh of a cloud: the triangles that a ball can rest on without a point inside.

        Args:
            cloud: A PointCloud with normals that point out of the surface.
            radii: Radii [m] of the ball, in the order in which they are used: one number or several. None takes 1.5
                times the spacing, which is the median distance of nearest points, and doubles it until three radii are
                there and 98 % of the points have a neighbour within the last one, up to six radii.

        Returns:
            The mesh on the cloud's device: all its points as vertices, in its order and with its normals and colours,
            and triangles that turn counter-clockwise seen from where the normals point. No edge has more than two
            triangles, and neighbours turn the same way. Holes stay where no ball fits.

        Raises:
            TypeError: No PointCloud, or radii that are no numbers.
            ValueError: A cloud without normals, no radius, one that is not a finite number > 0 or is 10,000 times the
                cloud's box, or radii for which the search would take hours; the message gives the estimate.

        Notes:
            Bernardini et al. 1999, "The ball-pivoting algorithm for surface reconstruction", without an order: all
            triangles whose ball is empty and which agree with the normals of their corners are found at once. Where
            several want the same side of an edge that with the smallest circle is taken, ties by indices. So the same
            bits from run to run, on every device and for any number of threads. Open3D's triangles of one radius are
            among them but where they share such an edge; it finds fewer. A later radius adds triangles to edges that
            have one triangle and to points that have none; unlike Open3D it always begins anew there, too. As in
            Open3D a later radius may be the smaller one.

            Points that are not finite, or have a normal that is zero or not finite, take no part; of points at one
            place the first does. Points on one circle, as of a grid, make a fan about the first. All is decided in
            float64 from the float32 coordinates about the cloud's origin, the same at every scale.

            Memory: some 1 kB a point on the CPU, scratch included, for radii of a few spacings; never a list of all
            neighbours.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> rng = np.random.default_rng(0)
            >>> ball = rng.normal(size=(2000, 3))
            >>> ball /= np.linalg.norm(ball, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(ball, normals=ball)
            >>> mesh = loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, [0.1, 0.2])
            >>> mesh.is_edge_manifold(), len(mesh) > 3900
            (True, True)
        """
        check_cloud("cloud", cloud)
        normals = cloud._required_array(
            "normals",
            "call cloud = cloud.estimate_normals(), then cloud = cloud.orient_normals_consistent_tangent_plane(15)",
        )
        points = cloud._device_array("points")
        given = None if radii is None else _check_radii(radii)
        ball = RollingBall(points, normals, cloud.search_tree)
        extent = float((np.asarray(ball.tree.high, np.float64) - ball.tree.low).max()) if ball.tree.count > 2 else 0.0
        sizes = _default_radii(ball.tree) if given is None else given
        if extent:
            _check_size(sizes, extent)
        triangles = ball.roll(sizes, len(cloud), _check_work)
        if given is not None and not triangles.size and ball.tree.count >= TRIANGLE_CORNERS:
            told, usual = (", ".join(f"{r:.3g}" for r in radii) for radii in (given, _default_radii(ball.tree)))
            if max(given) < SHORT_RADIUS * _default_radii(ball.tree)[0]:
                m = "" if cloud.unit is None else f" {cloud.unit.symbol}"
                message = f"radii: balls of {told}{m} touch no three points; the points' spacing asks for {usual}{m}"
                warn_of_units(message)
        colors = cloud._device_array("colors") if cloud.has_colors else None
        mesh = cls._from_device_arrays(
            points,
            triangles,
            vertex_normals=normals,
            vertex_colors=colors,
            origin=cloud.origin,
            library=cloud.array_library,
        )
        mesh.unit = cloud.unit
        return mesh

    create_from_point_cloud_ball_pivoting = create_from_point_cloud_ball_pivoting

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
            if max(bare) < SHORT_ALPHA * usual:
                told = ", ".join(f"{size:g}" for size in bare)
                usual *= ADVISED / AUTO
                m = "" if cloud.unit is None else f" {cloud.unit.symbol}"
                warn_of_units(f"alpha: nothing is left at {told}{m}; the points' spacing asks for some {usual:.2g}{m}")
        return answers if is_list else answers[0]

    create_from_point_cloud_alpha_shape = create_from_point_cloud_alpha_shape

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

    @classmethod
    def create_isosurfaces(cls, volume: ArrayLike, contour_values: ArrayLike = (0.0,), device: Any = None) -> Self:
        """The surfaces on which a sampled field passes some values, one behind the other, as Open3D has them.

        `marching_cubes` is the same for one value, with the spacing of the samples and another order of axes.

        Args:
            volume: Values at the points (x, y, z) of a grid, shape [nz, ny, nx] with at least 2 along each axis.
            contour_values: The values on the surfaces, taken as float32.
            device: "cpu" (default), "cuda:N" or "auto".

        Returns:
            The mesh, one unit of length a sample; triangles turn counter-clockwise seen from where the field is below.

        Raises:
            ValueError, TypeError, DeviceError: As `marching_cubes`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> z, y, x = np.mgrid[:9, :9, :9] - 4.0
            >>> ball = loom.TriangleMesh.create_isosurfaces(3 - np.sqrt(x**2 + y**2 + z**2))
            >>> ball.is_watertight(), ball.get_center().round(3).tolist()
            (True, [4.0, 4.0, 4.0])
        """
        levels = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
        if levels.ndim != 1 or not levels.size or levels.dtype == np.bool_:
            raise ValueError(f"contour_values: expected numbers, shape [k], got {shown(contour_values)}")
        if np.abs(levels).max() > _FLOAT_MAX:
            raise ValueError(f"contour_values: expected numbers within float32, got {shown(contour_values)}")
        field = np.asarray(check_numeric("volume", volume)).T
        if field.ndim != 3 or min(field.shape) < 2:
            found = list(field.shape[::-1])
            raise ValueError(f"volume: expected shape [nz, ny, nx] with at least 2 along each axis, got {found}")
        parts = []
        for level in levels.tolist():
            vertices, triangles, origin = extract_level(field, level, (1.0,) * 3, (0.0,) * 3, device)
            parts.append(cls._from_device_arrays(vertices, flip_triangles(triangles), origin=origin))
        return cls.concatenate(parts)


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


def _check_radii(radii: Any) -> list[float]:
    values = [radii] if isinstance(radii, int | float | np.number) else check_list("radii", radii, "radii [m]")
    if not values:
        raise ValueError("radii: expected one radius [m] or more, got none; None takes them from the cloud's spacing")
    return [check_positive("radii", value) for value in values]


def _default_radii(tree: Any) -> list[float]:
    """From 1.5 times the median distance of nearest points on, each twice the one before."""
    if tree.count < 3:
        return []
    distances = nearest_distances(tree, tree.source, others=True)  # NaN at points out of the tree
    spacing, wide = quantiles_of(distances, (0.5, WIDE_SHARE))  # sync
    radii = [FIRST_RADIUS * spacing * 2**i for i in range(MOST_RADII)]
    needed = sum(radius < wide for radius in radii) + 1
    return radii[: max(LEAST_RADII, needed)]


def _check_size(radii: list[float], extent: float) -> None:
    for radius in radii:
        if radius > LARGEST_SHARE * extent:
            raise ValueError(
                f"radii: {shown(radius)} m is more than {LARGEST_SHARE:,.0f} times the {extent:.3g} m that the points "
                "span; take a few times their spacing, or None"
            )


def _check_work(tree: Any, radius: float, places: Any) -> None:
    """Refuse a radius whose neighbours are too many to look at."""
    if tree.count * places.size <= MOST_NEIGHBORS:
        return
    mean = count_around(tree, places, 2 * radius)  # sync
    if mean * places.size > MOST_NEIGHBORS:
        raise ValueError(
            f"radii: at {radius:.6g} m some {mean:,.0f} points lie within twice the radius of each of {places.size:,}, "
            f"{mean * places.size:.1e} in all, where {MOST_NEIGHBORS:.1e} take minutes; take a smaller radius, or "
            "cloud.voxel_down_sample() with a voxel of half the radius first"
        )


def why_flat(cloud: PointCloud) -> str | None:
    """Why no alpha shape of a cloud has a tetrahedron, as a clause of a sentence; None if some alpha gives one."""
    points = cloud._device_arrays["points"]
    return _flat_reason(cloud._select_rows(first_occurrences(points)).search_tree().count, points)


def _flat_reason(distinct: int, points: wp.array) -> str | None:
    if distinct < TETRAHEDRON_CORNERS:
        return f"there are {distinct} distinct finite points, fewer than {TETRAHEDRON_CORNERS}"
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


def extract_level(
    field: Any, level: float, spacing: Any, origin: Any, device: Any
) -> tuple[wp.array, wp.array, NDArray[np.float64]]:
    """(vertices, triangles, origin): see `marching_cubes`."""
    values = _device_field(field, device)
    nx, ny, nz = values.shape
    level = _check_level(level)
    steps = check_shape("spacing", spacing, (3,))
    for step in steps:
        if check_positive("spacing", step) < _FLOAT_TINY:
            raise ValueError(f"spacing: {float(step)!r} is below what float32 can hold")
    corner = check_shape("origin", origin, (3,))
    far = corner + steps * (np.array(values.shape) - 1)
    if not np.isfinite(corner).all() or not max(np.abs(corner).max(), np.abs(far).max()) < _FLOAT_MAX:
        raise ValueError(f"origin, spacing: the grid from {corner.tolist()} to {far.tolist()} passes float32")
    mesh_origin = choose_origin(np.array([corner, far]))
    rows = values.reshape((nx * ny, nz))
    vertices, triangles = extract_surface(rows, (nx, ny, nz), level, corner - mesh_origin, steps)
    return vertices, triangles, mesh_origin


def _check_level(level: Any) -> float:
    number = check_number("level", level)
    if abs(number) > _FLOAT_MAX:
        raise ValueError(f"level: expected a finite number within float32, got {level!r}")
    return number


def _device_field(field: Any, device: Any) -> wp.array:
    """The field as a contiguous float32 device array of shape [nx, ny, nz], without a copy where it is one."""
    if not isinstance(field, wp.array) and not isinstance(field, np.ndarray):
        if hasattr(field, "__cuda_array_interface__"):
            resolve_device(None)  # starts Warp
            field = wp.array(field, copy=False)
        elif hasattr(field, "__dlpack__"):
            resolve_device(None)
            with lock:
                field = wp.from_dlpack(field)
    if not isinstance(field, wp.array):
        return _upload_field(field, resolve_device(device))
    if device is not None:
        check_same_device("field, device", field.device, resolve_device(device))
    _check_grid(field.shape)
    if field.dtype == wp.float32:
        return contiguous(field)
    if field.dtype not in (wp.float64, wp.float16, wp.int32, wp.uint8, wp.int8, wp.int16, wp.uint16):
        raise TypeError(f"field: expected real numbers, got {wp.types.type_repr(field.dtype)}")
    return cast(contiguous(field), wp.float32)


def _upload_field(field: Any, device: Any) -> wp.array:
    host = check_numeric("field", field)
    _check_grid(host.shape)
    with np.errstate(over="ignore"):  # beyond float32 is infinite, and cells with infinite corners are left out
        host = np.ascontiguousarray(host, dtype=np.float32)
    return upload(host, wp.float32, device, copied=False)


def _check_grid(shape: tuple[int, ...]) -> None:
    if len(shape) != 3 or min(shape) < 2:
        raise ValueError(f"field: expected shape [nx, ny, nz] with at least 2 along each axis, got {list(shape)}")
