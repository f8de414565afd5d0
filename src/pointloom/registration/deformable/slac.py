"""Joint alignment of fragments, rigid or with a common camera distortion (SLAC)."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import LARGEST_NUMBER, check_count, check_fraction, check_positive, check_progress
from ...core.devices import check_same_device
from ...core.progress import ReportProgress
from ...core.quaternions import nearest_rotations
from ...io.points.point_cloud import read_point_cloud
from ...kernels.algebra.transform import transform_points
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.lang import launch, mat44d
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download
from ...kernels.poses.anchor_ties import shift_anchors_kernel
from ...kernels.poses.control_lattice import motion_of, move_anchors_kernel
from ...kernels.poses.fragment_rows import FragmentRows, Fragments, Pairs
from ...kernels.poses.fragment_steps import FragmentStep, StepSystem
from ...kernels.poses.point_sums import count_agreeing
from ...kernels.search.nearest_point import find_nearest
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud, list_clouds
from ...pcd.units import common_reference
from ..pose_graphs.connected_parts import connected_parts
from ..pose_graphs.pose_graph import GraphArrays, PoseGraph, PoseGraphNode, check_pose_graph
from ..pose_graphs.reports import FragmentOverlap, RefinementReport
from ..rigid import invert_pose, rotations_of, to_local
from .control_grid import GRID_SIZE, ControlGrid

Array = NDArray[np.float64]
MAX_ITERATIONS = 1000
OUTLIER_NEIGHBORS, OUTLIER_DEVIATIONS = 20, 2.0  # outlier removal, as intended in Open3D
NORMAL_NEIGHBORS = 30
MIN_COSINE = 0.5  # 60 degrees: larger angles are different surfaces


@dataclasses.dataclass(frozen=True, kw_only=True)
class SLACOptimizerParams:
    """Options of the fragment alignment, with Open3D's names and defaults (without `slac_folder`: nothing is written).

    Args:
        max_iterations: Number of steps. Point pairs are searched again before each.
        voxel_size: Downsampling voxel edge [m]; 0: none.
        distance_threshold: Maximum distance of a point pair [m].
        fitness_threshold: Minimum fraction of consistent point pairs of an edge between non-consecutive fragments.
        regularizer_weight: Stiffness of the grid; multiplied by the number of fragments.
        grid_size: Edge of the grid cells [m].

    Raises:
        TypeError, ValueError: A number is out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.rgbd.SLACOptimizerParams(max_iterations=10).distance_threshold
        0.07
    """

    max_iterations: int = 5
    voxel_size: float = 0.05
    distance_threshold: float = 0.07
    fitness_threshold: float = 0.3
    regularizer_weight: float = 1.0
    grid_size: float = GRID_SIZE

    def __post_init__(self):
        reason = "more iterations do not converge"
        steps = check_count("max_iterations", self.max_iterations, minimum=0, maximum=MAX_ITERATIONS, because=reason)
        object.__setattr__(self, "max_iterations", steps)
        for name in ("voxel_size", "distance_threshold", "regularizer_weight", "grid_size"):
            value = check_positive(name, getattr(self, name), allow_zero=name == "voxel_size", maximum=LARGEST_NUMBER)
            object.__setattr__(self, name, value)
        object.__setattr__(self, "fitness_threshold", check_fraction("fitness_threshold", self.fitness_threshold))


def run_slac_optimizer_for_fragments(
    fragments: Sequence[PointCloud | str | os.PathLike[str]],
    fragment_pose_graph: PoseGraph,
    params: SLACOptimizerParams | None = None,
    *,
    progress: ReportProgress | None = None,
) -> tuple[PoseGraph, ControlGrid]:
    """Align fragments together with a shared deformation grid that models the camera distortion (SLAC).

    The points of overlapping fragments are paired with their nearest neighbors. Poses and grid take a point-to-plane
    step with an as-rigid-as-possible grid; and so on.

    Args:
        fragments: The clouds, or their files, in node order, each in its camera frame. At least one. All on one device.
        fragment_pose_graph: T_world_fragment as from `global_optimization`, and the edges.
        params: None: the defaults.
        progress: Called with ("slac", steps done, steps in all).

    Returns:
        The graph with new poses, its `report` a RefinementReport; and the grid, whose `deform` is applied to a fragment
        before its new pose. The first fragment of each connected part keeps its pose.

    Raises:
        TypeError, ValueError: Not clouds, a wrong number of nodes, numbers out of range, or an invalid graph.
        FileError, DeviceError: A file cannot be read, or clouds are on different devices.

    Notes:
        Matrix-free (Open3D's dense matrix takes 2.3 GB at 8,000 anchors): about 220 B per point pair, 900 B per anchor
        and 40 B per point. Bitwise reproducible. Zhou and Koltun, "Simultaneous localization and calibration:
        self-calibration of consumer depth cameras", CVPR 2014.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((2000, 3)) * [[1, 1, 0.0]]
        >>> corner = np.concatenate([points, points[:, [2, 0, 1]], points[:, [1, 2, 0]]])
        >>> reg, poses = loom.registration, [np.eye(4), np.eye(4)]
        >>> poses[1][0, 3] = 0.02
        >>> graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in poses], [reg.PoseGraphEdge(0, 1)])
        >>> clouds = [loom.PointCloud(corner), loom.PointCloud(corner)]
        >>> graph, grid = loom.rgbd.run_slac_optimizer_for_fragments(clouds, graph)
        >>> bool(np.abs(graph.nodes[1].pose[:3, 3]).max() < 0.002), bool(graph.report.rmse[-1] < graph.report.rmse[0])
        (True, True)
    """
    job = _Alignment(fragments, fragment_pose_graph, params, progress, bends=True)
    return job.run(), job.grid


def run_rigid_optimizer_for_fragments(
    fragments: Sequence[PointCloud | str | os.PathLike[str]],
    fragment_pose_graph: PoseGraph,
    params: SLACOptimizerParams | None = None,
    *,
    progress: ReportProgress | None = None,
) -> PoseGraph:
    """As `run_slac_optimizer_for_fragments`, with rigid fragments.

    Returns:
        The graph with new poses, its `report` a RefinementReport.

    Raises:
        TypeError, ValueError, FileError, DeviceError: As `run_slac_optimizer_for_fragments`.

    Notes:
        About 180 B per point pair and 40 B per point. Bitwise reproducible.
    """
    return _Alignment(fragments, fragment_pose_graph, params, progress, bends=False).run()


class _Alignment:
    """State between steps. Poses are about the scene center and the grid origin."""

    def __init__(
        self,
        fragments: Sequence[PointCloud | str | os.PathLike[str]],
        graph: PoseGraph,
        params: SLACOptimizerParams | None,
        progress: ReportProgress | None,
        *,
        bends: bool,
    ):
        self.params = SLACOptimizerParams() if params is None else params
        if not isinstance(self.params, SLACOptimizerParams):
            raise TypeError(f"params: expected a SLACOptimizerParams, got {type(params).__name__}")
        self.report_progress = check_progress(progress)
        if not isinstance(graph, PoseGraph):
            raise TypeError(f"fragment_pose_graph: expected a PoseGraph, got {type(graph).__name__}")
        self.graph, given = check_pose_graph(graph), list_clouds("fragments", fragments)
        if len(given) != len(self.graph.poses) or not given:
            raise ValueError(
                f"fragments: expected one for each of the {len(self.graph.poses)} nodes of fragment_pose_graph, "
                f"at least one, got {len(given)}"
            )
        clouds, self.sided = _prepare(given, self.params.voxel_size)
        self.bends, self.edges = bends, list(graph.edges)
        self.grid = ControlGrid(self.params.grid_size, device=clouds[0].device)
        for cloud in clouds if bends else ():
            self.grid.touch(cloud)
        origin = self.grid.origin if len(self.grid) else clouds[0].origin
        parts = [cloud.arrays.about(origin) for cloud in clouds]
        normals = [cloud.arrays["normals"] for cloud in clouds]
        counts = [len(cloud) for cloud in clouds]
        lattice = self.grid.lattice
        self.fragments = Fragments(concatenate_rows(parts), concatenate_rows(normals), counts, lattice)
        self.origin, self.poses = origin, self.graph.poses.copy()
        self.poses[:, :3, :3] = nearest_rotations(self.poses[:, :3, :3])
        self.poses[:, :3, 3] += matmul(self.poses[:, :3, :3], origin)
        self.middle = self.poses[:, :3, 3].mean(axis=0)
        self.poses[:, :3, 3] -= self.middle
        self.fractions = _agreement(clouds, self.graph, self.params.distance_threshold)

    def run(self) -> PoseGraph:
        params, graph = self.params, self.graph
        follows = np.abs(graph.source - graph.target) == 1
        used = follows | (self.fractions >= params.fitness_threshold)
        ends = np.stack([graph.source[used], graph.target[used]], axis=1)
        parts, is_fixed = _parts(ends, len(self.poses))
        first = self.poses.copy()
        pairs = Pairs(ends, self.fragments, params.distance_threshold, MIN_COSINE, sided=self.sided)
        tie = params.regularizer_weight * len(self.poses)
        system = StepSystem(self.fragments.lattice, is_fixed, ends, tie)
        errors, solver_iterations = [], []
        for step in range(params.max_iterations):
            self.report_progress("slac", step, params.max_iterations)
            task = self._task(pairs, system)
            errors.append(task.errors())
            solver_iterations.append(self._step(task))
        self.report_progress("slac", params.max_iterations, params.max_iterations)
        last = self._task(pairs, system)
        errors.append(last.errors())
        if any(solver_iterations):
            self._restore_gauge(first, parts, is_fixed)
        return self._concluded(used, is_fixed, last.rows, errors, solver_iterations)

    def _task(self, pairs: Pairs, system: StepSystem) -> FragmentStep:
        rows = pairs.match(self.poses)
        if not rows.count and len(pairs.ends):
            raise ValueError(
                f"fragments: no point is within {self.params.distance_threshold:g} m (distance_threshold) of a point "
                "of another fragment under the poses of fragment_pose_graph. Check that they are T_world_fragment"
            )
        return FragmentStep(rows, self.fragments.lattice, system)

    def _step(self, task: FragmentStep) -> int:
        if not task.rows.count:
            return 0
        count, lattice = len(self.poses), self.fragments.lattice
        solution, solver_iterations = task.solve()
        motions = np.array(download(solution[: 2 * count]), np.float64).reshape(count, 6)  # sync
        R = rotations_of(motions[:, :3])
        self.poses[:, :3, 3] = matmul(R, self.poses[:, :3, 3, None])[:, :, 0] + motions[:, 3:]
        self.poses[:, :3, :3] = nearest_rotations(matmul(R, self.poses[:, :3, :3]))
        launch(shift_anchors_kernel, lattice.anchor_count, [2 * count, solution, lattice.shifts])
        self.fragments.bend()
        return solver_iterations

    def _restore_gauge(self, first: Array, parts: NDArray[np.int32], is_fixed: NDArray[np.bool_]) -> None:
        """Move common rigid motion from the grid to the poses, and restore the first pose of each part."""
        lattice = self.fragments.lattice
        if self.bends and lattice.anchor_count:
            motion = motion_of(self.fragments.points, self.fragments.moved)  # sync
            back = mat44d(*invert_pose(motion).ravel())
            given = [lattice.anchor_keys, lattice.cell_size, back, lattice.shifts]
            launch(move_anchors_kernel, lattice.anchor_count, given)
            self.poses = matmul(self.poses, motion)
        for node in np.flatnonzero(is_fixed):
            part = parts == parts[node]
            self.poses[part] = matmul(first[node], invert_pose(self.poses[node]), self.poses[part])

    def _concluded(
        self,
        used: NDArray[np.bool_],
        is_fixed: NDArray[np.bool_],
        rows: FragmentRows,
        errors: list[tuple[float, int, float]],
        solver_iterations: list[int],
    ) -> PoseGraph:
        """The graph at the new poses. Fixed ones stay bitwise unchanged."""
        poses = self.poses.copy()
        poses[:, :3, 3] += self.middle - matmul(poses[:, :3, :3], self.origin)
        poses[is_fixed] = self.graph.poses[is_fixed]
        counts = np.zeros(len(used), np.int64)
        counts[used] = np.diff(rows.starts)
        edges = self.graph
        overlaps = [
            FragmentOverlap(int(s), int(t), float(fraction), bool(use), int(count))
            for s, t, fraction, use, count in zip(edges.source, edges.target, self.fractions, used, counts, strict=True)
        ]
        squares, number, stretch = np.array(errors, np.float64).T
        solved = PoseGraph([PoseGraphNode(T) for T in poses], [dataclasses.replace(edge) for edge in self.edges])
        rmse = np.sqrt(squares / np.maximum(number, 1))
        counts_of = number.astype(np.int64)
        solved.report = RefinementReport(overlaps, rmse, counts_of, stretch, np.array(solver_iterations, np.int64))
        return solved


def _prepare(given: Sequence[Any], voxel_size: float) -> tuple[list[PointCloud], bool]:
    clouds, sided = [], True
    for i, item in enumerate(given):
        cloud = read_point_cloud(item) if isinstance(item, str | Path | os.PathLike) else item
        check_cloud(f"fragments[{i}]", cloud)
        if clouds:
            check_same_device(f"fragments[{i}]", clouds[0].device, cloud.device)
        sided = sided and "normals" in cloud
        if voxel_size:
            cloud = cloud.voxel_down_sample(voxel_size)
        cloud = cloud.remove_statistical_outlier(OUTLIER_NEIGHBORS, OUTLIER_DEVIATIONS)[0]
        if voxel_size or "normals" not in cloud:
            cloud = cloud.estimate_normals(max_nn=NORMAL_NEIGHBORS)
        clouds.append(cloud)
    common_reference("fragments", clouds)
    return clouds, sided


def _agreement(clouds: Sequence[PointCloud], graph: GraphArrays, distance: float) -> Array:
    """Fraction of each edge's point pairs that agree with the node poses, 0..1."""
    counted = []
    for s, t, T in zip(graph.source, graph.target, graph.transformations, strict=True):
        source, target = clouds[s], clouds[t]
        points, local = source.arrays["points"], to_local(T, source.origin, target.origin)
        queries = transform_points(points, local[:3, :3], local[:3, 3])
        nearest = find_nearest(target.search_tree(), queries, radius=distance, order=source.search_tree().order)
        ends = (source.origin, target.origin), (graph.poses[s], graph.poses[t])
        counted.append(count_agreeing(points, target.arrays["points"], nearest, *ends, distance))
    if not counted:
        return np.zeros(0)
    matches, agreeing = download(concatenate_rows(counted)).T  # sync
    return agreeing / np.maximum(matches, 1)


def _parts(ends: NDArray[np.int64], count: int) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:
    parts = connected_parts(ends[:, 0], ends[:, 1], count)
    is_fixed = np.zeros(count, bool)
    is_fixed[np.unique(parts, return_index=True)[1]] = True
    return parts, is_fixed
