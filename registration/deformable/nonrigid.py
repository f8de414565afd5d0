"""Bodies that bend: one cloud brought onto another by a deformation graph."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import KDTree

from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_finite,
    check_list,
    check_positive,
    check_progress,
    check_rows,
)
from ...core.progress import ReportProgress
from ...core.told_arguments import told_arguments
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.quantiles import quantiles_of
from ...kernels.bending.bending_steps import BendingSteps
from ...kernels.bending.deformation_graph import (
    DeformationGraph,
    Influence,
    bend_normals,
    bend_points,
    measure_strain,
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
from ..given_pairs import check_clouds
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.icp import check_poses, registration_icp
from ..rigid import fit_pose, to_local
from .deformation import Deformation
from .nonrigid_result import NonRigidResult

Array = NDArray[np.float64]
_Tell = Callable[[int, int], None]
STIFFNESS = (100.0, 10.0, 1.0, 0.1)
NODES_ACROSS = 16  # of the diagonal of the body's box
MOST_ACROSS = 1000
LEAST_COSINE = 0.5  # 60 degrees: beyond that two points lie on two surfaces
POINT_WEIGHT = 0.1  # of the distance to the plane: keeps points from sliding off along flat places
NORMAL_NEIGHBORS = 20
FEWEST_POINTS = 10
TRIM = 4.0  # times the median distance of pairs: what lies farther in the end does not belong
DOUBTED_STRAIN = 0.12  # from here on the body is tried turned round as well
BETTER = 0.75  # of the strain: a start that needs less was the right one


@told_arguments
def register_nonrigid(
    source: PointCloud,
    target: PointCloud,
    *,
    node_spacing: float | None = None,
    max_distance: float | None = None,
    init: ArrayLike | None = None,
    landmarks: tuple[ArrayLike, ArrayLike] | None = None,
    landmark_weight: float = 10.0,
    stiffness: Sequence[float] = STIFFNESS,
    max_iteration: int = 30,
    tolerance: float = 1e-3,
    progress: ReportProgress | None = None,
) -> NonRigidResult:
    """Bend a body onto another scan of it.

    ICP brings the source near; then nodes on it turn and move so that its points come to the target's surface, first
    stiffly, then ever more softly. Points whose partner is too far, turned by more than 60 degrees or on the target's
    border have none, so the target may show a part of the body.

    Args:
        source: The body that bends, at least ten points. Normals are estimated where it has none.
        target: What it is brought to, on the same device; likewise.
        node_spacing: About how far nodes are apart [m]; None: a sixteenth of the source's diagonal.
        max_distance: Points farther apart are no pair [m]; None: two node spacings.
        init: Pose to begin from, T_target_source, 4x4; None: that of three or more landmarks, else the identity.
        landmarks: (places on the source, where they belong), both [l, 3] [m] in world coordinates.
        landmark_weight: What a landmark counts, beside one for what all points of a node count together.
        stiffness: What the ties of a node count in that unit, from stiff to soft.
        max_iteration: Steps at each stiffness.
        tolerance: A stiffness has settled where nodes move by less than this share of their spacing.
        progress: Called with ("bend" or "bend, turned round", stages done, stages in all).

    Returns:
        The result; check `reliable` and `is_rigid`.

    Raises:
        TypeError, ValueError: No clouds, too few points, numbers out of range, or landmarks that are not finite, lie
            off the source or contradict each other; or no point of the source near the target.
        DeviceError: Clouds on different devices.

    Notes:
        Where a surface is smooth nothing holds points along it, and they may slide by a third of a node spacing and
        more; landmarks hold them (docs/bending.md has figures).
        A body that really stretches by more than 22 % is reported as unreliable. Where the strain is above 12 % and
        there are fewer than three landmarks, starts half a turn away are tried too; the one of least strain is taken,
        or named where `init` was given. About 500 B a source point and 2 kB a node. The same bits from run to run.
        Source: Sumner, Schmid and Pauly 2007; Li, Sumner and Pauly 2008; stiffness in steps as in Amberg, Romdhani and
        Vetter 2007.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 3000))
        >>> flat = loom.PointCloud(np.column_stack([x, y, 0.1 * np.sin(4 * x)]))
        >>> bent = loom.PointCloud(np.column_stack([x, y, 0.1 * np.sin(4 * x) + 0.1 * x * x]))
        >>> found = loom.registration.register_nonrigid(flat, bent)
        >>> found.rmse < 0.005, found.is_rigid, found.reliable
        (True, False, None)
    """
    check_clouds(source, target)
    tell = check_progress(progress)
    steps = [check_positive("stiffness", value, maximum=1e6) for value in check_list("stiffness", stiffness, "numbers")]
    if not steps:
        raise ValueError("stiffness: expected at least one number")
    turns = check_count("max_iteration", max_iteration, minimum=1, maximum=1000)
    share = check_positive("tolerance", tolerance)
    weight = check_positive("landmark_weight", landmark_weight, maximum=1e6)
    for name, cloud in (("source", source), ("target", target)):
        if cloud.search_tree().count < FEWEST_POINTS:
            raise ValueError(
                f"{name}: expected at least {FEWEST_POINTS} finite points, got {cloud.search_tree().count}"
            )
    low, high = (np.asarray(bound) for bound in source._device_bounds())
    spacing = _check_spacing(node_spacing, float(norm(high - low)))
    limit = None if max_distance is None else check_positive("max_distance", max_distance, maximum=LARGEST_NUMBER)
    reach = 2 * spacing if limit is None else limit
    pins = _check_landmarks(landmarks, low, high, spacing)
    start = None if init is None else check_poses("init", init, TransformationEstimationPointToPlane())

    def bend(begin: Array | None, phase: str) -> NonRigidResult:
        job = _Bending(source, target, spacing, reach, begin, pins, weight)
        return job.run(steps, turns, share * spacing, partial(tell, phase))

    found = bend(start, "bend")
    if found.strain <= DOUBTED_STRAIN or len(pins[0]) >= 3:
        return found
    return _turned_round(source, found, bend, is_given=init is not None)


def _turned_round(source: PointCloud, found: NonRigidResult, bend: Any, *, is_given: bool) -> NonRigidResult:
    """The bend that needs least strain of the one found and three whose starts are half a turn away.

    Where the start was given it stays, and the better one is named. Half turns about the body's principal axes, since
    ICP lays a body along the one that it is brought to before it finds its ends.
    """
    points = source.remove_non_finite_points().points
    center, best, begin = points.mean(axis=0), found, None
    for axis in eigh(matmul((points - center).T, points - center) / max(len(points) - 1, 1))[1].T:
        turn = map_about(2 * np.outer(axis, axis) - np.eye(3), center)
        try:
            other = bend(matmul(found.rigid_pose, turn), "bend, turned round")
        except ValueError:  # no point near the target from there
            continue
        if other.strain < BETTER * best.strain and other.matched >= 0.98 * best.matched:
            best, begin = other, matmul(found.rigid_pose, turn)
    if begin is None or not is_given:
        return best
    return replace(found, better_start=begin)


def _check_spacing(value: float | None, diagonal: float) -> float:
    if diagonal <= 0:
        raise ValueError("source: all of its points are at one place")
    if value is None:
        return diagonal / NODES_ACROSS
    spacing = check_positive("node_spacing", value)
    if not diagonal / MOST_ACROSS <= spacing <= MOST_ACROSS * diagonal:
        raise ValueError(
            f"node_spacing: expected {diagonal / MOST_ACROSS:g} to {MOST_ACROSS * diagonal:g} m, a thousandth to a "
            f"thousandfold of the diagonal of the source's box, got {spacing:g}"
        )
    return spacing


def _check_landmarks(landmarks: Any, low: Array, high: Array, spacing: float) -> tuple[Array, Array]:
    if landmarks is None:
        return np.zeros((0, 3)), np.zeros((0, 3))
    if not isinstance(landmarks, tuple | list) or len(landmarks) != 2:
        raise ValueError("landmarks: expected two arrays, places on the source and where they belong")
    here = check_finite("landmarks[0]", check_rows("landmarks[0]", landmarks[0], 3, dtype=np.float64))
    there = check_rows("landmarks[1]", landmarks[1], 3, rows=len(here), dtype=np.float64)
    off = np.maximum(np.maximum(low - here, here - high), 0).max(axis=1, initial=0)
    if len(here) and off.max() > 2 * spacing:
        k = int(off.argmax())
        raise ValueError(
            f"landmarks[0]: place {k} lies {off[k]:g} m outside of the source's box; "
            "give places on the source first, in its world coordinates"
        )
    check_finite("landmarks[1]", there)
    _refuse_contradictions(here, there, spacing)
    return here, there


def _refuse_contradictions(here: Array, there: Array, spacing: float) -> None:
    """Two places less than a node spacing apart bend by the same nodes: they do not come to belong one more apart."""
    if len(here) < 2:
        return
    a, b = KDTree(here).query_pairs(spacing, output_type="ndarray").reshape(-1, 2).T
    before, after = (np.linalg.norm(places[a] - places[b], axis=1) for places in (here, there))
    if (after - before > spacing).any():
        k = int((after - before).argmax())
        raise ValueError(
            f"landmarks: places {min(a[k], b[k])} and {max(a[k], b[k])} are {before[k]:g} m apart and belong "
            f"{after[k]:g} m apart, which no bend of nodes {spacing:g} m apart does; leave one of them out, or give a "
            "smaller node_spacing"
        )


class _Bending:
    """The state between steps."""

    def __init__(
        self, source: PointCloud, target: PointCloud, spacing: float, reach: float, init: Any, pins: Any, weight: float
    ):
        self.sided = bool(source.has_normals and target.has_normals)
        self.source, self.target = (
            cloud if cloud.has_normals else cloud.estimate_normals(max_nn=NORMAL_NEIGHBORS)
            for cloud in (source, target)
        )
        self.spacing, self.reach, self.pins = spacing, reach, pins
        low, high = source._device_bounds()
        # what lies on the target is judged at the scale of the body where nodes are farther apart
        self.grain = min(spacing, float(norm(np.asarray(high) - np.asarray(low))) / NODES_ACROSS)
        if init is None and len(pins[0]) >= 3:
            init = fit_pose(*pins)
        method = TransformationEstimationPointToPlane()
        found = registration_icp(self.source, self.target, reach, init, method, overlap=None)
        if found.fitness == 0 and not len(pins[0]):
            raise ValueError(
                f"source, target: no point of the source lies within {reach:g} m (max_distance) of the target; give an "
                "init that brings them near (register_globally finds one), landmarks, or a larger max_distance"
            )
        self.pose, tree = found.transformation, self.target.search_tree()
        self.tree, self.count = tree, len(source)
        normals = self.target._device_array("normals")
        self.surface = Surface(tree.source, normals, find_borders(tree, normals))
        self._make_graph(weight)
        device = tree.device
        self.partners, self.distances = empty(self.count, int32, device), empty(self.count, float64, device)

    def _make_graph(self, weight: float) -> None:
        source, device, (here, there) = self.source, self.tree.device, self.pins
        thin = source.remove_non_finite_points()
        chosen = thin.farthest_point_down_sample(len(thin.voxel_down_sample(self.spacing)))
        nodes = chosen._points_about(source.origin)
        T = to_local(self.pose, source.origin, self.target.origin)
        host = np.asarray(download(nodes), np.float64).reshape(-1, 3)
        rotations = upload(np.tile(T[:3, :3], (len(host), 1, 1)), mat33d, device)
        self.graph = DeformationGraph(nodes, rotations, upload(matmul(host, T[:3, :3].T) + T[:3, 3], vec3d, device))
        points = source._device_array("points")
        self.influence = Influence(points, self.graph)
        around = neighbors_of(self.graph, self.influence)
        self.around, everything = around, self.influence
        if len(here):
            pinned = upload((here - source.origin).astype(np.float32), vec3, device)
            everything = Influence(concatenate_rows([points, pinned]), self.graph)
        self.steps = BendingSteps(self.graph, everything, around)
        if len(here):
            places = upload(there - self.target.origin, vec3d, device)
            launch(pin_rows_kernel, len(here), [self.count, places, weight, self.steps.rows])
        each = self.graph.count / max(source.search_tree().count, 1)
        self.rule = PairRule(LEAST_COSINE, self.sided, each, POINT_WEIGHT * each)

    def _pair(self, reach: float) -> Any:
        """Find the pairs within a distance; the bent points."""
        moved = bend_points(self.graph, self.influence)
        normals = bend_normals(self.graph, self.influence, self.source._device_array("normals"))
        nearest = find_nearest(self.tree, moved, radius=reach)
        found = [self.rule, self.steps.rows, self.partners, self.distances]
        launch(pair_points_kernel, self.count, [moved, normals, nearest, self.surface, *found])
        return moved

    def run(
        self, stiffness: Sequence[float], turns: int, still: float, tell: Callable[[int, int], None]
    ) -> NonRigidResult:
        """All steps."""
        moved = self._pair(self.reach)
        unbent = self._measure(moved)
        taken, settled = 0, True
        for stage, value in enumerate(stiffness):
            tell(stage, len(stiffness))
            shift = np.inf
            for _ in range(turns):
                shift = self.steps.take(value)
                taken += 1
                self._pair(self._limit(stage, len(stiffness)))
                if shift < still:
                    break
            settled = settled and shift < still
        tell(len(stiffness), len(stiffness))
        return self._conclude(unbent, taken, settled)

    def _limit(self, stage: int, stages: int) -> float:
        """How far apart pairs may be: in the softer half of all steps what is far beside the others is none."""
        if 2 * stage < stages:
            return self.reach
        medians = quantiles_of(self.distances, [0.5])  # sync
        return min(self.reach, max(TRIM * medians[0], 0.25 * self.spacing)) if medians else self.reach

    def _measure(self, moved: Any) -> tuple[Array, float, float]:
        """The residuals, the share of the source on the target, their rmse."""
        residuals = empty(self.count, float64, self.tree.device)
        launch(measure_residuals_kernel, self.count, [moved, self.partners, self.surface, residuals])
        values = np.array(download(residuals))  # sync
        values[values < 0] = np.nan
        paired = np.isfinite(values)
        near = paired & (np.nan_to_num(values, nan=np.inf) <= 0.1 * self.grain)
        rmse = float(np.sqrt((values[paired] ** 2).mean())) if paired.any() else float("nan")
        return values, float(near.sum()) / max(self.source.search_tree().count, 1), rmse

    def _conclude(self, unbent: tuple[Array, float, float], taken: int, settled: bool) -> NonRigidResult:
        residuals, matched, rmse = self._measure(self._pair(self._limit(1, 1)))
        deformation = Deformation(self.graph, self.source.origin, self.target.origin)
        warped = deformation.transform(self.source)
        reached = find_nearest(PointTree(warped._points_about(self.target.origin)), self.tree.source)
        covered = _share_within(reached, 0.5 * self.grain, self.tree.count)
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
            taken,
            settled,
            self.spacing,
            self.tree.source.size,
        )


def _share_within(nearest: Any, distance: float, count: int) -> float:
    """The share of points whose nearest one lies within a distance."""
    keys = np.asarray(download(nearest), np.int64)
    squares = (keys >> 32).astype(np.int32).view(np.float32)
    return float(((keys >= 0) & (squares <= distance * distance)).sum()) / max(count, 1)
