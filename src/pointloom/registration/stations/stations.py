"""Registration of many terrestrial laser scans into one frame: overlapping pairs, their covariances, joint adjustment.

The error of a pair is that of `pose_errors`: the scatter of the gradients by blocks of space, and errors common to all
points. Pairs with points in the same block have correlated errors.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtri

from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_finite,
    check_fraction,
    check_list,
    check_positive,
    check_progress,
    check_rigid,
    check_seed,
    check_shape,
)
from ...core.devices import check_same_device
from ...core.progress import ReportProgress
from ...core.reports import failed
from ...io.points.e57_stations import Stations
from ...kernels.linear_algebra import elementwise, matmul, norm
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud, list_clouds
from ...pcd.units import common_reference
from ..assessment_constants import MIN_SCORE
from ..assessment_constants import SOURCE_VOXEL_FACTOR as SOURCE_FINER
from ..evidence import Witness, witnesses_of
from ..globally.global_registration import Description, describe, register_described
from ..globally.level_poses import LEVEL
from ..globally.rating import rate_poses
from ..icp.constraint import Constraint
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.evaluation import fitness_of
from ..icp.icp import ICPConvergenceCriteria, registration_icp_batch
from ..icp.multi_scale import MIN_OVERLAP, MIN_OVERLAP_RATIO
from ..pose_errors import PoseCovariance
from ..pose_graphs.connected_parts import connected_parts
from ..pose_graphs.spanning_tree import chain, spanning_tree
from ..result import RegistrationResult
from ..rigid import about_up, fit_pose, invert_pose, make_pose, nearest_rotation, rotation_vector, to_local
from ..robust_kernels import TukeyLoss
from ..surfaces import surface_of
from ..voxel_size import choose_voxel_size
from .adjustment import LEVEL_ROWS, Adjusted, Observed
from .loops import loops_of
from .observations import (
    Array,
    ControlPoint,
    StationPair,
    TargetObservation,
    check_control,
    check_scan_unit,
    check_sigma,
    check_targets,
)
from .pair_errors import PairErrors, pair_errors
from .result import StationsResult
from .snooping import snoop

MAX_CLOSURE_VOXELS = 4.0  # [voxels] maximum closure error over three stations
OUTSIDE_FRACTION = 0.01  # fraction of surveys with sigma0 outside its limits
MIN_SCALING_REDUNDANCY = 10  # minimum redundancy for scaling by sigma0
APPROXIMATE_POSE_ERROR = 2.0  # [m]
MAX_VOXELS = 1e6  # maximum per axis of a cloud


def register_stations(
    stations: Sequence[PointCloud] | Stations,
    *,
    poses: ArrayLike | None = None,
    positions: ArrayLike | None = None,
    position_sigma: float | None = None,
    rough: float = APPROXIMATE_POSE_ERROR,
    level: bool = True,
    level_sigma: float | None = None,
    targets: Sequence[TargetObservation] | None = None,
    control: Sequence[ControlPoint] | None = None,
    names: Sequence[str] | None = None,
    voxel_size: float | None = None,
    overlap: float = 0.15,
    reference: int = 0,
    seed: int = 0,
    progress: ReportProgress | None = None,
) -> StationsResult:
    """Register many terrestrial scans into one frame, with the uncertainty of each station.

    Overlapping pairs are registered by point-to-plane ICP. Then all poses are adjusted jointly from the pairs with
    their covariances, targets, control points, levels and positions. Outliers are removed and reported.

    Args:
        stations: The clouds, each in its scanner's coordinates, on one device; or the result of `loom.read_stations`,
            whose names are used, and whose poses unless they are all equal or one is missing.
        poses: Approximate poses T_survey_station, [n, 4, 4]; None: unknown orientations.
        positions: Approximate scanner positions [m], [n, 3]; NaN: unknown. Default: those of `poses`.
        position_sigma: Standard deviation of observed positions (GNSS) [m]; None: they select pairs and define the
            frame.
        rough: Maximum error of distances by approximate poses or positions [m].
        level: z is up in the scans, or in `poses`: four degrees of freedom, and exact tilts. Otherwise six.
        level_sigma: Standard deviation of the up direction [rad], used as an observation with six degrees of freedom.
        targets: Target observations of the stations.
        control: Survey coordinates of some targets, which define the frame.
        names: Station names for the report; None: numbers.
        voxel_size: Voxel edge for downsampling [m]; None: half of `choose_voxel_size`.
        overlap: Minimum overlap of a pair as a fraction of the smaller cloud.
        reference: The station with a fixed pose if neither control nor positions define the frame.
        seed: Seed of the pair search.
        progress: Called with ("prepare", stations done, all), ("pairs", pairs done, all) and ("adjust", done, 2).

    Returns:
        Poses, standard deviations, residuals and tests. Check `reliable`, and print `report()`.

    Raises:
        TypeError: Not clouds, targets or control points.
        ValueError: No station, poses that are not rigid, not one name per station, or invalid observations, such as
            targets or control points in another unit.
        DeviceError: Clouds on different devices.

    Notes:
        Standard deviations come from the inverse normal matrix, times sigma0 if that is above 1 and the redundancy at
        least 10. Relative to the reference if that defines the frame. Memory O(points), dense in stations and targets.
        Bitwise reproducible. Baarda, "A testing procedure for use in geodetic networks", 1968. Theiler and Schindler
        2012.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 9000))
        >>> ground = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.2 * np.sin(4 * y + x)])
        >>> scans = [loom.PointCloud(ground[k::3] - [0.2 * k, 0.1, 0]) for k in range(3)]
        >>> rough = np.tile(np.eye(4), (3, 1, 1))
        >>> found = loom.registration.register_stations(scans, poses=rough, voxel_size=0.1)
        >>> bool(np.abs(found.poses[:, :3, 3] - [[0, 0, 0], [0.2, 0, 0], [0.4, 0, 0]]).max() < 0.01)
        True
    """
    if isinstance(stations, Stations):
        names = stations.names if names is None else names
        poses = stations.approximate_poses if poses is None and positions is None else poses
        stations = stations.clouds
    survey = _Survey(stations, names, poses, positions, level, level_sigma)
    observed_targets = check_targets(targets, survey.count)
    known = check_control(control, observed_targets)
    size = survey.voxel_size(voxel_size)
    fraction, start = check_fraction("overlap", overlap), check_seed(seed)
    check_count("reference", reference, minimum=0, maximum=survey.count - 1, because=f"there are {survey.count}")
    report_progress, away = check_progress(progress), check_positive("rough", rough)
    gnss = None if position_sigma is None else check_sigma("position_sigma", position_sigma)
    if gnss is not None and survey.positions is None:
        raise ValueError("position_sigma: requires positions=. Pass them, or leave position_sigma out")
    scans = []
    for done, cloud in enumerate(survey.clouds):
        report_progress("prepare", done, survey.count)
        scans.append(prepare(cloud.transform(survey.frames[done]), size))
    finder = PairFinder(scans, size, survey.level, fraction, start)
    first = None if survey.poses is None else survey.inner(survey.poses)
    pairs = finder.find(finder.candidates(first, survey.positions, away), first, report_progress)
    observed = Observed(
        (),
        [_in_frame(one, survey.frames[one.station]) for one in observed_targets],
        known,
        survey.tilt_sigma,
        None if gnss is None else (survey.positions, gnss),  # type: ignore[arg-type]
    )
    check_scan_unit(observed.targets, [pair for pair in pairs if pair.reliable])
    return _adjust_and_refine(survey, finder, observed, pairs, reference, away, report_progress)


def _adjust_and_refine(
    survey: _Survey,
    finder: PairFinder,
    observed: Observed,
    pairs: Sequence[StationPair],
    reference: int,
    rough: float,
    report_progress: ReportProgress,
) -> StationsResult:
    """Adjust, then register the pairs again from the adjusted poses and adjust once more."""
    result = None
    for iteration in range(2):
        if result is not None:
            inner = matmul(result.poses, np.array([invert_pose(F) for F in survey.frames]))
            pairs = finder.again(pairs, inner, result.placed)
        report_progress("adjust", iteration, 2)
        pairs = [_check_distance(pair, survey.positions, rough) for pair in pairs]
        used = dataclasses.replace(observed, pairs=[pair for pair in pairs if pair.reliable], errors=finder.errors)
        rejected = [pair for pair in pairs if not pair.reliable]
        result = adjust_stations(survey, used, rejected, reference, MAX_CLOSURE_VOXELS * finder.size)
    assert result is not None
    report_progress("adjust", 2, 2)
    return result


def adjust_stations(
    survey: _Survey, observed: Observed, rejected: list[StationPair], reference: int, tolerance: float
) -> StationsResult:
    links = links_of(observed.pairs, observed.targets, survey.level, tolerance)
    parts = parts_by(links, survey.count)
    first = np.tile(np.eye(4), (survey.count, 1, 1)) if survey.poses is None else survey.inner(survey.poses)
    if survey.poses is None and survey.positions is not None:
        first[:, :3, 3] = np.nan_to_num(survey.positions)
    initial = first
    placed_poses, fixed = onto_control(
        chain_links(links, first), parts, observed.targets, observed.control, survey.given, survey.level
    )
    first = _fix_reference(placed_poses, initial, parts, fixed, reference)
    anchored = bool(observed.control) or observed.positions is not None
    main = _main_part(parts, fixed, reference, anchored)
    fixed_station = reference if parts[reference] == main else int(np.flatnonzero(parts == main)[0])
    adjusted, remaining, outliers = snoop(first, observed, level=survey.level, reference=fixed_station)
    is_determined = ~adjusted.loose & ((parts == main) | (fixed[parts] & anchored))
    sigma0, limits = _sigma0(adjusted)
    scale = max(sigma0, 1.0) if adjusted.redundancy >= MIN_SCALING_REDUNDANCY else 1.0
    is_fixed = np.arange(survey.count) == (fixed_station if adjusted.datum == adjusted.covariances.shape[1] else -1)
    covariances = _pose_covariances(adjusted, is_determined, is_fixed, scale)
    is_wide = [bool(covariance.sigmas[3:].max() > tolerance) for covariance in covariances]
    is_open = is_determined & np.array(is_wide) & _has_open_pair(remaining, survey.count)
    poses = matmul(adjusted.poses, survey.frames)
    if survey.poses is None:
        poses[~is_determined] = np.eye(4)
    else:
        poses[~is_determined] = survey.poses[~is_determined]
    return StationsResult(
        survey.names,
        poses,
        is_determined,
        is_open,
        covariances,
        list(remaining.pairs),
        rejected,
        adjusted.targets,
        {name: np.sqrt(np.diag(C)) * scale for name, C in adjusted.target_covariances.items()},
        adjusted.groups,
        outliers,
        loops_of(remaining.pairs, survey.count),
        sigma0,
        limits,
        adjusted.redundancy,
        scale != 1.0,
        remaining.pair_factor,
        fixed_station if adjusted.datum else None,
        survey.level,
        adjusted.converged,
        survey.unit,
    )


class _Survey:
    """The stations and their adjustment frames: level if up is known, centered near the points."""

    def __init__(
        self,
        stations: Sequence[PointCloud],
        names: Sequence[str] | None,
        poses: ArrayLike | None,
        positions: ArrayLike | None,
        level: ArrayLike | None,
        level_sigma: float | None,
    ):
        self.clouds = list_clouds("stations", stations)
        if not self.clouds:
            raise ValueError("stations: expected at least one, got none")
        for i, cloud in enumerate(self.clouds):
            check_cloud(f"stations[{i}]", cloud)
            check_same_device(f"stations[{i}]", self.clouds[0].device, cloud.device)
        self.count, self.unit = len(self.clouds), common_reference("stations", self.clouds)[0]
        self.names = _check_names(names, self.count)
        if not isinstance(level, bool | np.bool_):
            raise TypeError(f"level: expected True or False, got {level!r}")
        self.tilt_sigma = 0.0 if level_sigma is None else check_sigma("level_sigma", level_sigma)
        if self.tilt_sigma and not level:
            raise ValueError("level_sigma: requires level=True, got level=False. Leave level_sigma out")
        self.level = bool(level) and not self.tilt_sigma
        self.poses = None if poses is None else _check_poses(poses, self.count)
        self.positions = None if positions is None else _check_positions(positions, self.count)
        self.given = self.positions
        self.frames = np.array([self._frame(i, bool(level)) for i in range(self.count)])
        if self.positions is None and self.poses is not None:
            self.positions = self.inner(self.poses)[:, :3, 3]

    def inner(self, poses: Array) -> Array:
        inner_poses = matmul(poses, np.array([invert_pose(F) for F in self.frames]))
        if self.level:
            yaws = elementwise(math.atan2, inner_poses[:, 1, 0], inner_poses[:, 0, 0])
            inner_poses[:, :3, :3] = 0.0
            inner_poses[:, 0, 0] = inner_poses[:, 1, 1] = np.cos(yaws)
            inner_poses[:, 1, 0], inner_poses[:, 0, 1] = np.sin(yaws), -np.sin(yaws)
            inner_poses[:, 2, 2] = 1.0
        return inner_poses

    def voxel_size(self, given: float | None) -> float:
        if given is not None:
            size = check_positive("voxel_size", given, maximum=LARGEST_NUMBER)
            extent = max(float((c.get_max_bound() - c.get_min_bound()).max()) for c in self.clouds)
            if extent / MAX_VOXELS > size:
                raise ValueError(f"voxel_size: {size:g} gives more than {MAX_VOXELS:g} voxels of {extent:g} m in a row")
            return size
        return choose_voxel_size(*self.clouds) / 2

    def _frame(self, i: int, level: bool) -> Array:
        """A station's tilt about its origin, or about the center of its points if that is far away.

        Given positions are those of the origin."""
        tilt, middle = np.eye(3), np.zeros(3)
        if level and self.poses is not None:
            R = self.poses[i, :3, :3]
            yaw = math.atan2(R[1, 0], R[0, 0])
            tilt = np.eye(3) if np.array_equal(R[2], [0.0, 0.0, 1.0]) else matmul(about_up(float(yaw)).T, R)
        low, high = np.asarray(self.clouds[i].get_min_bound()), np.asarray(self.clouds[i].get_max_bound())
        is_outside = len(self.clouds[i]) > 0 and ((low > 0) | (high < 0)).any()
        if self.given is None and is_outside and np.abs(low + high).max() > 4 * (high - low).max():
            middle = (low + high) / 2
        return make_pose(tilt, matmul(-tilt, middle))


def _check_names(names: object, count: int) -> tuple[str, ...]:
    if names is None:
        return tuple(str(i) for i in range(count))
    checked = check_list("names", names, "text")
    for name in checked:
        if not isinstance(name, str):
            raise TypeError(f"names: expected text, got {name!r}")
    if len(checked) != count or len(set(checked)) != count:
        raise ValueError(f"names: expected {count} different ones, one per station, got {len(set(checked))}")
    return tuple(checked)


def _check_poses(poses: object, count: int) -> Array:
    values = check_finite("poses", check_shape("poses", poses, (count, 4, 4)))
    checked = np.array([check_rigid(f"poses[{i}]", T) for i, T in enumerate(values)])
    checked[:, :3, :3] = [nearest_rotation(R) for R in checked[:, :3, :3]]
    return checked


def _check_positions(positions: object, count: int) -> Array:
    values = check_shape("positions", positions, (count, 3)).astype(np.float64)
    if np.isinf(values).any():
        raise ValueError("positions: expected numbers, or NaN where one is not known, got infinite ones")
    return values


def _in_frame(one: TargetObservation, F: Array) -> TargetObservation:
    return dataclasses.replace(one, position=matmul(F[:3, :3], np.asarray(one.position)) + F[:3, 3])


def _check_distance(pair: StationPair, positions: Array | None, rough: float) -> StationPair:
    if positions is None or not pair.reliable:
        return pair
    given = float(norm(positions[pair.source] - positions[pair.target]))
    estimated = float(norm(pair.transformation[:3, 3]))
    if not abs(estimated - given) > rough:
        return pair
    warning = f"it places the stations {estimated:.2f} m apart, their positions {given:.2f} m"
    return dataclasses.replace(pair, warnings=(warning,))


def _fix_reference(
    poses: Array, initial: Array, parts: NDArray[np.int32], fixed: NDArray[np.bool_], reference: int
) -> Array:
    """Fix the reference's connected part at its initial pose, unless observations fix it."""
    part = parts[reference]
    if fixed[part]:
        return poses
    moved, members = poses.copy(), parts == part
    moved[members] = matmul(initial[reference], invert_pose(poses[reference]), poses[members])
    moved[reference] = initial[reference]
    return moved


def _main_part(parts: NDArray[np.int32], fixed: NDArray[np.bool_], reference: int, anchored: bool) -> int:
    """The largest part (of those with control, if any; ties: the reference's)."""
    sizes = np.bincount(parts).astype(np.float64)
    sizes[parts[reference]] += 0.5
    if anchored and fixed.any():
        sizes[~fixed] = 0
    return int(np.argmax(sizes))


def _sigma0(adjusted: Adjusted) -> tuple[float, tuple[float, float]]:
    r = adjusted.redundancy
    if r <= 0:
        return 1.0, (0.0, np.inf)
    limits = (np.sqrt(chdtri(r, 1 - OUTSIDE_FRACTION / 2) / r), np.sqrt(chdtri(r, OUTSIDE_FRACTION / 2) / r))
    return float(np.sqrt(adjusted.squares / r)), (float(limits[0]), float(limits[1]))


def _has_open_pair(observed: Observed, count: int) -> NDArray[np.bool_]:
    """Mask of stations in a pair whose surfaces do not determine all motions."""
    mask = np.zeros(count, bool)
    for pair in observed.pairs:
        errors = observed.errors.get((pair.source, pair.target))
        mask[[pair.source, pair.target]] |= errors is not None and errors.is_open
    return mask


def _pose_covariances(
    adjusted: Adjusted, is_determined: NDArray[np.bool_], is_fixed: NDArray[np.bool_], scale: float
) -> tuple[PoseCovariance, ...]:
    size = adjusted.covariances.shape[1]
    free = LEVEL_ROWS if size == len(LEVEL_ROWS) else list(range(6))
    matrices = np.where(is_determined[:, None, None], np.zeros((6, 6)), np.inf)
    for i in np.flatnonzero(is_determined & ~is_fixed):
        C = adjusted.covariances[i] * scale**2
        np.fill_diagonal(C, np.maximum(np.diagonal(C), 0.0))
        matrices[i][np.ix_(free, free)] = (C + C.T) / 2
    return tuple(PoseCovariance(M, T[:3, 3].copy()) for M, T in zip(matrices, adjusted.poses, strict=True))


BY_TARGETS = 0.25  # support of a link from targets only: below an accepted pair


class Link(NamedTuple):
    source: int
    target: int
    transformation: Array
    support: float


def links_of(
    pairs: Sequence[StationPair], targets: Sequence[TargetObservation], level: bool, tolerance: float
) -> list[Link]:
    """Links between stations from targets and pairs. The support grows with the loops of three stations they close."""
    known = {(p.source, p.target): p.transformation for p in pairs}
    known |= {(b, a): invert_pose(T) for (a, b), T in known.items()}
    links = []
    for pair in pairs:
        a, b = pair.source, pair.target
        support = pair.score
        for c in {c for a_, c in known if a_ == a and (c, b) in known}:
            T = matmul(invert_pose(pair.transformation), known[c, b], known[a, c])
            shift = float(norm(T[:3, 3]))
            support += pair.score * (shift < tolerance and float(norm(rotation_vector(T[:3, :3]))) < 0.1)
        links.append(Link(a, b, pair.transformation, support))
    return links + _links_by_targets(targets, level)


def _links_by_targets(targets: Sequence[TargetObservation], level: bool) -> list[Link]:
    observed: dict[int, dict[str, Array]] = {}
    for one in targets:
        observed.setdefault(one.station, {})[one.name] = np.asarray(one.position)
    stations, links = sorted(observed), []
    for k, b in enumerate(stations):
        for a in stations[k + 1 :]:
            names = [name for name in observed[a] if name in observed[b]]
            left, right = (np.array([observed[i][name] for name in names]).reshape(-1, 3) for i in (a, b))
            if is_enough(left, level):
                links.append(Link(a, b, fit(left, right, level), BY_TARGETS))
    return links


def is_enough(points: Array, level: bool) -> bool:
    """True if points determine a pose: two apart in plan for level stations, else three that are not collinear."""
    if len(points) < (2 if level else 3):
        return False
    centered = points - points.mean(axis=0)
    spread = np.linalg.svd(centered[:, :2] if level else centered, compute_uv=False)
    return bool(spread[0] > 1e-3 if level else spread[1] > 1e-2 * spread[0] > 0)


def fit(source: Array, target: Array, level: bool) -> Array:
    """Least-squares pose between points. Level ones rotate about z only."""
    if not level:
        return fit_pose(source, target)
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    yaw = math.atan2((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum(), (a[:, :2] * b[:, :2]).sum())
    R = about_up(float(yaw))
    return make_pose(R, target.mean(axis=0) - matmul(R, source.mean(axis=0)))


def parts_by(links: Sequence[Link], count: int) -> NDArray[np.int32]:
    ends = np.array([[link.source, link.target] for link in links], np.int64).reshape(-1, 2)
    return connected_parts(ends[:, 0], ends[:, 1], count)


def chain_links(links: Sequence[Link], first: Array) -> Array:
    """Poses along the maximum spanning tree, from the first station of each part."""
    tree, groups = spanning_tree(links, [link.support for link in links], len(first))
    return chain(first, np.unique(groups).tolist(), links, tree)


def onto_control(
    poses: Array,
    parts: NDArray[np.int32],
    targets: Sequence[TargetObservation],
    control: Sequence[ControlPoint],
    positions: Array | None,
    level: bool,
) -> tuple[Array, NDArray[np.bool_]]:
    """Move each part to its control points and positions. Also returns the mask of parts that these determine."""
    control_positions = {point.name: np.asarray(point.position) for point in control}
    moved, fixed = poses.copy(), np.zeros(int(parts.max(initial=-1)) + 1, bool)
    for part in range(len(fixed)):
        observed = [one for one in targets if parts[one.station] == part and one.name in control_positions]
        source_points = [
            matmul(poses[one.station][:3, :3], np.asarray(one.position)) + poses[one.station][:3, 3] for one in observed
        ]
        target_points = [control_positions[one.name] for one in observed]
        members = np.flatnonzero(parts == part)
        if positions is not None:
            known = [i for i in members if np.isfinite(positions[i]).all()]
            source_points += [poses[i][:3, 3] for i in known]
            target_points += [positions[i] for i in known]
        if is_enough(np.array(target_points).reshape(-1, 3), level):
            fixed[part] = True
            moved[members] = matmul(fit(np.array(source_points), np.array(target_points), level), poses[members])
    return moved, fixed


NORMAL_VOXEL_DIVISOR = 3.0  # finer voxels for normals, per voxel edge
NORMAL_RADIUS, NORMAL_NEIGHBORS = 1.5, 60  # [voxels]
COARSE_TO_FINE = (8.0, 4.0, 2.0)  # [voxels] ICP distances from an approximate pose
MAX_DISTANCE = 2.0  # [voxels] of a correspondence
TUKEY_CUTOFF = 4.685  # standard deviations: 95% efficiency for normal errors
TO_DEVIATION = 1.4826  # MAD to standard deviation
MIN_LIMIT = 0.01  # [voxels]
CUTOFF_FACTORS = (12.0, 6.0, 3.0, 1.5, 1.0)  # decreasing factors of the cutoff
MAX_BENT = np.radians(30.0)  # maximum angle between the normals of a pair
RATED_WITHIN = 1.5  # [voxels]
# [voxels] maximum displacement of points to keep a rating, which first refines the pose itself
MAX_RATED_DISPLACEMENT = 0.25
OVERLAP_VOXELS = 4.0  # [voxels] overlap distance for approximate poses
ALL_PAIRS = 40  # maximum stations for all pairs without approximate positions
PLANE = TransformationEstimationPointToPlane()


@dataclass(frozen=True, eq=False)
class Scan:
    """A station's cloud for registration: downsampled, with normals, in its level frame."""

    cloud: PointCloud
    radius: float


def prepare(cloud: PointCloud, size: float) -> Scan:
    fine = cloud.thin(size / NORMAL_VOXEL_DIVISOR)
    fine = fine.estimate_normals(radius=NORMAL_RADIUS * size, max_nn=NORMAL_NEIGHBORS)
    thinned = fine.thin(size)
    ranges = np.sqrt((thinned.points**2).sum(axis=1))
    return Scan(thinned, float(np.quantile(ranges, 0.9)) if len(ranges) else 0.0)


class PairFinder:
    """Finds pairs of scans; `size`: voxel edge [m], `level`: rotations about z only, `min_overlap`: minimum overlap."""

    def __init__(self, scans: Sequence[Scan], size: float, level: bool, min_overlap: float, seed: int):
        self.scans, self.size, self.min_overlap, self.seed = scans, size, min_overlap, seed
        self.free = LEVEL if level else None
        self.descriptions: dict[int, Description] = {}
        self.witnesses: dict[tuple[int, float], Witness] = {}
        self.thinned: dict[tuple[int, float], PointCloud] = {}
        self.surfaces: dict[tuple[int, float], Surface] = {}
        self.errors: dict[tuple[int, int], PairErrors] = {}  # by blocks of the survey
        self.limit = MIN_LIMIT * size  # cutoff of the residuals

    def candidates(self, poses: Array | None, positions: Array | None, rough: float) -> list[tuple[int, int]]:
        count = len(self.scans)
        pairs = [(j, i) for i, j in itertools.combinations(range(count), 2)]
        if positions is not None:
            apart = {(a, b): float(norm(positions[a] - positions[b])) for a, b in pairs}
            max_distance = {(a, b): self.scans[a].radius + self.scans[b].radius + rough for a, b in pairs}
            pairs = [pair for pair in pairs if not apart[pair] > max_distance[pair]]
        if poses is None and positions is None and count > ALL_PAIRS:
            raise ValueError(
                f"positions: {count} stations without known positions give too many pairs to search. "
                f"Pass rough positions or poses, or at most {ALL_PAIRS} stations"
            )
        if poses is not None and pairs:
            max_distance = max(OVERLAP_VOXELS * self.size, min(rough, MAX_DISTANCE * COARSE_TO_FINE[0] * self.size))
            between = [matmul(invert_pose(poses[b]), poses[a]) for a, b in pairs]
            overlaps = self._overlaps(pairs, between, max_distance)
            pairs = [pair for pair, overlap in zip(pairs, overlaps, strict=True) if overlap >= self.min_overlap]
        return pairs

    def _overlaps(self, pairs: Sequence[tuple[int, int]], poses: Sequence[Array], distance: float) -> list[float]:
        return fitness_of(*self._clouds(pairs), distance, np.array(poses))

    def _clouds(self, pairs: Sequence[tuple[int, int]]) -> tuple[list[PointCloud], list[PointCloud]]:
        return [self.scans[a].cloud for a, _ in pairs], [self.scans[b].cloud for _, b in pairs]

    def find(
        self, pairs: Sequence[tuple[int, int]], poses: Array | None, report_progress: Callable[[str, int, int], None]
    ) -> list[StationPair]:
        starts, search_scores, ends = [], [], []
        near = [None] * len(pairs) if poses is None else self._near_poses(pairs, poses)
        for done, ((a, b), known) in enumerate(zip(pairs, near, strict=True)):
            report_progress("pairs", done, len(pairs))
            start, score = self._searched(a, b) if known is None else (known, 1.0)
            if start is not None:
                starts.append(start)
                search_scores.append(score)
                ends.append((a, b))
        report_progress("pairs", len(pairs), len(pairs))
        return self._refined(ends, starts, search_scores)

    def _near_poses(self, pairs: Sequence[tuple[int, int]], poses: Array) -> list[Array | None]:
        """Poses of the pairs by ICP from approximate poses of the stations. None if the surfaces do not match.

        From coarse to fine, and then at the finest scale alone: coarse scales may lose a good initial pose.
        """
        found: list[Array | None] = [None] * len(pairs)
        for scales in (COARSE_TO_FINE, COARSE_TO_FINE[-1:]):
            rows = [k for k, pose in enumerate(found) if pose is None]
            if rows:
                remaining = [pairs[k] for k in rows]
                between = np.array([matmul(invert_pose(poses[b]), poses[a]) for a, b in remaining])
                for scale in scales:
                    between = self._at_scale(remaining, scale * self.size, between)
                scores = self._rates(remaining, between, RATED_WITHIN * scales[-1] * self.size)
                for k, pose, score in zip(rows, between, scores, strict=True):
                    found[k] = pose if score > MIN_SCORE else None
        return found

    def _thinned(self, i: int, size: float) -> PointCloud:
        if (i, size) not in self.thinned:
            self.thinned[i, size] = self.scans[i].cloud.voxel_down_sample(size)
        return self.thinned[i, size]

    def _at_scale(self, pairs: Sequence[tuple[int, int]], size: float, starts: Array) -> Array:
        """Poses by all pairs of points, or by those of an estimated overlap if few points match."""
        distance = MAX_DISTANCE * size

        def register(rows: list[int], overlap: float | None) -> tuple[Array, Array]:
            rules, bound = ICPConvergenceCriteria(max_iteration=50), Constraint(self.free)
            clouds = [self._thinned(pairs[k][0], size) for k in rows], [self._thinned(pairs[k][1], size) for k in rows]
            given = *clouds, distance, starts[rows], PLANE, rules
            results = registration_icp_batch(*given, overlap=overlap, constraint=bound)
            poses = np.array([result.transformation for result in results])
            return poses, np.array(fitness_of(*clouds, distance, poses))

        poses, matched = register(list(range(len(starts))), 1.0)
        few = np.flatnonzero((matched > 0) & (matched < MIN_OVERLAP))
        if len(few):
            trimmed, still_matched = register(few.tolist(), None)
            is_better = still_matched >= MIN_OVERLAP_RATIO * matched[few]
            poses[few[is_better]] = trimmed[is_better]
        return poses

    def _searched(self, a: int, b: int) -> tuple[Array | None, float]:
        result = register_described(self._described(a), self._described(b), seed=self.seed, free=self.free)
        return (result.transformation, float(result.score)) if result.score else (None, 0.0)

    def _described(self, i: int) -> Description:
        if i not in self.descriptions:
            self.descriptions[i] = describe(self.scans[i].cloud, COARSE_TO_FINE[-1] * self.size)
        return self.descriptions[i]

    def _rates(self, pairs: Sequence[tuple[int, int]], poses: Iterable[Array], distance: float) -> list[float]:
        local = [
            to_local(T, self.scans[a].cloud.origin, self.scans[b].cloud.origin)
            for (a, b), T in zip(pairs, poses, strict=True)
        ]
        sources, targets = ([self._witness(ends[k], distance) for ends in pairs] for k in (0, 1))
        poses = np.array(local).reshape(-1, 4, 4)
        return [evidence.score for evidence in rate_poses(sources, targets, poses, distance)]

    def _witness(self, i: int, distance: float) -> Witness:
        if (i, distance) not in self.witnesses:
            self.witnesses[i, distance] = witnesses_of([self.scans[i].cloud], distance)[0]
        return self.witnesses[i, distance]

    def _refined(
        self,
        pairs: Sequence[tuple[int, int]],
        starts: Sequence[Array],
        search_scores: Sequence[float],
        earlier: Sequence[StationPair] = (),
        stations: Array | None = None,
    ) -> list[StationPair]:
        """Refine all pairs in the same launches, point to plane. With earlier results, the poses are accurate, and
        `stations` are the adjusted poses.
        """
        if not pairs:
            return []
        sources, targets = self._clouds(pairs)
        options: dict[str, Any] = {"constraint": Constraint(self.free), "max_normal_angle": MAX_BENT}
        rules, poses, results = ICPConvergenceCriteria(max_iteration=60), np.array(starts), []
        if not earlier:
            for voxels in (2 * MAX_DISTANCE, MAX_DISTANCE):
                results = registration_icp_batch(sources, targets, voxels * self.size, poses, PLANE, rules, **options)
                poses = np.array([result.transformation for result in results])
            self.limit = self._limit(pairs, results)
        for factor in (1.0,) if earlier else CUTOFF_FACTORS:
            method = TransformationEstimationPointToPlane(TukeyLoss(factor * self.limit))
            results = registration_icp_batch(
                sources, targets, MAX_DISTANCE * self.size, poses, method, rules, **options
            )
            poses = np.array([result.transformation for result in results])
        return self._judged(pairs, results, search_scores, earlier, stations)

    def again(self, pairs: Sequence[StationPair], poses: Array, is_placed: NDArray[np.bool_]) -> list[StationPair]:
        """Register the pairs again from adjusted poses, to leave local minima."""
        selected = [
            k for k, pair in enumerate(pairs) if is_placed[pair.source] and is_placed[pair.target] and pair.score > 0
        ]
        earlier = [pairs[k] for k in selected]
        starts = [matmul(invert_pose(poses[pair.target]), poses[pair.source]) for pair in earlier]
        ends = [(pair.source, pair.target) for pair in earlier]
        centered = poses.copy()
        centered[:, :3, 3] -= poses[is_placed][:, :3, 3].mean(axis=0) if is_placed.any() else 0.0
        refined = self._refined(ends, starts, [1.0] * len(earlier), earlier, centered)
        renewed = dict(zip(selected, refined, strict=True))
        return [renewed.get(k, pair) for k, pair in enumerate(pairs)]

    def _limit(self, pairs: Sequence[tuple[int, int]], results: Sequence[RegistrationResult]) -> float:
        sizes = [float(np.median(np.abs(self._residuals(*each)))) for each in zip(pairs, results, strict=True)
                 if len(each[1].correspondence_set)]  # fmt: skip
        return max(TUKEY_CUTOFF * TO_DEVIATION * float(np.median(sizes)) if sizes else np.inf, MIN_LIMIT * self.size)

    def _judged(
        self,
        pairs: Sequence[tuple[int, int]],
        results: Sequence[RegistrationResult],
        search_scores: Sequence[float],
        earlier: Sequence[StationPair],
        stations: Array | None,
    ) -> list[StationPair]:
        poses = [result.transformation for result in results]
        back = self._overlaps([(b, a) for a, b in pairs], [invert_pose(X) for X in poses], MAX_DISTANCE * self.size)
        overlaps = [max(result.fitness, backwards) for result, backwards in zip(results, back, strict=True)]
        scores = {k: pair.score for k, pair in enumerate(earlier) if pair.reliable and self._is_near(pair, poses[k])}
        rated = [k for k, overlap in enumerate(overlaps) if overlap >= self.min_overlap and k not in scores]
        rates = self._rates([pairs[k] for k in rated], [poses[k] for k in rated], RATED_WITHIN * self.size)
        scores |= {k: min(search_scores[k], rate) for k, rate in zip(rated, rates, strict=True)}
        judged = []
        for k, (pair, result, overlap) in enumerate(zip(pairs, results, overlaps, strict=True)):
            information, rms, score, warning = np.zeros((6, 6)), 0.0, 0.0, "no overlap"
            if overlap >= self.min_overlap:
                information, score = self._information(pair, poses[k], stations), scores[k]
                rms = self._rms(pair, result)
                warning = "" if score > MIN_SCORE else "the surfaces hardly match, or match elsewhere equally well"
                if not warning and not information.any():
                    warning = "too few points match to estimate the accuracy"
            judged.append(StationPair(*pair, poses[k], information, overlap, rms, score, failed(warning)))
        return judged

    def _is_near(self, pair: StationPair, X: Array) -> bool:
        """True if a pose differs so little from an earlier one that it needs no new rating."""
        D = matmul(invert_pose(pair.transformation), X)
        angle = float(norm(rotation_vector(D[:3, :3])))
        return float(norm(D[:3, 3])) + angle * self.scans[pair.source].radius < MAX_RATED_DISPLACEMENT * self.size

    def _information(self, pair: tuple[int, int], X: Array, stations: Array | None) -> Array:
        """Information of the pose in the source frame, zero if undetermined."""
        a, b = pair
        origins = self.scans[a].cloud.origin, self.scans[b].cloud.origin
        surfaces = self._surface(a, SOURCE_FINER * self.size), self._surface(b, self.size)
        motions = LEVEL_ROWS if self.free else list(range(6))
        frame = None if stations is None else to_local(stations[b], origins[1], np.zeros(3))
        errors = pair_errors(surfaces, origins, to_local(X, *origins), self.size, motions, frame)
        information = np.zeros((6, 6))
        if errors is not None:
            information[np.ix_(motions, motions)] = errors.information
            if stations is not None:
                self.errors[pair] = errors
        return information

    def _surface(self, i: int, size: float) -> Surface:
        if (i, size) not in self.surfaces:
            self.surfaces[i, size] = surface_of(self.scans[i].cloud, size)
        return self.surfaces[i, size]

    def _rms(self, pair: tuple[int, int], result: RegistrationResult) -> float:
        """Root mean square of the used residuals [m]."""
        r = self._residuals(pair, result)
        r = r[np.abs(r) < self.limit]
        return float(np.sqrt((r * r).mean())) if len(r) else 0.0

    def _residuals(self, pair: tuple[int, int], result: RegistrationResult) -> Array:
        """Point-to-plane distances of the matches."""
        a, b = pair
        source, target = self.scans[a].cloud, self.scans[b].cloud
        matches = result.correspondence_set
        p, q = source.points[matches[:, 0]], target.points[matches[:, 1]]
        R, t = result.transformation[:3, :3], result.transformation[:3, 3]
        n = np.asarray(target.normals, np.float64)[matches[:, 1]]
        return (n * (np.einsum("ij,nj->ni", R, p) + t - q)).sum(axis=1)
