"""Georeferencing of a model by ground control points and known lengths.

Marked points are triangulated and aligned by one weighted similarity without deformation of the model; outliers are
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
from ..sfm.image_positions import PicturePlaces
from .control_blunders import MIN_TO_TELL, ROUGH, agreeing, deviations, misfit
from .control_report import CHECK, CONTROL, UNUSED, ControlFit, ControlResidual, GpsGaps
from .control_systems import to_geodetic
from .georeference import NotSettledError, enu_of, places_of
from .ground_control import FEWEST, GroundControl, is_straight
from .marked_points import MarkedPoint, locate_marks
from .scale_bars import Bars, fit_bars

Array = NDArray[np.float64]

TURNS = 4  # iterations of reweighting
LARGE = 1e4  # [m] coordinates beyond this lose an origin, since meshes are float32
ROUND = 100.0  # [m] rounding of that origin
TOLD = 2.0  # ratio of actual to stated errors that is reported
FAR = 300.0  # [m] between control and GPS: larger than GNSS errors, smaller than wrong zones


@dataclass(frozen=True, eq=False)
class _Coordinates:
    frame: WorldFrame | None
    origin: Array
    targets: dict[str, Array]


def fit_control(model: SfmModel, control: GroundControl, places: PicturePlaces | None = None) -> ControlFit:
    found = locate_marks(model, control.marks)
    bars = Bars.of(control, found)
    used = [point for point in control.fitted if _place_of(point, found) is not None]
    reason = _why_open(control, used, found)
    if reason:
        if not bars.any:
            raise NotSettledError(reason)
        return _by_lengths(control, found, bars, reason)
    coordinates = _coordinates(control)
    try:
        return _by_points(model, control, found, used, coordinates, bars, places)
    except UndeterminedError as error:
        raise NotSettledError(str(error)) from None


def _place_of(point: ControlPoint, found: dict[str, MarkedPoint]) -> Array | None:
    return found[point.name].place if point.name in found else None


def _why_open(control: GroundControl, used: list[ControlPoint], found: dict[str, MarkedPoint]) -> str:
    lost = [f"{p.name}: {_why_lost(p, found)}" for p in control.fitted if _place_of(p, found) is None]
    told = f" ({'; '.join(lost)})" if lost else ""
    if len(used) < FEWEST:
        return (
            f"{len(used)} of {len(control.fitted)} control points can be used{told}; {FEWEST} or more that are not on "
            "a line settle size, turn and place: mark more of them, in pictures that are placed"
        )
    if is_straight(np.array([p.position for p in used])) or is_straight(np.array([_place_of(p, found) for p in used])):
        names = ", ".join(p.name for p in used)
        return f"the control points {names} lie on a line and leave a turn about it open{told}; add one beside it"
    return ""


def _why_lost(point: ControlPoint, found: dict[str, MarkedPoint]) -> str:
    return found[point.name].reason if point.name in found else "no picture shows it; mark it in two or more"


def _coordinates(control: GroundControl) -> _Coordinates:
    places, names = control.positions, [point.name for point in control.points]
    fitted = [name not in control.checks for name in names]
    if not control.crs:
        middle = np.median(places[fitted], axis=0)
        origin = np.round(middle / ROUND) * ROUND if np.abs(places).max() > LARGE else np.zeros(3)
        return _Coordinates(None, origin, dict(zip(names, places - origin, strict=True)))
    places = to_geodetic(places, control.crs, control.path)
    turn = places[0, 1]
    places[:, 1] = turn + (places[:, 1] - turn + 180) % 360 - 180  # wraps around the date line
    latitude, longitude, height = np.median(places[fitted], axis=0).tolist()
    frame = WorldFrame(latitude, (longitude + 180) % 360 - 180, height)
    return _Coordinates(frame, np.zeros(3), dict(zip(names, frame.to_enu(places), strict=True)))


def _by_points(
    model: SfmModel, control: GroundControl, found: dict[str, MarkedPoint], used: list[ControlPoint],
    coordinates: _Coordinates, bars: Bars, places: PicturePlaces | None,
) -> ControlFit:  # fmt: skip
    source = np.array([_place_of(p, found) for p in used])
    target = np.array([coordinates.targets[p.name] for p in used])
    fit, kept, sigma = _fitted(used, found, source, target)
    bars = bars.agreeing(fit.T)
    fit = fit_rows(Rows(source[kept], target[kept], sigma[kept], lengths=bars.rows(fit.T)), fit.T)
    worse = misfit(fit, source[kept], target[kept], sigma[kept])
    fit = replace(fit, covariance=fit.covariance * max(worse, 1.0) ** 2)
    wrong = {point.name for point, fits in zip(used, kept, strict=True) if not fits}
    rows = tuple(
        _residual(p, found, coordinates.targets[p.name], fit, p.name in control.checks, wrong) for p in control.points
    )
    gps = None if coordinates.frame is None or places is None else _gaps(model, places, coordinates.frame, fit.T)
    problems = [_why_wrong(rows, wrong), _why_off(rows, worse, len(used)), bars.problem(fit.T), _why_far(gps, control)]
    notes = (_off(rows, worse),) if TOLD < worse <= ROUGH else ()
    sigmas = np.sqrt(np.diag(fit.covariance))
    tilt, yaw = math.degrees(float(sigmas[1:3].max())), math.degrees(float(sigmas[3]))
    return ControlFit(
        coordinates.frame, control.crs, coordinates.origin, fit.T, fit.scale, float(sigmas[0]), tilt, yaw, worse,
        rows, bars.residuals(fit.T), True, gps, failed(*problems), notes,
    )  # fmt: skip


def _fitted(
    used: list[ControlPoint], found: dict[str, MarkedPoint], source: Array, target: Array
) -> tuple[WeightedFit, NDArray[np.bool_], Array]:
    T = fit_pose(source, target, with_scaling=True)
    kept = agreeing(source, target, _sigmas(used, found, T))
    T = fit_pose(source[kept], target[kept], with_scaling=True)
    kept = agreeing(source, target, _sigmas(used, found, T))  # with weights from inliers only
    sigma = _sigmas(used, found, T)
    fit = fit_rows(Rows(source[kept], target[kept], sigma[kept]), T)
    for _ in range(TURNS - 1):
        sigma = _sigmas(used, found, fit.T)
        fit = fit_rows(Rows(source[kept], target[kept], sigma[kept]), fit.T)
    return fit, kept, sigma


def _sigmas(points: list[ControlPoint], found: dict[str, MarkedPoint], T: Array) -> Array:
    """Standard deviations of each coordinate, from the known position and the triangulation."""
    M = T[:3, :3]
    of_marks = [np.diag(M @ found[point.name].covariance @ M.T) for point in points]
    return np.sqrt(np.array([np.asarray(point.sigma) for point in points]) ** 2 + np.array(of_marks))


def _residual(
    point: ControlPoint, found: dict[str, MarkedPoint], target: Array, fit: WeightedFit, is_check: bool, wrong: set[str]
) -> ControlResidual:
    place = _place_of(point, found)
    if place is None:
        return ControlResidual(point.name, UNUSED, None, None, math.nan, 0, (_why_lost(point, found),))
    marked = found[point.name]
    use = CHECK if is_check else UNUSED if point.name in wrong else CONTROL
    known = _sigmas([point], found, fit.T)
    spread = np.diag(fit.covariance_of(place[None])[0])
    sigma = np.sqrt(np.maximum(known[0] ** 2 + (-spread if use == CONTROL else spread), 0))
    warnings = [f"without the marks in {', '.join(marked.left_out)}"] if marked.left_out else []
    off = float(deviations(fit, place[None], target[None], known)[0])
    if use == UNUSED:
        warnings.append(f"contradicts the others, {off:.0f} standard deviations off")
    elif is_check and off > ROUGH:
        warnings.append(f"{off:.0f} standard deviations off")
    return ControlResidual(
        point.name, use, fit.of(place[None])[0] - target, sigma, marked.rms, len(marked.errors), tuple(warnings)
    )


def _why_wrong(rows: tuple[ControlResidual, ...], wrong: set[str]) -> str:
    if not wrong:
        return ""
    told = ", ".join(f"{row.name} by {np.linalg.norm(row.residual):.3g} m" for row in rows if row.name in wrong)  # pyright: ignore[reportArgumentType, reportCallIssue]
    return f"control points contradict the others and were left out, {told}: check their coordinates and marks"


def _off(rows: tuple[ControlResidual, ...], worse: float) -> str:
    used = [(float(np.linalg.norm(row.residual)), row.name) for row in rows if row.use == CONTROL]  # pyright: ignore[reportArgumentType, reportCallIssue]
    most, name = max(used)
    return f"the control points are {worse:.1f} times farther off than they are told to be sure, {name} by {most:.3g} m"


def _why_off(rows: tuple[ControlResidual, ...], worse: float, count: int) -> str:
    """Whether the used points contradict each other without a clear outlier."""
    if not worse > ROUGH:
        return ""
    more = f"; {MIN_TO_TELL} or more points tell which is wrong" if count < MIN_TO_TELL else ""
    return f"{_off(rows, worse)}: one is wrong, or the model is bent; check coordinates and marks{more}"


def _gaps(model: SfmModel, places: PicturePlaces, frame: WorldFrame, T: Array) -> GpsGaps | None:
    told = places_of(places, model.names)
    names = tuple(name for name in model.names if name in told)
    if not names:
        return None
    found = model.centers[[model.index_of(name) for name in names]] @ T[:3, :3].T + T[:3, 3]
    return GpsGaps(names, found - enu_of(frame, [told[name] for name in names]))


def _why_far(gps: GpsGaps | None, control: GroundControl) -> str:
    if gps is None or not (far := float(np.linalg.norm(gps.shift[:2]))) > FAR:
        return ""
    return (
        f"the control points lie {far / 1000:.4g} km from where GPS says that the pictures were taken: check the "
        f"coordinate system {control.crs}, and which of x and y is east"
    )


def _by_lengths(control: GroundControl, found: dict[str, MarkedPoint], bars: Bars, reason: str) -> ControlFit:
    T, sigma, bars = fit_bars(bars)
    alone = "scale bars set the size alone"
    rows = tuple(
        ControlResidual(
            p.name, UNUSED, None, None, math.nan, 0, (_why_lost(p, found) if _place_of(p, found) is None else alone,)
        )
        for p in control.points
    )
    problems = [reason if control.fitted and not control.why_open() else "", bars.problem(T)]
    notes = (f"the points are not used: {control.why_open()}",) if control.fitted and control.why_open() else ()
    return ControlFit(
        None, control.crs, np.zeros(3), T, float(T[0, 0]), sigma, math.nan, math.nan, math.nan, rows, bars.residuals(T),
        False, None, failed(*problems), notes,
    )  # fmt: skip
