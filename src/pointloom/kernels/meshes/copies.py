"""Classes of triangles with the same three vertices in any orientation, by sorting (triangle_order.py)."""

from ..array_types import Integers, Triangles
from ..arrays.prefix_sum import inclusive_scan
from ..lang import array, compute, int32, kernel, launch, tid, vec3i
from ..memory import download, empty
from .triangle_order import mark_new_triangles_kernel, sort_triangles


@kernel
def list_ascending_kernel(triangles: array(dtype=vec3i), ascending: array(dtype=vec3i)):
    i = tid()
    t = triangles[i]
    low = min(t[0], min(t[1], t[2]))
    high = max(t[0], max(t[1], t[2]))
    ascending[i] = vec3i(low, t[0] + t[1] + t[2] - low - high, high)


@kernel
def spread_classes_kernel(order: array(dtype=int32), ranks: array(dtype=int32), classes: array(dtype=int32)):
    i = tid()
    classes[order[i]] = ranks[i]


def find_copies(triangles: Triangles, vertex_count: int) -> tuple[Integers, int]:
    """(classes int32 [t], their count). One sync."""
    device, count = triangles.device, triangles.size
    if count == 0:
        return empty(0, int32, device), 0
    ascending = compute(list_ascending_kernel, count, [triangles], vec3i, device)
    order = sort_triangles(ascending, vertex_count)
    ranks, classes = empty(count, int32, device), empty(count, int32, device)
    launch(mark_new_triangles_kernel, count, [ascending, order, ranks])
    inclusive_scan(ranks, ranks)
    launch(spread_classes_kernel, count, [order, ranks, classes])
    return classes, int(download(ranks[count - 1 :])[0]) + 1  # sync
