"""Independently integrated part of a volume larger than memory."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import AnyArray, Keys
from ...kernels.lang import int64
from ...kernels.memory import download, empty, upload
from ...kernels.volumes.block_rows import SeenBlocks
from ...kernels.volumes.block_surface import BlockSurface
from ...kernels.volumes.tsdf_blocks import block_box
from ...kernels.volumes.voxel_blocks import VoxelBlocks
from .tsdf import FrameState, TSDFVolume

Blocks = NDArray[np.int64]


class PartSurface(NamedTuple):
    """Surface of a part about the volume's origin. `blocks` (int64 keys) and `edge_slots` (int32) identify each
    vertex's grid edge in the complete volume."""

    vertices: NDArray[np.float32]
    colors: NDArray[np.float32] | None
    triangles: NDArray[np.int32]
    blocks: Blocks
    edge_slots: NDArray[np.int32]


class VolumePart(TSDFVolume):
    """Blocks of a TSDFVolume in [low, high), with one more layer at the upper sides. Blocks are bitwise those of the
    complete volume. The surface is that of the cells without the layer, so adjacent parts have each triangle once and
    equal shared vertices."""

    def __init__(self, low: Sequence[int], high: Sequence[int], *, origin: NDArray[np.float64], **sizes: Any):
        super().__init__(**sizes)
        self._low, self._high = np.asarray(low), np.asarray(high)
        self._frames = FrameState(origin=np.array(origin, np.float64))

    def _keep(self, blocks: VoxelBlocks) -> None:
        self.blocks, self._device_frames = blocks, None

    def _filter_keys(self, keys: Keys) -> Any:
        downloaded = download(keys)  # sync. Some thousand
        blocks = block_box(downloaded)
        inside = ((blocks >= self._low) & (blocks <= self._high)).all(axis=1)
        return upload(np.ascontiguousarray(downloaded[inside]), int64, self.device)

    def extract_part(self, weight_threshold: float) -> PartSurface:
        """Surface of the part by marching cubes. See `TSDFVolume.extract_triangle_mesh`."""
        surface = BlockSurface(SeenBlocks(self.blocks, weight_threshold), True, (self._low, self._high))
        vertices, shades, _ = surface.vertices(self.has_frame_colors, False)
        blocks, edge_slots = surface.vertex_edges()
        return PartSurface(
            download(vertices).reshape(-1, 3),
            None if shades is None else download(shades).reshape(-1, 3),
            download(surface.triangles()).reshape(-1, 3),
            download(blocks),
            download(edge_slots),
        )


class BlockFinder(TSDFVolume):
    """Records the blocks that `integrate` would touch in `block_indices`, int64 (m, 3), without integrating."""

    def __init__(self, *, origin: NDArray[np.float64], **sizes: Any):
        super().__init__(**sizes)
        self.block_indices: Blocks = np.zeros((0, 3), np.int64)
        self._frames = FrameState(origin=np.array(origin, np.float64))

    def _keep(self, blocks: VoxelBlocks) -> None:
        self.blocks, self._device_frames = blocks, None

    def _fold(
        self, raw: AnyArray, scale: float, farthest: float, camera: Any, T: NDArray[np.float64], pixels: AnyArray | None
    ) -> Any:
        self.block_indices = np.zeros((0, 3), np.int64)
        return super()._fold(raw, scale, farthest, camera, T, pixels)

    def _filter_keys(self, keys: Keys) -> Any:
        self.block_indices = block_box(download(keys))  # sync
        return empty(0, int64, self.device)
