"""Evaluation of depth maps: `evaluate_depth`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.depth_range import DEPTH_SCALE
from ...core.checks import check_numeric, check_positive
from ...core.exchange import on_host

DELTA1_RATIO = 1.25  # threshold of delta1


@dataclasses.dataclass(frozen=True)
class DepthErrors:
    """Errors of a depth map over the pixels valid in both maps.

    Args:
        abs_rel: Mean of abs(z - true z) / true z.
        delta1: Fraction of pixels with z within a factor of 1.25.
        rmse: Root mean square difference [m].
        coverage: Fraction of pixels with true depth that have a depth.
        pixel_count: Number of compared pixels.
    """

    abs_rel: float
    delta1: float
    rmse: float
    coverage: float
    pixel_count: int


def evaluate_depth(depth: ArrayLike, truth: ArrayLike, *, depth_scale: float = DEPTH_SCALE) -> DepthErrors:
    """Compare a depth map with a true one of the same size, without alignment (see `estimate_depth`).

    Args:
        depth: Shape [h, w]. Integers are divided by `depth_scale`, floats are meters. <= 0, NaN and inf are invalid.
        truth: Likewise.
        depth_scale: Units per meter of integers.

    Returns:
        The standard metrics of depth estimation. NaN without common pixels.

    Raises:
        ValueError: A wrong shape, different sizes, or a scale out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photogrammetry.depth.evaluation import evaluate_depth
        >>> evaluate_depth(np.array([[1.1, 2.0, 0.0]]), np.array([[1.0, 2.0, 3.0]])).abs_rel.__round__(3)
        0.05
    """
    scale = check_positive("depth_scale", depth_scale)
    estimate, true = _metres("depth", depth, scale), _metres("truth", truth, scale)
    if estimate.shape != true.shape:
        raise ValueError(
            f"depth: expected shape {list(true.shape)} as of truth, got {list(estimate.shape)}; resize one"
        )
    known = true > 0
    both = known & (estimate > 0)
    z, t = estimate[both], true[both]
    if not len(z):
        return DepthErrors(np.nan, np.nan, np.nan, 0.0, 0)
    with np.errstate(over="ignore"):
        relative, difference = np.abs(z - t) / t, z - t
        close = np.maximum(z / t, t / z) < DELTA1_RATIO
        rmse = float(np.sqrt(np.mean(difference * difference)))
    return DepthErrors(float(relative.mean()), float(close.mean()), rmse, float(both.sum() / known.sum()), len(z))


def _metres(name: str, values: Any, scale: float) -> NDArray[np.float64]:
    array = check_numeric(name, on_host(name, values))
    if array.ndim != 2 or 0 in array.shape:
        raise ValueError(f"{name}: expected shape [h, w], got {list(array.shape)}")
    meters = array.astype(np.float64) / (1.0 if array.dtype.kind == "f" else scale)
    return np.where(np.isfinite(meters) & (meters > 0), meters, 0.0)
