"""All planes, spheres, cylinders, cones and tori of a cloud, in rounds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive, check_progress, shown
from ..core.progress import ReportProgress
from ..core.told_arguments import told_arguments
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.quantiles import median_above_zero
from ..kernels.lang import float32, int32
from ..kernels.memory import full
from ..kernels.search.neighbor_distances import nearest_distances
from ..kernels.segmentation.plane_fit import label_rows
from ..kernels.segmentation.shape_models import CONE, NUMBERS, PLANE
from ..kernels.segmentation.shape_parts import largest_part, rows_labelled, write_distances
from ..kernels.segmentation.shape_search import Found, ShapeLimits, ShapeSearch, chance_of
from .cloud import PointCloud
from .point_arrays import check_cloud
from .shape import KINDS, Shape
from .shape_verdicts import is_flat, is_open, plane_of, shape_of
from .shapes import check_samples, limits_of, search_of

LEAST, LEAST_SHARE = 100, 0.01  # points of a shape where none are given: at least, and of the cloud
STEPS = 5.0  # medians of the distance of neighbours that points of one part may lie apart
FIRST_BATCH, MOST_BATCH = 512, 8192  # samples of a kind between two looks at the candidates
POOL = 64  # candidates kept from round to round
TRIED = 3  # of them fitted before one is taken
# Of shapes with about as many points the simpler is meant.
WORTH = dict(enumerate((1.0, 0.97, 0.95, 0.9, 0.85)))


@dataclass(frozen=True, eq=False)
class DetectedShapes:
    """What `detect_shapes` found.

    Attributes:
        labels: int32 [n], the number of each point's shape, -1 of none.
        shapes: In the order in which they were taken, the most points first but for chance.
        distances: float32 [n], the signed distance [m] of each point from its shape, NaN of none.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).normal(size=(2000, 3))
        >>> ball = loom.PointCloud(points / np.linalg.norm(points, axis=1)[:, None]).estimate_normals()
        >>> found = loom.detect_shapes(ball, 0.02, min_support=500)
        >>> [shape.kind for shape in found.shapes], found.labels.shape
        (['sphere'], (2000,))
    """

    labels: NDArray[np.int32]
    shapes: list[Shape]
    distances: NDArray[np.float32]

    def __str__(self) -> str:
        found = [f"{k}: {shape}" for k, shape in enumerate(self.shapes)]
        return "\n".join([*found, f"{int((self.labels < 0).sum()):,} points of {len(self.labels):,} are of none"])

    def to_dict(self) -> dict[str, Any]:
        """The shapes in JSON's types, and how many points are of none."""
        return {"shapes": [shape.to_dict() for shape in self.shapes], "unlabelled": int((self.labels < 0).sum())}


@told_arguments
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
    """Find all planes, spheres, cylinders, cones and tori of a cloud; it needs normals.

    Args:
        cloud: With normals.
        distance_threshold: Distance [m] from a surface below which a point may be of it.
        normal_threshold_deg: Largest angle [degrees] between the point's normal and the surface's, whichever way the
            normal faces.
        kinds: Which to look for.
        min_support: Points of a shape at least; None for a hundredth of the points, and 100 at least.
        cluster_epsilon: Points of one shape hang together by steps shorter than this [m]; None for five times the
            median distance of neighbours.
        num_iterations: Samples of each kind at most.
        probability: Wanted of having missed no shape of `min_support` points, and of taking none before a larger one.
        min_radius: Smallest radius [m] of a sphere, a cylinder and the tube of a torus.
        max_radius: Largest radius [m]; None for the diagonal of the cloud.
        max_shapes: Shapes at most; None for any number.
        seed: Of the samples.
        progress: Called with ("shapes", points that have one, points).

    Returns:
        Labels, shapes and distances. `shape.reasons` says what speaks against each.

    Raises:
        ValueError: The cloud has no normals, a kind is not known, or an argument is out of range.

    Notes:
        Schnabel, Wahl and Klein 2007, in rounds: each draws samples of every kind among the points that have no shape
        yet; the best candidate, once a better one is unlikely, is fitted to the largest part of its points that hangs
        together, and these are taken. Where it differs: parts hang together in space, not in a bitmap over the shape;
        of candidates with nearly as many points the simpler kind is taken; one that is as flat as a plane is a plane,
        or dropped where none are looked for, and so is a cone that may as well be a cylinder. The same bits from run to
        run. 60 B of memory a point.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> table = np.random.default_rng(0).random((3000, 3)) * [2, 2, 0]
        >>> ball = loom.TriangleMesh.create_sphere(0.3, 40).vertices + [1, 1, 0.8]
        >>> cloud = loom.PointCloud(np.vstack([table, ball])).estimate_normals()
        >>> found = loom.detect_shapes(cloud, 0.01, kinds=("plane", "sphere"))
        >>> [shape.kind for shape in found.shapes]
        ['sphere', 'plane']
    """
    check_cloud("cloud", cloud)
    wanted = _check_kinds(kinds)
    limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
    most, chance, start = check_samples(num_iterations, probability, seed)
    fewest = max(LEAST, int(LEAST_SHARE * len(cloud)))
    if min_support is not None:
        fewest = check_count("min_support", min_support, minimum=10)
    reach = None if cluster_epsilon is None else check_positive("cluster_epsilon", cluster_epsilon)
    largest = len(cloud) if max_shapes is None else check_count("max_shapes", max_shapes)
    tell = check_progress(progress)
    labels = full(len(cloud), -1, int32, cloud.device)
    distances = full(len(cloud), math.nan, float32, cloud.device)
    shapes: list[Shape] = []
    search, limits = search_of(cloud, limits)
    if search.rows.size >= fewest and search.size > 0:
        if reach is None:
            apart = nearest_distances(cloud.search_tree(), cloud._device_array("points"), others=True, missing=0.0)
            reach = STEPS * float(median_above_zero(apart) or limits.distance)
        rounds = _Rounds(search, limits, wanted, fewest, reach, most, chance, start, labels)
        tell("shapes", 0, len(cloud))
        while len(shapes) < largest and (found := rounds.next_shape()) is not None:
            write_distances(rounds.search, found, distances)
            shapes.append(shape_of(rounds.search, found, rounds.limits, cloud.origin, search))
            rounds.remove(found, len(shapes) - 1)
            tell("shapes", len(cloud) - rounds.search.rows.size, len(cloud))
    return DetectedShapes(cloud._handed_out(labels), shapes, cloud._handed_out(distances))


class _Rounds:
    """The candidates of all rounds, and the points that have no shape yet."""

    def __init__(
        self,
        search: ShapeSearch,
        limits: ShapeLimits,
        kinds: list[int],
        fewest: int,
        reach: float,
        most: int,
        probability: float,
        seed: int,
        labels: Any,
    ) -> None:
        self.search, self.limits, self.labels = search, limits, labels
        self._kinds, self._fewest, self._reach, self._seed = kinds, fewest, reach, seed
        self._most, self._probability, self._batch = most, probability, FIRST_BATCH
        self._drawn = dict.fromkeys(kinds, 0)  # samples of a kind
        self._tried = dict.fromkeys(kinds, 0)  # those since it was last asked whether all were drawn for nothing
        self._has_found = False  # a shape since then, of which most of the candidates kept may have been
        self._shapes, self._of, self._counts = np.zeros((0, NUMBERS)), np.zeros(0, np.int64), np.zeros(0, np.int64)

    def next_shape(self) -> Found | None:
        """The next shape; None where none of enough points is left, as likely as was asked for."""
        while self.search.rows.size >= self._fewest:
            while len(self._counts) and (self._is_safe(self._counts[0], self._of[0]) or not self._open()):
                found = self._best()
                if found is not None:
                    return found
            if not self._open():
                if not self._has_found:
                    return None
                self._tried, self._has_found = dict.fromkeys(self._kinds, 0), False
                continue
            self._draw()
        return None

    def remove(self, found: Found, number: int) -> None:
        """Take the points of a shape away, and count again what the candidates have of the rest."""
        self._has_found = True
        label_rows(found.rows, number, self.labels)
        rows = rows_labelled(self.labels, self.search.rows, -1)
        if rows.size < self._fewest:
            self.search.rows = rows
            return
        self.search = ShapeSearch(self.search.points, self.search.normals, rows, self.search)
        self._keep(self._shapes, self._of, self.search.score(self._shapes, self._of, self.limits))

    # ------------------------------------------------------------------------------------------ internals

    def _open(self) -> list[int]:
        """The kinds of which a shape may have been missed, and samples are left."""
        return [
            kind for kind in self._kinds if self._drawn[kind] < self._most and not self._is_safe(self._fewest, kind)
        ]

    def _is_safe(self, count: int, kind: int) -> bool:
        """Whether a shape of so many points has been found by now with the wanted probability."""
        hit = chance_of(count / self.search.rows.size, kind, self.search.levels)
        return 1 - (1 - hit) ** self._tried[kind] >= self._probability

    def _draw(self) -> None:
        """A batch of samples of each kind that is open."""
        samples = [(kind, min(self._batch, self._most - self._drawn[kind]), self._drawn[kind]) for kind in self._open()]
        drawn = self.search.draw_each(samples, self._seed, self.limits)
        for (kind, size, _), (shapes, counts) in zip(samples, drawn, strict=True):
            self._drawn[kind] += size
            self._tried[kind] += size
            self._keep(
                np.concatenate([self._shapes, shapes]),
                np.concatenate([self._of, np.full(len(counts), kind)]),
                np.concatenate([self._counts, counts]),
            )
        self._batch = min(2 * self._batch, MOST_BATCH)

    def _keep(self, shapes: NDArray[Any], of: NDArray[Any], counts: NDArray[Any]) -> None:
        """Keep the candidates with the most points, those of simple kinds before others with nearly as many."""
        worth = counts * np.array([WORTH[int(kind)] for kind in of])
        order = np.argsort(-worth, kind="stable")
        order = order[counts[order] >= self._fewest][:POOL]
        self._shapes, self._of, self._counts = shapes[order], of[order], counts[order]

    def _best(self) -> Found | None:
        """The best of the first candidates, fitted to what hangs together; those that are no shape are dropped."""
        first = slice(min(TRIED, len(self._counts)))
        refined = self.search.each_refined(self._of[first].tolist(), self._shapes[first], self.limits)
        settled = [None if found is None else self._settled(found) for found in refined]
        tried = [found for found in settled if found is not None]
        poor = np.zeros(len(self._counts), bool)
        poor[first] = [found is None for found in settled]
        kept = ~poor
        self._shapes, self._of, self._counts = self._shapes[kept], self._of[kept], self._counts[kept]
        return max(tried, key=lambda found: found.rows.size * WORTH[found.kind], default=None)

    def _settled(self, refined: Found) -> Found | None:
        """A candidate fitted to the largest part of its points; None where that is too small or of another kind."""
        search, kind = self.search, refined.kind
        found = self._fitted(kind, refined.fit.shape, largest_part(search.points, refined.rows, self._reach))
        if found is not None and kind != PLANE and is_flat(search, found, plane := plane_of(search, found)):
            found = self._fitted(PLANE, plane.shape, found.rows) if PLANE in self._kinds else None
        if found is not None and found.kind == CONE:
            low, high = bound_points(search.turned(found.fit.shape, found.rows))[:2]  # sync
            found = None if is_open(found, float(high[2] - low[2])) else found
        return found

    def _fitted(self, kind: int, shape: NDArray[np.float64], rows: Any) -> Found | None:
        """A shape fitted to some points, with the largest part of what is on it; None where that is too small."""
        if rows.size < self._fewest:
            return None
        fit = self.search.fitter.fit(kind, shape, rows)
        if not self.limits.allow(kind, fit.shape):
            return None
        part = largest_part(self.search.points, self.search.on(kind, fit.shape, self.limits), self._reach)
        return Found(kind, fit, part) if part.size >= self._fewest and not fit.reason else None


def _check_kinds(kinds: Any) -> list[int]:
    """The kinds to look for, by number, each once."""
    named = [kinds] if isinstance(kinds, str) else kinds
    if not isinstance(named, (list, tuple, set, frozenset)) or not named:
        raise TypeError(f"kinds: expected some of {', '.join(KINDS)}, got {shown(kinds)}")
    for kind in named:
        if kind not in KINDS:
            raise ValueError(f"kinds: expected some of {', '.join(KINDS)}, got {shown(kind)}")
    return sorted({KINDS.index(kind) for kind in named})
