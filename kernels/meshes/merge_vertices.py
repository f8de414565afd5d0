"""Vertices made one: those at the same position, and the rows of those that follow another.

Which vertex each one follows is an int32 array `owners` with owners[v] <= v and owners[owners[v]] == owners[v]. The
owners stay, in their order; triangles name them. About 16 B a vertex beside the sort.
"""

from collections.abc import Iterable
from typing import Any

from ..algebra.transform import narrow, widen
from ..array_types import Indices, Integers, Mask, Points, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.sort import argsort_keys, positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import array, float64, int32, int64, kernel, launch, length, tid, uint8, vec3, vec3d, vec3i
from ..memory import empty
from ..sampling.duplicates import WORD_BITS, hash_points_kernel, is_nan, same_point


@kernel
def unite_equal_kernel(
    points: array(dtype=vec3), keys: array(dtype=int64), order: array(dtype=int32), parents: array(dtype=int32)
):
    """Make one set of a point and the one before it with the same coordinates; one with a NaN equals none."""
    i = tid()
    p = points[order[i]]
    j = i - 1
    if is_nan(p) == 1:
        j = -1
    while j >= 0 and keys[max(j, 0)] == keys[i]:
        if same_point(p, points[order[j]]) == 1:
            unite(parents, order[i], order[j])
            j = 0
        j -= 1


@kernel
def mark_owners_kernel(owners: array(dtype=int32), marks: array(dtype=int32)):
    """1 for the vertices that follow none but themselves."""
    i = tid()
    marks[i] = 1 if owners[i] == i else 0


@kernel
def mask_owners_kernel(owners: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for the vertices that follow none but themselves."""
    i = tid()
    mask[i] = uint8(1 if owners[i] == i else 0)


@kernel
def rename_corners_kernel(
    triangles: array(dtype=vec3i), owners: array(dtype=int32), places: array(dtype=int32), renamed: array(dtype=vec3i)
):
    """Triangles by the new numbers of the vertices that theirs follow."""
    i = tid()
    t = triangles[i]
    renamed[i] = vec3i(places[owners[t[0]]], places[owners[t[1]]], places[owners[t[2]]])


@kernel
def list_owner_places_kernel(owners: array(dtype=int32), places: array(dtype=int32), keys: array(dtype=int64)):
    """The new number of the vertex that each one follows."""
    i = tid()
    keys[i] = int64(places[owners[i]])


@kernel
def average_members_kernel(rows: array(dtype=vec3), groups: UniqueKeys, unit: int, means: array(dtype=vec3)):
    """The mean of the rows of those that follow one vertex, summed by their numbers; a vertex alone keeps its bits.

    With `unit` the mean is brought to unit length where it has one.
    """
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


def find_equal_vertices(vertices: Points) -> Indices:
    """The first vertex at the position of each, int32 [m]; those with a NaN follow themselves."""
    device, count = vertices.device, vertices.size
    bits = WORD_BITS - max(1, (count - 1).bit_length())
    keys, owners = empty(count, int64, device), positions(count, device)
    launch(hash_points_kernel, count, [vertices, bits, keys])
    keys, order = argsort_keys(keys, bits)
    launch(unite_equal_kernel, count, [vertices, keys, order, owners])
    launch(flatten_sets_kernel, count, [owners])
    return owners


def number_owners(owners: Indices) -> tuple[Integers, int]:
    """(places int32 [m + 1], count): the new number of each owner; one sync."""
    marks = empty(owners.size, int32, owners.device)
    launch(mark_owners_kernel, owners.size, [owners, marks])
    return exclusive_scan(marks)


def mask_owners(owners: Indices) -> Mask:
    """uint8 [m]: 1 for the vertices that stay."""
    mask = empty(owners.size, uint8, owners.device)
    launch(mask_owners_kernel, owners.size, [owners, mask])
    return mask


def rename_corners(triangles: Triangles, owners: Indices, places: Integers) -> Triangles:
    """The triangles of the vertices that theirs follow, by their new numbers."""
    renamed = empty(triangles.size, vec3i, triangles.device)
    launch(rename_corners_kernel, triangles.size, [triangles, owners, places, renamed])
    return renamed


def average_members(
    arrays: Iterable[Vectors], unit: Iterable[bool], owners: Indices, places: Integers, count: int
) -> list[Any]:
    """The mean rows of each owner and those that follow it.

    Args:
        arrays: vec3 [m] device arrays.
        unit: For each of them whether its rows have unit length.
        owners: int32 [m].
        places: The new numbers of owners.
        count: Owners.

    Returns:
        vec3 [count] arrays.
    """
    device = owners.device
    keys = empty(owners.size, int64, device)
    launch(list_owner_places_kernel, owners.size, [owners, places, keys])
    groups, means = UniqueKeys(keys, max(1, count.bit_length()), padded=True), []
    for rows, is_unit in zip(arrays, unit, strict=True):
        means.append(empty(count, vec3, device))
        launch(average_members_kernel, count, [rows, groups, int(is_unit), means[-1]])
    return means
