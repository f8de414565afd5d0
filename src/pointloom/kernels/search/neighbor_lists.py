"""Lists of the k nearest points of every tree point, as tree ranks (4 B per neighbor), generated in parts."""

from collections.abc import Iterator

from ..array_types import Indices
from ..arrays.packed_keys import key_index
from ..lang import INFINITY, WARP, array, int32, kernel, launch, tid
from ..memory import empty
from .group_scratch import GroupScratch, LaunchPart, stored_key
from .group_search import nearest_of_leaves
from .point_tree import PointTree, positions_in
from .tree_search import squared_radius

MAX_ENTRIES = 2**30  # per part: below the array size limit of a launch


@kernel(max_registers=80)
def list_neighbors_kernel(
    part: LaunchPart,
    begin: int,
    sort: int,
    own: int,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    lists: array(dtype=int32),
):
    """Ranks of the k nearest points within `max_sqdist`; padded with the point itself with `own`, else -1."""
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, labels, scratch, max_sqdist, sort):
        out = (rank - begin) * scratch.k
        for j in range(size):
            lists[out + j] = key_index(stored_key(scratch, base, j))
        for j in range(size, scratch.k):
            lists[out + j] = rank if own == 1 else -1


def list_neighbors(
    tree: PointTree,
    k: int,
    radius: float = INFINITY,
    sort: bool = True,
    own: bool = False,
    max_entries: int = MAX_ENTRIES,
) -> Iterator[tuple[int, Indices]]:
    """Yield (begin, lists): the k nearest, including itself, of the points from rank `begin` on, int32 (points * k).
    Short lists (by `radius` [m] or float32 overflow) are padded with the point itself if `own`, else with -1.
    """
    device, max_sqdist = tree.device, squared_radius(radius)
    labels = positions_in(tree)
    step = max(1, max_entries // (k * WARP)) * WARP  # whole groups
    for begin in range(0, tree.count, step):
        rows = min(step, tree.count - begin)
        lists = empty(rows * k, int32, device)
        scratch = GroupScratch(device, rows, k)
        for part in scratch.parts(shift=begin):
            arguments = [part, begin, int(sort), int(own), tree, labels, scratch, max_sqdist, lists]
            launch(list_neighbors_kernel, part.threads, arguments)
        yield begin, lists
