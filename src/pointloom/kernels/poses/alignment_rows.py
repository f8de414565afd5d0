"""Point-to-plane rows of two surfaces at a given pose, in both directions, and their robust normal equations.

Weights of Geman and McClure (1985). The scores of the rows are also summed by blocks of space, for a covariance that
is valid if the errors within a block are correlated (Liang and Zeger 1986).
"""

import numpy as np

from ..algebra.transform import Transform, narrow, transform_point, transform_points, widen
from ..array_types import LongIntegers
from ..arrays.block_keys import block_key
from ..arrays.packed_keys import key_index
from ..arrays.quantiles import median_above_zero
from ..arrays.run_sums import sum_columns
from ..arrays.select import positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    mat44d,
    reduce,
    reduction,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..memory import download, empty
from ..search.nearest_point import NO_POINT, find_nearest
from ..surface.hollow_side import Surface
from .overlap_evidence import move_surface_kernel

motions = vector(6, float64)
position_sums = vector(9, float64)  # x, y, z, xx, xy, xz, yy, yz, zz
system_sums = vector(28, float64)  # weight, upper triangle, right side
TRIANGLE_SIZE = 21


@struct
class PairedSurfaces:
    """Two surfaces, the source moved by a pose, with the nearest point of each point in the other surface."""

    moved: array(dtype=vec3)
    moved_normals: array(dtype=vec3)
    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    nearest_target: array(dtype=int64)
    nearest_source: array(dtype=int64)
    cosine: float

    def __init__(
        self, source: Surface, target: Surface, pose: np.ndarray, inverse: np.ndarray, radius: float, cosine: float
    ) -> None:
        """`pose` T_target_source about the clouds' origins; `radius` [m] of the search; `cosine` limits normals."""
        device = source.device
        self.points, self.normals, self.cosine = target.points, target.normals, cosine
        self.moved, self.moved_normals = (empty(len(source), vec3, device) for _ in range(2))
        T = mat44d(*pose.ravel().tolist())
        launch(move_surface_kernel, len(source), [source.points, source.normals, T, self.moved, self.moved_normals])
        back = transform_points(target.points, inverse[:3, :3], inverse[:3, 3])
        self.nearest_target = find_nearest(target.tree, self.moved, radius=radius, order=source.tree.order)
        self.nearest_source = find_nearest(source.tree, back, radius=radius, order=target.tree.order)


@func
def rows_of_pair(surfaces: PairedSurfaces, i: int) -> tuple[int, int]:
    """Row in the source and in the target, or -1: of a source point, then of a target point."""
    count = surfaces.moved.shape[0]
    source = -1
    target = -1
    if i < count:
        if surfaces.nearest_target[i] != int64(NO_POINT):
            source = i
            target = key_index(surfaces.nearest_target[i])
    elif surfaces.nearest_source[i - count] != int64(NO_POINT):
        source = key_index(surfaces.nearest_source[i - count])
        target = i - count
    return source, target


@kernel
def mask_pairs_kernel(surfaces: PairedSurfaces, mask: array(dtype=uint8)):
    i = tid()
    source, target = rows_of_pair(surfaces, i)
    agrees = 0
    if source >= 0:
        if abs(dot(surfaces.moved_normals[source], surfaces.normals[target])) > surfaces.cosine:
            agrees = 1
    mask[i] = uint8(agrees)


@reduction
def sum_positions(surfaces: PairedSurfaces, pairs: array(dtype=int32)) -> position_sums:
    i = tid()
    source, _target = rows_of_pair(surfaces, pairs[i])
    p = widen(surfaces.moved[source])
    return position_sums(p[0], p[1], p[2], p[0] * p[0], p[0] * p[1], p[0] * p[2], p[1] * p[1], p[1] * p[2], p[2] * p[2])


@kernel
def fill_rows_kernel(
    surfaces: PairedSurfaces,
    pairs: array(dtype=int32),
    middle: vec3d,
    scale: float64,
    rows: array(dtype=motions),
    residuals: array(dtype=float64),
):
    """Derivatives of the distance along the normal of the found point, rotations about `middle` times 1 / `scale`."""
    i = tid()
    source, target = rows_of_pair(surfaces, pairs[i])
    p = widen(surfaces.moved[source])
    n = widen(surfaces.normals[target])
    if pairs[i] >= surfaces.moved.shape[0]:
        n = widen(surfaces.moved_normals[source])
    c = cross((p - middle) * scale, n)
    rows[i] = motions(c[0], c[1], c[2], n[0], n[1], n[2])
    residuals[i] = dot(p - widen(surfaces.points[target]), n)


@func
def residual_after(rows: array(dtype=motions), residuals: array(dtype=float64), motion: motions, i: int) -> float64:
    return residuals[i] + dot(rows[i], motion)


@func
def weight_of(residual: float64, width: float64) -> float64:
    """Geman-McClure weight."""
    e = residual / width
    root = 1.0 / (1.0 + e * e)
    return root * root


@kernel
def measure_residuals_kernel(
    rows: array(dtype=motions), residuals: array(dtype=float64), motion: motions, out: array(dtype=float64)
):
    i = tid()
    out[i] = abs(residual_after(rows, residuals, motion, i))


@reduction
def sum_system(
    rows: array(dtype=motions), residuals: array(dtype=float64), motion: motions, width: float64
) -> system_sums:
    """Sum of the weights at a motion, of the normal matrix and of the right side without the motion."""
    i = tid()
    a = rows[i]
    weight = weight_of(residual_after(rows, residuals, motion, i), width)
    out = system_sums(0.0)
    out[0] = weight
    at = 1
    for j in range(6):
        for k in range(j, 6):
            out[at] = weight * a[j] * a[k]
            at += 1
    for j in range(6):
        out[22 + j] = weight * a[j] * residuals[i]
    return out


@kernel
def score_rows_kernel(
    surfaces: PairedSurfaces,
    pairs: array(dtype=int32),
    rows: array(dtype=motions),
    residuals: array(dtype=float64),
    motion: motions,
    width: float64,
    frame: Transform,
    block_size: float,
    scores: array(dtype=float64, ndim=2),
    blocks: array(dtype=int64),
):
    """Gradient of each row at a motion, and its block of space in a frame."""
    i = tid()
    residual = residual_after(rows, residuals, motion, i)
    a = rows[i]
    factor = weight_of(residual, width) * residual
    for k in range(6):
        scores[i, k] = factor * a[k]
    source, _target = rows_of_pair(surfaces, pairs[i])
    p = narrow(transform_point(widen(surfaces.moved[source]), frame))
    blocks[i] = block_key(int(floor(p[0] / block_size)), int(floor(p[1] / block_size)), int(floor(p[2] / block_size)))


class AlignmentRows:
    """Linearized rows of two surfaces at a pose: their number `len()`, their `middle` about the target's origin [m],
    the `lever` [m], which is the RMS distance from it and scales rotations, and the covariance of the positions in
    levers, `spread` [3, 3].
    """

    def __init__(self, surfaces: PairedSurfaces) -> None:
        """Three syncs."""
        device = surfaces.moved.device
        self._surfaces = surfaces
        mask = compute(mask_pairs_kernel, surfaces.moved.size + surfaces.points.size, [surfaces], uint8, device)
        self._pairs = positions_of(mask)  # sync
        count = self._pairs.size
        self.middle, self.lever, self.spread = np.zeros(3), 1.0, np.eye(3) / 3
        if count:
            sums = download(reduce(sum_positions, count, [surfaces, self._pairs]))[0] / count  # sync
            self.middle = sums[:3]
            squares = sums[[3, 4, 5, 4, 6, 7, 5, 7, 8]].reshape(3, 3) - np.outer(self.middle, self.middle)
            self.lever = max(float(np.sqrt(max(np.trace(squares), 0.0))), 1e-9)
            self.spread = squares / self.lever**2
        self._rows, self._residuals = empty(count, motions, device), empty(count, float64, device)
        frame = [vec3d(*self.middle.tolist()), 1.0 / self.lever]
        launch(fill_rows_kernel, count, [surfaces, self._pairs, *frame, self._rows, self._residuals])

    def __len__(self) -> int:
        return self._pairs.size

    def median_residual(self, motion: np.ndarray) -> float:
        """Median distance along the normal after a motion [m]. One sync."""
        distances = empty(len(self), float64, self._rows.device)
        launch(measure_residuals_kernel, len(self), [self._rows, self._residuals, motions(*motion), distances])
        return median_above_zero(distances) or 0.0

    def system(self, motion: np.ndarray, width: float) -> tuple[float, np.ndarray, np.ndarray]:
        """Sum of the weights at a motion, upper triangle (21) of the normal matrix, and right side (6). One sync."""
        sums = download(reduce(sum_system, len(self), [self._rows, self._residuals, motions(*motion), width]))[0]
        return float(sums[0]), sums[1 : 1 + TRIANGLE_SIZE], sums[1 + TRIANGLE_SIZE :]

    def block_scores(
        self, motion: np.ndarray, width: float, block_size: float, frame: np.ndarray
    ) -> tuple[LongIntegers, np.ndarray]:
        """Keys of blocks with an edge [m], and the sums of the gradients over them, float64 (blocks, 6). Two syncs.

        `frame`: T_frame_target about the target's origin, in which space is divided.
        """
        device = self._rows.device
        scores, keys = empty((len(self), 6), float64, device), empty(len(self), int64, device)
        at = [motions(*motion), width, Transform(frame), block_size]
        launch(
            score_rows_kernel, len(self), [self._surfaces, self._pairs, self._rows, self._residuals, *at, scores, keys]
        )
        groups = UniqueKeys(keys)
        return groups.keys, download(sum_columns(scores, groups.order, groups.starts))
