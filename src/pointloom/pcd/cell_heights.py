"""Heights at the centers of cells as linear combinations of cell means, for exact sums of their correlated errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.array_types import Points
from ..kernels.linear_algebra import inv, matmul
from ..kernels.memory import download
from ..kernels.terrain.cells import CellGroups, FixedCells

Grid = NDArray[np.float64]
Mask = NDArray[np.bool_]
BATCH_CELLS = 1 << 14  # fitted at once, up to 10 kB each
# Maximum variance of the slope correction of a cell, in variances of a neighbor's mean: it adds a tenth to the variance
# of a cell whose neighbors have as many points.
MAX_SLOPE_VARIANCE = 0.1
MIN_CELLS = 7  # of a quadratic fit: its 6 coefficients, and one residual
MAX_FIT_VARIANCE = 1.0  # of an interpolated height, in variances of a cell's mean: no worse than a measured cell
# Maximum squared Mahalanobis distance of a center from the centroid of the cells of a fit: beyond it is extrapolation.
MAX_OFFSET = 1.0
# Degrees of freedom of a local spread. With 8, the standard deviation has a relative error of 25 %.
MIN_FREEDOM = 8.0
MAX_BIAS = 1e-4  # of a determined fit, per unit slope [cells] or curvature
RIDGE = 1e-10  # of a diagonal element: singular fits get a large variance instead of an exception


@dataclass(frozen=True, eq=False)
class CellHeights:
    """Heights of a cloud at cell centers. Arrays are (columns, rows), southernmost row first.

    Attributes:
        values: Heights about the origin of the points. NaN if empty.
        filled: Cells without points.
        weights: Sparse matrix (cells, cells): heights from cell means.
        variance: Variance of each cell's mean.
        fit_error: Error of the fit in `filled` cells that its order causes, 0 elsewhere.
        roughness: Variance of cell means about the fit beyond that of their errors, likewise. Negative by chance.
        reach: Range of the correlation of both.
    """

    values: Grid
    filled: Mask
    weights: Any
    variance: Grid
    fit_error: Grid
    roughness: Grid
    reach: int

    def cell_variance(self) -> Grid:
        """Variance of each height."""
        random = self.weights.multiply(self.weights) @ self.variance.ravel()
        return random.reshape(self.values.shape) + self.fit_error**2 + np.maximum(self.roughness, 0.0)

    def sum_variance(self, cells: Mask) -> float:
        """Variance of the sum of the heights of some cells.

        The sum is a linear combination of cell means, whose errors are independent. The errors of fits in gaps are
        correlated: from 1 at the same cell, linearly along each axis, to 0 at `reach` cells.
        """
        shares = self.weights.T @ cells.ravel().astype(np.float64)
        size = self._near(self.filled)
        rough = np.divide(self._near(self.roughness), size, out=np.zeros(size.shape), where=size > 0.5)
        rough = np.sqrt(np.maximum(rough, 0.0)) * self._near(self.filled & cells)
        fit_error = self._near(np.where(cells, self.fit_error, 0.0))
        systematic = float((fit_error**2 + rough**2).sum()) / self.reach**2
        return float((shares**2 * self.variance.ravel()).sum()) + systematic

    def _near(self, values: NDArray[Any]) -> Grid:
        """Sums over squares of `reach` cells."""
        from scipy.ndimage import uniform_filter  # slow import

        padded = np.pad(values.astype(np.float64), self.reach // 2 + 1)
        return uniform_filter(padded, self.reach, mode="constant") * self.reach**2


@dataclass(frozen=True, eq=False)
class _Level:
    """Cells of 2^number fine cells along an edge.

    Attributes:
        count: Measured fine cells in each, (columns, rows).
        places: Mean x, y of their points [fine cells], and mean products xx, xy, yy about it, (5, columns, rows).
        members: Sparse matrix (cells, fine cells) of means.
    """

    number: int
    count: Grid
    places: Grid
    members: Any

    def coarser(self) -> _Level:
        from scipy.sparse import csr_array  # slow import

        columns, rows = ((size + 1) >> 1 for size in self.count.shape)
        i, j = np.nonzero(self.count)
        parent, count, (x, y, xx, xy, yy) = (i >> 1) * rows + (j >> 1), self.count[i, j], self.places[:, i, j]
        totals: Grid = np.asarray(np.bincount(parent, count, columns * rows), np.float64)
        shares = count / totals[parent]
        x0, y0 = (np.bincount(parent, shares * each, columns * rows) for each in (x, y))
        u, v = x - x0[parent], y - y0[parent]
        products = [np.bincount(parent, shares * each, columns * rows) for each in (xx + u * u, xy + u * v, yy + v * v)]
        parts = csr_array((shares, (parent, i * self.count.shape[1] + j)), (columns * rows, self.count.size))
        places = np.array([x0, y0, *products], np.float64).reshape(5, columns, rows)
        return _Level(self.number + 1, totals.reshape(columns, rows), places, parts @ self.members)


@dataclass(frozen=True, eq=False)
class _Neighbors:
    """Cells of a level around n centers, (n, k): number, measured fine cells, and terms of a quadratic surface.

    The terms are the means of u, v, uu, uv and vv over the points, (5, n, k), from the center in edges of the level.
    """

    numbers: NDArray[np.int64]
    count: Grid
    terms: Grid

    def slopes(self) -> tuple[Grid, Grid, Grid, Grid, Grid]:
        """Weights of a least-squares slope along u and v, and its covariance uu, uv, vv. Infinite if undefined."""
        total = np.maximum(self.count.sum(axis=1, keepdims=True), 1.0)
        u, v = (p - (self.count * p).sum(axis=1, keepdims=True) / total for p in self.terms[:2])
        uu, uv, vv = ((self.count * a * b).sum(axis=1, keepdims=True) for a, b in ((u, u), (u, v), (v, v)))
        scale = uu * vv - uv * uv
        known = scale > RIDGE * (uu + vv) ** 2
        scale = np.where(known, scale, np.inf)
        along = self.count * (vv * u - uv * v) / scale, self.count * (uu * v - uv * u) / scale
        spread_u, spread_v = (np.where(known, part / scale, np.inf)[:, 0] for part in (vv, uu))
        return *along, spread_u, (-uv / scale)[:, 0], spread_v


def _around(level: _Level, x: NDArray[np.int64], y: NDArray[np.int64], reach: int) -> _Neighbors:
    columns, rows = level.count.shape
    step = np.arange(-reach, reach + 1)
    i, j = (x >> level.number)[:, None, None] + step[:, None], (y >> level.number)[:, None, None] + step
    inside = (i >= 0) & (i < columns) & (j >= 0) & (j < rows)
    i, j, inside = (np.broadcast_to(each, inside.shape).reshape(len(x), -1) for each in (i, j, inside))
    i, j = np.where(inside, i, 0), np.where(inside, j, 0)
    count, edge = np.where(inside, level.count[i, j], 0.0), float(1 << level.number)
    u, v, uu, uv, vv = level.places[:, i, j]
    u, v = (u - x[:, None] - 0.5) / edge, (v - y[:, None] - 0.5) / edge
    terms = np.stack([u, v, uu / edge**2 + u * u, uv / edge**2 + u * v, vv / edge**2 + v * v])
    return _Neighbors(i * rows + j, count, np.where(count > 0, terms, 0.0))


class _Pyramid:
    """Cell means at all levels, and the weights of fits to them. Cells are numbered by column, then row."""

    def __init__(self, found: Grid, max_level: int) -> None:
        from scipy.sparse import diags_array  # slow import

        count, u, v, means, uu, uv, vv = found[:7]
        known = (count > 0).astype(np.float64)
        columns, self.rows = count.shape
        places = [u + np.arange(columns)[:, None] + 0.5, v + np.arange(self.rows) + 0.5]
        places += [part / np.maximum(count, 1.0) for part in (uu, uv, vv)]
        measured = diags_array(known.ravel(), format="csr")
        self.levels = [_Level(0, known, np.stack(places), measured)]
        while len(self.levels) <= max_level and max(self.levels[-1].count.shape) > 1:
            self.levels.append(self.levels[-1].coarser())
        self.means = [level.members @ means.ravel() for level in self.levels]
        self.parts: list[tuple[int, NDArray[np.int64], NDArray[np.int64], Grid]] = []

    def fit(self, cells: NDArray[np.int64], fit: Any) -> NDArray[np.int64]:
        """Apply `fit` to cells in growing neighborhoods until it accepts them. Returns the cells that it rejects."""
        for number, reach in [(0, 1), (0, 2), (0, 3), *((number, 2) for number in range(1, len(self.levels)))]:
            rejected = [cells[:0]]
            for first in range(0, len(cells), BATCH_CELLS):
                batch = cells[first : first + BATCH_CELLS]
                near = _around(self.levels[number], *np.divmod(batch, self.rows), reach)
                with np.errstate(invalid="ignore"):  # NaN is rejected
                    weights, accepted = fit(batch, near, number)
                used = (weights != 0) & accepted[:, None]
                rows = np.broadcast_to(batch[:, None], used.shape)[used]
                self.parts.append((number, rows, near.numbers[used], weights[used]))
                rejected.append(batch[~accepted])
            cells = np.concatenate(rejected)
        return cells

    def weights(self) -> Any:
        """Sparse matrix (cells, cells): heights from cell means."""
        from scipy.sparse import csr_array  # slow import

        total = self.levels[0].members
        for level in self.levels:
            parts = [part[1:] for part in self.parts if part[0] == level.number]
            if parts:
                rows, numbers, weights = (np.concatenate(each) for each in zip(*parts, strict=True))
                added = csr_array((weights, (rows, numbers)), (total.shape[0], level.count.size))
                total = total + added @ level.members
        return total.tocsr()


def center_heights(points: Points, window: FixedCells, max_gap: int) -> CellHeights:
    """Heights at cell centers, with gaps of up to `max_gap` cells between measured cells.

    A measured cell has the mean height of its points, moved to the center along the slope of its neighbors. A cell in a
    gap has the height of a quadratic surface through the cells around it. Both use the smallest neighborhood that
    determines the fit.
    """
    max_gap = min(max_gap, max(window.columns, window.rows))
    found = np.asarray(download(CellGroups(points, window).moments()))
    found = np.moveaxis(found.reshape(window.columns, window.rows, 10), 2, 0)
    count, mean_u, mean_v = found[:3]
    pyramid = _Pyramid(found, max(max_gap, 1).bit_length())
    slopes, bends, fit_error = np.zeros((2, count.size)), np.zeros((3, count.size)), np.zeros((2, count.size))
    flat_u, flat_v = mean_u.ravel(), mean_v.ravel()

    def correct(cells: NDArray[np.int64], near: _Neighbors, number: int) -> tuple[Grid, Mask]:
        values, edge = pyramid.means[number][near.numbers], float(1 << number)
        along_u, along_v, uu, uv, vv = near.slopes()
        u, v = flat_u[cells] / edge, flat_v[cells] / edge
        accepted = u * u * uu + 2 * u * v * uv + v * v * vv <= MAX_SLOPE_VARIANCE
        slopes[:, cells[accepted]] = [(part * values).sum(axis=1)[accepted] / edge for part in (along_u, along_v)]
        weights = -(u[:, None] * along_u + v[:, None] * along_v)
        bends[:, cells[accepted]] = (weights * near.terms[2:]).sum(axis=2)[:, accepted] * edge**2
        return weights, accepted

    def interpolate(cells: NDArray[np.int64], near: _Neighbors, number: int) -> tuple[Grid, Mask]:
        weights, accepted = np.zeros(near.count.shape), (near.count > 0).sum(axis=1) >= MIN_CELLS
        near = _Neighbors(near.numbers[accepted], near.count[accepted], near.terms[:, accepted])
        values, noise = pyramid.means[number][near.numbers], variances[number][near.numbers]
        weights[accepted], fit_error[:, cells[accepted]], accepted[accepted] = _center_fit(near, values, noise)
        return weights, accepted

    filled = _gaps(count > 0, max_gap)
    pyramid.fit(np.flatnonzero(count > 0), correct)
    variance = _variance(found, slopes.reshape(2, *count.shape))
    variances = [level.members @ variance.ravel() for level in pyramid.levels]
    missed = pyramid.fit(np.flatnonzero(filled), interpolate)
    filled.ravel()[missed], fit_error[:, missed] = False, 0.0
    weights = pyramid.weights()
    heights = (weights @ pyramid.means[0]).reshape(count.shape)
    heights[(count == 0) & ~filled] = np.nan
    bends = bends.reshape(3, *count.shape) + pyramid.levels[0].places[2:] + [mean_u**2, mean_u * mean_v, mean_v**2]
    heights -= np.where(count > 0, (bends * _curvature(heights)).sum(axis=0), 0.0)
    return CellHeights(
        heights, filled, weights, variance, *fit_error.reshape(2, *count.shape), reach=2 * max(max_gap, 1)
    )


def _curvature(heights: Grid) -> Grid:
    """Coefficients of uu, uv and vv of a quadratic fit to 5 x 5 heights. Where one is empty: the nearest ones."""
    from scipy.ndimage import correlate, distance_transform_edt  # slow import

    bend, slope = np.array([2.0, -1.0, -2.0, -1.0, 2.0]) / 14, np.arange(-2.0, 3.0) / 10
    kernels = np.outer(bend, np.ones(5) / 5), np.outer(slope, slope), np.outer(np.ones(5) / 5, bend)
    found = np.stack([correlate(heights, kernel, mode="constant", cval=np.nan) for kernel in kernels])
    unknown = ~np.isfinite(found[0])
    if unknown.all():
        return np.zeros(found.shape)
    nearest: Any = distance_transform_edt(unknown, return_distances=False, return_indices=True)
    return found[:, *nearest]


def _gaps(known: Mask, max_gap: int) -> Mask:
    """Empty cells between measured ones that are at most `max_gap` cells apart. Cells outside are none."""
    from scipy.ndimage import binary_closing  # slow import

    cells = (max_gap + 1) // 2
    if not cells or known.all():
        return np.zeros(known.shape, bool)
    square = np.ones((2 * cells + 1, 2 * cells + 1), bool)
    closed = np.asarray(binary_closing(np.pad(known, cells), square), bool)[cells:-cells, cells:-cells]
    return closed & ~known


def _center_fit(near: _Neighbors, values: Grid, variance: Grid) -> tuple[Grid, Grid, Mask]:
    """Weights of a quadratic fit at the centers, its error and roughness, and whether it is well determined.

    The fit error is the difference to a linear fit, times 3 times the ratio of the residuals of both. The factor covers
    the summit of a cone in the gap, around which the surface is nearly quadratic. `variance` is that of the means of
    fine cells. The roughness is the variance of their residuals beyond it.
    """
    along_u, along_v, uu, uv, vv = near.slopes()
    total = np.maximum(near.count.sum(axis=1), 1.0)
    u, v = ((near.count * p).sum(axis=1) / total for p in near.terms[:2])
    offset = total * (u * u * uu + 2 * u * v * uv + v * v * vv)
    linear = near.count / total[:, None] - u[:, None] * along_u - v[:, None] * along_v
    terms = np.stack([np.ones(near.count.shape), *near.terms], axis=2)
    weighted = terms * near.count[:, :, None]
    by_term = weighted.transpose(0, 2, 1)
    normal = matmul(by_term, terms)
    normal += RIDGE * total[:, None, None] * np.eye(6)
    inverse = inv(normal)
    weights = matmul(weighted, inverse[:, :, :1])[:, :, 0]
    scale = np.divide(weights**2, near.count, out=np.zeros(weights.shape), where=near.count > 0).sum(axis=1)
    weights /= weights.sum(axis=1, keepdims=True)
    moved = matmul(weights[:, None], terms)[
        :, 0, 1:
    ]  # 0 unless the cells are in few rows, and the surface is ambiguous
    accepted = (offset <= MAX_OFFSET) & (scale <= MAX_FIT_VARIANCE) & (np.abs(moved).max(axis=1) <= MAX_BIAS)
    plane = [(part * values).sum(axis=1, keepdims=True) for part in (linear, along_u, along_v)]
    flat = values - plane[0] - plane[1] * near.terms[0] - plane[2] * near.terms[1]
    curved = values - matmul(terms, matmul(inverse, matmul(by_term, values[:, :, None])))[:, :, 0]
    before, after = ((near.count * part**2).sum(axis=1) for part in (flat, curved))
    ratio = np.sqrt(np.divide(after, before, out=np.ones(len(before)), where=before > 0))
    fit_error = ((weights - linear) * values).sum(axis=1) * np.minimum(3 * ratio, 1.0)
    known = (near.count > 0).sum(axis=1)
    roughness = after / np.maximum(known - 6, 1) - (near.count * variance).sum(axis=1) / total
    return weights, np.stack([fit_error, roughness]), accepted


def _variance(found: Grid, slopes: Grid) -> Grid:
    """Variance of the mean of each cell, 0 if empty: the spread about the slope in 3 x 3 cells, else that of all."""
    from scipy.ndimage import convolve  # slow import

    count, (uu, uv, vv, uz, vz, zz), (a, b) = found[0], found[4:], slopes
    squares = zz - 2 * (a * uz + b * vz) + a * a * uu + 2 * a * b * uv + b * b * vv
    freedom = np.maximum(count - 1, 0.0)
    pooled = squares.sum() / freedom.sum() if freedom.any() else np.nan
    near_squares, near_freedom = (
        convolve(values, np.ones((3, 3)), mode="constant") for values in (np.maximum(squares, 0.0), freedom)
    )
    local = np.divide(near_squares, near_freedom, out=np.full(count.shape, pooled), where=near_freedom >= MIN_FREEDOM)
    return np.divide(local, count, out=np.zeros(count.shape), where=count > 0)
