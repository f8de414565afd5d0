"""Least-squares fit of one shape to all points of a cloud."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.checks import check_finite, check_numeric, check_seed
from ..core.exchange import on_host
from ..core.false_alarms import is_chance
from ..kernels.lang import float64
from ..kernels.memory import download, upload
from ..kernels.segmentation.shape_alternatives import FREE_SIZE, MAX_COMPARED
from ..kernels.segmentation.shape_fit import ShapeFit, ShapeFitter
from ..kernels.segmentation.shape_models import CONE, PLANE
from ..kernels.segmentation.shape_rows import every_of, rows_of_weight, usable_in_order
from ..kernels.segmentation.shape_search import DetectedShape, ShapeLimits, ShapeSearch
from .cloud import PointCloud
from .point_arrays import check_cloud
from .search import NearestNeighborSearch
from .shape import KINDS, UNKNOWNS, Shape, check_kind
from .shape_checks import POSITION_ROUNDING, fitted_shape

INLIER_LEVELS = (0.1, 0.03, 0.01, 0.003)  # of the cloud's size: inlier distances of the initialization
SAMPLES_PER_LEVEL, FITS_PER_LEVEL = 512, 4  # samples per level, and fits of them
SPREAD_DEVIATIONS = 3.0  # root mean squares that contain nearly all points
# Deviation that neighbors have in common, relative to the radius or half a side: more is another shape. Chosen.
MAX_COMMON_DEVIATION = 0.05
CUBE_CELLS = 16  # cells along each edge of the cube of unrelated points


@explain_argument_errors
def fit_shape(
    cloud: PointCloud, kind: str, *, start: Shape | None = None, weights: ArrayLike | None = None, seed: int = 0
) -> Shape:
    """Fit a plane, sphere, cylinder, cone or torus to all points of a cloud by least squares.

    Levenberg-Marquardt on true distances in float64 (Lukacs, Martin and Marshall, "Faithful least-squares fitting",
    ECCV 1998). Bitwise reproducible. 60 B per point. Points that are not finite are ignored.

    Args:
        cloud: The points. Normals, if any, only help the initialization.
        kind: "plane", "sphere", "cylinder", "cone" or "torus".
        start: Initial shape of this kind. If None: searched.
        weights: (n,), >= 0, proportional to the inverse variance of distances. 0 ignores a point. If None: equal.
        seed: Random seed of the initialization.

    Returns:
        The shape; `covariance` and `sigma` from the residuals, `support` the points used, `rms` weighted. `warnings`
        lists failed checks, including other kinds that fit better.

    Raises:
        TypeError: If `start` is not a Shape, or `kind` is not a string.
        ValueError: If the kind, start or weights are invalid, there are too few distinct points, or no fit converges.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> turn, height = rng.random((2, 3000)) * [[np.pi], [1.0]]
        >>> pipe = np.column_stack([0.2 * np.cos(turn), 0.2 * np.sin(turn), height])
        >>> pipe += 0.001 * rng.normal(size=(3000, 3))
        >>> shape = loom.fit_shape(loom.PointCloud(pipe), "cylinder")
        >>> round(shape.radius, 3), shape.sigma["radius"] < 0.0001, shape.support, shape.reliable
        (0.2, True, 3000, True)
    """
    check_cloud("cloud", cloud)
    number = check_kind(kind)
    if start is not None and not isinstance(start, Shape):
        raise TypeError(f"start: expected a Shape, got {type(start).__name__}")
    if start is not None and start.kind != kind:
        raise ValueError(f"start: expected a {kind}, got a {start.kind}")
    first, given = check_seed(seed), _check_weights(weights, len(cloud))
    search = _search_of(cloud, given)
    rows = search.rows
    if rows.size <= len(UNKNOWNS[kind]):
        have = f"the cloud has {rows.size} finite points" + (" with a weight" if given is not None else "")
        raise ValueError(f"cloud: a {kind} has {len(UNKNOWNS[kind])} unknowns, but {have}")
    if search.size <= 0.0:
        raise ValueError(f"cloud: all {rows.size:,} points are equal and define no {kind}")
    fit = _best_start(search, number, first) if start is None else _fit(search, number, _numbers(start, search, cloud))
    if fit is None:
        raise ValueError(
            f"cloud: no {kind} found to start from: the points span none, or the normals are too noisy. Pass start"
        )
    if start is None:
        fit = _fit(search, number, fit.shape)
    fit = _fit(search, number, fit.shape)
    max_distance = max(SPREAD_DEVIATIONS * fit.rms, POSITION_ROUNDING * search.size)
    limits = ShapeLimits(max_distance, 0.0, 0.0, FREE_SIZE * search.size)
    shape = fitted_shape(search, DetectedShape(number, fit, rows), limits, cloud.origin)
    if shape.warnings:
        return shape
    used = download(every_of(rows, max(1, rows.size // MAX_COMPARED)))
    points = cloud.select_by_index(used).to(cloud.device, arrays="numpy").points
    relative = np.ones(len(used)) if given is None else np.sqrt(given[used] / given[used].mean())
    return replace(shape, warnings=_deviation_warnings(points, relative, shape))


def _deviation_warnings(points: NDArray[np.float64], relative: NDArray[np.float64], shape: Shape) -> tuple[str, ...]:
    """Failed checks of the distances, times relative weights: they may be chance, or neighbors deviate together."""
    points, first = np.unique(points, axis=0, return_index=True)  # equal points are no more evidence
    distances = shape.compute_distances(points) * relative[first]
    if is_chance(_chances(points, np.abs(distances), shape), len(shape.unknowns), least=len(points) // 2 + 1):
        unrelated = f"{len(points):,} unrelated points would fit a {shape.kind} as well by chance"
        return (f"too few points to decide: {unrelated} (rms {shape.rms:.3g} m)",)
    nearest = NearestNeighborSearch(points).knn_search(points, 2).indices[:, 1]
    common = float(np.sqrt(max((distances * distances[nearest]).mean(), 0.0)))
    size = {
        "plane": np.sqrt(np.diff(shape.extent[:, :2], axis=0).prod()) / 2,
        "cone": np.tan(shape.half_angle) * shape.extent[1, 2],
        "torus": shape.minor_radius,
    }.get(shape.kind, shape.radius)
    if common > MAX_COMMON_DEVIATION * size:
        return (f"not a {shape.kind}: neighbors deviate together by {common:.3g} m, {common / size:.0%} of its size",)
    return ()


def _chances(points: NDArray[np.float64], distances: NDArray[np.float64], shape: Shape) -> NDArray[np.float64]:
    """Probability of each distance from the shape for a uniform point in a cube around the points."""
    low, high = points.min(axis=0), points.max(axis=0)
    width = (high - low).max() / CUBE_CELLS
    axes = [(np.arange(CUBE_CELLS) + 0.5 - CUBE_CELLS / 2) * width + middle for middle in (low + high) / 2]
    cells = np.stack(np.meshgrid(*axes), -1).reshape(-1, 3)
    of_cells = np.sort(np.abs(shape.compute_distances(cells)))
    below = np.searchsorted(of_cells, np.maximum(distances, width), side="right") / len(cells)
    return below * np.minimum(distances / width, 1.0)  # a thin layer has a volume in proportion to its thickness


def _search_of(cloud: PointCloud, weights: NDArray[np.float64] | None) -> ShapeSearch:
    with_normals = cloud if "normals" in cloud.arrays or len(cloud) == 0 else cloud.estimate_normals()
    points = cloud.arrays["points"]
    normals = with_normals.arrays["normals"] if len(cloud) else points
    rows = usable_in_order(with_normals.search_tree(), points, points)
    if weights is None:
        return ShapeSearch(points, normals, rows)
    given = upload(weights, float64, points.device)
    rows = rows_of_weight(given, rows)
    search = ShapeSearch(points, normals, rows)
    used = weights[download(rows)]
    given = upload(weights / used.mean() if used.size else weights, float64, points.device)
    search.fitter = ShapeFitter(points, search.center, search.fitter.size, given)
    return search


def _best_start(search: ShapeSearch, kind: int, seed: int) -> ShapeFit | None:
    rows, fits = search.rows, []
    if rows.size // MAX_COMPARED >= 2:
        rows = every_of(rows, rows.size // MAX_COMPARED)
    part = ShapeSearch(search.points, search.normals, rows, search)
    limits = ShapeLimits(0.0, 0.0, 0.0, FREE_SIZE * search.size)
    for level, fraction in enumerate(INLIER_LEVELS):
        near = replace(limits, distance=fraction * search.size)
        drawn = part.draw(kind, SAMPLES_PER_LEVEL, seed, level * SAMPLES_PER_LEVEL, near)[0][:FITS_PER_LEVEL]
        if len(drawn):
            fits += search.fitter.fit_all([kind] * len(drawn), drawn, rows)
    fits = [fit for fit in fits if np.isfinite(fit.rms)]
    return min(fits, key=lambda fit: (bool(fit.reason), fit.rms), default=None)


def _fit(search: ShapeSearch, kind: int, shape: NDArray[np.float64]) -> ShapeFit:
    return search.fitter.fit(kind, shape, search.rows)


def _numbers(start: Shape, search: ShapeSearch, cloud: PointCloud) -> NDArray[np.float64]:
    """Eight parameters of a shape about the center of a search."""
    kind = KINDS.index(start.kind)
    sizes = [start.radius, start.minor_radius]
    if kind == CONE:
        sizes = [np.cos(start.half_angle), np.sin(start.half_angle)]
    elif kind == PLANE:
        sizes = [1.0, 1.0]
    sizes = [size if np.isfinite(size) else 1.0 for size in sizes]
    return np.concatenate([start.center - cloud.origin - search.center, start.axis, sizes])


def _check_weights(weights: object, count: int) -> NDArray[np.float64] | None:
    if weights is None:
        return None
    given = check_finite("weights", np.asarray(check_numeric("weights", on_host("weights", weights)), np.float64))
    if given.shape != (count,):
        raise ValueError(f"weights: expected shape [{count}], one per point, got {list(given.shape)}")
    if (given < 0).any():
        row = int(np.argmax(given < 0))
        raise ValueError(f"weights: expected numbers >= 0, got {given[row]:g} at {row}")
    return given
