"""Minimum spanning forests that propagate signs: each vertex stores its component's root and its sign relative to it.

Boruvka's algorithm as rounds of parallel hooking and shortening (Vineet, Harish, Patidar and Narayanan, "Fast minimum
spanning tree for large graphs on the GPU", HPG 2009). The tree itself is not stored. Edges are ordered by weight,
vertex, list position, so the tree is unique and independent of the number of threads. 20 B per vertex beside the lists.
"""

from collections.abc import Callable, Sequence

from ..array_types import Device, Integers, LongIntegers, Vectors
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import fill_positions_kernel
from ..lang import (
    array,
    atomic_add,
    atomic_min,
    compute,
    float64,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    loop_while,
    struct,
    tid,
    uint8,
    vec3,
)
from ..memory import copy, download, empty, fill, full, zeros

ENTRY_BITS = 33  # of a key, for the list entry. The weight 0..1 has the 30 bits above
ENTRY_MASK = 0x1_FFFF_FFFF
MAX_VERTICES = 2**30  # a word has a root and a sign in 31 bits
MAX_HOPS = 64  # links followed per pass: nearly all chains are shorter
MAX_PASSES = 6  # MAX_HOPS^5 exceeds the maximum number of vertices


@struct
class Forest:
    """Components of vertices. `links`, `hooks`: twice the root (or its next parent) plus 1 if flipped against it."""

    links: array(dtype=int32)
    roots: array(dtype=int32)
    hooks: array(dtype=int32)

    def __init__(self, count: int, device: Device) -> None:
        if count > MAX_VERTICES:
            raise ValueError(f"{count} vertices are more than 2^30; split the cloud")
        self.count, self.device = count, device
        self.links, self.roots = empty(count, int32, device), empty(count, int32, device)
        self.hooks, self._shorter = empty(count, int32, device), empty(count, int32, device)
        launch(fill_roots_kernel, count, [self])
        launch(fill_positions_kernel, count, [self.roots])
        self._every = self.roots
        self.reset_hooks()

    def reset_hooks(self) -> None:
        launch(reset_hooks_kernel, self.roots.size, [self])

    def merge(self) -> None:
        """Join components along their hooks (two syncs, rarely more). Raises RuntimeError if a cycle closes."""
        for _ in range(MAX_PASSES):
            counter = zeros(1, int32, self.device)
            launch(shorten_hooks_kernel, self.roots.size, [self, self._shorter, counter])
            self.hooks, self._shorter = self._shorter, self.hooks
            if int(download(counter)[0]) == 0:  # sync
                break
        else:
            raise RuntimeError("components hang under each other in a cycle")
        launch(relink_vertices_kernel, self.count, [self])
        mask = compute(mark_roots_kernel, self.roots.size, [self], uint8, self.device)
        self.roots = gather_rows(self.roots, positions_of(mask))
        self.reset_hooks()

    def merge_in_loop(self, status: Integers) -> None:
        """`merge` in a device loop, without sync; `status`: loop flag, links in cycles, links longer than a pass."""
        for left in range(MAX_PASSES - 1, -1, -1):  # an even number, so that hooks end in place
            launch(shorten_hooks_kernel, self.count, [self, self._shorter, status[2:3] if left else status[1:2]])
            self.hooks, self._shorter = self._shorter, self.hooks
        launch(relink_vertices_kernel, self.count, [self])
        launch(close_round_kernel, self.count, [self, status])

    def run_rounds(self, run_round: Callable[[Integers], None]) -> None:
        """Run iterations ending with `merge_in_loop` until none joins (two syncs). Raises RuntimeError for a cycle.
        `run_round(status)` sets status[0] to 0, and to 1 if there is an edge to join.
        """
        status = full(3, 0, int32, self.device)
        fill(status[:1], 1)
        launch(fill_positions_kernel, self.count, [self._every])
        self.roots = self._every
        loop_while(status[:1], lambda: run_round(status))
        mask = compute(mark_roots_kernel, self.count, [self], uint8, self.device)
        self.roots = positions_of(mask)  # sync
        if self.roots.size > 1 and int(download(status)[1]):  # sync
            raise RuntimeError("components hang under each other in a cycle")


@struct
class GraphPart:
    """Edges of consecutive vertices from `begin`, `k` each. An entry of `lists` equal to its vertex is no edge."""

    begin: int
    k: int
    lists: array(dtype=int32)

    def __init__(self, begin: int, k: int, lists: Integers) -> None:
        self.begin, self.k, self.lists = begin, k, lists


@func
def agreement(a: vec3, b: vec3) -> float64:
    return float64(a[0]) * float64(b[0]) + float64(a[1]) * float64(b[1]) + float64(a[2]) * float64(b[2])


@func
def normal_weight(a: vec3, b: vec3) -> float:
    """1 - |cos| in 0..1, subtracted in float64 to resolve small angles."""
    return max(float(1.0 - abs(agreement(a, b))), 0.0)


@func
def compose(word: int, onward: int) -> int:
    """Word of a vertex whose root has a word itself: the new root with both signs multiplied."""
    return onward ^ (word & 1)


@func
def hook_word(near: int, far: int, forest: Forest, normals: array(dtype=vec3)) -> int:
    """Word that hooks the component of `near` to that of `far` with agreeing normals."""
    is_flipped = 0
    if agreement(normals[near], normals[far]) < 0.0:
        is_flipped = 1
    return compose(is_flipped, compose(forest.links[near] & 1, forest.links[far]))


@kernel
def fill_roots_kernel(forest: Forest):
    i = tid()
    forest.links[i] = 2 * i


@kernel
def clear_keys_kernel(forest: Forest, keys: array(dtype=int64), going: array(dtype=int32)):
    """Reset the best edges; `going` is set later if one is offered."""
    i = tid()
    if i == 0:
        going[0] = 0
    keys[forest.roots[i]] = int64(NO_KEY)


@kernel
def offer_edges_kernel(
    active: array(dtype=int32),
    part: GraphPart,
    normals: array(dtype=vec3),
    forest: Forest,
    keys: array(dtype=int64),
    leaving: array(dtype=uint8),
    going: array(dtype=int32),
):
    """Offer each listed edge that leaves its component to both, and flag its vertex. All writers of `going` write 1. A
    stale key costs one needless atomic, never a wrong result.
    """
    i = tid()
    if leaving[i] == 0:
        return
    v = active[i]
    own = forest.links[v] >> 1
    n = normals[v]
    min_key = int64(NO_KEY)
    row = (v - part.begin) * part.k
    for j in range(part.k):
        u = part.lists[row + j]
        other = forest.links[u] >> 1
        if other != own:
            weight = int64(float_bits(normal_weight(n, normals[u])))
            key = (weight << int64(ENTRY_BITS)) | (int64(v) * int64(part.k) + int64(j))
            min_key = min(min_key, key)
            if key < keys[other]:
                atomic_min(keys, other, key)  # resolves the race: the component's minimum edge
    is_leaving = 0
    if min_key < int64(NO_KEY):
        is_leaving = 1
        going[0] = 1
        if min_key < keys[own]:
            atomic_min(keys, own, min_key)  # as above
    leaving[i] = uint8(is_leaving)


@kernel
def reset_hooks_kernel(forest: Forest):
    i = tid()
    forest.hooks[forest.roots[i]] = 2 * forest.roots[i]


@kernel
def hook_components_kernel(part: GraphPart, normals: array(dtype=vec3), forest: Forest, keys: array(dtype=int64)):
    """Hook each component along its edge if the edge is in this part. Of a mutual pair the lower stays a root."""
    i = tid()
    c = forest.roots[i]
    key = keys[c]
    entry = (key & int64(ENTRY_MASK)) - int64(part.begin) * int64(part.k)
    if key < int64(NO_KEY) and entry >= 0 and entry < int64(part.lists.shape[0]):
        near = part.begin + int(entry) // part.k
        far = part.lists[int(entry)]
        if forest.links[near] >> 1 != c:
            near = far
            far = part.begin + int(entry) // part.k
        other = forest.links[far] >> 1
        if keys[other] != key or other < c:
            forest.hooks[c] = hook_word(near, far, forest, normals)


@kernel
def shorten_hooks_kernel(forest: Forest, shorter: array(dtype=int32), unfinished: array(dtype=int32)):
    """Follow links up to MAX_HOPS times. Count those that have not reached a root."""
    i = tid()
    word = forest.hooks[forest.roots[i]]
    hop = 0
    above = forest.hooks[word >> 1]
    while above >> 1 != word >> 1 and hop < MAX_HOPS:
        word = compose(word, above)
        above = forest.hooks[word >> 1]
        hop += 1
    if above >> 1 != word >> 1:
        atomic_add(unfinished, 0, 1)  # integer sum: order-independent
    shorter[forest.roots[i]] = word


@kernel
def relink_vertices_kernel(forest: Forest):
    i = tid()
    forest.links[i] = compose(forest.links[i], forest.hooks[forest.links[i] >> 1])


@kernel
def close_round_kernel(forest: Forest, status: array(dtype=int32)):
    """Reset the hooks; stop if links closed a cycle."""
    i = tid()
    forest.hooks[i] = 2 * i
    if i == 0 and status[1] > 0:
        status[0] = 0


@kernel
def mark_roots_kernel(forest: Forest, mask: array(dtype=uint8)):
    i = tid()
    is_root = 0
    if forest.links[forest.roots[i]] >> 1 == forest.roots[i]:
        is_root = 1
    mask[i] = uint8(is_root)


def span_neighbors(forest: Forest, parts: Sequence[tuple[int, Integers]], k: int, normals: Vectors | None) -> None:
    """Join a forest (in place) along minimum spanning trees with weights 1 - |n . n'|. `parts` as of `list_neighbors`.
    An entry equal to its vertex is no edge. Raises ValueError for 2^33 entries or more.
    """
    if forest.count * k > ENTRY_MASK:
        raise ValueError(f"{forest.count} points with {k} neighbors each are more than 2^33; lower k")
    keys = empty(forest.count, int64, forest.device)
    graph = []
    for begin, lists in parts:
        rows = lists.size // k
        active = empty(rows, int32, forest.device)
        copy(active, forest.roots[begin : begin + rows], count=rows)
        graph.append((GraphPart(begin, k, lists), active))
    if forest.links.device.is_cuda and graph and forest.count > 1:
        _span_on_device(forest, graph, normals, keys)
        return
    going = zeros(1, int32, forest.device)
    while graph and forest.roots.size > 1:
        launch(clear_keys_kernel, forest.roots.size, [forest, keys, going])
        remaining = []
        for part, active in graph:
            leaving = full(active.size, 1, uint8, forest.device)
            launch(offer_edges_kernel, active.size, [active, part, normals, forest, keys, leaving, going])
            remaining.append((part, gather_rows(active, positions_of(leaving))))
        if not any(active.size for _, active in remaining):
            break
        for part, _ in graph:
            launch(hook_components_kernel, forest.roots.size, [part, normals, forest, keys])
        forest.merge()
        graph = [(part, active) for part, active in remaining if active.size]


def _span_on_device(
    forest: Forest, graph: Sequence[tuple[GraphPart, Integers]], normals: Vectors | None, keys: LongIntegers
) -> None:
    leaving = [full(active.size, 1, uint8, forest.device) for _, active in graph]

    def run_round(status: Integers) -> None:
        launch(clear_keys_kernel, forest.count, [forest, keys, status])
        for (part, active), marks in zip(graph, leaving, strict=True):
            launch(offer_edges_kernel, active.size, [active, part, normals, forest, keys, marks, status])
        for part, _ in graph:
            launch(hook_components_kernel, forest.count, [part, normals, forest, keys])
        forest.merge_in_loop(status)

    forest.run_rounds(run_round)
