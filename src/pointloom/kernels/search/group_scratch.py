"""Scratch memory for neighbor searches of query groups.

On the CPU a group is a leaf's points with contiguous candidates and keys. On CUDA it is a warp (lane_search.py): the
candidates are leaves, and key j of thread i is at i + j * stride for coalesced access.
"""

from collections.abc import Iterator

from ..array_types import Device
from ..arrays.side_by_side import part_of
from ..lang import WARP, array, float32, func, int32, int64, struct
from ..memory import empty
from .point_tree import BUCKET, LEAF

CPU_RUN = 32  # groups per CPU thread. Queries of the first have no previous group and traverse the tree
MAX_SCRATCH_NUMBERS = 2**25  # scratch numbers of one kind per CPU launch
SM_THREADS = 768  # per CUDA launch: a multiprocessor's capacity at 80 registers per thread
MAX_LEAVES = 512  # measured by a warp, besides two per neighbor
MAX_KEYS = 2**28  # per CUDA launch, 2 GB


@struct
class LaunchPart:
    """Groups `first` to `last` - 1 of one launch, `run` groups per thread, `threads` threads."""

    first: int
    last: int
    run: int

    def __init__(self, first: int, last: int, run: int, threads: int) -> None:
        self.first, self.last, self.run, self.threads = first, last, run, threads


@struct
class GroupScratch:
    """Scratch memory of searches in groups: candidates of a group from its number times `gather` (on CUDA `ids` of
    leaves, behind the keys); `room` keys per thread, then on the CPU k kept; `stride`: threads per launch.
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
        self.k, self.gather = k, candidate_room(device, k)
        self.lanes = self.width = WARP
        self.room = row = 2 * (k + BUCKET)
        if not device.is_cuda:
            self.lanes, self.width = 1, LEAF
            self.room = max(self.gather, 3 * k + 2 * BUCKET)  # a ball from the previous query contains about 2 k
            row = self.room + k
        self.groups = -(-query_count // self.width)
        if device.is_cuda:
            self._allocate_for_warps(device, row)
            return
        self.run, self.max_threads = CPU_RUN, max(1, MAX_SCRATCH_NUMBERS // row)
        self.stride = max(1, min(-(-self.groups // self.run), self.max_threads))
        size = self.stride * self.gather
        self.xs, self.ys = empty(size, float32, device), empty(size, float32, device)
        self.zs, self.ids = empty(size, float32, device), empty(size, int32, device)
        self.keys = empty(self.stride * row, int64, device)

    def _allocate_for_warps(self, device: Device, row: int) -> None:
        """One launch whose warps process several groups: limited by the device's threads and memory."""
        warps = max(1, min(device.sm_count * SM_THREADS, MAX_KEYS // row) // WARP)
        while True:
            self.run, self.max_threads = max(1, -(-self.groups // warps)), max(1, self.groups)
            used = max(1, -(-self.groups // self.run))
            self.stride = used * WARP
            key_count, listed = self.stride * row, used * self.gather
            try:  # one allocation, since each costs the host more than views
                self.keys = empty(key_count + -(-listed // 2), int64, device)
                break
            except MemoryError:
                if used == 1:
                    raise
                warps = used // 2
        self.ids = part_of(self.keys, 8 * key_count, int32, listed)
        self.xs = self.ys = self.zs = part_of(self.keys, 0, float32, 1)

    def parts(self, shift: int = 0) -> Iterator[LaunchPart]:
        """The LaunchPart of each launch; `shift` is the first query, a multiple of `width`."""
        runs, first = -(-self.groups // self.run), shift // self.width
        for begin in range(0, runs, self.max_threads):
            here = min(self.max_threads, runs - begin)
            last = min(self.groups, (begin + here) * self.run)
            yield LaunchPart(first + begin * self.run, first + last, self.run, here * self.lanes)


@func
def stored_key(scratch: GroupScratch, base: int, j: int) -> int64:
    """Key j of the thread whose keys begin at `base`."""
    return scratch.keys[base + j]


@stored_key.on_cuda
def stored_key_of_lane(scratch: GroupScratch, base: int, j: int) -> int64:
    return scratch.keys[base + j * scratch.stride]


def candidate_room(device: Device, k: int) -> int:
    """Maximum candidates of a group. A longer list on CUDA, because a lane that searches alone is slower."""
    return MAX_LEAVES + 2 * k if device.is_cuda else LEAF * max(64, 2 * k + 24)
