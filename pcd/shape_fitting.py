"""One shape of least squared distances to all points of a cloud."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_finite, check_numeric, check_seed, shown
from ..core.told_arguments import told_arguments
from ..kernels.lang import float64
from ..kernels.memory import download, upload
from ..kernels.segmentation.shape_fit import ShapeFit, ShapeFitter
from ..kernels.segmentation.shape_models import CONE, PLANE
from ..kernels.segmentation.shape_rivals import COMPARED, FREE_SIZE
from ..kernels.segmentation.shape_rows import every_of, rows_of_weight, usable_in_order
from ..kernels.segmentation.shape_search import Found, ShapeLimits, ShapeSearch
from .cloud import PointCloud
from .point_arrays import check_cloud
from .shape import KINDS, UNKNOWNS, Shape
from .shape_verdicts import ROUNDING, fitted_shape

LEVELS = (0.1, 0.03, 0.01, 0.003)  # of the size of the cloud: how near points are to the starts that are tried
DRAWN, STARTS = 512, 4  # samples of a level, and how many of them are fitted
SPREAD = 3.0  # root mean squares within which nearly all points lie


@told_arguments
def fit_shape(
    cloud: PointCloud, kind: str, *, start: Shape | None = None, weights: ArrayLike | None = None, seed: int = 0
) -> Shape:
    """Fit a plane, sphere, cylinder, cone or torus to all points of a cloud, by least squared distances.

    `cloud.segment_sphere` and the others find a shape among points that are not on it; here all points are.

    Args:
        cloud: The points. Normals, where it has some, only help to find where to start.
        kind: "plane", "sphere", "cylinder", "cone" or "torus".
        start: A shape of this kind to start from; None finds one.
        weights: Of the points, [n], each 0 or more: 1 over the variance of its distance, but for a common factor.
            Points of weight 0 are left out. None weighs all alike.
        seed: Of the samples that starts are made of.

    Returns:
        The shape; `covariance` and `sigma` are from the points' own distances, `support` is how many points were used,
        `rms` the root of their weighted mean squared distance. `reasons` has what speaks against it, other kinds that
        fit better among them.

    Raises:
        TypeError: `start` is no Shape, or `kind` no string.
        ValueError: A kind that is none of the five, a start of another kind, weights that are negative, not finite, or
            not one a point, no more points than unknowns, all points equal, or none of the starts a shape.

    Notes:
        Distances are true ones, not algebraic (Lukacs, Martin and Marshall 1998), by the method of Levenberg and
        Marquardt in float64. The starts are the best of some 2,000 small samples at four distances, fitted to some
        4,000 of the points. One pass over all points a step, some 5 to 15 steps. The same bits from run to run. 60 B of
        memory a point. Points that are not finite are left out.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> turn, height = rng.random((2, 3000)) * [[np.pi], [1.0]]
        >>> pipe = np.column_stack([0.2 * np.cos(turn), 0.2 * np.sin(turn), height])
        >>> pipe += 0.001 * rng.normal(size=(3000, 3))
        >>> shape = loom.fit_shape(loom.PointCloud(pipe), "cylinder")
        >>> round(shape.radius, 3), shape.sigma["radius"] < 0.0001, shape.support, shape.is_sure
        (0.2, True, 3000, True)
    """
    check_cloud("cloud", cloud)
    if not isinstance(kind, str):
        raise TypeError(f"kind: expected one of {', '.join(KINDS)}, got {shown(kind)}")
    if kind not in KINDS:
        raise ValueError(f"kind: expected one of {', '.join(KINDS)}, got {shown(kind)}")
    if start is not None and not isinstance(start, Shape):
        raise TypeError(f"start: expected a Shape, got {type(start).__name__}")
    if start is not None and start.kind != kind:
        raise ValueError(f"start: expected a {kind}, got a {start.kind}")
    first, given = check_seed(seed), _check_weights(weights, len(cloud))
    search = _search_of(cloud, given)
    number, rows = KINDS.index(kind), search.rows
    if rows.size <= len(UNKNOWNS[kind]):
        have = f"the cloud has {rows.size} finite points" + (" with a weight" if given is not None else "")
        raise ValueError(f"cloud: a {kind} has {len(UNKNOWNS[kind])} unknowns, but {have}")
    if search.size <= 0.0:
        raise ValueError(f"cloud: all {rows.size:,} points are equal, which is no {kind}")
    fit = _best_start(search, number, first) if start is None else _fit(search, number, _numbers(start, search, cloud))
    if fit is None:
        raise ValueError(
            f"cloud: no {kind} found to start from: the points span none, or normals are too noisy; give `start`"
        )
    if start is None:
        fit = _fit(search, number, fit.shape)
    fit = _fit(search, number, fit.shape)
    reach = max(SPREAD * fit.rms, ROUNDING * search.size)
    limits = ShapeLimits(reach, 0.0, 0.0, FREE_SIZE * search.size)
    return fitted_shape(search, Found(number, fit, rows), limits, cloud.origin)


def _search_of(cloud: PointCloud, weights: NDArray[np.float64] | None) -> ShapeSearch:
    """The search among the finite points that have a weight, whose fits are weighted."""
    with_normals = cloud if cloud.has_normals() or len(cloud) == 0 else cloud.estimate_normals()
    points = cloud._device_array("points")
    normals = with_normals._device_array("normals") if len(cloud) else points
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
    """The best fit of many starts to some of the points."""
    rows, fits = search.rows, []
    if rows.size // COMPARED >= 2:
        rows = every_of(rows, rows.size // COMPARED)
    part = ShapeSearch(search.points, search.normals, rows, search)
    limits = ShapeLimits(0.0, 0.0, 0.0, FREE_SIZE * search.size)
    for level, share in enumerate(LEVELS):
        near = replace(limits, distance=share * search.size)
        drawn = part.draw(kind, DRAWN, seed, level * DRAWN, near)[0][:STARTS]
        if len(drawn):
            fits += search.fitter.fit_all([kind] * len(drawn), drawn, rows)
    fits = [fit for fit in fits if np.isfinite(fit.rms)]
    return min(fits, key=lambda fit: (bool(fit.reason), fit.rms), default=None)


def _fit(search: ShapeSearch, kind: int, shape: NDArray[np.float64]) -> ShapeFit:
    return search.fitter.fit(kind, shape, search.rows)


def _numbers(start: Shape, search: ShapeSearch, cloud: PointCloud) -> NDArray[np.float64]:
    """The eight numbers of a shape about the middle of a search."""
    kind = KINDS.index(start.kind)
    sizes = [start.radius, start.minor_radius]
    if kind == CONE:
        sizes = [np.cos(start.half_angle), np.sin(start.half_angle)]
    elif kind == PLANE:
        sizes = [1.0, 1.0]
    sizes = [size if np.isfinite(size) else 1.0 for size in sizes]
    return np.concatenate([start.center - cloud.origin - search.center, start.axis, sizes])


def _check_weights(weights: Any, count: int) -> NDArray[np.float64] | None:
    """Weights, one a point, none below zero; None where none were given."""
    if weights is None:
        return None
    given = check_finite("weights", np.asarray(check_numeric("weights", weights), np.float64))
    if given.shape != (count,):
        raise ValueError(f"weights: expected shape [{count}], one a point, got {list(given.shape)}")
    if (given < 0).any():
        row = int(np.argmax(given < 0))
        raise ValueError(f"weights: expected 0 or more, got {given[row]:g} at {row}")
    return given
