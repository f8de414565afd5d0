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
    cross,
    dot,
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
from ..search.nearest_point import NO_POINT, find_nearest
from ..surface.hollow_side import Surface
from .main_planes import MainPlanes, find_main_planes, leave_out_planes

middle_sums = vector(5, float64)  # count, x, y, z, squares
evidence_sums = vector(46, float64)  # normal matrices of near points and matches, then four counts
motions = vector(6, float64)
NEAR_AT, AGREEING_AT, MATCHED_AT, ALIGNED_AT = 42, 43, 44, 45

PLANES = 3  # sufficient to fix a pose
MAX_DIRECTIONS = 6  # of plane normals, and orthogonal to two of them
# In match distances (1.5 voxels): half a voxel to the points that fit a plane, one voxel to those on it,
# three voxels to those whose normals it bends.
FITTED, ON_PLANE, BENT = 0.35, 0.75, 2.0
SQUARE = 0.17  # 10 degrees: cosine between normals of orthogonal planes
ALIGNED = 0.95  # 18 degrees: cosine between a normal and a plane's, as in plane fitting


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
        self.nearest = find_nearest(target.tree, self.moved, radius=near)
        self.find_middle()

    def find_middle(self) -> None:
        total = reduce(sum_near, self.moved.size, [self.moved, self.nearest])
        launch(find_middle_kernel, 1, [total, self])

    def leave_out_planes(self) -> None:
        """Remove the points on the dominant planes of the matches."""
        count = self.moved.size
        mask = empty(count, uint8, self.moved.device)
        launch(mask_matched_kernel, count, [self, mask])
        fitted, slab, edge = (share * self.distance for share in (FITTED, ON_PLANE, BENT))
        planes = find_main_planes(self.moved, self.moved_normals, mask, PLANES, fitted, slab, self.cosine)
        leave_out_planes(self.moved, self.moved_normals, planes, slab, self.cosine, edge, self.nearest)
        self.find_middle()
        find_directions(planes, self.frame, self.frame_size)

    def weigh(self) -> Array1[Any]:
        return reduce(sum_evidence, self.moved.size, [self])


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
        directions[k] = planes.directions[k]
        for j in range(k):
            a = planes.directions[k]
            b = planes.directions[j]
            if abs(dot(a, b)) < SQUARE:
                third = cross(a, b)
                directions[total] = third * (1.0 / length(third))
                total += 1
    count[i] = total


def find_directions(planes: MainPlanes, directions: Vectors, count: Integers) -> None:
    """Write the directions of planes and their count, at most MAX_DIRECTIONS of PLANES."""
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
        if abs(dot(overlap.frame[k], overlap.moved_normals[i])) > ALIGNED:
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


def weigh_overlaps(
    pairs: Sequence[tuple[Surface, Surface, np.ndarray]],
    distance: float,
    near: float,
    cosine: float,
    tight: float,
    *,
    beside_planes: bool = False,
) -> np.ndarray:
    """Evidence for (source, target, pose) triples about the clouds' origins; float64 (pairs, 46), one sync. `distance`
    [m] and `cosine` limit matches, `near` [m] the overlap. Columns: upper triangles of two normal matrices, then counts
    at NEAR_AT, AGREEING_AT, MATCHED_AT and ALIGNED_AT (matches in the directions of removed planes).
    """
    if not pairs:
        return np.empty((0, len(evidence_sums(0.0))))
    gathered = empty(len(pairs), evidence_sums, pairs[0][0].device)
    for k, (source, target, pose) in enumerate(pairs):
        overlap = Overlap(source, target, pose, distance, near, cosine, tight)
        if beside_planes:
            overlap.leave_out_planes()
        copy(gathered, overlap.weigh(), count=1, offset=k)
    return download(gathered).copy()  # sync
