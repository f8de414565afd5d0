"""The shape of a kind with the most points on it: samples are scored, the best refined, where the points are.

After Schnabel, Wahl and Klein 2007. Samples come in batches; each is scored on a part of the points, every n-th along
the Hilbert curve, and those that promise the most there on all of them; the best few of all batches are fitted to their
points again and again while these grow in number. Points must be in the order of the tree, in which runs are compact.
24 B of memory a point, and 68 B a sample.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..array_types import AnyArray, Array1, Indices, Integers, Mask, Points, Vectors
from ..arrays.bounds import bound_points, box_of, find_extremes, fold_box_kernel
from ..arrays.select import gather_rows, positions_of
from ..arrays.side_by_side import read_together
from ..arrays.sort import argsort_keys
from ..lang import array, atomic_max, dot, float32, float64, int32, int64, kernel, launch, sqrt, tid, uint8, vec3, vec3d
from ..memory import download, empty, upload, zeros
from .plane_samples import sampled_point
from .shape_fit import EXACT, ROUGHLY, Selection, ShapeFit, ShapeFitter, Shapes, frame_of
from .shape_fit_rows import is_on
from .shape_models import CONE, CYLINDER, NUMBERS, PLANE, SPHERE, TORUS, ShapePoints, split_points_kernel
from .shape_rows import every_of
from .shape_samples import LEAST_WINDOW, draw_shapes_kernel
from .shape_scores import score_shapes

SAMPLE_POINTS = {PLANE: 3, SPHERE: 2, CYLINDER: 2, CONE: 3, TORUS: 4}
PART = 2048  # points that all samples are scored on
FIRST_BATCH, BATCH_GROWTH, MOST_BATCH = 256, 4, 8192
PROMISING = 16  # samples of a batch that are scored on all points
REFINED = 6  # samples that are fitted to their points
FITTED_PART = 4096  # points at most that the best few samples are fitted to first
MOST_FITS = 6  # of one sample, each to the points of the one before
SECTORS, BANDS = 36, 18  # cells around a shape, along it: what share of them has points is its coverage
STREAM = 7919  # kinds draw from seeds that lie so far apart


@dataclass(frozen=True)
class ShapeLimits:
    """What makes a point one of a shape, and what sizes shapes have.

    Attributes:
        distance: From the surface [m], excluded.
        cosine: Least between the point's normal and the surface's, whichever way they face.
        smallest, largest: Radius [m] of a sphere, a cylinder, a torus (its tube's, its ring's).
    """

    distance: float
    cosine: float
    smallest: float
    largest: float

    def allow(self, kind: int, shape: NDArray[np.float64]) -> bool:
        """Whether a shape has such a size."""
        if kind in (PLANE, CONE):
            return True
        return bool(shape[7 if kind == TORUS else 6] >= self.smallest and shape[6] <= self.largest)


Drawn = tuple[NDArray[np.float64], NDArray[np.int64]]  # shapes, and how many points are on each


@dataclass(frozen=True)
class Found:
    """A shape, its points and how it fits them.

    Attributes:
        kind: Of `shape_models`.
        fit: The fit to the points, relative to the middle of the search.
        rows: int32 device array, the points within the limits of the fitted shape, in the order of the search.
    """

    kind: int
    fit: ShapeFit
    rows: Indices


@kernel
def mask_on_shape_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    a: vec3d,
    sizes: vec3d,
    threshold: float64,
    least_cosine: float64,
    mask: array(dtype=uint8),
):
    """1 where a point is one of a shape, in float64."""
    i = tid()
    x = sampled_point(points, rows[i], center)
    mask[i] = uint8(is_on(kind, p, a, sizes[0], sizes[1], x, normals[rows[i]], threshold, least_cosine))


@kernel
def turn_points_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    p: vec3d,
    u: vec3d,
    v: vec3d,
    a: vec3d,
    turned: array(dtype=vec3),
):
    """Points in the frame of a shape."""
    i = tid()
    y = sampled_point(points, rows[i], center) - p
    turned[i] = vec3(float32(dot(y, u)), float32(dot(y, v)), float32(dot(y, a)))


@kernel
def mark_cells_kernel(
    turned: array(dtype=vec3), kind: int, r: float, directions: array(dtype=float32), cells: array(dtype=int32)
):
    """Mark the cell of each point: its sector about the axis, its band along a sphere or around a torus' tube."""
    i = tid()
    p = turned[i]
    sector = 0
    best = -float(1.0e30)
    for k in range(SECTORS):
        along = directions[2 * k] * p[0] + directions[2 * k + 1] * p[1]
        if along > best:
            best = along
            sector = k
    band = 0
    if kind == TORUS:
        q = sqrt(p[0] * p[0] + p[1] * p[1]) - r
        best = -float(1.0e30)
        for k in range(BANDS):  # every other direction
            along = directions[4 * k] * q + directions[4 * k + 1] * p[2]
            if along > best:
                best = along
                band = k
    if kind == SPHERE and r > 0.0:
        band = int(float(BANDS) * (p[2] + r) / (2.0 * r))
        band = max(0, min(BANDS - 1, band))
    atomic_max(cells, sector * BANDS + band, 1)  # all write the same


@kernel
def key_scores_kernel(scores: array(dtype=int32), most: int, keys: array(dtype=int64)):
    """Keys of which the least has the most points."""
    i = tid()
    keys[i] = int64(most - scores[i])


@kernel
def take_shapes_kernel(
    order: array(dtype=int32),
    shapes: array(dtype=float64, ndim=2),
    kinds: array(dtype=int32),
    scores: array(dtype=int32),
    best: array(dtype=float64, ndim=2),
    of: array(dtype=int32),
    near: array(dtype=int32),
):
    """The first shapes of an order, with their kinds and scores."""
    i = tid()
    k = order[i]
    for entry in range(NUMBERS):
        best[i, entry] = shapes[k, entry]
    of[i] = kinds[k]
    near[i] = scores[k]


def drawn_of(found: Sequence[NDArray[Any]]) -> list[Drawn]:
    """What came of `draw_unread`, three arrays a draw: (shapes, counts), the most points first."""
    drawn = []
    for shapes, near, counts in zip(found[::3], found[1::3], found[2::3], strict=True):
        chosen = near > 0
        best, on = shapes[chosen].copy(), counts[chosen].astype(np.int64)
        order = np.argsort(-on, kind="stable")
        drawn.append((best[order], on[order]))
    return drawn


class ShapeSearch:
    """The search for shapes among some points with normals.

    Attributes:
        rows: int32 device array, the points searched.
        center: Middle of their box, float64 [3]; shapes are relative to it.
        size: How far they reach from it along an axis [m].
    """

    def __init__(self, points: Points, normals: Vectors, rows: Indices, of: "ShapeSearch | None" = None) -> None:
        """Prepare a search among `points[rows]`, all finite and in the tree's order.

        `of` is one among more of the points, whose middle and size are kept; without it one sync.
        """
        self.points, self.normals, self.rows, self.device = points, normals, rows, points.device
        if of is None:
            low, high = bound_points(gather_rows(points, rows))[:2] if rows.size else (np.zeros(3), np.zeros(3))  # sync
            low, high = low.astype(np.float64), high.astype(np.float64)
            self.center = (0.5 * (low + high)).astype(np.float32).astype(np.float64)
            self.size = float(max((high - self.center).max(), (self.center - low).max()))
        else:
            self.center, self.size = of.center, of.size
        middle = self.center.astype(np.float32)
        step = max(1, rows.size // PART)
        self.share = step
        self.cloud = self._split(vec3(*middle), 1, 0, rows.size)
        self.part = self._split(vec3(*middle), step, step // 2, min(rows.size, max(1, rows.size // step)))
        self.levels = max(1, int(math.log2(max(1, rows.size / LEAST_WINDOW))))
        self.fitter = ShapeFitter(points, self.center, max(self.size, 1e-30))

    def draw(self, kind: int, count: int, seed: int, first: int, limits: ShapeLimits) -> Drawn:
        """The shapes of samples `first` .. `first + count` that promise the most, and how many points are on each."""
        return self.draw_each([(kind, count, first)], seed, limits)[0]

    def draw_each(self, samples: Sequence[tuple[int, int, int]], seed: int, limits: ShapeLimits) -> list[Drawn]:
        """The same of several (kind, count, first); one sync for all.

        Returns:
            (shapes, counts) of each: float64 [m, 8] and int64 [m], m up to PROMISING, the most points first.
        """
        there = [self.draw_unread(*one, seed, limits) for one in samples]
        return drawn_of(read_together([values for one in there for values in one]))  # sync

    def draw_unread(self, kind: int, count: int, first: int, seed: int, limits: ShapeLimits) -> list[AnyArray]:
        """What `drawn_of` makes that of, where it is: the shapes, and their points in the part and in all."""
        shapes, kinds = empty((count, NUMBERS), float64, self.device), empty(count, int32, self.device)
        drawn = [self.cloud, kind, (seed + STREAM * kind) % 2**31, first, self.levels, limits.distance, limits.cosine]
        launch(draw_shapes_kernel, count, [*drawn, limits.smallest, limits.largest, shapes, kinds])
        scores = score_shapes(self.part, shapes, kinds, limits.distance, limits.cosine)
        keys = empty(count, int64, self.device)
        launch(key_scores_kernel, count, [scores, self.part.count, keys])
        order = argsort_keys(keys, max(1, self.part.count.bit_length()))[1]
        m = min(count, PROMISING)
        best, of = empty((m, NUMBERS), float64, self.device), empty(m, int32, self.device)
        near = empty(m, int32, self.device)
        launch(take_shapes_kernel, m, [order, shapes, kinds, scores, best, of, near])
        return [best, near, score_shapes(self.cloud, best, of, limits.distance, limits.cosine)]

    def score(self, shapes: NDArray[np.float64], kinds: NDArray, limits: ShapeLimits) -> NDArray[np.int64]:
        """How many points are on each of some shapes; one sync."""
        if not len(shapes):
            return np.zeros(0, np.int64)
        there, of = upload(shapes, float64, self.device), upload(kinds.astype(np.int32), int32, self.device)
        return download(score_shapes(self.cloud, there, of, limits.distance, limits.cosine)).astype(np.int64)

    def find(self, kind: int, limits: ShapeLimits, most: int, probability: float, seed: int) -> Found | None:
        """The shape with the most points on it; None where no sample spans one."""
        pool, counts, done, batch, needed = np.zeros((0, NUMBERS)), np.zeros(0, np.int64), 0, FIRST_BATCH, float(most)
        while done < min(most, needed):
            size = int(min(batch, most - done))
            drawn, scores = self.draw(kind, size, seed, done, limits)
            pool, counts = np.concatenate([pool, drawn]), np.concatenate([counts, scores])
            best = np.argsort(-counts, kind="stable")[:REFINED]
            pool, counts = pool[best], counts[best]
            done += size
            share = counts[0] / self.rows.size if len(counts) else 0.0
            needed = samples_needed(share, kind, self.levels, probability, most)
            batch = min(BATCH_GROWTH * batch, MOST_BATCH)
        part = self._part_search()
        if part is not None and len(pool):
            refined = [one for one in part.refine_all([kind] * len(pool), pool, limits) if one is not None]
            best = max(refined, key=lambda one: (one[1], -one[0].rms), default=None)
            pool = pool[:1] if best is None else best[0].shape[None]
        found = [one for one in self.each_refined([kind] * len(pool), pool, limits) if one is not None]
        return max(found, key=lambda one: (one.rows.size, -one.fit.rms), default=None)

    def _part_search(self) -> "ShapeSearch | None":
        """The search among every n-th of the points; None where there are few."""
        if self.rows.size <= FITTED_PART:
            return None
        step = -(-self.rows.size // FITTED_PART)
        return ShapeSearch(self.points, self.normals, every_of(self.rows, step), self)

    def refine_all(
        self, kinds: Sequence[int], shapes: Shapes, limits: ShapeLimits, gain: float = ROUGHLY
    ) -> list[tuple[ShapeFit, int] | None]:
        """Shapes fitted to their points while these grow in number, and how many; None of one without; one sync."""
        chosen = Selection(
            self.normals, limits.distance, limits.cosine, limits.smallest, limits.largest, MOST_FITS
        )  # fmt: skip
        return self.fitter.refine_all(kinds, shapes, self.rows, chosen, gain)

    def each_refined(self, kinds: Sequence[int], shapes: Shapes, limits: ShapeLimits) -> list[Found | None]:
        """Shapes fitted to their points while these grow in number, exactly; None of one without; one sync."""
        each = zip(kinds, self.refine_all(kinds, shapes, limits, EXACT), strict=True)
        return [
            None if one is None else Found(kind, one[0], self.on(kind, one[0].shape, limits, one[1]))
            for kind, one in each
        ]

    def on(self, kind: int, shape: NDArray[np.float64], limits: ShapeLimits, count: int | None = None) -> Indices:
        """The rows of the points of a shape; one sync where it is not known how many."""
        return gather_rows(self.rows, positions_of(self.mask(kind, shape, limits), count))

    def mask(self, kind: int, shape: NDArray[np.float64], limits: ShapeLimits) -> Mask:
        """1 for each point of a shape."""
        mask = empty(self.rows.size, uint8, self.device)
        arguments = [self.points, self.normals, self.rows, vec3d(*self.center), kind, *_taken_apart(shape)]
        launch(mask_on_shape_kernel, mask.size, [*arguments, limits.distance, limits.cosine, mask])
        return mask

    def turned(self, shape: NDArray[np.float64], rows: Indices) -> Points:
        """Points in the frame of a shape."""
        frame, out = frame_of(shape[3:6]), empty(rows.size, vec3, self.device)
        arguments = [self.points, rows, vec3d(*self.center), vec3d(*shape[:3]), *(vec3d(*axis) for axis in frame), out]
        launch(turn_points_kernel, rows.size, arguments)
        return out

    def spread_unread(self, found: Found) -> tuple[Integers, Array1[float32], Integers]:
        """What `spread_of` makes of a shape's points, and their box in its frame, where they are; no sync."""
        shape, turned = found.fit.shape, self.turned(found.fit.shape, found.rows)
        extremes, box = find_extremes(turned), empty(6, float32, self.device)
        launch(fold_box_kernel, 6, [extremes, box])
        angles = 2 * np.pi * np.arange(SECTORS) / SECTORS
        around = np.stack([np.cos(angles), np.sin(angles)], 1).astype(np.float32).ravel()
        directions, cells = upload(around, float32, self.device), zeros(SECTORS * BANDS, int32, self.device)
        launch(mark_cells_kernel, turned.size, [turned, found.kind, float(shape[6]), directions, cells])
        return extremes, box, cells

    def _split(self, middle: vec3, step: int, first: int, count: int) -> ShapePoints:
        cloud = ShapePoints()
        cloud.count = count
        for name in ("xs", "ys", "zs", "us", "vs", "ws"):
            setattr(cloud, name, empty(count, float32, self.device))
        arguments = [self.points, self.normals, self.rows, middle, step, first, cloud]
        launch(split_points_kernel, count, arguments)
        return cloud


def spread_of(kind: int, extremes: NDArray[np.int32], cells: NDArray[np.int32]) -> tuple[NDArray[np.float64], float]:
    """The box of a shape's points in its frame (low, high), and the share of its surface's cells that have some."""
    bounds = np.array([bound.astype(np.float64) for bound in box_of(extremes)[:2]])
    marks = cells.reshape(SECTORS, BANDS)
    if kind == PLANE:
        return bounds, 1.0
    return bounds, float(marks.any(axis=1).mean() if kind in (CYLINDER, CONE) else marks.mean())


def _taken_apart(shape: NDArray[np.float64]) -> list:
    return [vec3d(*shape[:3]), vec3d(*shape[3:6]), vec3d(shape[6], shape[7], 0.0)]


def chance_of(share: float, kind: int, levels: int) -> float:
    """The chance that a sample is of one shape alone (Schnabel, Wahl and Klein 2007, section 4.4).

    Either all of the cloud is drawn from, or, at the best of the lengths of a run, half of the run is the shape's.
    """
    points = SAMPLE_POINTS[kind]
    return max(share**points, share / 2 ** (points - 1)) / levels


def samples_needed(share: float, kind: int, levels: int, probability: float, most: int) -> float:
    """Samples after which one of the shape alone was drawn with the wanted probability."""
    hit = chance_of(share, kind, levels)
    if hit <= 0.0 or probability >= 1.0:
        return float(most)
    return min(float(most), math.log1p(-probability) / math.log1p(-min(hit, 1 - 1e-12)))
