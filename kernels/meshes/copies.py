"""Triangles of the same three vertices, whichever way round: each in the class of its vertices.

As repeats are found (clean_triangles.py), by two sorts of whole numbers. 12 B read and 4 B written a triangle beside
them.
"""

from ..array_types import Integers, Triangles
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import gather_rows
from ..arrays.sort import argsort_keys
from ..lang import array, func, int32, int64, kernel, launch, tid, vec3i
from ..memory import download, empty


@func
def ascending(t: vec3i) -> vec3i:
    """The vertices of a triangle, the lowest first."""
    low = min(t[0], min(t[1], t[2]))
    high = max(t[0], max(t[1], t[2]))
    return vec3i(low, t[0] + t[1] + t[2] - low - high, high)


@kernel
def list_high_keys_kernel(triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    """The highest vertex."""
    i = tid()
    keys[i] = int64(ascending(triangles[i])[2])


@kernel
def list_low_keys_kernel(triangles: array(dtype=vec3i), rows: array(dtype=int32), bits: int, keys: array(dtype=int64)):
    """The other two of some triangles."""
    i = tid()
    t = ascending(triangles[rows[i]])
    keys[i] = (int64(t[0]) << int64(bits)) | int64(t[1])


@kernel
def mark_new_classes_kernel(triangles: array(dtype=vec3i), order: array(dtype=int32), marks: array(dtype=int32)):
    """1 where a triangle has other vertices than the one before in the order; 0 at the first."""
    i = tid()
    mark = 0
    if i > 0:
        t = ascending(triangles[order[i]])
        s = ascending(triangles[order[i - 1]])
        if t[0] != s[0] or t[1] != s[1] or t[2] != s[2]:
            mark = 1
    marks[i] = mark


@kernel
def spread_classes_kernel(order: array(dtype=int32), ranks: array(dtype=int32), classes: array(dtype=int32)):
    """The class of each triangle."""
    i = tid()
    classes[order[i]] = ranks[i]


def find_copies(triangles: Triangles, vertex_count: int) -> tuple[Integers, int]:
    """(classes int32 [t], their count): triangles of the same vertices have the same one; one sync."""
    device, count, bits = triangles.device, triangles.size, max(1, vertex_count.bit_length())
    if count == 0:
        return empty(0, int32, device), 0
    keys = empty(count, int64, device)
    launch(list_high_keys_kernel, count, [triangles, keys])
    _, highs = argsort_keys(keys, bits)
    keys = empty(count, int64, device)
    launch(list_low_keys_kernel, count, [triangles, highs, bits, keys])
    _, places = argsort_keys(keys, 2 * bits)
    order = gather_rows(highs, places)
    ranks, classes = empty(count, int32, device), empty(count, int32, device)
    launch(mark_new_classes_kernel, count, [triangles, order, ranks])
    inclusive_scan(ranks, ranks)
    launch(spread_classes_kernel, count, [order, ranks, classes])
    return classes, int(download(ranks[count - 1 :])[0]) + 1  # sync
