"""Nonrigid registration of two clouds with a deformation graph."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import KDTree

from ...core.argument_errors import explain_argument_errors
from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_finite,
    check_list,
    check_number,
    check_numeric,
    check_positive,
    check_progress,
    check_rows,
    check_shape,
)
from ...core.devices import check_same_device
from ...core.pickled_arrays import check_form, device_like, pickled, unpickled, unpickling
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, failed, quality, with_warnings
from ...core.wording import format_fraction
from ...kernels.array_types import AnyArray
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.quantiles import quantiles_of
from ...kernels.bending.bending_steps import BendingSteps
from ...kernels.bending.deformation_graph import (
    DeformationGraph,
    Influence,
    bend_normals,
    bend_points,
    bend_wide,
    measure_strain,
    measure_volumes,
    neighbors_of,
)
from ...kernels.bending.surface_pairs import (
    PairRule,
    Surface,
    find_borders,
    measure_residuals_kernel,
    pair_points_kernel,
    pin_rows_kernel,
)
from ...kernels.lang import float64, int32, launch, mat33d, vec3, vec3d
from ...kernels.linear_algebra import eigh, matmul, norm
from ...kernels.memory import download, empty, rows_of, upload
from ...kernels.search.nearest_point import find_nearest
from ...kernels.search.point_tree import PointTree
from ...pcd.cloud import PointCloud
from ...pcd.motion import map_about
from ..correspondence_input import check_clouds
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.icp import check_poses, registration_icp
from ..rigid import fit_pose, to_local

Array = NDArray[np.float64]
DEFAULT_STIFFNESS = (100.0, 10.0, 1.0, 0.1)
NODES_ACROSS = 16  # per bounding box diagonal
MAX_ACROSS = 1000
MIN_COSINE = 0.5  # 60 degrees: larger angles are different surfaces
POINT_WEIGHT = 0.1  # relative weight of point-to-point terms, against sliding on flat areas
NORMAL_NEIGHBORS = 20
MIN_POINTS = 10
TRIM_MEDIANS = 4.0  # times the median pair distance: outliers in the final stages
DOUBTED_STRAIN = 0.12  # strain above which rotated starts are tried
MAX_STRAIN_RATIO = 0.75  # strain ratio of a better start


@explain_argument_errors
def register_nonrigid(
    source: PointCloud,
    target: PointCloud,
    *,
    node_spacing: float | None = None,
    max_correspondence_distance: float | None = None,
    init: ArrayLike | None = None,
    landmarks: tuple[ArrayLike, ArrayLike] | None = None,
    landmark_weight: float = 10.0,
    stiffness: Sequence[float] = DEFAULT_STIFFNESS,
    max_iterations: int = 30,
    tolerance: float = 1e-3,
    progress: ReportProgress | None = None,
) -> NonRigidResult:
    """Deform a body to match another scan of it.

    After ICP, the nodes of a deformation graph rotate and translate so that the source matches the target surface,
    first stiffly, then softer. Points without a target point nearby, with normals that differ by more than 60 degrees,
    or matched to the target's border have no partner, so the target may be partial.

    Args:
        source: The body to deform, at least ten points. Normals are estimated if missing.
        target: The target, on the same device. Likewise.
        node_spacing: Approximate node distance [m]; None: a sixteenth of the source's diagonal.
        max_correspondence_distance: Maximum distance of a pair [m]; None: two node spacings.
        init: Initial T_target_source, 4x4; None: from three or more landmarks, else the identity.
        landmarks: (positions on the source, target positions), both [l, 3] [m] in world coordinates.
        landmark_weight: Weight of a landmark relative to all points of a node.
        stiffness: Weights of the regularization of a node, from stiff to soft, in the same unit.
        max_iterations: Maximum steps per stiffness.
        tolerance: Converged if nodes move by less than this fraction of their spacing.
        progress: Called with ("bend" or "bend, rotated", stages done, stages in all).

    Returns:
        The result. Check `reliable` and `is_rigid`.

    Raises:
        TypeError, ValueError: Wrong types, too few points, numbers out of range, landmarks that are not finite, off the
            source or contradictory, or no source point near the target.
        DeviceError: The clouds are on different devices.

    Notes:
        On smooth surfaces points may slide tangentially by a third of a node spacing and more; landmarks prevent this
        (docs/bending.md). A stretch above 22% is reported as unreliable. If the strain exceeds 12% with fewer than
        three landmarks, starts rotated by half a turn are tried too. The least strain wins, or is reported if `init`
        was given. About 500 B per source point and 2 kB per node. Bitwise reproducible.
        Sumner, Schmid and Pauly, "Embedded deformation for shape manipulation", SIGGRAPH 2007. Li, Sumner and Pauly
        2008; decreasing stiffness: Amberg, Romdhani and Vetter 2007.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 3000))
        >>> flat = loom.PointCloud(np.column_stack([x, y, 0.1 * np.sin(4 * x)]))
        >>> bent = loom.PointCloud(np.column_stack([x, y, 0.1 * np.sin(4 * x) + 0.1 * x * x]))
        >>> found = loom.registration.register_nonrigid(flat, bent)
        >>> found.rmse < 0.005, found.is_rigid, found.reliable
        (True, False, True)
    """
    check_clouds(source, target)
    report_progress = check_progress(progress)
    steps = [check_positive("stiffness", value, maximum=1e6) for value in check_list("stiffness", stiffness, "numbers")]
    if not steps:
        raise ValueError("stiffness: expected at least one number")
    iteration_limit = check_count("max_iterations", max_iterations, minimum=1, maximum=1000)
    fraction = check_positive("tolerance", tolerance)
    weight = check_positive("landmark_weight", landmark_weight, maximum=1e6)
    for name, cloud in (("source", source), ("target", target)):
        if cloud.search_tree().count < MIN_POINTS:
            raise ValueError(f"{name}: expected at least {MIN_POINTS} finite points, got {cloud.search_tree().count}")
    low, high = (np.asarray(bound) for bound in source.arrays.bounds())
    spacing = _check_spacing(node_spacing, float(norm(high - low)))
    max_distance = 2 * spacing
    if max_correspondence_distance is not None:
        name = "max_correspondence_distance"
        max_distance = check_positive(name, max_correspondence_distance, maximum=LARGEST_NUMBER)
    pins = _check_landmarks(landmarks, low, high, spacing)
    start = None if init is None else check_poses("init", init, TransformationEstimationPointToPlane())

    def bend(begin: Array | None, phase: str) -> NonRigidResult:
        job = _NonRigidRegistration(source, target, spacing, max_distance, begin, pins, weight)
        return job.run(steps, iteration_limit, fraction * spacing, partial(report_progress, phase))

    result = bend(start, "bend")
    if result.strain <= DOUBTED_STRAIN or len(pins[0]) >= 3:
        return result
    return _retry_rotated(source, result, bend, is_given=init is not None)


def _retry_rotated(
    source: PointCloud, result: NonRigidResult, bend: Callable[..., NonRigidResult], *, is_given: bool
) -> NonRigidResult:
    """The result with least strain among this one and three half turns about the principal axes."""
    points = source.remove_non_finite_points().points
    center, best, begin = points.mean(axis=0), result, None
    for axis in eigh(matmul((points - center).T, points - center) / max(len(points) - 1, 1))[1].T:
        half_rotation = map_about(2 * np.outer(axis, axis) - np.eye(3), center)
        try:
            other = bend(matmul(result.rigid_pose, half_rotation), "bend, rotated")
        except ValueError:  # no point near the target from this start
            continue
        if other.strain < MAX_STRAIN_RATIO * best.strain and other.matched >= 0.98 * best.matched:
            best, begin = other, matmul(result.rigid_pose, half_rotation)
    if begin is None or not is_given:
        return best
    return replace(result, better_start=begin)


def _check_spacing(value: float | None, diagonal: float) -> float:
    if diagonal <= 0:
        raise ValueError("source: expected different points, got equal ones")
    if value is None:
        return diagonal / NODES_ACROSS
    spacing = check_positive("node_spacing", value)
    if not diagonal / MAX_ACROSS <= spacing <= MAX_ACROSS * diagonal:
        raise ValueError(
            f"node_spacing: expected {diagonal / MAX_ACROSS:g} to {MAX_ACROSS * diagonal:g} m, a thousandth to a "
            f"thousandfold of the diagonal of the source's box, got {spacing:g}"
        )
    return spacing


def _check_landmarks(landmarks: object, low: Array, high: Array, spacing: float) -> tuple[Array, Array]:
    if landmarks is None:
        return np.zeros((0, 3)), np.zeros((0, 3))
    if not isinstance(landmarks, tuple | list) or len(landmarks) != 2:
        raise ValueError("landmarks: expected two arrays, points on the source and their target positions")
    source_points = check_finite("landmarks[0]", check_rows("landmarks[0]", landmarks[0], 3, dtype=np.float64))
    target_points = check_rows("landmarks[1]", landmarks[1], 3, rows=len(source_points), dtype=np.float64)
    off = np.maximum(np.maximum(low - source_points, source_points - high), 0).max(axis=1, initial=0)
    if len(source_points) and off.max() > 2 * spacing:
        k = int(off.argmax())
        raise ValueError(
            f"landmarks[0]: point {k} is {off[k]:g} m outside the source's bounding box. "
            "Pass the points on the source first, in its world coordinates"
        )
    check_finite("landmarks[1]", target_points)
    _refuse_contradictions(source_points, target_points, spacing)
    return source_points, target_points


def _refuse_contradictions(source_points: Array, target_points: Array, spacing: float) -> None:
    """Reject landmarks less than a node spacing apart whose targets are farther apart: they share nodes."""
    if len(source_points) < 2:
        return
    a, b = KDTree(source_points).query_pairs(spacing, output_type="ndarray").reshape(-1, 2).T
    before, after = (np.linalg.norm(points[a] - points[b], axis=1) for points in (source_points, target_points))
    if (after - before > spacing).any():
        k = int((after - before).argmax())
        raise ValueError(
            f"landmarks: points {min(a[k], b[k])} and {max(a[k], b[k])} are {before[k]:g} m apart and their "
            f"targets {after[k]:g} m, which nodes {spacing:g} m apart cannot represent. Leave one out, or pass a "
            "smaller node_spacing"
        )


class _NonRigidRegistration:
    def __init__(
        self,
        source: PointCloud,
        target: PointCloud,
        spacing: float,
        max_distance: float,
        init: ArrayLike | None,
        pins: tuple[NDArray[np.float64], NDArray[np.float64]],
        weight: float,
    ):
        self.sided = all("normals" in cloud.arrays for cloud in (source, target))
        self.source, self.target = (
            cloud if "normals" in cloud.arrays else cloud.estimate_normals(max_nn=NORMAL_NEIGHBORS)
            for cloud in (source, target)
        )
        self.spacing, self.max_distance, self.pins = spacing, max_distance, pins
        low, high = source.arrays.bounds()
        # with sparse nodes, the match is judged at the scale of the body
        self.grain = min(spacing, float(norm(np.asarray(high) - np.asarray(low))) / NODES_ACROSS)
        if init is None and len(pins[0]) >= 3:
            init = fit_pose(*pins)
        method = TransformationEstimationPointToPlane()
        icp = registration_icp(self.source, self.target, max_distance, init, method, overlap=None)
        if icp.fitness == 0 and not len(pins[0]):
            raise ValueError(
                f"source, target: no point of the source is within {max_distance:g} m of the target. Pass an "
                "init that aligns them roughly (as from register_globally), landmarks, or a larger "
                "max_correspondence_distance"
            )
        self.pose, tree = icp.transformation, self.target.search_tree()
        self.tree, self.count = tree, len(source)
        normals = self.target.arrays["normals"]
        self.surface = Surface(tree.source, normals, find_borders(tree, normals))
        self._make_graph(weight)
        device = tree.device
        self.partners, self.distances = empty(self.count, int32, device), empty(self.count, float64, device)

    def _make_graph(self, weight: float) -> None:
        source, device, (source_points, target_points) = self.source, self.tree.device, self.pins
        thin = source.remove_non_finite_points()
        chosen = thin.farthest_point_down_sample(len(thin.voxel_down_sample(self.spacing)))
        nodes = chosen.arrays.about(source.origin)
        T = to_local(self.pose, source.origin, self.target.origin)
        host = np.asarray(download(nodes), np.float64).reshape(-1, 3)
        rotations = upload(np.tile(T[:3, :3], (len(host), 1, 1)), mat33d, device)
        self.graph = DeformationGraph(nodes, rotations, upload(matmul(host, T[:3, :3].T) + T[:3, 3], vec3d, device))
        points = source.arrays["points"]
        self.influence = Influence(points, self.graph)
        around = neighbors_of(self.graph, self.influence)
        self.around, everything = around, self.influence
        if len(source_points):
            pinned = upload((source_points - source.origin).astype(np.float32), vec3, device)
            everything = Influence(concatenate_rows([points, pinned]), self.graph)
        self.steps = BendingSteps(self.graph, everything, around)
        if len(source_points):
            pin_positions = upload(target_points - self.target.origin, vec3d, device)
            launch(pin_rows_kernel, len(source_points), [self.count, pin_positions, weight, self.steps.rows])
        each = self.graph.count / max(source.search_tree().count, 1)
        self.rule = PairRule(MIN_COSINE, self.sided, each, POINT_WEIGHT * each)

    def _pair(self, max_distance: float) -> Any:
        moved = bend_points(self.graph, self.influence)
        normals = bend_normals(self.graph, self.influence, self.source.arrays["normals"])
        nearest = find_nearest(self.tree, moved, radius=max_distance, order=self.source.search_tree().order)
        outputs = [self.rule, self.steps.rows, self.partners, self.distances]
        launch(pair_points_kernel, self.count, [moved, normals, nearest, self.surface, *outputs])
        return moved

    def run(
        self, stiffness: Sequence[float], max_iterations: int, still: float, report_progress: Callable[[int, int], None]
    ) -> NonRigidResult:
        moved = self._pair(self.max_distance)
        unbent = self._measure(moved)
        iterations, converged, last = 0, True, True
        for stage, value in enumerate(stiffness):
            report_progress(stage, len(stiffness))
            shift = np.inf
            for _ in range(max_iterations):
                shift = self.steps.take(value)
                iterations += 1
                self._pair(self._limit(stage, len(stiffness)))
                if shift < still:
                    break
            last = shift < still
            converged = converged and last
        report_progress(len(stiffness), len(stiffness))
        return replace(self._conclude(unbent, iterations, converged), last_converged=last)

    def _limit(self, stage: int, stages: int) -> float:
        """Maximum pair distance. The softer half of all stages also rejects outliers."""
        if 2 * stage < stages:
            return self.max_distance
        medians = quantiles_of(self.distances, [0.5])  # sync
        limit = max(TRIM_MEDIANS * medians[0], 0.25 * self.spacing) if medians else np.inf
        return min(self.max_distance, limit)

    def _measure(self, moved: AnyArray) -> tuple[Array, float, float]:
        residuals = empty(self.count, float64, self.tree.device)
        launch(measure_residuals_kernel, self.count, [moved, self.partners, self.surface, residuals])
        values = np.array(download(residuals))  # sync
        values[values < 0] = np.nan
        paired = np.isfinite(values)
        near = paired & (np.nan_to_num(values, nan=np.inf) <= 0.1 * self.grain)
        rmse = float(np.sqrt((values[paired] ** 2).mean())) if paired.any() else float("nan")
        return values, float(near.sum()) / max(self.source.search_tree().count, 1), rmse

    def _conclude(self, unbent: tuple[Array, float, float], iterations: int, converged: bool) -> NonRigidResult:
        residuals, matched, rmse = self._measure(self._pair(self._limit(1, 1)))
        deformation = Deformation(self.graph, self.source.origin, self.target.origin)
        warped = deformation.transform(self.source)
        warped_tree = PointTree(warped.arrays.about(self.target.origin))
        nearest = find_nearest(warped_tree, self.tree.source, order=self.tree.order)
        covered = _fraction_within(nearest, 0.5 * self.grain, self.tree.count)
        strains = quantiles_of(measure_strain(self.graph, self.around), [0.9])
        volumes = deformation.volumes(self.source)
        finite = volumes[np.isfinite(volumes)]
        return NonRigidResult(
            deformation,
            warped,
            np.array(download(rows_of(self.partners, 0, self.count)), np.int32),
            residuals,
            matched,
            covered,
            rmse,
            self.pose,
            unbent[2],
            unbent[1],
            float((finite <= 0).mean()) if finite.size else 0.0,
            strains[0] if strains else 0.0,
            iterations,
            converged,
            self.spacing,
            self.tree.source.size,
        )


def _fraction_within(nearest: AnyArray, distance: float, count: int) -> float:
    keys = np.asarray(download(nearest), np.int64)
    squares = (keys >> 32).astype(np.int32).view(np.float32)
    return float(((keys >= 0) & (squares <= distance * distance)).sum()) / max(count, 1)


RMSE_TOLERANCE = 1e-3  # of the node spacing: smaller differences are ignored
MIN_FRACTION, MAX_FOLDED, MAX_STRAIN = 0.75, 0.01, 0.22


@dataclass(frozen=True, eq=False)
class NonRigidResult(Report, Assessed):
    """Result of `register_nonrigid` with its quality measures.

    Attributes:
        deformation: The Deformation from source to target.
        warped: The deformed source.
        correspondences: Target index of each source point, int32 [n], or -1 without partner.
        residuals: Distance from the partner's plane [m], float64 [n]. NaN without partner.
        matched: Fraction of source points on the target, 0..1.
        covered: Fraction of target points that the deformed source reaches.
        rmse: Root mean square of the residuals [m].
        rigid_pose: T_target_source of the initial ICP, float64 [4, 4].
        rigid_rmse, rigid_matched: The same measures for the undeformed source at that pose.
        folded: Fraction of points where the deformation folds over.
        strain: Relative change of node distances, 90th percentile. 0 for pure bending.
        iterations: Total number of steps.
        converged: True if each stiffness converged.
        node_spacing: Approximate node distance [m].
        target_count: Number of target points.
        better_start: If `init` was given: a pose, rotated by half a turn, that needs less strain.
        last_converged: True if the last stiffness converged, which determines the result.
    """

    deformation: Deformation
    warped: PointCloud
    correspondences: NDArray[np.int32]
    residuals: Array
    matched: float
    covered: float
    rmse: float
    rigid_pose: Array
    rigid_rmse: float
    rigid_matched: float
    folded: float
    strain: float
    iterations: int
    converged: bool
    node_spacing: float
    target_count: int
    better_start: NDArray[np.float64] | None = None
    last_converged: bool = True

    @property
    def is_rigid(self) -> bool:
        """True if the source matches the target nearly as well without deformation: 98% of the points, 1.1 of the
        RMSE. Sparse or noisy scans of a rigid body can exceed it, because the deformation fits their noise."""
        return (
            self.rigid_matched >= 0.98 * self.matched
            and self.rigid_rmse <= 1.1 * self.rmse + RMSE_TOLERANCE * self.node_spacing
        )

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy. Empty if the result is reliable."""
        fraction, fold = max(self.matched, self.covered), self.folded > MAX_FOLDED
        has_better_start = self.better_start is not None
        return failed(
            f"only {format_fraction(fraction)} of either cloud matches the other" if fraction < MIN_FRACTION else None,
            f"the deformation folds at {format_fraction(self.folded)} of the points" if fold else None,
            f"the deformation stretches the source by {self.strain:.0%}" if self.strain > MAX_STRAIN else None,
            "a start rotated by 180 degrees (better_start) fits with less strain" if has_better_start else None,
            # Earlier stiffnesses only give the start of the next one: with 30 steps each, some did not converge in 3
            # of 6 correct results of bent_bodies.py (2026-11-28), whose rmse is that of 200 steps. The last one did.
            None if self.last_converged else f"not converged after {self.iterations} steps: use more max_iterations",
        )

    def to_dict(self) -> dict[str, Any]:
        """The values as JSON types."""
        names = ("matched", "covered", "rmse", "rigid_rmse", "rigid_matched", "folded", "strain", "iterations")
        values = {name: getattr(self, name) for name in names}
        return {"nodes": len(self.deformation), **values, "converged": self.converged, **quality(self)}

    def fields(self) -> Fields:
        """The rows of the printed summary."""
        unbent = f"rmse {self.rigid_rmse:.4g}, {format_fraction(self.rigid_matched)} of the source on the target"
        fields = [
            ("nodes", f"{len(self.deformation):,}"),
            (
                "matched",
                f"{format_fraction(self.matched)} of the source, {format_fraction(self.covered)} of the target",
            ),
            ("rmse", f"{self.rmse:.4g}"),
            ("unbent", unbent),
            ("strain", f"{self.strain:.1%}, folded at {format_fraction(self.folded)}"),
            ("steps", f"{self.iterations}{'' if self.converged else ', not converged'}"),
        ]
        return with_warnings(fields, self)

    def transfer(self, values: ArrayLike, missing: float = np.nan) -> NDArray[Any]:
        """Transfer values of the target points to the source points that match them.

        Args:
            values: Values per target point, such as `target.colors` or `target["label"]`, shape [m] or [m, c].
            missing: Value for points without a partner; must fit the type of integer values.

        Returns:
            Shape [n] or [n, c], in the type of the values.

        Raises:
            ValueError: The number of rows differs from the target's points, or `missing` does not fit the type.
            TypeError: Not numeric.
        """
        rows = check_numeric("values", values)
        if rows.ndim not in (1, 2) or len(rows) != self.target_count:
            raise ValueError(
                f"values: expected {self.target_count} rows, one per point of the target, got {list(rows.shape)}"
            )
        blank = check_number("missing", missing, allow_nan=True, allow_infinite=True)
        with np.errstate(invalid="ignore", over="ignore"):
            filled = np.asarray(blank).astype(rows.dtype)
        if rows.dtype.kind != "f" and filled != blank:
            raise ValueError(f"missing: expected an integer for {rows.dtype}, got {missing}")
        transferred = np.full((len(self.correspondences), *rows.shape[1:]), filled, rows.dtype)
        has = self.correspondences >= 0
        transferred[has] = rows[self.correspondences[has]]
        return transferred


class Deformation:
    """Deformation from `register_nonrigid` in world coordinates.

    Each point moves with a weighted mean of its four nearest nodes. Normals use the inverse transpose of the Jacobian.

    Attributes:
        device: The device of the nodes.
    """

    def __init__(self, graph: DeformationGraph, source_origin: Array, target_origin: Array) -> None:
        self._graph, self._source, self._target = graph, source_origin.copy(), target_origin.copy()
        self.device = graph.nodes.device

    def __len__(self) -> int:
        return self._graph.count

    def __repr__(self) -> str:
        return f"Deformation({len(self):,} nodes, {self.device})"

    def __getstate__(self) -> dict[str, Any]:
        graph = self._graph
        arrays = pickled({"nodes": graph.nodes, "rotations": graph.rotations, "centers": graph.centers})
        return {"arrays": arrays, "device": str(self.device), "source": self._source, "target": self._target}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("deformation"):
            arrays = unpickled(state["arrays"], device_like("deformation", state["device"]))
            count = arrays["nodes"].size
            graph = DeformationGraph(
                check_form("nodes", arrays["nodes"], (vec3, (count,))),
                check_form("rotations", arrays["rotations"], (mat33d, (count,))),
                check_form("centers", arrays["centers"], (vec3d, (count,))),
            )
            made = type(self)(graph, *(check_shape(name, state[name], (3,)) for name in ("source", "target")))
        vars(self).update(vars(made))

    @property
    def nodes(self) -> Array:
        """Initial node positions [m], float64 [nodes, 3]."""
        return np.asarray(download(self._graph.nodes), np.float64).reshape(-1, 3) + self._source

    @property
    def rotations(self) -> Array:
        """Node rotations, float64 [nodes, 3, 3]."""
        return np.array(download(self._graph.rotations), np.float64).reshape(-1, 3, 3)

    @property
    def translations(self) -> Array:
        """Node translations [m], float64 [nodes, 3]."""
        centers = np.asarray(download(self._graph.centers), np.float64).reshape(-1, 3)
        return centers + self._target - self.nodes

    def transform(self, points: PointCloud | ArrayLike) -> Any:
        """Deform a cloud, or points such as the vertices of a mesh.

        Args:
            points: A PointCloud on the device of the nodes, or world coordinates [n, 3] [m], on or near the body.

        Returns:
            The cloud with rotated normals and without covariances, or float64 [n, 3]. Non-finite points are unchanged.

        Raises:
            TypeError, ValueError: Neither a cloud nor points.
            DeviceError: A cloud on another device.
        """
        if not isinstance(points, PointCloud):
            rows = check_rows("points", points, 3, dtype=np.float64)
            cloud = PointCloud(rows, device=self.device)
            return np.array(download(bend_wide(self._graph, self._influence(cloud), self._target))).reshape(-1, 3)
        check_same_device("points", self.device, points.device)
        influence = self._influence(points)
        arrays = {name: values for name, values in points.arrays.items() if name != "covariances"}
        arrays["points"] = bend_points(self._graph, influence)
        if "normals" in arrays:
            arrays["normals"] = bend_normals(self._graph, influence, arrays["normals"])
        bent = PointCloud.from_device_arrays(arrays, self._target, points.array_library)
        bent.grid, bent.unit, bent.crs = points.grid, points.unit, points.crs
        return bent

    def volumes(self, points: PointCloud | ArrayLike) -> NDArray[np.float32]:
        """Volume change at points, float32 [n]: the determinant of the Jacobian, negative in a fold."""
        cloud = points if isinstance(points, PointCloud) else PointCloud(points, device=self.device)
        return np.array(download(measure_volumes(self._graph, self._influence(cloud))))

    def _influence(self, cloud: PointCloud) -> Influence:
        return Influence(cloud.arrays.about(self._source), self._graph)
