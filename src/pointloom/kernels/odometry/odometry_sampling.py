"""Scan subsampling for odometry: points in range, then the first of each voxel (Vizzo et al. 2023, "KISS-ICP", section
III-B). An ordered hash table keeps the least index per voxel, independent of threads, in a fifth of a sort's time. One
thread of the CPU selects the points of whole scans in order: consecutive ones are often of one voxel.
"""

import math
from collections.abc import Sequence

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Device, Keys, Mask, Points
from ..arrays.hash_table import EMPTY_KEY, insert_entry, mix_bits
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    NAN,
    array,
    compute,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import download, empty, full, host_view, upload, zeros
from .local_cells import LocalCells, cell_holding, local_key

MIN_CAPACITY = 1 << 12  # of a table of voxels. It grows to twice the voxels of a scan
ENTRY_BITS = 63  # of a table entry: voxel key above point index


@kernel
def shift_points_kernel(points: array(dtype=vec3), origin: vec3d, out: array(dtype=vec3)):
    i = tid()
    out[i] = narrow(widen(points[i]) + origin)


@func
def key_in_range(p: vec3, min_range: float64, max_range: float64, cells: LocalCells) -> int64:
    """Voxel of a point with distance in the open range min_range..max_range."""
    key = cells.skipped
    if isfinite(p):
        x = widen(p)
        sqdist = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]
        if sqdist > min_range * min_range and sqdist < max_range * max_range:
            key = local_key(cell_holding(x, cells.size), cells)
    return key


@kernel
def enter_points_kernel(
    points: array(dtype=vec3),
    min_range: float64,
    max_range: float64,
    cells: LocalCells,
    index_bits: int,
    mask: int64,
    entries: array(dtype=int64),
):
    i = tid()
    key = key_in_range(points[i], min_range, max_range, cells)
    if key != cells.skipped:
        insert_entry((key << int64(index_bits)) | int64(i), index_bits, entries, mask)


@kernel
def mark_entries_kernel(entries: array(dtype=int64), index_bits: int, marks: array(dtype=uint8)):
    i = tid()
    entry = entries[i]
    if entry != int64(EMPTY_KEY):
        marks[int(entry & ((1 << int64(index_bits)) - 1))] = 1


@kernel
def encode_in_range_kernel(
    points: array(dtype=vec3), min_range: float64, max_range: float64, cells: LocalCells, keys: array(dtype=int64)
):
    i = tid()
    keys[i] = key_in_range(points[i], min_range, max_range, cells)


@kernel
def mark_firsts_kernel(groups: UniqueKeys, marks: array(dtype=uint8)):
    i = tid()
    marks[groups.order[groups.starts[i]]] = 1


@kernel
def count_entries_kernel(entries: array(dtype=int64), index_bits: int, ranks: array(dtype=int32)):
    i = tid()
    entry = entries[i]
    if entry != int64(EMPTY_KEY):
        ranks[int(entry & ((1 << int64(index_bits)) - 1))] = 1


@kernel
def keep_firsts_kernel(
    points: array(dtype=vec3),
    ranks: array(dtype=int32),
    level: int,
    selected: array(dtype=vec3),
    counts: array(dtype=int32),
):
    """Flagged points in order, then padding outside all voxels; and the count."""
    i = tid()
    total = ranks[ranks.shape[0] - 1]
    before = 0
    if i > 0:
        before = ranks[i - 1]
    if ranks[i] > before:
        selected[before] = points[i]
    if i >= total:
        selected[i] = vec3(NAN, NAN, NAN)
    if i == 0:
        counts[level] = total


def shift_points(points: Points, origin: np.ndarray) -> Points:
    """Points about zero instead of an origin (3). The array itself if that is zero."""
    if not any(origin):
        return points
    return compute(shift_points_kernel, points.size, [points, vec3d(*origin)], vec3, points.device)


def first_in_voxels(points: Points, voxel_size: float, min_range: float, max_range: float) -> Points:
    """First nonzero point of each voxel in the open range [m], in order. Raises ValueError for 2^20 voxels per axis."""
    if points.size == 0:
        return points
    cells = _cells_within(max_range, voxel_size)
    marks = zeros(points.size, uint8, points.device)
    index_bits = (points.size - 1).bit_length()
    if cells.key_bits + index_bits <= ENTRY_BITS:
        capacity = 1 << (2 * points.size - 1).bit_length()
        entries = full(capacity, EMPTY_KEY, int64, points.device)
        entered = [points, min_range, max_range, cells, index_bits, capacity - 1, entries]
        launch(enter_points_kernel, points.size, entered)
        launch(mark_entries_kernel, capacity, [entries, index_bits, marks])
    else:
        _mark_by_sorting(points, min_range, max_range, cells, marks)
    return gather_rows(points, positions_of(marks))  # sync


def thin_successively(points: Points, voxel_sizes: Sequence[float], min_range: float, max_range: float) -> list[Points]:
    """Repeated `first_in_voxels` with each size [m]. One sync on CUDA."""
    index_bits = max(points.size - 1, 0).bit_length()
    chain = [_cells_within(max_range, size) for size in voxel_sizes]
    if not points.device.is_cuda or not points.size or max(c.key_bits for c in chain) + index_bits > ENTRY_BITS:
        thinned = []
        for size in voxel_sizes:
            points = first_in_voxels(points, size, min_range, max_range)
            thinned.append(points)
        return thinned
    device, n = points.device, points.size
    capacity = 1 << (2 * n - 1).bit_length()
    counts, levels = empty(len(chain), int32, device), []
    for level, cells in enumerate(chain):  # launched over the maximum count, to avoid a sync
        ranks, entries = zeros(n, int32, device), full(capacity, EMPTY_KEY, int64, device)
        launch(enter_points_kernel, n, [points, min_range, max_range, cells, index_bits, capacity - 1, entries])
        launch(count_entries_kernel, capacity, [entries, index_bits, ranks])
        inclusive_scan(ranks, ranks)
        selected = empty(n, vec3, device)
        launch(keep_firsts_kernel, n, [points, ranks, level, selected, counts])
        points = selected
        levels.append(selected)
    return [selected[:count] for selected, count in zip(levels, download(counts).tolist(), strict=True)]  # sync


@struct
class Selection:
    """Scratch for the first points of fine and of coarse voxels, and their numbers. `entries`: two hash tables of
    `capacity` keys each, of which at most half are used. `counts`: fine and coarse points, and 1 if there is no room.
    """

    entries: array(dtype=int64)
    fine: array(dtype=vec3)
    coarse: array(dtype=vec3)
    counts: array(dtype=int32)
    capacity: int

    def __init__(self, capacity: int, device: Device) -> None:
        self.capacity, self.counts = capacity, empty(3, int32, device)
        self.entries = empty(2 * capacity, int64, device)
        self.fine, self.coarse = empty(capacity // 2, vec3, device), empty(capacity // 2, vec3, device)


@func
def is_first_of_key(key: int64, begin: int, selection: Selection) -> int:
    """Insert a key into the table that begins at an entry. 1 if it was not there."""
    mask = int64(selection.capacity - 1)
    slot = mix_bits(key) & mask
    is_first = int(-1)
    while is_first < 0:
        entry = selection.entries[begin + int(slot)]
        if entry == key:
            is_first = 0
        elif entry == int64(EMPTY_KEY):
            selection.entries[begin + int(slot)] = key
            is_first = 1
        else:
            slot = (slot + 1) & mask
    return is_first


@kernel(for_cpu=True)
def select_firsts_kernel(
    points: array(dtype=vec3),
    keys: array(dtype=int64),
    min_range: float64,
    max_range: float64,
    cells: LocalCells,
    coarse_cells: LocalCells,
    selection: Selection,
):
    """The first point of each fine voxel, and of them the first of each coarse one. One thread."""
    i = tid()
    fine_count = i + 0
    coarse_count = i + 0
    is_full = int(0)
    previous = cells.skipped
    for j in range(i, points.shape[0]):
        key = keys[j]
        if key != previous and key != cells.skipped and is_full == 0:
            previous = key
            if is_first_of_key(key, 0, selection) == 1:
                if fine_count == selection.capacity // 2:
                    is_full = 1
                else:
                    selection.fine[fine_count] = points[j]
                    fine_count += 1
                    coarse_key = key_in_range(points[j], min_range, max_range, coarse_cells)
                    if coarse_key != coarse_cells.skipped:
                        if is_first_of_key(coarse_key, selection.capacity, selection) == 1:
                            selection.coarse[coarse_count] = points[j]
                            coarse_count += 1
    selection.counts[0] = fine_count
    selection.counts[1] = coarse_count
    selection.counts[2] = is_full


class ScanSampler:
    """`thin_successively` with two voxel sizes [m] for scans of similar size: arrays are reused on the CPU."""

    def __init__(self, fine_size: float, coarse_size: float, min_range: float, max_range: float) -> None:
        self._sizes, self._ranges = (fine_size, coarse_size), (min_range, max_range)
        self._cells: list[LocalCells] = []
        self._selection: Selection | None = None
        self._keys: Keys | None = None

    def thin(self, points: Points) -> tuple[Points, Points]:
        """The first points of the fine voxels, and of them those of the coarse voxels."""
        if points.device.is_cuda or not points.size:
            fine, coarse = thin_successively(points, self._sizes, *self._ranges)
            return fine, coarse
        if not self._cells:
            self._cells = [_cells_within(self._ranges[1], size) for size in self._sizes]
        if self._keys is None or self._keys.size < points.size:
            self._keys = empty(points.size, int64, points.device)
        cells, keys = self._cells, self._keys
        launch(encode_in_range_kernel, points.size, [points, *self._ranges, cells[0], keys])
        if self._selection is None:
            self._selection = Selection(MIN_CAPACITY, points.device)
        while True:
            selection = self._selection
            host_view(selection.entries).fill(EMPTY_KEY)
            launch(select_firsts_kernel, 1, [points, keys, *self._ranges, *cells, selection])
            fine, coarse, is_full = host_view(selection.counts).tolist()
            if not is_full:
                firsts = (host_view(selection.fine)[:fine], host_view(selection.coarse)[:coarse])
                return upload(firsts[0], vec3, points.device), upload(firsts[1], vec3, points.device)
            self._selection = Selection(4 * selection.capacity, points.device)


def _cells_within(max_range: float, voxel_size: float) -> LocalCells:
    radius = math.ceil(max_range / voxel_size) + 1
    cells = LocalCells(voxel_size, (0, 0, 0), radius)
    if cells.bits > 20:
        raise ValueError(f"voxel_size: {voxel_size} makes {2 * radius:,} voxels of the range; take larger ones")
    return cells


def _mark_by_sorting(points: Points, min_range: float, max_range: float, cells: LocalCells, marks: Mask) -> None:
    """Fallback by sorting if voxel and index do not fit into one entry."""
    keys = compute(encode_in_range_kernel, points.size, [points, min_range, max_range, cells], int64, points.device)
    groups = UniqueKeys(keys, cells.key_bits)  # sync
    groups.drop_last(cells.skipped)  # sync
    launch(mark_firsts_kernel, groups.count, [groups, marks])
