"""Lexicographic order of triangles by two stable integer sorts."""

from ..array_types import Indices, Triangles
from ..arrays.select import gather_rows
from ..arrays.sort import argsort_keys
from ..lang import array, compute, int32, int64, kernel, tid, vec3i


@kernel
def list_third_keys_kernel(triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    i = tid()
    keys[i] = int64(triangles[i][2])


@kernel
def list_first_keys_kernel(
    triangles: array(dtype=vec3i), rows: array(dtype=int32), bits: int, keys: array(dtype=int64)
):
    i = tid()
    t = triangles[rows[i]]
    keys[i] = (int64(t[0]) << int64(bits)) | int64(t[1])


@kernel
def mark_new_triangles_kernel(triangles: array(dtype=vec3i), order: array(dtype=int32), marks: array(dtype=int32)):
    i = tid()
    mark = 0
    if i > 0:
        t = triangles[order[i]]
        s = triangles[order[i - 1]]
        if t[0] != s[0] or t[1] != s[1] or t[2] != s[2]:
            mark = 1
    marks[i] = mark


def sort_triangles(triangles: Triangles, vertex_count: int) -> Indices:
    """Rows of triangles in lexicographic order. Equal ones keep their order."""
    device, count, bits = triangles.device, triangles.size, max(1, vertex_count.bit_length())
    keys = compute(list_third_keys_kernel, count, [triangles], int64, device)
    _, thirds = argsort_keys(keys, bits)
    keys = compute(list_first_keys_kernel, count, [triangles, thirds, bits], int64, device)
    _, order = argsort_keys(keys, 2 * bits)
    return gather_rows(thirds, order)
