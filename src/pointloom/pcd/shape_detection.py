"""Detection of all planes, spheres, cylinders, cones and tori of a cloud."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.checks import check_count, check_positive, check_progress, shown
from ..core.progress import ReportProgress
from ..core.reports import Assessed, failed, quality
from ..core.wording import plain
from ..kernels.array_types import Doubles, Indices, Integers
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.quantiles import median_above_zero
from ..kernels.arrays.select import gather_rows
from ..kernels.lang import float32, int32
from ..kernels.memory import full
from ..kernels.search.distinct_points import without_copies
from ..kernels.search.neighbor_distances import nearest_distances
from ..kernels.search.point_tree import PointTree
from ..kernels.segmentation.plane_fit import label_rows
from ..kernels.segmentation.shape_models import CONE, PLANE, SHAPE_NUMBERS
from ..kernels.segmentation.shape_parts import largest_part, rows_labeled, write_distances
from ..kernels.segmentation.shape_search import DetectedShape, ShapeLimits, ShapeSearch, chance_of
from .cloud import PointCloud
from .point_arrays import check_cloud
from .segmentation import check_samples, limits_of, search_of
from .shape import KINDS, Shape
from .shape_checks import is_flat, is_open, plane_of, shape_of

MIN_POINTS, MIN_FRACTION = 100, 0.01  # default minimum points of a shape: absolute, and fraction of the cloud
GAP_DISTANCES = 5.0  # maximum gap in a component, in median neighbor distances
# Fraction of the points of a sparse surface that wider steps connect. Random points on a plane connect at 2.4 median
# distances, and below that the largest part has a few percent.
CONNECTED = 0.25
SET_ASIDE = -2  # label of points that are left out of the search
FIRST_BATCH, MAX_BATCH = 512, 8192  # samples per kind between evaluations
MAX_CANDIDATES = 64  # candidates kept between rounds
FITTED_CANDIDATES = 3  # candidates fitted per selection
# Weights of support by kind, which prefer simpler shapes.
KIND_WEIGHTS = dict(enumerate((1.0, 0.97, 0.95, 0.9, 0.85)))


class SparseSurface(NamedTuple):
    """Kind and number of points of a surface, and the `cluster_epsilon` [m] that connects them."""

    kind: str
    points: int
    step: float


@dataclass(frozen=True, eq=False)
class DetectedShapes(Assessed):
    """Result of `detect_shapes`.

    Attributes:
        labels: int32 (n,), shape index of each point, -1 for none.
        shapes: In order of detection, mostly by decreasing size.
        distances: float32 (n,), signed distance of each point from its shape [m], NaN for none.
        undecided: Kinds of which a shape may be missed, because `num_iterations` samples do not reach `probability`.
        sparse: Surfaces that are no shape, because their points are further apart than `cluster_epsilon`.
    """

    labels: NDArray[np.int32]
    shapes: list[Shape]
    distances: NDArray[np.float32]
    undecided: tuple[str, ...] = ()
    sparse: tuple[SparseSurface, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks of the search and of each shape. Empty if all are reliable."""
        missed = f"shapes may be missed ({', '.join(self.undecided)}): use more num_iterations, or a larger min_support"
        each = [f"shape {k} ({shape.kind}): {one}" for k, shape in enumerate(self.shapes) for one in shape.warnings]
        sparse = [
            f"{one.points:,} points on a {one.kind} are no shape, because less than min_support of them are within "
            f"cluster_epsilon of each other: use {one.step:.2g} m"
            for one in self.sparse
        ]
        return failed(missed if self.undecided else None, *sparse, *each)

    def __str__(self) -> str:
        lines = [f"{k}: {shape}" for k, shape in enumerate(self.shapes)]
        lines += [f"shapes may be missed: {', '.join(self.undecided)}"] if self.undecided else []
        return "\n".join([*lines, f"{int((self.labels < 0).sum()):,} of {len(self.labels):,} points are in no shape"])

    def to_dict(self) -> dict[str, Any]:
        """Shapes and number of unassigned points in JSON's types, with `reliable` and `warnings`."""
        shapes = [shape.to_dict() for shape in self.shapes]
        rest = {"unlabeled": int((self.labels < 0).sum()), "undecided": list(self.undecided), "sparse": self.sparse}
        return plain({"shapes": shapes, **rest, **quality(self)})


@explain_argument_errors
def detect_shapes(
    cloud: PointCloud,
    distance_threshold: float = 0.01,
    normal_threshold_deg: float = 20.0,
    *,
    kinds: Sequence[str] = KINDS,
    min_support: int | None = None,
    cluster_epsilon: float | None = None,
    num_iterations: int = 100_000,
    probability: float = 0.99,
    min_radius: float = 0.0,
    max_radius: float | None = None,
    max_shapes: int | None = None,
    seed: int = 0,
    progress: ReportProgress | None = None,
) -> DetectedShapes:
    """Detect all planes, spheres, cylinders, cones and tori of a cloud with normals.

    Schnabel, Wahl and Klein, "Efficient RANSAC for point-cloud shape detection", CGF 2007. Unlike the paper, components
    are connected in space, and simpler kinds are preferred. 60 B per point. Bitwise reproducible.

    Args:
        cloud: With normals.
        distance_threshold: Exclusive inlier distance [m].
        normal_threshold_deg: Maximum unsigned angle between point and surface normals [degrees].
        kinds: Kinds of shapes to detect.
        min_support: Minimum points of a shape. If None: 1% of the points, at least 100.
        cluster_epsilon: Maximum step between points of one shape [m]. If None: five median neighbor distances of the
            cloud, or of the shape's points if that connects a sparse surface.
        num_iterations: Maximum number of samples per kind.
        probability: Required probability that no shape of `min_support` points, or larger than the next, is missed.
        min_radius: Minimum radius of spheres, cylinders and torus tubes [m].
        max_radius: Maximum radius [m]. If None: the diagonal of the cloud.
        max_shapes: Maximum number of shapes. None for no limit.
        seed: Random seed.
        progress: Called with ("shapes", assigned points, points).

    Returns:
        DetectedShapes: labels, shapes and distances. `warnings` lists failed checks of the search and of all shapes,
        `shape.warnings` those of one shape.

    Raises:
        ValueError: If the cloud has no normals, a kind is unknown, or an argument is out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> table = np.random.default_rng(0).random((3000, 3)) * [2, 2, 0]
        >>> ball = loom.TriangleMesh.create_sphere(0.3, 40).vertices + [1, 1, 0.8]
        >>> cloud = loom.PointCloud(np.vstack([table, ball])).estimate_normals()
        >>> result = loom.detect_shapes(cloud, 0.01, kinds=("plane", "sphere"))
        >>> [shape.kind for shape in result.shapes]
        ['sphere', 'plane']
    """
    check_cloud("cloud", cloud)
    kind_numbers = _check_kinds(kinds)
    limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
    sampling = _Sampling(*check_samples(num_iterations, probability, seed))
    min_points = max(MIN_POINTS, int(MIN_FRACTION * len(cloud)))
    if min_support is not None:
        min_points = check_count("min_support", min_support, minimum=10)
    epsilon = None if cluster_epsilon is None else check_positive("cluster_epsilon", cluster_epsilon)
    largest = len(cloud) if max_shapes is None else check_count("max_shapes", max_shapes)
    report_progress = check_progress(progress)
    labels = full(len(cloud), -1, int32, cloud.device)
    distances = full(len(cloud), math.nan, float32, cloud.device)
    shapes: list[Shape] = []
    undecided: tuple[str, ...] = ()
    sparse: tuple[SparseSurface, ...] = ()
    search, limits = search_of(cloud, limits)
    if search.rows.size >= min_points and search.size > 0:
        steps = _Steps(cloud.search_tree(), epsilon, limits.distance)
        rounds = _Rounds(search, limits, kind_numbers, min_points, steps, sampling, labels)
        report_progress("shapes", 0, len(cloud))
        while len(shapes) < largest and (candidate := rounds.next_shape()) is not None:
            write_distances(rounds.search, candidate, distances)
            shapes.append(shape_of(rounds.search, candidate, rounds.limits, cloud.origin, search))
            rounds.remove(candidate, len(shapes) - 1)
            report_progress("shapes", len(cloud) - rounds.search.rows.size, len(cloud))
        undecided = rounds.undecided() if len(shapes) < largest else ()
        sparse = rounds.restored()
    return DetectedShapes(cloud.arrays.hand_out(labels), shapes, cloud.arrays.hand_out(distances), undecided, sparse)


class _Sampling(NamedTuple):
    """Samples per kind, required probability of finding each shape, and random seed."""

    max_samples: int
    probability: float
    seed: int


class _Steps:
    """Maximum steps between points of one shape [m]: `given`, or else by the distances to the nearest points."""

    def __init__(self, tree: PointTree, given: float | None, otherwise: float) -> None:
        self._tree, self.given, self._otherwise = tree, given, otherwise

    @functools.cached_property
    def common(self) -> float:
        """The step for dense surfaces."""
        return self._by(self._distances, self._otherwise) if self.given is None else self.given

    def of(self, rows: Indices) -> float:
        """The step by the distances of some points. One sync."""
        distances, distinct = self._distances, self._tree.distinct
        return self._by(gather_rows(distances, rows if distinct is None else gather_rows(distinct.rows, rows)), 0.0)

    @functools.cached_property
    def _distances(self) -> Doubles:
        """Distance of each distinct position to the nearest other one."""
        tree = without_copies(self._tree)
        return nearest_distances(tree, tree.source, others=True, missing=0.0)

    @staticmethod
    def _by(distances: Doubles, otherwise: float) -> float:
        return GAP_DISTANCES * float(median_above_zero(distances) or otherwise)


class _Rounds:
    """Candidates of all rounds, and the unassigned points."""

    def __init__(
        self,
        search: ShapeSearch,
        limits: ShapeLimits,
        kinds: list[int],
        min_points: int,
        steps: _Steps,
        sampling: _Sampling,
        labels: Integers,
    ) -> None:
        self.search, self.limits, self.labels = search, limits, labels
        self._kinds, self._min_points, self._steps = kinds, min_points, steps
        self._sampling, self._batch = sampling, FIRST_BATCH
        self._drawn = dict.fromkeys(kinds, 0)  # samples per kind
        self._tried = dict.fromkeys(kinds, 0)  # samples since the last check for missed shapes
        self._has_detected = False  # a shape was detected since then, which most kept candidates may have been
        self._sparse: tuple[SparseSurface, Indices] | None = None  # the largest surface whose parts are too small
        self._set_aside: list[tuple[SparseSurface, Indices]] = []  # those whose points are left out of the search
        self._shapes, self._of, self._counts = (
            np.zeros((0, SHAPE_NUMBERS)),
            np.zeros(0, np.int64),
            np.zeros(0, np.int64),
        )

    def next_shape(self) -> DetectedShape | None:
        """Next shape. None if no shape with enough points remains, at the required probability."""
        while self.search.rows.size >= self._min_points:
            while len(self._counts) and (self._is_safe(self._counts[0], self._of[0]) or not self._open()):
                candidate = self._best()
                if candidate is not None:
                    return candidate
            if not self._open():
                if not self._has_detected and not self._is_set_aside():
                    return None
                self._tried, self._has_detected = dict.fromkeys(self._kinds, 0), False
                continue
            self._draw()
        return None

    def remove(self, candidate: DetectedShape, number: int) -> None:
        self._has_detected = True
        self._label(candidate.rows, number)

    def restored(self) -> tuple[SparseSurface, ...]:
        """The surfaces whose points were left out of the search. Their points get the label of no shape."""
        for _, rows in self._set_aside:
            label_rows(rows, -1, self.labels)
        return tuple(surface for surface, _ in self._set_aside)

    def _is_set_aside(self) -> bool:
        """Leave the points of the largest sparse surface out of the search: its candidates hide those of smaller ones.
        False if there is none."""
        if self._sparse is None:
            return False
        self._set_aside.append(self._sparse)
        self._label(self._sparse[1], SET_ASIDE)
        return True

    def _label(self, labeled: Indices, label: int) -> None:
        """Label points, and search among those without a label."""
        self._sparse = None  # found again among the points that are left
        label_rows(labeled, label, self.labels)
        rows = rows_labeled(self.labels, self.search.rows, -1)
        if rows.size < self._min_points:
            self.search.rows = rows
            return
        self.search = ShapeSearch(self.search.points, self.search.normals, rows, self.search)
        self._keep(self._shapes, self._of, self.search.score(self._shapes, self._of, self.limits))

    def _open(self) -> list[int]:
        """Kinds that may still have undetected shapes and samples left."""
        return [
            kind
            for kind in self._kinds
            if self._drawn[kind] < self._sampling.max_samples and not self._is_safe(self._min_points, kind)
        ]

    def undecided(self) -> tuple[str, ...]:
        """Kinds without enough samples to find every shape of the remaining points at the required probability."""
        if self.search.rows.size < self._min_points:
            return ()
        return tuple(KINDS[kind] for kind in self._kinds if not self._is_safe(self._min_points, kind))

    def _is_safe(self, count: int, kind: int) -> bool:
        """True if a shape of `count` points would have been found with the required probability."""
        hit = chance_of(count / self.search.rows.size, kind, self.search.levels)
        return 1 - (1 - hit) ** self._tried[kind] >= self._sampling.probability

    def _draw(self) -> None:
        samples = [
            (kind, min(self._batch, self._sampling.max_samples - self._drawn[kind]), self._drawn[kind])
            for kind in self._open()
        ]
        drawn = self.search.draw_each(samples, self._sampling.seed, self.limits)
        for (kind, size, _), (shapes, counts) in zip(samples, drawn, strict=True):
            self._drawn[kind] += size
            self._tried[kind] += size
            self._keep(
                np.concatenate([self._shapes, shapes]),
                np.concatenate([self._of, np.full(len(counts), kind)]),
                np.concatenate([self._counts, counts]),
            )
        self._batch = min(2 * self._batch, MAX_BATCH)

    def _keep(self, shapes: NDArray[Any], of: NDArray[Any], counts: NDArray[Any]) -> None:
        """Keep the candidates with the most points, simple kinds before others with similar support."""
        worth = counts * np.array([KIND_WEIGHTS[int(kind)] for kind in of])
        order = np.argsort(-worth, kind="stable")
        order = order[counts[order] >= self._min_points][:MAX_CANDIDATES]
        self._shapes, self._of, self._counts = shapes[order], of[order], counts[order]

    def _best(self) -> DetectedShape | None:
        """Best of the first candidates, fitted to its largest component. Invalid ones are dropped."""
        first = slice(min(FITTED_CANDIDATES, len(self._counts)))
        refined = self.search.each_refined(self._of[first].tolist(), self._shapes[first], self.limits)
        refitted = [None if candidate is None else self._refitted(candidate) for candidate in refined]
        tried = [candidate for candidate in refitted if candidate is not None]
        is_bad = np.zeros(len(self._counts), bool)
        is_bad[first] = [candidate is None for candidate in refitted]
        is_good = ~is_bad
        self._shapes, self._of, self._counts = self._shapes[is_good], self._of[is_good], self._counts[is_good]
        return max(tried, key=lambda candidate: candidate.rows.size * KIND_WEIGHTS[candidate.kind], default=None)

    def _refitted(self, refined: DetectedShape) -> DetectedShape | None:
        """Candidate fitted to its largest component. None if it is too small or of another kind."""
        search, kind = self.search, refined.kind
        part, step = self._largest_part(refined)
        candidate = self._fitted(kind, refined.fit.shape, part, step)
        if candidate is not None and kind != PLANE and is_flat(search, candidate, plane := plane_of(search, candidate)):
            candidate = self._fitted(PLANE, plane.shape, candidate.rows, step) if PLANE in self._kinds else None
        if candidate is not None and candidate.kind == CONE:
            low, high = bound_points(search.in_frame(candidate.fit.shape, candidate.rows))[:2]  # sync
            candidate = None if is_open(candidate, float(high[2] - low[2])) else candidate
        return candidate

    def _largest_part(self, refined: DetectedShape) -> tuple[Indices, float]:
        """Rows of the largest part, and the step [m] that connects it: that of the candidate's own points if they are
        sparse. With a given step, sparse surfaces are noted."""
        step, points, is_given = self._steps.common, self.search.points, self._steps.given is not None
        part = largest_part(points, refined.rows, step)
        enough = self._min_points if is_given else max(self._min_points, CONNECTED * refined.rows.size)
        if part.size >= enough or (own := self._steps.of(refined.rows)) <= step:
            return part, step
        wide = largest_part(points, refined.rows, own)
        if wide.size < max(self._min_points, CONNECTED * refined.rows.size):
            return part, step
        if not is_given:
            return wide, own
        if self._sparse is None or wide.size > self._sparse[1].size:
            self._sparse = SparseSurface(KINDS[refined.kind], wide.size, own), wide
        return part, step

    def _fitted(self, kind: int, shape: NDArray[np.float64], rows: Indices, step: float) -> DetectedShape | None:
        """Shape fitted to points, with the largest component of its inliers. None if too small."""
        if rows.size < self._min_points:
            return None
        fit = self.search.fitter.fit(kind, shape, rows)
        if not self.limits.allow(kind, fit.shape):
            return None
        part = largest_part(self.search.points, self.search.on(kind, fit.shape, self.limits), step)
        return DetectedShape(kind, fit, part) if part.size >= self._min_points and not fit.reason else None


def _check_kinds(kinds: object) -> list[int]:
    named = [kinds] if isinstance(kinds, str) else kinds
    if not isinstance(named, (list, tuple, set, frozenset)) or not named:
        raise TypeError(f"kinds: expected some of {', '.join(KINDS)}, got {shown(kinds)}")
    for kind in named:
        if kind not in KINDS:
            raise ValueError(f"kinds: expected some of {', '.join(KINDS)}, got {shown(kind)}")
    return sorted({KINDS.index(kind) for kind in named})
