"""Some of many samples of a surface, about evenly far apart: weighted sample elimination in rounds.

Yuksel, "Sample elimination for generating Poisson disk sample sets", Computer Graphics Forum 34(2), 2015. A sample
weighs sum(w(d)) over the samples left within r_max, w(d) = (1 - max(d, r_min) / r_max)^8. The paper removes the
heaviest sample of all, again and again, by a heap. Here each round removes every sample that is the heaviest within
r_max, of equally heavy ones the one with the highest index. That is the same: weights only fall, so the heap would
remove such a sample before its neighbours and at this weight, whatever happens elsewhere. And the weights at which the
heap removes samples fall from removal to removal, so its first n removals are the n of the largest weights. The rounds
go on until nobody has a neighbour, a few removals too many, and the lightest of them stay after all.

Weights are whole numbers, so that any order of additions gives the same bits; 2^-30 of the largest weight of a pair is
far below what decides. Memory: 8 B a neighbour (18 a sample where init_factor is 5, with room for 33 on the CPU), and
about 60 B a sample beside the search tree. A round reads about one neighbour of each sample that is left.
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
from ..search.group_scratch import GroupScratch, LaunchPart, held_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of
from ..search.point_tree import PointTree

BETA, GAMMA = 0.65, 1.5  # of the paper's r_min; its alpha, 8, is the power in `pair_weight`
WEIGHT_BITS = 30  # of the largest weight of a pair: times 2^31 neighbours it fits into 62 bits
WEIGHT_UNIT = float(2**WEIGHT_BITS)
IN_TURN = 2**16  # samples up to which one core is no slower than two in rounds, which do the work twice
ROOM = 6.5  # neighbours times kept samples to all, 1.8 times what they are at random on a flat surface
MOST_ROOM = 2**26  # entries of lists that are not counted first: 512 MB
MOST_PAIRS = 2**30  # entries of the lists: 8 GB


@struct
class Elimination:
    """The samples that are left, by place on the tree's curve.

    Attributes:
        tree: PointTree of the samples.
        widest: r_max [m].
        gain: 1 / (1 - r_min / r_max).
        firsts, lasts: int32 [n], where each sample's neighbours begin in `lists`, and end.
        lists: int32, the places of neighbours closer than r_max.
        shares: int32, what each of them weighs on the sample.
        states: int64 [n], the weight of a sample that is left; of one that was removed, less than zero by the weight
            that it had.
        rivals: int32 [n], a neighbour that was heavier when it was last asked for.
        peaks: int32 [n], 1 for those that the round removes.
        found: int32 [1], whether a sample that is left has a neighbour.
        running: int32 [1], the same at the end of the round before.
    """

    tree: PointTree
    widest: float64
    gain: float64
    firsts: array(dtype=int32)
    lasts: array(dtype=int32)
    lists: array(dtype=int32)
    shares: array(dtype=int32)
    states: array(dtype=int64)
    rivals: array(dtype=int32)
    peaks: array(dtype=int32)
    found: array(dtype=int32)
    running: array(dtype=int32)

    def __init__(self, tree: PointTree, widest: float, narrowest: float, kept: int) -> None:
        device, count = tree.device, tree.count
        self.tree, self.widest, self.gain = tree, widest, 1 / (1 - narrowest / widest)
        self.states = empty(count, int64, device)
        self.rivals, self.peaks = full(count, -1, int32, device), zeros(count, int32, device)
        self.found, self.running = zeros(1, int32, device), full(1, 1, int32, device)
        near, room = Neighborhood(tree, widest, None), math.ceil(ROOM * count / kept)
        if device.is_cuda or room * count > MOST_ROOM or not self._list_at_once(near, room):
            self._list_counted(near)

    def _list_at_once(self, near: Neighborhood, room: int) -> bool:
        """List the neighbours of each thread's samples one after the other in room for some more than they should have.

        Whether there was room enough: not where samples lie closer than at random on a surface.
        """
        device, count = self.tree.device, self.tree.count
        self.firsts, self.lasts = (empty(count, int32, device) for _ in range(2))
        self.lists, self.shares = (empty(count * room, int32, device) for _ in range(2))
        lacking = zeros(1, int32, device)
        near.visit(list_neighbors_kernel, near.places, [room, self, lacking])
        return not download(lacking)[0]  # sync

    def _list_counted(self, near: Neighborhood) -> None:
        device, count = self.tree.device, self.tree.count
        counts = empty(count, int32, device)
        near.visit(count_neighbors_kernel, near.places, [counts])
        total = sum_counts(counts)  # sync
        if total > MOST_PAIRS:
            raise CrowdedError(total)
        check_room(device, 8 * total, f"{total:,} neighbours of {count:,} samples")
        starts = offsets_of(counts)
        self.firsts, self.lasts = starts[:count], starts[1:]
        self.lists, self.shares = (empty(total, int32, device) for _ in range(2))
        near.visit(list_neighbors_kernel, near.places, [0, self, zeros(1, int32, device)])

    def round(self) -> None:
        """Remove the heaviest of each neighbourhood."""
        launch(find_peaks_kernel, self.tree.count, [self])
        launch(remove_peaks_kernel, self.tree.count, [self])


class CrowdedError(ValueError):
    """More pairs of neighbours than fit.

    Args:
        pair_count: How many there are.
    """

    def __init__(self, pair_count: int) -> None:
        super().__init__(f"{pair_count} pairs of neighbours")
        self.pair_count = pair_count


@func
def pair_weight(sqdist: float, widest: float64, gain: float64) -> int:
    """What two samples weigh on each other, in units of 2^-30 of the most that they can."""
    share = (1.0 - sqrt(float64(sqdist)) / widest) * gain
    share = min(max(share, 0.0), 1.0)
    square = share * share
    fourth = square * square
    return int(fourth * fourth * float64(WEIGHT_UNIT))


@kernel(most_registers=128)  # two blocks of an SM, not one
def count_neighbors_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    counts: array(dtype=int32),
):
    """How many samples lie within reach of each, itself not counted."""
    i = tid()
    for member, base, held in members_of(i, part, ranks, neighborhood, scratch):
        found = held - 1
        if held < 0:
            for j, sqdist in neighbors_of(ranks[member], neighborhood):
                found += 1
            found = found + 1
        counts[ranks[member]] = found


@kernel
def list_neighbors_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    room: int,
    samples: Elimination,
    lacking: array(dtype=int32),
):
    """The neighbours of each sample, what they weigh on it, and the sum of that.

    With room a thread lists the neighbours of its samples one after the other; without, the lists' places are known.
    The atomic settles who says that there was too little.
    """
    i = tid()
    at = (part.first + i * part.run) * scratch.width * room
    end = min((part.first + (i + 1) * part.run) * scratch.width, ranks.shape[0]) * room
    for member, base, held in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        if room == 0:
            at = samples.firsts[rank]
            end = samples.lasts[rank]
        first = at
        total = int64(0)
        if held >= 0:
            count = held
            if at + held - 1 > end:
                count = 0
                atomic_max(lacking, 0, 1)
            for slot in range(count):
                key = held_key(scratch, base, slot)
                if key_index(key) != rank:
                    share = pair_weight(key_number(key), samples.widest, samples.gain)
                    samples.lists[at] = key_index(key)
                    samples.shares[at] = share
                    at += 1
                    total += int64(share)
        else:
            for j, sqdist in neighbors_of(rank, neighborhood):
                if j != rank:
                    if at < end:
                        share = pair_weight(sqdist, samples.widest, samples.gain)
                        samples.lists[at] = j
                        samples.shares[at] = share
                        at += 1
                        total += int64(share)
                    else:
                        atomic_max(lacking, 0, 1)
        if room > 0:
            samples.firsts[rank] = first
            samples.lasts[rank] = at
        samples.states[rank] = total


@func
def outweighs(samples: Elimination, j: int, i: int) -> int:
    """1 where a sample is left and goes before another, which is left."""
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
    """1 where a neighbour of a sample goes before it.

    A neighbour that was heavier the last time most often still is, so few lists are read to their end.
    """
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
    """Remove a sample, and take its weight off its neighbours; the atomic adds whole numbers."""
    samples.states[i] = -samples.states[i]
    for at in range(samples.firsts[i], samples.lasts[i]):
        j = samples.lists[at]
        if samples.states[j] > 0:
            atomic_add(samples.states, j, -int64(samples.shares[at]))


@kernel
def find_peaks_kernel(samples: Elimination):
    """1 for the samples that outweigh all their neighbours; the atomic settles who says that there are any left."""
    i = tid()
    if samples.states[i] > 0:
        if samples.found[0] == 0:  # spares most of the atomics; an old value only lets one more through
            atomic_max(samples.found, 0, 1)
        samples.peaks[i] = 1 - is_outweighed(i, samples)


@kernel
def remove_peaks_kernel(samples: Elimination):
    """Remove the samples that were found. None is another's neighbour, so nobody's state is read that changes.

    The first thread says whether the rounds go on.
    """
    i = tid()
    if i == 0:
        samples.running[0] = samples.found[0]
        samples.found[0] = 0
    if samples.peaks[i] == 1:
        samples.peaks[i] = 0
        remove_sample(i, samples)


@kernel(for_cpu=True)
def remove_in_turn_kernel(samples: Elimination):
    """All rounds by one thread, which removes a sample as soon as it outweighs its neighbours."""
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
    """Weights at removal by index, zero for samples that were never removed."""
    i = tid()
    keys[order[i]] = max(-states[i], 0)


def eliminate_samples(tree: PointTree, kept: int, widest: float) -> Integers:
    """The rows of `kept` of the samples in a tree, spread evenly, ascending.

    Args:
        tree: PointTree of the samples, more than `kept` of them.
        kept: How many to keep.
        widest: The distance r_max [m] within which samples weigh on each other.

    Returns:
        int32 device array [kept]. About 40 rounds of two launches; one sync.

    Raises:
        CrowdedError: More than 2^30 pairs of neighbours.
        MemoryError: The device has no room for them.
    """
    narrowest = widest * BETA * (1 - (kept / tree.count) ** GAMMA)
    samples = Elimination(tree, widest, narrowest, kept)
    if tree.device.is_cuda or tree.count > IN_TURN:
        loop_while(samples.running, samples.round)
    else:
        launch(remove_in_turn_kernel, 1, [samples])
    most = tree.count
    if not tree.device.is_cuda:  # where a sort of fewer bits is another, faster one
        most = int((download(samples.lasts) - download(samples.firsts)).max()) + 1
    weight_bits = WEIGHT_BITS + most.bit_length()
    keys = full(tree.source.size, 2**weight_bits, int64, tree.device)  # beyond all weights: samples that are not finite
    launch(spread_keys_kernel, tree.count, [samples.states, tree.order, keys])
    _, order = argsort_keys(keys, weight_bits + 1)
    return sort_rows(order[:kept], tree.source.size, are_distinct=True)
