"""Order-independent ball pivoting: all triangles with an empty ball per radius, then conflict resolution.

At most one triangle may use a directed edge. Each round accepts the triangles that precede, by (circle radius,
vertices), all undecided ones on their directed edges, and rejects those that share one with an accepted triangle. Later
radii process points without a triangle or on boundary edges, and grow from accepted triangles. 100 B per point and
radius, 60 B per half-edge.
"""

from collections.abc import Callable, Iterable

from ..algebra.transform import widen
from ..array_types import Bytes, Indices, Mask, Points, Scalars, Triangles, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.duplicates import first_occurrences, same_point
from ..arrays.select import gather_rows, positions_of, positions_of_each
from ..arrays.sort import argsort_keys, positions
from ..lang import (
    array,
    compute,
    dot,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop_while,
    struct,
    tid,
    uint8,
    vec3,
    vec3i,
)
from ..memory import copy, empty, full, zeros
from ..meshes.mesh_topology import CornersByVertex, corner_vertex, next_corner
from ..search.point_tree import PointTree
from .ball_faces import BallPoints, list_faces

REJECTED_FACE, UNDECIDED_FACE, ACCEPTED_FACE = 0, 1, 2


@kernel
def find_ends_kernel(triangles: array(dtype=vec3i), around: CornersByVertex, ends: array(dtype=int32)):
    i = tid()
    ends[i] = corner_vertex(triangles, next_corner(around.corners[i]))


@struct
class BallMesh:
    """Accepted, undecided and rejected triangles, and the half-edges by start vertex. Triangles of earlier radii come
    first. `ends` follow the order of `around`. `waiting` marks triangles that have nothing to grow from yet,
    `covered` the vertices that had a triangle before this radius. `order` breaks ties between equal circles."""

    triangles: array(dtype=vec3i)
    widths: array(dtype=float32)
    around: CornersByVertex
    ends: array(dtype=int32)
    states: array(dtype=uint8)
    waiting: array(dtype=uint8)
    covered: array(dtype=uint8)
    order: array(dtype=int32)

    def __init__(
        self, accepted: Triangles, candidates: Triangles, widths: Scalars, covered: Bytes, order: Indices
    ) -> None:
        device, count = accepted.device, accepted.size + candidates.size
        self.triangles, self.covered, self.order = concatenate_rows([accepted, candidates]), covered, order
        self.widths = concatenate_rows([zeros(accepted.size, float32, device), widths])
        self.around = CornersByVertex(self.triangles, covered.size)
        self.ends = empty(3 * count, int32, device)
        launch(find_ends_kernel, 3 * count, [self.triangles, self.around, self.ends])
        self.states, self.waiting = full(count, UNDECIDED_FACE, uint8, device), zeros(count, uint8, device)
        copy(self.states, full(accepted.size, ACCEPTED_FACE, uint8, device), count=accepted.size)


@func
def sorted_corners(t: vec3i, order: array(dtype=int32)) -> vec3i:
    a = order[t[0]]
    b = order[t[1]]
    c = order[t[2]]
    low = min(min(a, b), c)
    high = max(max(a, b), c)
    middle = max(min(a, b), min(max(a, b), c))
    return vec3i(low, middle, high)


@func
def comes_before(a: int, b: int, mesh: BallMesh) -> int:
    before = 0
    if mesh.widths[a] < mesh.widths[b]:
        before = 1
    if mesh.widths[a] == mesh.widths[b]:
        p = sorted_corners(mesh.triangles[a], mesh.order)
        q = sorted_corners(mesh.triangles[b], mesh.order)
        if p[0] < q[0] or (p[0] == q[0] and (p[1] < q[1] or (p[1] == q[1] and p[2] < q[2]))):
            before = 1
    return before


@func
def has_accepted_edge(a: int, b: int, mesh: BallMesh) -> int:
    accepted = 0
    for j in range(mesh.around.starts[a], mesh.around.starts[a + 1]):
        if mesh.ends[j] == b:
            if mesh.states[mesh.around.corners[j] // 3] == uint8(ACCEPTED_FACE):
                accepted = 1
    return accepted


@func
def can_grow(t: int, mesh: BallMesh) -> int:
    """1 if a triangle touches a new vertex or an edge with a triangle on its other side only."""
    grows = 0
    for k in range(3):
        a = corner_vertex(mesh.triangles, 3 * t + k)
        b = corner_vertex(mesh.triangles, next_corner(3 * t + k))
        if mesh.covered[a] == 0:
            grows = 1
        else:
            grows = max(grows, has_accepted_edge(b, a, mesh))
    return grows


@kernel
def find_waiting_kernel(undecided: array(dtype=int32), mesh: BallMesh, changed: array(dtype=int32)):
    """Mark triangles that have nothing to grow from yet, and reset `changed`."""
    i = tid()
    if i == 0:
        changed[0] = 0
    t = undecided[i]
    if mesh.states[t] == uint8(UNDECIDED_FACE):
        mesh.waiting[t] = uint8(1 - can_grow(t, mesh))


@kernel
def decide_kernel(undecided: array(dtype=int32), mesh: BallMesh, decided: array(dtype=uint8)):
    i = tid()
    t = undecided[i]
    state = int(ACCEPTED_FACE)
    if mesh.waiting[t] == 1:
        state = UNDECIDED_FACE
    sides = int(3)
    if mesh.states[t] != uint8(UNDECIDED_FACE):
        state = int(mesh.states[t])
        sides = 0
    for k in range(sides):
        a = corner_vertex(mesh.triangles, 3 * t + k)
        b = corner_vertex(mesh.triangles, next_corner(3 * t + k))
        for j in range(mesh.around.starts[a], mesh.around.starts[a + 1]):
            other = mesh.around.corners[j] // 3
            if mesh.ends[j] == b and other != t:
                rival = int(mesh.states[other])
                if rival == ACCEPTED_FACE:
                    state = REJECTED_FACE
                elif rival == UNDECIDED_FACE and state == ACCEPTED_FACE and mesh.waiting[other] == 0:
                    if comes_before(other, t, mesh) == 1:
                        state = UNDECIDED_FACE
    decided[i] = uint8(state)


@kernel
def apply_decisions_kernel(
    undecided: array(dtype=int32),
    decided: array(dtype=uint8),
    mesh: BallMesh,
    left: array(dtype=uint8),
    changed: array(dtype=int32),
):
    """Apply the decisions of a round and mark undecided triangles. All threads that write `changed` write 1."""
    i = tid()
    t = undecided[i]
    if mesh.states[t] != decided[i]:
        mesh.states[t] = decided[i]
        changed[0] = 1
    open = 0
    if decided[i] == uint8(UNDECIDED_FACE):
        open = 1
    left[i] = uint8(open)


@kernel
def mark_covered_kernel(
    mesh: BallMesh, searched: array(dtype=uint8), covered: array(dtype=uint8), rims: array(dtype=uint8)
):
    """Mark vertices that have triangles, and those on boundary edges between searched ones (same value written)."""
    i = tid()
    if mesh.states[i] == uint8(ACCEPTED_FACE):
        for k in range(3):
            a = corner_vertex(mesh.triangles, 3 * i + k)
            b = corner_vertex(mesh.triangles, next_corner(3 * i + k))
            covered[a] = 1
            if searched[a] != 0 and searched[b] != 0:
                if has_accepted_edge(b, a, mesh) == 0:
                    rims[a] = 1
                    rims[b] = 1


@kernel
def mark_searched_kernel(covered: array(dtype=uint8), rims: array(dtype=uint8), searched: array(dtype=uint8)):
    """Mark vertices for the next radius: without a triangle, or on a boundary edge."""
    i = tid()
    wanted = 0
    if covered[i] == 0 or rims[i] != 0:
        wanted = 1
    searched[i] = uint8(wanted)


@kernel
def part_triangles_kernel(
    mesh: BallMesh, searched: array(dtype=uint8), open: array(dtype=uint8), closed: array(dtype=uint8)
):
    """Split accepted triangles into those with a vertex to be searched again and the others."""
    i = tid()
    near = 0
    far = 0
    if mesh.states[i] == uint8(ACCEPTED_FACE):
        t = mesh.triangles[i]
        far = 1
        if searched[t[0]] != 0 or searched[t[1]] != 0 or searched[t[2]] != 0:
            near = 1
            far = 0
    open[i] = uint8(near)
    closed[i] = uint8(far)


def resolve_conflicts(mesh: BallMesh, first: int) -> None:
    """Decide which triangles from number `first` on are accepted, in one device loop on CUDA. No sync."""
    device = mesh.triangles.device
    undecided = (
        positions(mesh.triangles.size, device)[first:] if first < mesh.triangles.size else empty(0, int32, device)
    )
    changed = full(1, 1, int32, device)
    decided, left = empty(undecided.size, uint8, device), empty(undecided.size, uint8, device)

    def run_round() -> None:
        launch(find_waiting_kernel, undecided.size, [undecided, mesh, changed])
        launch(decide_kernel, undecided.size, [undecided, mesh, decided])
        launch(apply_decisions_kernel, undecided.size, [undecided, decided, mesh, left, changed])

    if device.is_cuda and undecided.size:
        loop_while(changed, run_round)
        return
    before = undecided.size + 1
    while undecided.size and undecided.size < before:
        before = undecided.size
        decided, left = empty(before, uint8, device), empty(before, uint8, device)
        run_round()
        undecided = gather_rows(undecided, positions_of(left))


def close_radius(mesh: BallMesh, searched: Bytes) -> tuple[Triangles, Triangles, Indices]:
    """Split the accepted triangles and select the vertices for the next radius; updates `searched` and `mesh.covered`.
    One sync. Returns (open, closed, indices): triangles with selected vertices, others, and the selected vertices."""
    device = searched.device
    rims = zeros(searched.size, uint8, device)
    near, far = (empty(mesh.triangles.size, uint8, device) for _ in range(2))
    launch(mark_covered_kernel, mesh.triangles.size, [mesh, searched, mesh.covered, rims])
    launch(mark_searched_kernel, searched.size, [mesh.covered, rims, searched])
    launch(part_triangles_kernel, mesh.triangles.size, [mesh, searched, near, far])
    open_rows, closed_rows, indices = positions_of_each(near, far, searched)  # sync
    return gather_rows(mesh.triangles, open_rows), gather_rows(mesh.triangles, closed_rows), indices


@kernel
def mark_facing_kernel(points: array(dtype=vec3), normals: array(dtype=vec3), facing: array(dtype=uint8)):
    i = tid()
    n = widen(normals[i])
    valid = 0
    if isfinite(points[i]) and isfinite(normals[i]):
        if dot(n, n) > 0.0:
            valid = 1
    facing[i] = uint8(valid)


@kernel
def mark_repeated_kernel(points: array(dtype=vec3), marks: array(dtype=uint8)):
    """1 where a point equals its predecessor in tree order."""
    i = tid()
    repeated = 0
    if i > 0:
        repeated = same_point(points[i - 1], points[i])
    marks[i] = uint8(repeated)


@func
def rotate_lowest_first(t: vec3i) -> vec3i:
    first = t + vec3i(0, 0, 0)
    if t[1] < t[0] and t[1] < t[2]:
        first = vec3i(t[1], t[2], t[0])
    if t[2] < t[0] and t[2] < t[1]:
        first = vec3i(t[2], t[0], t[1])
    return first


@kernel
def name_corners_kernel(rows: array(dtype=int32), bits: int, triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    """Replace tree indices by rows, the lowest first. The key is the first edge, which is unique."""
    i = tid()
    t = triangles[i]
    named = rotate_lowest_first(vec3i(rows[t[0]], rows[t[1]], rows[t[2]]))
    triangles[i] = named
    keys[i] = (int64(named[0]) << int64(bits)) | int64(named[1])


class RollingBall:
    """Points that balls roll over: finite, with a normal, without duplicates. `grown` builds the tree over points."""

    def __init__(self, points: Points, normals: Vectors, grown: Callable[[], PointTree]) -> None:
        device = points.device
        facing = compute(mark_facing_kernel, points.size, [points, normals], uint8, device)
        self.tree = grown() if points.size else PointTree(empty(0, vec3, device))
        rows, repeated = positions_of_each(facing, self._mark_repeated())  # sync
        if rows.size < self.tree.count or repeated.size:
            if rows.size:
                rows = gather_rows(rows, first_occurrences(gather_rows(points, rows)))
            self.tree = PointTree(gather_rows(points, rows))
            self.rows = gather_rows(rows, self.tree.order)
        else:
            self.rows = self.tree.order
        self.normals = gather_rows(normals, self.rows[: self.tree.count]) if self.tree.count else empty(0, vec3, device)

    def _mark_repeated(self) -> Mask:
        """Mark points equal to their predecessor in the tree. Other duplicates only cost time."""
        return compute(mark_repeated_kernel, self.tree.count, [self.tree.points], uint8, self.tree.device)

    def roll(
        self, radii: Iterable[float], row_count: int, check: Callable[[PointTree, float, Indices], None]
    ) -> Triangles:
        """Triangles of balls of the given radii [m], as rows of the cloud, the lowest first, sorted. `check` is called
        with each radius and its points before the search, and may raise if it would take too long."""
        device, count = self.tree.device, self.tree.count
        searched, covered = full(count, 1, uint8, device), zeros(count, uint8, device)
        open, parts = empty(0, vec3i, device), []
        indices, largest, previous = positions(count, device), 0, 0.0
        for radius in radii:
            if not indices.size:
                break
            check(self.tree, radius, indices)
            expected = int(min(count, largest * (radius / previous) ** 2)) if largest else 0  # as on a plane
            ball, previous = BallPoints(self.tree, self.normals, searched, radius), radius
            faces, widths, largest = list_faces(ball, indices, expected)
            mesh = BallMesh(open, faces, widths, covered, self.rows)
            resolve_conflicts(mesh, open.size)
            open, closed, indices = close_radius(mesh, searched)  # sync
            parts.append(closed)
        triangles = concatenate_rows([*parts, open])
        bits = max(1, row_count.bit_length())
        keys = compute(name_corners_kernel, triangles.size, [self.rows, bits, triangles], int64, device)
        return gather_rows(triangles, argsort_keys(keys, 2 * bits)[1])
