"""Observations of stations: pairs of overlapping clouds, targets, control points."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_finite, check_list, check_numeric, check_positive, shown
from ...core.reports import AssessedRecord
from ...core.wording import few_of

Array = NDArray[np.float64]
TARGET_SIGMA = 0.002  # [m] default for scanned targets
CONTROL_SIGMA = 0.002  # [m] default for control points
MIN_SIGMA, MAX_SIGMA = 1e-9, 1e9  # [m], [rad] valid range


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
    return checked


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
    return checked


def _listed(names: Iterable[str]) -> str:
    return few_of(sorted(names), 5) or "nothing"
