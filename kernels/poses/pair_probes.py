"""What the surfaces of two clouds tell of the six motions at a pose, and how much worse one lies at other poses.

The rows of point-to-plane ICP (Chen and Medioni 1991) about the middle of the pairs, turns in units of their spread,
say how firmly each motion is held; noise of the normals holds what nothing holds, so poses beside are compared with
the pairs found anew. One search for the nearest a point and pose.
"""

from dataclasses import dataclass

import numpy as np

from ..algebra.rigid_solve import move, turn
from ..algebra.transform import narrow, widen
from ..arrays.packed_keys import key_index
from ..lang import array, dot, float32, int64, kernel, launch, mat44d, tid, vec3
from ..memory import download, empty, upload
from ..search.nearest_point import NO_POINT, find_nearest
from ..surface.hollow_side import Surface
from .cost_differences import compare_costs
from .overlap_evidence import MATCHED_AT, Overlap


@dataclass(frozen=True)
class Hold:
    """How firmly a pose is held by what matches there.

    Attributes:
        triangle: Upper triangle of the matches' normal matrix, float64 [21], rotation first.
        matches: How many they are, those off the surface counting less.
        middle: Of the points near the other surface, float64 [3], about the target's origin [m].
        lever: Their root mean square distance from there [m]: the unit of turns.
    """

    triangle: np.ndarray
    matches: float
    middle: np.ndarray
    lever: float


def find_hold(source: Surface, target: Surface, pose: np.ndarray, distance: float, near: float, cosine: float) -> Hold:
    """The hold of a pose, float64 [4, 4] between coordinates about the clouds' origins.

    Args:
        source, target: The surfaces.
        pose: T_target_source.
        distance: Of agreeing points [m].
        near: Distance [m] within which a point should have met the other surface.
        cosine: Least of the angle between agreeing normals.

    Returns:
        The hold. Three syncs.
    """
    overlap = Overlap(source, target, pose, distance, near, cosine, distance)
    sums = download(overlap.weigh())[0]  # sync
    middle, scale = download(overlap.middle)[0], float(download(overlap.scale)[0])  # sync
    return Hold(sums[21:42].copy(), float(sums[MATCHED_AT]), middle.copy(), 1 / scale)


@kernel
def place_samples_kernel(
    points: array(dtype=vec3), step: int, count: int, poses: array(dtype=mat44d), moved: array(dtype=vec3)
):
    """Each n-th point at one of the poses."""
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
    """The squared distance of a point from its nearest one along the normal there; -1 where their normals disagree."""
    i = tid()
    count = squares.shape[1]
    square = -1.0
    if nearest[i] != int64(NO_POINT):
        row = key_index(nearest[i])
        turned = narrow(turn(poses[i // count], widen(directions[(i % count) * step])))
        if abs(dot(turned, normals[row])) > cosine:
            height = dot(moved[i] - points[row], normals[row])
            square = height * height
    squares[i // count, i % count] = square


def compare_pair(
    source: Surface, target: Surface, most: int, poses: np.ndarray, reach: float, cosine: float, voxel_size: float
) -> np.ndarray:
    """What changes where one surface moves from its pose to others.

    Args:
        source, target: The surfaces, not thinned by voxels of one size: they would lie best where the grids do.
        most: About so many of the source's points are taken, each n-th.
        poses: float64 [k, 4, 4], T_target_source about the clouds' origins; the first is the source's own.
        reach: Points this far [m] from the nearest one have no plane,
        cosine: nor have those whose normals enclose more than this, as at the edge of another surface.
        voxel_size: As of `compare_costs` [m].

    Returns:
        float64 [k, 4], a row a pose, as `compare_costs` gives them. One sync.
    """
    device = source.device
    step = max(1, len(source) // max(most, 1))
    count = -(-len(source) // step)
    placed = upload(np.ascontiguousarray(poses, np.float64), mat44d, device)
    moved, squares = empty(len(poses) * count, vec3, device), empty((len(poses), count), float32, device)
    launch(place_samples_kernel, moved.size, [source.points, step, count, placed, moved])
    nearest = find_nearest(target.tree, moved, radius=reach)
    compared = [source.normals, step, placed, target.points, target.normals, cosine, squares]
    launch(measure_offsets_kernel, moved.size, [moved, nearest, *compared])
    return compare_costs(squares, voxel_size)
