"""Multiway registration: pairwise global registration, spanning tree, and pose graph with loop closures."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_list,
    check_positive,
    check_progress,
    check_rigid,
    check_seed,
    shown,
)
from ...core.devices import check_same_device
from ...core.observers import report
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, failed, quality, with_warnings
from ...core.wording import few_of, plain
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud, list_clouds
from ...pcd.units import common_reference
from ..assessment_constants import MIN_SCORE
from ..globally.global_registration import Description, describe_each, register_described
from ..globally.level_poses import check_level
from ..icp.constraint import MOTIONS
from ..pose_errors import PoseCovariance
from .fragment_errors import fragment_covariances
from .fragment_graph import (
    Extent,
    FragmentGraph,
    FragmentPair,
    loop_candidates,
    overlapping_pairs,
    poses_from_pairs,
    refine_pairs,
    transformed_box,
    with_pairs,
)
from .pose_graph import PoseGraph
from .reports import GlobalOptimizationReport

Matrices = NDArray[np.float64]

ALL_PAIRS = 40  # maximum clouds for all pairs: 780
FOLLOWING_CLOUDS = 5  # following clouds tried with each, if there are more
# Minimum fraction of the source's voxels on the target of a pair in the graph. Below it, practically no surface is
# shared, so the clouds do not support the relative pose.
MIN_FITNESS = 0.02
MAX_LISTED = 5  # clouds or pairs that a warning names
LEVEL_ENOUGH = 1e-6  # [rad] maximum tilt of known level poses


@dataclass(frozen=True, eq=False)
class FragmentsResult(Report, Assessed):
    """Result of `register_multiway`.

    Attributes:
        poses: T_reference_cloud of each cloud, float64 [n, 4, 4]. The identity if not placed.
        placed: Mask of the placed clouds, bool [n].
        reference: Reference cloud: the first of the largest connected group.
        groups: Connected component of each cloud, int [n].
        pose_graph: The optimized graph of the placed clouds, in their order.
        pairs: The accepted pairs.
        voxel_size: Voxel edge [m] of the registration.
        free: Free motions of the poses; None: all.
        reliable, warnings: True if all quality checks passed, and those that failed: clouds that are not placed, pairs
            of the pose graph whose clouds hardly overlap, and an optimization that did not converge.
    """

    poses: Matrices
    placed: NDArray[np.bool_]
    reference: int
    groups: NDArray[np.int64]
    pose_graph: PoseGraph
    pairs: list[FragmentPair]
    voxel_size: float
    free: tuple[str, ...] | None

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy. Empty if the result is reliable."""
        return failed(self._why_not_placed(), *self.graph_warnings)

    @property
    def graph_warnings(self) -> tuple[str, ...]:
        """Failed quality checks of the pose graph of the placed clouds."""
        report = self.pose_graph.report
        optimization = report.warnings if isinstance(report, GlobalOptimizationReport) else ()
        return failed(self._why_no_overlap(), *optimization)

    def _why_not_placed(self) -> str | None:
        lost = np.flatnonzero(~self.placed).tolist()
        if not lost:
            return None
        of_all = f"{len(lost)} of {len(self.placed)} clouds ({few_of([str(i) for i in lost], MAX_LISTED)})"
        remedy = "Use more neighbors or another voxel_size, pass known pairs, or add clouds between them"
        return f"{of_all} match none of the others, so their poses are unknown. {remedy}"

    def _why_no_overlap(self) -> str | None:
        members = np.flatnonzero(self.placed).tolist()
        used = {(members[edge.source_node_id], members[edge.target_node_id]) for edge in self.pose_graph.edges}
        empty = [
            f"{p.source} and {p.target}"
            for p in self.pairs
            if (p.source, p.target) in used and not p.fitness >= MIN_FITNESS
        ]
        if not empty:
            return None
        remedy = "Check the poses of the known pairs, or use a larger voxel_size"
        which = few_of(empty, MAX_LISTED)
        return f"the clouds of {len(empty)} pairs hardly overlap at their relative poses ({which}). {remedy}"

    @property
    def trajectory(self) -> Trajectory:
        """The poses as a Trajectory."""
        indices = np.flatnonzero(self.placed)
        ids = np.stack([indices, indices, np.full(len(indices), len(self.placed))], axis=1)
        return Trajectory(self.poses[indices], ids=ids)

    @property
    def loop_count(self) -> int:
        """Number of uncertain edges of the pose graph."""
        return sum(edge.uncertain for edge in self.pose_graph.edges)

    def merge(self, clouds: Sequence[PointCloud]) -> PointCloud:
        """The clouds at their poses as one cloud."""
        clouds = self._check_clouds(clouds)
        return PointCloud.concatenate([clouds[i].transform(self.poses[i]) for i in np.flatnonzero(self.placed)])

    def pose_covariances(self, clouds: Sequence[PointCloud]) -> list[PoseCovariance]:
        """Compute the covariance of the error of each pose relative to the reference.

        Args:
            clouds: The registered clouds, in their order.

        Returns:
            A `PoseCovariance` for each cloud, along the axes of the reference, about the cloud's data. Zero for the
            reference. Infinite for clouds that are not placed, or that no pair with correspondences determines.

        Raises:
            TypeError, ValueError: Not the number of clouds that were registered, or not point clouds.
            DeviceError: Clouds on different devices.

        Notes:
            Each edge of the graph has the error of `assess_registration`, independent of the others. The graph's
            weights propagate the errors to the poses. Edges whose surfaces hardly match are as uncertain as the cloud
            is large. Memory O(points) and O(edges x n). Bitwise reproducible. The coverage is in docs/trust.md.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 20000))
            >>> surface = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.1 * np.sin(5 * y + x)])
            >>> clouds = [loom.PointCloud(surface[:12000]), loom.PointCloud(surface[8000:])]
            >>> result = loom.registration.register_multiway(clouds, voxel_size=0.1)
            >>> [bool(found.sigmas.max() < 0.01) for found in result.pose_covariances(clouds)]
            [True, True]
        """
        clouds, infinite = self._check_clouds(clouds), np.full((6, 6), np.inf)
        found = [PoseCovariance(infinite, T[:3, 3].copy()) for T in self.poses]
        members = np.flatnonzero(self.placed).tolist()
        motions = [i for i, name in enumerate(MOTIONS) if self.free is None or name in self.free]
        graph = self.pose_graph, [clouds[i] for i in members]
        for i, covariance in zip(members, fragment_covariances(*graph, self.voxel_size, motions), strict=True):
            found[i] = covariance
        return found

    def _check_clouds(self, clouds: object) -> list[PointCloud]:
        checked = _check_clouds(clouds)
        if len(checked) != len(self.placed):
            raise ValueError(f"clouds: expected {len(self.placed)}, as many as were registered, got {len(checked)}")
        return checked

    def to_dict(self, names: Sequence[str] | None = None) -> dict[str, Any]:
        called = range(len(self.placed)) if names is None else names
        return plain(
            {
                "clouds": list(called),
                "not_placed": [name for name, is_placed in zip(called, self.placed, strict=True) if not is_placed],
                "reference": called[self.reference],
                "poses": [T if is_placed else None for T, is_placed in zip(self.poses, self.placed, strict=True)],
                "pairs": len(self.pairs),
                "edges": len(self.pose_graph.edges),
                "loops": self.loop_count,
                "registered": [
                    {"source": called[p.source], "target": called[p.target], "fitness": p.fitness, "score": p.score}
                    for p in self.pairs
                ],
                **quality(self),
            }
        )

    def fields(self) -> Fields:
        edges = f"{len(self.pairs):,} that overlap, {len(self.pose_graph.edges):,} of them kept in the pose"
        fields = [
            ("clouds", f"{self.placed.sum()} of {len(self.placed)} placed"),
            ("pairs", f"{edges} graph, {self.loop_count:,} to close loops"),
            ("frame", f"that of {self.reference}"),
        ]
        return with_warnings(fields, self)


def register_multiway(
    clouds: Sequence[PointCloud],
    *,
    voxel_size: float,
    neighbors: int | None = None,
    seed: int = 0,
    known: Sequence[FragmentPair] = (),
    pairs: Sequence[tuple[int, int]] | None = None,
    free: Sequence[str] | None = None,
    progress: ReportProgress | None = None,
) -> FragmentsResult:
    """Register many clouds of one scene without initial poses.

    Pairs are registered globally and refined. A tree of mutually consistent pairs gives initial poses. The others are
    loop closures of a pose graph, which removes wrong ones. Then new overlapping pairs are added.

    Args:
        clouds: At least one, all on one device, in capture order if there is one.
        voxel_size: Voxel edge [m], as of `register_globally`. Poses are far more accurate.
        neighbors: Number of following clouds to try for each cloud; None: all pairs up to 40 clouds, else the next 5.
        seed: As of `register_globally`.
        known: Pairs with known poses (odometry), refined but not globally registered. Their score is their confidence.
        pairs: Index pairs to try; None: by `neighbors`.
        free: None, or ("x", "y", "z", "yaw") for level clouds (`leveled`) and level known pairs: no pose tilts.
        progress: Called with ("pairs", pairs done, pairs in all).

    Returns:
        The poses, and the mask of placed clouds. The result is unreliable if there are clouds without overlap.

    Raises:
        ValueError: No clouds, a known pair of missing clouds, or as `register_globally`.
        DeviceError: Clouds on different devices.

    Notes:
        Memory O(total points). Bitwise reproducible. Choi, Zhou and Koltun, "Robust reconstruction of indoor scenes",
        CVPR 2015, sections 4 and 5.
    """
    size = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    clouds, chooser = _check_clouds(clouds), check_seed(seed)
    if not clouds:
        raise ValueError("clouds: expected at least one, got none")
    common_reference("clouds", clouds)
    report_progress, level = check_progress(progress), check_level(free)
    accepted = check_known(known, len(clouds), level)
    given = {frozenset((pair.source, pair.target)) for pair in accepted}
    tried = [ends for ends in pairs_to_try(len(clouds), neighbors, pairs) if frozenset(ends) not in given]
    described = describe_each(clouds, size)
    for done, (i, j) in enumerate(tried):
        report_progress("pairs", done, len(tried))
        pair, _ = try_pair(j, i, described[j], described[i], chooser, level)
        accepted += [pair] if pair.score > MIN_SCORE else []
    report_progress("pairs", len(tried), len(tried))
    surfaces = [d.thinned for d in described]
    accepted, information = refine_pairs(surfaces, accepted, size, level)
    extents = [Extent.of(surface) for surface in surfaces]
    fragments = poses_from_pairs(extents, accepted, information, size, level)
    boxes = [transformed_box(surfaces[m], fragments.poses[m]) for m in fragments.members]
    closing = overlapping_pairs(surfaces, loop_candidates(boxes, fragments.poses, fragments.members, accepted), size)
    if closing:
        more, more_information = refine_pairs(surfaces, closing, size, level)
        accepted, information = [*accepted, *more], [*information, *more_information]
        fragments = with_pairs(fragments, accepted, information, size, level)
    result = fragments_result(fragments, accepted, size, level)
    report("fragments", clouds=clouds, poses=result.poses, placed=result.placed)
    return result


def _check_clouds(clouds: object) -> list[PointCloud]:
    """A list of point clouds on one device."""
    checked = list_clouds("clouds", clouds)
    for i, cloud in enumerate(checked):
        check_cloud(f"clouds[{i}]", cloud)
        check_same_device(f"clouds[{i}]", checked[0].device, cloud.device)
    return checked


def try_pair(
    source: int, target: int, left: Description, right: Description, seed: int, free: Sequence[str] | None = None
) -> tuple[FragmentPair, str]:
    """Register two clouds globally. Also the problem if the score is not above MIN_SCORE."""
    result = register_described(left, right, seed=seed, free=free)
    pair = FragmentPair(source, target, result.transformation, result.fitness, result.score or 0.0)
    return pair, "; ".join(result.warnings)


def fragments_result(
    fragments: FragmentGraph, pairs: list[FragmentPair], size: float, free: Sequence[str] | None
) -> FragmentsResult:
    poses, is_placed = fragments.poses.copy(), np.zeros(len(fragments.poses), bool)
    is_placed[fragments.members] = True
    poses[~is_placed] = np.eye(4)
    reference, motions = int(fragments.members[0]), None if free is None else tuple(free)
    return FragmentsResult(poses, is_placed, reference, fragments.groups, fragments.graph, pairs, size, motions)


def pairs_to_try(count: int, neighbors: int | None, pairs: Iterable[tuple[int, int]] | None) -> list[tuple[int, int]]:
    if pairs is None:
        nearby = count if count <= ALL_PAIRS else FOLLOWING_CLOUDS
        span = nearby if neighbors is None else check_count("neighbors", neighbors)
        return [(i, j) for i in range(count) for j in range(i + 1, min(i + span, count - 1) + 1)]
    if neighbors is not None:
        raise ValueError("neighbors, pairs: expected one of them, got both")
    selected = set()
    for k, ends in enumerate(check_list("pairs", pairs, "pairs of indices")):
        if not isinstance(ends, Sequence | np.ndarray) or isinstance(ends, str) or len(ends) != 2:
            raise ValueError(f"pairs[{k}]: expected two indices, got {shown(ends)}")
        i, j = (
            check_count(f"pairs[{k}]", end, minimum=0, maximum=count - 1, because=f"there are {count} clouds")
            for end in ends
        )
        if i == j:
            raise ValueError(f"pairs[{k}]: expected two clouds, got {i} twice")
        selected.add((min(i, j), max(i, j)))
    return sorted(selected)


def check_known(known: Sequence[FragmentPair], count: int, free: Sequence[str] | None = None) -> list[FragmentPair]:
    pairs = check_list("known", known, "FragmentPair")
    for k, pair in enumerate(pairs):
        if not isinstance(pair, FragmentPair):
            raise TypeError(f"known[{k}]: expected a FragmentPair, got {type(pair).__name__}")
        for end in (pair.source, pair.target):
            check_count(f"known[{k}]", end, minimum=0, maximum=count - 1, because=f"there are {count} clouds")
        if pair.source == pair.target:
            raise ValueError(f"known[{k}]: expected two clouds, got {pair.source} twice")
        T = check_rigid(f"known[{k}].transformation", pair.transformation)
        tilt = float(np.hypot(T[0, 2], T[1, 2]))
        if free is not None and tilt > LEVEL_ENOUGH:
            raise ValueError(
                f"known[{k}].transformation: expected no tilt, as free= has none, got {np.degrees(tilt):.3g} degrees"
            )
        check_positive(f"known[{k}].score", pair.score)
    return pairs
