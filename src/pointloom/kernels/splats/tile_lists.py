"""Splats of each tile, front to back: stable sorts by depth, then by tile, so lists are deterministic."""

from ..array_types import Integers
from ..arrays.key_starts import find_key_starts
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.sort import SortKeys, put_key
from ..lang import array, compute, float_bits, func, int32, int64, kernel, launch, struct, tid, vec4i
from ..memory import empty
from .projection import TILE_PIXELS, TILE_SIDE, ProjectedSplats

BITS_OF_DEPTH = 32


@struct
class TileLists:
    """Splat lists per tile: `width`, `height` [px]; `columns` of tiles; `starts` (tiles + 1); `members`."""

    width: int
    height: int
    columns: int
    starts: array(dtype=int32)
    members: array(dtype=int32)

    def __init__(self, projected: ProjectedSplats, counts: Integers, width: int, height: int) -> None:
        """From splats and their tile counts (two syncs)."""
        device = projected.device
        self.width, self.height, self.columns = width, height, -(-width // TILE_SIDE)
        self.tile_count = self.columns * -(-height // TILE_SIDE)
        by_depth = SortKeys(projected.count, device)
        launch(key_depths_kernel, projected.count, [projected, counts, by_depth])
        _, order = by_depth.sort(BITS_OF_DEPTH)
        in_order = compute(take_counts_kernel, projected.count, [order, counts], int32, device)
        offsets, total = exclusive_scan(in_order, largest=self.tile_count)  # sync
        keys, owners = SortKeys(total, device), empty(total, int32, device)
        launch(list_tiles_kernel, projected.count, [order, offsets, projected.boxes, self.columns, keys, owners])
        by_tile, entries = keys.sort(max(self.tile_count.bit_length(), 1))
        self.starts, self.members = empty(self.tile_count + 1, int32, device), empty(total, int32, device)
        find_key_starts(by_tile, self.starts)
        launch(take_counts_kernel, total, [entries, owners, self.members])

    @property
    def threads(self) -> int:
        """Thread count of pixel kernels, tile by tile: `pixel_of_thread`."""
        return self.tile_count * TILE_PIXELS


@func
def pixel_of_thread(i: int, lists: TileLists) -> int:
    """Pixel of a thread, or -1 outside the image."""
    tile = i // TILE_PIXELS
    column = (tile % lists.columns) * TILE_SIDE + i % TILE_SIDE
    row = (tile // lists.columns) * TILE_SIDE + (i // TILE_SIDE) % TILE_SIDE
    return row * lists.width + column if column < lists.width and row < lists.height else -1


@kernel
def key_depths_kernel(projected: ProjectedSplats, counts: array(dtype=int32), keys: SortKeys):
    """Depth bits as ordered keys; invisible splats come last."""
    i = tid()
    key = (int64(1) << int64(BITS_OF_DEPTH)) - int64(1)
    if counts[i] > 0:
        key = int64(float_bits(projected.middles[i][2]))
    put_key(i, key, keys)


@kernel
def take_counts_kernel(order: array(dtype=int32), values: array(dtype=int32), taken: array(dtype=int32)):
    i = tid()
    taken[i] = values[order[i]]


@kernel
def list_tiles_kernel(
    order: array(dtype=int32),
    offsets: array(dtype=int32),
    boxes: array(dtype=vec4i),
    columns: int,
    keys: SortKeys,
    owners: array(dtype=int32),
):
    i = tid()
    splat = order[i]
    box = boxes[splat]
    box_columns = max(box[1] - box[0] + 1, 1)
    first = offsets[i]
    for slot in range(offsets[i + 1] - first):
        tile = (box[2] + slot // box_columns) * columns + box[0] + slot % box_columns
        put_key(first + slot, int64(tile), keys)
        owners[first + slot] = splat
