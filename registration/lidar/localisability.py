"""What a scan does not fix: motions under which it lies on the map as well as where it was found.

Directions are asked one by one, as Tuna et al. 2023 do ("X-ICP: Localizability-Aware LiDAR Registration for Robust
Localization in Extreme Environments"). Those of which the planes' normals tell little are only suspects: whether the
scan really lies as well a little farther along, its points say when they are paired anew there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.linear_algebra import EPSILON, eigh, matmul, pinvh
from ...kernels.odometry.pose_probes import compare_poses
from ...kernels.odometry.voxel_map import VoxelMap
from ..open_motions import JUDGING_POINTS, STEP_VOXELS, SUSPECT_SHARE, moved, rises_clearly, spanned
from ..rigid import rotation_vector

Matrix = NDArray[np.float64]

SEARCHED_SHARE = 0.1  # the same, below which other places are looked for after the start: planes are rough by then
LEAST_PLANES = 0.05  # of the points, below which nothing but lines and single points holds the pose
MOST_PLACES = 64  # along a line
MOST_RIVALS = 4  # of them that are looked at more closely
# Of the worst between them, that a place may lie worse than the best and still be a rival: of equal doors that had been
# driven past, the true one had 0.1 to 0.2, since rings that move along fit better where the scanner seems to stand.
RIVAL_RISE = 0.25
RIVAL_SEEN = 0.75  # of the points with a plane at the best place that have one there: elsewhere floors are out of reach
LEAST_SEEN = 0.5  # of the most points with a plane at any of them: at the map's rim a scan lies well on little
HELD_WEIGHT = 1.0e6  # of a motion that is held, in units of all pairs' weight


@dataclass(frozen=True, eq=False)
class OpenDirections:
    """Motions about and of a sensor that a scan does not fix, in the map's axes.

    Attributes:
        lever: Length [m] by which turns [rad] count beside translations.
        basis: Orthonormal columns [6, k] over (turn times lever, translation).
        is_blind: Whether all are open since the map has next to no planes there: lines that a turning scanner drew
            hold the pose then, wherever it is.
    """

    lever: float
    basis: Matrix
    is_blind: bool = False

    @property
    def scale(self) -> Matrix:
        """What takes (turn, translation) to the basis' units, [6]."""
        return np.array([self.lever] * 3 + [1.0] * 3)

    def weight(self) -> Matrix:
        """What to add to the normal equations, in units of their trace, so that these motions are left out, [6, 6]."""
        rows = self.scale[:, None] * self.basis
        return HELD_WEIGHT * matmul(rows, rows.T)

    def taken_from(self, pose: Matrix, held: Matrix) -> Matrix:
        """A pose whose part along these directions is that of another one."""
        turn = rotation_vector(matmul(held[:3, :3], pose[:3, :3].T))
        way = np.concatenate([turn, held[:3, 3] - pose[:3, 3]]) * self.scale
        return moved(pose, matmul(self.basis, matmul(self.basis.T, way)) / self.scale)

    def translations(self) -> tuple[tuple[float, float, float], ...]:
        """Unit directions along which the sensor may slide, its largest part first positive."""
        return spanned(self.basis[3:])

    def turns(self) -> tuple[tuple[float, float, float], ...]:
        """Unit axes about which it may turn, likewise."""
        return spanned(self.basis[:3])


def open_directions(
    points: wp.array, voxel_map: VoxelMap, pose: Matrix, told: Matrix, count: int
) -> OpenDirections | None:
    """The motions that a scan does not fix where it was found; None where it fixes all.

    Args:
        points: The scan, device array of vec3, finite.
        voxel_map: The map.
        pose: T_map_sensor.
        told: What planes tell, [6, 6], as `align_to_map` gives it.
        count: Of the points that it tells of.
    """
    planes, size = float(np.trace(told[3:, 3:])), voxel_map.voxel_size
    if planes < LEAST_PLANES * count:
        return OpenDirections(1.0, np.eye(6), is_blind=True)
    lever = max(math.sqrt(np.trace(told[:3, :3]) / planes), size)
    scale = np.array([lever] * 3 + [1.0] * 3)
    values, vectors = eigh(told / np.outer(scale, scale) / planes)
    suspects = vectors[:, values < SUSPECT_SHARE]
    if not suspects.shape[1]:
        return None
    steps = [sign * STEP_VOXELS * size * v / scale for v in suspects.T for sign in (-1, 1)]
    rises = compare_poses(points, JUDGING_POINTS, voxel_map, np.array([pose, *(moved(pose, s) for s in steps)]), size)
    is_open = ~rises_clearly(rises[1:]).reshape(-1, 2).all(axis=1)
    return OpenDirections(lever, suspects[:, is_open]) if is_open.any() else None


def weak_ways(told: Matrix, count: int) -> Matrix:
    """The directions [k, 3] of translations of which planes tell little, by the turns as they are found best."""
    planes = float(np.trace(told[3:, 3:]))
    if planes < LEAST_PLANES * count:
        return np.empty((0, 3))
    alone = told[3:, 3:] - matmul(told[3:, :3], pinvh(told[:3, :3], 3 * EPSILON), told[:3, 3:])
    values, vectors = eigh(alone / planes)
    return vectors.T[values < SEARCHED_SHARE]


def places_along(
    points: wp.array, voxel_map: VoxelMap, pose: Matrix, guess: Matrix, way: Matrix, reach: float
) -> tuple[list[Matrix], float]:
    """Poses along a line where a scan lies better than a little before and behind, the best few, without its own.

    With them comes how much worse it lies between them at worst, as the mean of the costs' differences.

    Args:
        points: The scan, device array of vec3, finite.
        voxel_map: The map.
        pose: T_map_sensor.
        guess: The line is as long as `reach` [m] to either side of it.
        way: The line's direction, [3].
        reach: Half its length [m].
    """
    step = max(STEP_VOXELS * voxel_map.voxel_size, 2 * reach / MOST_PLACES)
    middle = float(matmul(way, guess[:3, 3] - pose[:3, 3]))
    shifts = np.arange(math.floor((middle - reach) / step), math.ceil((middle + reach) / step) + 1) * step
    poses = np.array([pose, *(moved(pose, np.concatenate([np.zeros(3), s * way])) for s in shifts)])
    total, _, pairs, _ = compare_poses(points, JUDGING_POINTS, voxel_map, poses, voxel_map.voxel_size)[1:].T
    costs = np.where(pairs >= LEAST_SEEN * pairs.max(), total / np.maximum(pairs, 1), np.inf)
    beside = np.concatenate([[np.inf], costs, [np.inf]])
    is_least = (costs <= beside[:-2]) & (costs <= beside[2:]) & np.isfinite(costs) & (np.abs(shifts) > step)
    best = [i for i in np.argsort(costs, kind="stable") if is_least[i]]
    return [poses[1 + i] for i in best[:MOST_RIVALS]], float(max(costs[np.isfinite(costs)], default=0.0))
