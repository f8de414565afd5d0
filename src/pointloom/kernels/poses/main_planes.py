"""Dominant planes of a surface, such as floors and walls: sequential plane extraction without random sampling.

A subset of points (voters) proposes tangent planes. The plane with most inliers is fitted, its inliers are removed, and
so on, as in Schnabel, Wahl and Klein 2007 ("Efficient RANSAC for point-cloud shape detection"). No sync.
"""

import numpy as np

from ..algebra.eigen import smallest_eigenvector
from ..algebra.moments import add_difference, moments
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Device, Indices, LongIntegers, Mask, Points, Vectors
from ..arrays.blocks import WARPS, block_threads, wait_for_block
from ..arrays.lanes import sum_int_of_lanes
from ..arrays.packed_keys import NO_KEY, key_index, pack_bits
from ..arrays.prefix_sum import find_owner, inclusive_scan
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import count_mask_kernel
from ..lang import (
    BLOCK_THREADS,
    WARP,
    array,
    atomic_min,
    cuda_func,
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
    reduce_segments,
    segment_reduction,
    shuffle_xor,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..memory import download, empty, full, host_view, upload, zeros
from ..search.nearest_point import NO_POINT

MAX_VOTERS, MAX_PROPOSALS = 2048, 256  # maxima, evenly spaced: a dominant plane has 10 % of the voters
PARALLEL_COSINE = 0.95  # 18 degrees: cosine between a plane normal and its points' normals
FIT_STEPS = 2  # of the plane to its inliers: the first normal comes from a few voxels
MIN_POINTS = 5  # points of a plane
MOMENTS = 10  # numbers of `moments`
CHUNKS = MAX_VOTERS // BLOCK_THREADS  # voters of a thread

VOTERS_AT, STEP_AT, DONE_AT = 0, 1, 2  # columns of `sizes`


@struct
class MainPlanes:
    """Planes of surfaces, largest first: `middles`, `directions` vec3 (surfaces, room); `count` int32 (surfaces)."""

    middles: array(dtype=vec3, ndim=2)
    directions: array(dtype=vec3, ndim=2)
    count: array(dtype=int32)

    def __init__(self, surfaces: int, room: int, device: Device) -> None:
        self.middles, self.directions = (empty((surfaces, room), vec3, device) for _ in range(2))
        self.count = zeros(surfaces, int32, device)

    @classmethod
    def of(cls, middles: np.ndarray, directions: np.ndarray, device: Device) -> "MainPlanes":
        """The planes of one surface."""
        planes = cls.__new__(cls)
        planes.middles, planes.directions = upload(middles[None], vec3, device), upload(directions[None], vec3, device)
        planes.count = upload(np.array([len(middles)]), int32, device)
        return planes

    def read(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Point and normal of each plane of each surface, float32 (k, 3) on the host. Three syncs."""
        middles, directions = download(self.middles), download(self.directions)
        return [(m[:k], n[:k]) for m, n, k in zip(middles, directions, download(self.count).tolist(), strict=True)]


@struct
class Voters:
    """Subset of the points of each surface and its current plane (`point`, `normal`). `normals`, zero once assigned;
    `firsts`: original normals; `sizes`: voter count, proposal step, 1 when finished; `best`: non-inliers, above the
    proposal; `partials`, `sums`: scratch of sums by a block.
    """

    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    firsts: array(dtype=vec3)
    sizes: array(dtype=int32, ndim=2)
    best: array(dtype=int64)
    point: array(dtype=vec3d)
    normal: array(dtype=vec3d)
    partials: array(dtype=float64)
    sums: array(dtype=float64, ndim=2)

    def __init__(self, surfaces: int, device: Device) -> None:
        self.points, self.normals, self.firsts = (empty(surfaces * MAX_VOTERS, vec3, device) for _ in range(3))
        self.sizes, self.best = empty((surfaces, 3), int32, device), empty(surfaces, int64, device)
        self.point, self.normal = empty(surfaces, vec3d, device), empty(surfaces, vec3d, device)
        partials = surfaces * CHUNKS * WARPS * MOMENTS if device.is_cuda else 0
        self.partials, self.sums = empty(partials, float64, device), empty((surfaces, MOMENTS), float64, device)


@kernel
def choose_voters_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    ranks: array(dtype=int32),
    starts: array(dtype=int32),
    voters: Voters,
):
    """Choose evenly spaced flagged points of each surface as voters. Ranks are prefix sums of the flags, `starts` the
    first points of the surfaces and the count. A thread per point, then one per surface."""
    i = tid()
    surface = i - points.shape[0]
    if surface < 0:
        surface = find_owner(starts, i)
    first = 0
    last = 0
    if starts[surface] > 0:
        first = ranks[starts[surface] - 1]
    if starts[surface + 1] > 0:
        last = ranks[starts[surface + 1] - 1]
    step = max(1, (last - first + MAX_VOTERS - 1) // MAX_VOTERS)
    if i < points.shape[0]:
        before = 0
        if i > 0:
            before = ranks[i - 1]
        if ranks[i] > before and (before - first) % step == 0:
            at = surface * MAX_VOTERS + (before - first) // step
            voters.points[at] = points[i]
            voters.normals[at] = normals[i]
            voters.firsts[at] = normals[i]
    else:
        count = (last - first + step - 1) // step
        voters.sizes[surface, VOTERS_AT] = count
        voters.sizes[surface, STEP_AT] = max(1, (count + MAX_PROPOSALS - 1) // MAX_PROPOSALS)
        voters.sizes[surface, DONE_AT] = 1 if count == 0 else 0
        voters.best[surface] = int64(NO_KEY)


@func
def offer_plane(surface: int, proposal: int, inliers: int, voters: Voters):
    """Keep the proposal with most inliers, the first of equal ones. Minimum: order-independent."""
    atomic_min(voters.best, surface, pack_bits(MAX_VOTERS - inliers, proposal))


@func
def is_inlier(j: int, p: vec3, n: vec3, voters: Voters, slab: float, cosine: float) -> int:
    is_near = 0
    if abs(dot(n, voters.normals[j])) > cosine:
        if abs(dot(n, voters.points[j] - p)) < slab:
            is_near = 1
    return is_near


@func
def count_coplanar(surface: int, proposal: int, voters: Voters, slab: float, cosine: float):
    """Count the inliers of the plane of a voter, and keep the best plane."""
    at = proposal * voters.sizes[surface, STEP_AT]
    count = voters.sizes[surface, VOTERS_AT]
    if at < count and voters.sizes[surface, DONE_AT] == 0:
        first = surface * MAX_VOTERS
        p = voters.points[first + at]
        n = voters.normals[first + at]
        total = 0
        for j in range(count):
            total += is_inlier(first + j, p, n, voters, slab, cosine)
        offer_plane(surface, proposal, total, voters)


@count_coplanar.on_cuda
def count_coplanar_in_lanes(surface: int, proposal: int, voters: Voters, slab: float, cosine: float):
    """CUDA variant: all lanes of a warp take one proposal, and a lane each 32nd voter."""
    at = proposal * voters.sizes[surface, STEP_AT]
    count = voters.sizes[surface, VOTERS_AT]
    if at < count and voters.sizes[surface, DONE_AT] == 0:
        first = surface * MAX_VOTERS
        p = voters.points[first + at]
        n = voters.normals[first + at]
        total = 0
        for step in range((count + WARP - 1) // WARP):
            j = step * WARP + lane()
            if j < count:
                total += is_inlier(first + j, p, n, voters, slab, cosine)
        total = sum_int_of_lanes(total)
        if lane() == 0:
            offer_plane(surface, proposal, total, voters)


@kernel(for_cpu=True)
def count_coplanar_kernel(voters: Voters, slab: float, cosine: float):
    i = tid()
    count_coplanar(i // MAX_PROPOSALS, i % MAX_PROPOSALS, voters, slab, cosine)


@func
def choose_plane(surface: int, voters: Voters):
    """Select the plane with most inliers, and clear the choice for the next one."""
    if voters.sizes[surface, DONE_AT] == 0:
        best = surface * MAX_VOTERS + key_index(voters.best[surface]) * voters.sizes[surface, STEP_AT]
        voters.point[surface] = widen(voters.points[best])
        voters.normal[surface] = widen(voters.firsts[best])
        voters.best[surface] = int64(NO_KEY)


@kernel(for_cpu=True)
def choose_plane_kernel(voters: Voters):
    i = tid()
    choose_plane(i, voters)


@func
def is_coplanar(surface: int, j: int, voters: Voters, slab: float, cosine: float) -> int:
    """True if the j-th voter of a surface is an inlier of its plane."""
    is_near = 0
    if j < voters.sizes[surface, VOTERS_AT] and voters.sizes[surface, DONE_AT] == 0:
        p = narrow(voters.point[surface])
        is_near = is_inlier(surface * MAX_VOTERS + j, p, narrow(voters.normal[surface]), voters, slab, cosine)
    return is_near


@func
def moments_of_voter(surface: int, j: int, voters: Voters, slab: float, cosine: float) -> moments:
    total = moments(0.0)
    if is_coplanar(surface, j, voters, slab, cosine) == 1:
        total = add_difference(total, narrow(voters.point[surface]), voters.points[surface * MAX_VOTERS + j])
    return total


@segment_reduction
def sum_coplanar(voters: Voters, slab: float, cosine: float) -> moments:
    i = tid()
    return moments_of_voter(i // MAX_VOTERS, i % MAX_VOTERS, voters, slab, cosine)


@func
def fit_plane(surface: int, m: moments, is_last: int, voters: Voters, planes: MainPlanes):
    """Fit the plane to its inliers. Store it in the last step if there are enough."""
    if m[0] < float64(MIN_POINTS):
        voters.sizes[surface, DONE_AT] = 1
    if voters.sizes[surface, DONE_AT] == 0:
        c = m[0]
        mean = vec3d(m[1] / c, m[2] / c, m[3] / c)
        xy = m[5] / c
        xz = m[6] / c
        yz = m[8] / c
        squares = mat33d(m[4] / c, xy, xz, xy, m[7] / c, yz, xz, yz, m[9] / c)
        p = voters.point[surface] + mean
        n = smallest_eigenvector(squares - outer(mean, mean))
        voters.point[surface] = p
        voters.normal[surface] = n
        if is_last == 1:
            at = planes.count[surface]
            planes.middles[surface, at] = narrow(p)
            planes.directions[surface, at] = narrow(n)
            planes.count[surface] = at + 1


@kernel(for_cpu=True)
def fit_plane_kernel(sums: array(dtype=moments), is_last: int, voters: Voters, planes: MainPlanes):
    i = tid()
    fit_plane(i, sums[i], is_last, voters, planes)


@func
def silence_coplanar(surface: int, j: int, voters: Voters, slab: float, cosine: float):
    """Zero the normal of an inlier, which removes it."""
    if is_coplanar(surface, j, voters, slab, cosine) == 1:
        voters.normals[surface * MAX_VOTERS + j] = vec3(0.0, 0.0, 0.0)


@kernel(for_cpu=True)
def silence_coplanar_kernel(voters: Voters, slab: float, cosine: float):
    i = tid()
    silence_coplanar(i // MAX_VOTERS, i % MAX_VOTERS, voters, slab, cosine)


@cuda_func
def sum_in_order_of_reduce(x: float64) -> float64:
    """Sum over the lanes of a warp in the order of a `reduce` of `moments` (`_sum_of_lanes` of warp_compiler.py)."""
    total = x + shuffle_xor(x, 8)
    total += shuffle_xor(total, 4)
    total += shuffle_xor(total, 2)
    total += shuffle_xor(total, 1)
    total += shuffle_xor(total, 16)
    return total


@func
def sum_voters(surface: int, thread: int, voters: Voters, slab: float, cosine: float):
    """Write the moments of the inliers of a surface to `voters.sums`."""
    total = moments(0.0)
    for j in range(MAX_VOTERS):
        total += moments_of_voter(surface, j, voters, slab, cosine)
    for k in range(MOMENTS):
        voters.sums[surface, k] = total[k]


@sum_voters.on_cuda
def sum_voters_of_block(surface: int, thread: int, voters: Voters, slab: float, cosine: float):
    """CUDA variant: the sums of a `reduce` over the voters, bitwise."""
    n = int(CHUNKS)
    for chunk in range(n):
        m = moments_of_voter(surface, chunk * BLOCK_THREADS + thread, voters, slab, cosine)
        row = ((surface * CHUNKS + chunk) * WARPS + thread // WARP) * MOMENTS
        for k in range(MOMENTS):
            total = sum_in_order_of_reduce(m[k])
            if lane() == 0:
                voters.partials[row + k] = total
    wait_for_block()
    if thread < MOMENTS:
        total = float64(0.0)
        for chunk in range(n):
            row = (surface * CHUNKS + chunk) * WARPS * MOMENTS + thread
            of_chunk = voters.partials[row]
            for warp in range(1, WARPS):
                of_chunk += voters.partials[row + warp * MOMENTS]
            total += of_chunk
        voters.sums[surface, thread] = total


@func
def sums_of(surface: int, voters: Voters) -> moments:
    m = moments(0.0)
    for k in range(MOMENTS):
        m[k] = voters.sums[surface, k]
    return m


@kernel
def extract_planes_kernel(
    threads: int, plane_count: int, tight: float, slab: float, cosine: float, voters: Voters, planes: MainPlanes
):
    """Extract the planes of a surface by a block of `threads`."""
    i = tid()
    surface = i // threads
    thread = i % threads
    warps = (threads + WARP - 1) // WARP
    for _ in range(plane_count):
        for turn in range((MAX_PROPOSALS + warps - 1) // warps):
            count_coplanar(surface, turn * warps + thread // WARP, voters, tight, PARALLEL_COSINE)
        wait_for_block()
        if thread == 0:
            choose_plane(surface, voters)
        wait_for_block()
        for step in range(FIT_STEPS):
            sum_voters(surface, thread, voters, tight, PARALLEL_COSINE)
            wait_for_block()
            if thread == 0:
                fit_plane(surface, sums_of(surface, voters), 1 if step == FIT_STEPS - 1 else 0, voters, planes)
            wait_for_block()
        for turn in range((MAX_VOTERS + threads - 1) // threads):
            silence_coplanar(surface, turn * threads + thread, voters, slab, cosine)
        wait_for_block()


@kernel
def leave_out_planes_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    planes: MainPlanes,
    slab: float,
    cosine: float,
    edge: float,
    nearest: array(dtype=int64),
    starts: array(dtype=int32),
):
    """Clear the nearest point of points on planes and near plane intersections (edges belong to the planes)."""
    i = tid()
    surface = find_owner(starts, i)
    p = points[i]
    left_out = 0
    for k in range(planes.count[surface]):
        n = planes.directions[surface, k]
        height = abs(dot(n, p - planes.middles[surface, k]))
        if height < slab and abs(dot(n, normals[i])) > cosine:
            left_out = 1
        if height < edge:
            for j in range(k):
                m = planes.directions[surface, j]
                if abs(dot(n, m)) < cosine and abs(dot(m, p - planes.middles[surface, j])) < edge:
                    left_out = 1
    if left_out == 1:
        nearest[i] = int64(NO_POINT)


def find_main_planes(
    points: Points,
    normals: Vectors,
    mask: Mask,
    plane_count: int,
    tight: float,
    slab: float,
    cosine: float,
    starts: Indices | None = None,
) -> MainPlanes:
    """Dominant planes of the points in `mask`, largest first, deterministic; `tight` [m]: inlier distance. `starts`:
    first points of consecutive surfaces, and the number of points. None for one surface.
    """
    device = points.device
    starts = upload(np.array([0, points.size]), int32, device) if starts is None else starts
    surfaces = starts.size - 1
    planes = MainPlanes(surfaces, plane_count, device)
    if not points.size:
        return planes
    voters = Voters(surfaces, device)
    launch(choose_voters_kernel, points.size + surfaces, [points, normals, _ranks_of(mask), starts, voters])
    if device.is_cuda:
        threads = block_threads(device)
        launch(extract_planes_kernel, surfaces * threads, [threads, plane_count, tight, slab, cosine, voters, planes])
        return planes
    blocks = SegmentBlocks(np.arange(surfaces) * MAX_VOTERS, np.full(surfaces, MAX_VOTERS), device)
    scratch = [blocks.partials(moments), empty(surfaces, moments, device)]
    live = full(surfaces, 1, int32, device)
    for _ in range(plane_count):
        launch(count_coplanar_kernel, surfaces * MAX_PROPOSALS, [voters, tight, PARALLEL_COSINE])
        launch(choose_plane_kernel, surfaces, [voters])
        for step in range(FIT_STEPS):
            reduce_segments(sum_coplanar, blocks, live, [voters, tight, PARALLEL_COSINE], *scratch)
            launch(fit_plane_kernel, surfaces, [scratch[1], int(step == FIT_STEPS - 1), voters, planes])
        launch(silence_coplanar_kernel, surfaces * MAX_VOTERS, [voters, slab, cosine])
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
    points: Points,
    normals: Vectors,
    planes: MainPlanes,
    slab: float,
    cosine: float,
    edge: float,
    nearest: LongIntegers,
    starts: Indices,
) -> None:
    """Set `nearest` to NO_POINT for points within `slab` [m] of planes of their surface, or `edge` [m] of two
    intersecting ones. `starts`: as of `find_main_planes`.
    """
    launch(leave_out_planes_kernel, points.size, [points, normals, planes, slab, cosine, edge, nearest, starts])
