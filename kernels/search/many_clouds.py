"""Many clouds in one array, each in the order of the Hilbert curve: what batches of searches run over.

The finite points of each cloud stand behind one another in the curve's order, padded with points at infinity to whole
buckets, so that a bucket belongs to one cloud. All clouds share one curve through the box of all points. One sort of
(cloud, place on the curve): 40 B of memory a point while it runs, 16 B afterwards.
"""

import numpy as np

from ..arrays.bounds import bound_points
from ..arrays.concatenation import concatenate_rows
from ..arrays.sort import argsort_keys
from ..lang import INFINITY, array, float32, int32, int64, kernel, launch, tid, vec3
from ..memory import empty, upload
from .hilbert_order import MAX_LEVELS, HilbertCurve, encode_points
from .point_tree import BUCKET


@kernel
def mark_segments_kernel(segments: array(dtype=int32), bits: int, keys: array(dtype=int64)):
    """Put the segment of each point above its code."""
    i = tid()
    keys[i] = keys[i] | (int64(segments[i]) << int64(bits))


@kernel
def count_finite_kernel(keys: array(dtype=int64), starts: array(dtype=int32), bits: int, counts: array(dtype=int32)):
    """How many keys of each segment are those of finite points: bisection, as the others stand last."""
    i = tid()
    limit = (int64(i) << int64(bits)) | (int64(1) << int64(bits - 1))
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
def place_points_kernel(
    points: array(dtype=vec3),
    sorted_rows: array(dtype=int32),
    starts: array(dtype=int32),
    counts: array(dtype=int32),
    owners: array(dtype=int32),
    bases: array(dtype=int32),
    order: array(dtype=int32),
    placed: array(dtype=vec3),
):
    """Each point at its place; -1 and infinity where a bucket has no point."""
    i = tid()
    owner = owners[i // BUCKET]
    rank = i - bases[owner]
    row = int(-1)
    p = vec3(INFINITY, INFINITY, INFINITY)
    if rank < counts[owner]:
        at = sorted_rows[starts[owner] + rank]
        row = at - starts[owner]
        p = points[at]
    order[i] = row
    placed[i] = p


@kernel
def place_codes_kernel(
    keys: array(dtype=int64),
    starts: array(dtype=int32),
    owners: array(dtype=int32),
    bases: array(dtype=int32),
    bits: int,
    codes: array(dtype=int64),
):
    """The code of each bucket's first point."""
    i = tid()
    owner = owners[i]
    at = starts[owner] + i * BUCKET - bases[owner]
    code = int64(0)
    if at < starts[owner + 1]:
        code = keys[at] & ((int64(1) << int64(bits)) - int64(1))
    codes[i] = code


@kernel
def gather_rows_kernel(
    values: array(dtype=float32, ndim=2),
    starts: array(dtype=int32),
    owners: array(dtype=int32),
    order: array(dtype=int32),
    placed: array(dtype=float32, ndim=2),
):
    """The rows of the points at their places; zeros where there is no point."""
    i = tid()
    row = order[i]
    at = starts[owners[i // BUCKET]] + row
    for column in range(placed.shape[1]):
        value = float(0.0)
        if row >= 0:
            value = values[at, column]
        placed[i, column] = value


@kernel
def gather_vectors_kernel(
    values: array(dtype=vec3),
    starts: array(dtype=int32),
    owners: array(dtype=int32),
    order: array(dtype=int32),
    placed: array(dtype=vec3),
):
    """The vectors of the points at their places; zero where there is no point."""
    i = tid()
    row = order[i]
    value = vec3(0.0, 0.0, 0.0)
    if row >= 0:
        value = values[starts[owners[i // BUCKET]] + row]
    placed[i] = value


class ManyClouds:
    """Clouds of one device in one array, each along the curve.

    Args:
        clouds: Device arrays of vec3; at least one, all on one device.

    Attributes:
        points: vec3 [padded], the finite points; infinite where a bucket is not full.
        order: int32 [padded], the row of each in its own cloud, or -1.
        owners: int32 [buckets], the cloud of each bucket.
        bases, counts: int64 [clouds] on the host: the first place of each cloud (a multiple of BUCKET), and its finite
            points; `device_bases`, `device_counts` the same as int32 on the device.
        codes: int64 [buckets], the code of each bucket's first point.
        curve: The HilbertCurve.

    Raises:
        ValueError: 2^31 places or more.
    """

    def __init__(self, clouds):
        device = clouds[0].device
        sizes = np.array([c.size for c in clouds], np.int64)
        starts, count = np.concatenate([[0], np.cumsum(sizes)]), len(clouds)
        if starts[-1] + BUCKET * count >= 2**31:
            raise ValueError(f"{starts[-1]:,} points in {count:,} clouds; register them in parts below 2^31 points")
        points = clouds[0] if count == 1 else concatenate_rows(clouds)
        self.device, self._starts = device, upload(starts, int32, device)
        low, high, finite = bound_points(points)  # sync
        index_bits, segment_bits = max(1, (points.size - 1).bit_length()), (count - 1).bit_length()
        levels = min(MAX_LEVELS, (62 - index_bits - segment_bits) // 3)
        self.curve = HilbertCurve(low, high, levels, is_empty=not finite)
        bits, keys = self.curve.code_bits, encode_points(points, self.curve)
        if count > 1:
            segments = upload(np.repeat(np.arange(count, dtype=np.int32), sizes), int32, device)
            launch(mark_segments_kernel, points.size, [segments, bits, keys])
        keys, rows = argsort_keys(keys, bits + segment_bits)
        counts = empty(count, int32, device)
        launch(count_finite_kernel, count, [keys, self._starts, bits, counts])
        self.device_counts, self.counts = counts, counts.numpy().astype(np.int64)  # sync
        buckets = np.maximum(1, -(-self.counts // BUCKET))
        self.bases = np.concatenate([[0], np.cumsum(buckets)[:-1]]) * BUCKET
        self.buckets, total = buckets, int(buckets.sum())
        self.owners = upload(np.repeat(np.arange(count), buckets), int32, device)
        self.device_bases = upload(self.bases, int32, device)
        self.order, self.points = empty(total * BUCKET, int32, device), empty(total * BUCKET, vec3, device)
        tables = [self._starts, self.device_counts, self.owners, self.device_bases]
        launch(place_points_kernel, self.points.size, [points, rows, *tables, self.order, self.points])
        self.codes = empty(total, int64, device)
        launch(place_codes_kernel, total, [keys, self._starts, self.owners, self.device_bases, bits, self.codes])

    def gather(self, arrays):
        """One attribute of all clouds, vec3 or float32 [n, c], at the places of their points."""
        values = arrays[0] if len(arrays) == 1 else concatenate_rows(arrays)
        if values.dtype == vec3:
            placed, gather = empty(self.points.size, vec3, self.device), gather_vectors_kernel
        else:
            placed, gather = empty((self.points.size, values.shape[1]), float32, self.device), gather_rows_kernel
        launch(gather, self.points.size, [values, self._starts, self.owners, self.order, placed])
        return placed
