"""Many terrestrial scans brought into one frame: `register_stations`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any

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
from ...kernels.linear_algebra import elementwise, matmul, norm
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..rigid import about_up, invert_pose, make_pose, nearest_rotation
from ..voxel_size import choose_voxel_size
from .adjustment import Adjusted, Observed
from .first_poses import chain_links, links_of, onto_control, parts_by
from .loops import loops_of
from .observations import Array, ControlPoint, StationPair, TargetObservation, check_control, check_sigma, check_targets
from .pairs import PairFinder, prepare
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
