"""Depth integration on a GPU without a sync: touched and missing blocks are found on the device.

Rays mark blocks in a grid over the frame's box. Marked cells are numbered by a prefix sum in key order, as on the CPU.
Launch sizes depend only on the camera and the maximum depth, so they are recorded once (frame_record.py). 1.5 B per
cell and 12 B per block of a ray. Room for all blocks that rays could touch is reserved, or, if too large, for the
counted ones after one sync.
"""

import weakref
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..algebra.camera import Camera, CameraLike, pixel_ray
from ..array_types import Array1, Array2, Doubles, Scalars
from ..arrays.block_keys import block_key
from ..arrays.hash_table import HashTable, find_position, find_slot, insert_key
from ..arrays.lanes import max_int_of_lanes
from ..arrays.prefix_sum import inclusive_scan
from ..lang import (
    WARP,
    array,
    atomic_add,
    bits_float,
    float32,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    record,
    replay,
    tid,
    uint8,
    uint16,
)
from ..linear_algebra import inv
from ..memory import Readback, copy, download, empty, fill, free_bytes, rows_of, write, zeros
from .frame_record import (
    BOX_LOW,
    BOX_SIZE,
    COUNTED_INDEX,
    INTO_VOLUME,
    MISSING_INDEX,
    RECORD_LENGTH,
    TOUCHED_INDEX,
    FrameCounts,
    FrameTouches,
    recorded_rotation,
    recorded_translation,
)
from .integrate import Frame, launch_integration
from .tsdf_blocks import (
    BLOCK_SIDE,
    MAX_BLOCKS,
    MAX_GRID,
    MAX_STRIDE,
    blocks_on_segment,
    frame_box,
    is_out_of_range,
    ray_grid,
    ray_slots,
    ray_stride,
)
from .voxel_blocks import VoxelBlocks, check_block_count

RawDepth: TypeAlias = Scalars | Array1[uint16] | NDArray[Any]  # of the device or the host, as Colors
Colors: TypeAlias = Array2[uint8] | NDArray[np.uint8]
LONGEST_STRIDE = float(MAX_STRIDE)
CELLS_PER_GROUP = 32  # cells counted together
TOUCHED_CELL, MISSING_CELL = 1, 2  # states of a cell: touched; touched without a block in the volume
RESERVED_RATIO = 1  # times the existing blocks, plus an eighth of those a frame may touch: reserve for later frames
ROOM_FRACTION = 0.125  # of the free memory, for blocks that a frame may touch but will hardly need


@func
def greatest_of(i: int, values: array(dtype=int32)) -> int:
    """Maximum of nonnegative numbers, the same for all threads."""
    maximum = 0
    for k in range(values.shape[0]):
        maximum = max(maximum, values[k])
    return maximum


@greatest_of.on_cuda
def greatest_of_lanes(i: int, values: array(dtype=int32)) -> int:
    """Each lane of a warp reads some. All 32 lanes must be active."""
    maximum = 0
    k = i % WARP
    while k < values.shape[0]:
        maximum = max(maximum, values[k])
        k += WARP
    return max_int_of_lanes(maximum)


@func
def stride_of(largest: int, camera: Camera, block_size: float64) -> int:
    spacing = float64(bits_float(largest)) / min(camera.fx, camera.fy)
    stride = int(MAX_STRIDE)
    if spacing > 0.0:
        stride = int(min(max(block_size / 2.0 / spacing, 1.0), float64(LONGEST_STRIDE)))
    return stride


@kernel
def mark_touched_kernel(
    depth: array(dtype=float32),
    largest: array(dtype=int32),
    record: array(dtype=float64),
    camera: Camera,
    truncation: float64,
    block_size: float64,
    slots: int,
    grid: array(dtype=uint8),
):
    """Mark the blocks around the depth of a ray. One thread per ray, rounded up to complete warps."""
    i = tid()
    stride = stride_of(greatest_of(i, largest), camera, block_size)
    columns = (camera.width + stride - 2) // stride + 1
    rows = (camera.height + stride - 2) // stride + 1
    if i < columns * rows:
        u = min((i % columns) * stride, camera.width - 1)  # including the last column and row
        v = min((i // columns) * stride, camera.height - 1)
        d = float64(depth[v * camera.width + u])
        if d > 0.0:
            R = recorded_rotation(record, INTO_VOLUME)
            t = recorded_translation(record, INTO_VOLUME)
            ray = pixel_ray(float64(u), float64(v), camera)
            a = (R @ (ray * max(d - truncation, 0.0)) + t) / block_size
            b = (R @ (ray * (d + truncation)) + t) / block_size
            nx = int(record[BOX_SIZE])
            ny = int(record[BOX_SIZE + 1])
            nz = int(record[BOX_SIZE + 2])
            for _slot, x, y, z in blocks_on_segment(a, b, slots):
                cx = x - int(record[BOX_LOW])
                cy = y - int(record[BOX_LOW + 1])
                cz = z - int(record[BOX_LOW + 2])
                if cx >= 0 and cy >= 0 and cz >= 0 and cx < nx and cy < ny and cz < nz:
                    grid[(cx * ny + cy) * nz + cz] = uint8(TOUCHED_CELL)  # all threads write the same


@func
def cell_key(cell: int, record: array(dtype=float64)) -> int64:
    ny = int(record[BOX_SIZE + 1])
    nz = int(record[BOX_SIZE + 2])
    x = cell // (ny * nz) + int(record[BOX_LOW])
    y = (cell // nz) % ny + int(record[BOX_LOW + 1])
    return block_key(x, y, cell % nz + int(record[BOX_LOW + 2]))


@kernel
def count_touched_kernel(
    record: array(dtype=float64), table: HashTable, groups: int, grid: array(dtype=uint8), sizes: array(dtype=int32)
):
    """Touched cells of each group, followed by the number of missing blocks. Integer sums."""
    i = tid()
    if grid[i] != 0:
        atomic_add(sizes, i // CELLS_PER_GROUP, 1)
        if find_position(cell_key(i, record), table) < 0:
            grid[i] = uint8(MISSING_CELL)
            atomic_add(sizes, groups + i // CELLS_PER_GROUP, 1)


@kernel
def list_touched_kernel(
    record: array(dtype=float64),
    table: HashTable,
    grid: array(dtype=uint8),
    offsets: array(dtype=int32),
    groups: int,
    counts: array(dtype=int32),
    keys: array(dtype=int64),
    touched: array(dtype=int32),
):
    i = tid()
    if i == 0:
        counts[TOUCHED_INDEX] = offsets[groups]
        counts[MISSING_INDEX] = offsets[2 * groups] - offsets[groups]
    if grid[i] != 0:
        group = i // CELLS_PER_GROUP
        at = offsets[group]
        position = counts[COUNTED_INDEX] + offsets[groups + group] - offsets[groups]
        for j in range(group * CELLS_PER_GROUP, i):
            if grid[j] != 0:
                at += 1
            if grid[j] == uint8(MISSING_CELL):
                position += 1
        key = cell_key(i, record)
        if grid[i] == uint8(MISSING_CELL):
            keys[position] = key
        else:
            position = find_position(key, table)
        touched[at] = position


@kernel
def insert_new_kernel(counts: array(dtype=int32), keys: array(dtype=int64), table: HashTable):
    """Insert the keys of new blocks. The number of threads is an upper bound."""
    i = tid()
    if i < counts[MISSING_INDEX]:
        insert_key(keys[counts[COUNTED_INDEX] + i], table)


@kernel
def store_all_positions_kernel(counts: array(dtype=int32), keys: array(dtype=int64), table: HashTable):
    """Store each key's position, since insertion moves keys. The number of threads is an upper bound."""
    i = tid()
    if i < counts[COUNTED_INDEX] + counts[MISSING_INDEX]:
        table.positions[find_slot(keys[i], table)] = i


class FrameShape:
    """Sizes shared by frames with the same launches: pixels between rays, maximum blocks per ray and frame."""

    def __init__(self, scale: float, farthest: float, camera: CameraLike, has_color: bool, blocks: VoxelBlocks) -> None:
        self.block_size = BLOCK_SIDE * blocks.voxel_size
        self.stride = ray_stride(farthest, camera, self.block_size)
        self.slots = ray_slots(camera, blocks.truncation, blocks.voxel_size)
        columns, rows = ray_grid(camera, self.stride)
        self.max_blocks = columns * rows * self.slots
        self.threads = -(-columns * rows // 32) * 32
        self.scale, self.farthest, self.has_color = scale, farthest, has_color


class DeviceFrames:
    """Buffers and recorded launches for the frames of a volume on a GPU."""

    def __init__(self, blocks: VoxelBlocks, images: ModuleType) -> None:
        """`images` is images/depth.py of a higher package."""
        self._blocks, self._images = blocks, images
        self._key: Any = None  # identifies frames that reuse these arrays
        self._graph, self._recorded, self._cells = None, None, 0
        self._touches: Callable[[], FrameTouches | None] = lambda: None  # of the last frames together, if still used

    def integrate(
        self,
        raw: RawDepth,
        scale: float,
        farthest: float,
        camera: CameraLike,
        T_volume_camera: np.ndarray,
        pixels: Colors | None = None,
    ) -> FrameCounts | None:
        """Integrate a frame atomically without a sync. `raw` is uint16 / `scale` or float32 [m], ignored beyond
        `farthest`. Returns FrameCounts, or None for a box too large for a grid. Raises ValueError beyond int32 blocks.
        Images of the host are uploaded while the GPU works on the last frame.
        """
        blocks, boxes = self._blocks, self._boxes(farthest, [camera], [T_volume_camera])
        if boxes is None:
            return None
        self._prepare(raw, scale, float(np.float32(farthest)), [camera], pixels, boxes)
        known = blocks.count  # as sent by the last frame
        blocks.record.write(T_volume_camera, inv(T_volume_camera), *boxes[0], blocks.changes.count + 1)
        if self._has_room(known):
            counts = blocks.begin_on_device()
            self._run_all()
        else:
            self._find(0)
            count = known + self._count_missing()
            check_block_count(count)
            blocks.reserve(count)
            blocks.make_room(blocks.keys.size)
            counts = blocks.begin_on_device()
            self._fold(0)
        blocks.end()
        blocks.record.readback.send()
        return counts

    def integrate_together(
        self,
        raw: RawDepth,
        scale: float,
        farthest: float,
        cameras: Sequence[CameraLike],
        T_volume_camera: Sequence[np.ndarray],
        pixels: Colors | None = None,
    ) -> FrameTouches | None:
        """Integrate frames of one size as `integrate` does one after another, in one graph: all or none. `raw` and
        `pixels` are those of all frames. Returns None, without effect, if a box is too large or all new blocks might
        not fit."""
        blocks, boxes = self._blocks, self._boxes(farthest, cameras, T_volume_camera)
        if boxes is None:
            return None
        self._prepare(raw, scale, float(np.float32(farthest)), cameras, pixels, boxes)
        known = blocks.count
        if (last := self._touches()) is not None:
            last.read()
        if not self._has_room(known):
            return None
        first = blocks.changes.count + 1
        numbers = [
            blocks.record.numbers_of(T, inv(T), *box, first + k).copy()
            for k, (T, box) in enumerate(zip(T_volume_camera, boxes, strict=True))
        ]
        write(self._values, np.concatenate(numbers))
        blocks.begin_on_device(len(cameras))
        self._run_all()
        blocks.end()
        blocks.record.readback.send()
        self._readback.send()
        touches = FrameTouches(self._readback)
        self._touches = weakref.ref(touches)
        return touches

    def _boxes(
        self, farthest: float, cameras: Sequence[CameraLike], T_volume_camera: Sequence[np.ndarray]
    ) -> list[tuple[np.ndarray, np.ndarray]] | None:
        """First block and size of the box of each frame [blocks]. None if one is too large or out of range."""
        blocks, limit, boxes = self._blocks, float(np.float32(farthest)), []
        if not np.isfinite(limit):
            return None
        for camera, T in zip(cameras, T_volume_camera, strict=True):
            low, size, _ = frame_box(limit, camera, T, blocks.truncation, blocks.voxel_size)
            if is_out_of_range(low, size) or size.prod() > MAX_GRID:
                return None
            boxes.append((low, size))
        return boxes

    def _prepare(
        self,
        raw: RawDepth,
        scale: float,
        farthest: float,
        cameras: Sequence[CameraLike],
        pixels: Colors | None,
        boxes: list[tuple[np.ndarray, np.ndarray]],
    ) -> None:
        """Copy the images to arrays that have room for these frames."""
        cells = max(int(size.prod()) for _, size in boxes)
        numbers = tuple((c.width, c.height, c.fx, c.fy, c.cx, c.cy) for c in cameras)
        element = float32 if raw.dtype in (float32, np.float32) else uint16
        key = (*numbers, element, scale, farthest, pixels is not None)
        if key != self._key or cells > self._cells:
            self._allocate(raw.size, element, scale, farthest, cameras, pixels is not None, cells)
            self._key = key
        images = [(self._raw, raw)] if pixels is None else [(self._raw, raw), (self._pixels, pixels)]
        for target, image in images:
            if isinstance(image, np.ndarray):
                write(target, image)
            else:
                copy(target, image, count=image.size)

    def _allocate(
        self,
        size: int,
        element: Any,
        scale: float,
        farthest: float,
        cameras: Sequence[CameraLike],
        has_color: bool,
        cells: int,
    ) -> None:
        self._key, self._graph, self._recorded = None, None, None
        shapes = [FrameShape(scale, farthest, camera, has_color, self._blocks) for camera in cameras]
        device, frames = self._blocks.device, len(cameras)
        count = size // frames
        self._raw, self._depth = empty(size, element, device), empty(count, float32, device)
        self._raws = [rows_of(self._raw, k * count, (k + 1) * count) for k in range(frames)]
        self._largest = zeros(self._images.depth_runs(self._raws[0]).rows, int32, device)
        self._pixels = zeros((size if has_color else 1, 3), uint8, device)
        colors = [rows_of(self._pixels, k * count, (k + 1) * count) if has_color else None for k in range(frames)]
        self._frames = [Frame(self._depth, farthest, c, p) for c, p in zip(cameras, colors, strict=True)]
        self._values = zeros(frames * RECORD_LENGTH, float64, device)  # of frames together
        self._touched_counts = zeros(frames, int32, device)
        self._readback = Readback(self._touched_counts)
        self._cells = min(MAX_GRID, 1 << (cells - 1).bit_length() + 1)
        self._groups = -(-self._cells // CELLS_PER_GROUP)
        self._grid = zeros(self._groups * CELLS_PER_GROUP, uint8, device)
        self._sizes, self._offsets = zeros(2 * self._groups, int32, device), zeros(2 * self._groups + 1, int32, device)
        self._touched = empty(min(max(shape.max_blocks for shape in shapes), self._cells), int32, device)
        self._shapes = shapes

    def _has_room(self, known: int) -> bool:
        """True if all blocks that the frames could touch fit, possibly after a modest reallocation."""
        blocks, max_touched = self._blocks, len(self._shapes) * self._touched.size
        if not blocks.has_room(known + max_touched):
            free, room = free_bytes(blocks.device), max_touched + RESERVED_RATIO * (known + max_touched // 8)
            if known + room > MAX_BLOCKS or free is None or max_touched * blocks.block_bytes > ROOM_FRACTION * free:
                return False
            blocks.make_room(known + room)
        return True

    def _record(self, k: int) -> Doubles:
        if len(self._frames) == 1:
            return self._blocks.record.values
        return rows_of(self._values, k * RECORD_LENGTH, (k + 1) * RECORD_LENGTH)

    def _find(self, k: int) -> None:
        shape, values, table = self._shapes[k], self._record(k), self._blocks.table
        fill(self._largest, 0)
        self._images.scale_depth(self._raws[k], shape.scale, shape.farthest, self._depth, self._largest)
        fill(self._grid, 0)
        fill(self._sizes, 0)
        sizes = [self._blocks.truncation, shape.block_size, shape.slots]
        seen = [self._depth, self._largest, values, self._frames[k].camera]
        launch(mark_touched_kernel, shape.threads, [*seen, *sizes, self._grid])
        launch(count_touched_kernel, self._grid.size, [values, table, self._groups, self._grid, self._sizes])
        inclusive_scan(self._sizes, self._offsets[1:])

    def _fold(self, k: int) -> None:
        blocks, counts, values = self._blocks, self._blocks.record.counts, self._record(k)
        listed = [values, blocks.table, self._grid, self._offsets, self._groups, counts, blocks.keys]
        launch(list_touched_kernel, self._grid.size, [*listed, self._touched])
        launch(insert_new_kernel, self._touched.size, [counts, blocks.keys, blocks.table])
        launch(store_all_positions_kernel, blocks.keys.size, [counts, blocks.keys, blocks.table])
        launch_integration(self._touched, self._touched.size, self._frames[k], blocks, values)

    def _count_missing(self) -> int:
        """Number of touched blocks that are missing (sync)."""
        first, last = self._groups, 2 * self._groups
        ends = [int(download(self._offsets[k : k + 1])[0]) for k in (first, last)]
        return ends[1] - ends[0]

    def _find_and_fold(self) -> None:
        counts = self._blocks.record.counts
        for k in range(len(self._frames)):
            self._find(k)
            self._fold(k)
            if len(self._frames) > 1:
                copy(self._touched_counts, rows_of(counts, TOUCHED_INDEX, TOUCHED_INDEX + 1), count=1, offset=k)

    def _run_all(self) -> None:
        """Find blocks and integrate; recorded on the second run, since a graph costs more than one run. Several frames
        are always a graph: an interrupt must not separate them."""
        blocks = self._blocks
        voxels = (blocks.distances, blocks.weights, blocks.colors)
        arrays = (blocks.keys, *voxels, blocks.table.keys, blocks.record.counts, self._grid)
        addresses = tuple(a.ptr for a in arrays)
        if self._recorded != addresses:
            self._graph, self._recorded = None, addresses
            if len(self._frames) == 1:
                self._find_and_fold()
                return
        if self._graph is None:
            self._graph = record(blocks.device, self._find_and_fold)
        replay(self._graph)
