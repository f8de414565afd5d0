"""Many terrestrial scans brought into one frame: `register_stations`.

Pairs of stations whose clouds overlap: which they are, their poses, and what these poses are worth.

The information of a pair's pose comes from its point-to-plane rows J at the end, with residuals r: N = sum J^T J, and
with g_b = sum of J^T r over the matches in block b of space, covariance N^-1 (sum g_b g_b^T) N^-1. So whatever errors
neighbours have in common (normals from the same points, surfaces that are not planes) counts as often as it occurs, not
once a point (White 1980, eq. 3, in groups as Liang and Zeger 1986).
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtri

from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_finite,
    check_list,
    check_positive,
    check_progress,
    check_rigid,
    check_seed,
    check_shape,
    check_share,
)
from ...core.devices import check_same_device
from ...core.progress import ReportProgress
from ...core.units import common_unit
from ...kernels.linear_algebra import eigh, elementwise, inv, matmul, norm
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..globally.global_registration import Description, describe, register_described
from ..globally.level_poses import LEVEL
from ..globally.rating import rate_registration
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.evaluation import evaluate_registration
from ..icp.icp import ICPConvergenceCriteria, registration_icp_batch
from ..icp.multi_scale import multi_scale_icp
from ..pose_graphs.connected_parts import connected_parts
from ..pose_graphs.spanning_tree import chain, spanning_tree
from ..result import RegistrationResult
from ..rigid import about_up, fit_pose, invert_pose, make_pose, nearest_rotation, rotation_vector
from ..robust_kernels import TukeyLoss
from ..voxel_size import choose_voxel_size
from .adjustment import Adjusted, Observed
from .loops import loops_of
from .observations import Array, ControlPoint, StationPair, TargetObservation, check_control, check_sigma, check_targets
from .result import StationsResult
from .snooping import snoop

AGREES = 4.0  # [voxels] that a way round three stations may miss by
BAND = 0.01  # of surveys whose sigma0 lies outside of its limits
ENOUGH = 10  # redundancy from which on sigma0 is known well enough to scale by
ROUGH = 2.0  # [m]
MOST_VOXELS = 1e6  # along a cloud
# What errors of pairs are, in parts of what their residuals show: all pairs of a station have its noise in common,
# which closes their loops. Measured over 16 made courtyards of five stations each, tests/registration/test_stations.py.
SHARED = 1.25


def register_stations(
    stations: Sequence[PointCloud],
    *,
    poses: ArrayLike | None = None,
    positions: ArrayLike | None = None,
    position_sigma: float | None = None,
    rough: float = ROUGH,
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
    """Bring many terrestrial scans into one frame, and say how well each station is known.

    Pairs of scans that overlap are registered, from points to planes; then all poses are adjusted together, each pair
    with the covariance that its residuals show, beside targets, control points, levels and positions. Observations
    that contradict the rest are taken out, the worst first, and named.

    Args:
        stations: The clouds, each in its scanner's own coordinates, on one device.
        poses: Rough poses T_survey_station, [n, 4, 4]; None: nothing is known of where scanners turned to.
        positions: Rough positions of the scanners [m], [n, 3]; NaN where one is not known. Those of `poses` where these
            are given.
        position_sigma: Standard deviation of the positions [m]: they are observations then, as those of GNSS; None:
            they say what may overlap, and where a pair cannot be, and the frame alone.
        rough: By how much two stations may be apart otherwise than poses or positions say [m].
        level: Whether z is up in the scans, or in `poses`: four degrees of freedom each, and tilts are kept exactly.
            Else all six.
        level_sigma: Standard deviation of the direction of up [rad] where it is known, but not exactly: six degrees of
            freedom, with up as an observation.
        targets: What stations saw of targets.
        control: Where some targets are in the survey's coordinates, in which poses then are.
        names: The stations', for the report; None numbers them.
        voxel_size: Edge of the voxels that clouds are thinned to [m]; None: half of what `choose_voxel_size` says.
        overlap: Share of the smaller cloud that lies on the other in a pair.
        reference: The station that keeps its pose where neither control nor positions hold the frame.
        seed: Of the search for pairs.
        progress: Called with ("prepare", stations done, in all), ("pairs", pairs done, in all) and ("adjust", done, 2).

    Returns:
        Poses, their standard deviations, residuals and tests; check `reliable`, and print `report()`.

    Raises:
        TypeError: Not clouds, targets or control points.
        ValueError: No station, poses that are not rigid, names that are not one a
            station, or observations that make no sense.
        DeviceError: Clouds on different devices.

    Notes:
        A station's standard deviations are the roots of the inverse normal matrix' diagonal, times sigma0 where that
        is above 1 and the redundancy at least 10; relative to the reference where that holds the frame. O(points)
        memory, dense in stations and targets. The same bits from run to run. Baarda 1968; Theiler and Schindler 2012.

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
    survey = _Survey(stations, names, poses, positions, level, level_sigma)
    seen = check_targets(targets, survey.count)
    known = check_control(control, seen)
    size = survey.voxel_size(voxel_size)
    share, start = check_share("overlap", overlap), check_seed(seed)
    check_count("reference", reference, minimum=0, maximum=survey.count - 1, because=f"there are {survey.count}")
    tell, away = check_progress(progress), check_positive("rough", rough)
    gnss = None if position_sigma is None else check_sigma("position_sigma", position_sigma)
    if gnss is not None and survey.positions is None:
        raise ValueError("position_sigma: it is of positions, and there are none; give positions=, or leave it out")
    scans = []
    for done, cloud in enumerate(survey.clouds):
        tell("prepare", done, survey.count)
        scans.append(prepare(cloud.transform(survey.frames[done]), size))
    finder = PairFinder(scans, size, survey.level, share, start)
    first = None if survey.poses is None else survey.inner(survey.poses)
    pairs = finder.find(finder.candidates(first, survey.positions, away), first, tell)
    observed = Observed(
        (),
        [_in_frame(one, survey.frames[one.station]) for one in seen],
        known,
        survey.tilt_sigma,
        None if gnss is None else (survey.positions, gnss),  # type: ignore[arg-type]
        SHARED,
    )
    return _in_turns(survey, finder, observed, pairs, reference, away, tell)


def _in_turns(
    survey: _Survey,
    finder: PairFinder,
    observed: Observed,
    pairs: Sequence[StationPair],
    reference: int,
    rough: float,
    tell: ReportProgress,
) -> StationsResult:
    """The adjustment, and another one with the pairs registered from where it has put the stations."""
    found = None
    for turn in range(2):
        if found is not None:
            inner = matmul(found.poses, np.array([invert_pose(F) for F in survey.frames]))
            pairs = finder.again(pairs, inner, found.placed)
        tell("adjust", turn, 2)
        pairs = [_placed_rightly(pair, survey.positions, rough) for pair in pairs]
        used = dataclasses.replace(observed, pairs=[pair for pair in pairs if not pair.reason])
        rejected = [pair for pair in pairs if pair.reason]
        found = adjust_stations(survey, used, rejected, reference, AGREES * finder.size)
    assert found is not None
    tell("adjust", 2, 2)
    return found


def adjust_stations(
    survey: _Survey, observed: Observed, rejected: list[StationPair], reference: int, tolerance: float
) -> StationsResult:
    """The joint adjustment of what is observed in the stations' level frames, and what it says."""
    links = links_of(observed.pairs, observed.targets, survey.level, tolerance)
    parts = parts_by(links, survey.count)
    first = np.tile(np.eye(4), (survey.count, 1, 1)) if survey.poses is None else survey.inner(survey.poses)
    if survey.poses is None and survey.positions is not None:
        first[:, :3, 3] = np.nan_to_num(survey.positions)
    began = first
    placed, fixed = onto_control(
        chain_links(links, first), parts, observed.targets, observed.control, survey.given, survey.level
    )
    first = _held_at(placed, began, parts, fixed, reference)
    anchored = bool(observed.control) or observed.positions is not None
    main = _main_part(parts, fixed, reference, anchored)
    held = reference if parts[reference] == main else int(np.flatnonzero(parts == main)[0])
    found, left, outliers = snoop(first, observed, level=survey.level, reference=held)
    there = ~found.loose & ((parts == main) | (fixed[parts] & anchored))
    sigma0, limits = _sigma0(found)
    scale = max(sigma0, 1.0) if found.redundancy >= ENOUGH else 1.0
    sigmas, covariances = _sigmas(found, survey, scale)
    sigmas[~there] = np.nan
    poses = matmul(found.poses, survey.frames)
    if survey.poses is None:
        poses[~there] = np.eye(4)
    else:
        poses[~there] = survey.poses[~there]
    return StationsResult(
        survey.names,
        poses,
        there,
        sigmas,
        covariances,
        list(left.pairs),
        rejected,
        found.targets,
        {name: np.sqrt(np.diag(C)) * scale for name, C in found.target_covariances.items()},
        found.groups,
        outliers,
        loops_of(left.pairs, survey.count),
        sigma0,
        limits,
        found.redundancy,
        scale != 1.0,
        left.pair_factor,
        held if found.datum else None,
        survey.level,
        found.converged,
        survey.unit,
    )


class _Survey:
    """The stations, and the frames in which they are adjusted: level where up is known, about a place near the points.

    Attributes:
        frames: From the stations' own coordinates to these, [n, 4, 4].
        poses: Rough ones as given, or None.
        positions: Rough ones of the frames' zeros, or None.
        given: Those that were given as such, which hold the frame.
    """

    def __init__(self, stations: Any, names: Any, poses: Any, positions: Any, level: Any, level_sigma: Any):
        self.clouds = check_list("stations", stations, "point clouds")
        if not self.clouds:
            raise ValueError("stations: expected at least one, got none")
        for i, cloud in enumerate(self.clouds):
            check_cloud(f"stations[{i}]", cloud)
            check_same_device(f"stations[{i}]", self.clouds[0].device, cloud.device)
        self.count, self.unit = len(self.clouds), common_unit("stations", (cloud.unit for cloud in self.clouds))
        self.names = _check_names(names, self.count)
        if not isinstance(level, bool | np.bool_):
            raise TypeError(f"level: expected True or False, got {level!r}")
        self.tilt_sigma = 0.0 if level_sigma is None else check_sigma("level_sigma", level_sigma)
        if self.tilt_sigma and not level:
            raise ValueError("level_sigma: it says how level stations are, and level=False that they are not")
        self.level = bool(level) and not self.tilt_sigma
        self.poses = None if poses is None else _check_poses(poses, self.count)
        self.positions = None if positions is None else _check_positions(positions, self.count)
        self.given = self.positions
        self.frames = np.array([self._frame(i, bool(level)) for i in range(self.count)])
        if self.positions is None and self.poses is not None:
            self.positions = self.inner(self.poses)[:, :3, 3]

    def inner(self, poses: Array) -> Array:
        """Poses of the frames, of poses of the stations."""
        found = matmul(poses, np.array([invert_pose(F) for F in self.frames]))
        if self.level:
            yaws = elementwise(math.atan2, found[:, 1, 0], found[:, 0, 0])
            found[:, :3, :3] = 0.0
            found[:, 0, 0] = found[:, 1, 1] = np.cos(yaws)
            found[:, 1, 0], found[:, 0, 1] = np.sin(yaws), -np.sin(yaws)
            found[:, 2, 2] = 1.0
        return found

    def voxel_size(self, given: float | None) -> float:
        """The edge of the voxels."""
        if given is not None:
            size = check_positive("voxel_size", given, maximum=LARGEST_NUMBER)
            extent = max(float((c.get_max_bound() - c.get_min_bound()).max()) for c in self.clouds)
            if extent / MOST_VOXELS > size:
                raise ValueError(
                    f"voxel_size: {size:g} makes more than {MOST_VOXELS:g} voxels of {extent:g} m in a row"
                )
            return size
        return choose_voxel_size(*self.clouds) / 2

    def _frame(self, i: int, level: bool) -> Array:
        """A station's tilt, about its zero; about the middle of its points where these are far from that."""
        tilt, middle = np.eye(3), np.zeros(3)
        if level and self.poses is not None:
            R = self.poses[i, :3, :3]
            yaw = math.atan2(R[1, 0], R[0, 0])
            tilt = np.eye(3) if np.array_equal(R[2], [0.0, 0.0, 1.0]) else matmul(about_up(float(yaw)).T, R)
        low, high = np.asarray(self.clouds[i].get_min_bound()), np.asarray(self.clouds[i].get_max_bound())
        if len(self.clouds[i]) and ((low > 0) | (high < 0)).any() and np.abs(low + high).max() > 4 * (high - low).max():
            middle = (low + high) / 2
        return make_pose(tilt, matmul(-tilt, middle))


def _check_names(names: Any, count: int) -> tuple[str, ...]:
    if names is None:
        return tuple(str(i) for i in range(count))
    found = check_list("names", names, "text")
    for name in found:
        if not isinstance(name, str):
            raise TypeError(f"names: expected text, got {name!r}")
    if len(found) != count or len(set(found)) != count:
        raise ValueError(f"names: expected {count} different ones, one a station, got {len(set(found))}")
    return tuple(found)


def _check_poses(poses: Any, count: int) -> Array:
    values = check_finite("poses", check_shape("poses", poses, (count, 4, 4)))
    found = np.array([check_rigid(f"poses[{i}]", T) for i, T in enumerate(values)])
    found[:, :3, :3] = [nearest_rotation(R) for R in found[:, :3, :3]]
    return found


def _check_positions(positions: Any, count: int) -> Array:
    values = check_shape("positions", positions, (count, 3)).astype(np.float64)
    if np.isinf(values).any():
        raise ValueError("positions: expected numbers, or NaN where one is not known, got infinite ones")
    return values


def _in_frame(one: TargetObservation, F: Array) -> TargetObservation:
    return dataclasses.replace(one, position=matmul(F[:3, :3], np.asarray(one.position)) + F[:3, 3])


def _placed_rightly(pair: StationPair, positions: Array | None, rough: float) -> StationPair:
    """The pair, with a reason not to use it where its stations are not as far apart as their positions."""
    if positions is None or pair.reason:
        return pair
    said = float(norm(positions[pair.source] - positions[pair.target]))
    found = float(norm(pair.transformation[:3, 3]))
    if not abs(found - said) > rough:
        return pair
    reason = f"it puts the stations {found:.2f} m apart, their positions {said:.2f} m"
    return dataclasses.replace(pair, reason=reason)


def _held_at(poses: Array, began: Array, parts: NDArray[np.int32], fixed: NDArray[np.bool_], reference: int) -> Array:
    """The poses with the reference's part where the reference began, unless something else fixes that part."""
    part = parts[reference]
    if fixed[part]:
        return poses
    moved, members = poses.copy(), parts == part
    moved[members] = matmul(began[reference], invert_pose(poses[reference]), poses[members])
    moved[reference] = began[reference]
    return moved


def _main_part(parts: NDArray[np.int32], fixed: NDArray[np.bool_], reference: int, anchored: bool) -> int:
    """The part that the survey is: of those that control fixes, else of all, the largest; the reference's of equals."""
    sizes = np.bincount(parts).astype(np.float64)
    sizes[parts[reference]] += 0.5
    if anchored and fixed.any():
        sizes[~fixed] = 0
    return int(np.argmax(sizes))


def _sigma0(found: Adjusted) -> tuple[float, tuple[float, float]]:
    r = found.redundancy
    if r <= 0:
        return 1.0, (0.0, np.inf)
    limits = (np.sqrt(chdtri(r, 1 - BAND / 2) / r), np.sqrt(chdtri(r, BAND / 2) / r))
    return float(np.sqrt(found.squares / r)), (float(limits[0]), float(limits[1]))


def _sigmas(found: Adjusted, survey: _Survey, scale: float) -> tuple[Array, Array]:
    """Standard deviations of positions and turns [n, 6], and covariances, scaled."""
    covariances = found.covariances * scale**2
    spread = np.sqrt(np.maximum(np.diagonal(covariances, axis1=1, axis2=2), 0.0))
    sigmas = np.zeros((survey.count, 6))
    sigmas[:, :3] = spread[:, -3:]
    sigmas[:, 5 if survey.level else 3 :] = spread[:, :-3]
    return sigmas, covariances


BY_TARGETS = 0.25  # the support of a link by targets alone: below that of an accepted pair of clouds


class Link(NamedTuple):
    """A pose between two stations, and its support."""

    source: int
    target: int
    transformation: Array
    support: float


def links_of(
    pairs: Sequence[StationPair], targets: Sequence[TargetObservation], level: bool, tolerance: float
) -> list[Link]:
    """Links between stations: targets, and pairs, with more support the more loops of three stations they close."""
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
    seen: dict[int, dict[str, Array]] = {}
    for one in targets:
        seen.setdefault(one.station, {})[one.name] = np.asarray(one.position)
    stations, links = sorted(seen), []
    for k, b in enumerate(stations):
        for a in stations[k + 1 :]:
            names = [name for name in seen[a] if name in seen[b]]
            left, right = (np.array([seen[i][name] for name in names]).reshape(-1, 3) for i in (a, b))
            if is_enough(left, level):
                links.append(Link(a, b, fit(left, right, level), BY_TARGETS))
    return links


def is_enough(points: Array, level: bool) -> bool:
    """Whether points fix a pose: two apart in plan of level stations, else three that lie on no line."""
    if len(points) < (2 if level else 3):
        return False
    centred = points - points.mean(axis=0)
    spread = np.linalg.svd(centred[:, :2] if level else centred, compute_uv=False)
    return bool(spread[0] > 1e-3 if level else spread[1] > 1e-2 * spread[0] > 0)


def fit(source: Array, target: Array, level: bool) -> Array:
    """The pose that takes points nearest to others; level ones turn about z alone."""
    if not level:
        return fit_pose(source, target)
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    yaw = math.atan2((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum(), (a[:, :2] * b[:, :2]).sum())
    R = about_up(float(yaw))
    return make_pose(R, target.mean(axis=0) - matmul(R, source.mean(axis=0)))


def parts_by(links: Sequence[Link], count: int) -> NDArray[np.int32]:
    """The part that each station belongs to."""
    ends = np.array([[link.source, link.target] for link in links], np.int64).reshape(-1, 2)
    return connected_parts(ends[:, 0], ends[:, 1], count)


def chain_links(links: Sequence[Link], first: Array) -> Array:
    """Poses along the tree of most support, from the first station of each part, which stays where it is."""
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
    """The poses with each part moved onto the control and the positions that fix it, and which parts these are."""
    places = {point.name: np.asarray(point.position) for point in control}
    moved, fixed = poses.copy(), np.zeros(int(parts.max(initial=-1)) + 1, bool)
    for part in range(len(fixed)):
        seen = [one for one in targets if parts[one.station] == part and one.name in places]
        here = [
            matmul(poses[one.station][:3, :3], np.asarray(one.position)) + poses[one.station][:3, 3] for one in seen
        ]
        there = [places[one.name] for one in seen]
        members = np.flatnonzero(parts == part)
        if positions is not None:
            known = [i for i in members if np.isfinite(positions[i]).all()]
            here += [poses[i][:3, 3] for i in known]
            there += [positions[i] for i in known]
        if is_enough(np.array(there).reshape(-1, 3), level):
            fixed[part] = True
            moved[members] = matmul(fit(np.array(here), np.array(there), level), poses[members])
    return moved, fixed


FINER = 3.0  # points to a voxel's edge, of which normals are fitted
NORMAL_RADIUS, NORMAL_NEIGHBORS = 1.5, 60  # [voxels]
COARSE_TO_FINE = (8.0, 4.0, 2.0)  # [voxels] of ICP from a rough pose
REACH = 2.0  # [voxels] of a correspondence
TUKEY = 4.685  # standard deviations: as good as least squares to 95 % where errors are normal
TO_DEVIATION = 1.4826  # times the median of absolute values, for normal errors
LEAST_LIMIT = 0.01  # [voxels]
GRADED = (12.0, 6.0, 3.0, 1.5, 1.0)  # times the limit of a match that counts, one after another
MOST_BENT = np.radians(30.0)  # between the normals of a correspondence
RATED_WITHIN = 1.5  # [voxels]
SURE = 0.5  # score above which a pair is accepted
NEAR = 4.0  # [voxels] within which rough poses show an overlap
BLOCK = 8.0  # [voxels] edge of the blocks whose matches err alike
FEWEST_BLOCKS = 12  # with matches in them, below which a pose's errors cannot be told
OPEN = 1e-3  # of the largest eigenvalue, with rotations in units of the matches' radius: what matches leave open
ALL_PAIRS = 40  # stations up to which every pair is searched for where nothing says where they are
PLANE = TransformationEstimationPointToPlane()


@dataclass(frozen=True, eq=False)
class Scan:
    """A station's cloud as it is registered: thinned, with normals, in its level frame."""

    cloud: PointCloud
    radius: float


def prepare(cloud: PointCloud, size: float) -> Scan:
    """Points thinned to voxels, with normals of finer ones around them."""
    fine = cloud.thin(size / FINER)
    fine = fine.estimate_normals(radius=NORMAL_RADIUS * size, max_nn=NORMAL_NEIGHBORS)
    thinned = fine.thin(size)
    reach = np.sqrt((thinned.points**2).sum(axis=1))
    return Scan(thinned, float(np.quantile(reach, 0.9)) if len(reach) else 0.0)


class PairFinder:
    """Finds pairs among scans.

    Args:
        scans: The stations' clouds.
        size: Edge of the voxels [m].
        level: Whether poses between them turn about z alone.
        least: Share of the smaller cloud that lies on the other in a pair.
        seed: Of the search.
    """

    def __init__(self, scans: Sequence[Scan], size: float, level: bool, least: float, seed: Any):
        self.scans, self.size, self.least, self.seed = scans, size, least, seed
        self.free = LEVEL if level else None
        self.descriptions: dict[int, Description] = {}
        self.limit = LEAST_LIMIT * size  # the residual from which on a match counts nothing

    def candidates(self, poses: Array | None, positions: Array | None, rough: float) -> list[tuple[int, int]]:
        """Which pairs may overlap: (source, target)."""
        count = len(self.scans)
        pairs = [(j, i) for i, j in itertools.combinations(range(count), 2)]
        if positions is not None:
            apart = {(a, b): float(norm(positions[a] - positions[b])) for a, b in pairs}
            reach = {(a, b): self.scans[a].radius + self.scans[b].radius + rough for a, b in pairs}
            pairs = [pair for pair in pairs if not apart[pair] > reach[pair]]
        if poses is None and positions is None and count > ALL_PAIRS:
            raise ValueError(
                f"positions: {count} stations of which nothing says where they are make too many pairs to search; "
                f"give rough positions or poses, or at most {ALL_PAIRS}"
            )
        if poses is not None:
            reach = max(NEAR * self.size, min(rough, REACH * COARSE_TO_FINE[0] * self.size))
            pairs = [pair for pair in pairs if self._overlap(pair, poses, reach) >= self.least]
        return pairs

    def _overlap(self, pair: tuple[int, int], poses: Array, reach: float) -> float:
        a, b = pair
        X = matmul(invert_pose(poses[b]), poses[a])
        return evaluate_registration(self.scans[a].cloud, self.scans[b].cloud, reach, X).fitness

    def find(
        self, pairs: Sequence[tuple[int, int]], poses: Array | None, tell: Callable[[str, int, int], None]
    ) -> list[StationPair]:
        """The pairs registered; rejected ones have a reason."""
        starts, believed, kept = [], [], []
        for done, (a, b) in enumerate(pairs):
            tell("pairs", done, len(pairs))
            start, score = self._start(a, b, poses)
            if start is not None:
                starts.append(start)
                believed.append(score)
                kept.append((a, b))
        tell("pairs", len(pairs), len(pairs))
        return self._refined(kept, starts, believed)

    def _start(self, a: int, b: int, poses: Array | None) -> tuple[Array | None, float]:
        """A first pose of a pair: by ICP from the rough one; if that is rejected, by search."""
        source, target = self.scans[a].cloud, self.scans[b].cloud
        if poses is not None:
            sizes = [scale * self.size for scale in COARSE_TO_FINE]
            rules = [ICPConvergenceCriteria(max_iteration=50)] * len(sizes)
            init, held = matmul(invert_pose(poses[b]), poses[a]), {"free": self.free, "estimate_normals": True}
            found = multi_scale_icp(source, target, sizes, rules, [REACH * s for s in sizes], init, PLANE, **held)
            if self._rate(a, b, found.transformation, RATED_WITHIN * sizes[-1]) > SURE:
                return found.transformation, 1.0
        found = register_described(self._described(a), self._described(b), seed=self.seed, free=self.free)
        return (found.transformation, float(found.score)) if found.score else (None, 0.0)

    def _described(self, i: int) -> Description:
        if i not in self.descriptions:
            self.descriptions[i] = describe(self.scans[i].cloud, COARSE_TO_FINE[-1] * self.size)
        return self.descriptions[i]

    def _rate(self, a: int, b: int, T: Array, distance: float) -> float:
        return rate_registration(self.scans[a].cloud, self.scans[b].cloud, T, distance)

    def _refined(
        self,
        pairs: Sequence[tuple[int, int]],
        starts: Sequence[Array],
        believed: Sequence[float],
        limit: float | None = None,
    ) -> list[StationPair]:
        """All pairs refined in the same launches, from points to planes; from right poses where there is a limit."""
        if not pairs:
            return []
        sources, targets = ([self.scans[ends[k]].cloud for ends in pairs] for k in (0, 1))
        options: dict[str, Any] = {"free": self.free, "max_normal_angle": MOST_BENT}
        rules, poses, results = ICPConvergenceCriteria(max_iteration=60), np.array(starts), []
        if limit is None:
            for reach in (2 * REACH, REACH):
                results = registration_icp_batch(sources, targets, reach * self.size, poses, PLANE, rules, **options)
                poses = np.array([result.transformation for result in results])
            self.limit = self._limit(pairs, results)
        for wide in GRADED if limit is None else (1.0,):
            method = TransformationEstimationPointToPlane(TukeyLoss(wide * self.limit))
            results = registration_icp_batch(sources, targets, REACH * self.size, poses, method, rules, **options)
            poses = np.array([result.transformation for result in results])
        return [self._judged(*each, self.limit) for each in zip(pairs, results, believed, strict=True)]

    def again(self, pairs: Sequence[StationPair], poses: Array, placed: NDArray[np.bool_]) -> list[StationPair]:
        """The pairs registered from where an adjustment has put their stations, past minima that held them."""
        kept = [k for k, pair in enumerate(pairs) if placed[pair.source] and placed[pair.target] and pair.score > 0]
        ends = [(pairs[k].source, pairs[k].target) for k in kept]
        found = self._refined(
            ends, [matmul(invert_pose(poses[b]), poses[a]) for a, b in ends], [1.0] * len(kept), self.limit
        )
        renewed = dict(zip(kept, found, strict=True))
        return [renewed.get(k, pair) for k, pair in enumerate(pairs)]

    def _limit(self, pairs: Sequence[tuple[int, int]], results: Sequence[RegistrationResult]) -> float:
        """The residual [m] from which on a match counts nothing: edges, and what stood elsewhere."""
        sizes = [float(np.median(np.abs(self._rows(*each)[1]))) for each in zip(pairs, results, strict=True)
                 if len(each[1].correspondence_set)]  # fmt: skip
        return max(TUKEY * TO_DEVIATION * float(np.median(sizes)) if sizes else np.inf, LEAST_LIMIT * self.size)

    def _judged(self, pair: tuple[int, int], result: RegistrationResult, believed: float, limit: float) -> StationPair:
        a, b = pair
        X = result.transformation
        backwards = evaluate_registration(
            self.scans[b].cloud, self.scans[a].cloud, REACH * self.size, invert_pose(X)
        ).fitness
        overlap = max(result.fitness, backwards)
        if overlap < self.least:
            return StationPair(a, b, X, np.zeros((6, 6)), overlap, 0.0, 0.0, "no overlap")
        information, rms = self._information(pair, result, limit)
        score = min(believed, self._rate(a, b, X, RATED_WITHIN * self.size))
        reason = "" if score > SURE else "the surfaces hardly lie on each other, or elsewhere as well"
        if not reason and not information.any():
            reason = "too few places match to tell how well"
        return StationPair(a, b, X, information, overlap, rms, score, reason)

    def _information(self, pair: tuple[int, int], result: RegistrationResult, limit: float) -> tuple[Array, float]:
        """Of the misfit in the source's frame, and the root mean square of the residuals that count."""
        J, r, p = self._rows(pair, result)
        inside = np.abs(r) < limit
        J, r, p = J[inside], r[inside], p[inside]
        share = 1 - (r / limit) ** 2
        motions = [2, 3, 4, 5] if self.free else list(range(6))
        information = np.zeros((6, 6))
        information[np.ix_(motions, motions)] = _clustered(
            J[:, motions], share**2 * r, share * (5 * share - 4), p, BLOCK * self.size
        )
        return information, float(np.sqrt((r * r).mean())) if len(r) else 0.0

    def _rows(self, pair: tuple[int, int], result: RegistrationResult) -> tuple[Array, Array, Array]:
        """Derivatives of the matches' distances from planes, these distances, and where they are in the source."""
        a, b = pair
        source, target = self.scans[a].cloud, self.scans[b].cloud
        found = result.correspondence_set
        p, q = source.points[found[:, 0]], target.points[found[:, 1]]
        R, t = result.transformation[:3, :3], result.transformation[:3, 3]
        n = np.asarray(target.normals, np.float64)[found[:, 1]]
        r = (n * (np.einsum("ij,nj->ni", R, p) + t - q)).sum(axis=1)
        n = np.einsum("ji,nj->ni", R, n)
        return np.concatenate([np.asarray(np.cross(p, n), np.float64), n], axis=1), r, p


def _clustered(J: Array, pull: Array, stiffness: Array, places: Array, edge: float) -> Array:
    """The information of the unknowns of rows whose errors are alike within blocks of space; zeros for too few.

    Rows have Tukey's influence `pull`, and its derivative by the residual, `stiffness`.
    """
    size = J.shape[1]
    keys = np.floor(places / edge).astype(np.int64)
    _, block = np.unique(keys, axis=0, return_inverse=True)
    block = block.reshape(-1)
    count = int(block.max(initial=-1)) + 1
    if count < FEWEST_BLOCKS:
        return np.zeros((size, size))
    turns = size - 3
    radius = max(float(np.sqrt((places * places).sum(axis=1).mean())), 1e-9)
    unit = np.concatenate([np.full(turns, radius), np.ones(3)])
    J = J / unit
    N = np.einsum("ni,n,nj->ij", J, stiffness, J)
    pulls = np.stack([np.bincount(block, J[:, k] * pull, count) for k in range(size)], axis=1)
    values, vectors = eigh(N)
    known = values > OPEN * values[-1]
    V = vectors[:, known] / values[known]
    errors = np.einsum("bi,ik->bk", pulls, V)
    covariance = np.einsum("bi,bj->ij", errors, errors) * count / (count - size)
    information = matmul(vectors[:, known], inv(covariance), vectors[:, known].T)
    return information * unit[:, None] * unit[None]
