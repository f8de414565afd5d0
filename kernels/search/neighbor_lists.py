"""The k nearest points of every point of a tree as lists of ranks, in parts that are made one after the other.

Points are named by their rank on the tree's curve, so neighbours in space lie near each other in memory, whatever
order the cloud has. 4 B a neighbour and nothing else: no distances, no rows of the cloud.
"""

from ..arrays.sort import fill_positions_kernel
from ..lang import INFINITY, array, int32, int64, kernel, launch, tid, vec3
from ..memory import empty
from .group_search import GUESS, GroupScratch, farthest_key, gather_around_leaf, grown_reach, search_member
from .point_tree import FAN, INDEX_MASK, LEAF, PointTree, square_distance
from .tree_search import reach_of

MOST_ENTRIES = 2**30  # of a part: below the limit of what one array of a launch may hold


@kernel
def list_neighbors_kernel(
    first: int,
    last: int,
    run: int,
    begin: int,
    sort: int,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    reach: float,
    lists: array(dtype=int32),
):
    """Rows of the ranks of the k nearest points within reach, for the leaves from `first` to `last`; -1 where fewer."""
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    for leaf in range(first + i * run, min(first + (i + 1) * run, last)):
        covered = min(reach, widest * GUESS)
        gathered = gather_around_leaf(leaf, covered, tree, places, scratch, listing)
        widest = float(0.0)
        for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, tree.count)):
            p = tree.points[rank]
            near = min(reach, grown_reach(bound, square_distance(before, p)))
            size = search_member(
                p, leaf // FAN, gathered, covered, tree, places, scratch, listing, base, near, sort,
            )  # fmt: skip
            out = (rank - begin) * scratch.k
            for j in range(size):
                lists[out + j] = int(scratch.keys[base + j] & int64(INDEX_MASK))
            for j in range(size, scratch.k):
                lists[out + j] = -1
            before = p
            bound = float(INFINITY)
            if size == scratch.k:
                bound = farthest_key(scratch.keys, base, size)
            widest = max(widest, bound)


def list_neighbors(tree, k, radius=INFINITY, sort=True, most=MOST_ENTRIES):
    """The k nearest points of each of a tree's points, itself among them.

    Args:
        tree: A PointTree.
        k: Neighbours a list.
        radius: Upper limit of the distance [m], excluded.
        sort: By distance, ties by rank; else in an order that may differ between devices.
        most: Entries of a part.

    Yields:
        (begin, lists): the lists of the points of rank `begin` and following, int32 [points * k]; -1 where a list has
        fewer than k entries.
    """
    device, reach = tree.device, reach_of(radius)
    places = empty(tree.count, int32, device)
    launch(fill_positions_kernel, tree.count, [places])
    step = max(1, most // (k * LEAF)) * LEAF
    for begin in range(0, tree.count, step):
        rows = min(step, tree.count - begin)
        lists = empty(rows * k, int32, device)
        scratch = GroupScratch(device, rows, k, reach)
        common = [begin, int(sort), tree, places, scratch, reach, lists]
        shift = begin // LEAF
        for first, last, threads, run in scratch.parts():
            launch(list_neighbors_kernel, threads, [shift + first, shift + last, run, *common])
        yield begin, lists
