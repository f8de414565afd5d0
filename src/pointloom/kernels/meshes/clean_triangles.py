"""Masks of degenerate, non-finite and duplicate triangles.

Duplicates are equal rows (first_rows.py) once triangles are rotated to begin with their lowest vertex.
"""

from ..array_types import Mask, Points, Triangles
from ..arrays.first_rows import mask_first_rows
from ..lang import array, compute, func, isfinite, kernel, launch, length, tid, uint8, vec3, vec3i
from ..memory import empty, zeros
from .mesh_measures import triangle_cross


@func
def uses_vertex_twice(t: vec3i) -> int:
    repeated = 0
    if t[0] == t[1] or t[1] == t[2] or t[2] == t[0]:
        repeated = 1
    return repeated


@kernel
def mask_degenerate_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), zero_area: int, mask: array(dtype=uint8)
):
    i = tid()
    t = triangles[i]
    degenerate = uses_vertex_twice(t)
    if zero_area == 1 and degenerate == 0:
        n = triangle_cross(vertices, t)
        finite = isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])
        if finite and length(n) == 0.0:
            degenerate = 1
    mask[i] = uint8(degenerate)


@kernel
def mask_not_finite_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), mask: array(dtype=uint8)):
    i = tid()
    t = triangles[i]
    finite = isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])
    mask[i] = uint8(0 if finite else 1)


@kernel
def list_rotated_kernel(triangles: array(dtype=vec3i), rotated: array(dtype=vec3i)):
    i = tid()
    t = triangles[i]
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
        if less == 1:
            best = other
    rotated[i] = best


def mask_degenerate(vertices: Points, triangles: Triangles, *, zero_area: bool) -> Mask:
    """uint8 [t]: 1 for triangles with repeated vertices, and with `zero_area` also finite triangles without area."""
    mask = empty(triangles.size, uint8, triangles.device)
    launch(mask_degenerate_kernel, triangles.size, [vertices, triangles, int(zero_area), mask])
    return mask


def mask_not_finite(vertices: Points, triangles: Triangles) -> Mask:
    return compute(mask_not_finite_kernel, triangles.size, [vertices, triangles], uint8, triangles.device)


@kernel
def join_masks_kernel(more: array(dtype=uint8), mask: array(dtype=uint8)):
    i = tid()
    if more[i] != 0:
        mask[i] = uint8(1)


def join_masks(mask: Mask, *others: Mask) -> Mask:
    for more in others:
        launch(join_masks_kernel, mask.size, [more, mask])
    return mask


@kernel
def mark_corners_kernel(triangles: array(dtype=vec3i), removed: array(dtype=uint8), used: array(dtype=uint8)):
    """1 for vertices of unmasked triangles. All threads write the same value."""
    i = tid()
    if removed[i] == 0:
        t = triangles[i]
        for k in range(3):
            used[t[k]] = uint8(1)


def mask_used(triangles: Triangles, removed: Mask, vertex_count: int) -> Mask:
    """uint8 [m]: 1 for vertices of unmasked triangles."""
    used = zeros(vertex_count, uint8, triangles.device)
    launch(mark_corners_kernel, triangles.size, [triangles, removed, used])
    return used


def mask_repeats(triangles: Triangles) -> Mask:
    """uint8 [t]: 1 for triangles that equal an earlier one up to rotation. The opposite orientation differs."""
    rotated = compute(list_rotated_kernel, triangles.size, [triangles], vec3i, triangles.device)
    return mask_first_rows(rotated, 0)
