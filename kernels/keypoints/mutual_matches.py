"""Mutual nearest descriptors of pairs of pictures, many pairs in one launch.

The squared distance of two descriptors a and b is |a|^2 + |b|^2 - 2 a b, all of them whole numbers. A feature's match
is the nearest one of the other picture, where it is near enough and clearly nearer than the second (Lowe 2004,
section 7.1); it is kept where the same holds the other way round. The way back is asked only for features that are
somebody's match, few of them where two pictures show different things.

One thread takes eight features of one picture of a pair and walks the blocks of the other, eight at a time for all of
them. It reads 128 B of each feature of the other picture a feature, of which sixteen are multiplied at once
(language/byte_products.py): 1.4 ns for two descriptors on a core with AVX-512 VNNI, 1.7 with AVX2. Signed bytes, 128
less than the numbers, are what the CPU multiplies with unsigned ones: the sum of a descriptor makes up for it. Ties go
to the lower number: the same matches on any device and number of threads.

Not made: one pass for both directions. The way back is a sixth of the time on the fountain, and a pass for both would
keep two minima of each column.
"""

import numpy as np

from ..array_types import Array1, Device, Indices, Integers, Mask
from ..arrays.select import positions_of
from ..features.epipolar_matching import search_of
from ..lang import array, float64, func, int8, int32, kernel, launch, sixteen_products, struct, tid, uint8, vec3i
from ..memory import download, empty, upload
from .descriptors import WIDTH

NO_MATCH = -1
BLOCK = 16  # descriptors that are multiplied with one at once
ROWS = 8  # features that a thread looks for, with blocks that stay in the nearest cache
TURN = 8  # blocks that it takes for all of them
PADDING = 0x40000000  # squared length where a block's descriptors end: farther than any
FARTHEST = 0x7FFFFFFF  # beyond any squared distance of two descriptors


@struct
class Descriptors:
    """Descriptors of pictures, one picture's after the other's.

    Args:
        firsts: The first feature of each picture, and the number of all, [n + 1].
        descriptors: uint8 [m, 128].
        device: Where to match.

    Attributes:
        first_blocks: The first block of each picture, and the number of all, int32 [n + 1].
        blocks: Descriptors less 128, four numbers of one, four of the next: int8 [b, 16 x 128].
        squares: Squared lengths in blocks, int32 [16 b].
        offsets: Of each descriptor its squared length less 256 times its sum, int32 [m]: what is missing from the
            squared distance to one of length s that has a product p with it in blocks is s - 2 p.
    """

    firsts: array(dtype=int32)
    descriptors: array(dtype=uint8, ndim=2)
    first_blocks: array(dtype=int32)
    blocks: array(dtype=int8, ndim=2)
    squares: array(dtype=int32)
    offsets: array(dtype=int32)

    def __init__(self, firsts: np.ndarray, descriptors: np.ndarray, device: Device) -> None:
        self.device, self.host_firsts = device, firsts
        self.firsts, self.descriptors = upload(firsts, int32, device), upload(descriptors, uint8, device)
        counts = -(-(firsts[1:] - firsts[:-1]) // BLOCK)
        first_blocks = np.concatenate([[0], np.cumsum(counts)])
        owners = np.repeat(np.arange(len(counts)), counts)
        self.first_blocks = upload(first_blocks, int32, device)
        self.blocks = empty((len(owners), BLOCK * WIDTH), int8, device)
        self.squares: Integers = empty(BLOCK * len(owners), int32, device)
        self.offsets: Integers = empty(len(descriptors), int32, device)
        arrays = [self.firsts, self.first_blocks, upload(owners, int32, device), self.descriptors]
        launch(fill_blocks_kernel, self.squares.size, [*arrays, self.blocks, self.squares, self.offsets])


@struct
class PictureSearches:
    """Pairs of pictures, one after the other.

    Attributes:
        starts: Number of the first feature of each pair's first picture, and of all of them, int32 [p + 1].
        groups: The same of groups of features, int32 [p + 1].
        pictures: First and second picture of each, int32 [p, 2].
        ratio: Of the squared distances of the nearest and the second feature.
        most: Squared distance of a match.
    """

    starts: array(dtype=int32)
    groups: array(dtype=int32)
    pictures: array(dtype=int32, ndim=2)
    ratio: float64
    most: int

    def __init__(self, starts: np.ndarray, pairs: np.ndarray, ratio: float, most: int, device: Device) -> None:
        self.starts, self.pictures = upload(starts, int32, device), upload(pairs, int32, device)
        groups = np.concatenate([[0], np.cumsum(-(-(starts[1:] - starts[:-1]) // ROWS))])
        self.groups, self.group_count = upload(groups, int32, device), int(groups[-1])
        self.ratio, self.most = float(ratio), int(most)


@func
def nearest_in(mine: int, picture: int, begin: int, end: int, before: vec3i, features: Descriptors) -> vec3i:
    """The nearest feature of some blocks of a picture, its squared distance, and that of the second.

    What was found in the blocks before is held against them.
    """
    best = before[0]
    least = before[1]
    second = before[2]
    own = features.offsets[mine]
    first = features.firsts[picture]
    count = features.firsts[picture + 1] - first
    origin = features.first_blocks[picture]
    for block in range(begin, end):
        products = sixteen_products(features.descriptors, mine, features.blocks, block)
        low = int(FARTHEST)
        for lane in range(BLOCK):
            low = min(low, own + features.squares[block * BLOCK + lane] - 2 * products[lane])
        if low < second:
            for lane in range(BLOCK):
                j = (block - origin) * BLOCK + lane
                sqdist = own + features.squares[block * BLOCK + lane] - 2 * products[lane]
                if j < count and sqdist < least:
                    second = least
                    least = sqdist
                    best = first + j
                elif j < count:
                    second = min(second, sqdist)
    return vec3i(best, least, second)


@func
def is_clear(found: vec3i, searches: PictureSearches) -> bool:
    """Whether the nearest feature is near, and clearly nearer than the second."""
    clear = float64(found[1]) < searches.ratio * float64(found[2])
    return found[0] != NO_MATCH and found[1] <= searches.most and clear


@kernel
def fill_blocks_kernel(
    firsts: array(dtype=int32),
    first_blocks: array(dtype=int32),
    owners: array(dtype=int32),
    descriptors: array(dtype=uint8, ndim=2),
    blocks: array(dtype=int8, ndim=2),
    squares: array(dtype=int32),
    offsets: array(dtype=int32),
):
    """One place of a block: its descriptor and squared length, or padding where the picture has no more."""
    i = tid()
    block = i // BLOCK
    lane = i % BLOCK
    picture = owners[block]
    row = firsts[picture] + (block - first_blocks[picture]) * BLOCK + lane
    square = int(0)
    total = int(0)
    inside = row < firsts[picture + 1]
    for k in range(WIDTH):
        value = int(0)
        if inside:
            value = int(descriptors[row, k])
        total += value
        square += value * value
        blocks[block, k // 4 * 64 + lane * 4 + k % 4] = int8(value - 128)
    if inside:
        squares[i] = square
        offsets[row] = square - 256 * total
    else:
        squares[i] = PADDING


@kernel
def find_matches_kernel(
    searches: PictureSearches,
    features: Descriptors,
    found: array(dtype=vec3i),
    matches: array(dtype=int32),
    clear: array(dtype=uint8),
):
    """The nearest features of the second picture to a group of the first's, and whether they are matches."""
    i = tid()
    s = search_of(i, searches.groups)
    to = searches.starts[s] + (i - searches.groups[s]) * ROWS
    count = min(searches.starts[s + 1] - to, ROWS)
    mine = features.firsts[searches.pictures[s, 0]] + to - searches.starts[s]
    other = searches.pictures[s, 1]
    begin = features.first_blocks[other]
    end = features.first_blocks[other + 1]
    for k in range(count):
        found[to + k] = vec3i(NO_MATCH, FARTHEST, FARTHEST)
    turns = (end - begin + TURN - 1) // TURN
    for turn in range(turns):
        first = begin + turn * TURN
        last = min(first + TURN, end)
        for k in range(count):
            found[to + k] = nearest_in(mine + k, other, first, last, found[to + k], features)
    for k in range(count):
        matches[to + k] = found[to + k][0]
        clear[to + k] = uint8(1 if is_clear(found[to + k], searches) else 0)


@kernel
def confirm_matches_kernel(
    searches: PictureSearches,
    features: Descriptors,
    threads: array(dtype=int32),
    matches: array(dtype=int32),
    mutual: array(dtype=int32),
):
    """The number of a match's feature in the second picture, NO_MATCH where it has another match itself, or none."""
    i = tid()
    thread = threads[i]
    s = search_of(thread, searches.starts)
    first = searches.pictures[s, 0]
    mine = features.firsts[first] + thread - searches.starts[s]
    begin = features.first_blocks[first]
    end = features.first_blocks[first + 1]
    found = nearest_in(matches[thread], first, begin, end, vec3i(NO_MATCH, FARTHEST, FARTHEST), features)
    to = int(NO_MATCH)
    if found[0] == mine and is_clear(found, searches):
        to = matches[thread] - features.firsts[searches.pictures[s, 1]]
    mutual[i] = to


def match_mutually(features: Descriptors, pairs: np.ndarray, *, ratio: float, most: int) -> list[np.ndarray]:
    """Matches of pairs of pictures.

    Args:
        features: Of all pictures.
        pairs: First and second picture of each, int [p, 2]; fewer than 2^31 features in all first pictures together.
        ratio: Of the squared distances of the nearest and the second feature, below which a match is clear.
        most: Squared distance of a match.

    Returns:
        Numbers of the feature in the first and in the second picture, int64 [k, 2] of each pair, by the first.
    """
    device = features.device
    counts = (features.host_firsts[1:] - features.host_firsts[:-1])[pairs[:, 0]]
    starts = np.concatenate([[0], np.cumsum(counts)])
    searches = PictureSearches(starts, pairs, ratio, most, device)
    matches: Integers = empty(int(starts[-1]), int32, device)
    clear: Mask = empty(matches.size, uint8, device)
    found: Array1[vec3i] = empty(matches.size, vec3i, device)
    launch(find_matches_kernel, searches.group_count, [searches, features, found, matches, clear])
    threads: Indices = positions_of(clear)  # sync
    mutual: Integers = empty(threads.size, int32, device)
    launch(confirm_matches_kernel, threads.size, [searches, features, threads, matches, mutual])
    mine, to = download(threads), download(mutual)  # sync
    mine, to = mine[to != NO_MATCH], to[to != NO_MATCH]
    rows = np.searchsorted(mine, starts)
    both = np.stack([mine, to], axis=1).astype(np.int64)
    parts = [both[a:b] for a, b in zip(rows[:-1].tolist(), rows[1:].tolist(), strict=True)]
    return [part - [[first, 0]] for part, first in zip(parts, starts[:-1].tolist(), strict=True)]
