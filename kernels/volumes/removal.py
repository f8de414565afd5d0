"""Removal of integrated depth frames from blocks.

The inverse of the running mean of integrate.py: (D w - d) / (w - 1), for the same voxels and values. A voxel that no
other frame observed becomes unobserved. Each removal adds the rounding of its quotient: 1e-7 truncations, 1/512 of a
color level, times the ratio of the weights before and after all removals. One thread per voxel, 6 B read and written,
12 B with color.
"""

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..algebra.transform import narrow
from ..array_types import Keys
from ..arrays.block_keys import key_block
from ..lang import array, float64, func, int32, kernel, launch, tid, uint16, vec3d
from .frame_record import INTO_CAMERA, recorded_rotation, recorded_translation
from .integrate import NEAREST, Frame, margin_of, note_frame, pixel_of
from .tsdf_blocks import BLOCK_VOXELS, ROWS, SIDE
from .voxel_blocks import COLOR_SCALE, VoxelBlocks

COLOR_LIMIT = 65535.0


@func
def remove_color(voxel: int, pixel: int, frame: Frame, blocks: VoxelBlocks):
    """Remove a pixel's color from a voxel's mean, before its weight changes to at least 1."""
    w = float(blocks.weights[voxel])
    for c in range(3):
        shade = float(frame.pixels[pixel, c]) * COLOR_SCALE
        rest = (float(blocks.colors[voxel, c]) * w - shade) / (w - 1.0)
        blocks.colors[voxel, c] = uint16(smaller(larger(rest, 0.0), COLOR_LIMIT) + 0.5)


@kernel
def remove_depth_kernel(
    touched: array(dtype=int32),
    counts: array(dtype=int32),
    record: array(dtype=float64),
    frame: Frame,
    blocks: VoxelBlocks,
):
    """One thread per voxel, with the projection of `integrate_voxels_kernel`."""
    i = tid()
    note_frame(i, counts, record, blocks)
    block = touched[i // BLOCK_VOXELS]
    voxel = block * BLOCK_VOXELS + i % BLOCK_VOXELS
    x = i // ROWS % SIDE
    row = i // SIDE % SIDE
    j = i % SIDE
    size = blocks.voxel_size
    R = recorded_rotation(record, INTO_CAMERA)
    corner = key_block(blocks.keys[block]) * SIDE
    p = narrow(
        R @ (vec3d(float64(corner[0] + x), float64(corner[1]), float64(corner[2])) * size)
        + recorded_translation(record, INTO_CAMERA)
    )
    p0 = p[0] + float(R[0, 1] * size) * float(row)
    p1 = p[1] + float(R[1, 1] * size) * float(row)
    p2 = p[2] + float(R[2, 1] * size) * float(row)
    depth_z = p2 + float(R[2, 2] * size) * float(j)
    scale = 1.0 / larger(depth_z, NEAREST)
    u = (p0 + float(R[0, 2] * size) * float(j)) * scale * float(frame.camera.fx) + (float(frame.camera.cx) + 0.5)
    v = (p1 + float(R[1, 2] * size) * float(j)) * scale * float(frame.camera.fy) + (float(frame.camera.cy) + 0.5)
    width = frame.camera.width
    truncation = float(blocks.truncation)
    right = float(width)
    bottom = float(frame.camera.height)
    pixel = pixel_of(u, v, right, bottom, width)
    d = frame.depth[pixel]
    w = float(blocks.weights[voxel])
    if w > 0.0 and margin_of(u, v, right, bottom, depth_z, d, truncation) > 0.0:
        value = smaller((d - depth_z) * (1.0 / truncation), 1.0)
        rest = 0.0
        if w > 1.0:
            rest = smaller(larger((blocks.distances[voxel] * w - value) / (w - 1.0), -1.0), 1.0)
            if frame.has_color == 1:
                remove_color(voxel, pixel, frame, blocks)
        blocks.distances[voxel] = rest
        blocks.weights[voxel] = uint16(w - 1.0)


def remove_depth(keys: Keys, frame: Frame, T_camera_volume: np.ndarray, blocks: VoxelBlocks) -> None:
    """Remove a frame atomically from blocks `keys`, into which it was integrated with the same pose."""
    touched = blocks.begin(keys)
    nowhere = np.zeros(3)
    blocks.record.write(np.eye(4), T_camera_volume, nowhere, nowhere, blocks.changes.number)
    record = blocks.record
    launch(remove_depth_kernel, keys.size * BLOCK_VOXELS, [touched, record.counts, record.values, frame, blocks])
    blocks.end()
    blocks.latest = (blocks.changes.number, touched)
