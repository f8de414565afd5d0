"""How firmly matching surfaces constrain a pose, and how the cost changes at other poses.

Point-to-plane rows (Chen and Medioni 1991) about the center of the pairs. Noise of the normals constrains even free
motions, so neighboring poses are compared with correspondences searched anew.
"""

from dataclasses import dataclass

import numpy as np

from ..algebra.rigid_solve import move, rotate
from ..algebra.transform import narrow, widen
from ..arrays.packed_keys import key_index
from ..arrays.side_by_side import read_together
from ..lang import array, dot, float32, int64, kernel, launch, mat44d, tid, vec3
from ..memory import empty, rows_of, upload
from ..search.nearest_point import NO_POINT, find_nearest
from ..search.tree_search import order_along_curve
from ..surface.hollow_side import Surface
from .cost_differences import compare_costs
from .overlap_evidence import MATCHED_AT, Overlaps, repeat_order


@dataclass(frozen=True)
class PoseConstraint:
    """Constraint of a pose: `triangle` (21) of the normal matrix (rotation first, in units of the RMS distance
    `lever`). Weighted `matches`; `middle` about the target's origin [m].
    """

    triangle: np.ndarray
    matches: float
    middle: np.ndarray
    lever: float


def find_pose_constraint(
    source: Surface, target: Surface, pose: np.ndarray, distance: float, near: float, cosine: float
) -> PoseConstraint:
    """Constraint of T_target_source about the clouds' origins; `near`: overlap distance [m]. One sync."""
    overlaps = Overlaps([(source, target, pose)], distance, near, cosine, distance)
    (sums,), (middle,), (scale,) = read_together([overlaps.weigh(), overlaps.middle, overlaps.scale])  # sync
    return PoseConstraint(sums[21:42].copy(), float(sums[MATCHED_AT]), middle.copy(), 1 / float(scale))


@kernel
def transform_samples_kernel(
    points: array(dtype=vec3), step: int, count: int, poses: array(dtype=mat44d), moved: array(dtype=vec3)
):
    i = tid()
    moved[i] = narrow(move(poses[i // count], widen(points[(i % count) * step])))


@kernel
def measure_offsets_kernel(
    moved: array(dtype=vec3),
    nearest: array(dtype=int64),
    directions: array(dtype=vec3),
    step: int,
    poses: array(dtype=mat44d),
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    cosine: float,
    squares: array(dtype=float32, ndim=2),
):
    """Squared distance to the nearest point along its normal, or -1 if the normals disagree."""
    i = tid()
    count = squares.shape[1]
    square = -1.0
    if nearest[i] != int64(NO_POINT):
        row = key_index(nearest[i])
        rotated = narrow(rotate(poses[i // count], widen(directions[(i % count) * step])))
        if abs(dot(rotated, normals[row])) > cosine:
            height = dot(moved[i] - points[row], normals[row])
            square = height * height
    squares[i // count, i % count] = square


def compare_pair(
    source: Surface,
    target: Surface,
    max_points: int,
    poses: np.ndarray,
    radius: float,
    cosine: float,
    voxel_size: float,
) -> np.ndarray:
    """Cost changes when one surface moves from its pose (the first) to others, (k, 4) as of `compare_costs`. One sync.
    The surfaces must not be thinned on a common grid, which would bias the result.
    """
    device = source.device
    step = max(1, len(source) // max(max_points, 1))
    count = -(-len(source) // step)
    device_poses = upload(np.ascontiguousarray(poses, np.float64), mat44d, device)
    moved, squares = empty(len(poses) * count, vec3, device), empty((len(poses), count), float32, device)
    launch(transform_samples_kernel, moved.size, [source.points, step, count, device_poses, moved])
    order = source.tree.order if step == 1 else order_along_curve(target.tree, rows_of(moved, 0, count))
    nearest = find_nearest(target.tree, moved, radius=radius, order=repeat_order(order, count, len(poses)))
    compared = [source.normals, step, device_poses, target.points, target.normals, cosine, squares]
    launch(measure_offsets_kernel, moved.size, [moved, nearest, *compared])
    return compare_costs(squares, voxel_size)
