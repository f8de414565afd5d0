"""The k nearest points of every point of a tree as lists of ranks, in parts that are made one after the other.

Points are named by their rank on the tree's curve, so neighbours in space lie near each other in memory, whatever
order the cloud has. 4 B a neighbour and nothing else: no distances, no rows of the cloud.
"""

from collections.abc import Iterator

from ..array_types import Indices
from ..arrays.packed_keys import key_index
from ..arrays.sort import positions
from ..lang import INFINITY, WARP, array, int32, kernel, launch, tid
from ..memory import empty
from .group_scratch import GroupScratch, LaunchPart, held_key
from .group_search import nearest_of_leaves
from .point_tree import PointTree
from .tree_search import reach_of

MOST_ENTRIES = 2**30  # of a part: below the limit of what one array of a launch may hold


@kernel(most_registers=80)
def list_neighbors_kernel(
    part: LaunchPart,
    begin: int,
    sort: int,
    own: int,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    reach: float,
    lists: array(dtype=int32),
):
    """Rows of the ranks of the k nearest points within reach, for the leaves of a part.

    Where they are fewer than k the point itself with `own`, else -1.
    """
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, places, scratch, reach, sort):
        out = (rank - begin) * scratch.k
        for j in range(size):
            lists[out + j] = key_index(held_key(scratch, base, j))
        for j in range(size, scratch.k):
            lists[out + j] = rank if own == 1 else -1


def list_neighbors(
    tree: PointTree, k: int, radius: float = INFINITY, sort: bool = True, own: bool = False, most: int = MOST_ENTRIES
) -> Iterator[tuple[int, Indices]]:
    """The k nearest points of each of a tree's points, itself among them.

    Args:
        tree: A PointTree.
        k: Neighbours a list.
        radius: Upper limit of the distance [m], excluded.
        sort: By distance, ties by rank; else in an order that may differ between devices.
        own: Fill up lists that have fewer than k entries with the point itself, else with -1. Without a radius, too,
            they may: where squared distances are beyond float32.
        most: Entries of a part.

    Yields:
        (begin, lists): the lists of the points of rank `begin` and following, int32 [points * k].
    """
    device, reach = tree.device, reach_of(radius)
    places = positions(tree.count, device)
    step = max(1, most // (k * WARP)) * WARP  # whole groups
    for begin in range(0, tree.count, step):
        rows = min(step, tree.count - begin)
        lists = empty(rows * k, int32, device)
        scratch = GroupScratch(device, rows, k)
        for part in scratch.parts(shift=begin):
            arguments = [part, begin, int(sort), int(own), tree, places, scratch, reach, lists]
            launch(list_neighbors_kernel, part.threads, arguments)
        yield begin, lists
