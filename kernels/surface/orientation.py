"""Normals on one side of their surface: signs carried along a spanning tree of the points.

Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH 1992, section 3.3: a graph joins each point to
its k nearest, its edges weigh 1 - |n . n'|, and along its least spanning tree each normal takes the side of the one
before. Where the graph falls into several components the shortest bridges join them.

Memory: the graph, 4 k B a point, until the spanning tree is known; beside it about 80 B a point. All on the device: one
number comes back a round of Boruvka's algorithm.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..algebra.transform import narrow, widen
from ..array_types import Indices, Integers, Points, Vectors
from ..arrays.packed_keys import NO_KEY, pack_bits
from ..arrays.runs import Runs, elements_of
from ..lang import array, atomic_min, float32, float_bits, func, int32, int64, kernel, launch, sqrt, tid, vec3
from ..memory import copy, empty, full
from ..search.neighbor_lists import list_neighbors
from .component_bridges import bridge_components
from .spanning_tree import Forest, span_neighbors

if TYPE_CHECKING:
    from ..search.point_tree import PointTree

RUN = 4096  # points a thread on the CPU in the search for the lowest: one atomic a run
MAGNITUDE = 0x7FFF_FFFF  # the bits of a float32 but its sign
HEIGHT_ENTRIES = 2**24  # of the heights held at a time, one beside each entry of the lists
FENCE = 1.5  # times the width between the quartiles: what lies farther out is an outlier (Tukey)


@func
def unit_vector(v: vec3) -> vec3:
    """v / |v|; zero stays zero."""
    w = widen(v)
    size = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2])
    unit = v + vec3(0.0, 0.0, 0.0)
    if size > 0.0:
        unit = narrow(w / size)
    return unit


@kernel
def normalize_vectors_kernel(vectors: array(dtype=vec3), units: array(dtype=vec3)):
    """Each vector at length 1; zero stays zero."""
    i = tid()
    units[i] = unit_vector(vectors[i])


@kernel
def flip_vectors_kernel(vectors: array(dtype=vec3), flipped: array(dtype=vec3)):
    """The opposite vectors."""
    i = tid()
    flipped[i] = -vectors[i]


@kernel
def gather_units_kernel(
    normals: array(dtype=vec3), rows: array(dtype=int32), order: array(dtype=int32), units: array(dtype=vec3)
):
    """Unit normals by rank on the curve."""
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
    """Turn into no edge each neighbour that lies too steep over the tangent plane, or too far from it.

    Too steep: the cosine between the way there and the normal exceeds `steepest`. Too far, where asked for: above the
    upper quartile of the list by more than FENCE times the width between its quartiles.
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
            place = 0
            for m in range(k):
                other = heights[out + m]
                if other < height or (other == height and m < j):
                    place += 1
            if place == k // 4:
                low = height
            if place == 3 * k // 4:
                high = height
        fence = high + FENCE * (high - low)
    for j in range(k):
        d = points[lists[row + j]] - p
        height = heights[out + j]
        if height > fence or height > steepest * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]):
            lists[row + j] = v


@kernel
def find_lowest_kernel(points: array(dtype=vec3), rows: array(dtype=int32), runs: Runs, lowest: array(dtype=int64)):
    """The least z above the row that has it."""
    i = tid()
    least = int64(NO_KEY)
    for j in elements_of(i, runs):
        z = points[rows[j]][2]
        bits = 0  # of zero and minus zero neither is lower
        if z != 0.0:
            bits = float_bits(z)
        if bits < 0:
            bits = bits ^ MAGNITUDE  # whole numbers in the order of the floats
        least = min(least, pack_bits(bits, rows[j]))
    if least < lowest[0]:  # an old value only lets one more through
        atomic_min(lowest, 0, least)  # settles the lowest of all runs


@kernel
def spread_words_kernel(
    links: array(dtype=int32), rows: array(dtype=int32), order: array(dtype=int32), words: array(dtype=int32)
):
    """Signs by row of the cloud."""
    i = tid()
    words[rows[order[i]]] = links[i] & 1


@kernel
def turn_normals_kernel(
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    words: array(dtype=int32),
    lowest: array(dtype=int64),
    oriented: array(dtype=vec3),
):
    """Each normal by its sign, all together so that the lowest point's looks down; zero normals stay."""
    i = tid()
    row = rows[i]
    low = int(lowest[0] & int64(MAGNITUDE))
    turned = words[row] ^ words[low]
    m = normals[low]
    if m[2] > 0.0:
        turned = 1 - turned
    n = normals[row]
    if turned == 1 and (n[0] != 0.0 or n[1] != 0.0 or n[2] != 0.0):
        oriented[row] = -n


def normalize_vectors(vectors: Vectors) -> Vectors:
    """Vectors at length 1; zero stays zero."""
    units = empty(vectors.size, vec3, vectors.device)
    launch(normalize_vectors_kernel, vectors.size, [vectors, units])
    return units


def flip_vectors(vectors: Vectors) -> Vectors:
    """The opposite vectors."""
    flipped = empty(vectors.size, vec3, vectors.device)
    launch(flip_vectors_kernel, vectors.size, [vectors, flipped])
    return flipped


def drop_neighbors(
    parts: Sequence[tuple[int, Integers]], k: int, tree: "PointTree", units: Vectors, steepest: float, outliers: bool
) -> None:
    """Take edges out of a graph of neighbours, in place; see drop_neighbors_kernel."""
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
    """Normals turned so that neighbours agree, the lowest point's (of lowest row) looking down.

    Args:
        points: Device array of vec3, shape [n].
        normals: Device array of vec3, shape [n].
        rows: The `usable_rows`, one at least; the normals of others stay.
        tree: PointTree of the points of these rows.
        k: Neighbours of a point in the graph, itself included.
        steepest: Cosine between a normal and the way to a neighbour above which that is no edge.
        outliers: Leave out neighbours whose height over the tangent plane is an outlier of the list.

    Returns:
        Device array of vec3, shape [n].
    """
    device = points.device
    oriented = empty(points.size, vec3, device)
    copy(oriented, normals, count=points.size)
    units = empty(rows.size, vec3, device)
    launch(gather_units_kernel, rows.size, [normals, rows, tree.order, units])
    forest = Forest(rows.size, device)
    count = min(k, rows.size)
    parts = list(list_neighbors(tree, count, own=True))
    if steepest < 1.0 or outliers:
        drop_neighbors(parts, count, tree, units, steepest, outliers)
    span_neighbors(forest, parts, count, units)
    del parts
    bridge_components(forest, tree, units)
    words, lowest = empty(points.size, int32, device), full(1, NO_KEY, int64, device)
    runs = Runs(rows.size, device, RUN)
    launch(find_lowest_kernel, runs.threads, [points, rows, runs, lowest])
    launch(spread_words_kernel, rows.size, [forest.links, rows, tree.order, words])
    launch(turn_normals_kernel, rows.size, [normals, rows, words, lowest, oriented])
    return oriented
