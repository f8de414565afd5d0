"""Poisson disk sampling by parallel weighted sample elimination.

Yuksel, "Sample elimination for generating Poisson disk sample sets", Computer Graphics Forum 34(2), 2015. A sample
weighs sum(w(d)) over remaining samples within r_max, w(d) = (1 - max(d, r_min) / r_max)^8. Each round removes all local
maxima, equivalent to the paper's heap since weights only decrease. The last removals are undone. Integer weights, so
the order does not matter. 8 B per neighbor and about 60 B per sample.
"""

import math

from ..array_types import Integers
from ..arrays.packed_keys import key_index, key_number
from ..arrays.prefix_sum import offsets_of, sum_counts
from ..arrays.sort import argsort_keys
from ..arrays.subsets import sort_rows
from ..lang import (
    array,
    atomic_add,
    atomic_max,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    loop_while,
    sqrt,
    struct,
    tid,
)
from ..memory import check_room, download, empty, full, zeros
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of
from ..search.point_tree import PointTree

RADIUS_BETA, RADIUS_GAMMA = 0.65, 1.5  # of the paper's r_min. Its alpha, 8, is the power in `pair_weight`
WEIGHT_BITS = 30  # of the largest weight of a pair: times 2^31 neighbors it fits into 62 bits
WEIGHT_UNIT = float(2**WEIGHT_BITS)
MAX_SEQUENTIAL = 2**16  # samples up to which one core is no slower than two in rounds, which do the work twice
PAIRS_PER_SAMPLE = 6.5  # neighbors times kept samples over all, 1.8 times the value of random samples on a plane
MAX_ROOM = 2**26  # entries of lists that are not counted first: 512 MB
MAX_PAIRS = 2**30  # entries of the lists: 8 GB


@struct
class Elimination:
    """Remaining samples by tree position. `gain` is 1 / (1 - r_min / r_max). `firsts` and `lasts` delimit neighbors
    within r_max in `lists`, with weights `fractions`. `states` are weights, or the negated weight at removal. `rivals`
    cache a heavier neighbor; `peaks` marks samples to remove; `remaining` and `running` whether neighbors remain."""

    tree: PointTree
    max_radius: float64
    gain: float64
    firsts: array(dtype=int32)
    lasts: array(dtype=int32)
    lists: array(dtype=int32)
    fractions: array(dtype=int32)
    states: array(dtype=int64)
    rivals: array(dtype=int32)
    peaks: array(dtype=int32)
    remaining: array(dtype=int32)
    running: array(dtype=int32)

    def __init__(self, tree: PointTree, max_radius: float, min_radius: float, kept_count: int) -> None:
        device, count = tree.device, tree.count
        self.tree, self.max_radius, self.gain = tree, max_radius, 1 / (1 - min_radius / max_radius)
        self.states = empty(count, int64, device)
        self.rivals, self.peaks = full(count, -1, int32, device), zeros(count, int32, device)
        self.remaining, self.running = zeros(1, int32, device), full(1, 1, int32, device)
        near, room = Neighborhood(tree, max_radius, None), math.ceil(PAIRS_PER_SAMPLE * count / kept_count)
        if device.is_cuda or room * count > MAX_ROOM or not self._list_at_once(near, room):
            self._list_counted(near)

    def _list_at_once(self, near: Neighborhood, room: int) -> bool:
        """List neighbors into preallocated room per thread. False if it is too small."""
        device, count = self.tree.device, self.tree.count
        self.firsts, self.lasts = (empty(count, int32, device) for _ in range(2))
        self.lists, self.fractions = (empty(count * room, int32, device) for _ in range(2))
        overflow = zeros(1, int32, device)
        near.visit(list_neighbors_kernel, near.positions, [room, self, overflow])
        return not download(overflow)[0]  # sync

    def _list_counted(self, near: Neighborhood) -> None:
        device, count = self.tree.device, self.tree.count
        counts = empty(count, int32, device)
        near.visit(count_neighbors_kernel, near.positions, [counts])
        total = sum_counts(counts)  # sync
        if total > MAX_PAIRS:
            raise CrowdedError(total)
        check_room(device, 8 * total, f"{total:,} neighbors of {count:,} samples")
        starts = offsets_of(counts)
        self.firsts, self.lasts = starts[:count], starts[1:]
        self.lists, self.fractions = (empty(total, int32, device) for _ in range(2))
        near.visit(list_neighbors_kernel, near.positions, [0, self, zeros(1, int32, device)])

    def round(self) -> None:
        launch(find_peaks_kernel, self.tree.count, [self])
        launch(remove_peaks_kernel, self.tree.count, [self])


class CrowdedError(ValueError):
    def __init__(self, pair_count: int) -> None:
        super().__init__(f"{pair_count} pairs of neighbors")
        self.pair_count = pair_count


@func
def pair_weight(sqdist: float, max_radius: float64, gain: float64) -> int:
    """Mutual weight of two samples in units of 2^-30 of the maximum."""
    fraction = (1.0 - sqrt(float64(sqdist)) / max_radius) * gain
    fraction = min(max(fraction, 0.0), 1.0)
    square = fraction * fraction
    fourth = square * square
    return int(fourth * fourth * float64(WEIGHT_UNIT))


@kernel(max_registers=128)  # two blocks per SM, not one
def count_neighbors_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    counts: array(dtype=int32),
):
    i = tid()
    for member, base, stored in members_of(i, part, ranks, neighborhood, scratch):
        count = stored - 1
        if stored < 0:
            for j, sqdist in neighbors_of(ranks[member], neighborhood):
                count += 1
            count = count + 1
        counts[ranks[member]] = count


@kernel
def list_neighbors_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    room: int,
    samples: Elimination,
    overflow: array(dtype=int32),
):
    """Neighbors of each sample, their weights, and the sum; appended within `room`. The atomic records overflow."""
    i = tid()
    at = (part.first + i * part.run) * scratch.width * room
    end = min((part.first + (i + 1) * part.run) * scratch.width, ranks.shape[0]) * room
    for member, base, stored in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        if room == 0:
            at = samples.firsts[rank]
            end = samples.lasts[rank]
        first = at
        total = int64(0)
        if stored >= 0:
            count = stored
            if at + stored - 1 > end:
                count = 0
                atomic_max(overflow, 0, 1)
            for slot in range(count):
                key = stored_key(scratch, base, slot)
                if key_index(key) != rank:
                    fraction = pair_weight(key_number(key), samples.max_radius, samples.gain)
                    samples.lists[at] = key_index(key)
                    samples.fractions[at] = fraction
                    at += 1
                    total += int64(fraction)
        else:
            for j, sqdist in neighbors_of(rank, neighborhood):
                if j != rank:
                    if at < end:
                        fraction = pair_weight(sqdist, samples.max_radius, samples.gain)
                        samples.lists[at] = j
                        samples.fractions[at] = fraction
                        at += 1
                        total += int64(fraction)
                    else:
                        atomic_max(overflow, 0, 1)
        if room > 0:
            samples.firsts[rank] = first
            samples.lasts[rank] = at
        samples.states[rank] = total


@func
def outweighs(samples: Elimination, j: int, i: int) -> int:
    """1 if j remains and has priority over the remaining i."""
    a = samples.states[j]
    b = samples.states[i]
    heavier = 0
    if a > b:
        heavier = 1
    if a == b:
        if samples.tree.order[j] > samples.tree.order[i]:
            heavier = 1
    return heavier


@func
def is_outweighed(i: int, samples: Elimination) -> int:
    """1 if a neighbor has priority. The last heavier neighbor is tried first, so few lists are read completely."""
    rival = samples.rivals[i]
    beaten = 0
    if rival >= 0:
        beaten = outweighs(samples, rival, i)
    at = samples.firsts[i]
    end = samples.lasts[i]
    while beaten == 0 and at < end:
        rival = samples.lists[at]
        beaten = outweighs(samples, rival, i)
        at += 1
    samples.rivals[i] = rival
    return beaten


@func
def remove_sample(i: int, samples: Elimination):
    samples.states[i] = -samples.states[i]
    for at in range(samples.firsts[i], samples.lasts[i]):
        j = samples.lists[at]
        if samples.states[j] > 0:
            atomic_add(samples.states, j, -int64(samples.fractions[at]))


@kernel
def find_peaks_kernel(samples: Elimination):
    """1 for samples that outweigh all neighbors. The atomic records whether any are left."""
    i = tid()
    if samples.states[i] > 0:
        if samples.remaining[0] == 0:  # avoids most atomics. An old value only causes an extra one
            atomic_max(samples.remaining, 0, 1)
        samples.peaks[i] = 1 - is_outweighed(i, samples)


@kernel
def remove_peaks_kernel(samples: Elimination):
    """Remove the local maxima, which are not neighbors of each other. Thread 0 decides whether to continue."""
    i = tid()
    if i == 0:
        samples.running[0] = samples.remaining[0]
        samples.remaining[0] = 0
    if samples.peaks[i] == 1:
        samples.peaks[i] = 0
        remove_sample(i, samples)


@kernel(for_cpu=True)
def remove_sequentially_kernel(samples: Elimination):
    """All rounds on one thread, which removes a sample as soon as it outweighs its neighbors."""
    i = tid()
    left = 1
    while left == 1:
        left = 0
        for j in range(i, samples.states.shape[0]):
            if samples.states[j] > 0:
                left = 1
                if is_outweighed(j, samples) == 0:
                    remove_sample(j, samples)


@kernel
def spread_keys_kernel(states: array(dtype=int64), order: array(dtype=int32), keys: array(dtype=int64)):
    """Weights at removal by index, zero for samples never removed."""
    i = tid()
    keys[order[i]] = max(-states[i], 0)


def eliminate_samples(tree: PointTree, kept_count: int, max_radius: float) -> Integers:
    """Ascending rows (int32) of evenly spread samples; `max_radius` is r_max [m]. About 40 rounds of two launches.
    One sync. Raises CrowdedError for more than 2^30 pairs of neighbors, MemoryError if device memory is exhausted."""
    min_radius = max_radius * RADIUS_BETA * (1 - (kept_count / tree.count) ** RADIUS_GAMMA)
    samples = Elimination(tree, max_radius, min_radius, kept_count)
    if tree.device.is_cuda or tree.count > MAX_SEQUENTIAL:
        loop_while(samples.running, samples.round)
    else:
        launch(remove_sequentially_kernel, 1, [samples])
    max_neighbors = tree.count
    if not tree.device.is_cuda:  # up to which a faster sort with fewer bits is used
        max_neighbors = int((download(samples.lasts) - download(samples.firsts)).max()) + 1
    weight_bits = WEIGHT_BITS + max_neighbors.bit_length()
    keys = full(tree.source.size, 2**weight_bits, int64, tree.device)  # above all weights: samples that are not finite
    launch(spread_keys_kernel, tree.count, [samples.states, tree.order, keys])
    _, order = argsort_keys(keys, weight_bits + 1)
    return sort_rows(order[:kept_count], tree.source.size, are_distinct=True)
