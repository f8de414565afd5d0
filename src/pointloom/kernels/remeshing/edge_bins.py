"""Selection of edges by cost: the limit of a round, and the cheapest edges that reach the target.

Costs are counted in a histogram. A radix selection of 12 bits at a time finds the last key to take. For small meshes it
is one launch.
"""

from ..array_types import Bytes, Indices, Keys
from ..arrays.blocks import block_threads, wait_for_block
from ..lang import array, atomic_add, func, int32, int64, kernel, launch, tid, uint8
from ..memory import empty, full, zeros
from ..meshes.mesh_topology import corner_vertex, next_corner
from .collapse_mesh import HIGHEST_BIN, PICKED_COUNT, TRIANGLE_COUNT, CollapseMesh, edge_valence
from .edge_costs import COST_BINS, COST_BITS

MIN_EDGES = 4  # minimum number of edges considered
BIN_BLOCKS = 64  # of bins
BLOCK = COST_BINS // BIN_BLOCKS
DIGIT_BITS = 12  # of COST_BINS
PRICE_SHIFT = 32 + COST_BITS  # of a key: lower bits are zeros and the unique number
KEY_DIGITS = 4  # of a key: 11 bits of the cost and 32 of the unique number


@func
def sum_of_bins(i: int, bins: array(dtype=int32)) -> int:
    total = 0
    for j in range(i * BLOCK, (i + 1) * BLOCK):
        total += bins[j]
    return total


@kernel
def sum_bins_kernel(bins: array(dtype=int32), blocks: array(dtype=int32)):
    i = tid()
    blocks[i] = sum_of_bins(i, bins)


@func
def sum_of_blocks(blocks: array(dtype=int32), count: int) -> int:
    total = 0
    for j in range(count):
        total += blocks[j]
    return total


@kernel
def limit_prices_kernel(blocks: array(dtype=int32), target: int, bins: array(dtype=int32), numbers: array(dtype=int32)):
    """Highest cost bin to consider (or -1): a fraction of edges, at most the triangles to remove; clears bins."""
    i = tid()
    before = sum_of_blocks(blocks, i)
    total = sum_of_blocks(blocks, BIN_BLOCKS)
    excess = numbers[TRIANGLE_COUNT] - target
    fraction = int((int64(total) * 7 + 19) // 20)  # 0.35, rounded up: more is faster and less accurate
    wanted = min(max(min(fraction, excess), MIN_EDGES), total)
    if i == 0 and total == 0:
        numbers[HIGHEST_BIN] = -1
    has_limit = 0
    if total > 0 and before < wanted and before + blocks[i] >= wanted:
        has_limit = 1
    highest = -1
    for j in range(i * BLOCK, (i + 1) * BLOCK):
        is_below = 1 if has_limit == 1 and before < wanted else 0
        before += bins[j]
        if is_below == 1 and before >= wanted:
            highest = j
    for j in range(i * BLOCK, (i + 1) * BLOCK):  # after the loads, which would wait for the stores
        bins[j] = 0
    if highest >= 0:
        numbers[HIGHEST_BIN] = highest


@func
def short_key(key: int64) -> int64:
    return ((key >> int64(PRICE_SHIFT)) << int64(32)) | (key & int64(0xFFFFFFFF))


@func
def is_cut(mesh: CollapseMesh, target: int) -> int:
    """1 if more triangles than necessary would be removed."""
    return 1 if 2 * mesh.numbers[PICKED_COUNT] > mesh.numbers[TRIANGLE_COUNT] - target else 0


@func
def count_removed(
    i: int,
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    digit: int,
    heads: array(dtype=int64),
    bins: array(dtype=int32),
):
    """Triangles removed by the edges of each digit, among those with the digits found so far."""
    h = edges[i]
    key = short_key(mesh.keys[h])
    rest = DIGIT_BITS * (KEY_DIGITS - 1 - digit)
    if (key >> int64(rest + DIGIT_BITS)) == heads[digit]:
        a = corner_vertex(mesh.triangles, h)
        b = corner_vertex(mesh.triangles, next_corner(h))
        atomic_add(bins, int((key >> int64(rest)) & int64(COST_BINS - 1)), edge_valence(mesh, a, b))  # integers


@kernel
def count_removed_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    target: int,
    digit: int,
    heads: array(dtype=int64),
    bins: array(dtype=int32),
):
    i = tid()
    cut = is_cut(mesh, target)
    if i < mesh.numbers[PICKED_COUNT] and cut == 1:
        count_removed(i, mesh, edges, digit, heads, bins)


@func
def find_digit(
    i: int,
    mesh: CollapseMesh,
    blocks: array(dtype=int32),
    target: int,
    digit: int,
    heads: array(dtype=int64),
    rests: array(dtype=int32),
    bins: array(dtype=int32),
):
    """Next digit of the highest key to take (the highest if all are), and the triangles to remove with it."""
    wanted = mesh.numbers[TRIANGLE_COUNT] - target
    if digit > 0:
        wanted = rests[digit]
    before = sum_of_blocks(blocks, i)
    after = before + blocks[i]
    bin_index = -1
    rest = wanted
    if i == BIN_BLOCKS - 1 and after < wanted:
        bin_index = COST_BINS - 1
    for j in range(i * BLOCK, (i + 1) * BLOCK):
        removed = bins[j]
        if before < wanted and before + removed >= wanted:
            bin_index = j
            rest = wanted - before
        before += removed
    for j in range(i * BLOCK, (i + 1) * BLOCK):  # after the loads, which would wait for the stores
        bins[j] = 0
    if bin_index >= 0:
        rests[digit + 1] = rest
        heads[digit + 1] = (heads[digit] << int64(DIGIT_BITS)) | int64(bin_index)


@kernel
def find_digit_kernel(
    mesh: CollapseMesh,
    blocks: array(dtype=int32),
    target: int,
    digit: int,
    heads: array(dtype=int64),
    rests: array(dtype=int32),
    bins: array(dtype=int32),
):
    i = tid()
    if is_cut(mesh, target) == 1:
        find_digit(i, mesh, blocks, target, digit, heads, rests, bins)


@func
def is_cheap(mesh: CollapseMesh, edges: array(dtype=int32), target: int, heads: array(dtype=int64), i: int) -> int:
    """1 for edges up to the key found. For all if that does not exceed the target."""
    taken = 0
    if i < mesh.numbers[PICKED_COUNT]:
        if is_cut(mesh, target) == 0:
            taken = 1
        elif short_key(mesh.keys[edges[i]]) <= heads[KEY_DIGITS]:
            taken = 1
    return taken


@kernel
def mark_cheapest_kernel(
    mesh: CollapseMesh, edges: array(dtype=int32), target: int, heads: array(dtype=int64), mask: array(dtype=uint8)
):
    i = tid()
    mask[i] = uint8(is_cheap(mesh, edges, target, heads, i))


@kernel
def mark_cheapest_at_once_kernel(
    threads: int,
    count: int,
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    target: int,
    blocks: array(dtype=int32),
    heads: array(dtype=int64),
    rests: array(dtype=int32),
    bins: array(dtype=int32),
    mask: array(dtype=uint8),
):
    """All digits: one block on CUDA, one thread on the CPU. `count` flags are written."""
    i = tid()
    digits = int(KEY_DIGITS)
    if is_cut(mesh, target) == 0:
        digits = 0
    for digit in range(digits):
        at = i + 0
        while at < mesh.numbers[PICKED_COUNT]:
            count_removed(at, mesh, edges, digit, heads, bins)
            at += threads
        wait_for_block()
        at = i + 0
        while at < BIN_BLOCKS:
            blocks[at] = sum_of_bins(at, bins)
            at += threads
        wait_for_block()
        at = i + 0
        while at < BIN_BLOCKS:
            find_digit(at, mesh, blocks, target, digit, heads, rests, bins)
            at += threads
        wait_for_block()
    at = i + 0
    while at < count:
        mask[at] = uint8(is_cheap(mesh, edges, target, heads, at))
        at += threads


MAX_AT_ONCE = 2048  # triangles of a mesh whose edges are selected by one block: about four edges per thread


def threads_at_once(mesh: CollapseMesh) -> int:
    """Threads of the launches that select the edges of a small mesh, 0 for a large one."""
    return block_threads(mesh.numbers.device) if mesh.triangles.size <= MAX_AT_ONCE else 0


class EdgeBins:
    def __init__(self, target: int, mesh: CollapseMesh) -> None:
        numbers, device = mesh.numbers, mesh.numbers.device
        self._threads = threads_at_once(mesh)
        self.target, self.numbers = target, numbers
        self.bins, self._blocks = zeros(COST_BINS, int32, device), empty(BIN_BLOCKS, int32, device)
        self._heads: Keys = full(KEY_DIGITS + 1, 0, int64, device)
        self._rests = zeros(KEY_DIGITS + 1, int32, device)

    def limit_prices(self) -> None:
        launch(sum_bins_kernel, BIN_BLOCKS, [self.bins, self._blocks])
        launch(limit_prices_kernel, BIN_BLOCKS, [self._blocks, self.target, self.bins, self.numbers])

    def mark_cheapest(self, mesh: CollapseMesh, edges: Indices, count: int, mask: Bytes) -> None:
        """Mark the cheapest selected edges that reach the target, or all."""
        if self._threads:
            given = [mesh, edges, self.target, self._blocks, self._heads, self._rests, self.bins, mask]
            launch(mark_cheapest_at_once_kernel, self._threads, [self._threads, count, *given])
            return
        for digit in range(KEY_DIGITS):
            launch(count_removed_kernel, count, [mesh, edges, self.target, digit, self._heads, self.bins])
            launch(sum_bins_kernel, BIN_BLOCKS, [self.bins, self._blocks])
            arguments = [mesh, self._blocks, self.target, digit, self._heads, self._rests, self.bins]
            launch(find_digit_kernel, BIN_BLOCKS, arguments)
        launch(mark_cheapest_kernel, count, [mesh, edges, self.target, self._heads, mask])
