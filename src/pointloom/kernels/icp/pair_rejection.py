"""Rejection of pairs whose normals disagree, and of the farthest fraction of a job's pairs.

The trimming threshold (Chetverikov et al. 2002) is found by three rounds of histograms over distance bits. An unknown
fraction minimizes the fractional RMSD (Phillips, Liu and Tomasi 2007, "Outlier robust ICP for minimizing fractional
RMSD", eq. 2): sqrt(S / k) / k^a over the k nearest pairs, to an eighth of an octave. Integer counts.
"""

import numpy as np

from ..algebra.rigid_solve import rotate
from ..algebra.transform import narrow, widen
from ..array_types import Doubles, Vectors
from ..lang import (
    array,
    atomic_add,
    bits_float,
    dot,
    float64,
    float_bits,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    tid,
    vec3,
)
from ..memory import empty, upload
from ..search.point_tree import LEAF, square_distance
from .correspondences import LARGEST_BITS
from .jobs import source_position
from .matches import NO_PAIR, Matches, moved_source

BIN_COUNT = 2048  # per round: 11 bits, three rounds for 31
BIN_BITS = 11
SQUARE_SHIFT = 20  # for fractional RMSDs in one round: the eleven highest bits below the sign
DISTANCE_ROUNDING = 2.0**-20  # of a source's spread: smaller distances are float32 rounding, and equal
MIN_FRACTION = 0.1  # minimum fraction of pairs kept: a few coincidental matches are not the overlap


@kernel
def reject_normals_kernel(
    matches: Matches, source_normals: array(dtype=vec3), target_normals: array(dtype=vec3), min_cosine: float64
):
    i = tid()
    job = matches.jobs.group_jobs[i // LEAF]
    if matches.live[job] != 0 and matches.pairs[i] >= 0:
        at = source_position(i, matches.jobs)
        n = rotate(matches.poses[job], widen(source_normals[at]))
        if not (dot(n, widen(target_normals[matches.pairs[i]])) >= min_cosine):
            matches.pairs[i] = NO_PAIR


@kernel
def measure_pairs_kernel(matches: Matches, bits: array(dtype=int32)):
    """Squared distance bits of each pair. The maximum without one."""
    i = tid()
    job = matches.jobs.group_jobs[i // LEAF]
    if matches.live[job] != 0:
        sqdist_bits = int(LARGEST_BITS)
        if matches.pairs[i] >= 0:
            p = narrow(moved_source(i, matches))
            sqdist_bits = float_bits(square_distance(p, matches.targets[matches.pairs[i]]))
        bits[i] = sqdist_bits


@kernel
def clear_counts_kernel(counts: array(dtype=int32)):
    i = tid()
    counts[i] = 0


@kernel
def begin_ranks_kernel(wanted: array(dtype=int32), prefixes: array(dtype=int32), ranks: array(dtype=int32)):
    """Start the search for the pair of rank wanted - 1."""
    i = tid()
    prefixes[i] = 0
    ranks[i] = wanted[i] - 1


@kernel
def count_bits_kernel(
    matches: Matches, bits: array(dtype=int32), prefixes: array(dtype=int32), shift: int, counts: array(dtype=int32)
):
    """Histogram of the next bits of pairs that match the threshold prefix."""
    i = tid()
    job = matches.jobs.group_jobs[i // LEAF]
    if matches.live[job] != 0 and bits[i] != LARGEST_BITS:
        if int(int64(bits[i]) >> int64(shift + BIN_BITS)) == prefixes[job]:  # in 64 bits: the shift may exceed 31
            bin_number = (bits[i] >> shift) & (BIN_COUNT - 1)
            atomic_add(counts, job * BIN_COUNT + bin_number, 1)  # integer sum: order-independent


@kernel
def pick_bin_kernel(
    live: array(dtype=int32), counts: array(dtype=int32), prefixes: array(dtype=int32), ranks: array(dtype=int32)
):
    """Extend the prefix by the bin that contains the rank. All bits set if there are fewer."""
    i = tid()
    if live[i] != 0:
        chosen = int(BIN_COUNT - 1)
        passed = 0
        rank = ranks[i]
        searching = 1
        b = 0
        while searching == 1 and b < BIN_COUNT:
            here = counts[i * BIN_COUNT + b]
            if passed + here > rank:
                chosen = b
                searching = 0
            else:
                passed += here
                b += 1
        ranks[i] = rank - passed
        prefixes[i] = (prefixes[i] << BIN_BITS) | chosen


@kernel
def pick_min_rmsd_kernel(
    live: array(dtype=int32), sizes: array(dtype=float64), counts: array(dtype=int32), thresholds: array(dtype=int32)
):
    """Threshold bits of the minimum fractional RMSD from the histogram; below zero without any pair. With a = 1.25 (the
    paper: 1.3 in space) the minimum S / k^3.5: a root rounds alike everywhere, a power need not.
    """
    i = tid()
    if live[i] != 0:
        total = float64(0.0)
        for b in range(BIN_COUNT):
            total += float64(counts[i * BIN_COUNT + b])
        rounding = sizes[i] * float64(DISTANCE_ROUNDING)
        selected = float64(0.0)
        sqdists = float64(0.0)
        min_score = float64(0.0)
        chosen = -1
        for b in range(BIN_COUNT):
            count = counts[i * BIN_COUNT + b]
            if count > 0:
                selected += float64(count)
                middle = bits_float((b << SQUARE_SHIFT) + (1 << (SQUARE_SHIFT - 1)))
                sqdists += float64(count) * (float64(middle) + rounding * rounding)
                score = sqdists / (selected * selected * selected * sqrt(selected))
                if selected >= float64(MIN_FRACTION) * total and (chosen < 0 or score < min_score):
                    chosen = b
                    min_score = score
        thresholds[i] = -1
        if chosen >= 0:
            thresholds[i] = (chosen << SQUARE_SHIFT) | ((1 << SQUARE_SHIFT) - 1)


@kernel
def trim_pairs_kernel(matches: Matches, bits: array(dtype=int32), thresholds: array(dtype=int32)):
    """Reject pairs beyond their job's threshold. A negative threshold rejects none."""
    i = tid()
    job = matches.jobs.group_jobs[i // LEAF]
    if matches.live[job] != 0 and thresholds[job] >= 0 and bits[i] > thresholds[job]:
        matches.pairs[i] = NO_PAIR


class PairRejection:
    """Launches that reject pairs. Source spreads `sizes` [m] minimize the fractional RMSD instead of `wanted`."""

    def __init__(
        self,
        matches: Matches,
        wanted: np.ndarray | None = None,
        normals: tuple[Vectors, Vectors, float] | None = None,
        *,
        sizes: Doubles | None = None,
    ) -> None:
        jobs, device = matches.jobs, matches.jobs.device
        self.matches, self.normals, self.wanted, self.sizes = matches, normals, None, sizes
        if wanted is not None:
            self.wanted, self.ranks = upload(wanted, int32, device), empty(jobs.count, int32, device)
        if wanted is not None or sizes is not None:
            self.bits = empty(matches.pairs.size, int32, device)
            self.counts = empty(jobs.count * BIN_COUNT, int32, device)
            self.prefixes = empty(jobs.count, int32, device)

    def run(self) -> None:
        matches, jobs, elements = self.matches, self.matches.jobs, self.matches.pairs.size
        if self.normals is not None:
            launch(reject_normals_kernel, elements, [matches, *self.normals])
        if self.wanted is None and self.sizes is None:
            return
        launch(measure_pairs_kernel, elements, [matches, self.bits])
        if self.sizes is not None:
            launch(clear_counts_kernel, jobs.count, [self.prefixes])  # counts the highest bits of every pair
            self._count(SQUARE_SHIFT)
            launch(pick_min_rmsd_kernel, jobs.count, [matches.live, self.sizes, self.counts, self.prefixes])
        else:
            launch(begin_ranks_kernel, jobs.count, [self.wanted, self.prefixes, self.ranks])
            for shift in (2 * BIN_BITS, BIN_BITS, 0):
                self._count(shift)
                launch(pick_bin_kernel, jobs.count, [matches.live, self.counts, self.prefixes, self.ranks])
        launch(trim_pairs_kernel, elements, [matches, self.bits, self.prefixes])

    def _count(self, shift: int) -> None:
        """Histogram of eleven distance bits for all live jobs."""
        launch(clear_counts_kernel, self.counts.size, [self.counts])
        launch(count_bits_kernel, self.matches.pairs.size, [self.matches, self.bits, self.prefixes, shift, self.counts])
