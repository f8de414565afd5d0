"""A thinned scan against the map: robust ICP from one or several guesses, and the threshold that it works with.

Equation numbers are those of Vizzo et al. 2023 (see odometry.py).

What a scan does not fix: motions under which it lies on the map as well as where it was found.

Directions are asked one by one, as Tuna et al. 2023 do ("X-ICP: Localizability-Aware LiDAR Registration for Robust
Localization in Extreme Environments"). Those of which the planes' normals tell little are only suspects: whether the
scan really lies as well a little farther along, its points say when they are paired anew there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.linear_algebra import EPSILON, eigh, matmul, norm, pinvh
from ...kernels.odometry.map_aligner import Leg, MapAligner, Reached
from ...kernels.odometry.map_course import CHEAPEST, CONVERGED, LOST, OF_FIRST
from ...kernels.odometry.pose_probes import compare_poses
from ...kernels.odometry.voxel_map import VoxelMap
from ..open_motions import JUDGING_POINTS, STEP_VOXELS, SUSPECT_SHARE, moved, rises_clearly, spanned
from ..rigid import make_pose, nearest_rotation, pose_of, rotation_vector

Matrix = NDArray[np.float64]

SIGMAS = 3.0  # eq. 8: correspondences within three standard deviations
MOVED = 5.0  # times min_motion from the start, before which the initial threshold holds
MAX_TURNS = 50  # of a loop; three are usual, and where pairs change for ever no more of them help
TOLERANCE = 1e-4  # [rad, m] of a turn that ends it
ROUGH = 1e-2  # the same where another loop follows
LOST_SHARE = 0.1  # of a scan's points with a correspondence, below which a pose is rejected
JUDGED_VOXELS = 2.0  # edges of a voxel beyond which a distance says no more than that there is nothing
PLANE_VOXELS = 1.0  # edges of a voxel: reach of the points of a plane
COARSE_KERNEL, FINE_KERNEL = 0.5, 0.1  # squared edges: Geman-McClure's scale of distances from planes
START_RINGS = (0.375, 0.75, 1.5)  # times the initial threshold: distances of the guesses while no motion is known
START_DIRECTIONS = 8
RIVAL_VOXELS = 1.5  # edges of a voxel: what lies nearer than this is the same place
# [deg] about x, y, z: within a voxel of each other at 7 voxels' distance; a scanner in the hand is turned so fast
WIDE_TURNS = ((2, (8.0, 16.0, 24.0, 32.0, 40.0)), (1, (8.0, 16.0)), (0, (8.0, 16.0)))


@dataclass(frozen=True, eq=False)
class ScanMatch:
    """Where a scan lies in a map.

    Attributes:
        pose: T_map_sensor, float64 [4, 4]; the guess where the scan does not overlap the map.
        is_found: Whether it does.
        converged: Whether the loop came to rest.
        turns: Turns of the loop.
        inliers: Points with a correspondence.
        fitness: Their share, 0..1.
        sqsum: Sum of their squared distances [m^2].
        cost: Mean of Geman-McClure's cost, 0..1.
        disagreement: Mean of the same cost over points that have a plane.
        told: What planes tell, [6, 6].
        rivals: Other poses where the scan lies as well.
        open: What the scan does not fix: there the pose is the guess'; None where it fixes all.
    """

    pose: Matrix
    is_found: bool
    converged: bool
    turns: int
    inliers: int
    fitness: float
    sqsum: float
    cost: float
    disagreement: float
    told: Matrix
    open: OpenDirections | None = None
    rivals: tuple[Matrix, ...] = ()

    def ways_to_rivals(self) -> tuple[tuple[float, float, float], ...]:
        """The vectors [m] from the pose to the others."""
        ways = [rival[:3, 3] - self.pose[:3, 3] for rival in self.rivals]
        return tuple((float(x), float(y), float(z)) for x, y, z in ways)


def match_scan(
    aligner: MapAligner,
    points: wp.array,
    voxel_map: VoxelMap,
    guess: Matrix,
    sigma: float,
    further: Sequence[Matrix] = (),
    few: wp.array | None = None,
    dense: wp.array | None = None,
    reach: float = 0.0,
) -> ScanMatch:
    """The pose of a scan.

    Robust ICP between points (eqs. 9 to 12) finds it from far. Its weights let pairs count that are no pairs, though:
    the rings that a turning scanner draws on the ground and on walls along its way move with it, so that it favours
    standing still. Along a plane a ring may lie anywhere: therefore loops to the planes of the map follow, from the
    guess, from what was found, and from further guesses, and the scan lies where their cost is least.

    Args:
        aligner: What brings it there: all these loops are one course.
        points: Device array of vec3, finite, at least one.
        voxel_map: The map, not empty.
        guess: T_map_sensor to begin with.
        sigma: Standard deviation [m] of the guess' error.
        further: Other poses to begin with, where nothing is known of the motion.
        few: Fewer points of the scan, to choose among many poses with; None takes all.
        dense: More points of the scan, to tell with what it fixes; None takes `points`.
        reach: How far [m] from the guess other places are looked for along what the scan tells little of.
    """
    size, count = voxel_map.voxel_size, points.size
    limit, coarse, fine = JUDGED_VOXELS * size, COARSE_KERNEL * size**2, FINE_KERNEL * size**2
    near = _leg(guess, count if few is None else few.size, limit, coarse, ROUGH, few=few is not None)
    legs = [
        _leg(guess, count, SIGMAS * sigma, sigma / 3, ROUGH, to_planes=False, is_needed=True),
        near,
        replace(near, start=OF_FIRST),
        *(replace(near, pose=start) for start in further),
        _leg(guess, count, limit, fine, TOLERANCE, start=CHEAPEST),
    ]
    aligner.load(points, few, voxel_map)
    found, told = aligner.run(legs)  # sync
    far = _match_of(found[0], legs[0], count, np.zeros((6, 6)))
    if not far.is_found:
        return far
    last = _match_of(found[-1], legs[-1], count, told)
    turns = sum(reached.turns for reached in found)
    if not last.is_found:
        return replace(far, turns=turns)
    dense, rivals = points if dense is None else dense, ()
    for way in weak_ways(last.told, count) if reach > 0 else ():
        last, others = _search_along(aligner, points, voxel_map, dense, last, guess, way, reach)
        turns, rivals = turns + last.turns, rivals + others
    free = open_directions(dense, voxel_map, last.pose, last.told, count)
    if free is None or free.is_blind:
        return replace(last, turns=turns, open=None if further else free, rivals=rivals)
    start = free.taken_from(last.pose, guess)
    held = _align(aligner, _leg(start, count, limit, fine, TOLERANCE, is_held=True), count, free.weight())
    return replace(held if held.is_found else replace(last, pose=start), turns=turns + held.turns, open=free)


def _search_along(
    aligner: MapAligner,
    points: wp.array,
    voxel_map: VoxelMap,
    dense: wp.array,
    found: ScanMatch,
    guess: Matrix,
    way: Matrix,
    reach: float,
) -> tuple[ScanMatch, tuple[Matrix, ...]]:
    """Where a scan lies best along a direction of which it tells little, and other places where it lies as well.

    Like doors in a corridor fit at every period: of places that fit alike, the one next to the guess is taken.
    """
    size, count = voxel_map.voxel_size, points.size
    starts, worst = places_along(dense, voxel_map, found.pose, guess, way, reach)
    leg = _leg(guess, count, JUDGED_VOXELS * size, FINE_KERNEL * size**2, ROUGH)
    legs = [replace(leg, pose=T) for T in starts]
    tried = (
        [_match_of(*pair, count, found.told) for pair in zip(aligner.run(legs)[0], legs, strict=True)] if legs else []
    )
    places = [found, *(match for match in tried if match.is_found)]
    rises = compare_poses(dense, JUDGING_POINTS, voxel_map, np.array([match.pose for match in places]), size)
    best = places[int(np.argmin(rises[:, 0] / np.maximum(rises[:, 2], 1)))]
    rises = compare_poses(
        dense, JUDGING_POINTS, voxel_map, np.array([best.pose, *(match.pose for match in places)]), size
    )
    alike = [match for match, is_worse in zip(places, rises_clearly(rises[1:]), strict=True) if not is_worse]
    chosen = min(alike, key=lambda match: _distance(match.pose, guess))
    if chosen is not found:
        chosen = _align(aligner, replace(leg, pose=chosen.pose, tolerance=TOLERANCE), count)
    others = [
        match.pose
        for match, (total, _, seen, _) in zip(places, rises[1:], strict=True)
        if total < RIVAL_RISE * worst * seen
        and seen > RIVAL_SEEN * rises[0, 2]
        and _distance(match.pose, chosen.pose) > RIVAL_VOXELS * size
    ]
    return chosen, tuple(others)


def _distance(A: Matrix, B: Matrix) -> float:
    return float(norm(A[:3, 3] - B[:3, 3]))


def _leg(
    pose: Matrix,
    count: int,
    max_distance: float,
    scale: float,
    tolerance: float,
    *,
    to_planes: bool = True,
    **more: Any,
) -> Leg:
    return Leg(pose, max_distance, scale, tolerance, LOST_SHARE * count, MAX_TURNS, to_planes, **more)


def _align(aligner: MapAligner, leg: Leg, count: int, held: Matrix | None = None) -> ScanMatch:
    """Where a guess leads to."""
    (reached,), told = aligner.run([leg], held)
    return _match_of(reached, leg, count, told)


def _match_of(reached: Reached, leg: Leg, count: int, told: Matrix) -> ScanMatch:
    T, is_found = reached.pose, reached.state != LOST
    return ScanMatch(
        make_pose(nearest_rotation(T[:3, :3]), T[:3, 3]) if is_found else leg.pose, is_found,
        reached.state == CONVERGED, reached.turns, reached.paired, reached.paired / count, reached.sqsum, reached.cost,
        reached.disagreement, told,
    )  # fmt: skip


def start_guesses(pose: Matrix, threshold: float) -> list[Matrix]:
    """A pose, and poses around it in the sensor's plane: where the first motion may have led."""
    guesses = [pose]
    for ring in START_RINGS:
        for k in range(START_DIRECTIONS):
            angle = 2 * math.pi * k / START_DIRECTIONS
            step = np.array([math.cos(angle), math.sin(angle), 0.0]) * ring * threshold
            guesses.append(matmul(pose, make_pose(np.eye(3), step)))
    return guesses


def wide_guesses(predicted: Matrix, last: Matrix) -> list[Matrix]:
    """Two poses, and both turned about the sensor's own axes: where else to look for a scan."""
    guesses = []
    for pose in (predicted, last):
        guesses.append(pose)
        for axis, angles in WIDE_TURNS:
            for angle in angles:
                for sign in (-1.0, 1.0):
                    twist = np.zeros(6)
                    twist[axis] = sign * math.radians(angle)
                    guesses.append(matmul(pose, pose_of(twist)))
    return guesses


@dataclass(frozen=True)
class AdaptiveThreshold:
    """How far the constant-velocity prediction has been off, as a standard deviation [m] (eqs. 5 to 8).

    Attributes:
        initial: The standard deviation [m] before any motion was seen.
        min_motion: Errors below this [m] do not count.
        max_range: Of the sensor [m].
        sqsum: Sum of the squared errors so far [m^2], the first of them `initial`.
        count: Their number.
    """

    initial: float
    min_motion: float
    max_range: float
    sqsum: float
    count: int = 1

    def value(self, poses: Matrix) -> float:
        """The threshold for the next scan; the initial one as long as the sensor has not left its place."""
        if not len(poses) or norm(poses[-1, :3, 3] - poses[0, :3, 3]) <= MOVED * self.min_motion:
            return self.initial
        return math.sqrt(self.sqsum / self.count)

    def error_of(self, deviation: Matrix) -> float:
        """How far [m] a point at full range moves with the pose found in the frame of the predicted (eqs. 6, 7)."""
        angle = float(norm(rotation_vector(deviation[:3, :3])))
        return 2 * self.max_range * math.sin(angle / 2) + float(norm(deviation[:3, 3]))

    def updated(self, deviation: Matrix) -> AdaptiveThreshold:
        """The threshold that knows how far a pose found lies from the predicted one (eq. 8); the smallest motions say
        nothing."""
        error = self.error_of(deviation)
        if error <= self.min_motion:
            return self
        return replace(self, sqsum=self.sqsum + error**2, count=self.count + 1)


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
