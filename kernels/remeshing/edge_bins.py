"""Which edges are looked at in a round, and which of those that may collapse do: numbers found by counts in bins.

The price up to which edges are looked at is that of a bin. Towards the end the cheapest edges are found to the one
with which enough triangles are gone: digit by digit of their keys, as a radix sort would, without their order. A block
of bins is summed, then a thread a block finds out whether the number falls into it: 64 numbers are read, and 64 more.
"""

from ..array_types import Bytes, Indices, Keys
from ..lang import array, atomic_add, func, int32, int64, kernel, launch, tid, uint8
from ..memory import empty, full, zeros
from ..meshes.mesh_topology import corner_vertex, next_corner
from .collapse_mesh import BIN, PICKED, TRIANGLES, CollapseMesh, edge_valence
from .edge_prices import BINS, STEP

LEAST = 4  # edges are looked at in any case
BLOCKS = 64  # of bins
BLOCK = BINS // BLOCKS
DIGIT_BITS = 12  # of BINS
PRICE_SHIFT = 32 + STEP  # of a key: below are zeros and its own number
DIGITS = 4  # of a key: 11 bits of the price and 32 of its own number


@kernel
def sum_bins_kernel(bins: array(dtype=int32), blocks: array(dtype=int32)):
    """The sum of each block of bins."""
    i = tid()
    total = 0
    for j in range(i * BLOCK, (i + 1) * BLOCK):
        total += bins[j]
    blocks[i] = total


@func
def sum_of_blocks(blocks: array(dtype=int32), count: int) -> int:
    """The sum of the first blocks."""
    total = 0
    for j in range(count):
        total += blocks[j]
    return total


@kernel
def limit_prices_kernel(blocks: array(dtype=int32), target: int, bins: array(dtype=int32), numbers: array(dtype=int32)):
    """The bin of the dearest edge to be looked at, -1 where there is none; and bins of zero for the next round.

    They are a share of all, and no more than triangles are to go: towards the end only the cheapest should.
    """
    i = tid()
    before = sum_of_blocks(blocks, i)
    total = sum_of_blocks(blocks, BLOCKS)
    excess = numbers[TRIANGLES] - target
    share = int((int64(total) * 7 + 19) // 20)  # 0.35, rounded up: more is faster and less exact
    wanted = min(max(min(share, excess), LEAST), total)
    if i == 0 and total == 0:
        numbers[BIN] = -1
    has_limit = 0
    if total > 0 and before < wanted and before + blocks[i] >= wanted:
        has_limit = 1
    for j in range(i * BLOCK, (i + 1) * BLOCK):
        if has_limit == 1 and before < wanted:
            before += bins[j]
            if before >= wanted:
                numbers[BIN] = j
        bins[j] = 0


@func
def short_key(key: int64) -> int64:
    """A key without the bits that are zero in all."""
    return ((key >> int64(PRICE_SHIFT)) << int64(32)) | (key & int64(0xFFFFFFFF))


@func
def is_cut(mesh: CollapseMesh, target: int) -> int:
    """1 where more than enough triangles might go."""
    return 1 if 2 * mesh.numbers[PICKED] > mesh.numbers[TRIANGLES] - target else 0


@kernel
def count_gone_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    target: int,
    digit: int,
    heads: array(dtype=int64),
    bins: array(dtype=int32),
):
    """How many triangles go with the edges of each digit, of those whose digits before are the ones that were found."""
    i = tid()
    cut = is_cut(mesh, target)
    if i >= mesh.numbers[PICKED] or cut == 0:
        return
    h = edges[i]
    key = short_key(mesh.keys[h])
    rest = DIGIT_BITS * (DIGITS - 1 - digit)
    if (key >> int64(rest + DIGIT_BITS)) == heads[digit]:
        a = corner_vertex(mesh.triangles, h)
        b = corner_vertex(mesh.triangles, next_corner(h))
        atomic_add(bins, int((key >> int64(rest)) & int64(BINS - 1)), edge_valence(mesh, a, b))  # whole numbers


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
    """The next digit of the dearest key to be taken, and how many triangles are to go with it; the highest for all."""
    i = tid()
    if is_cut(mesh, target) == 0:
        return
    wanted = mesh.numbers[TRIANGLES] - target
    if digit > 0:
        wanted = rests[digit]
    before = sum_of_blocks(blocks, i)
    after = before + blocks[i]
    found = -1
    if i == BLOCKS - 1 and after < wanted:
        found = BINS - 1
        rests[digit + 1] = wanted
    for j in range(i * BLOCK, (i + 1) * BLOCK):
        if before < wanted:
            if before + bins[j] >= wanted:
                found = j
                rests[digit + 1] = wanted - before
        before += bins[j]
        bins[j] = 0
    if found >= 0:
        heads[digit + 1] = (heads[digit] << int64(DIGIT_BITS)) | int64(found)


@kernel
def mark_cheapest_kernel(
    mesh: CollapseMesh, edges: array(dtype=int32), target: int, heads: array(dtype=int64), mask: array(dtype=uint8)
):
    """1 for the edges up to the key that was found; for all where no more triangles would go than are to."""
    i = tid()
    taken = 0
    if i < mesh.numbers[PICKED]:
        if is_cut(mesh, target) == 0:
            taken = 1
        elif short_key(mesh.keys[edges[i]]) <= heads[DIGITS]:
            taken = 1
    mask[i] = uint8(taken)


class EdgeBins:
    """Room for the counts; the bins are zero between two steps."""

    def __init__(self, target: int, numbers: Indices) -> None:
        device = numbers.device
        self.target, self.numbers = target, numbers
        self.bins, self._blocks = zeros(BINS, int32, device), empty(BLOCKS, int32, device)
        self._heads: Keys = full(DIGITS + 1, 0, int64, device)
        self._rests = zeros(DIGITS + 1, int32, device)

    def limit_prices(self) -> None:
        """Find the bin up to which edges are looked at, of the prices that were counted."""
        launch(sum_bins_kernel, BLOCKS, [self.bins, self._blocks])
        launch(limit_prices_kernel, BLOCKS, [self._blocks, self.target, self.bins, self.numbers])

    def mark_cheapest(self, mesh: CollapseMesh, edges: Indices, count: int, mask: Bytes) -> None:
        """Mark the cheapest of the picked edges, as many as it takes for the target; all where they are not enough."""
        for digit in range(DIGITS):
            launch(count_gone_kernel, count, [mesh, edges, self.target, digit, self._heads, self.bins])
            launch(sum_bins_kernel, BLOCKS, [self.bins, self._blocks])
            arguments = [mesh, self._blocks, self.target, digit, self._heads, self._rests, self.bins]
            launch(find_digit_kernel, BLOCKS, arguments)
        launch(mark_cheapest_kernel, count, [mesh, edges, self.target, self._heads, mask])
