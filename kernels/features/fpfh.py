"""Fast point feature histograms: 33 numbers a point that tell how the surface around it bends.

Rusu, Blodow and Beetz, "Fast point feature histograms (FPFH) for 3D registration", ICRA 2009, with Open3D's choices:
neighbours are weighted by one over their squared distance, that sum is scaled to 100 an angle, and the point's own
histogram is added to it, unscaled.

Two passes over the neighbours, which are known by a limit a point (neighbor_limits.py) and found again each time: the
first counts the bins of the pairs into a row of 132 B a point, the second sums the rows: 70
operations a pair and 132 B read from the caches. No list of neighbours in memory.

The sums are float32: all terms are positive, so each comes out within m roundings (6e-8) of itself for m neighbours,
or 1e-5 for 100. That is a hundred times below what one neighbour in another bin changes.

The histograms of a point's angles to its neighbours, 100 an angle: the first pass of FPFH (its SPFH). About 130
operations a pair beside the search and 132 B written a point. Bins are counted as integers and are those of float64
arithmetic, so that the histograms are Open3D's to the last neighbour (pair_angles.py).
"""

from typing import TYPE_CHECKING

from ..array_types import Array2, Indices, Integers, Points, Vectors
from ..arrays.lanes import sum_of_lanes
from ..arrays.packed_keys import key_index, key_number
from ..arrays.select import gather_vec3_kernel, number_rows_kernel, positions_of
from ..arrays.sort import fill_positions_kernel
from ..lang import (
    NAN,
    WARP,
    array,
    atomic_max,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    lane,
    launch,
    shuffle,
    sync_lanes,
    tid,
    uint8,
    vec3,
    vector,
)
from ..memory import cast, download, empty, zeros
from ..search.group_scratch import GroupScratch, LaunchPart, held_key
from ..search.neighbor_limits import Neighborhood, hold_members, members_of, neighbors_of
from ..search.point_tree import LEAF
from .pair_angles import BIN_BITS, BIN_MASK, BINS, COLUMNS, MIDDLE, quick_bins, settled_bins

if TYPE_CHECKING:
    from ..search.point_tree import PointTree


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


HALF = 16  # columns of one register vector; two of them and one number are a row
HEAVIEST = 1.0e30  # [1 / m^2] the weight of points nearer than 1e-15 m: below infinity, times any number of neighbours
MAX_POINTS = (2**31 - 1) // COLUMNS  # the numbers of one array are counted in 32 bits
half_row = vector(16, float32)


@kernel
def mask_points_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), usable: array(dtype=vec3), masked: array(dtype=int32)
):
    """The points that have a finite normal, NaN in place of the others; 1 where a finite point was masked."""
    i = tid()
    p = points[i]
    if not isfinite(normals[i]):
        if isfinite(p):
            atomic_max(masked, 0, 1)  # settles who sets it, all of them to 1
        p = vec3(NAN, NAN, NAN)
    usable[i] = p


@kernel
def mark_chosen_kernel(rows: array(dtype=int32), places: array(dtype=int32), count: int, marks: array(dtype=int32)):
    """Set the marks of the chosen points, by place; the atomic settles repeats, all of them write 1."""
    i = tid()
    place = places[rows[i]]
    if place < count:
        atomic_max(marks, place, 1)


@kernel
def copy_features_kernel(
    rows: array(dtype=int32),
    places: array(dtype=int32),
    count: int,
    slots: array(dtype=int32),
    compact: array(dtype=float32, ndim=2),
    features: array(dtype=float32, ndim=2),
):
    """Each chosen point's feature in the order asked for; NaN for points that have none."""
    i = tid()
    place = places[rows[i]]
    for c in range(COLUMNS):
        value = float(NAN)
        if place < count:
            value = compact[slots[place], c]
        features[i, c] = value


@kernel
def fill_missing_features_kernel(order: array(dtype=int32), count: int, features: array(dtype=float32, ndim=2)):
    """NaN for the points behind the last usable one."""
    i = tid()
    row = order[count + i]
    for c in range(COLUMNS):
        features[row, c] = NAN


@func
def weight_of(sqdist: float) -> float:
    """One over a squared distance [1 / m^2]; points at the same place have none."""
    weight = 0.0
    if sqdist > 0.0:
        weight = min(1.0 / sqdist, HEAVIEST)
    return weight


@func
def weight_at(keys: array(dtype=int64), at: int, end: int, limit: int64) -> float:
    """The weight of the point that a key stands for; none beyond the limit or the end of the keys."""
    weight = 0.0
    if at < end:
        if keys[at] <= limit:
            weight = weight_of(key_number(keys[at]))
    return weight


@func
def sum_listed(
    limit: int64,
    histograms: array(dtype=float32, ndim=2),
    keys: array(dtype=int64),
    base: int,
    held: int,
    row: int,
    features: array(dtype=float32, ndim=2),
):
    """Write the weighted sum of the histograms that the keys up to a limit stand for.

    Four histograms at a time: the sums are loaded and stored once for all four.
    """
    low = half_row(0.0)
    high = half_row(0.0)
    end = 0.0
    last = base + held - 1
    for chunk in range((held + 3) // 4):
        j = base + 4 * chunk
        w0 = weight_at(keys, j, last + 1, limit)
        w1 = weight_at(keys, j + 1, last + 1, limit)
        w2 = weight_at(keys, j + 2, last + 1, limit)
        w3 = weight_at(keys, j + 3, last + 1, limit)
        i0 = key_index(keys[j])
        i1 = key_index(keys[min(j + 1, last)])
        i2 = key_index(keys[min(j + 2, last)])
        i3 = key_index(keys[min(j + 3, last)])
        for c in range(HALF):
            low[c] += (w0 * histograms[i0, c] + w1 * histograms[i1, c]) + (
                w2 * histograms[i2, c] + w3 * histograms[i3, c]
            )
        for c in range(HALF):
            high[c] += (w0 * histograms[i0, HALF + c] + w1 * histograms[i1, HALF + c]) + (
                w2 * histograms[i2, HALF + c] + w3 * histograms[i3, HALF + c]
            )
        end += (w0 * histograms[i0, 2 * HALF] + w1 * histograms[i1, 2 * HALF]) + (
            w2 * histograms[i2, 2 * HALF] + w3 * histograms[i3, 2 * HALF]
        )
    for c in range(HALF):
        features[row, c] = low[c]
        features[row, HALF + c] = high[c]
    features[row, 2 * HALF] = end


@func
def sum_walked(
    rank: int,
    neighborhood: Neighborhood,
    histograms: array(dtype=float32, ndim=2),
    row: int,
    features: array(dtype=float32, ndim=2),
):
    """Write the weighted sum of the histograms of a point's neighbours, by a walk through the tree."""
    low = half_row(0.0)
    high = half_row(0.0)
    end = 0.0
    for j, sqdist in neighbors_of(rank, neighborhood):
        weight = weight_of(sqdist)
        for c in range(HALF):
            low[c] += weight * histograms[j, c]
        for c in range(HALF):
            high[c] += weight * histograms[j, HALF + c]
        end += weight * histograms[j, 2 * HALF]
    for c in range(HALF):
        features[row, c] = low[c]
        features[row, HALF + c] = high[c]
    features[row, 2 * HALF] = end


@func
def scale_of(total: float) -> float:
    """What makes the columns of an angle, of this sum, 100 together."""
    scale = 0.0
    if total > 0.0:
        scale = 100.0 / total
    return scale


@func
def finish_row(rank: int, histograms: array(dtype=float32, ndim=2), row: int, features: array(dtype=float32, ndim=2)):
    """Scale the sum in a row to 100 an angle and add the point's own histogram."""
    for angle in range(3):
        total = 0.0
        for j in range(angle * BINS, angle * BINS + BINS):
            total += features[row, j]
        scale = scale_of(total)
        for j in range(angle * BINS, angle * BINS + BINS):
            features[row, j] = features[row, j] * scale + histograms[rank, j]


@kernel(most_registers=80)
def sum_histograms_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    histograms: array(dtype=float32, ndim=2),
    rows: array(dtype=int32),
    features: array(dtype=float32, ndim=2),
):
    """The feature of each query, in the row that it belongs to."""
    i = tid()
    for member, base, held in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        row = rows[member]
        if held >= 0:
            sum_listed(neighborhood.limits[rank], histograms, scratch.keys, base, held, row, features)
        else:
            sum_walked(rank, neighborhood, histograms, row, features)
        finish_row(rank, histograms, row, features)


@sum_histograms_kernel.on_cuda
def sum_histograms_of_lanes_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    histograms: array(dtype=float32, ndim=2),
    rows: array(dtype=int32),
    features: array(dtype=float32, ndim=2),
):
    """The same, all lanes of a warp for one query after another: a lane sums a column, and rows are read at once."""
    i = tid()
    first = part.first + (i // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        held = hold_members(i, group, ranks, neighborhood, scratch)
        sync_lanes()
        for owner in range(min(WARP, ranks.shape[0] - group * WARP)):
            member = group * WARP + owner
            rank = ranks[member]
            row = rows[member]
            total = 0.0
            end = 0.0
            own = lane()
            count = shuffle(held, owner)
            for chunk in range((count + WARP - 1) // WARP):
                left = min(WARP, count - chunk * WARP)
                key = scratch.keys[i - own + owner + (chunk * WARP + min(own, left - 1)) * scratch.stride]
                weight = weight_of(key_number(key))
                if own < left:
                    end += weight * histograms[key_index(key), 2 * HALF]
                for j in range(left):
                    total += shuffle(weight, j) * histograms[shuffle(key_index(key), j), own]
            if count < 0:
                for j, sqdist in neighbors_of(rank, neighborhood):
                    weight = weight_of(sqdist)
                    total += weight * histograms[j, own]
                    if own == 0:
                        end += weight * histograms[j, 2 * HALF]
            end = sum_of_lanes(end)
            sums = vec3(0.0, 0.0, 0.0)
            for c in range(BINS):
                third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))
                if c == BINS - 1:
                    third = end  # the column behind the lanes
                sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)
            angle = own // BINS
            per_angle = sums[0] if angle == 0 else (sums[1] if angle == 1 else sums[2])
            features[row, own] = total * scale_of(per_angle) + histograms[rank, own]
            if own == 0:
                features[row, 2 * HALF] = end * scale_of(sums[2]) + histograms[rank, 2 * HALF]
        sync_lanes()  # the next group's keys are written over these
        sync_lanes()


def sum_histograms(
    neighborhood: Neighborhood, histograms: Array2[float32], ranks: Integers, rows: Indices, features: Array2[float32]
) -> None:
    """Write the features of the points at some places on the curve into rows of `features`."""
    neighborhood.visit(sum_histograms_kernel, ranks, [histograms, rows, features])


def mask_points(points: Points, normals: Vectors) -> Points | None:
    """The points with NaN in place of those without a finite normal; None where all finite points have one (a sync)."""
    usable, masked = empty(points.size, vec3, points.device), zeros(1, int32, points.device)
    launch(mask_points_kernel, points.size, [points, normals, usable, masked])
    return usable if download(masked)[0] else None  # sync


def compute_features(
    tree: "PointTree", normals: Vectors, radius: float, max_nn: int | None, rows: Indices | None = None
) -> Array2[float32]:
    """Fast point feature histograms.

    Args:
        tree: The PointTree of n points, none of which is finite without a finite normal: see `mask_points`.
        normals: Device array of vec3, shape [n].
        radius: Upper limit of the distance of a neighbour [m], excluded; infinity for none.
        max_nn: Neighbours, the point itself included; None takes all within the radius.
        rows: int32 device array of the points whose features are wanted; None for all.

    Returns:
        float32 device array of shape [n, 33], or [rows, 33]; NaN for points without finite position and normal.

    Raises:
        ValueError: More points than one array holds rows for.
    """
    n, device = tree.source.size, tree.device
    if max(n, 0 if rows is None else rows.size) > MAX_POINTS:
        raise ValueError(f"features of {n} points: one array holds those of {MAX_POINTS}; split the cloud")
    sorted_normals = empty(tree.count, vec3, device)
    launch(gather_vec3_kernel, tree.count, [normals, tree.order, sorted_normals])
    if rows is not None:
        return _compute_chosen(tree, sorted_normals, radius, max_nn, rows)
    features = empty((n, COLUMNS), float32, device)
    neighborhood = Neighborhood(tree, radius, max_nn)
    histograms = count_angles(neighborhood, sorted_normals, neighborhood.places)
    sum_histograms(neighborhood, histograms, neighborhood.places, tree.order, features)
    launch(fill_missing_features_kernel, n - tree.count, [tree.order, tree.count, features])
    return features


def _compute_chosen(
    tree: "PointTree", normals: Vectors, radius: float, max_nn: int | None, rows: Indices
) -> Array2[float32]:
    """Features of some points; histograms are counted for these and their neighbours only."""
    device, count = tree.device, tree.count
    places, chosen = empty(tree.order.size, int32, device), zeros(count, int32, device)
    launch(number_rows_kernel, tree.order.size, [tree.order, places])
    launch(mark_chosen_kernel, rows.size, [rows, places, count, chosen])
    centers = positions_of(cast(chosen, uint8))  # sync
    neighborhood = Neighborhood(tree, radius, max_nn, centers)
    ranks = positions_of(cast(neighborhood.mark(centers), uint8))  # sync
    neighborhood.find(ranks)
    histograms = count_angles(neighborhood, normals, ranks)
    slots, within = empty(count, int32, device), empty(centers.size, int32, device)
    launch(fill_positions_kernel, centers.size, [within])
    launch(number_rows_kernel, centers.size, [centers, slots])
    compact = empty((centers.size, COLUMNS), float32, device)
    sum_histograms(neighborhood, histograms, centers, within, compact)
    features = empty((rows.size, COLUMNS), float32, device)
    launch(copy_features_kernel, rows.size, [rows, places, count, slots, compact, features])
    return features
