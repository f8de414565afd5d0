"""Per-point data that ICP estimators need, given or computed on the device. Normals and colors must be given."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from ...core.array_libraries import view_as
from ...core.checks import check_numeric
from ...core.coordinates import ORIGIN_LIMIT
from ...core.exchange import on_host, share_vectors
from ...core.units import NonFiniteWarning, warn_of_units
from ...kernels.algebra.transform import transform_points
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.concatenation import joined_rows
from ...kernels.extent.masks import count_unusable, drop_unusable
from ...kernels.icp.color_gradients import average_colors, estimate_color_gradients
from ...kernels.icp.plane_covariances import flatten_covariances, plane_covariances, plane_covariances_from_normals
from ...kernels.lang import float32, vec3
from ...kernels.language.device_arrays import reinterpreted
from ...kernels.memory import cast, download, upload
from ...kernels.surface.orientation import normalize_vectors
from ...pcd.cached_tree import CachedTree
from ...pcd.cloud import PointCloud

GRADIENT_RADIUS = 2.0  # times the maximum correspondence distance, as in Open3D
GRADIENT_NEIGHBORS = 30
COVARIANCE_NEIGHBORS = 20  # as in the generalized ICP paper, Open3D and small_gicp


class ColoredSurface(NamedTuple):
    normals: wp.array
    intensities: wp.array
    gradients: wp.array


class DopplerMeasurements(NamedTuple):
    dopplers: wp.array
    directions: wp.array


def in_sensor_frame(cloud: PointCloud, name: str) -> PointCloud:
    if not cloud.origin.any():
        return cloud
    if np.abs(cloud.origin).max() > ORIGIN_LIMIT:
        raise ValueError(f"{name}: expected a scan in the frame of its sensor, within 10 km of the origin")
    arrays = {n: cloud.arrays[n] for n in cloud.arrays} | {"points": cloud.arrays.about(np.zeros(3))}
    return type(cloud).from_device_arrays(arrays, np.zeros(3), cloud.array_library)


@dataclass
class Side:
    """All sources or all targets, with the columns that the estimator requires: arrays by cloud, or one for all.

    `points`: usable points by cloud. `joined`: those of all clouds, if they are in one array. `tree`: the cached tree
    of one cloud whose points are all used.
    """

    clouds: Sequence[PointCloud]
    names: Sequence[str]
    columns: dict[str, list[Any]]
    points: Sequence[wp.array]
    joined: wp.array | None = None
    tree: CachedTree | None = None


def drop_unusable_points(sides: Sequence[Side], *, are_finite: bool = False) -> None:
    """Set the points to NaN with a NonFiniteWarning where a required column is not finite. Join many clouds.

    One sync, or none if all columns `are_finite`.
    """
    if (any(len(side.clouds) > 1 for side in sides) and _join_usable(sides, are_finite)) or are_finite:
        return
    columns = [
        [_as_rows(arrays[k]) for arrays in side.columns.values()] for side in sides for k in range(len(side.clouds))
    ]
    points, counts = drop_unusable([p for side in sides for p in side.points], columns)
    clouds, names = ([x for side in sides for x in getattr(side, name)] for name in ("clouds", "names"))
    required = [list(side.columns) for side in sides for _ in side.clouds]
    for k in np.flatnonzero(counts).tolist():
        lost = len(clouds[k]) - bound_points(points[k])[2]
        lost -= len(clouds[k]) - bound_points(clouds[k].arrays["points"])[2]
        warn_of_units(
            f"{names[k]}: {' or '.join(required[k])} of {lost:,} of {len(clouds[k]):,} points are not finite. "
            "These points are not used.",
            NonFiniteWarning,
        )
    for side in sides:
        side.points, points = points[: len(side.clouds)], points[len(side.clouds) :]


def _join_usable(sides: Sequence[Side], are_finite: bool) -> bool:
    """Join the clouds of each side if all their points are usable: one launch per column instead of one per cloud."""
    joined = [joined_rows(side.points) for side in sides]
    columns = [{name: [joined_rows(arrays)] for name, arrays in side.columns.items()} for side in sides]
    rows = [[_as_rows(c[0]) for c in arrays.values()] for arrays in columns]
    if not are_finite and count_unusable(joined, rows).any():  # sync
        return False
    for side, points, arrays in zip(sides, joined, columns, strict=True):
        side.joined, side.columns = points, arrays
    return True


def _as_rows(values: wp.array) -> wp.array:
    if values.dtype != vec3:
        return values
    shape = len(values), 3
    rows = reinterpreted(values, 0, float32, shape)
    return view_as(values, float32, shape) if rows is None else rows


def normals_of(clouds: Sequence[PointCloud], names: Sequence[str], method: str) -> list[wp.array]:
    for cloud, name in zip(clouds, names, strict=True):
        if "normals" not in cloud.arrays:
            remedy = f"call {name} = {name}.estimate_normals()"
            raise ValueError(f"{name}: {method} needs normals, and it has none; {remedy}")
    return [cloud.arrays["normals"] for cloud in clouds]


def require_colors(cloud: PointCloud, name: str) -> wp.array:
    if "colors" not in cloud.arrays:
        raise ValueError(f"{name}: colored ICP needs colors, and it has none; assign cloud.colors")
    return cloud.arrays["colors"]


def colored_source(cloud: PointCloud, name: str = "source") -> wp.array:
    """Intensities for colored ICP, float32 [n]: the mean of red, green and blue."""
    return average_colors(require_colors(cloud, name))


def colored_target(cloud: PointCloud, max_correspondence_distance: float, *, name: str = "target") -> ColoredSurface:
    """Normals, intensities and their tangential gradients of a colored ICP target.

    Gradients come from the 30 nearest neighbors within twice `max_correspondence_distance` [m], as in Open3D, but with
    the projection onto the tangent plane, which Open3D dropped in 2022.
    """
    (normals,) = normals_of([cloud], [name], "colored ICP")
    colors = require_colors(cloud, name)
    radius = GRADIENT_RADIUS * max_correspondence_distance
    gradients = estimate_color_gradients(cloud.search_tree(), normals, colors, radius, GRADIENT_NEIGHBORS)
    return ColoredSurface(normals, *gradients)


def generalized_covariances(cloud: PointCloud, epsilon: float, name: str = "cloud", *, flatten: bool = True):
    """Covariances for generalized ICP, float32 [n, 9]: planes of given ones, of normals or of 20 neighbors.

    Without `flatten`, given covariances are used as they are.
    """
    if "covariances" in cloud:
        rows = cloud.arrays["covariances"]
        if rows.shape != (len(cloud), 9):
            raise ValueError(f"{name}: expected covariances of shape [{len(cloud)}, 9], got {list(rows.shape)}")
        rows = rows if rows.dtype == float32 else cast(rows, float32)
        return flatten_covariances(rows, epsilon) if flatten else rows
    if "normals" in cloud.arrays:
        return plane_covariances_from_normals(cloud.arrays["normals"], epsilon)
    return plane_covariances(cloud.search_tree(), COVARIANCE_NEIGHBORS, epsilon)


def doppler_measurements(cloud: PointCloud, name: str = "source") -> DopplerMeasurements:
    """Radial speeds [m/s], float32 [n], and unit directions from the sensor (or "directions" [n, 3]), vec3 [n]."""
    if "dopplers" not in cloud:
        raise ValueError(
            f"{name}: Doppler ICP needs radial speeds, and it has none; assign cloud['dopplers'], shape [n] in m/s"
        )
    speeds = cloud.arrays["dopplers"]
    if speeds.shape not in ((len(cloud),), (len(cloud), 1)):
        raise ValueError(f"{name}: expected dopplers of shape [{len(cloud)}], got {list(speeds.shape)}")
    speeds = speeds.reshape(len(cloud))
    if speeds.dtype != float32:
        speeds = cast(speeds, float32)
    return DopplerMeasurements(speeds, _directions(cloud, name))


def _directions(cloud: PointCloud, name: str) -> wp.array:
    if "directions" in cloud:
        rows = cloud.arrays["directions"]
        if rows.shape != (len(cloud), 3):
            raise ValueError(f"{name}: expected directions of shape [{len(cloud)}, 3], got {list(rows.shape)}")
        return normalize_vectors(share_vectors("directions", rows if rows.dtype == float32 else cast(rows, float32)))
    points = cloud.arrays["points"]
    if cloud.origin.any():
        points = transform_points(points, np.eye(3), cloud.origin)
    return normalize_vectors(points)


def point_weights(clouds: Sequence[PointCloud], weights: ArrayLike | str, names: Sequence[str]) -> list[wp.array]:
    if not isinstance(weights, str) and len(clouds) > 1:
        raise ValueError(
            f"weights: expected one array per cloud, got one for {len(clouds)}. Set cloud['weights'] and pass its name"
        )
    columns = []
    for cloud, name in zip(clouds, names, strict=True):
        label = f"{name}[{weights!r}]" if isinstance(weights, str) else "weights"
        if isinstance(weights, str):
            if weights not in cloud:
                raise ValueError(f"weights: {name} has no attribute {weights!r}; assign {label}, shape [n]")
            values = download(cloud.arrays[weights])  # sync
        else:
            values = check_numeric("weights", on_host("weights", weights))
        if values.shape not in ((len(cloud),), (len(cloud), 1)):
            raise ValueError(f"{label}: expected shape [{len(cloud)}], got {list(values.shape)}")
        values = values.astype(np.float32).reshape(-1, 1)
        if not (np.isfinite(values) & (values >= 0)).all():
            worst = int(np.argmin(np.isfinite(values) & (values >= 0)))
            raise ValueError(f"{label}: expected finite weights >= 0, got {values[worst, 0]:g} at point {worst}")
        if len(values) and not values.any():
            raise ValueError(f"{label}: expected a weight above 0, got zeros only")
        columns.append(upload(values, float32, cloud.device))
    return columns
