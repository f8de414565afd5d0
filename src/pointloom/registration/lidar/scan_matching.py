"""Alignment of a downsampled scan with the map: robust ICP, the adaptive threshold, and localizability.

Equation numbers are those of Vizzo et al. 2023 (KISS-ICP). Localizability is tested per direction as in Tuna et al.,
"X-ICP: Localizability-Aware LiDAR Registration for Robust Localization in Extreme Environments", 2023. Suspected
directions are verified by matching the scan at shifted poses.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.quaternions import nearest_rotations
from ...kernels.linear_algebra import EPSILON, eigh, is_positive_definite, matmul, norm, pinvh
from ...kernels.odometry.map_aligner import Leg, MapAligner, Reached
from ...kernels.odometry.map_course import FROM_CHEAPEST, FROM_FIRST, FROM_GIVEN, LEG_CONVERGED, LEG_LOST, MAX_LEGS
from ...kernels.odometry.pose_probes import compare_poses, find_map_planes
from ...kernels.odometry.surface_patches import SurfacePatches
from ...kernels.odometry.voxel_map import VoxelMap
from ..assessment_constants import JUDGING_POINTS, MIN_DEVIATIONS, MIN_RISE, STEP_VOXELS, SUSPECT_FRACTION
from ..rigid import make_pose, nearest_rotation, pose_of, rotation_vector, rotations_of
from ..unobservable_motions import moved, rises_clearly, spanned
from .path_errors import MatchError, match_error, prediction_error

Matrix = NDArray[np.float64]
Rises = Callable[[Matrix], NDArray[np.bool_]]  # from changes of costs (k, 4) to flags: True if the cost is higher

THRESHOLD_SIGMAS = 3.0  # eq. 8: correspondences within three standard deviations
MIN_MOTIONS_FROM_START = 5.0  # times min_motion from the start, below which the initial threshold is used
MAX_ITERATIONS = 50  # three are usual. Oscillating pairs do not converge with more
FINE_TOLERANCE = 1e-4  # [rad, m] step that ends the iterations
ROUGH_TOLERANCE = 1e-2  # likewise if other iterations follow
LOST_FRACTION = 0.1  # minimum fraction of points with a correspondence
JUDGED_VOXELS = 2.0  # voxels: larger distances count as missing
PLANE_VOXELS = 1.0  # voxels: radius of plane neighborhoods
COARSE_KERNEL, FINE_KERNEL = 0.5, 0.1  # squared voxels: Geman-McClure scale of plane distances
START_RINGS = (0.375, 0.75, 1.5)  # times the initial threshold: radii of the guesses while no motion is known
START_DIRECTIONS = 8
MANY_STARTS = 8  # with more, most map points are near a scan point at some start
TRIAL_ITERATIONS = 2  # of many starts. The best ones are continued
NEAR_VOXELS = 0.5  # voxels: such poses after the trials are continued once
MAX_DISAGREEMENT = 0.99  # for a finite residual
RIVAL_VOXELS = 1.5  # voxels: closer poses are the same
# [deg] about x, y, z: within a voxel of each other at 7 voxels' distance; handheld scanners rotate this fast
WIDE_ANGLES = ((2, (8.0, 16.0, 24.0, 32.0, 40.0)), (1, (8.0, 16.0)), (0, (8.0, 16.0)))

HEADING_STEP = 8.0  # [deg] between headings


@dataclass(frozen=True, eq=False)
class ScanMatch:
    """Pose of a scan in a map (`information`: of the planes, [6, 6]; `open`: undetermined motions, or None; `rows`: of
    points on surface patches, [n, 7]; `has_planes`: False if only points were matched).
    """

    pose: Matrix
    is_matched: bool
    converged: bool
    iterations: int
    inliers: int
    fitness: float
    sqsum: float
    cost: float
    disagreement: float
    information: Matrix
    open: OpenDirections | None = None
    rivals: tuple[Matrix, ...] = ()
    rows: Matrix = field(default_factory=lambda: np.empty((0, 7)))
    has_planes: bool = True

    def ways_to_rivals(self) -> tuple[tuple[float, float, float], ...]:
        ways = [rival[:3, 3] - self.pose[:3, 3] for rival in self.rivals]
        return tuple((float(x), float(y), float(z)) for x, y, z in ways)

    def error(self, size: float, deviation: float, max_range: float) -> MatchError:
        """Error of the pose in a map of voxels with this edge [m]. `deviation` [m] is that of a prediction."""
        worst = min(self.disagreement, MAX_DISAGREEMENT)
        residual = size * math.sqrt(FINE_KERNEL * worst / (1 - worst))
        error = match_error(self.information, self.rows, residual, size)
        if self.open is None:
            return error
        if self.open.is_blind:
            return error.plus_lasting(prediction_error(deviation, max_range))
        rays = self.open.basis / self.open.scale[:, None]
        return error.plus_lasting(deviation**2 * matmul(rays, rays.T))


@dataclass(frozen=True, eq=False)
class DownsampledScan:
    """A scan about the sensor, downsampled for the map, for registration, and for trying many starts."""

    dense: wp.array
    sparse: wp.array
    few: Callable[[], wp.array]


def match_scan(
    aligner: MapAligner,
    scan: DownsampledScan,
    voxel_map: VoxelMap,
    guess: Matrix,
    sigma: float,
    further: Sequence[Matrix] = (),
) -> ScanMatch:
    """Align a scan with the map. The match is to be assessed by `assess_match`.

    Robust point-to-point ICP (eqs. 9 to 12) has a wide basin but favors no motion, since scan rings move with the
    sensor. Point-to-plane iterations follow from its result, the guess, and the `further` guesses. The least cost wins.
    `sigma` [m] is the standard deviation of the guess.
    """
    points, few = scan.sparse, scan.few() if further else None
    size, count = voxel_map.voxel_size, points.size
    limit, coarse = JUDGED_VOXELS * size, COARSE_KERNEL * size**2
    near_count, has_few = count if few is None else few.size, few is not None
    first = Leg(
        guess, THRESHOLD_SIGMAS * sigma, sigma / 3, ROUGH_TOLERANCE, LOST_FRACTION * count, MAX_ITERATIONS,
        is_needed=True,
    )  # fmt: skip
    rough = _leg(guess, near_count, limit, coarse, ROUGH_TOLERANCE, few=has_few)
    last = _fine_leg(guess, voxel_map, count, start=FROM_CHEAPEST)
    legs = [first, rough, replace(rough, start=FROM_FIRST)]
    has_many_starts = len(further) > MANY_STARTS
    trial = replace(rough, iterations=TRIAL_ITERATIONS) if has_many_starts else rough
    legs += [replace(trial, pose=start) for start in further]
    aligner.load(points, few, voxel_map, has_many_starts=has_many_starts)
    results, information = aligner.run(legs if has_many_starts else [*legs, last])  # sync
    near, is_lost = results[0], results[0].state == LEG_LOST
    iterations = sum(reached.iterations for reached in results)
    if has_many_starts and not is_lost:
        legs = [replace(rough, pose=pose) for pose in _best_poses(results[1:], size)]
        results, information = aligner.run([*legs, last])  # sync
        iterations += sum(reached.iterations for reached in results)
    is_lost = is_lost or results[-1].state == LEG_LOST
    match = _match_of(near if is_lost else results[-1], first if is_lost else last, count, information)
    return replace(match, iterations=iterations, has_planes=not is_lost) if match.is_matched else match


def _best_poses(results: Sequence[Reached], size: float) -> list[Matrix]:
    """The poses of least cost of some legs, a third of them, without those near better ones."""
    poses: list[Matrix] = []
    for reached in sorted(results, key=lambda reached: reached.cost):
        if reached.state != LEG_LOST and not any(_is_near(reached.pose, pose, size) for pose in poses):
            poses.append(reached.pose)
    return poses[: -(-len(results) // 3)]


def _is_near(A: Matrix, B: Matrix, size: float) -> bool:
    """True if ICP from both poses ends at the same one."""
    is_aligned = float((A[:3, :3] * B[:3, :3]).sum()) > 1 + 2 * math.cos(math.radians(HEADING_STEP / 2))
    return is_aligned and _distance(A, B) < NEAR_VOXELS * size


def refine_match(aligner: MapAligner, scan: DownsampledScan, voxel_map: VoxelMap, pose: Matrix) -> ScanMatch:
    """Align a scan with the planes of the map from a `pose` that is about right. It is to be assessed likewise."""
    aligner.load(scan.sparse, None, voxel_map)
    return _align(aligner, _fine_leg(pose, voxel_map, scan.sparse.size), scan.sparse.size)  # sync


def assess_match(
    aligner: MapAligner,
    scan: DownsampledScan,
    voxel_map: VoxelMap,
    match: ScanMatch,
    guess: Matrix,
    search_range: float = 0.0,
    *,
    is_blind_open: bool = True,
) -> ScanMatch:
    """The match of the scan that the aligner has just aligned, with its undetermined motions and rivals.

    `search_range` [m] limits the search along poorly determined directions. Motions that only the pattern of the scan
    determines are reported as open, and keep their estimate. Other open ones are those of the `guess`.
    `is_blind_open`: report all motions as open if there are no planes.
    """
    if not (match.is_matched and match.has_planes):
        return match
    last, count, iterations = match, scan.sparse.size, match.iterations
    rivals: tuple[Matrix, ...] = ()
    for way in weak_directions(last.information, count) if search_range > 0 else ():
        last, others = _search_along(aligner, scan, voxel_map, last, guess, way, search_range)
        iterations, rivals = iterations + last.iterations, rivals + others
    last = replace(last, iterations=iterations, rivals=rivals)
    free = open_directions(scan.dense, voxel_map, last.pose, last.information, count)
    if free is None:
        free, rows = directions_without_surfaces(scan.dense, voxel_map, last.pose)
        return replace(last, open=free, rows=rows)
    if free.is_blind:
        return replace(last, open=free if is_blind_open else None)
    start = free.taken_from(last.pose, guess)
    leg = replace(_fine_leg(start, voxel_map, count), is_regularized=True)
    constrained = _align(aligner, leg, count, free.weight())
    return replace(
        constrained if constrained.is_matched else replace(last, pose=start),
        iterations=iterations + constrained.iterations,
        open=free,
        rivals=(),
    )


def search_poses(
    aligner: MapAligner,
    scan: DownsampledScan,
    voxel_map: VoxelMap,
    first: ScanMatch,
    poses: Matrix,
    guess: Matrix | None,
    min_fitness: float,
) -> ScanMatch:
    """The best match from `first` and from further `poses` [n, 4, 4], with its rivals.

    Of about equal ones that is the nearest to a guess, or without one the match of least cost. Rivals have at least
    this fitness: areas that are new to the map lower it.
    """
    size, count, few = voxel_map.voxel_size, scan.sparse.size, scan.few()
    rough = _leg(first.pose, few.size, JUDGED_VOXELS * size, COARSE_KERNEL * size**2, ROUGH_TOLERANCE)
    aligner.load(scan.sparse, few, voxel_map)
    starts = [replace(rough, few=True, pose=T) for T in (first.pose, *poses)]
    batches = [starts[k : k + MAX_LEGS] for k in range(0, len(starts), MAX_LEGS)]
    tried = _distinct([match for legs in batches for match in _matches(aligner, legs, few.size)], size)  # syncs
    if not tried:
        return first
    leg = _fine_leg(first.pose, voxel_map, count)
    chances = [match.pose for match in tried[: 1 + MAX_RIVALS]]
    if guess is not None:
        chances.append(min(tried, key=lambda match: _distance(match.pose, guess)).pose)
    finals = _matches(aligner, [replace(leg, pose=T) for T in chances], count)  # sync
    finals = _distinct(finals, size)
    if not finals:
        return first
    limit = RIVAL_COST_RATIOS[guess is not None] * max(finals[0].disagreement, MIN_RIVAL_COST)
    alike = [match for match in finals if match.disagreement <= limit and match.fitness >= min_fitness] or finals[:1]
    chosen = alike[0] if guess is None else min(alike, key=lambda match: _distance(match.pose, guess))
    chosen = _align(aligner, replace(leg, pose=chosen.pose), count)  # sync, for its information
    free, rows = directions_without_surfaces(scan.dense, voxel_map, chosen.pose)
    rivals = tuple(match.pose for match in alike if _distance(match.pose, chosen.pose) > RIVAL_VOXELS * size)
    return replace(chosen, iterations=first.iterations + chosen.iterations, rivals=rivals, open=free, rows=rows)


def _matches(aligner: MapAligner, legs: Sequence[Leg], count: int) -> list[ScanMatch]:
    if not legs:
        return []
    reached, information = aligner.run(legs)  # sync
    matches = [_match_of(*pair, count, information) for pair in zip(reached, legs, strict=True)]
    return [match for match in matches if match.is_matched]


def _distinct(matches: Sequence[ScanMatch], size: float) -> list[ScanMatch]:
    """The matches by ascending cost, without those at about the same pose as a better one."""
    kept: list[ScanMatch] = []
    for match in sorted(matches, key=lambda match: match.cost):
        if all(_distance(match.pose, other.pose) > RIVAL_VOXELS * size for other in kept):
            kept.append(match)
    return kept


def _search_along(
    aligner: MapAligner,
    scan: DownsampledScan,
    voxel_map: VoxelMap,
    first: ScanMatch,
    guess: Matrix,
    way: Matrix,
    search_range: float,
) -> tuple[ScanMatch, tuple[Matrix, ...]]:
    """The best pose along a poorly determined direction (of equal ones, the nearest to the guess), and its rivals."""
    size, count = voxel_map.voxel_size, scan.sparse.size
    planes = aligner.map_planes or find_map_planes(voxel_map, PLANE_VOXELS * size)

    def rises_at(poses: Matrix) -> Matrix:
        return compare_poses(scan.dense, JUDGING_POINTS, voxel_map, poses, size, planes)

    starts, worst = poses_along(rises_at, size, first.pose, guess, way, search_range)
    leg = _leg(guess, count, JUDGED_VOXELS * size, FINE_KERNEL * size**2, ROUGH_TOLERANCE)
    legs = [replace(leg, pose=T) for T in starts]
    tried = (
        [_match_of(*pair, count, first.information) for pair in zip(aligner.run(legs)[0], legs, strict=True)]
        if legs
        else []
    )
    candidates = [first, *(match for match in tried if match.is_matched)]
    rises = rises_at(np.array([match.pose for match in candidates]))
    best = candidates[int(np.argmin(rises[:, 0] / np.maximum(rises[:, 2], 1)))]
    rises = rises_at(np.array([best.pose, *(match.pose for match in candidates)]))
    alike = [match for match, is_worse in zip(candidates, rises_clearly(rises[1:]), strict=True) if not is_worse]
    chosen = min(alike, key=lambda match: _distance(match.pose, guess))
    if chosen is not first:
        chosen = _align(aligner, replace(leg, pose=chosen.pose, tolerance=FINE_TOLERANCE), count)
    others = [
        match.pose
        for match, (total, _, visible, _) in zip(candidates, rises[1:], strict=True)
        if total < RIVAL_RISE * worst * visible
        and visible > RIVAL_SEEN * rises[0, 2]
        and _distance(match.pose, chosen.pose) > RIVAL_VOXELS * size
    ]
    return chosen, tuple(others)


def _distance(A: Matrix, B: Matrix) -> float:
    return float(norm(A[:3, 3] - B[:3, 3]))


def _fine_leg(pose: Matrix, voxel_map: VoxelMap, count: int, start: int = FROM_GIVEN) -> Leg:
    size = voxel_map.voxel_size
    return _leg(pose, count, JUDGED_VOXELS * size, FINE_KERNEL * size**2, FINE_TOLERANCE, start=start)


def _leg(
    pose: Matrix,
    count: int,
    max_distance: float,
    scale: float,
    tolerance: float,
    *,
    few: bool = False,
    start: int = FROM_GIVEN,
) -> Leg:
    return Leg(
        pose, max_distance, scale, tolerance, LOST_FRACTION * count, MAX_ITERATIONS, to_planes=True, few=few,
        start=start,
    )  # fmt: skip


def _align(aligner: MapAligner, leg: Leg, count: int, constraint: Matrix | None = None) -> ScanMatch:
    (reached,), information = aligner.run([leg], constraint)
    return _match_of(reached, leg, count, information)


def _match_of(reached: Reached, leg: Leg, count: int, information: Matrix) -> ScanMatch:
    T, is_matched = reached.pose, reached.state != LEG_LOST
    return ScanMatch(
        pose=make_pose(nearest_rotation(T[:3, :3]), T[:3, 3]) if is_matched else leg.pose, is_matched=is_matched,
        converged=reached.state == LEG_CONVERGED, iterations=reached.iterations, inliers=reached.paired,
        fitness=reached.paired / count, sqsum=reached.sqsum, cost=reached.cost, disagreement=reached.disagreement,
        information=information,
    )  # fmt: skip


def start_guesses(pose: Matrix, threshold: float) -> list[Matrix]:
    """A pose and poses around it in the sensor plane, for an unknown first motion."""
    guesses = [pose]
    for ring in START_RINGS:
        for k in range(START_DIRECTIONS):
            angle = 2 * math.pi * k / START_DIRECTIONS
            step = np.array([math.cos(angle), math.sin(angle), 0.0]) * ring * threshold
            guesses.append(matmul(pose, make_pose(np.eye(3), step)))
    return guesses


def rotated_guesses(predicted: Matrix, last: Matrix) -> list[Matrix]:
    guesses = []
    for pose in (predicted, last):
        guesses.append(pose)
        for axis, angles in WIDE_ANGLES:
            for angle in angles:
                for sign in (-1.0, 1.0):
                    twist = np.zeros(6)
                    twist[axis] = sign * math.radians(angle)
                    guesses.append(matmul(pose, pose_of(twist)))
    return guesses


def headings(pose: Matrix) -> list[Matrix]:
    """A pose rotated about the sensor's z axis by all multiples of `HEADING_STEP`."""
    angles = np.arange(0.0, 360.0, HEADING_STEP)
    return [matmul(pose, pose_of(np.array([0, 0, math.radians(angle), 0, 0, 0]))) for angle in angles]


@dataclass(frozen=True)
class AdaptiveThreshold:
    """Standard deviation [m] of the constant-velocity prediction (eqs. 5 to 8), from the squared errors `sqsum`."""

    initial: float
    min_motion: float
    max_range: float
    sqsum: float
    count: int = 1

    def value(self, poses: Matrix) -> float:
        """The threshold for the next scan. The initial one until the sensor has moved."""
        if not len(poses) or norm(poses[-1, :3, 3] - poses[0, :3, 3]) <= MIN_MOTIONS_FROM_START * self.min_motion:
            return self.initial
        return math.sqrt(self.sqsum / self.count)

    def error_of(self, deviation: Matrix) -> float:
        """Displacement [m] of a point at maximum range due to a pose deviation (eqs. 6, 7)."""
        angle = float(norm(rotation_vector(deviation[:3, :3])))
        return 2 * self.max_range * math.sin(angle / 2) + float(norm(deviation[:3, 3]))

    def updated(self, deviation: Matrix) -> AdaptiveThreshold:
        """The threshold after one more deviation (eq. 8). The smallest motions are ignored."""
        error = self.error_of(deviation)
        if error <= self.min_motion:
            return self
        return replace(self, sqsum=self.sqsum + error**2, count=self.count + 1)


SEARCHED_FRACTION = 0.1  # below which rivals are searched after the start, where planes are rough
MIN_PLANES = 0.05  # fraction of points with planes, below which only lines and single points determine the pose
COARSE_FACTOR = 3.0  # of the voxel edge
MIN_PATCHES = 6.0  # fewer surface patches determine no motion
# Points of a quick check, and the information at which it suffices: errors of so few are up to 20%. With fewer patches
# no costs, which are at most 1, rise by three standard errors.
FEW_POINTS, SURE_FRACTION, MIN_SURE_PATCHES = 256, 1.2 * SUSPECT_FRACTION, 10.0
MAX_SAMPLES = 64  # along a line
MAX_RIVALS = 4  # examined in detail
# Fraction of the worst cost between them by which a rival may be worse: behind passed equal doors, the true pose had
# 0.1 to 0.2, since moving scan rings fit better without motion.
RIVAL_RISE = 0.25
# Ratios of plane costs up to which poses after an unknown and a known gap are equally good. In streets of equal houses
# it is up to 1.8. Elsewhere wrong poses had 1.6 to 3.5, or too little fitness (24 to 64 beams, synthetic streets and a
# real one, 2026-11-29). A known gap proposes the pose, so that others need not be as likely to be reported.
RIVAL_COST_RATIOS, MIN_RIVAL_COST = (1.5, 2.0), 0.02
RIVAL_SEEN = 0.75  # minimum ratio of points with a plane, compared with the best pose: floors may be out of range
MIN_SEEN = 0.5  # minimum ratio to the maximum over all poses: few points match well at the map border
ROUNDING_MARGIN = 1e-6  # relative margin for rounding: undecided matrices are decided by their eigenvalues
FIXED_WEIGHT = 1.0e6  # weight of a fixed motion, relative to all pairs


@dataclass(frozen=True, eq=False)
class OpenDirections:
    """Undetermined motions in map axes: columns [6, k] over (rotation times `lever` [m], translation)."""

    lever: float
    basis: Matrix
    is_blind: bool = False

    @property
    def scale(self) -> Matrix:
        return np.array([self.lever] * 3 + [1.0] * 3)

    def weight(self) -> Matrix:
        """Addition to the normal equations, in units of their trace, that fixes these motions, [6, 6]."""
        rows = self.scale[:, None] * self.basis
        return FIXED_WEIGHT * matmul(rows, rows.T)

    def taken_from(self, pose: Matrix, fixed_pose: Matrix) -> Matrix:
        """Replace the components of a pose along these directions by those of another."""
        rotation = rotation_vector(matmul(fixed_pose[:3, :3], pose[:3, :3].T))
        way = np.concatenate([rotation, fixed_pose[:3, 3] - pose[:3, 3]]) * self.scale
        return moved(pose, matmul(self.basis, matmul(self.basis.T, way)) / self.scale)

    def translations(self) -> tuple[tuple[float, float, float], ...]:
        return spanned(self.basis[3:])

    def rotations(self) -> tuple[tuple[float, float, float], ...]:
        return spanned(self.basis[:3])


def open_directions(
    points: wp.array, voxel_map: VoxelMap, pose: Matrix, information: Matrix, count: int
) -> OpenDirections | None:
    """The motions that `count` points with `information` of planes [6, 6] do not determine, or None."""
    if _count(information) < MIN_PLANES * count:
        return OpenDirections(1.0, np.eye(6), is_blind=True)
    size = voxel_map.voxel_size

    def undetermined(max_points: int, rises: Rises) -> OpenDirections | None:
        def rises_at(poses: Matrix) -> Matrix:
            return compare_poses(points, max_points, voxel_map, poses, size)

        return _undetermined(size, pose, information, rises_at, rises)

    if undetermined(FEW_POINTS, rises_surely) is None:
        return None
    return undetermined(JUDGING_POINTS, rises_clearly)


def directions_without_surfaces(
    points: wp.array, voxel_map: VoxelMap, pose: Matrix
) -> tuple[OpenDirections | None, Matrix]:
    """The motions that the surfaces of the map do not determine, even if the pattern of the scan does, or None.

    Also the rows [n, 7] of a few points on surfaces, as of `SurfacePatches`. Surfaces between distant rings are found
    in a coarser map only.
    """
    size, free = voxel_map.voxel_size, None
    few = SurfacePatches(points, FEW_POINTS, voxel_map, pose, size)
    if _count(information := few.information) >= MIN_SURE_PATCHES and (
        _undetermined(size, pose, information, few.cost_changes, rises_surely, limit=SURE_FRACTION) is None
    ):
        return None, few.rows
    has_patches = False
    for factor in (1.0, COARSE_FACTOR):
        like = voxel_map if factor == 1.0 else voxel_map.coarser(factor, pose[:3, 3])
        patches = SurfacePatches(points, JUDGING_POINTS, like, pose, like.voxel_size)
        if _count(information := patches.information) >= MIN_PATCHES:
            has_patches, rises_at = True, patches.cost_changes
            free = _undetermined(like.voxel_size, pose, information, rises_at, rises_clearly, among=free)
            if free is None:
                return None, few.rows
    return free if has_patches else OpenDirections(1.0, np.eye(6), is_blind=True), few.rows


def _count(information: Matrix) -> float:
    """Number of planes."""
    return float(information[3, 3] + information[4, 4] + information[5, 5])


def rises_surely(rises: Matrix) -> NDArray[np.bool_]:
    """As `rises_clearly`, for few points: by the error of their mean, more points rise clearly too."""
    total, square, pairs, _ = rises.T
    return total - MIN_DEVIATIONS * np.sqrt(np.maximum(square, 1)) >= MIN_RISE * np.maximum(pairs, 1)


def _undetermined(
    size: float,
    pose: Matrix,
    information: Matrix,
    rises_at: Callable[[Matrix], Matrix],
    rises: Rises,
    *,
    limit: float = SUSPECT_FRACTION,
    among: OpenDirections | None = None,
) -> OpenDirections | None:
    """Motions with information below a limit along which the cost does not rise, by `rises` (as `rises_clearly`).

    `rises_at` is as `compare_poses`. Motions are `among` given ones, if any. `size` [m] is the voxel edge.
    """
    normal_matrix, lever, scale = _scaled(information, size, None if among is None else among.lever)
    if _exceeds(normal_matrix, limit):
        return None
    if among is None:
        values, vectors = eigh(normal_matrix)
    else:
        values, vectors = eigh(matmul(among.basis.T, matmul(normal_matrix, among.basis)))
        vectors = matmul(among.basis, vectors)
    suspects = vectors[:, values < limit]
    if not suspects.shape[1]:
        return None
    steps = [sign * STEP_VOXELS * size * v / scale for v in suspects.T for sign in (-1, 1)]
    changes = rises_at(np.concatenate([pose[None], _moved_each(pose, np.array(steps))]))
    is_open = ~rises(changes[1:]).reshape(-1, 2).all(axis=1)
    return OpenDirections(lever, suspects[:, is_open]) if is_open.any() else None


def _moved_each(pose: Matrix, motions: Matrix) -> Matrix:
    """As `moved` for each of some motions [k, 6], poses [k, 4, 4]."""
    poses = np.tile(pose, (len(motions), 1, 1))
    poses[:, :3, :3] = nearest_rotations(matmul(rotations_of(motions[:, :3]), pose[:3, :3]))
    poses[:, :3, 3] += motions[:, 3:]
    return poses


def _scaled(information: Matrix, size: float, lever: float | None = None) -> tuple[Matrix, float, Matrix]:
    """Information of one plane with rotations times the lever, the lever [m], and the scale of each motion."""
    planes = _count(information)
    turning = float(information[0, 0] + information[1, 1] + information[2, 2])
    lever = max(math.sqrt(turning / planes), size) if lever is None else lever
    scale = np.array([lever] * 3 + [1.0] * 3)
    return information / (scale[:, None] * scale) / planes, lever, scale


def _exceeds(A: Matrix, limit: float) -> bool:
    """True if all eigenvalues surely exceed a limit: a quick check before `eigh`."""
    return is_positive_definite(A - (1 + ROUNDING_MARGIN) * limit * np.eye(len(A)))


def weak_directions(information: Matrix, count: int) -> Matrix:
    """Translation directions [k, 3] that the planes determine poorly, with rotations eliminated."""
    planes = _count(information)
    if planes < MIN_PLANES * count:
        return np.empty((0, 3))
    alone = information[3:, 3:] - matmul(
        information[3:, :3], pinvh(information[:3, :3], 3 * EPSILON), information[:3, 3:]
    )
    values, vectors = eigh(alone / planes)
    return vectors.T[values < SEARCHED_FRACTION]


def poses_along(
    rises_at: Callable[[Matrix], Matrix], size: float, pose: Matrix, guess: Matrix, way: Matrix, search_range: float
) -> tuple[list[Matrix], float]:
    """Locally best poses within `search_range` [m] of the guess along `way`, and the largest mean cost between them.

    `rises_at` is as `compare_poses`, in a map of voxels of `size` [m].
    """
    step = max(STEP_VOXELS * size, 2 * search_range / MAX_SAMPLES)
    middle = float(matmul(way, guess[:3, 3] - pose[:3, 3]))
    shifts = np.arange(math.floor((middle - search_range) / step), math.ceil((middle + search_range) / step) + 1) * step
    motions = np.zeros((len(shifts), 6))
    motions[:, 3:] = shifts[:, None] * way
    poses = np.concatenate([pose[None], _moved_each(pose, motions)])
    total, _, pairs, _ = rises_at(poses)[1:].T
    costs = np.where(pairs >= MIN_SEEN * pairs.max(), total / np.maximum(pairs, 1), np.inf)
    beside = np.concatenate([[np.inf], costs, [np.inf]])
    is_minimum = (costs <= beside[:-2]) & (costs <= beside[2:]) & np.isfinite(costs) & (np.abs(shifts) > step)
    best = [i for i in np.argsort(costs, kind="stable") if is_minimum[i]]
    return [poses[1 + i] for i in best[:MAX_RIVALS]], float(max(costs[np.isfinite(costs)], default=0.0))
