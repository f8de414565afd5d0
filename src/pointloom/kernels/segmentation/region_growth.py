"""Smooth regions: points connected to neighbors with similar normals through points of low curvature.

Rabbani, van den Heuvel and Vosselman 2006, as PCL's RegionGrowing. Regions are connected components of low-curvature
points (union_find.py). Other points join the low-curvature neighbor with the most similar normal, the first on a tie.
"""

from ..array_types import Array2, Integers, Scalars, Vectors
from ..arrays.select import number_rows_kernel, positions_of
from ..arrays.union_find import flatten_sets_kernel, mask_roots_kernel, unite
from ..lang import array, dot, float32, int32, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import empty, full
from .cluster_labels import NOISE_LABEL, rank_by_size


@kernel
def begin_sets_kernel(
    normals: array(dtype=vec3), curvature: array(dtype=float32), limit: float, parents: array(dtype=int32)
):
    """Low-curvature points start as sets of their own, others without a set."""
    i = tid()
    n = normals[i]
    parents[i] = NOISE_LABEL
    if isfinite(n) and dot(n, n) > 0.0 and curvature[i] < limit:  # NaN is not less
        parents[i] = i


@kernel
def join_neighbors_kernel(
    normals: array(dtype=vec3), neighbors: array(dtype=int32, ndim=2), cosine: float, parents: array(dtype=int32)
):
    """Unite neighbors with similar normals. The sets do not depend on the order."""
    i = tid()
    if parents[i] >= 0:
        for k in range(neighbors.shape[1]):
            j = neighbors[i, k]
            if j >= 0 and j != i:
                if parents[j] >= 0 and abs(dot(normals[i], normals[j])) >= cosine:
                    unite(parents, i, j)


@kernel
def label_regions_kernel(
    normals: array(dtype=vec3),
    neighbors: array(dtype=int32, ndim=2),
    cosine: float,
    parents: array(dtype=int32),
    numbers: array(dtype=int32),
    labels: array(dtype=int32),
):
    """Number of each point's set, or of the neighbor with the most similar normal."""
    i = tid()
    label = int(NOISE_LABEL)
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
    normals: Vectors,
    curvature: Scalars,
    neighbors: Array2[int32],
    cosine: float,
    limit: float,
    min_size: int,
    max_size: int,
) -> tuple[Integers, int]:
    """Labels of smooth regions by decreasing size, and their number before the size limits. `cosine`: minimum between
    unsigned normals, `limit`: maximum curvature to grow from."""
    count, device = normals.size, normals.device
    parents, labels = empty(count, int32, device), full(count, NOISE_LABEL, int32, device)
    launch(begin_sets_kernel, count, [normals, curvature, limit, parents])
    launch(join_neighbors_kernel, count, [normals, neighbors, cosine, parents])
    launch(flatten_sets_kernel, count, [parents])
    marks, numbers = empty(count, uint8, device), full(count, NOISE_LABEL, int32, device)
    launch(mask_roots_kernel, count, [parents, marks])
    heads = positions_of(marks)  # sync
    if not heads.size:
        return labels, 0
    launch(number_rows_kernel, heads.size, [heads, numbers])
    launch(label_regions_kernel, count, [normals, neighbors, cosine, parents, numbers, labels])
    rank_by_size(labels, heads.size, min_size, max_size)
    return labels, heads.size
