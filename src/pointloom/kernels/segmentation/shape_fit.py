"""Least-squares shape fit by Levenberg-Marquardt on true distances, in float64.

Lukacs, Martin and Marshall, "Faithful least-squares fitting of spheres, cylinders, cones and tori", ECCV 1998. Unknowns
are shifts in a frame (u, v, a) along the axis a, tilts to u and v, scaled as lengths, and sizes. All fits run on the
device (`shape_steps`) with one sync.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..array_types import Array1, Doubles, Indices, Points, Vectors
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide, read_together
from ..lang import float64, int32, launch, loop_while, reduce, reduce_segments, uint8, vec3d
from ..linear_algebra import eigh, matmul, norm
from ..memory import download, empty
from .shape_fit_rows import (
    COUNT_AT,
    SELECTION_PHASE,
    SQUARES_AT,
    FitRules,
    ShapeFits,
    add_fit_rows,
    add_weighted_fit_rows,
    fit_sums,
    list_fit_rows_kernel,
    select_fit_rows_kernel,
    sum_moments,
)
from .shape_models import CONE, CYLINDER, PLANE, SHAPE_NUMBERS, SPHERE, TORUS
from .shape_steps import step_fits_kernel, update_running_kernel

MIN_EIGENVALUE_RATIO = 1.0e-11  # eigenvalue ratio of the scaled system below which a fit is undetermined
EXACT_GAIN = 1.0e-13  # of the squared distances: a smaller gain ends a fit
ROUGH_GAIN = 1.0e-7  # the same for fits that are only compared or fitted again
NAMES = ("shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", "first", "second")
FREE_ENTRIES = {PLANE: [2, 3, 4], SPHERE: [0, 1, 2, 5], CYLINDER: [0, 1, 3, 4, 5], CONE: [0, 1, 2, 3, 4, 5]}
FREE_ENTRIES[TORUS] = [0, 1, 2, 3, 4, 5, 6]
Shapes = Sequence[NDArray[np.float64]] | NDArray[np.float64]


@dataclass(frozen=True)
class ShapeFit:
    """Result of a fit: `shape` float64 [8] relative to the center, covariance of the FREE_ENTRIES in
    `frame` (rows u, v, a), `rms` distance [m], point count, and the reason if it is undetermined."""

    shape: NDArray[np.float64]
    covariance: NDArray[np.float64]
    frame: NDArray[np.float64]
    rms: float
    count: int
    reason: str


@dataclass(frozen=True)
class FlatFit:
    """Plane fit: shape float64 [8] relative to the center, and rms distance [m]."""

    shape: NDArray[np.float64]
    rms: float


@dataclass(frozen=True)
class Selection:
    """Inlier limits for fits that select their rows: distance [m] (exclusive), minimum cosine between normals, sizes
    [m], and maximum number of fits per shape."""

    normals: Vectors
    threshold: float
    cosine: float
    smallest: float
    largest: float
    max_rounds: int


def frame_of(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    u = np.cross(np.eye(3)[np.argmin(np.abs(direction))], direction)
    u /= norm(u)
    return np.stack([u, np.cross(direction, u), direction])


def is_proper(kind: int, shape: NDArray[np.float64]) -> bool:
    return bool(np.isfinite(shape).all()) and (
        kind == PLANE or (shape[6] > 0 and (kind in (SPHERE, CYLINDER) or shape[7] > 0))
    )


def flat_fit(sums: NDArray[np.float64], count: int) -> FlatFit:
    """Plane from sums around the center. Float64 resolves distances of 1e-8 of the point extent."""
    sums = sums.reshape(-1) / max(count, 1)
    mean, products = sums[:3], np.zeros((3, 3))
    products[np.triu_indices(3)] = sums[3:9]
    products += np.triu(products, 1).T
    values, vectors = eigh(products - np.outer(mean, mean))
    return FlatFit(np.concatenate([mean, vectors[:, 0], [1.0, 1.0]]), float(np.sqrt(max(values[0], 0.0))))


class ShapeFitter:
    def __init__(
        self, points: Points, center: NDArray[np.float64], size: float, weights: Doubles | None = None
    ) -> None:
        """`size` [m] is the extent of the points around `center`. Weights have a mean of one."""
        self.points, self.center, self.size, self.weights = points, center, size, weights

    def fit(self, kind: int, shape: NDArray[np.float64], rows: Indices) -> ShapeFit:
        """Least-squares fit to `points[rows]` from an initial shape. One sync. Planes and cylinders are centered
        first."""
        return self.fit_all([kind], [shape], rows, EXACT_GAIN)[0]

    def fit_all(
        self, kinds: ArrayLike, shapes: Shapes, rows: Indices, gain: float = ROUGH_GAIN, hopeless: float = 0.0
    ) -> list[ShapeFit]:
        """Fits to the same rows from several shapes. One sync. Stops those with an rms above `hopeless` [m] (0:
        none)."""
        results = self._run(kinds, shapes, rows, None, gain, hopeless)
        return [
            self.fit_of(int(kind), shape, sums)
            for kind, shape, sums in zip(results["kinds"], results["shapes"], results["sums"], strict=True)
        ]

    def refine_all(
        self, kinds: ArrayLike, shapes: Shapes, rows: Indices, chosen: Selection, gain: float = ROUGH_GAIN
    ) -> list[tuple[ShapeFit, int] | None]:
        """Fit each shape to its inliers among `rows` while these increase. One sync: (fit, inlier count), or None."""
        results = self._run(kinds, shapes, rows, chosen, gain)
        each = zip(results["kinds"], results["bests"], results["best_sums"], results["best_counts"], strict=True)
        return [
            (self.fit_of(int(kind), shape, sums), int(count)) if count >= 0 else None
            for kind, shape, sums, count in each
        ]

    def fit_plane(self, rows: Indices) -> FlatFit:
        """Unweighted least-squares plane of `points[rows]`. One sync."""
        return flat_fit(download(self.add_moments(rows)), rows.size)  # sync

    def add_moments(self, rows: Indices) -> Array1[Any]:
        return reduce(sum_moments, rows.size, [self.points, rows, vec3d(*self.center)])

    def fit_of(self, kind: int, shape: NDArray[np.float64], sums: NDArray[np.float64]) -> ShapeFit:
        """Fit statistics from the sums at a shape."""
        free, count, squares = np.array(FREE_ENTRIES[kind]), int(sums[COUNT_AT]), max(float(sums[SQUARES_AT]), 0.0)
        scales = np.array([1.0, 1, 1, self.size, self.size, self.size if kind == CONE else 1, 1])[free]
        full = np.zeros((8, 8))
        full[np.triu_indices(8)] = sums[:COUNT_AT]
        full += np.triu(full, 1).T
        h = full[np.ix_(free, free)] / np.outer(scales, scales)
        reason, covariance = "", np.full((len(free), len(free)), np.inf)
        if count <= len(free):
            reason = f"{count} points do not say how well {len(free)} unknowns are known"
        elif not (np.isfinite(h).all() and is_proper(kind, shape)):
            reason = "the fit has left what is a shape"
        else:
            d = 1 / np.sqrt(np.maximum(np.diag(h), 1e-300))
            values, vectors = eigh(h * np.outer(d, d))
            if values[0] <= MIN_EIGENVALUE_RATIO * values[-1]:
                weak = NAMES[free[int(np.argmax(np.abs(vectors[:, 0])))]]
                reason = f"the points leave {weak} open"
            else:
                inverse = matmul(vectors / values, vectors.T) * np.outer(d, d)
                covariance = inverse / np.outer(scales, scales) * squares / (count - len(free))
        frame = np.eye(3) if kind == SPHERE else frame_of(shape[3:6])
        return ShapeFit(shape.copy(), covariance, frame, float(np.sqrt(squares / max(count, 1))), count, reason)

    def _run(
        self,
        kinds: ArrayLike,
        shapes: Shapes,
        rows: Indices,
        chosen: Selection | None,
        gain: float,
        hopeless: float = 0.0,
    ) -> dict[str, NDArray]:
        device, n = self.points.device, rows.size
        states = SideBySide(_first_state(kinds, shapes, chosen), device)
        k = states.arrays["kinds"].size
        fits = ShapeFits()
        for name, values in states.arrays.items():
            setattr(fits, name, values)
        fits.rows, fits.jobs, fits.mask = (empty(k * n, kind, device) for kind in (int32, int32, uint8))
        launch(list_fit_rows_kernel, k * n, [rows, fits])
        rules = FitRules()
        rules.size, rules.gain, rules.hopeless = self.size, gain, hopeless * hopeless
        rules.threshold = rules.cosine = rules.smallest = rules.largest = 0.0
        if chosen is not None:
            rules.threshold, rules.cosine = chosen.threshold, chosen.cosine
            rules.smallest, rules.largest = chosen.smallest, chosen.largest
        blocks = SegmentBlocks(np.arange(k) * n, np.full(k, n), device)
        partials, trials = blocks.partials(fit_sums), empty(k, fit_sums, device)
        center = vec3d(*self.center)

        def iterate() -> None:
            if chosen is not None:
                launch(select_fit_rows_kernel, k * n, [self.points, chosen.normals, center, rules, fits])
            if self.weights is None:
                given, reduction = [self.points, center, fits], add_fit_rows
            else:
                given, reduction = [self.points, self.weights, center, fits], add_weighted_fit_rows
            reduce_segments(reduction, blocks, fits.live, given, partials, trials)
            launch(step_fits_kernel, k, [rules, trials, fits])
            launch(update_running_kernel, 1, [fits])

        if n:
            loop_while(fits.running, iterate)
        names = ("shapes", "sums") if chosen is None else ("bests", "best_sums", "best_counts")
        results = dict(zip(names, read_together([states.arrays[name] for name in names]), strict=True))  # sync
        return {"kinds": np.asarray(kinds), **results}


def _first_state(kinds: ArrayLike, shapes: Shapes, chosen: Selection | None) -> dict[str, tuple[ArrayLike, type]]:
    of, given = np.asarray(kinds), np.asarray(shapes, np.float64).reshape(-1, SHAPE_NUMBERS)
    k, width = len(of), len(fit_sums(0.0))
    axes = [np.eye(3) if kind == SPHERE else frame_of(shape[3:6]) for kind, shape in zip(of, given, strict=True)]
    frames = np.reshape(axes, (k, 3, 3))
    rounds = 0 if chosen is None else chosen.max_rounds
    return {
        "shapes": (given, float64),
        "offers": (given, float64),
        "bests": (given, float64),
        "frames": (frames, vec3d),
        "sums": (np.zeros((k, width)), fit_sums),
        "best_sums": (np.zeros((k, width)), fit_sums),
        "dampings": (np.zeros(k), float64),
        "longest": (np.zeros(k), float64),
        "kinds": (of, int32),
        "phases": (np.full(k, SELECTION_PHASE), int32),
        "steps": (np.zeros(k), int32),
        "rounds": (np.zeros(k), int32),
        "max_rounds": (np.full(k, rounds), int32),
        "best_counts": (np.full(k, -1), int32),
        "live": (np.ones(k), int32),
        "running": (np.ones(1), int32),
    }
