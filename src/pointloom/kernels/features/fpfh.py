"""Fast point feature histograms: 33 numbers per point.

Rusu, Blodow and Beetz, "Fast point feature histograms (FPFH) for 3D registration", ICRA 2009, with Open3D's choices:
weights are 1 / squared distance, the sum is scaled to 100 per angle and the unscaled own histogram is added. Two passes
find the neighbors by limits (neighbor_limits.py), without lists: the first counts bins (SPFH, 132 B per point,
float64-exact bins, pair_angles.py), the second sums rows in float32 (relative error up to 6e-8 per neighbor).
"""

from typing import TYPE_CHECKING

from ..array_types import Array2, Indices, Integers, Points, Vectors
from ..arrays.lanes import sum_of_lanes
from ..arrays.packed_keys import key_index, key_number
from ..arrays.select import gather_rows, gather_vec3_kernel, number_rows_kernel, positions_of
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
from ..search.distinct_points import by_distinct_points, distinct_points
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of, store_members
from ..search.point_tree import LEAF
from .pair_angles import BIN_BITS, BIN_MASK, BINS_PER_ANGLE, FEATURE_COLUMNS, ZERO_BIN, quick_bins, resolved_bins

if TYPE_CHECKING:
    from ..search.point_tree import PointTree


histogram = vector(33, int32)
eight = vector(8, float32)
eight_bins = vector(8, int32)


@func
def bin_listed(
    rank: int, neighborhood: Neighborhood, normals: array(dtype=vec3), scratch: GroupScratch, base: int, stored: int
) -> histogram:
    """Bins of the pairs with a point's listed neighbors, eight at a time for vectorization."""
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
    for chunk in range((stored + LEAF - 1) // LEAF):
        first = chunk * LEAF
        last = stored - 1
        for j in range(LEAF):
            other = key_index(stored_key(scratch, base, min(first + j, last)))
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
            key = stored_key(scratch, base, first + j)
            if key <= limit:
                other = key_index(key)
                bins = resolved_bins(pairs[j], p, n, neighborhood.tree.points[other], normals[other])
                counts[bins & BIN_MASK] += 1
                counts[BINS_PER_ANGLE + ((bins >> BIN_BITS) & BIN_MASK)] += 1
                counts[2 * BINS_PER_ANGLE + (bins >> (2 * BIN_BITS))] += 1
    return counts


@func
def bin_by_traversal(rank: int, neighborhood: Neighborhood, normals: array(dtype=vec3)) -> histogram:
    """Bins of the pairs with a point's neighbors, by tree traversal."""
    p = neighborhood.tree.points[rank]
    n = normals[rank]
    counts = histogram(0)
    for j, sqdist in neighbors_of(rank, neighborhood):
        q = neighborhood.tree.points[j]
        bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])
        counts[bins & BIN_MASK] += 1
        counts[BINS_PER_ANGLE + ((bins >> BIN_BITS) & BIN_MASK)] += 1
        counts[2 * BINS_PER_ANGLE + (bins >> (2 * BIN_BITS))] += 1
    return counts


@func
def write_histogram(rank: int, counts: histogram, histograms: array(dtype=float32, ndim=2)):
    """Write a point's histogram, 100 per angle, without itself (middle bins) or, as in Open3D, a duplicate."""
    pairs = -1
    for j in range(BINS_PER_ANGLE):
        pairs += counts[j]
    fraction = 100.0 / float(max(pairs, 1))
    for j in range(FEATURE_COLUMNS):
        own = 0
        if j % BINS_PER_ANGLE == ZERO_BIN:
            own = 1
        histograms[rank, j] = float(counts[j] - own) * fraction


@kernel(max_registers=80)
def count_angles_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    normals: array(dtype=vec3),
    histograms: array(dtype=float32, ndim=2),
):
    i = tid()
    for member, base, stored in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        counts = histogram(0)
        if stored >= 0:
            counts = bin_listed(rank, neighborhood, normals, scratch, base, stored)
        else:
            counts = bin_by_traversal(rank, neighborhood, normals)
        write_histogram(rank, counts, histograms)


def count_angles(neighborhood: Neighborhood, normals: Vectors, ranks: Integers) -> Array2[float32]:
    """Histograms at the tree positions `ranks`, float32 (tree.count, 33), else zeros; `normals` in tree order."""
    tree = neighborhood.tree
    make = empty if ranks.size == tree.count else zeros  # a tie may read an unwritten row, with zero weight
    histograms = make((tree.count, FEATURE_COLUMNS), float32, tree.device)
    neighborhood.visit(count_angles_kernel, ranks, [normals, histograms])
    return histograms


HALF_COLUMNS = 16  # columns of a vector register. A row has two of them and one number
MAX_WEIGHT = 1.0e30  # [1 / m^2] weight of points closer than 1e-15 m: finite for any number of neighbors
MAX_POINTS = (2**31 - 1) // FEATURE_COLUMNS  # array elements are counted in 32 bits
half_row = vector(16, float32)


@kernel
def mask_points_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), usable: array(dtype=vec3), masked: array(dtype=int32)
):
    """Replace points without a finite normal by NaN. Flag if a finite point was replaced."""
    i = tid()
    p = points[i]
    if not isfinite(normals[i]):
        if isfinite(p):
            atomic_max(masked, 0, 1)  # resolves the race: all writers set 1
        p = vec3(NAN, NAN, NAN)
    usable[i] = p


@kernel
def mark_chosen_kernel(rows: array(dtype=int32), positions: array(dtype=int32), count: int, marks: array(dtype=int32)):
    """Flag the chosen points by tree position. Repeated writers all write 1."""
    i = tid()
    position = positions[rows[i]]
    if position < count:
        atomic_max(marks, position, 1)


@kernel
def copy_features_kernel(
    rows: array(dtype=int32),
    positions: array(dtype=int32),
    count: int,
    slots: array(dtype=int32),
    compact: array(dtype=float32, ndim=2),
    features: array(dtype=float32, ndim=2),
):
    """Features in the requested order. NaN for points without."""
    i = tid()
    position = positions[rows[i]]
    for c in range(FEATURE_COLUMNS):
        value = float(NAN)
        if position < count:
            value = compact[slots[position], c]
        features[i, c] = value


@kernel
def fill_missing_features_kernel(order: array(dtype=int32), count: int, features: array(dtype=float32, ndim=2)):
    i = tid()
    row = order[count + i]
    for c in range(FEATURE_COLUMNS):
        features[row, c] = NAN


@func
def weight_of(sqdist: float) -> float:
    """1 / squared distance [1 / m^2]. 0 for coincident points."""
    weight = 0.0
    if sqdist > 0.0:
        weight = min(1.0 / sqdist, MAX_WEIGHT)
    return weight


@func
def weight_at(keys: array(dtype=int64), at: int, end: int, limit: int64) -> float:
    """Weight of a key's point. 0 beyond the limit or the end."""
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
    stored: int,
    row: int,
    features: array(dtype=float32, ndim=2),
):
    """Weighted sum of the histograms of the keys up to a limit, four at a time to save stores."""
    low = half_row(0.0)
    high = half_row(0.0)
    end = 0.0
    last = base + stored - 1
    for chunk in range((stored + 3) // 4):
        j = base + 4 * chunk
        w0 = weight_at(keys, j, last + 1, limit)
        w1 = weight_at(keys, j + 1, last + 1, limit)
        w2 = weight_at(keys, j + 2, last + 1, limit)
        w3 = weight_at(keys, j + 3, last + 1, limit)
        i0 = key_index(keys[j])
        i1 = key_index(keys[min(j + 1, last)])
        i2 = key_index(keys[min(j + 2, last)])
        i3 = key_index(keys[min(j + 3, last)])
        for c in range(HALF_COLUMNS):
            low[c] += (w0 * histograms[i0, c] + w1 * histograms[i1, c]) + (
                w2 * histograms[i2, c] + w3 * histograms[i3, c]
            )
        for c in range(HALF_COLUMNS):
            high[c] += (w0 * histograms[i0, HALF_COLUMNS + c] + w1 * histograms[i1, HALF_COLUMNS + c]) + (
                w2 * histograms[i2, HALF_COLUMNS + c] + w3 * histograms[i3, HALF_COLUMNS + c]
            )
        end += (w0 * histograms[i0, 2 * HALF_COLUMNS] + w1 * histograms[i1, 2 * HALF_COLUMNS]) + (
            w2 * histograms[i2, 2 * HALF_COLUMNS] + w3 * histograms[i3, 2 * HALF_COLUMNS]
        )
    for c in range(HALF_COLUMNS):
        features[row, c] = low[c]
        features[row, HALF_COLUMNS + c] = high[c]
    features[row, 2 * HALF_COLUMNS] = end


@func
def sum_by_traversal(
    rank: int,
    neighborhood: Neighborhood,
    histograms: array(dtype=float32, ndim=2),
    row: int,
    features: array(dtype=float32, ndim=2),
):
    """Weighted sum of the histograms of a point's neighbors, by tree traversal."""
    low = half_row(0.0)
    high = half_row(0.0)
    end = 0.0
    for j, sqdist in neighbors_of(rank, neighborhood):
        weight = weight_of(sqdist)
        for c in range(HALF_COLUMNS):
            low[c] += weight * histograms[j, c]
        for c in range(HALF_COLUMNS):
            high[c] += weight * histograms[j, HALF_COLUMNS + c]
        end += weight * histograms[j, 2 * HALF_COLUMNS]
    for c in range(HALF_COLUMNS):
        features[row, c] = low[c]
        features[row, HALF_COLUMNS + c] = high[c]
    features[row, 2 * HALF_COLUMNS] = end


@func
def scale_of(total: float) -> float:
    """Factor that scales the columns of an angle to a sum of 100."""
    scale = 0.0
    if total > 0.0:
        scale = 100.0 / total
    return scale


@func
def finish_row(rank: int, histograms: array(dtype=float32, ndim=2), row: int, features: array(dtype=float32, ndim=2)):
    """Scale the sum to 100 per angle and add the point's own histogram."""
    for angle in range(3):
        total = 0.0
        for j in range(angle * BINS_PER_ANGLE, angle * BINS_PER_ANGLE + BINS_PER_ANGLE):
            total += features[row, j]
        scale = scale_of(total)
        for j in range(angle * BINS_PER_ANGLE, angle * BINS_PER_ANGLE + BINS_PER_ANGLE):
            features[row, j] = features[row, j] * scale + histograms[rank, j]


@kernel(max_registers=128)  # two blocks per SM: with 80, the loops over rows use local memory
def sum_histograms_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    histograms: array(dtype=float32, ndim=2),
    rows: array(dtype=int32),
    features: array(dtype=float32, ndim=2),
):
    i = tid()
    for member, base, stored in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        row = rows[member]
        if stored >= 0:
            sum_listed(neighborhood.limits[rank], histograms, scratch.keys, base, stored, row, features)
        else:
            sum_by_traversal(rank, neighborhood, histograms, row, features)
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
    """CUDA variant: a warp per query, one column per lane."""
    i = tid()
    first = part.first + (i // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        stored = store_members(i, group, ranks, neighborhood, scratch)
        sync_lanes()
        for owner in range(min(WARP, ranks.shape[0] - group * WARP)):
            member = group * WARP + owner
            rank = ranks[member]
            row = rows[member]
            total = 0.0
            end = 0.0
            own = lane()
            count = shuffle(stored, owner)
            for chunk in range((count + WARP - 1) // WARP):
                left = min(WARP, count - chunk * WARP)
                key = scratch.keys[i - own + owner + (chunk * WARP + min(own, left - 1)) * scratch.stride]
                weight = weight_of(key_number(key))
                if own < left:
                    end += weight * histograms[key_index(key), 2 * HALF_COLUMNS]
                for j in range(left):
                    total += shuffle(weight, j) * histograms[shuffle(key_index(key), j), own]
            if count < 0:
                for j, sqdist in neighbors_of(rank, neighborhood):
                    weight = weight_of(sqdist)
                    total += weight * histograms[j, own]
                    if own == 0:
                        end += weight * histograms[j, 2 * HALF_COLUMNS]
            end = sum_of_lanes(end)
            sums = vec3(0.0, 0.0, 0.0)
            for c in range(BINS_PER_ANGLE):
                third = shuffle(total, min(2 * BINS_PER_ANGLE + c, 2 * HALF_COLUMNS - 1))
                if c == BINS_PER_ANGLE - 1:
                    third = end  # the column behind the lanes
                sums += vec3(shuffle(total, c), shuffle(total, BINS_PER_ANGLE + c), third)
            angle = own // BINS_PER_ANGLE
            per_angle = sums[0] if angle == 0 else (sums[1] if angle == 1 else sums[2])
            features[row, own] = total * scale_of(per_angle) + histograms[rank, own]
            if own == 0:
                features[row, 2 * HALF_COLUMNS] = end * scale_of(sums[2]) + histograms[rank, 2 * HALF_COLUMNS]
        sync_lanes()  # before the next group overwrites the keys
        sync_lanes()


def sum_histograms(
    neighborhood: Neighborhood, histograms: Array2[float32], ranks: Integers, rows: Indices, features: Array2[float32]
) -> None:
    """Write the features at the tree positions `ranks` into `rows` of `features`."""
    neighborhood.visit(sum_histograms_kernel, ranks, [histograms, rows, features])


def mask_points(points: Points, normals: Vectors) -> Points | None:
    """Points with NaN where the normal is not finite. None if nothing changes (sync)."""
    usable, masked = empty(points.size, vec3, points.device), zeros(1, int32, points.device)
    launch(mask_points_kernel, points.size, [points, normals, usable, masked])
    return usable if download(masked)[0] else None  # sync


def compute_features(
    tree: "PointTree", normals: Vectors, radius: float, max_nn: int | None, rows: Indices | None = None
) -> Array2[float32]:
    """Fast point feature histograms, float32 (n, 33) or (rows, 33). NaN for points without finite position and normal.
    The tree's points must pass `mask_points`; `max_nn` includes the point itself; `radius` [m] is exclusive.
    """
    n = tree.source.size
    if max(n, 0 if rows is None else rows.size) > MAX_POINTS:
        raise ValueError(f"features of {n} points: one array holds those of {MAX_POINTS}; split the cloud")
    if rows is not None and distinct_points(tree, max_nn) is None:
        return _compute_chosen(tree, _in_tree_order(tree, normals), radius, max_nn, rows)

    (features,) = by_distinct_points(
        tree, max_nn, radius, lambda some, n: [_compute_all(some, _in_tree_order(some, n), radius, max_nn)], normals
    )
    return features if rows is None else gather_rows(features, rows)


def _in_tree_order(tree: "PointTree", normals: Vectors) -> Vectors:
    sorted_normals = empty(tree.count, vec3, tree.device)
    launch(gather_vec3_kernel, tree.count, [normals, tree.order, sorted_normals])
    return sorted_normals


def _compute_all(tree: "PointTree", sorted_normals: Vectors, radius: float, max_nn: int | None) -> Array2[float32]:
    n, device = tree.source.size, tree.device
    features = empty((n, FEATURE_COLUMNS), float32, device)
    neighborhood = Neighborhood(tree, radius, max_nn)
    histograms = count_angles(neighborhood, sorted_normals, neighborhood.positions)
    sum_histograms(neighborhood, histograms, neighborhood.positions, tree.order, features)
    if n > tree.count:
        launch(fill_missing_features_kernel, n - tree.count, [tree.order, tree.count, features])
    return features


def _compute_chosen(
    tree: "PointTree", normals: Vectors, radius: float, max_nn: int | None, rows: Indices
) -> Array2[float32]:
    """Features of some points; histograms only for these and their neighbors."""
    device, count = tree.device, tree.count
    positions, chosen = empty(tree.order.size, int32, device), zeros(count, int32, device)
    launch(number_rows_kernel, tree.order.size, [tree.order, positions])
    launch(mark_chosen_kernel, rows.size, [rows, positions, count, chosen])
    centers = positions_of(cast(chosen, uint8))  # sync
    neighborhood = Neighborhood(tree, radius, max_nn, centers)
    ranks = positions_of(cast(neighborhood.mark(centers), uint8))  # sync
    neighborhood.find(ranks)
    histograms = count_angles(neighborhood, normals, ranks)
    slots, within = empty(count, int32, device), empty(centers.size, int32, device)
    launch(fill_positions_kernel, centers.size, [within])
    launch(number_rows_kernel, centers.size, [centers, slots])
    compact = empty((centers.size, FEATURE_COLUMNS), float32, device)
    sum_histograms(neighborhood, histograms, centers, within, compact)
    features = empty((rows.size, FEATURE_COLUMNS), float32, device)
    launch(copy_features_kernel, rows.size, [rows, positions, count, slots, compact, features])
    return features
