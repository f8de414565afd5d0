"""Consistent normal orientation along a minimum spanning tree.

Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH 1992, section 3.3: edges to the k nearest weigh
1 - |n . n'|. The shortest bridges join the components: single-tree Boruvka (Prokopenko, Sao and Lebrun-Grandie, ICPP
2022), one thread per leaf, pruned by the shortest bridge of its component. Bridges are ordered by length, lower rank,
higher rank, so no cycle closes and results are deterministic. Memory: 4 k + 80 B per point.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..algebra.transform import narrow, widen
from ..array_types import Indices, Integers, Points, Vectors
from ..arrays.packed_keys import NO_KEY, key_bits, key_index, last_key, pack_bits
from ..arrays.row_atomics import lower_long
from ..arrays.runs import Runs, elements_of
from ..lang import (
    array,
    atomic_min,
    compute,
    float32,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    partial,
    sqrt,
    struct,
    tid,
    vec3,
)
from ..memory import copy, empty, full, zeros
from ..search.bucket_walk import next_step, start_traversal
from ..search.neighbor_lists import list_neighbors
from ..search.point_tree import BUCKET, FAN, LEAF, PointTree, level_sizes, measure_boxes, square_distance
from .spanning_tree import Forest, hook_word, span_neighbors

if TYPE_CHECKING:
    from ..search.point_tree import PointTree


INFINITY_BITS = 0x7F80_0000  # bits of an infinite float32
MAX_RANK = 0x7FFF_FFFF
MIXED_OWNER = -1  # owner of a node with points of several components
NO_OWNER = -2  # owner of an empty node


@struct
class Bridges:
    """Shortest bridges of components. `owners`: component of a node, MIXED_OWNER or NO_OWNER. By root: lengths squared
    `sqlengths`, ends `lows` and `highs`. By rank: `bridge_keys`, squared length above the end.
    """

    tree: PointTree
    forest: Forest
    owners: array(dtype=int32)
    sqlengths: array(dtype=int32)
    lows: array(dtype=int32)
    highs: array(dtype=int32)
    bridge_keys: array(dtype=int64)

    def __init__(self, tree: PointTree, forest: Forest) -> None:
        count, device = forest.count, forest.device
        self.tree, self.forest = tree, forest
        self.records = level_sizes(-(-tree.count // BUCKET))[1]
        # Missing children are NO_OWNER: they are read beside their siblings and written by no kernel.
        self.owners = full(int(self.records[-1]) * FAN, NO_OWNER, int32, device)
        self.sqlengths, self.lows, self.highs = (empty(count, int32, device) for _ in range(3))
        self.bridge_keys = empty(count, int64, device)

    def label_nodes(self) -> None:
        """Write the component of each tree node, level by level."""
        launch(label_leaves_kernel, int(self.records[1]) * FAN, [self])
        for level in range(1, self.tree.root + 1):
            below, here = int(self.records[level - 1]), int(self.records[level])
            launch(label_nodes_kernel, here - below, [below, here, self.owners])


@func
def joint_owner(a: int, b: int) -> int:
    owner = a
    if a == NO_OWNER:
        owner = b
    else:
        if b != NO_OWNER and b != a:
            owner = MIXED_OWNER
    return owner


@kernel
def label_leaves_kernel(bridges: Bridges):
    i = tid()
    owner = int(NO_OWNER)
    for j in range(i * LEAF, min((i + 1) * LEAF, bridges.tree.count)):
        owner = joint_owner(owner, bridges.forest.links[j] >> 1)
    bridges.owners[i] = owner


@kernel
def label_nodes_kernel(below: int, first: int, owners: array(dtype=int32)):
    i = tid()
    owner = int(NO_OWNER)
    for j in range(FAN):
        owner = joint_owner(owner, owners[(below + i) * FAN + j])
    owners[first * FAN + i] = owner


@kernel
def clear_bridges_kernel(bridges: Bridges, going: array(dtype=int32)):
    """Reset the bridges; `going` is set later if one is found."""
    i = tid()
    if i == 0:
        going[0] = 0
    root = bridges.forest.roots[i]
    bridges.sqlengths[root] = INFINITY_BITS
    bridges.lows[root] = MAX_RANK
    bridges.highs[root] = MAX_RANK


@kernel
def offer_steps_kernel(bridges: Bridges):
    """Offer the edge from each point to the next on the curve as a first bound."""
    i = tid()
    a = bridges.forest.links[i] >> 1
    b = bridges.forest.links[i + 1] >> 1
    if a != b:
        bits = float_bits(square_distance(bridges.tree.points[i], bridges.tree.points[i + 1]))
        atomic_min(bridges.sqlengths, a, bits)  # resolves the race: the shortest
        atomic_min(bridges.sqlengths, b, bits)


@func
def children_of_others(a: vec3, b: vec3, limit: int64, own: int, bridges: Bridges, level: int, node: int) -> int:
    """Bit mask of children with keys up to `limit` from the box (a, b), not entirely in component `own`."""
    at = bridges.tree.levels[level] + node
    distances = measure_boxes(bridges.tree.boxes, at, a, b)
    rank = int64(node) * int64(BUCKET) << int64(3 * level)  # FAN is 2^3
    width = int64(LEAF) << int64(3 * level)
    bits = 0
    for j in range(FAN):
        owner = bridges.owners[at * FAN + j]
        key = (int64(float_bits(distances[j])) << 32) | rank
        rank = rank + width
        if key <= limit and owner != own and owner != NO_OWNER:
            bits = bits | (1 << j)
    return bits


@func
def is_near_other_component(leaf: int, bridges: Bridges) -> int:
    """1 if another component may be as near to the leaf's box as its own shortest bridge, or if the leaf is mixed."""
    own = bridges.owners[leaf]
    reached = 0
    if own < 0:
        reached = 1
    else:
        a = bridges.tree.points[leaf * LEAF]
        b = a + vec3(0.0, 0.0, 0.0)
        for rank in range(leaf * LEAF + 1, min((leaf + 1) * LEAF, bridges.tree.count)):
            q = bridges.tree.points[rank]
            a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
            b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
        limit = last_key(bridges.sqlengths[own])
        step = start_traversal(leaf // FAN)
        while int(step[0]) <= bridges.tree.root and reached == 0:
            if children_of_others(a, b, limit, own, bridges, 0, int(step[2])) != 0:
                reached = 1
            else:
                step = next_step(step, bridges.tree.root, partial(children_of_others, a, b, limit, own, bridges))
    return reached


@func
def nearest_of_others(rank: int, bridges: Bridges) -> int64:
    """Nearest point of another component within the shortest bridge, as squared distance bits above its rank."""
    p = bridges.tree.points[rank]
    own = bridges.forest.links[rank] >> 1
    limit = last_key(bridges.sqlengths[own])
    nearest = int64(NO_KEY)
    step = start_traversal(rank // BUCKET)
    while int(step[0]) <= bridges.tree.root:
        bucket = int(step[2])
        limit = min(limit, last_key(bridges.sqlengths[own]))  # other threads may have found a shorter bridge
        children = children_of_others(p, p, limit, own, bridges, 0, bucket)
        for leaf in range(FAN):
            if (children >> leaf) & 1 == 1:
                first = bucket * BUCKET + leaf * LEAF
                for j in range(first, min(first + LEAF, bridges.tree.count)):
                    if bridges.forest.links[j] >> 1 != own:
                        bits = float_bits(square_distance(p, bridges.tree.points[j]))
                        nearest = min(nearest, pack_bits(bits, j))
        limit = min(limit, nearest)
        step = next_step(step, bridges.tree.root, partial(children_of_others, p, p, limit, own, bridges))
    return nearest


@kernel(max_registers=128)  # for two blocks per SM
def find_bridges_kernel(bridges: Bridges):
    """Shortest bridge from each point of a leaf. Pruning never drops the component's shortest bridge."""
    i = tid()
    reached = is_near_other_component(i, bridges)
    for rank in range(i * LEAF, min((i + 1) * LEAF, bridges.tree.count)):
        key = int64(NO_KEY)
        if reached == 1:
            key = nearest_of_others(rank, bridges)
            own = bridges.forest.links[rank] >> 1
            bits = key_bits(key)
            if bits < bridges.sqlengths[own]:
                atomic_min(bridges.sqlengths, own, bits)  # resolves the race: length of the component's shortest bridge
        bridges.bridge_keys[rank] = key


@kernel
def select_lows_kernel(bridges: Bridges):
    """Select the lowest lower end of the component's shortest bridges."""
    i = tid()
    own = bridges.forest.links[i] >> 1
    if bridges.bridge_keys[i] < int64(NO_KEY) and key_bits(bridges.bridge_keys[i]) == bridges.sqlengths[own]:
        atomic_min(bridges.lows, own, min(i, key_index(bridges.bridge_keys[i])))  # resolves ties of length


@kernel
def select_highs_kernel(bridges: Bridges):
    """Of those with this lower end, select the lowest higher end."""
    i = tid()
    own = bridges.forest.links[i] >> 1
    if bridges.bridge_keys[i] < int64(NO_KEY) and key_bits(bridges.bridge_keys[i]) == bridges.sqlengths[own]:
        far = key_index(bridges.bridge_keys[i])
        if min(i, far) == bridges.lows[own]:
            atomic_min(bridges.highs, own, max(i, far))  # resolves ties of length and lower end


@kernel
def hook_bridges_kernel(bridges: Bridges, normals: array(dtype=vec3), going: array(dtype=int32)):
    """Hook each component to the target of its bridge. Of a mutual pair the lower stays. All writers write 1."""
    i = tid()
    c = bridges.forest.roots[i]
    near = bridges.lows[c]
    far = bridges.highs[c]
    if near < far:  # a bridge was found
        going[0] = 1
        if bridges.forest.links[near] >> 1 != c:
            near = bridges.highs[c]
            far = bridges.lows[c]
        other = bridges.forest.links[far] >> 1
        if bridges.lows[other] != bridges.lows[c] or bridges.highs[other] != bridges.highs[c] or other < c:
            bridges.forest.hooks[c] = hook_word(near, far, bridges.forest, normals)


def bridge_components(forest: Forest, tree: PointTree, normals: Vectors) -> None:
    """Join the components of a Forest (in place) by their shortest bridges. Unit normals by tree rank."""
    if forest.roots.size < 2:
        return
    bridges = Bridges(tree, forest)

    def bridge(going: Integers) -> None:
        launch(clear_bridges_kernel, forest.roots.size, [bridges, going])
        launch(offer_steps_kernel, forest.count - 1, [bridges])
        bridges.label_nodes()
        launch(find_bridges_kernel, -(-forest.count // LEAF), [bridges])
        launch(select_lows_kernel, forest.count, [bridges])
        launch(select_highs_kernel, forest.count, [bridges])
        launch(hook_bridges_kernel, forest.roots.size, [bridges, normals, going])

    def run_round(status: Integers) -> None:
        bridge(status)
        forest.merge_in_loop(status)

    if forest.links.device.is_cuda:
        forest.run_rounds(run_round)
    else:
        going, before = zeros(1, int32, forest.device), forest.count + 1
        while 1 < forest.roots.size < before:
            before = forest.roots.size
            bridge(going)
            forest.merge()
    if forest.roots.size > 1:
        raise RuntimeError(f"no bridge found between {forest.roots.size} components")


POINTS_PER_THREAD = 4096  # on the CPU in the search for the lowest: one atomic each
MAGNITUDE_MASK = 0x7FFF_FFFF  # bits of a float32 without the sign
HEIGHT_ENTRIES = 2**24  # heights in memory, one per list entry
FENCE_RANGES = 1.5  # interquartile ranges beyond the quartile of an outlier (Tukey)


@func
def unit_vector(v: vec3) -> vec3:
    """Unit vector. Zero stays zero."""
    w = widen(v)
    size = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2])
    unit = v + vec3(0.0, 0.0, 0.0)
    if size > 0.0:
        unit = narrow(w / size)
    return unit


@kernel
def normalize_vectors_kernel(vectors: array(dtype=vec3), units: array(dtype=vec3)):
    i = tid()
    units[i] = unit_vector(vectors[i])


@kernel
def flip_vectors_kernel(vectors: array(dtype=vec3), flipped: array(dtype=vec3)):
    i = tid()
    flipped[i] = -vectors[i]


@kernel
def gather_units_kernel(
    normals: array(dtype=vec3), rows: array(dtype=int32), order: array(dtype=int32), units: array(dtype=vec3)
):
    i = tid()
    units[i] = unit_vector(normals[rows[order[i]]])


@kernel
def drop_neighbors_kernel(
    points: array(dtype=vec3),
    units: array(dtype=vec3),
    begin: int,
    first: int,
    k: int,
    steepest: float,
    outliers: int,
    heights: array(dtype=float32),
    lists: array(dtype=int32),
):
    """Remove edges that are too steep (|cosine| to the normal above `steepest`) or, optionally, outliers of height:
    above the upper quartile by FENCE_RANGES times the interquartile range.
    """
    i = tid()
    v = begin + first + i
    row = (first + i) * k
    out = i * k
    p = points[v]
    n = units[v]
    for j in range(k):
        d = points[lists[row + j]] - p
        heights[out + j] = abs(d[0] * n[0] + d[1] * n[1] + d[2] * n[2])
    fence = 3.4e38
    if outliers == 1:
        low = 0.0
        high = 0.0
        for j in range(k):
            height = heights[out + j]
            rank = 0
            for m in range(k):
                other = heights[out + m]
                if other < height or (other == height and m < j):
                    rank += 1
            if rank == k // 4:
                low = height
            if rank == 3 * k // 4:
                high = height
        fence = high + FENCE_RANGES * (high - low)
    for j in range(k):
        d = points[lists[row + j]] - p
        height = heights[out + j]
        if height > fence or height > steepest * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]):
            lists[row + j] = v


@kernel
def find_lowest_kernel(points: array(dtype=vec3), rows: array(dtype=int32), runs: Runs, lowest: array(dtype=int64)):
    i = tid()
    minimum = int64(NO_KEY)
    for j in elements_of(i, runs):
        z = points[rows[j]][2]
        bits = 0  # zero and minus zero are equal
        if z != 0.0:
            bits = float_bits(z)
        if bits < 0:
            bits = bits ^ MAGNITUDE_MASK  # integers in the order of the floats
        minimum = min(minimum, pack_bits(bits, rows[j]))
    lower_long(lowest, 0, minimum)


@kernel
def spread_words_kernel(
    links: array(dtype=int32), rows: array(dtype=int32), order: array(dtype=int32), words: array(dtype=int32)
):
    i = tid()
    words[rows[order[i]]] = links[i] & 1


@kernel
def apply_signs_kernel(
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    words: array(dtype=int32),
    lowest: array(dtype=int64),
    oriented: array(dtype=vec3),
):
    """Apply the signs so that the normal of the lowest point looks down. Zero normals stay."""
    i = tid()
    row = rows[i]
    low = int(lowest[0] & int64(MAGNITUDE_MASK))
    is_flipped = words[row] ^ words[low]
    m = normals[low]
    if m[2] > 0.0:
        is_flipped = 1 - is_flipped
    n = normals[row]
    if is_flipped == 1 and (n[0] != 0.0 or n[1] != 0.0 or n[2] != 0.0):
        oriented[row] = -n


def normalize_vectors(vectors: Vectors) -> Vectors:
    return compute(normalize_vectors_kernel, vectors.size, [vectors], vec3, vectors.device)


def flip_vectors(vectors: Vectors) -> Vectors:
    return compute(flip_vectors_kernel, vectors.size, [vectors], vec3, vectors.device)


def drop_neighbors(
    parts: Sequence[tuple[int, Integers]], k: int, tree: "PointTree", units: Vectors, steepest: float, outliers: bool
) -> None:
    """Remove edges of a neighbor graph in place. See drop_neighbors_kernel."""
    rows = max(1, HEIGHT_ENTRIES // k)
    heights = empty(rows * k, float32, tree.device)
    for begin, lists in parts:
        total = lists.size // k
        for first in range(0, total, rows):
            drop = [tree.points, units, begin, first, k, steepest, int(outliers), heights, lists]
            launch(drop_neighbors_kernel, min(rows, total - first), drop)


def orient_consistently(
    points: Points,
    normals: Vectors,
    rows: Indices,
    tree: "PointTree",
    k: int,
    steepest: float = 1.0,
    outliers: bool = False,
) -> Vectors:
    """Orient normals of the `usable_rows`. The normal of the lowest point looks down. Edges above the cosine `steepest`
    to a normal and, with `outliers`, of outlying height are removed.
    """
    device = points.device
    oriented = empty(points.size, vec3, device)
    copy(oriented, normals, count=points.size)
    units = compute(gather_units_kernel, rows.size, [normals, rows, tree.order], vec3, device)
    forest = Forest(rows.size, device)
    count = min(k, rows.size)
    parts = list(list_neighbors(tree, count, own=True))
    if steepest < 1.0 or outliers:
        drop_neighbors(parts, count, tree, units, steepest, outliers)
    span_neighbors(forest, parts, count, units)
    del parts
    bridge_components(forest, tree, units)
    words, lowest = empty(points.size, int32, device), full(1, NO_KEY, int64, device)
    runs = Runs(rows.size, device, POINTS_PER_THREAD)
    launch(find_lowest_kernel, runs.threads, [points, rows, runs, lowest])
    launch(spread_words_kernel, rows.size, [forest.links, rows, tree.order, words])
    launch(apply_signs_kernel, rows.size, [normals, rows, words, lowest, oriented])
    return oriented
