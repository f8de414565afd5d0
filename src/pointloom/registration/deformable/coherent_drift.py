"""Coherent point drift: rigid, affine or deformable registration of small point sets without correspondences."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import (
    check_count,
    check_fraction,
    check_positive,
    check_progress,
    check_rows,
    check_transformation,
    shown,
)
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, failed, with_warnings
from ...core.wording import format_fraction
from ...kernels.array_types import AnyArray
from ...kernels.arrays.side_by_side import read_together
from ...kernels.bending.coherent_drift import (
    Drift,
    map_positions_kernel,
    sum_positions,
    sum_pulls,
    sum_targets,
    transform_to_positions,
)
from ...kernels.bending.coherent_field import CoherentField, move_points
from ...kernels.lang import launch, mat33d, reduce, vec3d
from ...kernels.linear_algebra import EPSILON, matmul, pinvh
from ...kernels.memory import clone, download, empty
from ...pcd.cloud import PointCloud
from ..chance_matches import AFFINE_SAMPLE, RIGID_SAMPLE, find_too_few
from ..correspondence_input import check_clouds
from ..pose_check import find_problem
from ..rigid import fit_moments, make_pose

Array = NDArray[np.float64]
Kind = Literal["rigid", "affine", "deformable"]
KINDS = ("rigid", "affine", "deformable")
MIN_POINTS = 4
MAX_TREE_DEVIATION = 0.7  # relative to the source's radius: below it, trees are faster than all pairs
MAX_DIAGONAL_RESIDUAL = 1e-9  # relative diagonal residual of the factorization
MAX_ROWS = 1000  # maximum rank
MIN_VARIANCE = 1e-10  # minimum variance relative to the squared radius
MIN_FRACTION, MAX_SPREAD = 0.5, 2.5


@dataclass(frozen=True, eq=False)
class DriftResult(Report, Assessed):
    """Result of `coherent_point_drift`.

    Attributes:
        kind: "rigid", "affine" or "deformable".
        transformation: T_target_source, float64 [4, 4], with scale if rigid; `init` if deformable.
        warped: The moved source.
        deviation: Final standard deviation of the Gaussians [m]: distance of targets from sources per axis.
        spacing: Median nearest neighbor distance of the target [m].
        matched: Fraction of targets that are inliers, 0..1.
        iterations: Number of steps.
        converged: True if the variance converged.
    """

    kind: Kind
    transformation: Array
    warped: PointCloud
    deviation: float
    spacing: float
    matched: float
    iterations: int
    converged: bool
    _field: tuple[Array, float, Array, Array, float] | None = None
    _problem: str = ""

    @property
    def warnings(self) -> tuple[str, ...]:
        apart = self.deviation / self.spacing if self.spacing > 0 else 0.0
        return failed(
            f"only {format_fraction(self.matched)} of the target are inliers" if self.matched < MIN_FRACTION else None,
            f"targets are {apart:.1f} of their spacings from the sources" if apart > MAX_SPREAD else None,
            None if self.converged else f"not converged after {self.iterations} steps",
            self._problem,
        )

    def transform(self, points: PointCloud | ArrayLike) -> Any:
        """Transform a PointCloud (without normals and covariances if deformable), or coordinates [n, 3] [m]."""
        if isinstance(points, PointCloud):
            return _moved(points, self.transformation, self._field)
        rows = check_rows("points", points, 3, dtype=np.float64)
        return np.array(_moved(PointCloud(rows, device=self.warped.device), self.transformation, self._field).points)

    def fields(self) -> Fields:
        fields = [
            ("kind", self.kind),
            ("deviation", f"{self.deviation:.4g}, with {self.spacing:.4g} between targets"),
            ("matched", f"{format_fraction(self.matched)} of the target"),
            ("steps", f"{self.iterations}{'' if self.converged else ', not converged'}"),
        ]
        return with_warnings(fields, self)


@explain_argument_errors
def coherent_point_drift(
    source: PointCloud,
    target: PointCloud,
    *,
    kind: Kind = "rigid",
    with_scaling: bool = True,
    outliers: float = 0.1,
    width: float = 2.0,
    stiffness: float = 3.0,
    init: ArrayLike | None = None,
    max_iterations: int = 150,
    tolerance: float = 1e-4,
    progress: ReportProgress | None = None,
) -> DriftResult:
    """Register one small point set to another without correspondences: coherent point drift.

    The source points are Gaussian centers, the target points their samples. Each EM step moves the centers and updates
    the common variance. No distance threshold is needed, but every point meets every other: use `registration_icp` or
    `register_nonrigid` above some ten thousand points.

    Args:
        source: The points to move, at least four.
        target: The fixed points, on the same device.
        kind: "rigid", with one scale if `with_scaling`; "affine"; "deformable": a smooth displacement field.
        with_scaling: Estimate a scale in a rigid drift.
        outliers: Fraction of targets without a source, below 1.
        width: Gaussian width of the displacement field, relative to the source's root mean square radius.
        stiffness: Regularization weight (lambda) of the field, in units of that radius.
        init: Initial affine map, 4x4; None: the identity.
        max_iterations: Maximum number of steps.
        tolerance: Converged if the relative change of the variance is below this.
        progress: Called with ("drift", steps taken, max_iterations).

    Returns:
        The result. Check `reliable`: it is False if unrelated points would match as well by chance, also under a field
            with as many parameters as points.

    Raises:
        TypeError, ValueError: Not clouds, too few points, numbers out of range, an unknown kind, or a width that needs
            more than 1,000 Gaussians.
        DeviceError: Clouds on different devices.

    Notes:
        Rotations above a quarter turn may end in a wrong optimum of a regular body: give `init` (`register_globally`).
        120 B per point, and 8 B times the field's Gaussians per source point. Float64 and bitwise reproducible, up to
        the small systems solved on the host. Myronenko and Song, "Point set registration: coherent point drift", PAMI
        2010, with incomplete Cholesky instead of eigenvectors.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> body = rng.random((200, 3)) * [3, 2, 1]
        >>> bent = body + 0.2 * np.sin(body[:, [1, 2, 0]])
        >>> found = loom.registration.coherent_point_drift(
        ...     loom.PointCloud(body), loom.PointCloud(bent), kind="deformable", outliers=0.01
        ... )
        >>> bool(np.abs(found.warped.points - bent).max() < 0.05), found.reliable
        (True, True)
    """
    check_clouds(source, target)
    report_progress = check_progress(progress)
    if not isinstance(kind, str) or kind not in KINDS:
        raise ValueError(f"kind: expected one of {', '.join(KINDS)}, got {shown(kind)}")
    fraction, iteration_limit = (
        check_fraction("outliers", outliers),
        check_count("max_iterations", max_iterations, maximum=100_000),
    )
    if fraction >= 1:
        raise ValueError("outliers: expected a fraction below 1, got 1, which leaves no inliers")
    begin = np.eye(4) if init is None else check_transformation("init", init)
    field_width, stiff = (
        check_positive("width", width, maximum=1e3),
        check_positive("stiffness", stiffness, maximum=1e9),
    )
    still = check_positive("tolerance", tolerance)
    for name, cloud in (("source", source), ("target", target)):
        if cloud.search_tree().count < MIN_POINTS:
            count = cloud.search_tree().count
            raise ValueError(f"{name}: expected at least {MIN_POINTS} finite points, got {count}")
    job = _DriftRegistration(source, target, begin, fraction)
    if kind == "deformable":
        job.begin_field(field_width, stiff)
    converged = False
    while not converged and job.taken < iteration_limit:
        report_progress("drift", job.taken, iteration_limit)
        converged = job.step(kind, bool(with_scaling)) <= still
    report_progress("drift", iteration_limit, iteration_limit)
    return job.conclude(kind, converged)


class _DriftRegistration:
    """State in coordinates about the source's center, in units of its radius."""

    def __init__(self, source: PointCloud, target: PointCloud, begin: Array, outliers: float):
        self.source, self.target, self.begin = source, target, begin
        points, others = source.remove_non_finite_points(), target.remove_non_finite_points()
        start = points.transform(begin)
        first = transform_to_positions(start.arrays["points"], np.eye(3), np.zeros(3))
        count = first.size
        total = np.asarray(download(reduce(sum_positions, count, [first])), np.float64).ravel() / count  # sync
        radius = float(np.sqrt(max(total[3] - matmul(total[:3], total[:3]), 0.0)))
        if radius <= 0:
            raise ValueError("source: expected different points, got equal ones")
        self.center, self.unit = start.origin + total[:3], 1 / radius
        self.positions = self._normalized(start)
        self.drift = Drift(self._normalized(others), count)
        self.moved, self.A, self.t = self.positions, np.eye(3), np.zeros(3)
        self.size, self.number = count, self.drift.targets.size
        sums = [
            reduce(sum_positions, positions.size, [positions]) for positions in (self.positions, self.drift.targets)
        ]
        source_sums, target_sums = (np.asarray(part, np.float64).ravel() for part in read_together(sums))  # sync
        cross = matmul(source_sums[:3], target_sums[:3])
        squares = self.number * source_sums[3] + self.size * target_sums[3] - 2 * cross
        self.variance = max(squares / (3 * self.size * self.number), MIN_VARIANCE)
        self.odds, self.taken, self.matched = outliers / (1 - outliers), 0, 1.0
        self.field: CoherentField | None = None
        self.values = np.zeros((0, 3))

    def _normalized(self, cloud: PointCloud) -> Any:
        return transform_to_positions(
            cloud.arrays["points"], self.unit * np.eye(3), self.unit * (cloud.origin - self.center)
        )

    def begin_field(self, width: float, stiffness: float) -> None:
        try:
            self.field = CoherentField(self.positions, width, MAX_DIAGONAL_RESIDUAL, MAX_ROWS)
        except ValueError as error:
            raise ValueError(
                f"width: Gaussians of {width:g} of the source's radius require {error}. Use a larger width"
            ) from None
        self.stiffness = stiffness
        self.moved = clone(self.positions)  # the field writes here

    def step(self, kind: Kind, with_scaling: bool) -> float:
        """One EM step. Returns the relative change of the variance."""
        uniform = (2 * np.pi * self.variance) ** 1.5 * self.odds * self.size / self.number
        self.drift.weigh(self.moved, self.variance, uniform, near=MAX_TREE_DEVIATION)
        before = self.variance
        if kind == "deformable":
            self._bend()
        else:
            self._map(with_scaling if kind == "rigid" else None)
        self.variance, self.taken = max(self.variance, MIN_VARIANCE), self.taken + 1
        return abs(before - self.variance) / before

    def _sums(self, positions: AnyArray) -> tuple[Array, Array]:
        targets = reduce(sum_targets, self.number, [self.drift.targets, self.drift.fractions])
        sources = reduce(sum_pulls, self.size, [positions, self.drift.sums])
        first, second = read_together([targets, sources])  # sync
        return np.asarray(first, np.float64).ravel(), np.asarray(second, np.float64).ravel()

    def _map(self, with_scaling: bool | None) -> None:
        (total, squares), moments = self._sums(self.positions)
        if total <= 0:
            return
        mean_y, mean_x = moments[1:4] / total, moments[4:7] / total
        cross = moments[7:16].reshape(3, 3) / total - np.outer(mean_x, mean_y)
        spread = np.zeros((3, 3))
        spread[np.triu_indices(3)] = moments[16:] / total
        spread = spread + np.triu(spread, 1).T - np.outer(mean_y, mean_y)
        if with_scaling is None:
            self.A = matmul(cross, pinvh(spread, 3 * EPSILON))
        else:
            self.A = fit_moments(cross, float(np.trace(spread)), with_scaling=with_scaling)
        self.t = mean_x - matmul(self.A, mean_y)
        rest = (
            squares / total
            - matmul(mean_x, mean_x)
            - 2 * (cross * self.A).sum()
            + (matmul(self.A, spread) * self.A).sum()
        )
        self.variance, self.matched = float(rest) / 3, float(total) / self.number
        self.moved = empty(self.size, vec3d, self.positions.device)
        launch(map_positions_kernel, self.size, [self.positions, mat33d(*self.A.ravel()), vec3d(*self.t), self.moved])

    def _bend(self) -> None:
        assert self.field is not None
        self.values = self.field.step(self.drift.sums, self.stiffness * self.variance, self.moved)
        (total, squares), moments = self._sums(self.moved)
        if total <= 0:
            return
        cross, spread = moments[7] + moments[11] + moments[15], moments[16] + moments[19] + moments[21]
        self.variance = float(squares - 2 * cross + spread) / (3 * float(total))
        self.matched = float(total) / self.number

    def conclude(self, kind: Kind, converged: bool) -> DriftResult:
        T, field = self.begin, None
        if self.field is None:
            T = matmul(make_pose(self.A, self.t / self.unit + self.center - matmul(self.A, self.center)), self.begin)
        else:
            centers = self.field.centers()
            weights = self.field.weights_of(self.values)
            field = (self.center, self.unit, centers, weights, self.field.scale)
        target, warped = self.target.to(self.target.device, arrays="numpy"), _moved(self.source, T, field)
        return DriftResult(
            kind,
            T,
            warped,
            float(np.sqrt(self.variance)) / self.unit,
            float(np.nanmedian(target.remove_duplicated_points().compute_nearest_neighbor_distance())),
            self.matched,
            self.taken,
            converged,
            field,
            self._find_problem(kind, warped),
        )

    def _find_problem(self, kind: Kind, warped: PointCloud) -> str:
        """The warning of points, and surfaces if there are any, that unrelated clouds would match as well by chance."""
        sample = RIGID_SAMPLE if kind == "rigid" else AFFINE_SAMPLE
        if self.field is not None:
            sample = max(sample, math.ceil(self.field.count_parameters(self.stiffness * self.variance)))
        if not find_too_few(warped, np.eye(4), self.target, sample):
            return ""
        return find_problem(warped, self.target, np.eye(4), may_be_open=kind == "deformable", sample=sample)


def _moved(cloud: PointCloud, T: Array, field: Any) -> PointCloud:
    moved = cloud.transform(T)
    if field is None:
        return moved
    center, unit, centers, weights, scale = field
    arrays = {name: values for name, values in moved.arrays.items() if name not in ("normals", "covariances")}
    points = arrays["points"]
    arrays["points"] = move_points(points, moved.origin - center, unit, centers, weights, scale)
    return moved.with_arrays(arrays, grid=moved.grid)
