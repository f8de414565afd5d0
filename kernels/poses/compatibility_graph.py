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
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, bit_count, float32, int32, int64, kernel, launch, sqrt, tid, uint8
from ..memory import empty, zeros

WORD = 32  # bits a word
WORK = 2**29  # words that counting common neighbours may read: half a second of one core
SUM_BITS = 45  # of a sum of common neighbours: below m^2, and m^2 / 8 bytes fit into memory


@kernel
def connect_pairs_kernel(
    coordinates: array(dtype=float32),
    count: int,
    words: int,
    bound: float,
    least: float,
    bits: array(dtype=int32),
    degrees: array(dtype=int32),
):
    """One row of the graph: the correspondences that keep their distance to this one, and how many they are."""
    i = tid()
    px = coordinates[i]
    py = coordinates[count + i]
    pz = coordinates[2 * count + i]
    qx = coordinates[3 * count + i]
    qy = coordinates[4 * count + i]
    qz = coordinates[5 * count + i]
    degree = int(0)
    for w in range(words):
        first = w * WORD
        word = int(0)
        for j in range(first, min(first + WORD, count)):
            x = coordinates[j] - px
            y = coordinates[count + j] - py
            z = coordinates[2 * count + j] - pz
            u = coordinates[3 * count + j] - qx
            v = coordinates[4 * count + j] - qy
            t = coordinates[5 * count + j] - qz
            a = sqrt(x * x + y * y + z * z)
            b = sqrt(u * u + v * v + t * t)
            alike = 1 if abs(a - b) <= bound else 0
            apart = 1 if smaller(a, b) > least else 0  # false of a correspondence with itself
            word = word | ((alike & apart) << (j - first))
        bits[i * words + w] = word
        degree += bit_count(word)
    degrees[i] = degree


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


@kernel
def sum_common_kernel(bits: array(dtype=int32), words: int, rows: array(dtype=int32), sums: array(dtype=int64)):
    """Over the neighbours of a row, how many neighbours they share with it: twice the triangles that it is in."""
    i = tid()
    row = rows[i] * words
    total = int64(0)
    for w in range(words):
        left = bits[row + w]
        while left != 0:
            lowest = left & (-left)
            left = left ^ lowest
            other = (w * WORD + bit_count(lowest - 1)) * words
            shared = int(0)
            for k in range(words):
                shared += bit_count(bits[row + k] & bits[other + k])
            total += int64(shared)
    sums[rows[i]] = total


@kernel
def list_common_kernel(
    bits: array(dtype=int32), words: int, count: int, rows: array(dtype=int32), common: array(dtype=int32)
):
    """How many neighbours a row shares with each other correspondence; 0 where they are not neighbours themselves."""
    i = tid()
    row = rows[i] * words
    for j in range(count):
        common[i * count + j] = 0
    for w in range(words):
        left = bits[row + w]
        while left != 0:
            lowest = left & (-left)
            left = left ^ lowest
            column = w * WORD + bit_count(lowest - 1)
            other = column * words
            shared = int(0)
            for k in range(words):
                shared += bit_count(bits[row + k] & bits[other + k])
            common[i * count + column] = shared


@kernel
def mark_peaks_kernel(
    coordinates: array(dtype=float32),
    count: int,
    reach: float,
    sums: array(dtype=int64),
    peaks: array(dtype=uint8),
):
    """1 where no correspondence near this one at both ends has more support, or as much and a lower index."""
    i = tid()
    own = sums[i]
    px = coordinates[i]
    py = coordinates[count + i]
    pz = coordinates[2 * count + i]
    qx = coordinates[3 * count + i]
    qy = coordinates[4 * count + i]
    qz = coordinates[5 * count + i]
    beaten = int(0)
    for j in range(count):
        x = coordinates[j] - px
        y = coordinates[count + j] - py
        z = coordinates[2 * count + j] - pz
        u = coordinates[3 * count + j] - qx
        v = coordinates[4 * count + j] - qy
        t = coordinates[5 * count + j] - qz
        near = (1 if x * x + y * y + z * z < reach else 0) & (1 if u * u + v * v + t * t < reach else 0)
        more = (1 if sums[j] > own else 0) | ((1 if sums[j] == own else 0) & (1 if j < i else 0))
        beaten = beaten | (near & more)
    peak = int(0)
    if beaten == 0 and own > int64(0):
        peak = 1
    peaks[i] = uint8(peak)


def order_descending(values, bit_count=SUM_BITS):
    """The order of int64 values that are not negative, largest first, ties by index; int32."""
    keys = empty(values.size, int64, values.device)
    launch(descending_keys_kernel, values.size, [values, (1 << bit_count) - 1, keys])
    return argsort_keys(keys, bit_count)[1]


class CompatibilityGraph:
    """Correspondences as vertices; an edge joins two that keep their distance.

    Args:
        pairs: A PairCoordinates.
        bound: Most difference [m] of two distances.
        least: Distances up to this [m] join nothing: near each other, any two agree.

    Attributes:
        bits: int32 device array [m * words]: bit j % 32 of word j // 32 of row i is the edge (i, j).
        degrees: Edges of each vertex, int32 [m].
    """

    def __init__(self, pairs, bound, least):
        self.pairs, self.device, self.count = pairs, pairs.device, pairs.count
        self.words = -(-self.count // WORD)
        self.bits = empty(self.count * self.words, int32, self.device)
        self.degrees = empty(self.count, int32, self.device)
        arguments = [pairs.coordinates, self.count, self.words, bound, least, self.bits, self.degrees]
        launch(connect_pairs_kernel, self.count, arguments)

    def support(self, work=WORK):
        """Twice the triangles of each vertex, int64 device array [m].

        Counted for the vertices with most edges until `work` words are read, 0 for the rest: where edges are so many,
        degrees tell right from wrong already.
        """
        sums, degrees = zeros(self.count, int64, self.device), empty(self.count, int64, self.device)
        launch(widen_counts_kernel, self.count, [self.degrees, degrees])
        order = order_descending(degrees)
        ranked = gather_rows(self.degrees, order).numpy().cumsum(dtype="int64")  # sync
        counted = max(1, int((ranked * self.words <= work).sum()))
        launch(sum_common_kernel, counted, [self.bits, self.words, order[:counted].contiguous(), sums])
        return sums

    def peaks(self, sums, distance, most):
        """The vertices with the largest sums, none of them near a larger one at both ends; int32, largest first."""
        mask = empty(self.count, uint8, self.device)
        launch(mark_peaks_kernel, self.count, [self.pairs.coordinates, self.count, distance * distance, sums, mask])
        rows = positions_of(mask)  # sync
        if rows.size == 0:
            return rows
        order = order_descending(gather_rows(sums, rows))
        return gather_rows(rows, order[: min(most, rows.size)].contiguous())

    def common(self, rows):
        """Shared neighbours of some rows with all vertices, int32 [rows * m]; 0 without an edge."""
        common = empty(rows.size * self.count, int32, self.device)
        launch(list_common_kernel, rows.size, [self.bits, self.words, self.count, rows, common])
        return common
