"""Vertex merging: equal positions, and the rows of merged vertices.

`owners` maps each vertex to a representative with owners[v] <= v and owners[owners[v]] == owners[v]. About 16 B per
vertex.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Indices, Integers, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_keys, positions_of
from ..arrays.union_find import mask_roots_kernel
from ..arrays.unique import UniqueKeys
from ..lang import array, compute, float64, int32, kernel, launch, length, tid, uint8, vec3, vec3d, vec3i
from ..memory import download, empty, upload


@kernel
def mark_owners_kernel(owners: array(dtype=int32), marks: array(dtype=int32)):
    i = tid()
    marks[i] = 1 if owners[i] == i else 0


@kernel
def rename_corners_kernel(
    triangles: array(dtype=vec3i), owners: array(dtype=int32), indices: array(dtype=int32), renamed: array(dtype=vec3i)
):
    i = tid()
    t = triangles[i]
    renamed[i] = vec3i(indices[owners[t[0]]], indices[owners[t[1]]], indices[owners[t[2]]])


@kernel
def average_members_kernel(rows: array(dtype=vec3), groups: UniqueKeys, unit: int, means: array(dtype=vec3)):
    """Mean row of the vertices merged into one, by index. Single vertices keep their bits. With `unit`, normalized."""
    i = tid()
    first = groups.starts[i]
    last = groups.starts[i + 1]
    mean = rows[groups.order[first]]
    if last - first > 1:
        total = vec3d(0.0, 0.0, 0.0)
        for j in range(first, last):
            total += widen(rows[groups.order[j]])
        total = total / float64(last - first)
        size = length(total)
        if unit == 1 and size > 0.0:
            total = total / size
        mean = narrow(total)
    means[i] = mean


def number_owners(owners: Indices) -> tuple[Integers, int]:
    """(indices int32 [m + 1], count): new index of each owner. One sync."""
    marks = compute(mark_owners_kernel, owners.size, [owners], int32, owners.device)
    return exclusive_scan(marks, largest=1)


def list_owners(owners: Indices, indices: Integers, count: int) -> Indices:
    """Vertices that are their own owners, int32 ascending, by the result of `number_owners`."""
    device = owners.device
    if not device.is_cuda:
        steps = download(indices)
        return upload(np.flatnonzero(steps[1:] != steps[:-1]).astype(np.int32), int32, device)
    mask = compute(mask_roots_kernel, owners.size, [owners], uint8, device)
    return positions_of(mask, count)


def rename_corners(triangles: Triangles, owners: Indices, indices: Integers) -> Triangles:
    return compute(rename_corners_kernel, triangles.size, [triangles, owners, indices], vec3i, triangles.device)


def average_members(
    arrays: Iterable[Vectors], unit: Iterable[bool], owners: Indices, indices: Integers, count: int
) -> list[Any]:
    """Mean rows (vec3 [count]) of each owner and its merged vertices; `unit` marks arrays of unit vectors."""
    device = owners.device
    groups, means = UniqueKeys(gather_keys(indices, owners), max(1, count.bit_length()), padded=True), []
    for rows, is_unit in zip(arrays, unit, strict=True):
        means.append(empty(count, vec3, device))
        launch(average_members_kernel, count, [rows, groups, int(is_unit), means[-1]])
    return means
