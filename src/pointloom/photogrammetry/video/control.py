"""Georeferencing of a model by ground control points and known lengths.

Marked points are triangulated and aligned by one weighted similarity without deformation of the model. Outliers are
removed and reported. Check points and GPS are only compared.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...core.reports import failed
from ...io.models.sfm_model import SfmModel
from ...pcd.geodesy import WorldFrame
from ...registration.rigid import fit_pose
from ...registration.stations.observations import ControlPoint
from ...registration.trajectories.weighted_similarity import Rows, UndeterminedError, WeightedFit, fit_rows
from ..sfm.image_positions import ImagePositions
from .control_blunders import MIN_TO_IDENTIFY, OUTLIER_DEVIATIONS, agreeing, deviations, residual_ratio
from .control_report import CHECK, CONTROL, UNUSED, ControlFit, ControlResidual, GpsGaps
from .control_systems import to_geodetic
from .georeference import NotSettledError, enu_of, positions_by_image
from .ground_control import MIN_POINTS, GroundControl, is_straight
from .marked_points import MarkedPoint, locate_marks
from .scale_bars import Bars, fit_bars

Array = NDArray[np.float64]

MAX_ITERATIONS = 4  # iterations of reweighting
MAX_FLOAT32_COORDINATE = 1e4  # [m] coordinates beyond this lose an origin, since meshes are float32
ORIGIN_STEP = 100.0  # [m] rounding of that origin
MIN_REPORTED_RATIO = 2.0  # ratio of actual to stated errors that is reported
MAX_GPS_SHIFT = 300.0  # [m] between control and GPS: larger than GNSS errors, smaller than wrong zones


@dataclass(frozen=True, eq=False)
class _Coordinates:
    frame: WorldFrame | None
    origin: Array
    targets: dict[str, Array]


def fit_control(model: SfmModel, control: GroundControl, image_positions: ImagePositions | None = None) -> ControlFit:
    located = locate_marks(model, control.marks)
    bars = Bars.of(control, located)
    used = [point for point in control.fitted if _position_of(point, located) is not None]
    reason = _why_open(control, used, located)
    if reason:
        if not bars.any:
            raise NotSettledError(reason)
        return _by_lengths(control, located, bars, reason)
    coordinates = _coordinates(control)
    try:
        return _by_points(model, control, located, used, coordinates, bars, image_positions)
    except UndeterminedError as error:
        raise NotSettledError(str(error)) from None


def _position_of(point: ControlPoint, located: dict[str, MarkedPoint]) -> Array | None:
    return located[point.name].position if point.name in located else None


def _why_open(control: GroundControl, used: list[ControlPoint], located: dict[str, MarkedPoint]) -> str:
    lost = [f"{p.name}: {_why_lost(p, located)}" for p in control.fitted if _position_of(p, located) is None]
    details = f" ({'; '.join(lost)})" if lost else ""
    if len(used) < MIN_POINTS:
        return (
            f"{len(used)} of {len(control.fitted)} control points can be used{details}; {MIN_POINTS} or more that "
            "are not collinear determine scale, rotation and position: mark more of them in registered images"
        )
    known, estimated = [p.position for p in used], [_position_of(p, located) for p in used]
    if is_straight(np.array(known)) or is_straight(np.array(estimated)):
        names = ", ".join(p.name for p in used)
        return f"the control points {names} are collinear, so a rotation is undetermined{details}; add one off the line"
    return ""


def _why_lost(point: ControlPoint, located: dict[str, MarkedPoint]) -> str:
    return located[point.name].reason if point.name in located else "no image has a mark of it; mark it in two or more"


def _coordinates(control: GroundControl) -> _Coordinates:
    positions, names = control.positions, [point.name for point in control.points]
    fitted = [name not in control.checks for name in names]
    if not control.crs:
        middle = np.median(positions[fitted], axis=0)
        origin = (
            np.round(middle / ORIGIN_STEP) * ORIGIN_STEP
            if np.abs(positions).max() > MAX_FLOAT32_COORDINATE
            else np.zeros(3)
        )
        return _Coordinates(None, origin, dict(zip(names, positions - origin, strict=True)))
    positions = to_geodetic(positions, control.crs, control.path)
    first_longitude = positions[0, 1]
    # wraps around the date line
    positions[:, 1] = first_longitude + (positions[:, 1] - first_longitude + 180) % 360 - 180
    latitude, longitude, height = np.median(positions[fitted], axis=0).tolist()
    frame = WorldFrame(latitude, (longitude + 180) % 360 - 180, height)
    return _Coordinates(frame, np.zeros(3), dict(zip(names, frame.to_enu(positions), strict=True)))


def _by_points(
    model: SfmModel, control: GroundControl, located: dict[str, MarkedPoint], used: list[ControlPoint],
    coordinates: _Coordinates, bars: Bars, image_positions: ImagePositions | None,
) -> ControlFit:  # fmt: skip
    source = np.array([_position_of(p, located) for p in used])
    target = np.array([coordinates.targets[p.name] for p in used])
    fit, inliers, sigma = _fitted(used, located, source, target)
    bars = bars.agreeing(fit.T)
    fit = fit_rows(Rows(source[inliers], target[inliers], sigma[inliers], lengths=bars.rows(fit.T)), fit.T)
    worse = residual_ratio(fit, source[inliers], target[inliers], sigma[inliers])
    fit = replace(fit, covariance=fit.covariance * max(worse, 1.0) ** 2)
    wrong = {point.name for point, fits in zip(used, inliers, strict=True) if not fits}
    rows = tuple(
        _residual(p, located, coordinates.targets[p.name], fit, p.name in control.checks, wrong) for p in control.points
    )
    gps = None
    if coordinates.frame is not None and image_positions is not None:
        gps = _gaps(model, image_positions, coordinates.frame, fit.T)
    problems = [_why_wrong(rows, wrong), _why_off(rows, worse, len(used)), _why_checks_contradict(rows)]
    problems += [bars.problem(fit.T), bars.problem_of_checks(fit.T), _why_far(gps, control)]
    notes = (_off(rows, worse),) if MIN_REPORTED_RATIO < worse <= OUTLIER_DEVIATIONS else ()
    sigmas = np.sqrt(np.diag(fit.covariance))
    tilt, yaw = math.degrees(float(sigmas[1:3].max())), math.degrees(float(sigmas[3]))
    return ControlFit(
        coordinates.frame, control.crs, coordinates.origin, fit.T, fit.scale, float(sigmas[0]), tilt, yaw, worse,
        rows, bars.residuals(fit.T), True, gps, failed(*problems), notes,
    )  # fmt: skip


def _fitted(
    used: list[ControlPoint], located: dict[str, MarkedPoint], source: Array, target: Array
) -> tuple[WeightedFit, NDArray[np.bool_], Array]:
    T = fit_pose(source, target, with_scaling=True)
    inliers = agreeing(source, target, _sigmas(used, located, T))
    T = fit_pose(source[inliers], target[inliers], with_scaling=True)
    inliers = agreeing(source, target, _sigmas(used, located, T))  # with weights from inliers only
    sigma = _sigmas(used, located, T)
    fit = fit_rows(Rows(source[inliers], target[inliers], sigma[inliers]), T)
    for _ in range(MAX_ITERATIONS - 1):
        sigma = _sigmas(used, located, fit.T)
        fit = fit_rows(Rows(source[inliers], target[inliers], sigma[inliers]), fit.T)
    return fit, inliers, sigma


def _sigmas(points: list[ControlPoint], located: dict[str, MarkedPoint], T: Array) -> Array:
    """Standard deviations of each coordinate, from the known position and the triangulation."""
    M = T[:3, :3]
    of_marks = [np.diag(M @ located[point.name].covariance @ M.T) for point in points]
    return np.sqrt(np.array([np.asarray(point.sigma) for point in points]) ** 2 + np.array(of_marks))


def _residual(
    point: ControlPoint,
    located: dict[str, MarkedPoint],
    target: Array,
    fit: WeightedFit,
    is_check: bool,
    wrong: set[str],
) -> ControlResidual:
    position = _position_of(point, located)
    if position is None:
        return ControlResidual(point.name, UNUSED, None, None, math.nan, 0, (_why_lost(point, located),))
    marked = located[point.name]
    use = CHECK if is_check else UNUSED if point.name in wrong else CONTROL
    known = _sigmas([point], located, fit.T)
    spread = np.diag(fit.covariance_of(position[None])[0])
    sigma = np.sqrt(np.maximum(known[0] ** 2 + (-spread if use == CONTROL else spread), 0))
    warnings = [f"without the marks in {', '.join(marked.left_out)}"] if marked.left_out else []
    off = float(deviations(fit, position[None], target[None], known)[0])
    contradicts = use == UNUSED or (is_check and off > OUTLIER_DEVIATIONS)
    if use == UNUSED:
        warnings.append(f"contradicts the others, {off:.0f} standard deviations off")
    elif contradicts:
        warnings.append(f"{off:.0f} standard deviations off")
    gap = fit.of(position[None])[0] - target
    views = len(marked.errors)
    return ControlResidual(point.name, use, gap, sigma, marked.rms, views, tuple(warnings), contradicts)


def _why_wrong(rows: tuple[ControlResidual, ...], wrong: set[str]) -> str:
    if not wrong:
        return ""
    details = ", ".join(f"{row.name} by {np.linalg.norm(row.residual):.3g} m" for row in rows if row.name in wrong)  # pyright: ignore[reportArgumentType, reportCallIssue]
    return f"control points contradict the others and were excluded, {details}: check their coordinates and marks"


def _why_checks_contradict(rows: tuple[ControlResidual, ...]) -> str:
    far = [row for row in rows if row.use == CHECK and row.contradicts]
    if not far:
        return ""
    details = ", ".join(f"{row.name} by {np.linalg.norm(row.residual):.3g} m" for row in far)  # pyright: ignore[reportArgumentType, reportCallIssue]
    return f"check points contradict the model, {details}: check their coordinates and marks, and the control points"


def _off(rows: tuple[ControlResidual, ...], worse: float) -> str:
    used = [(float(np.linalg.norm(row.residual)), row.name) for row in rows if row.use == CONTROL]  # pyright: ignore[reportArgumentType, reportCallIssue]
    largest, name = max(used)
    return f"the residuals of the control points are {worse:.1f} times the stated accuracy, {name} {largest:.3g} m"


def _why_off(rows: tuple[ControlResidual, ...], worse: float, count: int) -> str:
    """Whether the used points contradict each other without a clear outlier."""
    if not worse > OUTLIER_DEVIATIONS:
        return ""
    more = f"; with {MIN_TO_IDENTIFY} or more points the wrong one can be identified" if count < MIN_TO_IDENTIFY else ""
    return f"{_off(rows, worse)}: one is wrong, or the model is deformed; check coordinates and marks{more}"


def _gaps(model: SfmModel, image_positions: ImagePositions, frame: WorldFrame, T: Array) -> GpsGaps | None:
    known = positions_by_image(image_positions, model.names)
    names = tuple(name for name in model.names if name in known)
    if not names:
        return None
    estimated = model.centers[[model.index_of(name) for name in names]] @ T[:3, :3].T + T[:3, 3]
    return GpsGaps(names, estimated - enu_of(frame, [known[name] for name in names]))


def _why_far(gps: GpsGaps | None, control: GroundControl) -> str:
    if gps is None or not (far := float(np.linalg.norm(gps.shift[:2]))) > MAX_GPS_SHIFT:
        return ""
    return (
        f"the control points are {far / 1000:.4g} km from the GPS positions of the images: check the "
        f"coordinate system {control.crs}, and which of x and y is east"
    )


def _by_lengths(control: GroundControl, located: dict[str, MarkedPoint], bars: Bars, reason: str) -> ControlFit:
    T, sigma, bars = fit_bars(bars)
    alone = "scale bars determine the scale only"
    rows = tuple(
        ControlResidual(
            p.name,
            UNUSED,
            None,
            None,
            math.nan,
            0,
            (_why_lost(p, located) if _position_of(p, located) is None else alone,),
        )
        for p in control.points
    )
    problems = [reason if control.fitted and not control.why_open() else ""]
    problems += [bars.problem(T), bars.problem_of_checks(T)]
    notes = (f"the points are not used: {control.why_open()}",) if control.fitted and control.why_open() else ()
    return ControlFit(
        None, control.crs, np.zeros(3), T, float(T[0, 0]), sigma, math.nan, math.nan, math.nan, rows, bars.residuals(T),
        False, None, failed(*problems), notes,
    )  # fmt: skip
