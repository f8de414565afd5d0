"""Mesh edits: orientation flips, and selection of triangles and vertices."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..array_types import Array1, Cells, Indices, Integers, Mask, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan, sum_counts
from ..arrays.select import gather_rows, invert_mask, positions_of
from ..lang import array, atomic_min, compute, int32, kernel, launch, tid, uint8, vec2, vec3, vec3i
from ..memory import download, empty, full, upload, zeros


@kernel
def flip_triangles_kernel(triangles: array(dtype=vec3i), flipped: array(dtype=vec3i)):
    i = tid()
    t = triangles[i]
    flipped[i] = vec3i(t[0], t[2], t[1])


@kernel
def mark_referenced_kernel(triangles: array(dtype=vec3i), used: array(dtype=int32)):
    """1 for vertices of triangles. All threads write the same value."""
    i = tid()
    t = triangles[i]
    used[t[0]] = 1
    used[t[1]] = 1
    used[t[2]] = 1


@kernel
def mark_chosen_kernel(triangles: array(dtype=vec3i), mask: array(dtype=uint8), used: array(dtype=uint8)):
    """1 for vertices of selected triangles. All threads write the same value."""
    i = tid()
    if mask[i] != 0:
        t = triangles[i]
        for k in range(3):
            used[t[k]] = uint8(1)


@kernel
def mask_complete_triangles_kernel(triangles: array(dtype=vec3i), used: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    t = triangles[i]
    mask[i] = uint8(used[t[0]] * used[t[1]] * used[t[2]])


@kernel
def gather_corners_kernel(values: array(dtype=vec2), rows: array(dtype=int32), gathered: array(dtype=vec2)):
    i = tid()
    for k in range(3):
        gathered[3 * i + k] = values[3 * rows[i] + k]


@kernel
def flip_corners_kernel(values: array(dtype=vec2), flipped: array(dtype=vec2)):
    i = tid()
    flipped[3 * i] = values[3 * i]
    flipped[3 * i + 1] = values[3 * i + 2]
    flipped[3 * i + 2] = values[3 * i + 1]


@kernel
def keep_rows_kernel(
    rows: array(dtype=vec3), used: array(dtype=int32), indices: array(dtype=int32), selected: array(dtype=vec3)
):
    i = tid()
    if used[i] == 1:
        selected[indices[i]] = rows[i]


@kernel
def renumber_triangles_kernel(
    triangles: array(dtype=vec3i), indices: array(dtype=int32), renumbered: array(dtype=vec3i)
):
    i = tid()
    t = triangles[i]
    renumbered[i] = vec3i(indices[t[0]], indices[t[1]], indices[t[2]])


@kernel
def compare_triangles_kernel(triangles: array(dtype=vec3i), others: array(dtype=vec3i), unlike: array(dtype=int32)):
    i = tid()
    t = triangles[i]
    s = others[i]
    same = t[0] == s[0] and t[1] == s[1] and t[2] == s[2]
    unlike[i] = 0 if same else 1


@kernel
def find_first_positions_kernel(rows: array(dtype=int32), first_positions: array(dtype=int32)):
    """First position of each row in a list. The minimum decides among several."""
    i = tid()
    atomic_min(first_positions, rows[i], i)


@kernel
def mark_first_positions_kernel(
    rows: array(dtype=int32), first_positions: array(dtype=int32), mask: array(dtype=uint8)
):
    i = tid()
    mask[i] = uint8(1 if first_positions[rows[i]] == i else 0)


@kernel
def mask_and_index_kernel(rows: array(dtype=int32), used: array(dtype=int32), indices: array(dtype=int32)):
    i = tid()
    used[rows[i]] = 1
    indices[rows[i]] = i


def first_listed(rows: Indices, count: int) -> Indices:
    """Distinct rows of a list in order of first occurrence."""
    first_positions, mask = full(count, rows.size, int32, rows.device), empty(rows.size, uint8, rows.device)
    launch(find_first_positions_kernel, rows.size, [rows, first_positions])
    launch(mark_first_positions_kernel, rows.size, [rows, first_positions, mask])
    return gather_rows(rows, positions_of(mask))  # sync


def repeated_positions(rows: Indices, count: int) -> Indices:
    """Positions of repeated rows in a list of all `count` rows."""
    first_positions, mask = full(count, rows.size, int32, rows.device), empty(rows.size, uint8, rows.device)
    launch(find_first_positions_kernel, rows.size, [rows, first_positions])
    launch(mark_first_positions_kernel, rows.size, [rows, first_positions, mask])
    return positions_of(invert_mask(mask), rows.size - count)


def mask_and_index(rows: Indices, count: int) -> tuple[Integers, Indices]:
    """(used, indices), int32: mask of listed vertices and their positions. The list has no duplicates."""
    used, indices = zeros(count, int32, rows.device), empty(count, int32, rows.device)
    launch(mask_and_index_kernel, rows.size, [rows, used, indices])
    return used, indices


def renumber_triangles(triangles: Triangles, indices: Integers) -> Triangles:
    return compute(renumber_triangles_kernel, triangles.size, [triangles, indices], vec3i, triangles.device)


@kernel
def shift_triangles_kernel(triangles: array(dtype=vec3i), step: int, shifted: array(dtype=vec3i)):
    i = tid()
    shifted[i] = triangles[i] + vec3i(step, step, step)


@kernel
def raise_numbers_kernel(numbers: array(dtype=int32), step: int, raised: array(dtype=int32)):
    i = tid()
    raised[i] = numbers[i] + step


def shift_triangles(triangles: Triangles, step: int) -> Triangles:
    return compute(shift_triangles_kernel, triangles.size, [triangles, step], vec3i, triangles.device)


def raise_numbers(numbers: Integers, step: int) -> Integers:
    return compute(raise_numbers_kernel, numbers.size, [numbers, step], int32, numbers.device)


def flip_triangles(triangles: Triangles) -> Triangles:
    return compute(flip_triangles_kernel, triangles.size, [triangles], vec3i, triangles.device)


def flip_corners(values: Array1[vec2]) -> Array1[vec2]:
    flipped = empty(values.size, vec2, values.device)
    launch(flip_corners_kernel, values.size // 3, [values, flipped])
    return flipped


def count_referenced(triangles: Triangles, vertex_count: int) -> int:
    """Number of vertices in use. One sync."""
    return sum_counts(mark_referenced(triangles, vertex_count))


def count_unlike(triangles: Triangles, others: Cells) -> int:
    """Number of triangles that differ from a list at least as long. One sync."""
    unlike = compute(compare_triangles_kernel, triangles.size, [triangles, others], int32, triangles.device)
    return sum_counts(unlike)


def mark_referenced(triangles: Triangles, vertex_count: int) -> Integers:
    used = zeros(vertex_count, int32, triangles.device)
    launch(mark_referenced_kernel, triangles.size, [triangles, used])
    return used


def mark_chosen(triangles: Triangles, mask: Mask, vertex_count: int) -> Mask:
    used = zeros(vertex_count, uint8, triangles.device)
    launch(mark_chosen_kernel, triangles.size, [triangles, mask, used])
    return used


def keep_vertices(triangles: Triangles, used: Integers, per_vertex: Iterable[Vectors]) -> tuple[Triangles, list[Any]]:
    """Keep used vertices (0 or 1) in order and renumber triangles, which use no others. Returns (triangles, arrays)."""
    indices, count = exclusive_scan(used, largest=1)  # sync
    return keep_counted(triangles, used, indices, count, per_vertex)


@kernel
def list_rows_kernel(used: array(dtype=int32), indices: array(dtype=int32), rows: array(dtype=int32)):
    i = tid()
    if used[i] != 0:
        rows[indices[i]] = i


def keep_counted(
    triangles: Triangles, used: Integers, indices: Integers, count: int, per_vertex: Iterable[Vectors]
) -> tuple[Triangles, list[Any]]:
    """`keep_vertices` with known count and indices. No sync."""
    device = triangles.device
    selected = []
    for rows in per_vertex:
        target = empty(count, vec3, device)
        launch(keep_rows_kernel, used.size, [rows, used, indices, target])
        selected.append(target)
    return renumber_triangles(triangles, indices), selected


def unmarked_rows(mask: Mask) -> Indices:
    """Positions, int32 ascending, where a uint8 mask is zero. One sync."""
    if mask.device.is_cuda:
        return positions_of(invert_mask(mask))  # sync
    return upload(np.flatnonzero(download(mask) == 0).astype(np.int32), int32, mask.device)


def keep_triangles(triangles: Triangles, mask: Mask) -> Triangles:
    return gather_rows(triangles, positions_of(mask))  # sync


def gather_corners(values: Array1[vec2], rows: Indices) -> Array1[vec2]:
    gathered = empty(3 * rows.size, vec2, values.device)
    launch(gather_corners_kernel, rows.size, [values, rows, gathered])
    return gathered


def complete_triangles(triangles: Triangles, used: Integers) -> Indices:
    """Rows of triangles whose vertices are all used (int32 [m] of 0 or 1)."""
    mask = compute(mask_complete_triangles_kernel, triangles.size, [triangles, used], uint8, triangles.device)
    return positions_of(mask)  # sync
