"""Scratch memory of searches for the neighbours of groups of queries, and the launches that share it.

On the CPU a group is a leaf's points: their candidates are copied side by side, and a query's keys lie side by side.
On CUDA it is a warp's 32 lanes (lane_search.py): their candidates are a list of leaves, and the keys of all queries of
a launch are interleaved, key j of thread i at i + j * stride, so that a warp takes one of each lane at once.
"""

from collections.abc import Iterator

from ..array_types import Device
from ..arrays.side_by_side import part_of
from ..lang import WARP, array, float32, func, int32, int64, struct
from ..memory import empty
from .point_tree import BUCKET, LEAF

CPU_RUN = 32  # groups a thread on the CPU; the queries of the first have no group before and walk the tree
SCRATCH = 2**25  # scratch numbers of one kind a launch on the CPU
SM_THREADS = 768  # a launch on CUDA: what a multiprocessor holds at 80 registers a thread; a warp takes groups in turn
MOST_LEAVES = 512  # that a warp measures, besides two a neighbour
MOST_KEYS = 2**28  # a launch on CUDA, 2 GB


@struct
class LaunchPart:
    """The groups of one launch.

    Attributes:
        first, last: The groups from `first` to `last` - 1.
        run: Groups a thread.
        threads: Threads.
    """

    first: int
    last: int
    run: int

    def __init__(self, first: int, last: int, run: int, threads: int) -> None:
        self.first, self.last, self.run, self.threads = first, last, run, threads


@struct
class GroupScratch:
    """Scratch memory of searches in groups, and the parts in which they are launched.

    Attributes:
        xs, ys, zs, ids: Candidates of a group: coordinates and labels; on CUDA only ids, the first places of leaves,
            which lie behind the keys. A group's begin at its number times `gather`.
        keys: A thread's, read by `held_key`: first `room` that are held, then, on the CPU, k
            that are kept.
        k: Neighbours a query.
        gather: Candidates that a group may have, on CUDA leaves.
        width: Queries a group.
        stride: Threads of a launch.
    """

    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    ids: array(dtype=int32)
    keys: array(dtype=int64)
    k: int
    room: int
    gather: int
    width: int
    stride: int

    def __init__(self, device: Device, query_count: int, k: int) -> None:
        """Memory for searches of the k nearest."""
        self.k, self.gather = k, candidate_room(device, k)
        self.lanes = self.width = WARP
        self.room = row = 2 * (k + BUCKET)
        if not device.is_cuda:
            self.lanes, self.width = 1, LEAF
            self.room = max(self.gather, 3 * k + 2 * BUCKET)  # a ball from the query before holds some 2 k
            row = self.room + k
        self.groups = -(-query_count // self.width)
        if device.is_cuda:
            self._allocate_for_warps(device, row)
            return
        self.run, self.most = CPU_RUN, max(1, SCRATCH // row)
        self.stride = max(1, min(-(-self.groups // self.run), self.most))
        self.xs, self.ys, self.zs = (empty(self.stride * self.gather, float32, device) for _ in range(3))
        self.ids, self.keys = empty(self.stride * self.gather, int32, device), empty(self.stride * row, int64, device)

    def _allocate_for_warps(self, device: Device, row: int) -> None:
        """One launch, whose warps take groups in turn: as many as the device holds, fewer where it has no room."""
        warps = max(1, min(device.sm_count * SM_THREADS, MOST_KEYS // row) // WARP)
        while True:
            self.run, self.most = max(1, -(-self.groups // warps)), max(1, self.groups)
            used = max(1, -(-self.groups // self.run))
            self.stride = used * WARP
            held, listed = self.stride * row, used * self.gather
            try:  # one allocation, since each takes the host longer than the parts of one
                self.keys = empty(held + -(-listed // 2), int64, device)
                break
            except MemoryError:
                if used == 1:
                    raise
                warps = used // 2
        self.ids = part_of(self.keys, 8 * held, int32, listed)
        self.xs = self.ys = self.zs = part_of(self.keys, 0, float32, 1)

    def parts(self, shift: int = 0) -> Iterator[LaunchPart]:
        """The LaunchPart of each launch; `shift` is the number of the first query, a multiple of `width`."""
        runs, first = -(-self.groups // self.run), shift // self.width
        for begin in range(0, runs, self.most):
            here = min(self.most, runs - begin)
            last = min(self.groups, (begin + here) * self.run)
            yield LaunchPart(first + begin * self.run, first + last, self.run, here * self.lanes)


@func
def held_key(scratch: GroupScratch, base: int, j: int) -> int64:
    """Key j of a thread's, which begin at `base`."""
    return scratch.keys[base + j]


@held_key.on_cuda
def held_key_of_lane(scratch: GroupScratch, base: int, j: int) -> int64:
    """Key j of a thread's, which begin at `base`."""
    return scratch.keys[base + j * scratch.stride]


def candidate_room(device: Device, k: int) -> int:
    """How many candidates a group may gather: points on the CPU, twice what a surface asks for; leaves on CUDA.

    There a lane that walks the tree alone takes longer than all lanes with many leaves, and a list holds them cheaply.
    """
    return MOST_LEAVES + 2 * k if device.is_cuda else LEAF * max(64, 2 * k + 24)
