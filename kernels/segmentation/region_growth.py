"""Smooth regions: points joined to their neighbours where normals agree, through points of small curvature.

Rabbani, van den Heuvel and Vosselman 2006, as PCL's RegionGrowing has it: a region grows from a point of small
curvature to each of its nearest neighbours whose normal is within an angle of its own, and on from those of small
curvature. So regions are the connected components of the points of small curvature over such edges, whichever way the
list of neighbours names them: disjoint sets (union_find.py). Each other point joins the region of the neighbour of
small curvature whose normal is nearest to its own, of equals the first listed. 4 B a neighbour are read twice, and 12
B a point written.
"""

from ..array_types import Array2, Integers, Scalars, Vectors
from ..arrays.select import number_rows_kernel, positions_of
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import array, dot, float32, int32, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import empty, full
from .cluster_labels import NOISE, rank_by_size


@kernel
def begin_sets_kernel(
    normals: array(dtype=vec3), curvature: array(dtype=float32), limit: float, parents: array(dtype=int32)
):
    """Each point of small curvature is a set of its own, the others are of none."""
    i = tid()
    n = normals[i]
    parents[i] = NOISE
    if isfinite(n) and dot(n, n) > 0.0 and curvature[i] < limit:  # NaN is not less
        parents[i] = i


@kernel
def join_neighbors_kernel(
    normals: array(dtype=vec3), neighbors: array(dtype=int32, ndim=2), cosine: float, parents: array(dtype=int32)
):
    """Unite the sets of neighbours whose normals agree; the sets are the same in any order."""
    i = tid()
    if parents[i] >= 0:
        for k in range(neighbors.shape[1]):
            j = neighbors[i, k]
            if j >= 0 and j != i:
                if parents[j] >= 0 and abs(dot(normals[i], normals[j])) >= cosine:
                    unite(parents, i, j)


@kernel
def mark_roots_kernel(parents: array(dtype=int32), marks: array(dtype=uint8)):
    """1 at the first point of each set."""
    i = tid()
    marks[i] = uint8(1 if parents[i] == i else 0)


@kernel
def label_regions_kernel(
    normals: array(dtype=vec3),
    neighbors: array(dtype=int32, ndim=2),
    cosine: float,
    parents: array(dtype=int32),
    numbers: array(dtype=int32),
    labels: array(dtype=int32),
):
    """The number of each point's set, or of the neighbour's that agrees best."""
    i = tid()
    label = int(NOISE)
    if parents[i] >= 0:
        label = numbers[parents[i]]
    elif isfinite(normals[i]):
        best = cosine * 1.0
        for k in range(neighbors.shape[1]):
            j = neighbors[i, k]
            if j >= 0 and j != i:
                facing = abs(dot(normals[i], normals[j]))
                if parents[j] >= 0 and facing >= best and (label < 0 or facing > best):
                    best = facing
                    label = numbers[parents[j]]
    labels[i] = label


def grow_regions(
    normals: Vectors, curvature: Scalars, neighbors: Array2[int32], cosine: float, limit: float, least: int, most: int
) -> tuple[Integers, int]:
    """Labels of smooth regions, the largest first, ties by their first point; the number before sizes are looked at.

    Args:
        normals: Unit normals.
        curvature: Surface variation of each point.
        neighbors: The nearest neighbours of each point, -1 where there are fewer.
        cosine: Of the largest angle between neighbours' normals, whichever way they face.
        limit: Curvature below which a region grows on from a point.
        least, most: Points of a region.
    """
    count, device = normals.size, normals.device
    parents, labels = empty(count, int32, device), full(count, NOISE, int32, device)
    launch(begin_sets_kernel, count, [normals, curvature, limit, parents])
    launch(join_neighbors_kernel, count, [normals, neighbors, cosine, parents])
    launch(flatten_sets_kernel, count, [parents])
    marks, numbers = empty(count, uint8, device), full(count, NOISE, int32, device)
    launch(mark_roots_kernel, count, [parents, marks])
    heads = positions_of(marks)  # sync
    if not heads.size:
        return labels, 0
    launch(number_rows_kernel, heads.size, [heads, numbers])
    launch(label_regions_kernel, count, [normals, neighbors, cosine, parents, numbers, labels])
    rank_by_size(labels, heads.size, least, most)
    return labels, heads.size
