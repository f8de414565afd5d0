"""Observations of stations: pairs of overlapping clouds, targets, control points."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_finite, check_list, check_numeric, check_positive, shown
from ...core.reports import AssessedRecord
from ...core.wording import few_of
from ...kernels.linear_algebra import matmul, norm

Array = NDArray[np.float64]
TARGET_SIGMA = 0.002  # [m] default for scanned targets
CONTROL_SIGMA = 0.002  # [m] default for control points
MIN_SIGMA, MAX_SIGMA = 1e-9, 1e9  # [m], [rad] valid range
MAX_SCALE = 2.0  # ratio of distances between the same targets: 3.3 of feet, 1000 of millimeters; 1 with exchanged names
MAX_SCALE_SPREAD = 1.5  # of these ratios about their median: one unit has one ratio, wrong targets have many
UNIT_RATIOS = (3.2808, 12.0, 25.4, 30.48, 39.37, 100.0, 304.8, 1000.0)  # of m, cm, mm, inches and feet
UNIT_TOLERANCE = 0.02  # relative: the errors of a registration are below
MIN_COMMON = 3  # distances that show the unit
MIN_BASELINE = 20  # distance of stations in standard deviations of a target: its error is then 5%


@dataclass(frozen=True, eq=False)
class TargetObservation:
    """A target observed by one station.

    Args:
        station: Station number, from 0.
        name: Target name, the same in all stations and in the control.
        position: Center [m] in station coordinates, shape [3].
        sigma: Standard deviation of each coordinate [m].

    Raises:
        TypeError, ValueError: A wrong type, a position that is not finite or not [3], or a sigma that is not positive.

    Example:
        >>> import pointloom as loom
        >>> loom.registration.TargetObservation(0, "T1", [1.0, 2.0, 0.5]).sigma
        0.002
    """

    station: int
    name: str
    position: ArrayLike
    sigma: float = TARGET_SIGMA

    def __post_init__(self) -> None:
        object.__setattr__(self, "station", check_count("station", self.station, minimum=0))
        _check_point(self)
        object.__setattr__(self, "sigma", check_sigma("sigma", self.sigma))


@dataclass(frozen=True, eq=False)
class ControlPoint:
    """A target with known survey coordinates.

    Args:
        name: Target name.
        position: Coordinates [m], shape [3].
        sigma: Standard deviation of its coordinates [m], one or [3].

    Raises:
        TypeError, ValueError: A wrong type, a position that is not finite or not [3], or a sigma that is not positive.

    Example:
        >>> import pointloom as loom
        >>> loom.registration.ControlPoint("T1", [500_001.0, 5_400_002.0, 120.5], sigma=[0.003, 0.003, 0.005]).sigma
        array([0.003, 0.003, 0.005])
    """

    name: str
    position: ArrayLike
    sigma: ArrayLike = CONTROL_SIGMA

    def __post_init__(self) -> None:
        _check_point(self)
        values = check_finite("sigma", check_numeric("sigma", self.sigma)).astype(np.float64)
        if values.shape not in ((), (3,)):
            raise ValueError(f"sigma: expected one number or [3], got {shown(self.sigma)}")
        values = np.array([check_sigma("sigma", v) for v in (values.tolist() if values.ndim else [self.sigma])])
        object.__setattr__(self, "sigma", np.broadcast_to(values, (3,)).copy())


def check_sigma(name: str, sigma: object) -> float:
    value = check_positive(name, sigma)
    if not MIN_SIGMA <= value <= MAX_SIGMA:
        raise ValueError(f"{name}: expected a standard deviation from {MIN_SIGMA:g} to {MAX_SIGMA:g}, got {value:g}")
    return value


def _check_point(point: TargetObservation | ControlPoint) -> None:
    if not isinstance(point.name, str) or not point.name:
        raise TypeError(f"name: expected the target's name, got {shown(point.name)}")
    position = check_finite("position", check_numeric("position", point.position)).astype(np.float64)
    if position.shape != (3,):
        raise ValueError(f"position: expected shape [3], got {list(position.shape)}")
    object.__setattr__(point, "position", position)


@dataclass(frozen=True, eq=False)
class StationPair(AssessedRecord):
    """Registration of two overlapping stations.

    Attributes:
        source, target: Station numbers.
        transformation: T_target_source, float64 [4, 4].
        information: Of rotation [rad] then translation [m] in source coordinates, [6, 6]. Zero if undetermined or
            fixed.
        fitness: Fraction of source points on the target, 0..1.
        rms: Root mean square point-to-surface distance of the matches [m].
        score: Confidence, 0..1.
        warnings: Why the pair is rejected. Empty if it is used.
    """

    source: int
    target: int
    transformation: Array
    information: Array
    fitness: float = 1.0
    rms: float = 0.0
    score: float = 1.0
    warnings: tuple[str, ...] = ()


def check_targets(targets: Sequence[TargetObservation] | None, count: int) -> list[TargetObservation]:
    checked = [] if targets is None else check_list("targets", targets, "TargetObservation")
    observed: set[tuple[int, str]] = set()
    for k, one in enumerate(checked):
        if not isinstance(one, TargetObservation):
            raise TypeError(f"targets[{k}]: expected TargetObservation(station, name, position), got {shown(one)}")
        if one.station >= count:
            raise ValueError(f"targets[{k}]: expected a station from 0 to {count - 1}, got {one.station}")
        if (one.station, one.name) in observed:
            raise ValueError(f"targets[{k}]: station {one.station} has {one.name!r} twice; average them, or rename one")
        observed.add((one.station, one.name))
    stations = _positions_by_station(checked)
    scales = {k: _median_scale(one, [other for j, other in stations.items() if j != k]) for k, one in stations.items()}
    station = max(scales, key=lambda k: abs(math.log(scales[k])), default=None)
    if station is not None and abs(math.log(scales[station])) > math.log(MAX_SCALE):
        raise ValueError(
            f"targets: expected one unit, got distances at station {station} that are {scales[station]:.4g} times "
            "those of the same targets at other stations. Convert its positions to meters"
        )
    return checked


def _positions_by_station(targets: Sequence[TargetObservation]) -> dict[int, dict[str, Array]]:
    stations: dict[int, dict[str, Array]] = {}
    for one in targets:
        stations.setdefault(one.station, {})[one.name] = np.asarray(one.position)
    return stations


def _median_scale(one: dict[str, Array], others: Iterable[dict[str, Array]]) -> float:
    """Median ratio of the distances between the same targets, or 1 if they do not agree on a ratio."""
    scales = []
    for other in others:
        common = sorted(one.keys() & other.keys())
        if len(common) < MIN_COMMON:
            continue
        first, second = (np.array([positions[name] for name in common]) for positions in (one, other))
        lengths, known = (np.linalg.norm(points - points.mean(axis=0), axis=1) for points in (first, second))
        valid = (lengths > 0) & (known > 0)
        scale = _common_scale(np.log(lengths[valid]) - np.log(known[valid]))
        scales += [] if scale is None else [scale]
    return math.exp(float(np.median(scales))) if scales else 1.0


def check_scan_unit(targets: Sequence[TargetObservation], pairs: Sequence[StationPair]) -> None:
    """Compare the distances of stations by their targets with those by the registered scans. Raise `ValueError` if the
    targets have another unit."""
    by_station: dict[int, dict[str, TargetObservation]] = {}
    for one in targets:
        by_station.setdefault(one.station, {})[one.name] = one
    logs = []
    for pair in pairs:
        first, second = by_station.get(pair.source, {}), by_station.get(pair.target, {})
        known = norm(pair.transformation[:3, 3])
        for name in sorted(first.keys() & second.keys()):
            offset = np.asarray(second[name].position) - matmul(
                pair.transformation[:3, :3], np.asarray(first[name].position)
            )
            if known > MIN_BASELINE * first[name].sigma and offset.any():
                logs.append(math.log(norm(offset)) - math.log(known))
    scale = _common_scale(np.array(logs))
    # registered scans may be wrong, as in a repetitive corridor: only ratios of units are errors of the targets
    if scale is not None and any(abs(abs(scale) - math.log(ratio)) < UNIT_TOLERANCE for ratio in UNIT_RATIOS):
        raise ValueError(
            f"targets: expected the unit of the scans, got distances between stations that are {math.exp(scale):.4g} "
            "times those of the registered scans. Convert both to meters"
        )


def _common_scale(logs: Array) -> float | None:
    """The median logarithm of a scale. None if there are few, or if they do not agree."""
    if len(logs) < MIN_COMMON or np.median(np.abs(logs - np.median(logs))) > math.log(MAX_SCALE_SPREAD):
        return None
    return float(np.median(logs))


def check_control(control: Sequence[ControlPoint] | None, targets: Sequence[TargetObservation]) -> list[ControlPoint]:
    checked = [] if control is None else check_list("control", control, "ControlPoint")
    names: set[str] = set()
    for k, one in enumerate(checked):
        if not isinstance(one, ControlPoint):
            raise TypeError(f"control[{k}]: expected ControlPoint(name, position), got {shown(one)}")
        if one.name in names:
            raise ValueError(f"control[{k}]: {one.name!r} is duplicated")
        names.add(one.name)
    observed = {one.name for one in targets}
    if checked and not names & observed:
        raise ValueError(
            f"control: none of {_listed(names)} was observed by a station; targets= has {_listed(observed)}. "
            "Use one name for the same target everywhere"
        )
    scale = _median_scale(
        {one.name: np.asarray(one.position) for one in checked}, _positions_by_station(targets).values()
    )
    if abs(math.log(scale)) > math.log(MAX_SCALE):
        raise ValueError(
            f"control: expected the unit of the targets, got distances that are {scale:.4g} times those of the same "
            "targets at the stations. Convert both to meters"
        )
    return checked


def _listed(names: Iterable[str]) -> str:
    return few_of(sorted(names), 5) or "nothing"
