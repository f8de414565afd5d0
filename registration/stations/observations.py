"""What is observed of stations: pairs of clouds that lie on each other, targets, control points."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_finite, check_list, check_numeric, check_positive, shown
from ...core.wording import few_of

Array = NDArray[np.float64]
TARGET_SIGMA = 0.002  # [m] of a coordinate of a target that a scanner measured
CONTROL_SIGMA = 0.002  # [m] of a coordinate of a control point
LEAST_SIGMA, MOST_SIGMA = 1e-9, 1e9  # [m], [rad]: what is known better is no observation, what worse none


@dataclass(frozen=True, eq=False)
class TargetObservation:
    """A target as one station saw it.

    Args:
        station: The number of the station, from 0.
        name: The target's, the same in all stations and in the control.
        position: Its middle [m] in the station's own coordinates, shape [3].
        sigma: Standard deviation of each coordinate [m].

    Raises:
        TypeError: A name that is no text, a station that is no number.
        ValueError: A position that is not finite or not [3], or a sigma that is not positive.

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
    """A target whose place in the survey's coordinates is known.

    Args:
        name: The target's.
        position: Where it is [m], shape [3].
        sigma: Standard deviation of its coordinates [m], one or [3].

    Raises:
        TypeError: A name that is no text.
        ValueError: A position that is not finite or not [3], or a sigma that is not positive.

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


def check_sigma(name: str, sigma: Any) -> float:
    """A standard deviation that a least squares adjustment can weigh by.

    Raises:
        TypeError, ValueError: No number, or out of range.
    """
    value = check_positive(name, sigma)
    if not LEAST_SIGMA <= value <= MOST_SIGMA:
        raise ValueError(f"{name}: expected a standard deviation from {LEAST_SIGMA:g} to {MOST_SIGMA:g}, got {value:g}")
    return value


def _check_point(point: Any) -> None:
    if not isinstance(point.name, str) or not point.name:
        raise TypeError(f"name: expected the target's name, got {shown(point.name)}")
    position = check_finite("position", check_numeric("position", point.position)).astype(np.float64)
    if position.shape != (3,):
        raise ValueError(f"position: expected shape [3], got {list(position.shape)}")
    object.__setattr__(point, "position", position)


@dataclass(frozen=True, eq=False)
class StationPair:
    """Two stations whose clouds lie on each other.

    Attributes:
        source, target: Their numbers.
        transformation: T_target_source, float64 [4, 4].
        information: Of the misfit of the pose, rotation [rad] then translation [m] in the source's coordinates, [6, 6];
            zeros along what the clouds do not determine, and along what was not free.
        fitness: Share of the source's points that lie on the target, 0..1.
        rms: Of the distances of the matched points from the target's surface [m].
        score: Confidence in the pose, 0..1.
        reason: Why it is not used, or "".
    """

    source: int
    target: int
    transformation: Array
    information: Array
    fitness: float = 1.0
    rms: float = 0.0
    score: float = 1.0
    reason: str = ""


def check_targets(targets: Sequence[TargetObservation] | None, count: int) -> list[TargetObservation]:
    """The observed targets, once each names one of `count` stations, and none a target twice.

    Raises:
        TypeError, ValueError: They do not; the message says which.
    """
    found = [] if targets is None else check_list("targets", targets, "TargetObservation")
    seen: set[tuple[int, str]] = set()
    for k, one in enumerate(found):
        if not isinstance(one, TargetObservation):
            raise TypeError(f"targets[{k}]: expected TargetObservation(station, name, position), got {shown(one)}")
        if one.station >= count:
            raise ValueError(f"targets[{k}]: expected a station from 0 to {count - 1}, got {one.station}")
        if (one.station, one.name) in seen:
            raise ValueError(
                f"targets[{k}]: station {one.station} has {one.name!r} twice; take the mean, or rename one"
            )
        seen.add((one.station, one.name))
    return found


def check_control(control: Sequence[ControlPoint] | None, targets: Sequence[TargetObservation]) -> list[ControlPoint]:
    """The control points, each name once, and at least one of them a target that was seen.

    Raises:
        TypeError, ValueError: Not so.
    """
    found = [] if control is None else check_list("control", control, "ControlPoint")
    names: set[str] = set()
    for k, one in enumerate(found):
        if not isinstance(one, ControlPoint):
            raise TypeError(f"control[{k}]: expected ControlPoint(name, position), got {shown(one)}")
        if one.name in names:
            raise ValueError(f"control[{k}]: {one.name!r} stands there twice")
        names.add(one.name)
    seen = {one.name for one in targets}
    if found and not names & seen:
        raise ValueError(
            f"control: none of {_listed(names)} was seen by a station; targets= has {_listed(seen)}. "
            "The same target has one name everywhere"
        )
    return found


def _listed(names: Iterable[str]) -> str:
    return few_of(sorted(names), 5) or "nothing"
