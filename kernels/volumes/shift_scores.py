"""How well points would lie on a volume's surface if they were shifted: one number for each of many shifts.

A frame of a corridor with like doors lies on the model at its place, and as well a door further on. Which shifts there
are is asked of the distances themselves: a point on the surface counts 1, one a truncation away or where nothing was
seen 0. Rotations are not tried, and what a point hides is not asked: that is for an alignment to tell.

One thread a shift: a look-up in the hash table and 6 B a point; what is hopeless by its first points ends early.
Points come in an order in which the first ones are spread over the picture.
"""

from ..array_types import Points, Scalars, Vectors
from ..arrays.block_keys import block_key
from ..arrays.hash_table import find_position
from ..lang import array, float32, floor, kernel, launch, tid, vec3
from ..memory import empty
from .tsdf_blocks import BLOCK_VOXELS, SIDE
from .voxel_blocks import VoxelBlocks

FIRST_LOOK = 24  # points after which a shift is first given up


@kernel
def score_shifts_kernel(
    points: array(dtype=vec3),
    shifts: array(dtype=vec3),
    blocks: VoxelBlocks,
    threshold: float,
    least: float,
    is_coarse: int,
    scores: array(dtype=float32),
):
    """The mean closeness of the shifted points, all in voxels; of the points looked at, where it was given up."""
    i = tid()
    shift = shifts[i]
    total = 0.0
    looked = 0
    count = points.shape[0]
    while looked < count:
        p = points[looked] + shift
        x = int(floor(p[0] + 0.5))
        y = int(floor(p[1] + 0.5))
        z = int(floor(p[2] + 0.5))
        block = find_position(block_key(x >> 3, y >> 3, z >> 3), blocks.table)
        if block >= 0:
            voxel = block * BLOCK_VOXELS + ((x & 7) * SIDE + (y & 7)) * SIDE + (z & 7)
            if is_coarse == 1:
                total += 1.0
            elif float(blocks.weights[voxel]) > threshold:
                total += 1.0 - min(abs(blocks.distances[voxel]), 1.0)
        looked += 1
        if looked == FIRST_LOOK and total < least * float(looked):
            count = looked
    scores[i] = total / float(max(looked, 1))


def score_shifts(
    points: Points, shifts: Vectors, blocks: VoxelBlocks, threshold: float, least: float, *, is_coarse: bool = False
) -> Scalars:
    """The score of each shift, 0 to 1, float32 device array.

    Args:
        points: vec3 [n], in voxels of the blocks.
        shifts: vec3 [m], likewise.
        blocks: The VoxelBlocks.
        threshold: Voxels seen by no more frames than this are as if absent.
        least: Shifts whose first points score less are not looked at further.
        is_coarse: Whether a point counts 1 wherever a block of the volume is, for steps of a block's size.
    """
    scores = empty(shifts.size, float32, points.device)
    launch(score_shifts_kernel, shifts.size, [points, shifts, blocks, threshold, least, int(is_coarse), scores])
    return scores
