"""Removal of integrated depth frames from blocks.

The inverse of the running mean of integrate.py: (D w - d) / (w - 1), for the same voxels and values. A voxel that no
other frame observed becomes unobserved. Each removal adds the rounding of its quotient: 1e-7 truncations, 1/512 of a
color level, times the ratio of the weights before and after all removals. One thread per voxel, 6 B read and written,
12 B with color.
"""

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Keys
from ..lang import array, float64, int32, kernel, launch, tid, uint16
from .frame_record import INTO_CAMERA, recorded_rotation, recorded_translation
from .integrate import Frame, change_color, changed_mean, margin_of, note_frame, pixel_of, project_voxel
from .tsdf_blocks import BLOCK_VOXELS
from .voxel_blocks import VoxelBlocks


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
    R = recorded_rotation(record, INTO_CAMERA)
    at_pixel = project_voxel(i, block, R, recorded_translation(record, INTO_CAMERA), frame, blocks)
    u = at_pixel[0]
    v = at_pixel[1]
    depth_z = at_pixel[2]
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
            rest = smaller(larger(changed_mean(blocks.distances[voxel], w, value, -1.0), -1.0), 1.0)
            if frame.has_color == 1:
                change_color(voxel, pixel, -1.0, frame, blocks)
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
