"""How well the overlap of two surfaces constrains their relative pose.

Compares the point-to-plane normal equations (Chen and Medioni 1991) of all points near the other cloud with those of
matching points. Any two room corners match, so evidence beside the three dominant planes is measured separately, and
how much of that is aligned with those planes. One nearest-neighbor search per point, two beside planes.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.rigid_solve import move, rotate
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Integers, Vectors
from ..arrays.packed_keys import key_index, key_number
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float32,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    mat44d,
    reduce,
    reduction,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..memory import copy, download, empty, zeros
from ..search.bucket_walk import points_within
from ..search.nearest_point import NO_POINT, find_nearest
from ..search.point_tree import BUCKET, PointTree
from ..search.tree_search import squared_radius
from ..surface.hollow_side import Surface
from .main_planes import MainPlanes, find_main_planes, leave_out_planes

middle_sums = vector(5, float64)  # count, x, y, z, squares
relief_sums = vector(4, float64)  # count, covariance, variances
deviation_sums = vector(2, float64)  # pairs, deviating ones
evidence_sums = vector(46, float64)  # normal matrices of near points and matches, then four counts
motions = vector(6, float64)
NEAR_AT, AGREEING_AT, MATCHED_AT, ALIGNED_AT = 42, 43, 44, 45

PLANE_COUNT = 3  # sufficient to fix a pose
MAX_DIRECTIONS = 6  # of plane normals, and orthogonal to two of them
# In match distances (1.5 voxels): half a voxel to the points that fit a plane, one voxel to those on it,
# three voxels to those whose normals it bends.
FITTED_DISTANCE, ON_PLANE, BENT_DISTANCE = 0.35, 0.75, 2.0
MAX_ORTHOGONAL_COSINE = 0.17  # 10 degrees: cosine between normals of orthogonal planes
MIN_ALIGNED_COSINE = 0.95  # 18 degrees: cosine between a normal and a plane's, as in plane fitting


@kernel
def move_surface_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    pose: mat44d,
    moved: array(dtype=vec3),
    moved_normals: array(dtype=vec3),
):
    i = tid()
    moved[i] = narrow(move(pose, widen(points[i])))
    moved_normals[i] = narrow(rotate(pose, widen(normals[i])))


@reduction
def sum_near(moved: array(dtype=vec3), nearest: array(dtype=int64)) -> middle_sums:
    i = tid()
    out = middle_sums(0.0)
    if nearest[i] != int64(NO_POINT):
        p = widen(moved[i])
        out = middle_sums(1.0, p[0], p[1], p[2], dot(p, p))
    return out


@struct
class Overlap:
    """Two surfaces, the first moved by a pose (`moved`, `moved_normals`). `middle` [m] and `scale` [1 / m] (inverse RMS
    distance) of points with a nearest one; `tight` [m]: weights end; `frame`: directions of removed planes.
    """

    moved: array(dtype=vec3)
    moved_normals: array(dtype=vec3)
    nearest: array(dtype=int64)
    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    middle: array(dtype=vec3d)
    scale: array(dtype=float64)
    distance: float
    cosine: float
    tight: float
    frame: array(dtype=vec3)
    frame_size: array(dtype=int32)

    def __init__(
        self,
        source: Surface,
        target: Surface,
        pose: np.ndarray,
        distance: float,
        near: float,
        cosine: float,
        tight: float,
    ) -> None:
        count, device = source.points.size, source.device
        self.points, self.normals = target.points, target.normals
        self.distance, self.cosine, self.tight = distance, cosine, tight
        self.frame, self.frame_size = empty(MAX_DIRECTIONS, vec3, device), zeros(1, int32, device)
        self.middle, self.scale = empty(1, vec3d, device), empty(1, float64, device)
        self.moved, self.moved_normals = empty(count, vec3, device), empty(count, vec3, device)
        arguments = [source.points, source.normals, mat44d(*pose.ravel().tolist()), self.moved, self.moved_normals]
        launch(move_surface_kernel, count, arguments)
        self.nearest = find_nearest(target.tree, self.moved, radius=near, order=source.tree.order)
        self.find_middle()

    def leave_out_border(self) -> None:
        """Remove the points beyond the border of the other surface, where it has no measurement."""
        launch(leave_out_border_kernel, self.moved.size, [self, self.nearest])
        self.find_middle()

    def find_middle(self) -> None:
        total = reduce(sum_near, self.moved.size, [self.moved, self.nearest])
        launch(find_middle_kernel, 1, [total, self])

    def find_planes(self) -> MainPlanes:
        """The dominant planes of the matches."""
        count = self.moved.size
        mask = compute(mask_matched_kernel, count, [self], uint8, self.moved.device)
        fitted, slab = FITTED_DISTANCE * self.distance, ON_PLANE * self.distance
        return find_main_planes(self.moved, self.moved_normals, mask, PLANE_COUNT, fitted, slab, self.cosine)

    def leave_out_planes(self, planes: MainPlanes) -> None:
        """Remove the points on planes."""
        slab, edge = ON_PLANE * self.distance, BENT_DISTANCE * self.distance
        leave_out_planes(self.moved, self.moved_normals, planes, slab, self.cosine, edge, self.nearest)
        self.find_middle()
        find_directions(planes, self.frame, self.frame_size)

    def weigh(self) -> Array1[Any]:
        return reduce(sum_evidence, self.moved.size, [self])

    def weigh_relief(self, planes: MainPlanes) -> Array1[Any]:
        slab, edge = ON_PLANE * self.distance, BENT_DISTANCE * self.distance
        return reduce(sum_relief, self.moved.size, [self, planes, slab, edge])


@kernel
def leave_out_border_kernel(overlap: Overlap, nearest: array(dtype=int64)):
    """Clear the nearest point of points that are farther away along its surface than matches are."""
    i = tid()
    if nearest[i] != int64(NO_POINT):
        row = key_index(nearest[i])
        offset = overlap.moved[i] - overlap.points[row]
        height = dot(offset, overlap.normals[row])
        if dot(offset, offset) - height * height > overlap.distance * overlap.distance:
            nearest[i] = int64(NO_POINT)


@kernel
def find_middle_kernel(total: array(dtype=middle_sums), overlap: Overlap):
    """Center and scale of points from their sums. One thread."""
    i = tid()
    points = max(total[i][0], float64(1.0))
    middle = vec3d(total[i][1] / points, total[i][2] / points, total[i][3] / points)
    radius = sqrt(max(total[i][4] / points - dot(middle, middle), float64(0.0)))
    overlap.middle[i] = middle
    overlap.scale[i] = 1.0 / max(radius, float64(1e-30))


@kernel
def find_directions_kernel(planes: MainPlanes, directions: array(dtype=vec3), count: array(dtype=int32)):
    """Unit normals of planes, and those orthogonal to any two mutually orthogonal ones. One thread."""
    i = tid()
    total = planes.count[i]
    for k in range(planes.count[i]):
        directions[k] = planes.directions[0, k]
        for j in range(k):
            a = planes.directions[0, k]
            b = planes.directions[0, j]
            if abs(dot(a, b)) < MAX_ORTHOGONAL_COSINE:
                third = cross(a, b)
                directions[total] = third * (1.0 / length(third))
                total += 1
    count[i] = total


def find_directions(planes: MainPlanes, directions: Vectors, count: Integers) -> None:
    """Write the directions of planes and their count, at most MAX_DIRECTIONS of PLANE_COUNT."""
    launch(find_directions_kernel, 1, [planes, directions, count])


@func
def agrees(overlap: Overlap, i: int) -> int:
    """True if a point is within distance of its nearest point with parallel or opposite normal."""
    key = overlap.nearest[i]
    agreeing = 0
    if key_number(key) < overlap.distance * overlap.distance:
        if abs(dot(overlap.moved_normals[i], overlap.normals[key_index(key)])) > overlap.cosine:
            agreeing = 1
    return agreeing


@func
def match_weight(overlap: Overlap, i: int) -> float:
    """Weight of a match, decreasing with the distance along the normal."""
    row = key_index(overlap.nearest[i])
    height = dot(overlap.moved[i] - overlap.points[row], overlap.normals[row]) / overlap.tight
    return max(1.0 - height * height, 0.0)


@func
def is_aligned(overlap: Overlap, i: int) -> int:
    """True if a normal is along a removed plane's normal, or orthogonal to two."""
    aligned = 0
    for k in range(overlap.frame_size[0]):
        if abs(dot(overlap.frame[k], overlap.moved_normals[i])) > MIN_ALIGNED_COSINE:
            aligned = 1
    return aligned


@kernel
def mask_matched_kernel(overlap: Overlap, mask: array(dtype=uint8)):
    i = tid()
    matched = 0
    if overlap.nearest[i] != int64(NO_POINT):
        if agrees(overlap, i) == 1:
            if match_weight(overlap, i) > 0.0:
                matched = 1
    mask[i] = uint8(matched)


@reduction
def sum_evidence(overlap: Overlap) -> evidence_sums:
    """Normal matrices of near points and of matches, rotations in units of the overlap's radius."""
    i = tid()
    out = evidence_sums(0.0)
    if overlap.nearest[i] != int64(NO_POINT):
        n = widen(overlap.moved_normals[i])
        r = (widen(overlap.moved[i]) - overlap.middle[0]) * overlap.scale[0]
        c = cross(r, n)
        agreeing = float64(0.0)
        matched = float64(0.0)
        if agrees(overlap, i) == 1:
            agreeing = 1.0
            matched = float64(match_weight(overlap, i))
        a = motions(c[0], c[1], c[2], n[0], n[1], n[2])
        at = 0
        for j in range(6):
            for k in range(j, 6):
                entry = a[j] * a[k]
                out[at] = entry
                out[at + 21] = matched * entry
                at += 1
        out[NEAR_AT] = 1.0
        out[AGREEING_AT] = agreeing
        out[MATCHED_AT] = matched
        out[ALIGNED_AT] = matched * float64(is_aligned(overlap, i))
    return out


@func
def plane_of(overlap: Overlap, planes: MainPlanes, slab: float, edge: float, i: int) -> int:
    """The nearest plane of a point, or -1 if it is off all planes or at the edge of two."""
    p = overlap.moved[i]
    plane = int(-1)
    lowest = float(slab)
    at_edge = int(0)
    for k in range(planes.count[0]):
        n = planes.directions[0, k]
        height = abs(dot(n, p - planes.middles[0, k]))
        if height < lowest and abs(dot(n, overlap.moved_normals[i])) > overlap.cosine:
            plane = k
            lowest = height
        if height < edge:
            for j in range(k):
                m = planes.directions[0, j]
                if abs(dot(n, m)) < overlap.cosine and abs(dot(m, p - planes.middles[0, j])) < edge:
                    at_edge = 1
    if at_edge == 1:
        plane = -1
    return plane


@func
def slope_of(n: vec3, axis: vec3) -> vec3:
    """The tangential part of a normal on a plane, independent of the normal's sign."""
    along = dot(n, axis)
    slope = n - along * axis
    if along < 0.0:
        slope = -slope
    return slope


@reduction
def sum_relief(overlap: Overlap, planes: MainPlanes, slab: float, edge: float) -> relief_sums:
    """Count, covariance and variances of the slopes of matches on planes."""
    i = tid()
    out = relief_sums(0.0)
    if overlap.nearest[i] != int64(NO_POINT):
        if agrees(overlap, i) == 1:
            plane = plane_of(overlap, planes, slab, edge, i)
            weight = match_weight(overlap, i)
            if plane >= 0 and weight > 0.0:
                axis = planes.directions[0, plane]
                other = overlap.normals[key_index(overlap.nearest[i])]
                if abs(dot(other, axis)) > overlap.cosine:
                    a = widen(slope_of(overlap.moved_normals[i], axis))
                    b = widen(slope_of(other, axis))
                    out = relief_sums(1.0, dot(a, b), dot(a, a), dot(b, b))
    return out


@kernel
def find_spreads_kernel(tree: PointTree, normals: array(dtype=vec3), radius: float, spreads: array(dtype=float32)):
    """Standard deviation of the distances [m] of a point's neighbors from its tangent plane."""
    i = tid()
    row = tree.order[i]
    p = tree.points[i]
    n = normals[row]
    count = float(0.0)
    total = float(0.0)
    squares = float(0.0)
    for j, _ in points_within(i // BUCKET, p, radius, tree):
        height = dot(n, tree.points[j] - p)
        count += 1.0
        total += height
        squares += height * height
    mean = total / count
    spreads[row] = sqrt(max(squares / count - mean * mean, 0.0))


def find_spreads(surface: Surface, radius: float) -> Array1[Any]:
    """Noise of a surface [m] within a radius [m] of each point, float32 (n). Curvature adds to it."""
    spreads = zeros(surface.points.size, float32, surface.device)
    arguments = [surface.tree, surface.normals, squared_radius(radius), spreads]
    launch(find_spreads_kernel, surface.tree.count, arguments)
    return spreads


@reduction
def sum_deviating(
    overlap: Overlap, spreads: array(dtype=float32), other_spreads: array(dtype=float32), sigmas: float, floor: float
) -> deviation_sums:
    """Count of pairs with agreeing normals, and of those apart along the normal by several sigmas of their noise."""
    i = tid()
    out = deviation_sums(0.0)
    if overlap.nearest[i] != int64(NO_POINT):
        if agrees(overlap, i) == 1:
            row = key_index(overlap.nearest[i])
            height = dot(overlap.moved[i] - overlap.points[row], overlap.normals[row])
            noise = spreads[i] * spreads[i] + other_spreads[row] * other_spreads[row]
            deviating = float64(0.0)
            if height * height > sigmas * sigmas * max(noise, floor * floor):
                deviating = 1.0
            out = deviation_sums(1.0, deviating)
    return out


def weigh_overlaps(
    pairs: Sequence[tuple[Surface, Surface, np.ndarray]],
    distance: float,
    near: float,
    cosine: float,
    tight: float,
    *,
    beside_planes: bool = False,
    within_borders: bool = False,
) -> np.ndarray:
    """Evidence for (source, target, pose) triples about the clouds' origins; float64 (pairs, 46), one sync. `distance`
    [m] and `cosine` limit matches, `near` [m] the overlap. Columns: upper triangles of two normal matrices, then counts
    at NEAR_AT, AGREEING_AT, MATCHED_AT and ALIGNED_AT (matches in the directions of removed planes). `within_borders`:
    the overlap ends at the border of the other surface.
    """
    if not pairs:
        return np.empty((0, len(evidence_sums(0.0))))
    gathered = empty(len(pairs), evidence_sums, pairs[0][0].device)
    for k, (source, target, pose) in enumerate(pairs):
        overlap = Overlap(source, target, pose, distance, near, cosine, tight)
        if within_borders:
            overlap.leave_out_border()
        if beside_planes:
            overlap.leave_out_planes(overlap.find_planes())
        copy(gathered, overlap.weigh(), count=1, offset=k)
    return download(gathered).copy()  # sync


def weigh_reliefs(
    pairs: Sequence[tuple[Surface, Surface, np.ndarray]], distance: float, near: float, cosine: float, tight: float
) -> np.ndarray:
    """Slopes of matches relative to the dominant planes that they are on, with arguments as of `weigh_overlaps`.

    float64 (pairs, 4): the count of matches, the covariance of the slopes of both surfaces, and their variances, as
    sums. Slopes of the same uneven ground are correlated, those of two flat walls are noise. One sync.
    """
    gathered = empty(len(pairs), relief_sums, pairs[0][0].device)
    for k, (source, target, pose) in enumerate(pairs):
        overlap = Overlap(source, target, pose, distance, near, cosine, tight)
        copy(gathered, overlap.weigh_relief(overlap.find_planes()), count=1, offset=k)
    return download(gathered).copy()  # sync


def count_deviating(
    pairs: Sequence[tuple[Surface, Surface, np.ndarray]],
    distance: float,
    near: float,
    cosine: float,
    tight: float,
    *,
    radius: float,
    sigmas: float,
    floor: float,
) -> np.ndarray:
    """Pairs of points within `distance` [m] with agreeing normals, and those apart along the normal by `sigmas`.

    The standard deviation is of the neighbors within `radius` [m] of both points, at least `floor` [m]. Arguments as of
    `weigh_overlaps`; float64 (pairs, 2). One sync.
    """
    spreads = {id(s): find_spreads(s, radius) for s in {id(s): s for pair in pairs for s in pair[:2]}.values()}
    gathered = empty(len(pairs), deviation_sums, pairs[0][0].device)
    for k, (source, target, pose) in enumerate(pairs):
        overlap = Overlap(source, target, pose, distance, near, cosine, tight)
        overlap.leave_out_border()
        arguments = [overlap, spreads[id(source)], spreads[id(target)], sigmas, floor]
        copy(gathered, reduce(sum_deviating, overlap.moved.size, arguments), count=1, offset=k)
    return download(gathered).copy()  # sync
