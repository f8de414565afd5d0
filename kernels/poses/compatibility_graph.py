"""Which correspondences could be right together: those that keep the distance between their ends, as rows of bits.

A rigid motion keeps distances, so two right correspondences (p, q) and (r, s) have |p - r| and |q - s| alike to within
twice the noise (the invariant of TEASER: Yang, Shi and Carlone 2021, section IV). Wrong ones agree by chance with a
few others; right ones agree with all that are right. How many correspondences both ends of an edge agree with tells
them apart at a percent of right ones, since chance counts twice there (Chen et al., "SC2-PCR: a second order spatial
compatibility for efficient and robust point cloud registration", CVPR 2022, section 3.2).

A bit an edge: m^2 / 8 bytes, 12.5 MB for 10,000 correspondences. Filling it takes some 20 operations a pair of
correspondences, without branches; counting common neighbours m / 32 words an edge. Whole numbers throughout: the same
on every device, whatever the number of threads.
"""

from ..algebra.plain_min_max import smaller
from ..array_types import Indices, Integers, LongIntegers
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, bit_count, func, int32, int64, kernel, launch, sqrt, struct, tid, uint8
from ..memory import download, empty, zeros
from .pair_fits import PairCoordinates

WORD = 32  # bits a word
WORK = 2**29  # words that counting common neighbours may read: half a second of one core
SUM_BITS = 45  # of a sum of common neighbours: below m^2, and m^2 / 8 bytes fit into memory


@struct
class CompatibilityGraph:
    """Correspondences as vertices; an edge joins two that keep their distance.

    Args:
        pairs: A PairCoordinates.
        bound: Most difference [m] of two distances.
        least: Distances up to this [m] join nothing: near each other, any two agree.

    Attributes:
        pairs: The correspondences.
        words: Words of bits a row.
        bits: int32 device array [m * words]: bit j % 32 of word j // 32 of row i is the edge (i, j).
        degrees: Edges of each vertex, int32 [m].
    """

    pairs: PairCoordinates
    words: int
    bits: array(dtype=int32)
    degrees: array(dtype=int32)

    def __init__(self, pairs: PairCoordinates, bound: float, least: float) -> None:
        self.pairs, self.device, self.count = pairs, pairs.device, pairs.count
        self.words = -(-self.count // WORD)
        self.bits = empty(self.count * self.words, int32, self.device)
        self.degrees = empty(self.count, int32, self.device)
        launch(connect_pairs_kernel, self.count, [self, bound, least])

    def support(self, work: int = WORK) -> LongIntegers:
        """Twice the triangles of each vertex, int64 device array [m].

        Counted for the vertices with most edges until `work` words are read, 0 for the rest: where edges are so many,
        degrees tell right from wrong already.
        """
        sums, degrees = zeros(self.count, int64, self.device), empty(self.count, int64, self.device)
        launch(widen_counts_kernel, self.count, [self.degrees, degrees])
        order = order_descending(degrees)
        ranked = download(gather_rows(self.degrees, order)).cumsum(dtype="int64")  # sync
        counted = max(1, int((ranked * self.words <= work).sum()))
        launch(sum_common_kernel, counted, [self, order[:counted], sums])
        return sums

    def peaks(self, sums: LongIntegers, distance: float, most: int) -> Integers:
        """The vertices with the largest sums, none of them near a larger one at both ends; int32, largest first."""
        mask = empty(self.count, uint8, self.device)
        launch(mark_peaks_kernel, self.count, [self.pairs, distance * distance, sums, mask])
        rows = positions_of(mask)  # sync
        if rows.size == 0:
            return rows
        order = order_descending(gather_rows(sums, rows))
        return gather_rows(rows, order[: min(most, rows.size)])

    def common(self, rows: Indices) -> Integers:
        """Shared neighbours of some rows with all vertices, int32 [rows * m]; 0 without an edge."""
        common = empty(rows.size * self.count, int32, self.device)
        launch(list_common_kernel, rows.size, [self, rows, common])
        return common


@kernel
def connect_pairs_kernel(graph: CompatibilityGraph, bound: float, least: float):
    """One row of the graph: the correspondences that keep their distance to this one, and how many they are."""
    i = tid()
    px = graph.pairs.coordinates[i]
    py = graph.pairs.coordinates[graph.pairs.count + i]
    pz = graph.pairs.coordinates[2 * graph.pairs.count + i]
    qx = graph.pairs.coordinates[3 * graph.pairs.count + i]
    qy = graph.pairs.coordinates[4 * graph.pairs.count + i]
    qz = graph.pairs.coordinates[5 * graph.pairs.count + i]
    degree = 0
    for w in range(graph.words):
        first = w * WORD
        word = 0
        for j in range(first, min(first + WORD, graph.pairs.count)):
            x = graph.pairs.coordinates[j] - px
            y = graph.pairs.coordinates[graph.pairs.count + j] - py
            z = graph.pairs.coordinates[2 * graph.pairs.count + j] - pz
            u = graph.pairs.coordinates[3 * graph.pairs.count + j] - qx
            v = graph.pairs.coordinates[4 * graph.pairs.count + j] - qy
            t = graph.pairs.coordinates[5 * graph.pairs.count + j] - qz
            a = sqrt(x * x + y * y + z * z)
            b = sqrt(u * u + v * v + t * t)
            alike = 1 if abs(a - b) <= bound else 0
            apart = 1 if smaller(a, b) > least else 0  # false of a correspondence with itself
            word = word | ((alike & apart) << (j - first))
        graph.bits[i * graph.words + w] = word
        degree += bit_count(word)
    graph.degrees[i] = degree


@kernel
def descending_keys_kernel(values: array(dtype=int64), top: int64, keys: array(dtype=int64)):
    """Keys whose ascending order is the values' descending one."""
    i = tid()
    keys[i] = top - values[i]


@kernel
def widen_counts_kernel(counts: array(dtype=int32), values: array(dtype=int64)):
    """The counts in 64 bits."""
    i = tid()
    values[i] = int64(counts[i])


@func
def count_shared(row: int, other: int, graph: CompatibilityGraph) -> int:
    """How many neighbours two correspondences share."""
    a = row * graph.words
    b = other * graph.words
    shared = 0
    for k in range(graph.words):
        shared += bit_count(graph.bits[a + k] & graph.bits[b + k])
    return shared


@kernel
def sum_common_kernel(graph: CompatibilityGraph, rows: array(dtype=int32), sums: array(dtype=int64)):
    """Over the neighbours of a row, how many neighbours they share with it: twice the triangles that it is in."""
    i = tid()
    row = rows[i] * graph.words
    total = int64(0)
    for w in range(graph.words):
        left = graph.bits[row + w]
        while left != 0:
            lowest = left & (-left)
            left = left ^ lowest
            total += int64(count_shared(rows[i], w * WORD + bit_count(lowest - 1), graph))
    sums[rows[i]] = total


@kernel
def list_common_kernel(graph: CompatibilityGraph, rows: array(dtype=int32), common: array(dtype=int32)):
    """How many neighbours a row shares with each other correspondence; 0 where they are not neighbours themselves."""
    i = tid()
    row = rows[i] * graph.words
    for j in range(graph.pairs.count):
        common[i * graph.pairs.count + j] = 0
    for w in range(graph.words):
        left = graph.bits[row + w]
        while left != 0:
            lowest = left & (-left)
            left = left ^ lowest
            column = w * WORD + bit_count(lowest - 1)
            common[i * graph.pairs.count + column] = count_shared(rows[i], column, graph)


@kernel
def mark_peaks_kernel(pairs: PairCoordinates, reach: float, sums: array(dtype=int64), peaks: array(dtype=uint8)):
    """1 where no correspondence near this one at both ends has more support, or as much and a lower index."""
    i = tid()
    own = sums[i]
    px = pairs.coordinates[i]
    py = pairs.coordinates[pairs.count + i]
    pz = pairs.coordinates[2 * pairs.count + i]
    qx = pairs.coordinates[3 * pairs.count + i]
    qy = pairs.coordinates[4 * pairs.count + i]
    qz = pairs.coordinates[5 * pairs.count + i]
    beaten = 0
    for j in range(pairs.count):
        x = pairs.coordinates[j] - px
        y = pairs.coordinates[pairs.count + j] - py
        z = pairs.coordinates[2 * pairs.count + j] - pz
        u = pairs.coordinates[3 * pairs.count + j] - qx
        v = pairs.coordinates[4 * pairs.count + j] - qy
        t = pairs.coordinates[5 * pairs.count + j] - qz
        near = (1 if x * x + y * y + z * z < reach else 0) & (1 if u * u + v * v + t * t < reach else 0)
        more = (1 if sums[j] > own else 0) | ((1 if sums[j] == own else 0) & (1 if j < i else 0))
        beaten = beaten | (near & more)
    peak = 0
    if beaten == 0 and own > 0:
        peak = 1
    peaks[i] = uint8(peak)


def order_descending(values: LongIntegers, bit_count: int = SUM_BITS) -> Indices:
    """The order of int64 values that are not negative, largest first, ties by index; int32."""
    keys = empty(values.size, int64, values.device)
    launch(descending_keys_kernel, values.size, [values, (1 << bit_count) - 1, keys])
    return argsort_keys(keys, bit_count)[1]
