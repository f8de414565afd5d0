"""Alternative explanations of a detected shape: points next to it, and fits of other kinds.

A shape that only touches another surface along a strip has slowly diverging points beside it: more than a third of the
points within three tolerances are beyond one. On a true shape almost none are. Rivals of other kinds are sampled and
fitted to some of the shape's points.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..array_types import Array1, Integers
from ..lang import array, atomic_add, cross, dot, float32, float64, int32, kernel, launch, sqrt, tid, vec3, vec3d
from ..memory import zeros
from .plane_samples import sampled_point
from .shape_fit import FREE_ENTRIES, ShapeFit, frame_of
from .shape_models import measure
from .shape_rows import every_of
from .shape_search import DetectedShape, ShapeLimits, ShapeSearch, drawn_of

BAND_TOLERANCES = 3.0  # tolerances up to which a point is beside a surface
MAX_COMPARED = 4096  # points of a shape used to fit rivals
SAMPLES_PER_KIND = 256  # samples of a rival kind
FITS_PER_KIND = 2  # of them that are fitted
MAX_DEVIATION_RATIO = 5.0  # times the shape's deviation: rivals farther away after some steps are dropped
COMPARED_GAIN = 1.0e-5  # of squared distances: a smaller gain ends a fit, accurate to 1% of the rms
FREE_SIZE = 20.0  # sizes of the cloud: larger radii are planes


@dataclass(frozen=True)
class Band:
    """Points in the box of a shape: within the tolerance, in the wider band, and those with matching normals."""

    on: int
    beside: int
    on_facing: int
    beside_facing: int


@dataclass(frozen=True)
class Rival:
    """Another kind fitted to at most MAX_COMPARED points: `ratio` of deviations, and `support` in the cloud."""

    kind: int
    fit: ShapeFit
    ratio: float
    support: int


@kernel
def count_band_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    u: vec3d,
    a: vec3d,
    sizes: vec3d,
    box: array(dtype=float32),
    near: float64,
    cosine: float64,
    counts: array(dtype=int32),
):
    """Count a point on or beside a shape, in the box of the shape's points."""
    i = tid()
    x = sampled_point(points, rows[i], center)
    y = x - p
    v = cross(a, u)
    m = measure(kind, p, a, sizes[0], sizes[1], x)
    far = near * float64(BAND_TOLERANCES)
    inside = 1
    if dot(y, u) < float64(box[0]) - far or dot(y, u) > float64(box[3]) + far:
        inside = 0
    if dot(y, v) < float64(box[1]) - far or dot(y, v) > float64(box[4]) + far:
        inside = 0
    if dot(y, a) < float64(box[2]) - far or dot(y, a) > float64(box[5]) + far:
        inside = 0
    if inside == 1 and abs(m[0]) < far:
        n = normals[rows[i]]
        size = sqrt(float64(dot(n, n)))
        facing = abs(m[1] * float64(n[0]) + m[2] * float64(n[1]) + m[3] * float64(n[2]))
        slot = 0
        if abs(m[0]) >= near:
            slot = 1
        atomic_add(counts, slot, 1)  # integer sums do not depend on the order
        if facing >= cosine * size:
            atomic_add(counts, slot + 2, 1)


def count_band(
    search: ShapeSearch, detected: DetectedShape, box: Array1[float32], distance: float, cosine: float
) -> Integers:
    """Numbers of a `Band` among the searched points. No sync."""
    counts, shape, frame = zeros(4, int32, search.device), detected.fit.shape, frame_of(detected.fit.shape[3:6])
    arguments = [search.points, search.normals, search.rows, vec3d(*search.center), detected.kind, vec3d(*shape[:3])]
    arguments += [vec3d(*frame[0]), vec3d(*frame[2]), vec3d(shape[6], shape[7], 0.0), box]
    launch(count_band_kernel, search.rows.size, [*arguments, distance, cosine, counts])
    return counts


class RivalStarts:
    """Samples of other kinds among the points of a detected shape."""

    def __init__(self, search: ShapeSearch, detected: DetectedShape, limits: ShapeLimits) -> None:
        self.search, self.shape, self.limits, self.rows = search, detected, limits, detected.rows
        if detected.rows.size > MAX_COMPARED:
            self.rows = every_of(detected.rows, -(-detected.rows.size // MAX_COMPARED))
        part = ShapeSearch(search.points, search.normals, self.rows, search)
        wide = replace(limits, smallest=0.0, largest=FREE_SIZE * max(search.size, 1e-30))
        count = self.rows.size
        self.kinds = [k for k, free in FREE_ENTRIES.items() if k != detected.kind and count > len(free) + 1]
        self.unread = [values for kind in self.kinds for values in part.draw_unread(kind, SAMPLES_PER_KIND, 0, 0, wide)]

    def find(self, drawn: Sequence[NDArray[Any]], every: ShapeSearch) -> list[Rival]:
        """Best shape of each other kind, from the arrays of `unread`. Support is counted in `every`. Two syncs."""
        kinds, starts = [self.shape.kind], [self.shape.fit.shape]
        for kind, (shapes, _) in zip(self.kinds, drawn_of(drawn), strict=True):
            kinds += [kind] * len(shapes[:FITS_PER_KIND])
            starts += list(shapes[:FITS_PER_KIND])
        rounding = float(np.finfo(np.float32).eps) * self.search.size
        hopeless = MAX_DEVIATION_RATIO * (self.shape.fit.rms + rounding)
        own, *offers = self.search.fitter.fit_all(kinds, starts, self.rows, COMPARED_GAIN, hopeless)
        best: dict[int, ShapeFit] = {}
        for kind, fit in zip(kinds[1:], offers, strict=True):
            if not fit.reason and (kind not in best or fit.rms < best[kind].rms):
                best[kind] = fit
        if not best:
            return []
        counts = every.score(np.stack([fit.shape for fit in best.values()]), np.array(list(best)), self.limits)
        spread = _spread(own, self.shape.kind) + rounding
        return [
            Rival(kind, fit, (_spread(fit, kind) + rounding) / spread, int(count))
            for (kind, fit), count in zip(best.items(), counts, strict=True)
        ]


def _spread(fit: ShapeFit, kind: int) -> float:
    return fit.rms * float(np.sqrt(fit.count / max(fit.count - len(FREE_ENTRIES[kind]), 1)))
