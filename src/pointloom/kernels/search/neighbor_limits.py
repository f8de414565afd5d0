"""Neighborhoods as one 64-bit limit per point: the neighbors are the keys up to it.

A key is a squared distance above a tree position. Operations that need the neighbors again store 8 B per point instead
of a list and search without sorting or selection.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..array_types import Integers
from ..arrays.lanes import max_of_lanes
from ..arrays.packed_keys import key_limit, key_number, pack_key
from ..lang import (
    INFINITY,
    WARP,
    Kernel,
    array,
    atomic_max,
    bits_float,
    cuda_func,
    func,
    int32,
    int64,
    kernel,
    lane,
    launch,
    loop,
    struct,
    tid,
    vec3,
    vector,
)
from ..memory import empty, full, zeros
from .bucket_walk import points_within
from .group_scratch import GroupScratch, LaunchPart
from .group_search import SQDIST_GROWTH, gather_candidates, grown_sqradius, pick_within
from .k_nearest import search_k_nearest
from .lane_search import keep_up_to_limit, list_leaves, search_lanes
from .neighbor_keys import limit_nearest
from .point_tree import BUCKET, LEAF, PointTree, positions_in, square_distance
from .tree_search import squared_radius

eight_counts = vector(8, int32)
LIST_SIZE = 256  # neighbors assumed for scratch memory if unlimited


@func
def count_candidates(p: vec3, scratch: GroupScratch, first: int, size: int, max_sqdist: float) -> int:
    counts = eight_counts(0)
    full = size // LEAF
    for chunk in range(full):
        start = first + chunk * LEAF
        for j in range(LEAF):
            x = scratch.xs[start + j] - p[0]
            y = scratch.ys[start + j] - p[1]
            z = scratch.zs[start + j] - p[2]
            counts[j] = counts[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0)
    total = 0
    for j in range(LEAF):
        total += counts[j]
    for j in range(first + full * LEAF, first + size):
        x = scratch.xs[j] - p[0]
        y = scratch.ys[j] - p[1]
        z = scratch.zs[j] - p[2]
        if x * x + y * y + z * z <= max_sqdist:
            total += 1
    return total


@func
def gather_group(
    ranks: array(dtype=int32),
    head: int,
    tail: int,
    max_sqdist: float,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    listing: int,
) -> int:
    """Copy the points near the box of a query group. Return the count, or gather + 1 if there are more."""
    size = scratch.gather + 1
    if scratch.gather > 0:
        a = tree.points[ranks[head]]
        b = a + vec3(0.0, 0.0, 0.0)
        for j in range(head + 1, tail):
            q = tree.points[ranks[j]]
            a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
            b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
        size = gather_candidates(
            a, b, ranks[head] // BUCKET, max_sqdist, tree, labels, scratch, listing,
        )  # fmt: skip
    return size


@func
def largest_sqdist(ranks: array(dtype=int32), head: int, tail: int, limits: array(dtype=int64)) -> float:
    """Largest squared distance of the limits of a query group."""
    widest = limits[ranks[head]]
    for j in range(head + 1, tail):
        widest = max(widest, limits[ranks[j]])
    return key_number(widest)


@kernel(max_registers=80)
def find_limits_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    limits: array(dtype=int64),
):
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    for group in range(part.first + i * part.run, min(part.first + (i + 1) * part.run, part.last)):
        head = group * LEAF
        tail = min((group + 1) * LEAF, ranks.shape[0])
        gathered = gather_group(ranks, head, tail, max_sqdist, tree, labels, scratch, listing)
        for j in range(head, tail):
            rank = ranks[j]
            p = tree.points[rank]
            limit = key_limit(max_sqdist)
            if gathered <= scratch.gather:
                if count_candidates(p, scratch, listing, gathered, max_sqdist) > scratch.k:
                    key_count = pick_within(p, scratch, listing, gathered, base, max_sqdist)
                    limit = limit_nearest(scratch.keys, base, 1, key_count, scratch.k, max_sqdist)
            else:
                near = min(max_sqdist, grown_sqradius(bound, square_distance(before, p)))
                size = search_k_nearest(
                    p, rank // BUCKET, tree, labels, scratch.keys, base, 1, scratch.k, scratch.room, near
                )
                before = p
                bound = float(INFINITY)
                if size == scratch.k:
                    limit = scratch.keys[base + scratch.k - 1]
                    bound = key_number(limit)
            limits[rank] = limit


@find_limits_kernel.on_cuda
def find_limits_of_lanes_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    limits: array(dtype=int64),
):
    i = tid()
    guess = -1.0
    first = part.first + (i // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        j = group * WARP + lane()
        rank = ranks[min(j, ranks.shape[0] - 1)]
        is_query = 1 if j < ranks.shape[0] else 0
        start = ranks[group * WARP] // BUCKET
        result = search_lanes(tree.points[rank], is_query, start, guess, tree, labels, scratch, i, max_sqdist, 1)
        guess = max_of_lanes(bits_float(result[1])) * SQDIST_GROWTH
        if is_query == 1:
            limit = key_limit(max_sqdist)
            if result[0] == scratch.k:
                limit = scratch.keys[i]
                for slot in range(1, scratch.k):
                    limit = max(limit, scratch.keys[i + slot * scratch.stride])
            limits[rank] = limit


@struct
class Neighborhood:
    """The neighbors of each point of a tree within a radius, a count or both, without lists. Ties go to the first on
    the curve. `radius` [m] is exclusive; `max_nn` includes the point itself; `ranks`: positions computed first.
    `limits` (tree.count). Maximum squared distance `max_sqdist` [m^2].
    """

    tree: PointTree
    positions: array(dtype=int32)
    limits: array(dtype=int64)

    def __init__(self, tree: PointTree, radius: float, max_nn: int | None, ranks: Integers | None = None) -> None:
        device, self.tree = tree.device, tree
        self.max_sqdist = squared_radius(radius)
        self.positions = positions_in(tree)
        self.is_complete = max_nn is None or max_nn >= tree.count
        self.list_size = LIST_SIZE if max_nn is None or self.is_complete else max_nn
        if self.is_complete:
            bits = int(np.float32(self.max_sqdist).view(np.int32))
            self.limits = full(tree.count, ((bits + 1) << 32) - 1, int64, device)  # key_limit(max_sqdist)
        else:
            self.limits = empty(tree.count, int64, device)
            self.find(self.positions if ranks is None else ranks)

    def find(self, ranks: Integers) -> None:
        if self.is_complete:
            return
        scratch = GroupScratch(self.tree.device, ranks.size, self.list_size)
        for part in scratch.parts():
            arguments = [part, ranks, self.tree, self.positions, scratch, self.max_sqdist, self.limits]
            launch(find_limits_kernel, part.threads, arguments)

    def visit(self, kernel: Kernel, ranks: Integers, arguments: Sequence[Any]) -> None:
        """Launch a kernel (LaunchPart, ranks, Neighborhood, GroupScratch, `arguments`) that loops over `members_of`."""
        scratch = GroupScratch(self.tree.device, ranks.size, self.list_size)
        for part in scratch.parts():
            launch(kernel, part.threads, [part, ranks, self, scratch, *arguments])

    def mark(self, ranks: Integers) -> Integers:
        """int32 (tree.count): 1 at these tree positions and their neighbors."""
        marks = zeros(self.tree.count, int32, self.tree.device)
        launch(mark_neighbors_kernel, ranks.size, [ranks, self, marks])
        return marks


@loop
def members_of(
    thread: int, part: LaunchPart, ranks: array(dtype=int32), neighborhood: Neighborhood, scratch: GroupScratch
) -> tuple[int, int, int]:
    """The queries of a thread, base and count of their keys, which may exceed the limit; -1 requires a traversal."""
    base = thread * (scratch.room + scratch.k)
    listing = thread * scratch.gather
    for group in range(part.first + thread * part.run, min(part.first + (thread + 1) * part.run, part.last)):
        head = group * scratch.width
        tail = min((group + 1) * scratch.width, ranks.shape[0])
        max_sqdist = largest_sqdist(ranks, head, tail, neighborhood.limits)
        gathered = gather_group(
            ranks, head, tail, max_sqdist, neighborhood.tree, neighborhood.positions, scratch, listing
        )
        for j in range(head, tail):
            rank = ranks[j]
            key_count = -1
            if gathered <= scratch.gather:
                p = neighborhood.tree.points[rank]
                key_count = pick_within(p, scratch, listing, gathered, base, key_number(neighborhood.limits[rank]))
            yield j, base, key_count


@cuda_func
def store_members(
    thread: int, group: int, ranks: array(dtype=int32), neighborhood: Neighborhood, scratch: GroupScratch
) -> int:
    """Store the keys of all neighbors of each lane's query. Return the count, -1 if they do not fit."""
    last = ranks.shape[0] - 1
    rank = ranks[min(group * WARP + lane(), last)]
    p = neighborhood.tree.points[rank]
    limit = neighborhood.limits[rank]
    listing = (thread // WARP) * scratch.gather
    start = ranks[group * WARP] // BUCKET
    listed = list_leaves(p, key_number(limit), start, neighborhood.tree, scratch, listing)
    key_count = -1
    if listed <= scratch.gather:
        key_count = keep_up_to_limit(p, limit, neighborhood.tree, scratch, listing, listed, thread)
    return key_count


@members_of.on_cuda
def members_of_lanes(
    thread: int, part: LaunchPart, ranks: array(dtype=int32), neighborhood: Neighborhood, scratch: GroupScratch
) -> tuple[int, int, int]:
    first = part.first + (thread // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        key_count = store_members(thread, group, ranks, neighborhood, scratch)
        j = group * WARP + lane()
        if j < ranks.shape[0]:
            base = thread
            yield j, base, key_count


@loop
def neighbors_of(rank: int, neighborhood: Neighborhood) -> tuple[int, float]:
    """Tree positions and squared distances [m^2] of a point's neighbors, by tree traversal."""
    p = neighborhood.tree.points[rank]
    limit = neighborhood.limits[rank]
    for j, sqdist in points_within(rank // BUCKET, p, key_number(limit), neighborhood.tree):
        if pack_key(sqdist, j) <= limit:
            yield j, sqdist


@kernel
def mark_neighbors_kernel(ranks: array(dtype=int32), neighborhood: Neighborhood, marks: array(dtype=int32)):
    """Flag some points and their neighbors. All writers write 1."""
    i = tid()
    rank = ranks[i]
    atomic_max(marks, rank, 1)
    for j, sqdist in neighbors_of(rank, neighborhood):
        atomic_max(marks, j, 1)
