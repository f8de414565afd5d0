"""A part of a volume that is larger than memory: some of its blocks, integrated by themselves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.lang import int64
from ...kernels.memory import download, empty, upload
from ...kernels.volumes.block_rows import SeenBlocks
from ...kernels.volumes.block_surface import BlockSurface
from ...kernels.volumes.tsdf_blocks import block_box
from ...kernels.volumes.voxel_blocks import VoxelBlocks
from .tsdf import TSDFVolume, _Frames

Blocks = NDArray[np.int64]


class PartSurface(NamedTuple):
    """The surface of a part, about the volume's origin.

    Attributes:
        vertices: float32 [n, 3] [m].
        colors: float32 [n, 3], or None.
        triangles: int32 [t, 3].
        blocks: The block that the edge of each vertex belongs to, int64 keys [n].
        places: The edge's place within the block, int32 [n]; with `blocks` it tells a vertex from all others of the
            volume, in whichever part it is met.
    """

    vertices: NDArray[np.float32]
    colors: NDArray[np.float32] | None
    triangles: NDArray[np.int32]
    blocks: Blocks
    places: NDArray[np.int32]


class VolumePart(TSDFVolume):
    """The blocks of a TSDFVolume from a low one to below a high one, and a layer more at the upper sides.

    Frames go into these alone, and leave there the bits that they leave in the whole volume: a block takes nothing from
    another. The surface is that of the cells of the blocks without the layer, which holds these cells' upper corners;
    so the surfaces of parts that lie side by side have each triangle once, and the same bits in vertices that they
    share.

    Args:
        low: The lowest block, whole numbers [3].
        high: The one beyond the highest.
        origin: Of the whole volume [m].
        sizes: Further arguments of TSDFVolume.
    """

    def __init__(self, low: Sequence[int], high: Sequence[int], *, origin: NDArray[np.float64], **sizes: Any):
        super().__init__(**sizes)
        self._low, self._high = np.asarray(low), np.asarray(high)
        self._frames = _Frames(origin=np.array(origin, np.float64))

    def _keep(self, blocks: VoxelBlocks) -> None:
        self._blocks, self._device_frames = blocks, None

    def _kept(self, keys: Any) -> Any:
        found = download(keys)  # sync; some thousand
        blocks = block_box(found)
        inside = ((blocks >= self._low) & (blocks <= self._high)).all(axis=1)
        return upload(np.ascontiguousarray(found[inside]), int64, self.device)

    def extract_part(self, weight_threshold: float) -> PartSurface:
        """The surface of the part, by marching cubes; see `TSDFVolume.extract_triangle_mesh`."""
        surface = BlockSurface(SeenBlocks(self._blocks, weight_threshold), True, (self._low, self._high))
        vertices, shades, _ = surface.vertices(self.has_frame_colors, False)
        blocks, places = surface.vertex_edges()
        return PartSurface(
            download(vertices).reshape(-1, 3),
            None if shades is None else download(shades).reshape(-1, 3),
            download(surface.triangles()).reshape(-1, 3),
            download(blocks),
            download(places),
        )


class BlockFinder(TSDFVolume):
    """Which blocks frames would touch in a volume; it takes none in.

    Args:
        origin: Of the volume [m].
        sizes: Further arguments of TSDFVolume.

    Attributes:
        found: Those of the last frame given to `integrate`, int64 [m, 3].
    """

    def __init__(self, *, origin: NDArray[np.float64], **sizes: Any):
        super().__init__(**sizes)
        self.found: Blocks = np.zeros((0, 3), np.int64)
        self._frames = _Frames(origin=np.array(origin, np.float64))

    def _keep(self, blocks: VoxelBlocks) -> None:
        self._blocks, self._device_frames = blocks, None

    def _fold(self, raw: Any, scale: float, farthest: float, camera: Any, T: Any, pixels: Any) -> Any:
        self.found = np.zeros((0, 3), np.int64)
        return super()._fold(raw, scale, farthest, camera, T, pixels)

    def _kept(self, keys: Any) -> Any:
        self.found = block_box(download(keys))  # sync
        return empty(0, int64, self.device)
