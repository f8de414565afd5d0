"""Surface reconstruction from points and volumes: Poisson, ball pivoting, alpha shapes, isosurfaces."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import hand_out, library_for
from ...core.checks import (
    check_count,
    check_finite,
    check_list,
    check_number,
    check_numeric,
    check_positive,
    check_progress,
    check_shape,
    is_on_gpu,
    shown,
)
from ...core.coordinates import choose_origin
from ...core.devices import DeviceLike, check_same_device, resolve_device
from ...core.gpu_arrays import take_numbers
from ...core.other_geometry import conversion_of
from ...core.units import warn_of_units
from ...kernels.algebra.transform import transform_points
from ...kernels.array_types import AnyArray, Device, Indices
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.duplicates import first_occurrences
from ...kernels.arrays.prefix_sum import scan_together
from ...kernels.arrays.quantiles import median_above_zero, quantiles_of
from ...kernels.arrays.select import gather_rows
from ...kernels.extent.mean_covariance import mean_and_covariance
from ...kernels.lang import int32, launch, vec3i
from ...kernels.language.device_lock import lock
from ...kernels.linear_algebra import eigvalsh
from ...kernels.memory import cast, clone, contiguous, empty, upload
from ...kernels.meshes.mesh_edits import flip_triangles, keep_counted, list_rows_kernel, mark_referenced
from ...kernels.reconstruction.alpha_faces import ALPHAS_PER_SYNC, find_alpha_shapes
from ...kernels.reconstruction.ball_surface import RollingBall
from ...kernels.reconstruction.envelope import Envelope
from ...kernels.reconstruction.poisson import PoissonSettings, mean_length, reconstruct_poisson
from ...kernels.reconstruction.sample_cells import MAX_DEPTH, Cube, bound_samples, sample_rows
from ...kernels.search.nearest_point import find_nearest_rows
from ...kernels.search.neighbor_distances import nearest_distances
from ...kernels.search.point_tree import PointTree
from ...kernels.search.tree_search import count_around
from ...kernels.volumes.marching_cubes import extract_surface
from ...pcd.cached_tree import LARGEST_EXTENT, SMALLEST_EXTENT
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ...pcd.units import common_reference
from .mesh_arrays import Mesh, MeshArrays
from .topology import is_watertight

MIN_DEPTH = 2  # densities use the level two above the finest, and level 0 has no information
MAX_POINT_WEIGHT = 1000.0  # at ten times this, float32 rounding causes bumps of a tenth of a cell
MAX_ENVELOPE = 10_000  # triangles: a minute for a million corners
MAX_OPPOSED_FRACTION = 0.1  # fraction of disagreeing neighbors. Seams of a good cloud are below, random signs give 0.5
MIN_SAMPLES = 0.001  # vertices are then five levels coarser than their points
NO_NORMALS = "call cloud = cloud.estimate_normals()"  # remedy in errors
FIRST_RADIUS = 1.5  # times the spacing: bridges grid cells (circumradius 0.7) and some gaps
MIN_RADII, MAX_RADII = 3, 6  # default number of radii, each twice the previous one
WIDE_FRACTION = 0.98  # of the points: ignores outliers in the largest default radius
MAX_NEIGHBORS = 2**33  # of all points together, about ten minutes on two cores
LARGEST_FRACTION = 1e4  # times the box: beyond it the ball is flat in float64
TRIANGLE_CORNERS = 3  # points of a triangle
SHORT_RADIUS = 0.1  # of the usual radius: below it a ball rarely touches two points
ADVISED_ALPHA = 3.0  # such medians, advised if alpha is too small: keeps detail and closes even samples
AUTO_ALPHA = 10.0  # times the median nearest neighbor distance: the minimum that keeps the scanned bunny connected
TETRAHEDRON_CORNERS = 4  # points of a tetrahedron
SHORT_ALPHA = 0.02  # of the usual alpha, a fifth of the nearest neighbor distance: no tetrahedron is so small
MIN_DEVIATION_RATIO = 2e-7  # of the largest standard deviation: float32 rounding of a plane's thickness
FLAT_REMEDY = "ball pivoting can mesh a flat cloud with normals"
MAX_ALPHAS = 1000  # each tetrahedron is tested for each alpha
_FLOAT_MAX = float(np.finfo(np.float32).max)
_FLOAT_TINY = float(np.finfo(np.float32).tiny)


class NormalsWarning(UserWarning):
    """Neighboring normals are on opposite sides of the surface, so the reconstruction is unreliable.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.NormalsWarning)  # make it an error
    """


def create_from_point_cloud_poisson(
    kind: type[Mesh],
    cloud: PointCloud,
    depth: int,
    width: float,
    scale: float,
    linear_fit: bool,
    *,
    point_weight: float,
    samples_per_node: float,
    confidence: bool,
    envelope: MeshArrays | None,
) -> tuple[Mesh, NDArray[np.float32]]:
    """As `TriangleMesh.create_from_point_cloud_poisson`."""
    check_cloud("cloud", cloud)
    points, normals = cloud.arrays["points"], cloud.arrays.required("normals", NO_NORMALS)
    deepest = check_count(
        "depth", depth, minimum=MIN_DEPTH, maximum=MAX_DEPTH, because="cell codes support no deeper trees"
    )
    edge, cell = check_positive("scale", scale), check_positive("width", width, allow_zero=True)
    pull = check_positive("point_weight", point_weight, allow_zero=True, maximum=MAX_POINT_WEIGHT)
    count = check_positive("samples_per_node", samples_per_node)
    if edge < 1:
        raise ValueError(f"scale: expected >= 1, so that the cube contains the cloud, got {edge:g}")
    if confidence:
        normals = _weights_as_lengths(points, normals)
    cube, rows = _cube_around(points, normals, edge)
    _warn_of_sides(cloud, float(cube.side))
    deepest = _depth_of_width(float(cube.side), cell) if cell > 0 else deepest
    _check_scale(edge, deepest, count, points.size)
    settings = PoissonSettings(deepest, bool(linear_fit), pull, count, bool(confidence))
    bounds = None if envelope is None else _check_envelope(envelope, cloud)
    surface = reconstruct_poisson(points, normals, rows, cube, settings, bounds, check_progress(None))
    mesh = kind.from_device_arrays(
        {
            "vertices": surface.vertices,
            "triangles": surface.triangles,
            "vertex_normals": surface.normals,
            "vertex_colors": _nearest_colors(cloud, surface.vertices),
        },
        cloud.origin,
        cloud.array_library,
    )
    mesh.unit, mesh.crs = cloud.unit, cloud.crs
    return mesh, mesh.arrays.hand_out(surface.densities)


def create_from_point_cloud_ball_pivoting(kind: type[Mesh], cloud: PointCloud, radii: ArrayLike | None) -> Mesh:
    """As `TriangleMesh.create_from_point_cloud_ball_pivoting`."""
    check_cloud("cloud", cloud)
    normals = cloud.arrays.required(
        "normals",
        "call cloud = cloud.estimate_normals(), then cloud = cloud.orient_normals_consistent_tangent_plane(15)",
    )
    points = cloud.arrays["points"]
    given = None if radii is None else _check_radii(radii)
    ball = RollingBall(points, normals, cloud.search_tree)
    extent = float((np.asarray(ball.tree.high, np.float64) - ball.tree.low).max()) if ball.tree.count > 2 else 0.0
    sizes = _default_radii(ball.tree) if given is None else given
    if extent:
        _check_size(sizes, extent)
    triangles = ball.roll(sizes, len(cloud), _check_work)
    if given is not None and not triangles.size and ball.tree.count >= TRIANGLE_CORNERS:
        given_radii, usual = (", ".join(f"{r:.3g}" for r in radii) for radii in (given, _default_radii(ball.tree)))
        if max(given) < SHORT_RADIUS * _default_radii(ball.tree)[0]:
            m = "" if cloud.unit is None else f" {cloud.unit.symbol}"
            message = f"radii: balls of {given_radii}{m} touch no three points. The point spacing suggests {usual}{m}"
            warn_of_units(message)
    colors = cloud.arrays["colors"] if cloud.has_colors else None
    arrays = {"vertices": points, "triangles": triangles, "vertex_normals": normals, "vertex_colors": colors}
    mesh = kind.from_device_arrays(arrays, cloud.origin, cloud.array_library)
    mesh.unit, mesh.crs = cloud.unit, cloud.crs
    return mesh


def create_from_point_cloud_alpha_shape(
    kind: type[Mesh], cloud: PointCloud, alpha: float | ArrayLike | None, *, return_tetrahedra: bool
) -> Any:
    """As `TriangleMesh.create_from_point_cloud_alpha_shape`."""
    check_cloud("cloud", cloud)
    chosen, is_list = _check_alphas(alpha)
    rows = first_occurrences(cloud.arrays["points"])
    unique = cloud if rows.size == len(cloud) else cloud.select_rows(rows)
    tree = unique.search_tree()
    if chosen is None:
        chosen = [_choose_alpha(tree, unique.arrays["points"])]
    shapes = _find_shapes(tree, rows, len(cloud), chosen, bool(return_tetrahedra))
    results, empty_sizes = [], []
    used = _used_points([triangles for triangles, _ in shapes], len(cloud))
    for size, (triangles, tetrahedra), (mask, offsets, count) in zip(chosen, shapes, used, strict=True):
        mesh = _over_points(kind, cloud, triangles, mask, offsets, count)
        if not triangles.size:
            empty_sizes.append(size)
        if return_tetrahedra:
            own = tetrahedra if chosen.count(size) == 1 else clone(tetrahedra)
            parts = own, _used_rows(mask, offsets, count)
            mesh = (mesh, *(hand_out(part, cloud.array_library) for part in parts))
        results.append(mesh)
    flat = _flat_reason(tree.count, unique.arrays["points"]) if empty_sizes else None
    if flat is not None:
        warn_of_units(f"cloud: {flat}, so no alpha gives a surface; {FLAT_REMEDY}", UserWarning)
    elif empty_sizes and not isinstance(alpha, str):
        usual = _choose_alpha(tree, unique.arrays["points"])
        if max(empty_sizes) < SHORT_ALPHA * usual:
            sizes = ", ".join(f"{size:g}" for size in empty_sizes)
            usual *= ADVISED_ALPHA / AUTO_ALPHA
            m = "" if cloud.unit is None else f" {cloud.unit.symbol}"
            warn_of_units(f"alpha: no triangles remain at {sizes}{m}. The point spacing suggests about {usual:.2g}{m}")
    return results if is_list else results[0]


def create_isosurfaces(
    kind: type[Mesh], volume: ArrayLike, contour_values: ArrayLike, device: Any, *, arrays: str | None
) -> Mesh:
    """As `TriangleMesh.create_isosurfaces`."""
    levels = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
    if levels.ndim != 1 or not levels.size or levels.dtype == np.bool_:
        raise ValueError(f"contour_values: expected numbers, shape [k], got {shown(contour_values)}")
    if np.abs(levels).max() > _FLOAT_MAX:
        raise ValueError(f"contour_values: expected numbers within float32, got {shown(contour_values)}")
    library = library_for(arrays, volume)
    numbers: Any = take_numbers("volume", volume) if is_on_gpu(volume) else check_numeric("volume", volume)
    field = numbers.transpose()
    if field.ndim != 3 or min(field.shape) < 2:
        shape = list(field.shape[::-1])
        raise ValueError(f"volume: expected shape [nz, ny, nx] with at least 2 along each axis, got {shape}")
    parts = []
    for level in levels.tolist():
        vertices, triangles, origin = extract_level(field, level, (1.0,) * 3, (0.0,) * 3, device)
        surface = {"vertices": vertices, "triangles": flip_triangles(triangles)}
        parts.append(kind.from_device_arrays(surface, origin, library))
    return kind.concatenate(parts)


def _over_points(
    kind: type[Mesh], cloud: PointCloud, triangles: wp.array, used: wp.array, offsets: wp.array, count: int
) -> Mesh:
    """Mesh of the points used by `triangles`, with their new indices."""
    names = {"vertices": "points", "vertex_normals": "normals", "vertex_colors": "colors"}
    arrays = {name: cloud.arrays[given] for name, given in names.items() if given in cloud.arrays}
    corners, selected = keep_counted(triangles, used, offsets, count, list(arrays.values()))
    rows = dict(zip(arrays, selected, strict=True))
    mesh = kind.from_device_arrays({"triangles": corners, **rows}, cloud.origin, cloud.array_library)
    mesh.unit, mesh.crs = cloud.unit, cloud.crs
    return mesh


def _check_scale(scale: float, depth: int, samples: float, point_count: int) -> None:
    """Raise ValueError if the cloud fills too few cells of the tree, or has too few points."""
    if scale > 2 ** (depth - 1):
        raise ValueError(
            f"scale: expected up to {2 ** (depth - 1)}, got {scale:g}, which leaves the cloud in fewer than two of the "
            f"2^{depth} cells along the cube. Reduce scale or increase depth"
        )
    if not MIN_SAMPLES <= samples <= point_count:
        raise ValueError(
            f"samples_per_node: expected a number from {MIN_SAMPLES:g} to {point_count}, the number of points, got "
            f"{samples:g}"
        )


def _nearest_colors(cloud: PointCloud, vertices: wp.array) -> wp.array | None:
    if not cloud.has_colors or not vertices.size:
        return None
    return gather_rows(cloud.arrays["colors"], find_nearest_rows(cloud.search_tree(), vertices))


def _cube_around(points: wp.array, normals: wp.array, scale: float) -> tuple[Cube, Indices]:
    """Cube around the valid points, and their rows. ValueError with fewer than two positions."""
    rows, low, high = bound_samples(points, normals)  # sync
    extent = float((high.astype(np.float64) - low).max()) if rows.size else 0.0
    if not extent > 0:
        reason = "all points with normals coincide" if rows.size else "no point is finite with a nonzero normal"
        raise ValueError(f"cloud: expected at least two distinct points with normals; {reason} among {points.size:,}")
    side = extent * scale
    corner = (low.astype(np.float64) + high) / 2 - side / 2
    if not np.abs([corner, corner + side]).max() < np.finfo(np.float32).max:
        raise ValueError(
            f"cloud, scale: a cube of {side:g} m exceeds the float32 range. Use a smaller scale, or call "
            "cloud.scale(1e-6) first"
        )
    return Cube(corner, side), rows


def _check_envelope(envelope: object, cloud: PointCloud) -> Envelope:
    if not isinstance(envelope, MeshArrays):
        given = f"{type(envelope).__name__}{conversion_of(envelope, expected='mesh')}"
        raise TypeError(f"envelope: expected a TriangleMesh, got {given}")
    check_same_device("envelope", cloud.device, envelope.device)
    common_reference("cloud, envelope", (cloud, envelope))
    if len(envelope) > MAX_ENVELOPE:
        raise ValueError(
            f"envelope: expected up to {MAX_ENVELOPE:,} triangles, got {len(envelope):,}. Use a coarser mesh"
        )
    if not is_watertight(envelope):
        raise ValueError("envelope: expected a closed mesh, got one that is not watertight")
    vertices = transform_points(envelope.arrays["vertices"], np.eye(3), envelope.origin - cloud.origin)
    low, high, _ = bound_points(vertices)
    return Envelope(vertices, envelope.arrays["triangles"], low, high)


def _warn_of_sides(cloud: PointCloud, side: float) -> None:
    """Warn if normals disagree; skipped where float32 cannot resolve neighbors."""
    if not SMALLEST_EXTENT < side < LARGEST_EXTENT:
        return
    fraction = cloud.normal_disagreement()
    if fraction > MAX_OPPOSED_FRACTION:
        warn_of_units(
            f"{100 * fraction:.0f}% of the neighboring points have opposite normals, so the surface does not follow "
            "the points. Call cloud.orient_normals_consistent_tangent_plane(30) first",
            NormalsWarning,
        )


def _weights_as_lengths(points: wp.array, normals: wp.array) -> wp.array:
    """Normals scaled to a mean length of 1."""
    mean = mean_length(normals, sample_rows(points, normals))
    return transform_points(normals, np.eye(3) / mean, np.zeros(3))


def _depth_of_width(side: float, width: float) -> int:
    """Level whose cells are at most `width` wide. ValueError if too deep."""
    if width * 2.0**MAX_DEPTH < side:
        raise ValueError(
            f"width: expected {side / 2**MAX_DEPTH:g} m or more, so that a cube of {side:g} m has up to 2^{MAX_DEPTH} "
            f"cells along it, got {width:g}"
        )
    return max(MIN_DEPTH, math.ceil(math.log2(side / width)))


def _check_radii(radii: object) -> list[float]:
    values = [radii] if isinstance(radii, int | float | np.number) else check_list("radii", radii, "radii [m]")
    if not values:
        raise ValueError(
            "radii: expected at least one radius [m], got none. Pass None to derive them from the point spacing"
        )
    return [check_positive("radii", value) for value in values]


def _default_radii(tree: PointTree) -> list[float]:
    """Radii from 1.5 times the median nearest neighbor distance, doubling."""
    if tree.count < 3:
        return []
    distances = nearest_distances(tree, tree.source, others=True)  # NaN at points outside the tree
    spacing, wide_spacing = quantiles_of(distances, (0.5, WIDE_FRACTION))  # sync
    radii = [FIRST_RADIUS * spacing * 2**i for i in range(MAX_RADII)]
    needed = sum(radius < wide_spacing for radius in radii) + 1
    return radii[: max(MIN_RADII, needed)]


def _check_size(radii: list[float], extent: float) -> None:
    for radius in radii:
        if radius > LARGEST_FRACTION * extent:
            raise ValueError(
                f"radii: {shown(radius)} m is more than {LARGEST_FRACTION:,.0f} times the {extent:.3g} m extent of the "
                "points. Use a few times their spacing, or None"
            )


def _check_work(tree: PointTree, radius: float, indices: AnyArray) -> None:
    """Raise ValueError if a radius has too many neighbors to search."""
    if tree.count * indices.size <= MAX_NEIGHBORS:
        return
    mean = count_around(tree, indices, 2 * radius)  # sync
    if mean * indices.size > MAX_NEIGHBORS:
        raise ValueError(
            f"radii: at {radius:.6g} m about {mean:,.0f} points are within twice the radius of each of "
            f"{indices.size:,}, {mean * indices.size:.1e} in total, and {MAX_NEIGHBORS:.1e} take minutes. Use a "
            "smaller radius, or call cloud.voxel_down_sample() with a voxel of half the radius first"
        )


def why_flat(cloud: PointCloud) -> str | None:
    """Reason why no alpha shape of the cloud has a tetrahedron, as a clause. None if some alpha does."""
    points = cloud.arrays["points"]
    return _flat_reason(cloud.select_rows(first_occurrences(points)).search_tree().count, points)


def _flat_reason(distinct: int, points: wp.array) -> str | None:
    if distinct < TETRAHEDRON_CORNERS:
        return f"there are {distinct} distinct finite points, fewer than {TETRAHEDRON_CORNERS}"
    _, _, covariance = mean_and_covariance(points)
    deviations = np.sqrt(np.maximum(eigvalsh(covariance), 0))  # ascending
    if deviations[1] <= MIN_DEVIATION_RATIO * deviations[2]:
        return "the points lie on one line"
    return "the points lie in one plane" if deviations[0] <= MIN_DEVIATION_RATIO * deviations[2] else None


def _used_points(shapes: list[wp.array], count: int) -> Iterator[tuple[wp.array, wp.array, int]]:
    """For each shape: mask of used points, their new indices, their count. One sync for several shapes."""
    for first in range(0, len(shapes), ALPHAS_PER_SYNC):
        used = [mark_referenced(triangles, count) for triangles in shapes[first : first + ALPHAS_PER_SYNC]]
        for mask, (offsets, (total,)) in zip(
            used, scan_together([(mask, [count]) for mask in used], largest=1), strict=True
        ):
            yield mask, offsets, total


def _used_rows(used: wp.array, offsets: wp.array, count: int) -> Indices:
    rows = empty(count, int32, used.device)
    launch(list_rows_kernel, used.size, [used, offsets, rows])
    return rows


def _check_alphas(alpha: object) -> tuple[list[float] | None, bool]:
    """Validate alphas. None for "auto". Also True if several were given."""
    if isinstance(alpha, str) and alpha == "auto":
        return None, False
    if isinstance(alpha, str):
        raise ValueError(f'alpha: expected a length [m], "auto" or a list of lengths, got {shown(alpha)}')
    is_list = isinstance(alpha, list | tuple) or getattr(alpha, "ndim", 0) == 1
    alphas = check_list("alpha", alpha, "lengths") if is_list else [alpha]
    if not 1 <= len(alphas) <= MAX_ALPHAS:
        raise ValueError(f"alpha: expected a list of 1 to {MAX_ALPHAS:,} lengths, got {len(alphas)}")
    return [check_positive("alpha", value, allow_infinite=True) for value in alphas], is_list


def _choose_alpha(tree: PointTree, points: wp.array) -> float:
    """AUTO times the median nearest neighbor distance; arbitrary with fewer than two points."""
    median = median_above_zero(nearest_distances(tree, points, others=True, missing=0.0))  # sync
    return 1.0 if median is None else AUTO_ALPHA * median


def _find_shapes(
    tree: PointTree, rows: wp.array, owners: int, alphas: list[float], with_tetrahedra: bool
) -> list[tuple[wp.array, Any]]:
    """Triangles and tetrahedra for each alpha, as rows of the cloud."""
    ascending = sorted(set(alphas))
    if tree.count < 4:
        none = empty((0, 4), int32, tree.device) if with_tetrahedra else None
        return [(empty(0, vec3i, tree.device), none) for _ in alphas]
    indices = gather_rows(rows, tree.order[: tree.count])
    shapes = find_alpha_shapes(tree, indices, owners, ascending, with_tetrahedra)
    return [shapes[ascending.index(alpha)] for alpha in alphas]


def extract_level(
    field: NDArray[Any], level: float, spacing: ArrayLike, origin: ArrayLike, device: Device
) -> tuple[wp.array, wp.array, NDArray[np.float64]]:
    """(vertices, triangles, origin): see `marching_cubes`."""
    values = _device_field(field, device)
    nx, ny, nz = values.shape
    level = _check_level(level)
    steps = check_shape("spacing", spacing, (3,))
    for step in steps:
        if check_positive("spacing", step) < _FLOAT_TINY:
            raise ValueError(f"spacing: {float(step)!r} is below the float32 range")
    corner = check_shape("origin", origin, (3,))
    far = corner + steps * (np.array(values.shape) - 1)
    if not np.isfinite(corner).all() or not max(np.abs(corner).max(), np.abs(far).max()) < _FLOAT_MAX:
        raise ValueError(
            f"origin, spacing: the grid from {corner.tolist()} to {far.tolist()} exceeds the float32 range"
        )
    mesh_origin = choose_origin(np.array([corner, far]), in_one_unit=True)
    rows = values.reshape((nx * ny, nz))
    vertices, triangles = extract_surface(rows, (nx, ny, nz), level, corner - mesh_origin, steps)
    return vertices, triangles, mesh_origin


def _check_level(level: object) -> float:
    number = check_number("level", level)
    if abs(number) > _FLOAT_MAX:
        raise ValueError(f"level: expected a finite number within float32, got {level!r}")
    return number


def _device_field(field: NDArray[Any], device: DeviceLike) -> wp.array:
    """Contiguous float32 device array (nx, ny, nz), without a copy if possible."""
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


def _upload_field(field: NDArray[Any], device: Device) -> wp.array:
    host = check_numeric("field", field)
    _check_grid(host.shape)
    with np.errstate(over="ignore"):  # overflow to infinity is intended: such cells are skipped
        host = np.ascontiguousarray(host, dtype=np.float32)
    return upload(host, wp.float32, device, copied=False)


def _check_grid(shape: tuple[int, ...]) -> None:
    if len(shape) != 3 or min(shape) < 2:
        raise ValueError(f"field: expected shape [nx, ny, nz] with at least 2 along each axis, got {list(shape)}")
