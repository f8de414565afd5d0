"""Which triangles of a mesh are none: those that name a vertex twice, have no area or a corner that is not finite, and
those that an earlier one repeats.

Repeats are found by sorting: triangles turned so that their lowest vertex comes first are compared as whole numbers, by
their first two vertices and, among equals, by the third. 12 B read and 1 B written a triangle beside two sorts.
"""

from ..array_types import Mask, Points, Triangles
from ..arrays.select import gather_rows
from ..arrays.sort import argsort_keys
from ..lang import array, func, int32, int64, isfinite, kernel, launch, length, tid, uint8, vec3, vec3i
from ..memory import empty
from .mesh_measures import triangle_cross


@func
def names_twice(t: vec3i) -> int:
    """1 where two corners are one vertex."""
    found = 0
    if t[0] == t[1] or t[1] == t[2] or t[2] == t[0]:
        found = 1
    return found


@kernel
def mask_degenerate_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), zero_area: int, mask: array(dtype=uint8)
):
    """1 where two corners are one vertex; with `zero_area` where the area is zero, too."""
    i = tid()
    t = triangles[i]
    found = names_twice(t)
    if zero_area == 1 and found == 0:
        n = triangle_cross(vertices, t)
        whole = isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])
        if whole and length(n) == 0.0:
            found = 1
    mask[i] = uint8(found)


@kernel
def mask_not_finite_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), mask: array(dtype=uint8)):
    """1 where a corner is not finite."""
    i = tid()
    t = triangles[i]
    whole = isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])
    mask[i] = uint8(0 if whole else 1)


@func
def turned(t: vec3i) -> vec3i:
    """The least of the three turns of a triangle, compared corner by corner."""
    best = t + vec3i(0, 0, 0)
    for k in range(2):
        other = vec3i(t[1], t[2], t[0])
        if k == 1:
            other = vec3i(t[2], t[0], t[1])
        less = 0
        if other[0] < best[0]:
            less = 1
        if other[0] == best[0] and other[1] < best[1]:
            less = 1
        if other[0] == best[0] and other[1] == best[1] and other[2] < best[2]:
            less = 1
        if less == 1:
            best = other
    return best


@kernel
def list_third_keys_kernel(triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    """The third vertex of a turned triangle."""
    i = tid()
    keys[i] = int64(turned(triangles[i])[2])


@kernel
def list_first_keys_kernel(
    triangles: array(dtype=vec3i), rows: array(dtype=int32), bits: int, keys: array(dtype=int64)
):
    """The first two vertices of some turned triangles."""
    i = tid()
    t = turned(triangles[rows[i]])
    keys[i] = (int64(t[0]) << int64(bits)) | int64(t[1])


@kernel
def mask_repeats_kernel(triangles: array(dtype=vec3i), order: array(dtype=int32), mask: array(dtype=uint8)):
    """1 where the triangle before in a sorted order is the same; equal ones stand by their numbers."""
    i = tid()
    same = 0
    if i > 0:
        t = turned(triangles[order[i]])
        s = turned(triangles[order[i - 1]])
        if t[0] == s[0] and t[1] == s[1] and t[2] == s[2]:
            same = 1
    mask[order[i]] = uint8(same)


def mask_degenerate(vertices: Points, triangles: Triangles, *, zero_area: bool) -> Mask:
    """uint8 [t]: 1 for triangles that name a vertex twice, and where asked for those of finite corners without area."""
    mask = empty(triangles.size, uint8, triangles.device)
    launch(mask_degenerate_kernel, triangles.size, [vertices, triangles, int(zero_area), mask])
    return mask


def mask_not_finite(vertices: Points, triangles: Triangles) -> Mask:
    """uint8 [t]: 1 for triangles with a corner that is not finite."""
    mask = empty(triangles.size, uint8, triangles.device)
    launch(mask_not_finite_kernel, triangles.size, [vertices, triangles, mask])
    return mask


def mask_repeats(triangles: Triangles, vertex_count: int) -> Mask:
    """uint8 [t]: 1 for triangles that are an earlier one, turned or not; the opposite of one is another."""
    device, count, bits = triangles.device, triangles.size, max(1, vertex_count.bit_length())
    keys = empty(count, int64, device)
    launch(list_third_keys_kernel, count, [triangles, keys])
    _, thirds = argsort_keys(keys, bits)
    keys = empty(count, int64, device)
    launch(list_first_keys_kernel, count, [triangles, thirds, bits, keys])
    _, places = argsort_keys(keys, 2 * bits)
    order = gather_rows(thirds, places)
    mask = empty(count, uint8, device)
    launch(mask_repeats_kernel, count, [triangles, order, mask])
    return mask
