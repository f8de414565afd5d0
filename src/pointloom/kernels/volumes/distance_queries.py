"""Distances, gradients and nearest obstacles at points; collision queries of spheres and bodies.

Up to 8 hash lookups per query, in float64. The free distance at a point is that to the nearest occupied voxel center
minus its offset from the voxel center and half a voxel diagonal (Oleynikova et al., "Voxblox", IROS 2017, uses the
first term alone), so collisions are never missed.
"""

from typing import Any, NamedTuple

import numpy as np

from ..algebra.transform import narrow
from ..array_types import Array2, Device, Doubles, Integers, Mask, Poses, Positions, Scalars
from ..arrays.hash_table import HashTable
from ..lang import (
    INFINITY,
    NAN,
    array,
    compute,
    float32,
    float64,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    mat44d,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
    vec4d,
)
from ..memory import empty
from .distance_blocks import DistanceBlocks, find_voxel
from .distance_sweeps import NO_SEED

MAX_QUERY_VOXELS = 8.0e6  # voxels from the origin: no block is farther
HALF_DIAGONAL = 0.8660254037844387  # of a voxel [voxels]


@struct
class DistanceGrid:
    """Distance blocks with an origin and voxel size [m]. `beyond` is the distance reported for unknown voxels (inf if
    all are known), `outside` that reported without a block (NaN if unknown)."""

    table: HashTable
    sqdists: array(dtype=int32)
    nearest: array(dtype=int32)
    occupied: array(dtype=vec3i)
    origin: vec3d
    voxel_size: float64
    beyond: float64
    outside: float64

    def __init__(self, blocks: DistanceBlocks, origin: Any, voxel_size: float, max_distance: float | None) -> None:
        self.table, self.sqdists, self.nearest = blocks.table, blocks.sqdists, blocks.nearest
        self.occupied, self.origin, self.voxel_size = blocks.occupied, vec3d(*origin), voxel_size
        self.beyond = INFINITY if max_distance is None else max_distance
        self.outside = NAN if max_distance is None else max_distance
        self.device: Device = blocks.device


class KnownDistances(NamedTuple):
    """Distances float32 [m], and uint8 1 if they are known."""

    distances: Scalars
    known: Mask


@func
def grid_position(p: vec3d, grid: DistanceGrid) -> vec3d:
    return (p - grid.origin) / grid.voxel_size


@func
def is_inner(q: vec3d) -> int:
    """1 if a position is finite and in the range of blocks."""
    inner = 0
    if abs(q[0]) < MAX_QUERY_VOXELS and abs(q[1]) < MAX_QUERY_VOXELS and abs(q[2]) < MAX_QUERY_VOXELS:
        inner = 1
    return inner


@func
def cell_at(q: vec3d) -> vec3i:
    return vec3i(int(floor(q[0])), int(floor(q[1])), int(floor(q[2])))


@func
def voxel_at(q: vec3d, grid: DistanceGrid) -> int:
    """Index of the voxel of a position, or -1."""
    voxel = -1
    if is_inner(q) == 1:
        voxel = find_voxel(cell_at(q), grid.table)
    return voxel


@func
def cell_center(cell: vec3i) -> vec3d:
    return vec3d(float64(cell[0]) + 0.5, float64(cell[1]) + 0.5, float64(cell[2]) + 0.5)


@func
def is_known(voxel: int, grid: DistanceGrid) -> int:
    known = 0
    if voxel >= 0:
        if abs(grid.sqdists[voxel]) != NO_SEED:
            known = 1
    return known


@func
def distance_at(voxel: int, grid: DistanceGrid) -> float64:
    d = grid.outside
    if voxel >= 0:
        sqdist = grid.sqdists[voxel]
        d = grid.beyond
        if abs(sqdist) != NO_SEED:
            d = sqrt(float64(abs(sqdist))) * grid.voxel_size
        if sqdist < 0:
            d = -d
    return d


@func
def interpolate(q: vec3d, grid: DistanceGrid) -> float64:
    """Trilinear distance [m] at a position. NaN if one of the eight voxels is unknown."""
    base = vec3d(floor(q[0] - 0.5), floor(q[1] - 0.5), floor(q[2] - 0.5))
    t = vec3d(q[0] - 0.5 - base[0], q[1] - 0.5 - base[1], q[2] - 0.5 - base[2])
    low = cell_at(base)
    known = 1
    value = float64(0.0)
    n = int(8)
    for k in range(n):
        if known == 1:
            x = k // 4
            y = (k // 2) % 2
            z = k % 2
            voxel = find_voxel(vec3i(low[0] + x, low[1] + y, low[2] + z), grid.table)
            known = is_known(voxel, grid)
            if known == 1:
                u = float64(x) * t[0] + float64(1 - x) * (1.0 - t[0])
                v = float64(y) * t[1] + float64(1 - y) * (1.0 - t[1])
                w = float64(z) * t[2] + float64(1 - z) * (1.0 - t[2])
                value += u * v * w * distance_at(voxel, grid)
    if known == 0:
        value = float64(NAN)
    return value


@func
def slope_along(q: vec3d, step: vec3d, grid: DistanceGrid) -> float64:
    """Slope of the distance over one voxel along a step."""
    return (interpolate(q + step, grid) - interpolate(q - step, grid)) / grid.voxel_size


@func
def clearance_at(p: vec3d, grid: DistanceGrid) -> float64:
    """Free distance that is certain around a point [m]; -inf if unknown."""
    q = grid_position(p, grid)
    voxel = voxel_at(q, grid)
    corner = float64(HALF_DIAGONAL)
    apart = float64(HALF_DIAGONAL)
    if is_inner(q) == 1:
        apart = length(q - cell_center(cell_at(q)))
    room = distance_at(voxel, grid) - (apart + corner) * grid.voxel_size
    if not isfinite(p):
        room = -float64(INFINITY)
    if voxel < 0 and not isfinite(grid.outside):
        room = -float64(INFINITY)
    return room


@kernel
def find_distances_kernel(
    points: array(dtype=vec3d),
    between: int,
    grid: DistanceGrid,
    distances: array(dtype=float32),
    known: array(dtype=uint8),
):
    """Distance of each point's voxel, or interpolated with `between` if all around it are known."""
    i = tid()
    p = points[i]
    q = grid_position(p, grid)
    voxel = voxel_at(q, grid)
    d = distance_at(voxel, grid)
    if between == 1 and is_inner(q) == 1:
        exact = interpolate(q, grid)
        if isfinite(exact):
            d = exact
    if not isfinite(p):
        d = float64(NAN)
    distances[i] = float(d)
    known[i] = uint8(is_known(voxel, grid))


@kernel
def find_gradients_kernel(points: array(dtype=vec3d), grid: DistanceGrid, gradients: array(dtype=vec3)):
    """Gradient at each point. NaN if a voxel around it is unknown."""
    i = tid()
    q = grid_position(points[i], grid)
    g = vec3d(NAN, NAN, NAN)
    if is_inner(q) == 1:
        x = slope_along(q, vec3d(0.5, 0.0, 0.0), grid)
        y = slope_along(q, vec3d(0.0, 0.5, 0.0), grid)
        z = slope_along(q, vec3d(0.0, 0.0, 0.5), grid)
        g = vec3d(x, y, z)
    if not isfinite(g):
        g = vec3d(NAN, NAN, NAN)
    gradients[i] = narrow(g)


@kernel
def find_obstacles_kernel(
    points: array(dtype=vec3d),
    grid: DistanceGrid,
    rows: array(dtype=int32),
    positions: array(dtype=vec3d),
    distances: array(dtype=float32),
):
    """Nearest occupied voxel to each point's voxel: row, center, and distance of the point from it."""
    i = tid()
    p = points[i]
    voxel = voxel_at(grid_position(p, grid), grid)
    row = -1
    position = vec3d(NAN, NAN, NAN)
    d = float64(NAN)
    if isfinite(p):
        d = distance_at(voxel, grid)
    if voxel >= 0:
        if grid.sqdists[voxel] != NO_SEED:
            row = grid.nearest[voxel]
            position = cell_center(grid.occupied[row]) * grid.voxel_size + grid.origin
            d = length(p - position)
    rows[i] = row
    positions[i] = position
    distances[i] = float(d)


@kernel
def find_hits_kernel(
    centers: array(dtype=vec3d), radii: array(dtype=float64), grid: DistanceGrid, hits: array(dtype=uint8)
):
    i = tid()
    hit = 1
    if clearance_at(centers[i], grid) > radii[i % radii.shape[0]]:
        hit = 0
    hits[i] = uint8(hit)


@kernel
def find_body_clearance_kernel(
    spheres: array(dtype=float64, ndim=2),
    poses: array(dtype=mat44d),
    grid: DistanceGrid,
    clearances: array(dtype=float64),
):
    i = tid()
    T = poses[i]
    min_clearance = float64(INFINITY)
    for k in range(spheres.shape[0]):
        p = T @ vec4d(spheres[k, 0], spheres[k, 1], spheres[k, 2], 1.0)
        min_clearance = min(min_clearance, clearance_at(vec3d(p[0], p[1], p[2]), grid) - spheres[k, 3])
    clearances[i] = min_clearance


@func
def lattice_voxel(i: int, low: vec3i, size: vec3i, grid: DistanceGrid) -> int:
    """Index of the i-th voxel of a box, z fastest, or -1."""
    cell = vec3i(low[0] + i // (size[1] * size[2]), low[1] + (i // size[2]) % size[1], low[2] + i % size[2])
    return find_voxel(cell, grid.table)


@kernel
def list_distances_kernel(
    low: vec3i, size: vec3i, grid: DistanceGrid, distances: array(dtype=float32), known: array(dtype=uint8)
):
    i = tid()
    voxel = lattice_voxel(i, low, size, grid)
    distances[i] = float(distance_at(voxel, grid))
    known[i] = uint8(is_known(voxel, grid))


@kernel
def list_sqdists_kernel(low: vec3i, size: vec3i, grid: DistanceGrid, sqdists: array(dtype=int32)):
    """Squared distances of a box of voxels [voxels^2]. FAR if unknown."""
    i = tid()
    voxel = lattice_voxel(i, low, size, grid)
    sqdist = int(NO_SEED)
    if voxel >= 0:
        sqdist = grid.sqdists[voxel]
    sqdists[i] = sqdist


@kernel
def list_nearest_kernel(low: vec3i, size: vec3i, grid: DistanceGrid, rows: array(dtype=int32)):
    """Row of the nearest occupied voxel to each voxel of a box, or -1 if unknown."""
    i = tid()
    voxel = lattice_voxel(i, low, size, grid)
    row = -1
    if voxel >= 0:
        if grid.sqdists[voxel] != NO_SEED:
            row = grid.nearest[voxel]
    rows[i] = row


def find_distances_at(points: Positions, grid: DistanceGrid, *, interpolate: bool) -> KnownDistances:
    result = KnownDistances(empty(points.size, float32, grid.device), empty(points.size, uint8, grid.device))
    launch(find_distances_kernel, points.size, [points, int(interpolate), grid, *result])
    return result


def find_gradients(points: Positions, grid: DistanceGrid) -> Any:
    return compute(find_gradients_kernel, points.size, [points, grid], vec3, grid.device)


def find_obstacles(points: Positions, grid: DistanceGrid) -> tuple[Integers, Positions, Scalars]:
    n, device = points.size, grid.device
    results = empty(n, int32, device), empty(n, vec3d, device), empty(n, float32, device)
    launch(find_obstacles_kernel, n, [points, grid, *results])
    return results


def find_hits(centers: Positions, radii: Doubles, grid: DistanceGrid) -> Mask:
    """1 for each sphere that is not certainly free. One radius, or one for each."""
    return compute(find_hits_kernel, centers.size, [centers, radii, grid], uint8, grid.device)


def find_body_room(spheres: Array2[float64], poses: Poses, grid: DistanceGrid) -> Doubles:
    """Free distance around the spheres (x, y, z, radius) of a body at each pose [m], float64."""
    return compute(find_body_clearance_kernel, poses.size, [spheres, poses, grid], float64, grid.device)


class Box(NamedTuple):
    low: tuple[int, int, int]
    size: tuple[int, int, int]

    @property
    def voxel_count(self) -> int:
        return int(np.prod(self.size, dtype=np.int64))


def list_distances(box: Box, grid: DistanceGrid) -> KnownDistances:
    result = KnownDistances(empty(box.voxel_count, float32, grid.device), empty(box.voxel_count, uint8, grid.device))
    launch(list_distances_kernel, box.voxel_count, [vec3i(*box.low), vec3i(*box.size), grid, *result])
    return result


def list_sqdists(box: Box, grid: DistanceGrid) -> Integers:
    return compute(list_sqdists_kernel, box.voxel_count, [vec3i(*box.low), vec3i(*box.size), grid], int32, grid.device)


def list_nearest(box: Box, grid: DistanceGrid) -> Integers:
    return compute(list_nearest_kernel, box.voxel_count, [vec3i(*box.low), vec3i(*box.size), grid], int32, grid.device)
