"""Options of the RGB-D odometry, and those with Open3D's names of `pointloom.open3d`."""

from __future__ import annotations

import dataclasses
import enum
from collections.abc import Sequence

from ...cameras.depth_range import DEPTH_MAX
from ...core.checks import check_count, check_list, check_positive

MAX_STEPS = 1000
MAX_LEVELS = 12


class OdometryMethod(enum.Enum):
    """Residuals of two frames: surfaces, brightness, or both."""

    PointToPlane = 0
    Intensity = 1
    Hybrid = 2


METHODS = {
    "hybrid": OdometryMethod.Hybrid,
    "intensity": OdometryMethod.Intensity,
    "point-to-plane": OdometryMethod.PointToPlane,
}


def check_method(method: str) -> OdometryMethod:
    """The method of a name."""
    if not isinstance(method, str) or method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    return METHODS[method]


def check_steps(name: str, steps: Sequence[int]) -> tuple[int, ...]:
    """Maximum steps per pyramid level."""
    listed = check_list(name, steps, "iteration counts")
    if not 1 <= len(listed) <= MAX_LEVELS:
        raise ValueError(f"{name}: expected 1 to {MAX_LEVELS} levels, got {len(listed)}")
    limit = {"maximum": MAX_STEPS, "because": "alignments that have not converged by then do not converge"}
    return tuple(check_count(name, step, minimum=0, **limit) for step in listed)


def check_depth_range(depth_min: float, depth_max: float) -> tuple[float, float]:
    """The depth range [m], of which the end may be infinite."""
    nearest = check_positive("depth_min", depth_min, allow_zero=True)
    farthest = check_positive("depth_max", depth_max, allow_infinite=True)
    if nearest >= farthest:
        raise ValueError(f"depth_min: expected less than depth_max, {depth_max}, got {depth_min}")
    return nearest, farthest


class RGBDOdometryJacobianFromColorTerm:
    """Brightness only (Steinbruecker, Sturm and Cremers 2011)."""

    def __repr__(self) -> str:
        return "RGBDOdometryJacobianFromColorTerm()"


class RGBDOdometryJacobianFromHybridTerm:
    """Brightness and surface (Park, Zhou and Koltun 2017)."""

    def __repr__(self) -> str:
        return "RGBDOdometryJacobianFromHybridTerm()"


@dataclasses.dataclass(frozen=True)
class OdometryOption:
    """Options of Open3D's `compute_rgbd_odometry`.

    Args:
        iteration_number_per_pyramid_level: Steps per level, the coarsest first.
        depth_diff_max: Maximum depth difference of a pixel pair [m].
        depth_min, depth_max: Valid depth range [m].

    Raises:
        ValueError, TypeError: A number is out of range.
    """

    iteration_number_per_pyramid_level: Sequence[int] = (20, 10, 5)
    depth_diff_max: float = 0.03
    depth_min: float = 0.0
    depth_max: float = DEPTH_MAX

    def __post_init__(self) -> None:
        name = "iteration_number_per_pyramid_level"
        object.__setattr__(self, name, check_steps(name, self.iteration_number_per_pyramid_level))
        check_positive("depth_diff_max", self.depth_diff_max)
        check_depth_range(self.depth_min, self.depth_max)


@dataclasses.dataclass(frozen=True)
class OdometryConvergenceCriteria:
    """Stopping criteria of a level of Open3D's `rgbd_odometry_multi_scale`.

    Args:
        max_iteration: Maximum number of steps.
        relative_rmse, relative_fitness: Relative changes below which a level ends.

    Raises:
        ValueError, TypeError: A number is out of range.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.rgbd.odometry.options import OdometryConvergenceCriteria
        >>> OdometryConvergenceCriteria(10).relative_rmse
        1e-06
    """

    max_iteration: int
    relative_rmse: float = 1e-6
    relative_fitness: float = 1e-6

    def __post_init__(self) -> None:
        reason = "alignments that have not converged by then do not converge"
        check_count("max_iteration", self.max_iteration, minimum=0, maximum=MAX_STEPS, because=reason)
        check_positive("relative_rmse", self.relative_rmse, allow_zero=True)
        check_positive("relative_fitness", self.relative_fitness, allow_zero=True)


@dataclasses.dataclass(frozen=True)
class OdometryLossParams:
    """Residual limits of Open3D's `rgbd_odometry_multi_scale`.

    Args:
        depth_outlier_trunc: Maximum depth residual [m].
        depth_huber_delta: Huber threshold of depth [m].
        intensity_huber_delta: Huber threshold of brightness, 0..1.

    Raises:
        ValueError, TypeError: A number is not positive.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.rgbd.odometry.options import OdometryLossParams
        >>> OdometryLossParams().depth_outlier_trunc
        0.07
    """

    depth_outlier_trunc: float = 0.07
    depth_huber_delta: float = 0.05
    intensity_huber_delta: float = 0.1

    def __post_init__(self) -> None:
        for field in dataclasses.fields(self):
            check_positive(field.name, getattr(self, field.name))
