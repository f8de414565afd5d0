"""Vertex clustering on a voxel grid.

Rossignac and Borrel, "Multi-resolution 3D approximations for rendering complex scenes", 1993, with the mean of a
voxel's vertices; or Lindstrom, "Out-of-core simplification of large polygonal models", 2000, with the point closest to
the planes of their triangles. Sums in vertex order. About 150 B per triangle.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Integers, Points, Triangles, Vectors
from ..arrays.bounds import bound_points
from ..arrays.prefix_sum import offsets_of
from ..arrays.select import positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    cross,
    float64,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, full, zeros
from ..meshes.mesh_edits import keep_triangles
from ..meshes.mesh_topology import CornersByVertex, corner_vertex, last_corner, next_corner
from ..meshes.triangle_order import list_first_keys_kernel
from ..sampling.voxel_keys import VoxelGroups
from .quadrics import minimum_point, plane_quadric, quadric
from .unit_frame import UnitFrame

MEAN_WEIGHT = 1e-3  # prior weight of a voxel's mean relative to its planes: less leaves a line or a plane undetermined


@struct
class VertexClusters:
    """Vertices by voxel, voxels numbered by first vertex. `order` are finite vertices by voxel, delimited by `starts`
    and `stops`; `labels` is the voxel of each vertex, -1 if not finite."""

    order: array(dtype=int32)
    starts: array(dtype=int32)
    stops: array(dtype=int32)
    labels: array(dtype=int32)

    def __init__(self, vertices: Points, voxel_size: float) -> None:
        """Sort by voxels from half a voxel below the box. Raises ValueError if the grid needs more than 62 bits."""
        device = vertices.device
        self.box = bound_points(vertices)  # sync
        low, high, finite = self.box
        low, high = (low.astype(np.float64), high.astype(np.float64)) if finite else (np.zeros(3), np.zeros(3))
        corner = low - 0.5 * voxel_size
        with np.errstate(over="ignore"):  # more voxels than a float can count: rejected below
            cells = np.floor((high - corner) / voxel_size) + 1
        groups = VoxelGroups(vertices, corner, voxel_size, cells)  # sync
        self.order, self.count = groups.order, groups.count
        firsts = zeros(vertices.size, int32, device)
        launch(mark_first_vertices_kernel, self.count, [groups.order, groups.starts, firsts])
        ranks = offsets_of(firsts)
        self.starts, self.stops = empty(self.count, int32, device), empty(self.count, int32, device)
        self.labels = full(vertices.size, -1, int32, device)
        arguments = [groups.order, groups.starts, ranks, self.starts, self.stops, self.labels]
        launch(rank_clusters_kernel, self.count, arguments)


@kernel
def mark_first_vertices_kernel(order: array(dtype=int32), starts: array(dtype=int32), firsts: array(dtype=int32)):
    i = tid()
    firsts[order[starts[i]]] = 1


@kernel
def rank_clusters_kernel(
    order: array(dtype=int32),
    starts: array(dtype=int32),
    ranks: array(dtype=int32),
    first: array(dtype=int32),
    last: array(dtype=int32),
    labels: array(dtype=int32),
):
    i = tid()
    rank = ranks[order[starts[i]]]
    first[rank] = starts[i]
    last[rank] = starts[i + 1]
    for j in range(starts[i], starts[i + 1]):
        labels[order[j]] = rank


@kernel
def average_clusters_kernel(clusters: VertexClusters, unit: int, rows: array(dtype=vec3), means: array(dtype=vec3)):
    """Mean of the finite rows of each voxel; normalized if `unit` is 1."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    count = float64(0.0)
    for j in range(clusters.starts[i], clusters.stops[i]):
        row = rows[clusters.order[j]]
        if isfinite(row):
            total += widen(row)
            count += 1.0
    mean = total / count
    size = length(mean)
    if unit == 1 and size > 0.0:
        mean = mean / size
    means[i] = narrow(mean)


@kernel
def fit_clusters_kernel(
    clusters: VertexClusters,
    positions: array(dtype=vec3d),
    triangles: array(dtype=vec3i),
    around: CornersByVertex,
    max_distance: float64,
    points: array(dtype=vec3d),
):
    """Point of each voxel closest to the planes of its triangles, or the mean if farther away than `max_distance`."""
    i = tid()
    mean = vec3d(0.0, 0.0, 0.0)
    for j in range(clusters.starts[i], clusters.stops[i]):
        mean = mean + positions[clusters.order[j]]
    mean = mean / float64(clusters.stops[i] - clusters.starts[i])
    q = quadric(0.0)
    for j in range(clusters.starts[i], clusters.stops[i]):
        v = clusters.order[j]
        p = positions[v]
        for k in range(around.starts[v], around.starts[v + 1]):
            c = around.corners[k]
            b = positions[corner_vertex(triangles, next_corner(c))]
            n = cross(b - p, positions[corner_vertex(triangles, last_corner(c))] - p)
            size = length(n)
            if size > 0.0 and isfinite(size):
                q += plane_quadric(n / size, p - mean, size * 0.5)
    x = minimum_point(q, vec3d(0.0, 0.0, 0.0), float64(MEAN_WEIGHT))
    if not (length(x) <= max_distance):
        x = vec3d(0.0, 0.0, 0.0)
    points[i] = mean + x


@kernel
def relabel_triangles_kernel(
    triangles: array(dtype=vec3i), labels: array(dtype=int32), relabeled: array(dtype=vec3i), mask: array(dtype=uint8)
):
    """Triangles by voxel, the lowest first, and 1 for those with three distinct voxels."""
    i = tid()
    t = triangles[i]
    a = labels[t[0]]
    b = labels[t[1]]
    c = labels[t[2]]
    rotated = vec3i(a, b, c)
    if b < a and b < c:
        rotated = vec3i(b, c, a)
    elif c < a and c < b:
        rotated = vec3i(c, a, b)
    valid = 0
    if rotated[0] >= 0 and a != b and b != c and c != a:
        valid = 1
    relabeled[i] = rotated
    mask[i] = uint8(valid)


@kernel
def list_triple_keys_kernel(
    pairs: UniqueKeys, triangles: array(dtype=vec3i), rows: array(dtype=int32), bits: int, keys: array(dtype=int64)
):
    i = tid()
    for j in range(pairs.starts[i], pairs.starts[i + 1]):
        k = pairs.order[j]
        keys[k] = (int64(i) << int64(bits)) | int64(triangles[rows[k]][2])


@kernel
def mark_first_rows_kernel(groups: UniqueKeys, rows: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    if groups.starts[i + 1] > groups.starts[i]:
        mask[rows[groups.order[groups.starts[i]]]] = 1


def join_triangles(triangles: Triangles, labels: Integers, count: int) -> Triangles:
    """Distinct triangles between three of `count` voxels in order of first appearance, vec3i, lowest vertex first.
    Opposite orientations differ. Two syncs."""
    device, bits = triangles.device, max(1, count.bit_length())
    relabeled, mask = empty(triangles.size, vec3i, device), empty(triangles.size, uint8, device)
    launch(relabel_triangles_kernel, triangles.size, [triangles, labels, relabeled, mask])
    rows = positions_of(mask)  # sync
    keys = compute(list_first_keys_kernel, rows.size, [relabeled, rows, bits], int64, device)
    pairs = UniqueKeys(keys, 2 * bits, padded=True)
    launch(list_triple_keys_kernel, pairs.count, [pairs, relabeled, rows, bits, keys])
    groups = UniqueKeys(keys, bits + max(1, pairs.count.bit_length()), padded=True)
    mask = zeros(triangles.size, uint8, device)
    launch(mark_first_rows_kernel, groups.count, [groups, rows, mask])
    return keep_triangles(relabeled, mask)  # sync


def cluster_vertices(
    triangles: Triangles, per_vertex: Sequence[Vectors], unit: Sequence[bool], voxel_size: float, with_planes: bool
) -> tuple[Triangles, list[Any]]:
    """Merge the vertices of each voxel, to their mean or (`with_planes`) the point closest to the triangle planes.
    `per_vertex` are vec3 [m] arrays, vertices first; `unit` marks unit vectors. Returns (triangles, arrays). Raises
    ValueError if the grid needs more than 62 bits."""
    vertices, device = per_vertex[0], triangles.device
    clusters = VertexClusters(vertices, voxel_size)
    joined = join_triangles(triangles, clusters.labels, clusters.count)
    arrays = []
    for rows, is_unit in zip(per_vertex, [False, *unit], strict=True):
        means = compute(average_clusters_kernel, clusters.count, [clusters, int(is_unit), rows], vec3, device)
        arrays.append(means)
    if with_planes:
        frame = UnitFrame(vertices, clusters.box)
        points = empty(clusters.count, vec3d, device)
        around = CornersByVertex(triangles, vertices.size)
        arguments = [clusters, frame.scaled(vertices), triangles, around, voxel_size * frame.scale, points]
        launch(fit_clusters_kernel, clusters.count, arguments)
        arrays[0] = frame.unscaled(points)
    return joined, arrays
