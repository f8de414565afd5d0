"""How well the overlap of two surfaces constrains their relative pose.

Compares the point-to-plane normal equations (Chen and Medioni 1991) of all points near the other cloud with those of
matching points. Any two room corners match, so evidence beside the three dominant planes is measured separately, and
how much of that is aligned with those planes. One nearest-neighbor search per point, two beside planes.
"""

import itertools
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..algebra.rigid_solve import move, rotate
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Array2, Indices, Integers
from ..arrays.packed_keys import key_index, key_number
from ..arrays.prefix_sum import find_owner
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import read_together
from ..lang import (
    array,
    block_elements,
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
    reduce_segments,
    segment_reduction,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..memory import clone, copy, empty, fill, full, rows_of, upload, zeros
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


@kernel
def move_surfaces_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    poses: array(dtype=mat44d),
    first_pose: int,
    first: int,
    moved: array(dtype=vec3),
    moved_normals: array(dtype=vec3),
):
    """A surface moved by several poses, to consecutive rows."""
    i = tid()
    count = points.shape[0]
    pose = poses[first_pose + i // count]
    moved[first + i] = narrow(move(pose, widen(points[i % count])))
    moved_normals[first + i] = narrow(rotate(pose, widen(normals[i % count])))


@kernel
def repeat_order_kernel(order: array(dtype=int32), count: int, orders: array(dtype=int32)):
    """An order of `count` points, for the points at each of several poses."""
    i = tid()
    orders[i] = i - i % count + order[i % count]


def repeat_order(order: Indices, count: int, poses: int) -> Indices:
    """The order of `count` points, repeated for each of several poses."""
    if poses == 1:
        return order
    return compute(repeat_order_kernel, poses * count, [order, count], int32, order.device)


@kernel
def gather_partners_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    first: int,
    nearest: array(dtype=int64),
    partners: array(dtype=vec3),
    partner_normals: array(dtype=vec3),
):
    i = tid()
    key = nearest[first + i]
    if key != int64(NO_POINT):
        partners[first + i] = points[key_index(key)]
        partner_normals[first + i] = normals[key_index(key)]


@segment_reduction
def sum_near(moved: array(dtype=vec3), nearest: array(dtype=int64)) -> middle_sums:
    i = tid()
    out = middle_sums(0.0)
    if nearest[i] != int64(NO_POINT):
        p = widen(moved[i])
        out = middle_sums(1.0, p[0], p[1], p[2], dot(p, p))
    return out


Pair = tuple[Surface, Surface, np.ndarray]  # source, target, and pose about the clouds' origins


@struct
class Overlaps:
    """Pairs of surfaces. The source of each is moved by its pose (`moved`, `moved_normals`), with the nearest point of
    each point in the target (`partners`, `partner_normals`). `starts`: first rows of the pairs. `middle` [m] and
    `scale` [1 / m] (inverse RMS distance) of points with a nearest one; `tight` [m]: weights end; `frame`: directions
    of removed planes.
    """

    moved: array(dtype=vec3)
    moved_normals: array(dtype=vec3)
    nearest: array(dtype=int64)
    partners: array(dtype=vec3)
    partner_normals: array(dtype=vec3)
    starts: array(dtype=int32)
    middle: array(dtype=vec3d)
    scale: array(dtype=float64)
    distance: float
    cosine: float
    tight: float
    frame: array(dtype=vec3, ndim=2)
    frame_size: array(dtype=int32)

    def __init__(self, pairs: Sequence[Pair], distance: float, near: float, cosine: float, tight: float) -> None:
        """Arguments as of `weigh_overlaps`. Equal surfaces of consecutive pairs are searched together."""
        counts, device = [len(source) for source, _, _ in pairs], pairs[0][0].device
        self.pairs, self.device, self.firsts = pairs, device, [0, *itertools.accumulate(counts)]
        self.count, rows = len(pairs), self.firsts[-1]
        self.distance, self.cosine, self.tight = distance, cosine, tight
        self.frame = empty((self.count, MAX_DIRECTIONS), vec3, device)
        self.frame_size = zeros(self.count, int32, device)
        self.middle, self.scale = empty(self.count, vec3d, device), empty(self.count, float64, device)
        self.moved, self.moved_normals, self.partners, self.partner_normals = (
            empty(rows, vec3, device) for _ in range(4)
        )
        self.nearest, self.starts = empty(rows, int64, device), upload(np.array(self.firsts), int32, device)
        self._blocks = SegmentBlocks(self.firsts[:-1], counts, device, [block_elements(n, device) for n in counts])
        self._live = full(self.count, 1, int32, device)
        poses = upload(np.stack([pose for _, _, pose in pairs]), mat44d, device)
        for _, group in itertools.groupby(range(self.count), lambda k: [id(surface) for surface in pairs[k][:2]]):
            self._search(list(group), poses, near)

    def _search(self, group: list[int], poses: Array1[mat44d], near: float) -> None:
        """Find the nearest points of consecutive pairs of the same surfaces."""
        source, target, _ = self.pairs[group[0]]
        first, last = self.firsts[group[0]], self.firsts[group[-1] + 1]
        if first == last:
            return
        moved = [source.points, source.normals, poses, group[0], first, self.moved, self.moved_normals]
        launch(move_surfaces_kernel, last - first, moved)
        order = repeat_order(source.tree.order, len(source), len(group))
        queries, nearest = (rows_of(values, first, last) for values in (self.moved, self.nearest))
        find_nearest(target.tree, queries, radius=near, order=order, nearest=nearest)
        partners = [target.points, target.normals, first, self.nearest, self.partners, self.partner_normals]
        launch(gather_partners_kernel, last - first, partners)

    def _sum(self, reduction: Any, arguments: Sequence[Any]) -> Array1[Any]:
        """Sums of the rows of each pair, with the bits of `reduce`."""
        sums = empty(self.count, reduction.vector, self.device)
        reduce_segments(reduction, self._blocks, self._live, arguments, self._blocks.partials(reduction.vector), sums)
        return sums

    def leave_out_border(self) -> None:
        """Remove the points beyond the border of the other surface, where it has no measurement."""
        launch(leave_out_border_kernel, self.moved.size, [self, self.nearest])

    def find_planes(self) -> MainPlanes:
        """The dominant planes of the matches of each pair."""
        mask = compute(mask_matched_kernel, self.moved.size, [self], uint8, self.device)
        limits = PLANE_COUNT, FITTED_DISTANCE * self.distance, ON_PLANE * self.distance, self.cosine
        return find_main_planes(self.moved, self.moved_normals, mask, *limits, self.starts)

    def weigh(self) -> Array1[Any]:
        """Evidence of each pair, evidence_sums."""
        total = self._sum(sum_near, [self.moved, self.nearest])
        launch(find_middle_kernel, self.count, [total, self])
        return self._sum(sum_evidence, [self])

    def weigh_beside(self, planes: MainPlanes) -> Array1[Any]:
        """As `weigh`, without the points on planes."""
        nearest, slab, edge = clone(self.nearest), ON_PLANE * self.distance, BENT_DISTANCE * self.distance
        leave_out_planes(self.moved, self.moved_normals, planes, slab, self.cosine, edge, self.nearest, self.starts)
        find_directions(planes, self.frame, self.frame_size)
        beside = self.weigh()
        copy(self.nearest, nearest, count=nearest.size)
        fill(self.frame_size, 0)
        return beside

    def weigh_details(self, planes: MainPlanes, noise: "Noise") -> list[Array1[Any]]:
        """The arrays of OverlapDetails. Removes the points beyond the border."""
        reliefs = self.weigh_relief(planes)
        self.leave_out_border()
        visible, deviating = self.weigh(), self.count_deviating(noise)
        return [visible, self.weigh_beside(self.find_planes()), reliefs, deviating]

    def weigh_relief(self, planes: MainPlanes) -> Array1[Any]:
        """Slopes of the matches on planes of each pair, relief_sums."""
        return self._sum(sum_relief, [self, planes, ON_PLANE * self.distance, BENT_DISTANCE * self.distance])

    def count_deviating(self, limits: "Noise") -> Array1[Any]:
        """Pairs of points with agreeing normals, and deviating ones, deviation_sums."""
        surfaces = {id(surface): surface for pair in self.pairs for surface in pair[:2]}
        spreads = {key: find_spreads(surface, limits.radius) for key, surface in surfaces.items()}
        noise = empty(self.moved.size, float32, self.device)
        for first, (source, target, _) in zip(self.firsts, self.pairs, strict=False):
            given = [spreads[id(source)], spreads[id(target)], first, self.nearest, noise]
            launch(add_noise_kernel, len(source), given)
        return self._sum(sum_deviating, [self, noise, limits.sigmas, limits.floor])


@kernel
def leave_out_border_kernel(overlap: Overlaps, nearest: array(dtype=int64)):
    """Clear the nearest point of points that are farther away along its surface than matches are."""
    i = tid()
    if nearest[i] != int64(NO_POINT):
        offset = overlap.moved[i] - overlap.partners[i]
        height = dot(offset, overlap.partner_normals[i])
        if dot(offset, offset) - height * height > overlap.distance * overlap.distance:
            nearest[i] = int64(NO_POINT)


@kernel
def find_middle_kernel(total: array(dtype=middle_sums), overlap: Overlaps):
    """Center and scale of points from their sums. A thread per pair."""
    i = tid()
    points = max(total[i][0], float64(1.0))
    middle = vec3d(total[i][1] / points, total[i][2] / points, total[i][3] / points)
    radius = sqrt(max(total[i][4] / points - dot(middle, middle), float64(0.0)))
    overlap.middle[i] = middle
    overlap.scale[i] = 1.0 / max(radius, float64(1e-30))


@kernel
def find_directions_kernel(planes: MainPlanes, directions: array(dtype=vec3, ndim=2), count: array(dtype=int32)):
    """Unit normals of planes, and those orthogonal to any two mutually orthogonal ones. A thread per surface."""
    i = tid()
    total = planes.count[i]
    for k in range(planes.count[i]):
        directions[i, k] = planes.directions[i, k]
        for j in range(k):
            a = planes.directions[i, k]
            b = planes.directions[i, j]
            if abs(dot(a, b)) < MAX_ORTHOGONAL_COSINE:
                third = cross(a, b)
                directions[i, total] = third * (1.0 / length(third))
                total += 1
    count[i] = total


def find_directions(planes: MainPlanes, directions: Array2[vec3], count: Integers) -> None:
    """Write the directions of the planes of each surface and their count, at most MAX_DIRECTIONS of PLANE_COUNT."""
    launch(find_directions_kernel, count.size, [planes, directions, count])


@func
def agrees(overlap: Overlaps, i: int) -> int:
    """True if a point is within distance of its nearest point with parallel or opposite normal."""
    key = overlap.nearest[i]
    agreeing = 0
    if key_number(key) < overlap.distance * overlap.distance:
        if abs(dot(overlap.moved_normals[i], overlap.partner_normals[i])) > overlap.cosine:
            agreeing = 1
    return agreeing


@func
def match_weight(overlap: Overlaps, i: int) -> float:
    """Weight of a match, decreasing with the distance along the normal."""
    height = dot(overlap.moved[i] - overlap.partners[i], overlap.partner_normals[i]) / overlap.tight
    return max(1.0 - height * height, 0.0)


@func
def is_aligned(overlap: Overlaps, pair: int, i: int) -> int:
    """True if a normal is along a removed plane's normal, or orthogonal to two."""
    aligned = 0
    for k in range(overlap.frame_size[pair]):
        if abs(dot(overlap.frame[pair, k], overlap.moved_normals[i])) > MIN_ALIGNED_COSINE:
            aligned = 1
    return aligned


@kernel
def mask_matched_kernel(overlap: Overlaps, mask: array(dtype=uint8)):
    i = tid()
    matched = 0
    if overlap.nearest[i] != int64(NO_POINT):
        if agrees(overlap, i) == 1:
            if match_weight(overlap, i) > 0.0:
                matched = 1
    mask[i] = uint8(matched)


@segment_reduction
def sum_evidence(overlap: Overlaps) -> evidence_sums:
    """Normal matrices of near points and of matches, rotations in units of the overlap's radius."""
    i = tid()
    out = evidence_sums(0.0)
    if overlap.nearest[i] != int64(NO_POINT):
        pair = find_owner(overlap.starts, i)
        n = widen(overlap.moved_normals[i])
        r = (widen(overlap.moved[i]) - overlap.middle[pair]) * overlap.scale[pair]
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
        out[ALIGNED_AT] = matched * float64(is_aligned(overlap, pair, i))
    return out


@func
def plane_of(overlap: Overlaps, planes: MainPlanes, slab: float, edge: float, i: int) -> int:
    """The nearest plane of a point, or -1 if it is off all planes or at the edge of two."""
    pair = find_owner(overlap.starts, i)
    p = overlap.moved[i]
    plane = int(-1)
    lowest = float(slab)
    at_edge = int(0)
    for k in range(planes.count[pair]):
        n = planes.directions[pair, k]
        height = abs(dot(n, p - planes.middles[pair, k]))
        if height < lowest and abs(dot(n, overlap.moved_normals[i])) > overlap.cosine:
            plane = k
            lowest = height
        if height < edge:
            for j in range(k):
                m = planes.directions[pair, j]
                if abs(dot(n, m)) < overlap.cosine and abs(dot(m, p - planes.middles[pair, j])) < edge:
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


@segment_reduction
def sum_relief(overlap: Overlaps, planes: MainPlanes, slab: float, edge: float) -> relief_sums:
    """Count, covariance and variances of the slopes of matches on planes."""
    i = tid()
    out = relief_sums(0.0)
    if overlap.nearest[i] != int64(NO_POINT):
        if agrees(overlap, i) == 1:
            plane = plane_of(overlap, planes, slab, edge, i)
            weight = match_weight(overlap, i)
            if plane >= 0 and weight > 0.0:
                axis = planes.directions[find_owner(overlap.starts, i), plane]
                other = overlap.partner_normals[i]
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


@kernel
def add_noise_kernel(
    spreads: array(dtype=float32),
    other_spreads: array(dtype=float32),
    first: int,
    nearest: array(dtype=int64),
    noise: array(dtype=float32),
):
    """Variance [m^2] of the distance of each point of a pair from its nearest one, by the noise of both."""
    i = tid()
    if nearest[first + i] != int64(NO_POINT):
        row = key_index(nearest[first + i])
        noise[first + i] = spreads[i] * spreads[i] + other_spreads[row] * other_spreads[row]


@segment_reduction
def sum_deviating(overlap: Overlaps, noise: array(dtype=float32), sigmas: float, floor: float) -> deviation_sums:
    """Count of pairs with agreeing normals, and of those apart along the normal by several sigmas of their noise."""
    i = tid()
    out = deviation_sums(0.0)
    if overlap.nearest[i] != int64(NO_POINT):
        if agrees(overlap, i) == 1:
            height = dot(overlap.moved[i] - overlap.partners[i], overlap.partner_normals[i])
            deviating = float64(0.0)
            if height * height > sigmas * sigmas * max(noise[i], floor * floor):
                deviating = 1.0
            out = deviation_sums(1.0, deviating)
    return out


MAX_ROWS = 1 << 20  # points of all pairs that are compared at once: about 80 MB


def _batches(pairs: Sequence[Pair]) -> Iterator[list[int]]:
    """Pairs that are compared at once, those of the same surfaces together: at most MAX_ROWS points, or one pair."""
    batch, rows = [], 0
    for k in sorted(range(len(pairs)), key=lambda k: [id(surface) for surface in pairs[k][:2]]):
        if batch and rows + len(pairs[k][0]) > MAX_ROWS:
            yield batch
            batch, rows = [], 0
        batch.append(k)
        rows += len(pairs[k][0])
    if batch:
        yield batch


class Noise(NamedTuple):
    """Points are apart by `sigmas` standard deviations of the neighbors within `radius` [m] of both points, at least
    `floor` [m].
    """

    radius: float
    sigmas: float
    floor: float


class OverlapDetails(NamedTuple):
    """Sums of pairs, float64 (pairs, k).

    `visible`: as `plain` of OverlapSums, without points beyond the border of the other surface; `rest`: without points
    on the dominant planes, too. `reliefs`: number of matches on these planes, covariance of the slopes of both surfaces
    relative to the planes, and their variances, as sums. Slopes of the same uneven ground are correlated, those of two
    flat walls are noise. `deviating`: number of pairs of points with agreeing normals, and of those apart along the
    normal.
    """

    visible: np.ndarray
    rest: np.ndarray
    reliefs: np.ndarray
    deviating: np.ndarray


class OverlapSums(NamedTuple):
    """Sums of pairs, float64 (pairs, 46), and their details. Columns: upper triangles of two normal matrices, then
    counts at NEAR_AT, AGREEING_AT, MATCHED_AT and ALIGNED_AT (matches in the directions of removed planes). `beside` is
    without the points on the dominant planes.
    """

    plain: np.ndarray
    beside: np.ndarray | None
    details: OverlapDetails | None


def weigh_overlaps(
    pairs: Sequence[Pair],
    distance: float,
    near: float,
    cosine: float,
    tight: float,
    *,
    beside_planes: bool = False,
    noise: Noise | None = None,
) -> OverlapSums:
    """Evidence for (source, target, pose) triples about the clouds' origins, with `details` for given `noise` limits.
    `distance` [m] and `cosine` limit matches, `near` [m] the overlap, `tight` [m] the distance along the normal.
    Nearest points are searched once. One sync for MAX_ROWS points.
    """
    orders, rows = [], []
    for batch in _batches(pairs):
        overlaps = Overlaps([pairs[k] for k in batch], distance, near, cosine, tight)
        sums = [overlaps.weigh()]
        if beside_planes or noise is not None:
            planes = overlaps.find_planes()
            sums += [overlaps.weigh_beside(planes)] if beside_planes else []
            sums += overlaps.weigh_details(planes, noise) if noise is not None else []
        orders += batch
        rows.append(read_together(sums))  # sync
    joined = [np.concatenate(parts)[np.argsort(orders)] for parts in zip(*rows, strict=True)]
    joined = joined or [np.empty((0, len(evidence_sums(0.0))))] * 6
    details = None if noise is None else OverlapDetails(*joined[-4:])
    return OverlapSums(joined[0], joined[1] if beside_planes else None, details)
