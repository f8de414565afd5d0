"""Many clouds in one array, each in Hilbert order, for batched searches.

Finite points are padded with points at infinity to whole buckets, so that a bucket belongs to one cloud. All share one
curve through the common box and one sort (40 B per point while it runs, 16 B afterward).
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..array_types import AnyArray, Integers, LongIntegers, Points, Vectors
from ..arrays.bounds import bound_points
from ..arrays.concatenation import concatenate_rows
from ..arrays.prefix_sum import find_owner
from ..arrays.sort import SortKeys
from ..lang import INFINITY, array, float32, func, int32, int64, kernel, launch, struct, tid, vec3
from ..memory import download, empty, upload, upload_together
from .hilbert_order import MAX_LEVELS, HilbertCurve, encode_points
from .point_tree import BUCKET, PointTree


@struct
class ManyClouds:
    """Clouds in one array, each along the curve, with infinite padding: `order`: row in its cloud or -1; `owners` per
    bucket; `starts` in the input; `first_positions`, multiples of BUCKET; `codes` of first points; `bases`, `counts`
    and box on the host. Raises ValueError for 2^31 positions or more.
    """

    points: array(dtype=vec3)
    order: array(dtype=int32)
    owners: array(dtype=int32)
    starts: array(dtype=int32)
    first_positions: array(dtype=int32)
    finite_counts: array(dtype=int32)
    codes: array(dtype=int64)
    curve: HilbertCurve

    def __init__(self, clouds: Sequence[Vectors], tree: PointTree | None = None, joined: Vectors | None = None) -> None:
        """`joined`: the clouds in one array, if there is one."""
        device = clouds[0].device
        sizes = np.array([c.size for c in clouds], np.int64)
        starts, count = np.concatenate([[0], np.cumsum(sizes)]), len(clouds)
        if starts[-1] + BUCKET * count >= 2**31:
            raise ValueError(f"{starts[-1]:,} points in {count:,} clouds; register them in parts below 2^31 points")
        points = joined
        if points is None:
            points = clouds[0] if len(clouds) == 1 else concatenate_rows(clouds)
        self.device = device
        self.moments: Any = None  # as are `single_job`, of Jobs
        self.single_job: Any = None
        if tree is None:
            keys, rows, bits = self._sort(points, starts)
        else:
            keys, bits = tree.codes, 0
            self.curve, rows, self.counts = tree.curve, tree.order, np.array([tree.count])
            self.low, self.high = tree.low, tree.high
        buckets = np.maximum(1, -(-self.counts // BUCKET))
        self.bases = np.concatenate([[0], np.cumsum(buckets)[:-1]]) * BUCKET
        self.buckets, total = buckets, int(buckets.sum())
        owners = np.repeat(np.arange(count), buckets)
        tables = {"owners": owners, "first_positions": self.bases, "finite_counts": self.counts}
        if count == 1:
            tables["starts"] = starts
        vars(self).update(zip(tables, upload_together([*tables.values()], int32, device), strict=True))
        self.order, self.points = empty(total * BUCKET, int32, device), empty(total * BUCKET, vec3, device)
        launch(gather_points_kernel, self.points.size, [points, rows, self])
        if tree is None:
            self.codes = empty(total, int64, device)
            launch(gather_codes_kernel, total, [keys, bits, self])
        else:
            self.codes = keys

    def _sort(self, points: Points, starts: np.ndarray) -> tuple[LongIntegers, Integers, int]:
        """(keys, rows, code bits) of all points along one curve, cloud by cloud. Counts the finite ones."""
        device, count = self.device, len(starts) - 1
        low, high, finite = bound_points(points)  # sync
        self.low, self.high = low, high
        index_bits, segment_bits = max(1, (points.size - 1).bit_length()), (count - 1).bit_length()
        levels = min(MAX_LEVELS, (62 - index_bits - segment_bits) // 3)
        self.curve = HilbertCurve(low, high, levels, is_empty=not finite)
        bits, keys = self.curve.code_bits, encode_points(points, self.curve)
        if count == 1:
            self.counts = np.array([finite], np.int64)
            return *keys.sort(bits, starts), bits
        self.starts, counts = upload(starts, int32, device), empty(count, int32, device)
        launch(mark_segments_kernel, points.size, [self.starts, bits, keys])
        sorted_keys, rows = keys.sort(bits + segment_bits, starts)
        launch(count_finite_kernel, count, [sorted_keys, self.starts, bits, counts])
        self.counts = download(counts).astype(np.int64)  # sync
        return sorted_keys, rows, bits

    def gather(self, arrays: Sequence[AnyArray]) -> AnyArray:
        """One attribute of all clouds, vec3 or float32 (n, c), in sorted order."""
        values = arrays[0] if len(arrays) == 1 else concatenate_rows(arrays)
        if values.dtype == vec3:
            gathered, gather = empty(self.points.size, vec3, self.device), gather_vectors_kernel
        else:
            gathered, gather = empty((self.points.size, values.shape[1]), float32, self.device), gather_rows_kernel
        launch(gather, self.points.size, [values, self, gathered])
        return gathered


@kernel
def mark_segments_kernel(starts: array(dtype=int32), bits: int, codes: SortKeys):
    i = tid()
    codes.keys[i] = codes.keys[i] | (int64(find_owner(starts, i)) << int64(bits))


@kernel
def count_finite_kernel(keys: array(dtype=int64), starts: array(dtype=int32), bits: int, counts: array(dtype=int32)):
    """Count the finite points of each segment by bisection. The others are last."""
    i = tid()
    limit = (int64(i) << int64(bits)) | (1 << int64(bits - 1))
    a = starts[i]
    b = starts[i + 1]
    while a < b:
        middle = (a + b) // 2
        if keys[middle] < limit:
            a = middle + 1
        else:
            b = middle
    counts[i] = a - starts[i]


@kernel
def gather_points_kernel(points: array(dtype=vec3), sorted_rows: array(dtype=int32), clouds: ManyClouds):
    """Sorted points. Padding has row -1 and infinite coordinates."""
    i = tid()
    owner = clouds.owners[i // BUCKET]
    rank = i - clouds.first_positions[owner]
    row = -1
    p = vec3(INFINITY, INFINITY, INFINITY)
    if rank < clouds.finite_counts[owner]:
        at = sorted_rows[clouds.starts[owner] + rank]
        row = at - clouds.starts[owner]
        p = points[at]
    clouds.order[i] = row
    clouds.points[i] = p


@kernel
def gather_codes_kernel(keys: array(dtype=int64), bits: int, clouds: ManyClouds):
    i = tid()
    owner = clouds.owners[i]
    at = clouds.starts[owner] + i * BUCKET - clouds.first_positions[owner]
    code = int64(0)
    if at < clouds.starts[owner + 1]:
        code = keys[at] & ((1 << int64(bits)) - 1)
    clouds.codes[i] = code


@func
def given_row(i: int, clouds: ManyClouds) -> int:
    """Input row, over all clouds, of the point at a position, or -1 for padding."""
    row = clouds.order[i]
    at = -1
    if row >= 0:
        at = clouds.starts[clouds.owners[i // BUCKET]] + row
    return at


@kernel
def gather_rows_kernel(
    values: array(dtype=float32, ndim=2), clouds: ManyClouds, gathered: array(dtype=float32, ndim=2)
):
    i = tid()
    row = given_row(i, clouds)
    for column in range(gathered.shape[1]):
        value = 0.0
        if row >= 0:
            value = values[row, column]
        gathered[i, column] = value


@kernel
def gather_vectors_kernel(values: array(dtype=vec3), clouds: ManyClouds, gathered: array(dtype=vec3)):
    i = tid()
    row = given_row(i, clouds)
    value = vec3(0.0, 0.0, 0.0)
    if row >= 0:
        value = values[row]
    gathered[i] = value
