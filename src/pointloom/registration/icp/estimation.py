"""Transformation estimators of the ICP family."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, ClassVar, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from ...core.checks import check_count, check_fraction, check_positive, check_rigid
from ...kernels.icp.loop import RegistrationLoop
from ...kernels.icp.matches import PointColumns
from ...kernels.icp.rows import (
    DopplerRule,
    sum_colored_rows,
    sum_doppler_rows,
    sum_generalized_rows,
    sum_plane_rows,
    sum_point_rows,
    sum_symmetric_rows,
)
from ...kernels.icp.step import FIT_PAIRS, FIT_SYMMETRIC, GAUSS_NEWTON
from ...pcd.cloud import PointCloud
from ..robust_kernels import Geometry, L2Loss, RobustKernel
from .preparation import colored_source, colored_target, doppler_measurements, generalized_covariances, normals_of

Columns = dict[str, list[wp.array]]  # per attribute, a device array for each cloud
MIN_SQUARES = L2Loss()


@dataclasses.dataclass(frozen=True)
class TransformationEstimation:
    """An estimator of ICP, which computes a pose from pairs: the base class of the estimators.

    As in Open3D, a kernel may be the only argument: `TransformationEstimationForColoredICP(TukeyLoss(0.1))`.

    Raises:
        TypeError: `kernel` is not a kernel.

    Example:
        >>> import pointloom as loom
        >>> reg = loom.registration
        >>> reg.TransformationEstimationPointToPlane(reg.TukeyLoss(0.1)).kernel.k
        0.1
    """

    _internal: ClassVar[tuple[str, ...]] = (
        "arguments", "constrainable", "flattens_covariances", "geometry", "in_sensor_frame", "method", "needs_colors",
        "needs_normals", "prepare", "residual_count", "rows", "scales",
    )  # fmt: skip
    rows: ClassVar[Any]
    method: ClassVar[int] = GAUSS_NEWTON
    residual_count: ClassVar[int] = 1  # rows per pair
    constrainable: ClassVar[bool] = True  # True if motions may be fixed or have a prior
    needs_normals: ClassVar[tuple[str, ...]] = ()  # "source", "target"
    needs_colors: ClassVar[bool] = False  # both clouds
    in_sensor_frame: ClassVar[bool] = False  # True if the coordinate origin must be the sensor

    def __post_init__(self) -> None:
        names = [field.name for field in dataclasses.fields(self)]
        only = getattr(self, names[0]) if names else None
        if isinstance(only, RobustKernel) and names[0] != "kernel" and getattr(self, "kernel", None) == MIN_SQUARES:
            object.__setattr__(self, "kernel", only)
            object.__setattr__(self, names[0], getattr(type(self), names[0]))  # its default
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            if field.name.endswith("kernel") and not isinstance(value, RobustKernel):
                raise TypeError(f"{field.name}: expected a robust kernel such as TukeyLoss(0.1), got {value!r}")

    @property
    def scales(self) -> bool:
        """True if the pose may include a scale."""
        return False

    @property
    def _target_voxel_size(self) -> float | None:
        return None

    def geometry(self) -> Self | None:
        """The estimator that determines degenerate motions, with equal weights; None: this one."""
        kernels = [f.name for f in dataclasses.fields(self) if f.name.endswith("kernel")]
        robust = [name for name in kernels if getattr(self, name) != MIN_SQUARES]
        return dataclasses.replace(self, **dict.fromkeys(robust, MIN_SQUARES)) if robust else None

    def _source_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        return {}

    def _target_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        return {}

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """Kernel arguments after the common ones."""
        raise NotImplementedError

    def prepare(self, loop: RegistrationLoop) -> None:
        """Launches of each iteration before the rows."""


@dataclasses.dataclass(frozen=True)
class TransformationEstimationPointToPoint(TransformationEstimation):
    """Minimize squared point distances in closed form (Horn 1987). With scale as Umeyama 1991.

    Args:
        with_scaling: Estimate a scale.
        kernel: Weighs pairs by their distance [m]. Open3D has none here.
    """

    with_scaling: bool = False
    kernel: RobustKernel = MIN_SQUARES
    rows = sum_point_rows
    method = FIT_PAIRS
    residual_count = 3

    @property
    def scales(self) -> bool:
        """True if the pose may include a scale."""
        return self.with_scaling

    def geometry(self) -> Self | None:
        """None: degeneracy follows from the point positions."""
        return None

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """The kernel and the pivots of the sums."""
        return [self.kernel.loss, loop.progress.pivots]


@dataclasses.dataclass(frozen=True)
class TransformationEstimationPointToPlane(TransformationEstimation):
    """Minimize squared distances of source points from the target planes (Chen and Medioni 1991).

    Args:
        kernel: Weighs pairs by that distance [m].
    """

    kernel: RobustKernel = MIN_SQUARES
    rows = sum_plane_rows
    needs_normals = ("target",)

    def _target_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        return {"normals": normals_of(clouds, names, "point-to-plane ICP")}

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """The kernel and the normals."""
        return [self.kernel.loss, target]


@dataclasses.dataclass(frozen=True)
class TransformationEstimationSymmetric(TransformationEstimation):
    """Symmetric point-to-plane ICP (Rusinkiewicz 2019): exact on spheres, fewer steps.

    Args:
        kernel: Weighs pairs by (p - q) . (n_p + n_q), about twice a distance [m].
    """

    kernel: RobustKernel = MIN_SQUARES
    rows = sum_symmetric_rows
    method = FIT_SYMMETRIC
    constrainable = False  # half of each rotation applies to the target
    needs_normals = ("source", "target")

    def _source_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        return {"normals": normals_of(clouds, names, "symmetric ICP")}

    _target_columns = _source_columns

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """The kernel and both normals."""
        return [self.kernel.loss, source, target]


@dataclasses.dataclass(frozen=True)
class TransformationEstimationForGeneralizedICP(TransformationEstimation):
    """Generalized ICP: plane-to-plane with thin Gaussians (Segal, Haehnel and Thrun 2009).

    Planes are those of the cloud's covariances (across their smallest variance) if present, else of its normals, else
    of 20 neighbors.

    Args:
        epsilon: Variance across a plane, relative to 1 along it.
        kernel: Weighs each of the three rows of a pair by its dimensionless residual.
        voxel_size: Match to Gaussians of target voxels of this edge [m] instead of points (Koide et al. 2021): faster,
            without search. Open3D has no such form.
    """

    epsilon: float = 1e-3
    kernel: RobustKernel = MIN_SQUARES
    voxel_size: float | None = None
    rows = sum_generalized_rows
    residual_count = 3
    flattens_covariances: ClassVar[bool] = True  # False as in Open3D: given covariances are used as they are

    def __post_init__(self) -> None:
        super().__post_init__()
        check_positive("epsilon", self.epsilon)
        if self.voxel_size is not None:
            check_positive("voxel_size", self.voxel_size)

    @property
    def _target_voxel_size(self) -> float | None:
        return self.voxel_size

    def geometry(self) -> Self:
        """Equal weights without the information along planes, which exists on any surface."""
        return dataclasses.replace(self, kernel=Geometry())

    def _source_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        pairs, flat = zip(clouds, names, strict=True), self.flattens_covariances
        return {"covariances": [generalized_covariances(c, self.epsilon, n, flatten=flat) for c, n in pairs]}

    _target_columns = _source_columns

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """The kernel and both covariances."""
        return [self.kernel.loss, source, target]


@dataclasses.dataclass(frozen=True)
class TransformationEstimationForColoredICP(TransformationEstimation):
    """Colored ICP: point-to-plane and photometric terms (Park, Zhou and Koltun 2017).

    Args:
        lambda_geometric: Weight of the geometric term, 0..1.
        kernel: Weighs the geometric and the photometric row of a pair, each by its residual.

    Raises:
        ValueError: A weight outside 0..1 (Open3D silently uses its default).
    """

    lambda_geometric: float = 0.968
    kernel: RobustKernel = MIN_SQUARES
    rows = sum_colored_rows
    residual_count = 2
    needs_normals = ("target",)
    needs_colors = True

    def __post_init__(self) -> None:
        super().__post_init__()
        check_fraction("lambda_geometric", self.lambda_geometric)

    def _source_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        intensities = [colored_source(c, n) for c, n in zip(clouds, names, strict=True)]
        return {"intensities": [values.reshape((values.size, 1)) for values in intensities]}

    def _target_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        surfaces = [colored_target(c, distance, name=n) for c, n in zip(clouds, names, strict=True)]
        return {
            "normals": [surface.normals for surface in surfaces],
            "intensities": [surface.intensities.reshape((surface.intensities.size, 1)) for surface in surfaces],
            "gradients": [surface.gradients for surface in surfaces],
        }

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """The kernel, normals, intensities, gradients and the weight."""
        return [self.kernel.loss, source, target, self.lambda_geometric]


@dataclasses.dataclass(frozen=True)
class TransformationEstimationForDopplerICP(TransformationEstimation):
    """Doppler ICP: point-to-plane and radial velocities (Hexsel, Vhavle and Chen 2022).

    The source is the earlier scan in its sensor frame, with the attribute "dopplers", shape [n] [m/s]. The target is
    the next scan.

    Args:
        period: Time between the scans [s].
        lambda_doppler: Weight of the Doppler term, 0..1.
        reject_dynamic_outliers: Remove points whose speed differs from that of the motion.
        doppler_outlier_threshold: By more than this [m/s].
        outlier_rejection_min_iteration: First iteration with outlier rejection.
        geometric_robust_loss_min_iteration: First iteration with the geometric kernel.
        doppler_robust_loss_min_iteration: First iteration with the Doppler kernel.
        geometric_kernel, doppler_kernel: Kernels of the two rows.
        transform_vehicle_to_sensor: Pose of the vehicle in the sensor frame.
    """

    period: float = 0.1
    lambda_doppler: float = 0.01
    reject_dynamic_outliers: bool = False
    doppler_outlier_threshold: float = 2.0
    outlier_rejection_min_iteration: int = 2
    geometric_robust_loss_min_iteration: int = 0
    doppler_robust_loss_min_iteration: int = 2
    geometric_kernel: RobustKernel = MIN_SQUARES
    doppler_kernel: RobustKernel = MIN_SQUARES
    transform_vehicle_to_sensor: ArrayLike | None = None
    rows = sum_doppler_rows
    constrainable = False  # speeds depend on the complete pose
    needs_normals = ("target",)
    in_sensor_frame = True

    def __post_init__(self) -> None:
        super().__post_init__()
        check_positive("period", self.period)
        check_fraction("lambda_doppler", self.lambda_doppler)
        check_positive("doppler_outlier_threshold", self.doppler_outlier_threshold)
        for name in ("outlier_rejection", "geometric_robust_loss", "doppler_robust_loss"):
            check_count(f"{name}_min_iteration", getattr(self, f"{name}_min_iteration"), minimum=0)
        if self.transform_vehicle_to_sensor is not None:
            check_rigid("transform_vehicle_to_sensor", self.transform_vehicle_to_sensor)

    def _source_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        measurements = [doppler_measurements(c, n) for c, n in zip(clouds, names, strict=True)]
        return {
            "dopplers": [measured.dopplers.reshape((measured.dopplers.size, 1)) for measured in measurements],
            "directions": [measured.directions for measured in measurements],
        }

    def _target_columns(self, clouds: Sequence[PointCloud], names: Sequence[str], distance: float) -> Columns:
        return {"normals": normals_of(clouds, names, "Doppler ICP")}

    def geometry(self) -> Self:
        """Equal weights of both rows: a speed determines the direction of its ray as a plane its normal."""
        return dataclasses.replace(
            self,
            period=1.0,
            lambda_doppler=0.5,
            reject_dynamic_outliers=False,
            geometric_kernel=MIN_SQUARES,
            doppler_kernel=MIN_SQUARES,
        )

    def prepare(self, loop: RegistrationLoop) -> None:
        """Compute the velocities of the poses."""
        loop.measure_velocities(self.period)

    def arguments(self, loop: RegistrationLoop, source: PointColumns, target: PointColumns) -> list[Any]:
        """All arguments of the two rows."""
        sensor = np.zeros(3)
        if self.transform_vehicle_to_sensor is not None:
            sensor = np.asarray(self.transform_vehicle_to_sensor, np.float64)[:3, 3]
        never = 2**31 - 1
        rule = DopplerRule(
            sensor,
            self.period,
            self.lambda_doppler,
            self.doppler_kernel.loss,
            geometric_from=self.geometric_robust_loss_min_iteration,
            doppler_from=self.doppler_robust_loss_min_iteration,
            reject_from=self.outlier_rejection_min_iteration if self.reject_dynamic_outliers else never,
            threshold=self.doppler_outlier_threshold,
        )
        kernel = self.geometric_kernel.loss
        return [kernel, source, target, loop.velocities, loop.progress.iterations, rule]
