"""Score shifts of points by their closeness to a volume's surface, to find ambiguous positions such as repeated doors.

A point counts 1 on the surface, 0 at the truncation or if unobserved. 6 B per point. The first points decide on early
termination, so these should be spread over the image.
"""

from ..array_types import Points, Scalars, Vectors
from ..arrays.block_keys import block_key
from ..arrays.hash_table import find_position
from ..lang import array, float32, floor, kernel, launch, tid, vec3
from ..memory import empty
from .tsdf_blocks import BLOCK_SIDE, BLOCK_VOXELS
from .voxel_blocks import VoxelBlocks

FIRST_LOOK = 24  # points before the first test for early termination


@kernel
def score_shifts_kernel(
    points: array(dtype=vec3),
    shifts: array(dtype=vec3),
    blocks: VoxelBlocks,
    threshold: float,
    min_score: float,
    is_coarse: int,
    scores: array(dtype=float32),
):
    """Mean closeness of shifted points in voxels, over the points evaluated."""
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
            voxel = block * BLOCK_VOXELS + ((x & 7) * BLOCK_SIDE + (y & 7)) * BLOCK_SIDE + (z & 7)
            if is_coarse == 1:
                total += 1.0
            elif float(blocks.weights[voxel]) > threshold:
                total += 1.0 - min(abs(blocks.distances[voxel]), 1.0)
        looked += 1
        if looked == FIRST_LOOK and total < min_score * float(looked):
            count = looked
    scores[i] = total / float(max(looked, 1))


def score_shifts(
    points: Points, shifts: Vectors, blocks: VoxelBlocks, threshold: float, min_score: float, *, is_coarse: bool = False
) -> Scalars:
    """Score of each shift, 0..1, float32, all in voxels. Voxels with at most `threshold` frames count as absent. Shifts
    whose first points score below `min_score` stop early. With `is_coarse`, a point counts 1 in any block."""
    scores = empty(shifts.size, float32, points.device)
    launch(score_shifts_kernel, shifts.size, [points, shifts, blocks, threshold, min_score, int(is_coarse), scores])
    return scores
