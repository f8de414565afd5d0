"""Boundary half-edges of a mesh and the loops that they form.

Successors along the boundary are found by rotation around each vertex. Loops are ranked by pointer jumping (Wyllie
1979) in log2 n passes. A loop that passes a vertex twice is split there by one thread per loop. Paths end at
non-manifold or inconsistently oriented edges and form chains, not loops. On the CPU one thread follows few half-edges.
About 60 B per boundary half-edge and 8 B per half-edge.
"""

import numpy as np

from ..array_types import Indices, Integers, LongIntegers, Triangles
from ..arrays.packed_keys import pack_bits
from ..arrays.select import gather_rows, number_rows_kernel, positions_of
from ..arrays.sort import argsort_keys
from ..arrays.unique import UniqueKeys, cut_together
from ..lang import Kernel, array, compute, func, int32, int64, kernel, launch, tid, uint8, vec3i
from ..memory import clone, download, empty, full, upload
from .mesh_edges import find_edges, higher_end, key_bits, lower_end, run_indices
from .mesh_topology import corner_vertex, next_corner

BORDER_EDGE, BLOCKED_EDGE = -1, -2  # stored for a half-edge without an opposite
NOT_VISITED, ON_CHAIN, ON_LOOP = 0, 1, 2  # states of a half-edge: not visited, not on a loop, on a loop
# half-edges that one thread follows faster than two jump: 2.2 to 3.2 ms, 0.2 to 0.6 for 30 (2026-11-28)
MAX_SERIAL_HALF_EDGES = 1 << 14


@kernel
def pair_half_edges_kernel(edges: UniqueKeys, bits: int, twins: array(dtype=int32)):
    """Opposite of each half-edge. BORDER if there is none, BLOCKED if there are several."""
    i = tid()
    first = edges.starts[i]
    count = edges.starts[i + 1] - first
    distinct = 0
    if count > 0:
        if lower_end(edges.keys[i], bits) != higher_end(edges.keys[i], bits):
            distinct = 1
    for j in range(first, first + count):
        twin = BLOCKED_EDGE
        if distinct == 1 and count == 1:
            twin = BORDER_EDGE
        if distinct == 1 and count == 2:
            twin = edges.order[2 * first + 1 - j]
        twins[edges.order[j]] = twin


@kernel
def mark_border_kernel(twins: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if twins[i] == BORDER_EDGE else 0)


@kernel
def find_next_kernel(
    triangles: array(dtype=vec3i),
    twins: array(dtype=int32),
    half_edges: array(dtype=int32),
    indices: array(dtype=int32),
    nexts: array(dtype=int32),
    vertices: array(dtype=int32),
):
    """Next boundary half-edge (-1 if blocked) and start vertex. Rotation around a vertex ends: it is a permutation."""
    i = tid()
    h = half_edges[i]
    vertices[i] = corner_vertex(triangles, h)
    g = next_corner(h)
    end = corner_vertex(triangles, g)
    while twins[g] >= 0:
        g = next_corner(twins[g])
        if corner_vertex(triangles, g) != end:
            g = h  # the two triangles are inconsistently oriented; h is at the boundary, so the rotation ends
            end = -1
    following = -1
    if twins[g] == BORDER_EDGE and end >= 0:
        following = indices[g]
    nexts[i] = following


class Border:
    """Boundary half-edges: ascending numbers, start vertices, and successors (-1 for none); `edges` are padded."""

    def __init__(self, triangles: Triangles, vertex_count: int) -> None:
        device = triangles.device
        edges, twins = find_edges(triangles, vertex_count, True), empty(3 * triangles.size, int32, device)
        launch(pair_half_edges_kernel, edges.count, [edges, key_bits(vertex_count), twins])
        mask = compute(mark_border_kernel, twins.size, [twins], uint8, device)
        self.half_edges, self.edges = positions_of(mask), edges  # sync
        count, indices = self.half_edges.size, empty(twins.size, int32, device)
        launch(number_rows_kernel, count, [self.half_edges, indices])
        self.nexts, self.vertices = empty(count, int32, device), empty(count, int32, device)
        launch(find_next_kernel, count, [triangles, twins, self.half_edges, indices, self.nexts, self.vertices])


@kernel
def begin_leaders_kernel(vertices: array(dtype=int32), leaders: array(dtype=int64)):
    """Each half-edge leads itself: by vertex, then by number."""
    i = tid()
    leaders[i] = pack_bits(vertices[i], i)


@kernel
def jump_leaders_kernel(
    jumps: array(dtype=int32),
    leaders: array(dtype=int64),
    new_jumps: array(dtype=int32),
    new_leaders: array(dtype=int64),
):
    """Minimum of the leaders over twice the distance."""
    i = tid()
    jump = jumps[i]
    leader = leaders[i]
    if jump >= 0:
        leader = min(leader, leaders[jump])
        jump = jumps[jump]
    new_jumps[i] = jump
    new_leaders[i] = leader


@kernel
def cut_loops_kernel(
    nexts: array(dtype=int32), leaders: array(dtype=int64), jumps: array(dtype=int32), lengths: array(dtype=int64)
):
    i = tid()
    following = nexts[i]
    if following >= 0:
        if int64(following) == (leaders[i] & 0xFFFFFFFF):
            following = -1
    jumps[i] = following
    lengths[i] = int64(1 if following >= 0 else 0)


@kernel
def jump_lengths_kernel(
    jumps: array(dtype=int32),
    lengths: array(dtype=int64),
    new_jumps: array(dtype=int32),
    new_lengths: array(dtype=int64),
):
    i = tid()
    jump = jumps[i]
    length = lengths[i]
    if jump >= 0:
        length += lengths[jump]
        jump = jumps[jump]
    new_jumps[i] = jump
    new_lengths[i] = length


@kernel
def list_loop_keys_kernel(
    rows: array(dtype=int32), leaders: array(dtype=int64), lengths: array(dtype=int64), before: array(dtype=int64)
):
    i = tid()
    row = rows[i]
    leader = int(leaders[row] & 0xFFFFFFFF)
    before[i] = lengths[leader] - lengths[row]


@kernel
def mark_loops_kernel(jumps: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if jumps[i] >= 0 else 0)


def _jump(kernel: Kernel, jumps: Integers, values: LongIntegers) -> tuple[Integers, LongIntegers]:
    count, device = jumps.size, jumps.device
    for _ in range(max(1, count.bit_length())):
        new_jumps, new_values = empty(count, int32, device), empty(count, int64, device)
        launch(kernel, count, [jumps, values, new_jumps, new_values])
        jumps, values = new_jumps, new_values
    return jumps, values


@kernel(for_cpu=True)
def trace_loops_kernel(
    vertices: array(dtype=int32),
    nexts: array(dtype=int32),
    leaders: array(dtype=int64),
    before: array(dtype=int64),
    states: array(dtype=uint8),
):
    """Follow all paths by one thread. On loops: leaders, and half-edges from the leader on. `states` become CHAIN or
    LOOP."""
    i = tid()
    for h in range(i, nexts.shape[0]):
        if int(states[h]) == NOT_VISITED:
            leader = pack_bits(vertices[h], h)
            at = h
            going = 1
            while going == 1:
                states[at] = uint8(ON_CHAIN)
                leader = min(leader, pack_bits(vertices[at], at))
                at = nexts[at]
                going = 0
                if at >= 0:
                    if int(states[at]) == NOT_VISITED:
                        going = 1
            if at == h:
                at = int(leader & 0xFFFFFFFF)
                distance = int64(0)
                while int(states[at]) == ON_CHAIN:
                    states[at] = uint8(ON_LOOP)
                    leaders[at] = leader
                    before[at] = distance
                    distance += 1
                    at = nexts[at]


def rank_loops(vertices: Indices, nexts: Integers) -> tuple[Indices, UniqueKeys]:
    """Loops among distinct successors, each from its lowest vertex on, sorted: (rows int32 [k], padded UniqueKeys)."""
    if not nexts.device.is_cuda and nexts.size <= MAX_SERIAL_HALF_EDGES:
        return _rank_few(vertices, nexts)
    device, count = nexts.device, nexts.size
    leaders = compute(begin_leaders_kernel, count, [vertices], int64, device)
    ends, leaders = _jump(jump_leaders_kernel, nexts, leaders)
    jumps, lengths = empty(count, int32, device), empty(count, int64, device)
    launch(cut_loops_kernel, count, [nexts, leaders, jumps, lengths])
    _, lengths = _jump(jump_lengths_kernel, jumps, lengths)
    mask = compute(mark_loops_kernel, count, [ends], uint8, device)
    rows = positions_of(mask)  # sync
    before = compute(list_loop_keys_kernel, rows.size, [rows, leaders, lengths], int64, device)
    rows = gather_rows(rows, argsort_keys(before, max(1, count.bit_length()))[1])
    loops = UniqueKeys(gather_rows(leaders, rows), padded=True)
    return gather_rows(rows, loops.order), loops


def _rank_few(vertices: Indices, nexts: Integers) -> tuple[Indices, UniqueKeys]:
    """`rank_loops` on the CPU by one thread."""
    device, count = nexts.device, nexts.size
    leaders, before = empty(count, int64, device), empty(count, int64, device)
    states = full(count, NOT_VISITED, uint8, device)
    launch(trace_loops_kernel, min(1, count), [vertices, nexts, leaders, before, states])
    rows = np.flatnonzero(download(states) == ON_LOOP)
    keys = download(leaders)[rows]
    order = np.lexsort([download(before)[rows], keys])
    sorted_keys: LongIntegers = upload(keys[order], int64, device)
    in_order = sorted_keys, upload(order, int32, device)
    return upload(rows[order], int32, device), UniqueKeys(sorted_keys, in_order=in_order, padded=True)


@kernel
def list_passes_kernel(
    rows: array(dtype=int32), vertices: array(dtype=int32), loop_of: array(dtype=int32), keys: array(dtype=int64)
):
    i = tid()
    keys[i] = pack_bits(loop_of[i], vertices[rows[i]])


@kernel
def spread_passes_kernel(passes: UniqueKeys, pass_of: array(dtype=int32), slots: array(dtype=int32)):
    i = tid()
    slots[passes.order[i]] = pass_of[i]


@func
def close_loop(
    rows: array(dtype=int32), stack: array(dtype=int32), first: int, last: int, nexts: array(dtype=int32)
) -> int:
    """Make a loop of positions first .. last of a stack. Return their number."""
    for q in range(first, last):
        following = q + 1
        if following == last:
            following = first
        nexts[rows[stack[q]]] = rows[stack[following]]
    return last - first


@kernel
def cut_at_vertices_kernel(
    rows: array(dtype=int32),
    starts: array(dtype=int32),
    slots: array(dtype=int32),
    heights: array(dtype=int32),
    stack: array(dtype=int32),
    nexts: array(dtype=int32),
):
    """Close a loop at each repeated vertex. One thread per loop. `heights` are stack positions of vertices, or -1."""
    i = tid()
    base = starts[i]
    top = base
    for p in range(starts[i], starts[i + 1]):
        slot = slots[p]
        height = heights[slot]
        if height >= 0:
            closed = close_loop(rows, stack, height, top, nexts)
            for q in range(height, height + closed):
                heights[slots[stack[q]]] = -1
            top = height
        heights[slot] = top
        stack[top] = p
        top += 1
    closed = close_loop(rows, stack, base, top, nexts)


def find_loops(border: Border) -> tuple[Indices, UniqueKeys, np.ndarray]:
    """Simple loops of a Border: (rows, loops, starts on the host), as of `rank_loops` but without padding."""
    device = border.nexts.device
    rows, loops = rank_loops(border.vertices, border.nexts)
    loop_of, keys = run_indices(loops, rows.size), empty(rows.size, int64, device)
    launch(list_passes_kernel, rows.size, [rows, border.vertices, loop_of, keys])
    passes = UniqueKeys(keys, padded=True)
    (starts,) = cut_together([loops, passes, border.edges], loops.starts)  # sync
    if passes.count == rows.size:
        return rows, loops, starts[: loops.count + 1]
    slots, pass_of = empty(rows.size, int32, device), run_indices(passes, rows.size)
    launch(spread_passes_kernel, rows.size, [passes, pass_of, slots])
    nexts, stack = clone(border.nexts), empty(rows.size, int32, device)
    heights = full(passes.count, -1, int32, device)
    launch(cut_at_vertices_kernel, loops.count, [rows, loops.starts, slots, heights, stack, nexts])
    rows, loops = rank_loops(border.vertices, nexts)
    (starts,) = cut_together([loops], loops.starts)  # sync
    return rows, loops, starts[: loops.count + 1]
