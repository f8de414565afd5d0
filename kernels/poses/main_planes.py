"""The planes that most of a surface's points lie on: what floors and walls of any two rooms have in common.

Some points propose the plane through them; each counts the points that lie on it, and the plane of most is fitted to
those. Then its points count no more, and the next is looked for: the order of Schnabel, Wahl and Klein 2007 ("Efficient
RANSAC for point-cloud shape detection"), without drawing lots.

One thread a plane reads 24 B a voter, 12 operations each: VOTERS x PLANES, whatever the number of points. Nothing goes
to the host: some ten launches a plane, over as many voters as there could be.
"""

import numpy as np

from ..algebra.eigen import smallest_eigenvector
from ..algebra.moments import add_difference, moments
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Device, LongIntegers, Mask, Points, Vectors
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import count_mask_kernel
from ..lang import (
    array,
    dot,
    float64,
    func,
    int32,
    int64,
    kernel,
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

VOTERS, PLANES = 2048, 256  # at most, evenly spread: a plane that matters has a tenth of the voters
PARALLEL = 0.95  # 18 degrees: cosine between the normals of a plane and of a point that it is fitted to
FIT_STEPS = 2  # of the plane to the points on it: the first normal is that of a few voxels
FEWEST = 5  # points that make a plane


VOTERS_AT, STEP_AT, DONE_AT = 0, 1, 2  # of the voters' sizes


@struct
class MainPlanes:
    """Planes, the largest first.

    Attributes:
        middles, directions: A point of each and its normal, vec3 [room].
        count: int32 [1], how many there are.
    """

    middles: array(dtype=vec3)
    directions: array(dtype=vec3)
    count: array(dtype=int32)

    def __init__(self, room: int, device: Device) -> None:
        """None yet, and room for some."""
        self.middles, self.directions = empty(room, vec3, device), empty(room, vec3, device)
        self.count = zeros(1, int32, device)

    @classmethod
    def of(cls, middles: np.ndarray, directions: np.ndarray, device: Device) -> "MainPlanes":
        """Planes given by arrays [k, 3]."""
        planes = cls.__new__(cls)
        planes.middles, planes.directions = upload(middles, vec3, device), upload(directions, vec3, device)
        planes.count = upload(np.array([len(middles)]), int32, device)
        return planes

    def read(self) -> tuple[np.ndarray, np.ndarray]:
        """A point of each plane and its normal, float32 [k, 3] each on the host. Three syncs."""
        count = int(download(self.count)[0])
        return download(self.middles)[:count], download(self.directions)[:count]


@struct
class Voters:
    """Points that stand for all, and the plane that is being fitted to them.

    Attributes:
        places, ways: Of each its place and its normal, zero once it lies on a plane.
        firsts: The normals as they were.
        sizes: int32 [3]: how many voters there are; every so-many-th proposes a plane; 1 once no more are found.
        counts: int32 [PLANES], the voters on each proposed plane.
        place, way: vec3d [1], a point of the plane that is being fitted, and its normal.
    """

    places: array(dtype=vec3)
    ways: array(dtype=vec3)
    firsts: array(dtype=vec3)
    sizes: array(dtype=int32)
    counts: array(dtype=int32)
    place: array(dtype=vec3d)
    way: array(dtype=vec3d)

    def __init__(self, device: Device) -> None:
        self.places, self.ways, self.firsts = (empty(VOTERS, vec3, device) for _ in range(3))
        self.sizes, self.counts = empty(3, int32, device), empty(PLANES, int32, device)
        self.place, self.way = empty(1, vec3d, device), empty(1, vec3d, device)


@kernel
def choose_voters_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), ranks: array(dtype=int32), voters: Voters
):
    """Every so-many-th of the marked points, so that VOTERS suffice; ranks are the sums of the marks."""
    i = tid()
    total = ranks[ranks.shape[0] - 1]
    step = max(1, (total + VOTERS - 1) // VOTERS)
    before = 0
    if i > 0:
        before = ranks[i - 1]
    if ranks[i] > before and before % step == 0:
        at = before // step
        voters.places[at] = points[i]
        voters.ways[at] = normals[i]
        voters.firsts[at] = normals[i]
    if i == 0:
        count = (total + step - 1) // step
        voters.sizes[VOTERS_AT] = count
        voters.sizes[STEP_AT] = max(1, (count + PLANES - 1) // PLANES)
        voters.sizes[DONE_AT] = 1 if total == 0 else 0


@kernel
def count_coplanar_kernel(voters: Voters, slab: float, cosine: float):
    """How many voters lie on the plane through every step-th of them; those with a normal of zero on none."""
    i = tid()
    at = i * voters.sizes[STEP_AT]
    total = -1
    if at < voters.sizes[VOTERS_AT] and voters.sizes[DONE_AT] == 0:
        p = voters.places[at]
        n = voters.ways[at]
        total = 0
        for j in range(voters.sizes[VOTERS_AT]):
            if abs(dot(n, voters.ways[j])) > cosine:
                if abs(dot(n, voters.places[j] - p)) < slab:
                    total += 1
    voters.counts[i] = total


@kernel
def choose_plane_kernel(voters: Voters):
    """The plane of most voters, the first of equal ones. One thread."""
    i = tid()
    best = int(0)
    for k in range(PLANES):
        if voters.counts[k] > voters.counts[best]:
            best = k
    if voters.sizes[DONE_AT] == 0:
        voters.place[i] = widen(voters.places[best * voters.sizes[STEP_AT]])
        voters.way[i] = widen(voters.firsts[best * voters.sizes[STEP_AT]])


@func
def is_coplanar(i: int, voters: Voters, slab: float, cosine: float) -> int:
    """Whether a voter lies on the plane that is being fitted."""
    found = 0
    if i < voters.sizes[VOTERS_AT] and voters.sizes[DONE_AT] == 0:
        n = narrow(voters.way[0])
        if abs(dot(n, voters.ways[i])) > cosine:
            if abs(dot(n, voters.places[i] - narrow(voters.place[0]))) < slab:
                found = 1
    return found


@reduction
def sum_coplanar(voters: Voters, slab: float, cosine: float) -> moments:
    """Moments about the plane's point of the voters on it."""
    i = tid()
    total = moments(0.0)
    if is_coplanar(i, voters, slab, cosine) == 1:
        total = add_difference(total, narrow(voters.place[0]), voters.places[i])
    return total


@kernel
def fit_plane_kernel(sums: array(dtype=moments), is_last: int, voters: Voters, planes: MainPlanes):
    """The plane of the voters on it, and keep it where that is the last step; none where they are too few. One
    thread."""
    i = tid()
    m = sums[i]
    if m[0] < float64(FEWEST):
        voters.sizes[DONE_AT] = 1
    if voters.sizes[DONE_AT] == 0:
        c = m[0]
        mean = vec3d(m[1] / c, m[2] / c, m[3] / c)
        xy = m[5] / c
        xz = m[6] / c
        yz = m[8] / c
        squares = mat33d(m[4] / c, xy, xz, xy, m[7] / c, yz, xz, yz, m[9] / c)
        p = voters.place[i] + mean
        n = smallest_eigenvector(squares - outer(mean, mean))
        voters.place[i] = p
        voters.way[i] = n
        if is_last == 1:
            at = planes.count[0]
            planes.middles[at] = narrow(p)
            planes.directions[at] = narrow(n)
            planes.count[0] = at + 1


@kernel
def silence_coplanar_kernel(voters: Voters, slab: float, cosine: float):
    """Take the normal from voters on the plane: they lie on no other."""
    i = tid()
    if is_coplanar(i, voters, slab, cosine) == 1:
        voters.ways[i] = vec3(0.0, 0.0, 0.0)


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
    """Take the nearest point from points on planes, and from those where two cross: edges are no more than planes."""
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
    """The planes that most of some points lie on, the largest first.

    Args:
        points, normals: Device arrays of vec3 [n].
        mask: uint8 device array [n]: which of them count.
        plane_count: Planes at most.
        tight: Distance [m] from a plane within which points count for it.
        slab: Distance [m] within which points that look its way count for no other plane.
        cosine: Least of the angle between its normal and theirs.

    Returns:
        The planes, fewer where no more have five points. The same bits from run to run.
    """
    device = points.device
    planes = MainPlanes(plane_count, device)
    if not points.size:
        return planes
    voters = Voters(device)
    launch(choose_voters_kernel, points.size, [points, normals, _ranks_of(mask), voters])
    for _ in range(plane_count):
        launch(count_coplanar_kernel, PLANES, [voters, tight, PARALLEL])
        launch(choose_plane_kernel, 1, [voters])
        for step in range(FIT_STEPS):
            sums = reduce(sum_coplanar, VOTERS, [voters, tight, PARALLEL])
            launch(fit_plane_kernel, 1, [sums, int(step == FIT_STEPS - 1), voters, planes])
        launch(silence_coplanar_kernel, VOTERS, [voters, slab, cosine])
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
    """Take the nearest point from those that lie on planes.

    Args:
        points, normals: Device arrays of vec3 [n].
        planes: The planes.
        slab, cosine: Of the points on a plane [m].
        edge: Distance [m] from two planes that cross within which points belong to neither alone. Planes cross whose
            normals are apart by more than those of a plane and its points: layers of hills have no edges.
        nearest: int64 device array [n] of keys, changed: NO_POINT at those points.
    """
    launch(leave_out_planes_kernel, points.size, [points, normals, planes, slab, cosine, edge, nearest])
