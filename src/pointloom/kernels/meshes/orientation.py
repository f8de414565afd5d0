"""Consistent triangle orientation by disjoint sets over original and flipped triangles.

2 t is triangle t, 2 t + 1 its flipped form. Consistent neighbors unite equal forms, others opposite ones. A component
with both forms in one set is not orientable. Set roots are minimal, so the result does not depend on the thread order.
Edges with more than two triangles are ignored. About 30 B per half-edge.
"""

from typing import NamedTuple

import numpy as np

from ..algebra.transform import widen
from ..array_types import Array1, Bytes, LongIntegers, Points, Triangles, Vectors
from ..arrays.side_by_side import read_together
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    atomic_max,
    compute,
    dot,
    float64,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    tid,
    uint8,
    vec2,
    vec3,
    vec3i,
)
from ..memory import download, empty, upload, zeros
from .mesh_components import PartOrder, number_parts
from .mesh_edges import find_edges, higher_end, key_bits, lower_end
from .mesh_edits import mark_chosen
from .mesh_measures import triangle_cross, vertex_normals
from .mesh_topology import corner_vertex
from .part_votes import follow_majority


@kernel
def unite_forms_kernel(
    triangles: array(dtype=vec3i),
    edges: UniqueKeys,
    bits: int,
    parents: array(dtype=int32),
    is_open: array(dtype=int32),
):
    """Unite forms across edges with two triangles. Mark triangles at other edges. All threads write the same value."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    paired = 0
    if last - first == 2:
        key = edges.keys[i]
        h = edges.order[first]
        g = edges.order[first + 1]
        t = h // 3
        u = g // 3
        if t != u and lower_end(key, bits) != higher_end(key, bits):
            paired = 1
            against = 0
            if corner_vertex(triangles, h) == corner_vertex(triangles, g):
                against = 1
            unite(parents, 2 * t, 2 * u + against)
            unite(parents, 2 * t + 1, 2 * u + 1 - against)
    if paired == 0:
        for j in range(first, last):
            is_open[edges.order[j] // 3] = 1


@kernel
def read_forms_kernel(
    parents: array(dtype=int32),
    firsts: array(dtype=int32),
    flips: array(dtype=uint8),
    is_open: array(dtype=int32),
    twisted: array(dtype=int32),
):
    """First triangle of each component, and whether to flip. Non-orientable ones count as open (same value written)."""
    i = tid()
    root = parents[2 * i]
    flip = root % 2
    if root == parents[2 * i + 1]:
        atomic_max(twisted, 0, 1)
        is_open[i] = 1
        flip = 0
    firsts[i] = root // 2
    flips[i] = uint8(flip)


@kernel
def measure_oriented_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    firsts: array(dtype=int32),
    flips: array(dtype=uint8),
    volumes: array(dtype=float64),
):
    """Six times the volume between each oriented triangle and the first vertex of its component. 0 if not finite."""
    i = tid()
    t = triangles[i]
    tip = triangles[firsts[i]]
    volume = dot(triangle_cross(vertices, t), widen(vertices[t[0]]) - widen(vertices[tip[0]]))
    if not isfinite(volume):
        volume = 0.0
    if flips[i] == 1:
        volume = -volume
    volumes[i] = volume


@kernel
def mark_open_parts_kernel(is_open: array(dtype=int32), labels: array(dtype=int64), open_parts: array(dtype=int32)):
    """1 for components with an edge of other than two triangles. All threads write the same value."""
    i = tid()
    if is_open[i] == 1:
        open_parts[int(labels[i])] = 1


@kernel
def flip_parts_kernel(labels: array(dtype=int64), chosen_parts: array(dtype=uint8), flips: array(dtype=uint8)):
    i = tid()
    if chosen_parts[int(labels[i])] == 1:
        flips[i] = uint8(1 - int(flips[i]))


@kernel
def flip_some_triangles_kernel(triangles: array(dtype=vec3i), flips: array(dtype=uint8), flipped: array(dtype=vec3i)):
    i = tid()
    t = triangles[i]
    if flips[i] == 1:
        t = vec3i(t[0], t[2], t[1])
    flipped[i] = t


@kernel
def flip_some_corners_kernel(values: array(dtype=vec2), flips: array(dtype=uint8), flipped: array(dtype=vec2)):
    i = tid()
    other = int(flips[i])
    flipped[3 * i] = values[3 * i]
    flipped[3 * i + 1] = values[3 * i + 1 + other]
    flipped[3 * i + 2] = values[3 * i + 2 - other]


@kernel
def flip_some_normals_kernel(
    normals: array(dtype=vec3), used: array(dtype=uint8), directions: array(dtype=vec3), flipped: array(dtype=vec3)
):
    """Flip the normals of used vertices to the side of the surface's direction."""
    i = tid()
    normal = normals[i]
    if used[i] != 0 and dot(normal, directions[i]) < 0.0:
        normal = -normal
    flipped[i] = normal


class Orientation:
    """Triangles to flip for consistent orientation: `flips` uint8 [t], `orientable` if all components are. The first
    triangle of each component stays, and non-orientable components stay."""

    def __init__(self, triangles: Triangles, vertex_count: int) -> None:
        device, count = triangles.device, triangles.size
        edges, parents = find_edges(triangles, vertex_count, padded=True), positions(2 * count, device)
        self._is_open = zeros(count, int32, device)
        launch(unite_forms_kernel, edges.count, [triangles, edges, key_bits(vertex_count), parents, self._is_open])
        launch(flatten_sets_kernel, parents.size, [parents])
        self._firsts, self.flips = empty(count, int32, device), empty(count, uint8, device)
        twisted = zeros(1, int32, device)
        launch(read_forms_kernel, count, [parents, self._firsts, self.flips, self._is_open, twisted])
        self.orientable = not download(twisted)[0]  # sync

    def face_outwards(self, vertices: Points, triangles: Triangles) -> None:
        """Flip closed components whose volume is negative."""
        parts = self.measure_parts(vertices, triangles)
        self.flip_parts(parts.labels, (parts.volumes < 0) & parts.closed)

    def measure_parts(self, vertices: Points, triangles: Triangles) -> "OrientedParts":
        """Components and the volumes that they enclose after flipping."""
        device, count = triangles.device, triangles.size
        labels, part_count = number_parts(self._firsts)  # sync
        volumes, open_parts = empty(count, float64, device), zeros(part_count, int32, device)
        launch(measure_oriented_kernel, count, [vertices, triangles, self._firsts, self.flips, volumes])
        launch(mark_open_parts_kernel, count, [self._is_open, labels, open_parts])
        parts = PartOrder(labels, part_count)
        counts = parts.counts()  # sync
        sums, is_open = read_together([parts.sum(volumes, counts), open_parts])  # sync
        return OrientedParts(labels, counts, sums / 6, is_open == 0)

    def flip_parts(self, labels: LongIntegers, chosen_parts: np.ndarray) -> None:
        """Flip all triangles of selected components: labels int64 [t], bool NumPy per component."""
        device = self.flips.device
        launch(flip_parts_kernel, self.flips.size, [labels, upload(chosen_parts, uint8, device), self.flips])

    def follow_majority(self) -> None:
        """Flip components so that most triangles keep their orientation. On a tie, the first one does."""
        follow_majority(self._firsts, self.flips)


class OrientedParts(NamedTuple):
    """Components connected by edges of two triangles: `labels` int64 [t]. NumPy [p] `counts`, signed `volumes`, and
    `closed` (no boundary and orientable)."""

    labels: LongIntegers
    counts: np.ndarray
    volumes: np.ndarray
    closed: np.ndarray


def flip_some(triangles: Triangles, flips: Bytes) -> Triangles:
    return compute(flip_some_triangles_kernel, triangles.size, [triangles, flips], vec3i, triangles.device)


def flip_some_corners(values: Array1[vec2], flips: Bytes) -> Array1[vec2]:
    flipped = empty(values.size, vec2, values.device)
    launch(flip_some_corners_kernel, flips.size, [values, flips, flipped])
    return flipped


def flip_some_normals(normals: Vectors, vertices: Points, triangles: Triangles, flips: Bytes) -> Vectors:
    """Vertex normals after `flip_some`: those of the flipped triangles are on the side of the new `triangles`."""
    used = mark_chosen(triangles, flips, normals.size)
    directions = vertex_normals(vertices, triangles)
    return compute(flip_some_normals_kernel, normals.size, [normals, used, directions], vec3, normals.device)
