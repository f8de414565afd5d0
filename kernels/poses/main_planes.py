"""The planes that most of a surface's points lie on: what floors and walls of any two rooms have in common.

Some points propose the plane through them; each counts the points that lie on it, and the plane of most is fitted to
those. Then its points count no more, and the next is looked for: the order of Schnabel, Wahl and Klein 2007 ("Efficient
RANSAC for point-cloud shape detection"), without drawing lots.

One thread a plane reads 24 B a voter, 12 operations each: VOTERS x PLANES, whatever the number of points.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.moments import add_difference, moments
from ..array_types import Indices, LongIntegers, Points, Vectors
from ..arrays.select import gather_rows
from ..lang import array, dot, int32, int64, kernel, launch, reduce, reduction, tid, vec3
from ..memory import contiguous, download, empty, upload
from ..search.nearest_point import NO_POINT

VOTERS, PLANES = 2048, 256  # at most, evenly spread: a plane that matters has a tenth of the voters
PARALLEL = 0.95  # 18 degrees: cosine between the normals of a plane and of a point that it is fitted to
FIT_STEPS = 2  # of the plane to the points on it: the first normal is that of a few voxels
FEWEST = 5  # points that make a plane


@kernel
def count_coplanar_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    count: int,
    step: int,
    slab: float,
    cosine: float,
    counts: array(dtype=int32),
):
    """How many points lie on the plane through every step-th of them; points with a normal of zero on none."""
    i = tid()
    p = points[i * step]
    n = normals[i * step]
    total = 0
    for j in range(count):
        if abs(dot(n, normals[j])) > cosine:
            if abs(dot(n, points[j] - p)) < slab:
                total += 1
    counts[i] = total


@reduction
def sum_coplanar(
    points: array(dtype=vec3), normals: array(dtype=vec3), p: vec3, n: vec3, slab: float, cosine: float
) -> moments:
    """Moments about p of the points on the plane through it."""
    i = tid()
    total = moments(0.0)
    if abs(dot(n, normals[i])) > cosine:
        if abs(dot(n, points[i] - p)) < slab:
            total = add_difference(total, p, points[i])
    return total


@kernel
def silence_coplanar_kernel(
    points: array(dtype=vec3), p: vec3, n: vec3, slab: float, cosine: float, normals: array(dtype=vec3)
):
    """Take the normal from points on a plane: they lie on no other."""
    i = tid()
    if abs(dot(n, normals[i])) > cosine:
        if abs(dot(n, points[i] - p)) < slab:
            normals[i] = vec3(0.0, 0.0, 0.0)


@kernel
def leave_out_planes_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    middles: array(dtype=vec3),
    directions: array(dtype=vec3),
    plane_count: int,
    slab: float,
    cosine: float,
    edge: float,
    nearest: array(dtype=int64),
):
    """Take the nearest point from points on a plane, and from those where two cross: edges are no more than planes."""
    i = tid()
    p = points[i]
    left_out = 0
    for k in range(plane_count):
        n = directions[k]
        height = abs(dot(n, p - middles[k]))
        if height < slab and abs(dot(n, normals[i])) > cosine:
            left_out = 1
        if height < edge:
            for j in range(k):
                if abs(dot(n, directions[j])) < cosine and abs(dot(directions[j], p - middles[j])) < edge:
                    left_out = 1
    if left_out == 1:
        nearest[i] = int64(NO_POINT)


def find_main_planes(
    points: Points, normals: Vectors, rows: Indices, plane_count: int, tight: float, slab: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """The planes that most of some points lie on, the largest first.

    Args:
        points, normals: Device arrays of vec3 [n].
        rows: int32 device array: which of them count.
        plane_count: Planes at most.
        tight: Distance [m] from a plane within which points count for it.
        slab: Distance [m] within which points that look its way count for no other plane.
        cosine: Least of the angle between its normal and theirs.

    Returns:
        A point of each plane and its normal, float32 [k, 3] each on the host; fewer where no more have five points.
        Three syncs a plane. The same bits from run to run.
    """
    if not rows.size:
        return _stacked([])
    voters = contiguous(rows[:: max(1, -(-rows.size // VOTERS))])
    places, ways = gather_rows(points, voters), gather_rows(normals, voters)
    step = max(1, -(-voters.size // PLANES))
    counts = empty(-(-voters.size // step), int32, points.device)
    starts = [download(values)[::step].astype(np.float64) for values in (places, ways)]  # sync
    found = []
    for _ in range(plane_count):
        launch(count_coplanar_kernel, counts.size, [places, ways, voters.size, step, tight, PARALLEL, counts])
        best = int(download(counts).argmax())  # sync
        p, n = starts[0][best], starts[1][best]
        for _ in range(FIT_STEPS):
            arguments = [places, ways, vec3(*p.tolist()), vec3(*n.tolist()), tight, PARALLEL]
            m = download(reduce(sum_coplanar, voters.size, arguments))[0]  # sync
            if m[0] < FEWEST:
                return _stacked(found)
            mean = m[1:4] / m[0]
            squares = np.array([[m[4], m[5], m[6]], [m[5], m[7], m[8]], [m[6], m[8], m[9]]]) / m[0]
            p, n = p + mean, np.linalg.eigh(squares - np.outer(mean, mean))[1][:, 0]
        found.append((p, n))
        plane = [vec3(*p.tolist()), vec3(*n.tolist())]
        launch(silence_coplanar_kernel, voters.size, [places, *plane, slab, cosine, ways])
    return _stacked(found)


def leave_out_planes(
    points: Points,
    normals: Vectors,
    planes: tuple[np.ndarray, np.ndarray],
    slab: float,
    cosine: float,
    edge: float,
    nearest: LongIntegers,
) -> None:
    """Take the nearest point from those that lie on planes as `find_main_planes` gives them.

    Args:
        points, normals: Device arrays of vec3 [n].
        planes: A point of each plane and its normal, float32 [k, 3] each.
        slab, cosine: Of the points on a plane [m].
        edge: Distance [m] from two planes that cross within which points belong to neither alone. Planes cross whose
            normals are apart by more than those of a plane and its points: layers of hills have no edges.
        nearest: int64 device array [n] of keys, changed: NO_POINT at those points.
    """
    middles, directions = (upload(values, vec3, points.device) for values in planes)
    arguments = [points, normals, middles, directions, len(planes[0]), slab, cosine, edge, nearest]
    launch(leave_out_planes_kernel, points.size, arguments)


def _stacked(planes: Sequence[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Points and normals of planes, float32 [k, 3] each."""
    both = np.array(planes, np.float32).reshape(-1, 2, 3)
    return np.ascontiguousarray(both[:, 0]), np.ascontiguousarray(both[:, 1])
