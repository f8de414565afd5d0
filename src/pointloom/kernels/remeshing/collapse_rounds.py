"""Rounds of edge collapses until the target number of triangles. One CUDA graph, terminated by the device.

A round computes missing costs, considers edges up to a histogram limit, selects an independent set (Luby, "A simple
parallel algorithm for the maximal independent set problem", 1986, with costs for random numbers), and collapses the
cheapest. An edge is selected if its key is minimal at all vertices around both ends. Toward the end, a radix selection
finds the edges that reach the target. On CUDA about 40 kernels per round of a small mesh, 60 of a large one.
"""

from collections.abc import Sequence

from ..algebra.transform import narrow, widen
from ..array_types import Bytes, Indices
from ..arrays.blocks import wait_for_block
from ..arrays.loop_scan import LoopList
from ..arrays.packed_keys import NO_KEY
from ..arrays.tile_scan import TileScan
from ..lang import (
    DeviceLoop,
    array,
    atomic_min,
    dot,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    tid,
    uint8,
    vec2,
    vec2i,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, full, host_view
from ..meshes.mesh_topology import corner_vertex, last_corner, next_corner
from .collapse_mesh import (
    CHOSEN_COUNT,
    EDGE_COUNT,
    FINDS_ALL_FEATURES,
    FREE_VERTEX,
    HIGHEST_BIN,
    MAY_FLIP,
    NEEDS_COMPACTION,
    PICKED_COUNT,
    REJECTED_KEY,
    SEAMS_ARE_FEATURES,
    SLOT_COUNT,
    STALE_KEY,
    TRIANGLE_COUNT,
    VERTEX_COUNT,
    CollapseMesh,
    edge_at,
    fill_first,
    uv_at,
)
from .compacted_mesh import Squeezing, left_vertices
from .edge_bins import EdgeBins, threads_at_once
from .edge_costs import mark_cheap_edges_kernel, may_collapse, merged_position, placement, price_edges_kernel
from .quadrics import quadric


@func
def weights_in_triangle(a: vec3d, b: vec3d, c: vec3d, x: vec3d) -> vec3d:
    """Nonnegative barycentric coordinates of x projected to a triangle; c gets 0 without area."""
    u = b - a
    v = c - a
    w = x - a
    uu = dot(u, u)
    uv = dot(u, v)
    vv = dot(v, v)
    uw = dot(u, w)
    vw = dot(v, w)
    zero = float64(0.0)
    one = float64(1.0)
    tip = zero + zero
    area = uu * vv - uv * uv
    if area > zero:
        tip = min(max((uu * vw - uv * uw) / area, zero), one)
    fraction = zero + zero
    if uu > zero:
        fraction = min(max((uw - tip * uv) / uu, zero), one - tip)
    return vec3d(one - tip - fraction, fraction, tip)


@func
def new_position(mesh: CollapseMesh, h: int, a: int, b: int) -> vec3d:
    merged = merged_position(mesh, a, b, placement(mesh, h, a, b))
    return vec3d(merged[0], merged[1], merged[2])


@kernel
def weigh_corners_kernel(
    mesh: CollapseMesh, edges: array(dtype=int32), fractions: array(dtype=vec3d), tips: array(dtype=int32)
):
    """Weights `fractions` of first end, other end and tip (`tips`) of the triangle below the new vertex."""
    i = tid()
    if i >= mesh.numbers[CHOSEN_COUNT]:
        return
    h = edges[i]
    a = corner_vertex(mesh.triangles, h)
    b = corner_vertex(mesh.triangles, next_corner(h))
    x = new_position(mesh, h, a, b)
    p = mesh.positions[a]
    r = mesh.positions[b]
    best = weights_in_triangle(p, r, p, x)
    tip = -1
    if int(mesh.kinds[a]) == FREE_VERTEX and int(mesh.kinds[b]) == FREE_VERTEX:
        for j in range(mesh.starts[a], mesh.starts[a + 1]):
            g = edge_at(mesh, j, b)
            if g >= 0:
                other = last_corner(g)
                here = weights_in_triangle(p, r, mesh.positions[corner_vertex(mesh.triangles, other)], x)
                if here[2] > best[2]:
                    best = here
                    tip = other
    fractions[i] = best
    tips[i] = tip


@kernel
def collapse_edges_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    partners: array(dtype=int32),
    positions: array(dtype=vec3d),
    quadrics: array(dtype=quadric),
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    moved: array(dtype=int32),
):
    """Move the first end (in `moved`) of each edge to its new position with the triangles of the other end."""
    i = tid()
    if i >= mesh.numbers[CHOSEN_COUNT]:
        return
    h = edges[i]
    a = corner_vertex(triangles, h)
    b = corner_vertex(triangles, next_corner(h))
    partners[a] = b
    partners[b] = -2 - a
    positions[a] = new_position(mesh, h, a, b)
    quadrics[a] = quadrics[a] + quadrics[b]
    moved[i] = a
    for j in range(mesh.starts[b], mesh.starts[b + 1]):
        s = mesh.spokes[j]
        c = mesh.corners[j]
        k = c % 3
        t = vec3i(a, s[0], s[1])
        if k == 1:
            t = vec3i(s[1], a, s[0])
        if k == 2:
            t = vec3i(s[0], s[1], a)
        if s[0] == a or s[1] == a:
            t = vec3i(-1, -1, -1)
            for m in range(3):
                keys[3 * (c // 3) + m] = int64(NO_KEY)
        triangles[c // 3] = t


@kernel
def merge_rows_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    fractions: array(dtype=vec3d),
    tips: array(dtype=int32),
    unit: int,
    rows: array(dtype=vec3),
):
    """Attributes of merged vertices; normalized if `unit` is 1."""
    i = tid()
    if i >= mesh.numbers[CHOSEN_COUNT]:
        return
    h = edges[i]
    a = corner_vertex(mesh.triangles, h)
    s = fractions[i]
    row = widen(rows[a]) * s[0]
    if s[1] > 0.0:
        row = row + widen(rows[corner_vertex(mesh.triangles, next_corner(h))]) * s[1]
    if tips[i] >= 0:
        row = row + widen(rows[corner_vertex(mesh.triangles, tips[i])]) * s[2]
    size = length(row)
    if unit == 1 and size > 0.0:
        row = row / size
    rows[a] = narrow(row)


@func
def merged_uv(mesh: CollapseMesh, a: int, b: int, v: int, old: vec2, s: vec3d, tip: int) -> vec2:
    """New coordinates of a corner at v: from the triangle at the edge with the same `old` ones, or unchanged."""
    new = old
    matched = 0
    for j in range(mesh.starts[a], mesh.starts[a + 1]):
        g = edge_at(mesh, j, b)
        if g >= 0 and matched == 0:
            p = uv_at(mesh, g, a)
            q = uv_at(mesh, g, b)
            here = p
            if v == b:
                here = q
            if here[0] == old[0] and here[1] == old[1]:
                matched = 1
                new = p * float(s[0]) + q * float(s[1])
                if tip >= 0:
                    new = new + mesh.uvs[tip] * float(s[2])
    return new


@kernel
def merge_uvs_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    fractions: array(dtype=vec3d),
    tips: array(dtype=int32),
    uvs: array(dtype=vec2),
):
    """Texture coordinates around collapsing edges; `uvs` is a separate array."""
    i = tid()
    if i >= mesh.numbers[CHOSEN_COUNT]:
        return
    h = edges[i]
    a = corner_vertex(mesh.triangles, h)
    b = corner_vertex(mesh.triangles, next_corner(h))
    for j in range(mesh.starts[a], mesh.starts[a + 1]):
        c = mesh.corners[j]
        uvs[c] = merged_uv(mesh, a, b, a, mesh.uvs[c], fractions[i], tips[i])
    for j in range(mesh.starts[b], mesh.starts[b + 1]):
        d = mesh.corners[j]
        uvs[d] = merged_uv(mesh, a, b, b, mesh.uvs[d], fractions[i], tips[i])


@kernel
def take_uvs_kernel(mesh: CollapseMesh, edges: array(dtype=int32), merged: array(dtype=vec2), uvs: array(dtype=vec2)):
    i = tid()
    if i >= mesh.numbers[CHOSEN_COUNT]:
        return
    h = edges[i]
    v = corner_vertex(mesh.triangles, h)
    for end in range(2):
        for j in range(mesh.starts[v], mesh.starts[v + 1]):
            c = mesh.corners[j]
            uvs[c] = merged[c]
        v = corner_vertex(mesh.triangles, next_corner(h))


class EdgeCollapse:
    """Buffers to collapse up to `capacity` edges; `moved` are the merged vertices."""

    def __init__(self, mesh: CollapseMesh, capacity: int, unit: Sequence[bool]) -> None:
        device, self.capacity, self.unit = mesh.numbers.device, capacity, unit
        self.moved: Indices = empty(capacity, int32, device)
        self._partners: Indices = empty(mesh.positions.size, int32, device)
        self._weighted = capacity if mesh.rows or mesh.has_uvs else 0  # edges whose corners need weights
        self._fractions, self._tips = empty(self._weighted, vec3d, device), empty(self._weighted, int32, device)
        self._scan = TileScan(mesh.positions.size, device)

    def run(self, mesh: CollapseMesh, twin: CollapseMesh, edges: Indices) -> None:
        """Collapse independent edges (int32 half-edges), as many as in the record."""
        count, vertices = mesh.live(CHOSEN_COUNT, self.capacity), mesh.live(VERTEX_COUNT, mesh.positions.size)
        if self._weighted:
            launch(weigh_corners_kernel, count, [mesh, edges, self._fractions, self._tips])
        for rows, is_unit in zip(mesh.rows, self.unit, strict=True):
            launch(merge_rows_kernel, count, [mesh, edges, self._fractions, self._tips, int(is_unit), rows])
        if mesh.has_uvs:
            launch(merge_uvs_kernel, count, [mesh, edges, self._fractions, self._tips, twin.uvs])
            launch(take_uvs_kernel, count, [mesh, edges, twin.uvs, mesh.uvs])
        fill_first(self._partners, vertices, -1)
        outputs = [self._partners, mesh.positions, mesh.quadrics, mesh.triangles, mesh.keys, self.moved]
        launch(collapse_edges_kernel, count, [mesh, edges, *outputs])
        mesh.join_corners(self._partners, twin, self._scan)


@func
def list_edge(
    i: int, mesh: CollapseMesh, edges: array(dtype=int32), keys: array(dtype=int64), ends: array(dtype=vec2i)
):
    """Key and ends of a considered edge, adjacent in memory."""
    h = edges[i]
    keys[i] = mesh.keys[h]
    ends[i] = vec2i(corner_vertex(mesh.triangles, h), corner_vertex(mesh.triangles, next_corner(h)))


@kernel
def list_edges_kernel(
    mesh: CollapseMesh, edges: array(dtype=int32), keys: array(dtype=int64), ends: array(dtype=vec2i)
):
    i = tid()
    if i < mesh.numbers[EDGE_COUNT]:
        list_edge(i, mesh, edges, keys, ends)


@func
def take_edge(
    i: int, ends: array(dtype=vec2i), blocked: array(dtype=uint8), keys: array(dtype=int64), lowest: array(dtype=int64)
):
    """Minimum key of the edges at each vertex, without blocked ones. The minimum does not depend on the order."""
    key = keys[i]
    if key < int64(STALE_KEY):
        e = ends[i]
        if blocked[e[0]] == 0 and blocked[e[1]] == 0:
            atomic_min(lowest, e[0], key)
            atomic_min(lowest, e[1], key)
        else:
            keys[i] = int64(NO_KEY)


@kernel
def take_edges_kernel(
    numbers: array(dtype=int32),
    ends: array(dtype=vec2i),
    blocked: array(dtype=uint8),
    keys: array(dtype=int64),
    lowest: array(dtype=int64),
):
    i = tid()
    if i < numbers[EDGE_COUNT]:
        take_edge(i, ends, blocked, keys, lowest)


@func
def is_lowest_around(mesh: CollapseMesh, v: int, key: int64, lowest: array(dtype=int64)) -> int:
    flag = 1
    j = mesh.starts[v]
    while j < mesh.starts[v + 1] and flag == 1:
        s = mesh.spokes[j]
        if lowest[s[0]] < key or lowest[s[1]] < key:
            flag = 0
        j += 1
    return flag


@func
def block_around(mesh: CollapseMesh, v: int, blocked: array(dtype=uint8)):
    """Block a vertex and its neighbors. All threads write the same value."""
    blocked[v] = 1
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        s = mesh.spokes[j]
        blocked[s[0]] = 1
        blocked[s[1]] = 1


@func
def choose_edge(
    i: int,
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    ends: array(dtype=vec2i),
    lowest: array(dtype=int64),
    listed: array(dtype=int64),
    keys: array(dtype=int64),
    chosen: array(dtype=uint8),
    blocked: array(dtype=uint8),
):
    """Select or reject an edge whose key is minimal around; `keys` are those of the mesh, `listed` of the edges."""
    key = listed[i]
    a = ends[i][0]
    b = ends[i][1]
    if key < int64(STALE_KEY) and lowest[a] == key and lowest[b] == key:
        first = is_lowest_around(mesh, a, key, lowest)
        if first == 1:
            first = is_lowest_around(mesh, b, key, lowest)
        if first == 1:
            h = edges[i]
            if may_collapse(mesh, h, a, b, mesh.numbers[MAY_FLIP]) == 1:
                chosen[i] = 1
                block_around(mesh, a, blocked)
                block_around(mesh, b, blocked)
            else:
                listed[i] = int64(REJECTED_KEY)
                keys[h] = int64(REJECTED_KEY)


@kernel
def choose_edges_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    ends: array(dtype=vec2i),
    lowest: array(dtype=int64),
    listed: array(dtype=int64),
    keys: array(dtype=int64),
    chosen: array(dtype=uint8),
    blocked: array(dtype=uint8),
):
    i = tid()
    if i < mesh.numbers[EDGE_COUNT]:
        choose_edge(i, mesh, edges, ends, lowest, listed, keys, chosen, blocked)


@kernel
def choose_at_once_kernel(
    threads: int,
    passes: int,
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    ends: array(dtype=vec2i),
    lowest: array(dtype=int64),
    listed: array(dtype=int64),
    keys: array(dtype=int64),
    chosen: array(dtype=uint8),
    blocked: array(dtype=uint8),
):
    """All passes of the selection: one block on CUDA, one thread on the CPU. Clears `chosen` and `blocked` before."""
    i = tid()
    count = mesh.numbers[EDGE_COUNT]
    vertices = mesh.numbers[VERTEX_COUNT]
    at = i + 0
    while at < chosen.shape[0]:
        chosen[at] = uint8(0)
        at += threads
    at = i + 0
    while at < vertices:
        blocked[at] = uint8(0)
        at += threads
    at = i + 0
    while at < count:
        list_edge(at, mesh, edges, listed, ends)
        at += threads
    for _ in range(passes):
        at = i + 0
        while at < vertices:
            lowest[at] = int64(NO_KEY)
            at += threads
        wait_for_block()
        at = i + 0
        while at < count:
            take_edge(at, ends, blocked, listed, lowest)
            at += threads
        wait_for_block()
        at = i + 0
        while at < count:
            choose_edge(at, mesh, edges, ends, lowest, listed, keys, chosen, blocked)
            at += threads
        wait_for_block()


class EdgeChoice:
    """Buffers for edge selection; `chosen` is zero beyond the edges."""

    def __init__(self, mesh: CollapseMesh) -> None:
        device = mesh.numbers.device
        self._threads = threads_at_once(mesh)
        self.chosen: Bytes = empty(mesh.keys.size, uint8, device)
        self._lowest = empty(mesh.positions.size, int64, device)

    def run(self, mesh: CollapseMesh, twin: CollapseMesh, edges: Indices, passes: int) -> None:
        """Select independent `edges` (owners) in passes; sets `mesh.touched` and the keys of rejected edges. Keys and
        spokes of the twin are scratch memory."""
        count, vertices = mesh.live(EDGE_COUNT, edges.size), mesh.live(VERTEX_COUNT, mesh.positions.size)
        keys, ends = twin.keys, twin.spokes
        if self._threads:
            arguments = [mesh, edges, ends, self._lowest, keys, mesh.keys, self.chosen, mesh.touched]
            launch(choose_at_once_kernel, self._threads, [self._threads, passes, *arguments])
            return
        fill_first(self.chosen, count, 0)
        fill_first(mesh.touched, vertices, 0)
        launch(list_edges_kernel, count, [mesh, edges, keys, ends])
        for _ in range(passes):
            fill_first(self._lowest, vertices, NO_KEY)
            launch(take_edges_kernel, count, [mesh.numbers, ends, mesh.touched, keys, self._lowest])
            arguments = [mesh, edges, ends, self._lowest, keys, mesh.keys, self.chosen, mesh.touched]
            launch(choose_edges_kernel, count, arguments)


SELECTION_PASSES = 3  # selection passes per round
COMPACTED_NUMERATOR, COMPACTED_DENOMINATOR = 3, 4  # fraction of remaining triangles below which the mesh is compacted


@kernel
def take_rows_kernel(
    values: array(dtype=int32),
    rows: array(dtype=int32),
    counts: array(dtype=int32),
    entry: int,
    out: array(dtype=int32),
):
    i = tid()
    if i < counts[entry]:
        out[i] = values[rows[i]]


@kernel
def judge_round_kernel(
    mesh: CollapseMesh, stops_at_limit: int, numbers: array(dtype=int32), running: array(dtype=int32)
):
    """Round outcome: if no edge can collapse, relax constraints. Decide on compaction."""
    i = tid()
    left = mesh.starts[numbers[VERTEX_COUNT]] // 3
    numbers[TRIANGLE_COUNT] = left
    numbers[FINDS_ALL_FEATURES] = i
    running[0] = 1
    if numbers[HIGHEST_BIN] < 0:
        if numbers[MAY_FLIP] == 1 or stops_at_limit == 1:
            running[0] = 0
        else:
            has_seams = numbers[SEAMS_ARE_FEATURES] * max(mesh.has_uvs, mesh.has_materials)
            numbers[MAY_FLIP] = 1 - has_seams
            numbers[SEAMS_ARE_FEATURES] = numbers[SEAMS_ARE_FEATURES] * (1 - has_seams)
            numbers[FINDS_ALL_FEATURES] = 1
    elif numbers[CHOSEN_COUNT] > 0:
        numbers[MAY_FLIP] = 0
    numbers[NEEDS_COMPACTION] = 1 if COMPACTED_DENOMINATOR * left < COMPACTED_NUMERATOR * numbers[SLOT_COUNT] else 0


@kernel
def end_round_kernel(
    mesh: CollapseMesh, ranks: array(dtype=int32), target: int, numbers: array(dtype=int32), running: array(dtype=int32)
):
    """Sizes after compaction, and whether another round follows."""
    i = tid()
    count = left_vertices(mesh, ranks)
    if count >= 0:
        numbers[VERTEX_COUNT] = count
        numbers[SLOT_COUNT] = numbers[TRIANGLE_COUNT]
    numbers[NEEDS_COMPACTION] = i
    numbers[FINDS_ALL_FEATURES] = i
    if numbers[TRIANGLE_COUNT] <= target:
        running[0] = 0


@kernel
def request_squeeze_kernel(numbers: array(dtype=int32)):
    i = tid()
    numbers[NEEDS_COMPACTION] = i + 1


class CollapseRounds:
    """All rounds of a mesh with features and quadrics to `target` triangles, up to the error `max_error`."""

    def __init__(self, mesh: CollapseMesh, unit: Sequence[bool], target: int, max_error: float) -> None:
        device, half_edge_count = mesh.numbers.device, mesh.keys.size
        self.mesh, self.twin, self.target, self.max_error = mesh, mesh.twin(), target, float64(max_error)
        self.stops_at_limit = int(max_error < float("inf"))
        self.bins, self.choice, self.squeezing = EdgeBins(target, mesh), EdgeChoice(mesh), Squeezing(mesh)
        self.cheap = empty(half_edge_count, uint8, device)
        self.considered, self.picked_list = LoopList(half_edge_count, device), LoopList(half_edge_count, device)
        apart = max(1, min(mesh.triangles.size, mesh.positions.size // 2))  # edges with a triangle and no common end
        self.picked: Indices = empty(apart, int32, device)
        self.taken, self.taken_list = empty(apart, uint8, device), LoopList(apart, device)
        self.chosen: Indices = empty(apart, int32, device)
        self.collapse = EdgeCollapse(mesh, apart, unit)
        self.running = full(1, int(mesh.triangles.size > target), int32, device)

    def run(self) -> None:
        """Collapse edges to the target or as far as possible, then compact."""
        if self.running.device.is_cuda:
            DeviceLoop(self.running, self.run_round).run()
        else:
            running = host_view(self.running)
            while running[0]:
                self.run_round()
        launch(request_squeeze_kernel, 1, [self.mesh.numbers])
        self.squeeze()

    def price_edges(self) -> None:
        """Compute missing edge costs and the limit of edges to consider."""
        mesh = self.mesh
        count = 3 * mesh.live(SLOT_COUNT, mesh.triangles.size)
        launch(price_edges_kernel, count, [mesh, self.max_error, mesh.keys, self.bins.bins])
        self.bins.limit_prices()

    def choose(self) -> Indices:
        """Select cheap independent edges, at most as many as needed."""
        mesh, numbers = self.mesh, self.mesh.numbers
        count = 3 * mesh.live(SLOT_COUNT, mesh.triangles.size)
        launch(mark_cheap_edges_kernel, count, [mesh.keys, numbers, self.cheap])
        self.considered.find(self.cheap, count, numbers, EDGE_COUNT)
        self.choice.run(mesh, self.twin, self.considered.rows, SELECTION_PASSES)
        considered_count = mesh.live(EDGE_COUNT, self.considered.rows.size)
        self.picked_list.find(self.choice.chosen, considered_count, numbers, PICKED_COUNT)
        picked = mesh.live(PICKED_COUNT, self.picked.size)
        rows = [self.considered.rows, self.picked_list.rows, numbers, PICKED_COUNT, self.picked]
        launch(take_rows_kernel, picked, rows)
        if mesh.record is not None:
            if 2 * picked <= mesh.record[TRIANGLE_COUNT] - self.target:  # as is_cut
                mesh.record[CHOSEN_COUNT] = picked
                return self.picked
        self.bins.mark_cheapest(mesh, self.picked, picked, self.taken)
        self.taken_list.find(self.taken, picked, numbers, CHOSEN_COUNT)
        rows = [self.picked, self.taken_list.rows, numbers, CHOSEN_COUNT, self.chosen]
        launch(take_rows_kernel, mesh.live(CHOSEN_COUNT, self.chosen.size), rows)
        return self.chosen

    def run_round(self) -> None:
        mesh = self.mesh
        self.price_edges()
        self.collapse.run(mesh, self.twin, self.choose())
        mesh.find_features(self.collapse.moved, self.collapse.capacity)
        launch(judge_round_kernel, 1, [mesh, self.stops_at_limit, mesh.numbers, self.running])
        if mesh.record is None or mesh.record[FINDS_ALL_FEATURES]:
            mesh.find_all_features()
        self.squeeze()

    def squeeze(self) -> None:
        mesh = self.mesh
        if mesh.record is None or mesh.record[NEEDS_COMPACTION]:
            self.squeezing.run(mesh, self.twin)
        launch(end_round_kernel, 1, [mesh, self.squeezing.ranks, self.target, mesh.numbers, self.running])
