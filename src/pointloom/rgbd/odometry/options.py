"""Options of the RGB-D odometry with Open3D's names."""

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
    """Options of `compute_rgbd_odometry` with Open3D's fields and defaults.

    Args:
        iteration_number_per_pyramid_level: Maximum steps per level, the coarsest first. Further levels repeat the first
            number. Exact numbers of steps and levels with `weights="open3d"`.
        depth_diff_max: Maximum depth difference of a pixel pair [m] with `weights="open3d"`. Otherwise by the noise.
        depth_min, depth_max: Valid depth range [m].

    Raises:
        ValueError, TypeError: A number is out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.rgbd.OdometryOption(depth_max=3.0).iteration_number_per_pyramid_level
        (20, 10, 5)
    """

    iteration_number_per_pyramid_level: Sequence[int] = (20, 10, 5)
    depth_diff_max: float = 0.03
    depth_min: float = 0.0
    depth_max: float = DEPTH_MAX

    def __post_init__(self) -> None:
        name = "iteration_number_per_pyramid_level"
        steps = check_list(name, self.iteration_number_per_pyramid_level, "iteration counts")
        if not 1 <= len(steps) <= MAX_LEVELS:
            raise ValueError(f"{name}: expected 1 to {MAX_LEVELS} levels, got {len(steps)}")
        reason = "alignments that have not converged by then do not converge"
        limit = {"maximum": MAX_STEPS, "because": reason}
        object.__setattr__(self, name, tuple(check_count(name, step, minimum=0, **limit) for step in steps))
        check_positive("depth_diff_max", self.depth_diff_max)
        check_positive("depth_min", self.depth_min, allow_zero=True)
        check_positive("depth_max", self.depth_max, allow_infinite=True)
        if self.depth_min >= self.depth_max:
            raise ValueError(f"depth_min: expected less than depth_max, {self.depth_max}, got {self.depth_min}")


@dataclasses.dataclass(frozen=True)
class OdometryConvergenceCriteria:
    """Stopping criteria of a level of `rgbd_odometry_multi_scale`.

    Args:
        max_iteration: Maximum number of steps.
        relative_rmse, relative_fitness: Relative changes below which a level ends with `weights="open3d"`. Otherwise it
            ends when a step moves pixels by less than 0.03 px.

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
    """Residual limits for `weights="open3d"`. Otherwise they follow the frame noise.

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
