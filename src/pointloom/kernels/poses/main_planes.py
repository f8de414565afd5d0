"""Dominant planes of a surface, such as floors and walls: sequential plane extraction without random sampling.

A subset of points (voters) proposes tangent planes. The plane with most inliers is fitted, its inliers are removed, and
so on, as in Schnabel, Wahl and Klein 2007 ("Efficient RANSAC for point-cloud shape detection"). No sync.
"""

import numpy as np

from ..algebra.eigen import smallest_eigenvector
from ..algebra.moments import add_difference, moments
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Device, LongIntegers, Mask, Points, Vectors
from ..arrays.lanes import sum_int_of_lanes
from ..arrays.packed_keys import NO_KEY, key_index, pack_bits
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import count_mask_kernel
from ..lang import (
    WARP,
    array,
    atomic_min,
    dot,
    float64,
    func,
    int32,
    int64,
    kernel,
    lane,
    launch,
    mat33d,
    outer,
    reduce,
    reduction,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..memory import download, empty, host_view, upload, zeros
from ..search.nearest_point import NO_POINT

MAX_VOTERS, MAX_PROPOSALS = 2048, 256  # maxima, evenly spaced: a dominant plane has 10 % of the voters
PARALLEL_COSINE = 0.95  # 18 degrees: cosine between a plane normal and its points' normals
FIT_STEPS = 2  # of the plane to its inliers: the first normal comes from a few voxels
MIN_POINTS = 5  # points of a plane


VOTERS_AT, STEP_AT, DONE_AT = 0, 1, 2  # indices in `sizes`


@struct
class MainPlanes:
    """Planes, largest first: `middles`, `directions` vec3 (room); `count` int32 (1)."""

    middles: array(dtype=vec3)
    directions: array(dtype=vec3)
    count: array(dtype=int32)

    def __init__(self, room: int, device: Device) -> None:
        self.middles, self.directions = empty(room, vec3, device), empty(room, vec3, device)
        self.count = zeros(1, int32, device)

    @classmethod
    def of(cls, middles: np.ndarray, directions: np.ndarray, device: Device) -> "MainPlanes":
        planes = cls.__new__(cls)
        planes.middles, planes.directions = upload(middles, vec3, device), upload(directions, vec3, device)
        planes.count = upload(np.array([len(middles)]), int32, device)
        return planes

    def read(self) -> tuple[np.ndarray, np.ndarray]:
        """Point and normal of each plane, float32 (k, 3) on the host. Three syncs."""
        count = int(download(self.count)[0])
        return download(self.middles)[:count], download(self.directions)[:count]


@struct
class Voters:
    """Subset of points and the current plane (`point`, `normal`). `normals`, zero once assigned; `firsts`: original
    normals; `sizes`: voter count, proposal step, 1 when finished; `best`: non-inliers, above the proposal.
    """

    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    firsts: array(dtype=vec3)
    sizes: array(dtype=int32)
    best: array(dtype=int64)
    point: array(dtype=vec3d)
    normal: array(dtype=vec3d)

    def __init__(self, device: Device) -> None:
        self.points, self.normals, self.firsts = (empty(MAX_VOTERS, vec3, device) for _ in range(3))
        self.sizes, self.best = empty(3, int32, device), empty(1, int64, device)
        self.point, self.normal = empty(1, vec3d, device), empty(1, vec3d, device)


@kernel
def choose_voters_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), ranks: array(dtype=int32), voters: Voters
):
    """Choose evenly spaced flagged points as voters. Ranks are prefix sums of the flags."""
    i = tid()
    total = ranks[ranks.shape[0] - 1]
    step = max(1, (total + MAX_VOTERS - 1) // MAX_VOTERS)
    before = 0
    if i > 0:
        before = ranks[i - 1]
    if ranks[i] > before and before % step == 0:
        at = before // step
        voters.points[at] = points[i]
        voters.normals[at] = normals[i]
        voters.firsts[at] = normals[i]
    if i == 0:
        count = (total + step - 1) // step
        voters.sizes[VOTERS_AT] = count
        voters.sizes[STEP_AT] = max(1, (count + MAX_PROPOSALS - 1) // MAX_PROPOSALS)
        voters.sizes[DONE_AT] = 1 if total == 0 else 0
        voters.best[0] = int64(NO_KEY)


@func
def offer_plane(proposal: int, inliers: int, voters: Voters):
    """Keep the proposal with most inliers, the first of equal ones. Minimum: order-independent."""
    atomic_min(voters.best, 0, pack_bits(MAX_VOTERS - inliers, proposal))


@func
def is_inlier(j: int, p: vec3, n: vec3, voters: Voters, slab: float, cosine: float) -> int:
    is_near = 0
    if abs(dot(n, voters.normals[j])) > cosine:
        if abs(dot(n, voters.points[j] - p)) < slab:
            is_near = 1
    return is_near


@kernel
def count_coplanar_kernel(voters: Voters, slab: float, cosine: float):
    """Count the inliers of the plane of every step-th voter and keep the best plane."""
    i = tid()
    at = i * voters.sizes[STEP_AT]
    if at < voters.sizes[VOTERS_AT] and voters.sizes[DONE_AT] == 0:
        p = voters.points[at]
        n = voters.normals[at]
        total = 0
        for j in range(voters.sizes[VOTERS_AT]):
            total += is_inlier(j, p, n, voters, slab, cosine)
        offer_plane(i, total, voters)


@count_coplanar_kernel.on_cuda
def count_coplanar_in_lanes_kernel(voters: Voters, slab: float, cosine: float):
    """CUDA variant: a warp per proposal, a lane per voter."""
    i = tid()
    at = i // WARP * voters.sizes[STEP_AT]
    if at < voters.sizes[VOTERS_AT] and voters.sizes[DONE_AT] == 0:
        p = voters.points[at]
        n = voters.normals[at]
        total = 0
        for step in range((voters.sizes[VOTERS_AT] + WARP - 1) // WARP):
            j = step * WARP + lane()
            if j < voters.sizes[VOTERS_AT]:
                total += is_inlier(j, p, n, voters, slab, cosine)
        total = sum_int_of_lanes(total)
        if lane() == 0:
            offer_plane(i // WARP, total, voters)


@kernel
def choose_plane_kernel(voters: Voters):
    """Select the plane with most inliers, and clear the choice for the next one. One thread."""
    i = tid()
    if voters.sizes[DONE_AT] == 0:
        best = key_index(voters.best[i]) * voters.sizes[STEP_AT]
        voters.point[i] = widen(voters.points[best])
        voters.normal[i] = widen(voters.firsts[best])
        voters.best[i] = int64(NO_KEY)


@func
def is_coplanar(i: int, voters: Voters, slab: float, cosine: float) -> int:
    is_near = 0
    if i < voters.sizes[VOTERS_AT] and voters.sizes[DONE_AT] == 0:
        is_near = is_inlier(i, narrow(voters.point[0]), narrow(voters.normal[0]), voters, slab, cosine)
    return is_near


@reduction
def sum_coplanar(voters: Voters, slab: float, cosine: float) -> moments:
    i = tid()
    total = moments(0.0)
    if is_coplanar(i, voters, slab, cosine) == 1:
        total = add_difference(total, narrow(voters.point[0]), voters.points[i])
    return total


@kernel
def fit_plane_kernel(sums: array(dtype=moments), is_last: int, voters: Voters, planes: MainPlanes):
    """Fit the plane to its inliers. Store it in the last step if there are enough. One thread."""
    i = tid()
    m = sums[i]
    if m[0] < float64(MIN_POINTS):
        voters.sizes[DONE_AT] = 1
    if voters.sizes[DONE_AT] == 0:
        c = m[0]
        mean = vec3d(m[1] / c, m[2] / c, m[3] / c)
        xy = m[5] / c
        xz = m[6] / c
        yz = m[8] / c
        squares = mat33d(m[4] / c, xy, xz, xy, m[7] / c, yz, xz, yz, m[9] / c)
        p = voters.point[i] + mean
        n = smallest_eigenvector(squares - outer(mean, mean))
        voters.point[i] = p
        voters.normal[i] = n
        if is_last == 1:
            at = planes.count[0]
            planes.middles[at] = narrow(p)
            planes.directions[at] = narrow(n)
            planes.count[0] = at + 1


@kernel
def silence_coplanar_kernel(voters: Voters, slab: float, cosine: float):
    """Zero the normals of the inliers, which removes them."""
    i = tid()
    if is_coplanar(i, voters, slab, cosine) == 1:
        voters.normals[i] = vec3(0.0, 0.0, 0.0)


@kernel
def leave_out_planes_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    planes: MainPlanes,
    slab: float,
    cosine: float,
    edge: float,
    nearest: array(dtype=int64),
):
    """Clear the nearest point of points on planes and near plane intersections (edges belong to the planes)."""
    i = tid()
    p = points[i]
    left_out = 0
    for k in range(planes.count[0]):
        n = planes.directions[k]
        height = abs(dot(n, p - planes.middles[k]))
        if height < slab and abs(dot(n, normals[i])) > cosine:
            left_out = 1
        if height < edge:
            for j in range(k):
                m = planes.directions[j]
                if abs(dot(n, m)) < cosine and abs(dot(m, p - planes.middles[j])) < edge:
                    left_out = 1
    if left_out == 1:
        nearest[i] = int64(NO_POINT)


def find_main_planes(
    points: Points, normals: Vectors, mask: Mask, plane_count: int, tight: float, slab: float, cosine: float
) -> MainPlanes:
    """Dominant planes of the points in `mask`, largest first, deterministic; `tight` [m]: inlier distance."""
    device = points.device
    planes = MainPlanes(plane_count, device)
    if not points.size:
        return planes
    voters = Voters(device)
    launch(choose_voters_kernel, points.size, [points, normals, _ranks_of(mask), voters])
    for _ in range(plane_count):
        launch(count_coplanar_kernel, MAX_PROPOSALS * (WARP if device.is_cuda else 1), [voters, tight, PARALLEL_COSINE])
        launch(choose_plane_kernel, 1, [voters])
        for step in range(FIT_STEPS):
            sums = reduce(sum_coplanar, MAX_VOTERS, [voters, tight, PARALLEL_COSINE])
            launch(fit_plane_kernel, 1, [sums, int(step == FIT_STEPS - 1), voters, planes])
        launch(silence_coplanar_kernel, MAX_VOTERS, [voters, slab, cosine])
    return planes


def _ranks_of(mask: Mask) -> Array1[int32]:
    ranks = empty(mask.size, int32, mask.device)
    if mask.device.is_cuda:
        launch(count_mask_kernel, mask.size, [mask, ranks])
        inclusive_scan(ranks, ranks)
    else:
        np.cumsum(host_view(mask) != 0, out=host_view(ranks), dtype=np.int32)
    return ranks


def leave_out_planes(
    points: Points, normals: Vectors, planes: MainPlanes, slab: float, cosine: float, edge: float, nearest: LongIntegers
) -> None:
    """Set `nearest` to NO_POINT for points within `slab` [m] of planes, or `edge` [m] of two intersecting ones."""
    launch(leave_out_planes_kernel, points.size, [points, normals, planes, slab, cosine, edge, nearest])
