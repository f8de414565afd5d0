"""What else may explain the points of a found shape: how many lie beside it, and how well other kinds fit them.

A shape that touches another surface along a strip has some of its points, and next to them those that part from it
slowly: their distances grow with the square of the way from the strip, so that of what lies within three tolerances
more than a third lies beyond one. On a true shape nearly nothing does. One thread a point, 20 B and some 60 operations.
A rival of another kind is drawn among some of the shape's points and fitted to these in least squares.
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
from .shape_fit import FREE, ShapeFit, frame_of
from .shape_models import measure
from .shape_rows import every_of
from .shape_search import Found, ShapeLimits, ShapeSearch, drawn_of

BAND = 3.0  # tolerances within which a point lies beside a surface
COMPARED = 4096  # points of a shape that rivals are fitted to
DRAWN = 256  # samples of a rival kind
STARTS = 2  # of them that are fitted
HOPELESS = 5.0  # times the found shape's deviation: a rival that is no nearer after some steps is none
COMPARED_GAIN = 1.0e-5  # of squared distances: a step that gains less ends a fit, whose rms is told to 1 %
FREE_SIZE = 20.0  # sizes of the cloud: rounder ones are flat


@dataclass(frozen=True)
class Band:
    """Points within the box of a shape's own, by their distance from it.

    Attributes:
        on, beside: Within the tolerance, and up to BAND times as far, whichever way they face.
        on_facing, beside_facing: Those of them that face as the surface does.
    """

    on: int
    beside: int
    on_facing: int
    beside_facing: int


@dataclass(frozen=True)
class Rival:
    """A shape of another kind, fitted to the points of a found one.

    Attributes:
        kind: Of `shape_models`.
        fit: To COMPARED of the points at most.
        ratio: Of the standard deviation of its distances to the found shape's, of the same points.
        support: Points of the cloud on it.
    """

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
    """Count a point that lies on a shape or beside it, in the box of the shape's own points."""
    i = tid()
    x = sampled_point(points, rows[i], center)
    y = x - p
    v = cross(a, u)
    m = measure(kind, p, a, sizes[0], sizes[1], x)
    far = near * float64(BAND)
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
        place = 0
        if abs(m[0]) >= near:
            place = 1
        atomic_add(counts, place, 1)  # whole sums, the same in any order
        if facing >= cosine * size:
            atomic_add(counts, place + 2, 1)


def count_band(search: ShapeSearch, found: Found, box: Array1[float32], distance: float, cosine: float) -> Integers:
    """How many of the points searched lie on a shape and beside it, within its box: a `Band`'s numbers; no sync."""
    counts, shape, frame = zeros(4, int32, search.device), found.fit.shape, frame_of(found.fit.shape[3:6])
    arguments = [search.points, search.normals, search.rows, vec3d(*search.center), found.kind, vec3d(*shape[:3])]
    arguments += [vec3d(*frame[0]), vec3d(*frame[2]), vec3d(shape[6], shape[7], 0.0), box]
    launch(count_band_kernel, search.rows.size, [*arguments, distance, cosine, counts])
    return counts


class RivalStarts:
    """Samples of each other kind among the points of a found shape."""

    def __init__(self, search: ShapeSearch, found: Found, limits: ShapeLimits) -> None:
        """Draw among some of the points; rivals have any size."""
        self.search, self.found, self.limits, self.rows = search, found, limits, found.rows
        if found.rows.size > COMPARED:
            self.rows = every_of(found.rows, -(-found.rows.size // COMPARED))
        part = ShapeSearch(search.points, search.normals, self.rows, search)
        wide = replace(limits, smallest=0.0, largest=FREE_SIZE * max(search.size, 1e-30))
        self.kinds = [kind for kind in FREE if kind != found.kind and self.rows.size > len(FREE[kind]) + 1]
        self.unread = [values for kind in self.kinds for values in part.draw_unread(kind, DRAWN, 0, 0, wide)]

    def find(self, drawn: Sequence[NDArray[Any]], every: ShapeSearch) -> list[Rival]:
        """The best shape of each other kind, where there is one; two syncs.

        Args:
            drawn: The arrays of `unread`.
            every: All points, of which the support is counted.
        """
        kinds, starts = [self.found.kind], [self.found.fit.shape]
        for kind, (shapes, _) in zip(self.kinds, drawn_of(drawn), strict=True):
            kinds += [kind] * len(shapes[:STARTS])
            starts += list(shapes[:STARTS])
        rounding = float(np.finfo(np.float32).eps) * self.search.size
        hopeless = HOPELESS * (self.found.fit.rms + rounding)
        own, *offers = self.search.fitter.fit_all(kinds, starts, self.rows, COMPARED_GAIN, hopeless)
        best: dict[int, ShapeFit] = {}
        for kind, fit in zip(kinds[1:], offers, strict=True):
            if not fit.reason and (kind not in best or fit.rms < best[kind].rms):
                best[kind] = fit
        if not best:
            return []
        counts = every.score(np.stack([fit.shape for fit in best.values()]), np.array(list(best)), self.limits)
        spread = _spread(own, self.found.kind) + rounding
        return [
            Rival(kind, fit, (_spread(fit, kind) + rounding) / spread, int(count))
            for (kind, fit), count in zip(best.items(), counts, strict=True)
        ]


def _spread(fit: ShapeFit, kind: int) -> float:
    return fit.rms * float(np.sqrt(fit.count / max(fit.count - len(FREE[kind]), 1)))
