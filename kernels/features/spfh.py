"""The histograms of a point's angles to its neighbours, 100 an angle: the first pass of FPFH (its SPFH).

About 130 operations a pair beside the search and 132 B written a point. Bins are counted as integers and are those of
float64 arithmetic, so that the histograms are Open3D's to the last neighbour (pair_angles.py).
"""

from ..array_types import Array2, Integers, Vectors
from ..arrays.packed_keys import key_index
from ..lang import array, float32, func, int32, kernel, tid, vec3, vector
from ..memory import empty, zeros
from ..search.group_scratch import GroupScratch, LaunchPart, held_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of
from ..search.point_tree import LEAF
from .pair_angles import BIN_BITS, BIN_MASK, BINS, COLUMNS, MIDDLE, quick_bins, settled_bins

histogram = vector(33, int32)
eight = vector(8, float32)
eight_bins = vector(8, int32)


@func
def bin_listed(
    rank: int, neighborhood: Neighborhood, normals: array(dtype=vec3), scratch: GroupScratch, base: int, held: int
) -> histogram:
    """The bins of the pairs with a point's neighbours among those that its keys stand for, itself among them.

    Eight pairs at a time: what they read is collected first, so that the arithmetic runs in vector registers.
    """
    p = neighborhood.tree.points[rank]
    limit = neighborhood.limits[rank]
    n = normals[rank]
    counts = histogram(0)
    dx = eight(0.0)
    dy = eight(0.0)
    dz = eight(0.0)
    mx = eight(0.0)
    my = eight(0.0)
    mz = eight(0.0)
    pairs = eight_bins(0)
    for chunk in range((held + LEAF - 1) // LEAF):
        first = chunk * LEAF
        last = held - 1
        for j in range(LEAF):
            other = key_index(held_key(scratch, base, min(first + j, last)))
            q = neighborhood.tree.points[other]
            m = normals[other]
            dx[j] = q[0] - p[0]
            dy[j] = q[1] - p[1]
            dz[j] = q[2] - p[2]
            mx[j] = m[0]
            my[j] = m[1]
            mz[j] = m[2]
        for j in range(LEAF):
            pairs[j] = quick_bins(vec3(dx[j], dy[j], dz[j]), n, vec3(mx[j], my[j], mz[j]))
        for j in range(min(LEAF, last - first + 1)):
            key = held_key(scratch, base, first + j)
            if key <= limit:
                other = key_index(key)
                bins = settled_bins(pairs[j], p, n, neighborhood.tree.points[other], normals[other])
                counts[bins & BIN_MASK] += 1
                counts[BINS + ((bins >> BIN_BITS) & BIN_MASK)] += 1
                counts[2 * BINS + (bins >> (2 * BIN_BITS))] += 1
    return counts


@func
def bin_walked(rank: int, neighborhood: Neighborhood, normals: array(dtype=vec3)) -> histogram:
    """The bins of the pairs with a point's neighbours, the point itself among them, by a walk through the tree."""
    p = neighborhood.tree.points[rank]
    n = normals[rank]
    counts = histogram(0)
    for j, sqdist in neighbors_of(rank, neighborhood):
        q = neighborhood.tree.points[j]
        bins = settled_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])
        counts[bins & BIN_MASK] += 1
        counts[BINS + ((bins >> BIN_BITS) & BIN_MASK)] += 1
        counts[2 * BINS + (bins >> (2 * BIN_BITS))] += 1
    return counts


@func
def write_histogram(rank: int, counts: histogram, histograms: array(dtype=float32, ndim=2)):
    """Write a point's histogram, 100 an angle.

    A pair at distance zero has all angles zero, so the point itself was counted in the middle bins. Where more points
    than are asked for lie at one place it may not be among its own neighbours: then one of them goes in its stead, as
    in Open3D, which takes the first neighbour for the point itself.
    """
    pairs = -1
    for j in range(BINS):
        pairs += counts[j]
    share = 100.0 / float(max(pairs, 1))
    for j in range(COLUMNS):
        own = 0
        if j % BINS == MIDDLE:
            own = 1
        histograms[rank, j] = float(counts[j] - own) * share


@kernel(most_registers=80)
def count_angles_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    normals: array(dtype=vec3),
    histograms: array(dtype=float32, ndim=2),
):
    """The histogram of each query's pairs."""
    i = tid()
    for member, base, held in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        counts = histogram(0)
        if held >= 0:
            counts = bin_listed(rank, neighborhood, normals, scratch, base, held)
        else:
            counts = bin_walked(rank, neighborhood, normals)
        write_histogram(rank, counts, histograms)


def count_angles(neighborhood: Neighborhood, normals: Vectors, ranks: Integers) -> Array2[float32]:
    """The histograms of the points at some places on the curve.

    Args:
        neighborhood: The Neighborhood, with the limits of these points.
        normals: Device array of vec3, shape [tree.count], by place.
        ranks: int32 device array of the places.

    Returns:
        float32 device array of shape [tree.count, 33] by place; zeros in the rows of other points.
    """
    tree = neighborhood.tree
    make = empty if ranks.size == tree.count else zeros  # a tie may read, with no weight, a row that is not written
    histograms = make((tree.count, COLUMNS), float32, tree.device)
    neighborhood.visit(count_angles_kernel, ranks, [normals, histograms])
    return histograms
