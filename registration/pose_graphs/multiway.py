"""Many clouds of one scene brought into one frame: pairs from no guess, a tree of them, a pose graph, closed loops."""

from __future__ import annotations

from collections.abc import Sequence
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
from ...core.progress import ReportProgress
from ...core.reports import Fields, Report
from ...core.units import common_unit
from ...core.watching import report
from ...core.wording import plain
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..globally.global_registration import Description, describe, register_described
from ..globally.level_poses import check_level
from .fragment_graph import (
    Extent,
    FragmentGraph,
    FragmentPair,
    box_under,
    candidates_to_close,
    place_by_pairs,
    refine_pairs,
    those_that_overlap,
    with_pairs,
)
from .pose_graph import PoseGraph

Matrices = NDArray[np.float64]

ALL_PAIRS = 40  # clouds up to which every pair is tried: 780 pairs
NEARBY = 5  # clouds that follow one, each tried with it, where there are more
SURE = 0.5  # score above which a pair is accepted
LEVEL_ENOUGH = 1e-6  # [rad] that a known pose of level clouds may tilt


@dataclass(frozen=True, eq=False)
class FragmentsResult(Report):
    """Where clouds lie in the frame of one of them; `print` shows it as `pointloom multiway` does.

    Attributes:
        poses: T_reference_cloud of each cloud, float64 [n, 4, 4]; the identity where a cloud could not be placed.
        placed: Whether each cloud was placed, bool [n].
        reference: The cloud whose frame it is: the first of the largest group of clouds that hang together.
        groups: Which clouds hang together by pairs, int [n]: equal numbers do.
        pose_graph: The optimised graph over the placed clouds, its nodes in their order.
        pairs: The accepted pairs.
    """

    poses: Matrices
    placed: NDArray[np.bool_]
    reference: int
    groups: NDArray[np.int64]
    pose_graph: PoseGraph
    pairs: list[FragmentPair]

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the clouds that were placed; the first number of each is that of its cloud, from 0."""
        placed = np.flatnonzero(self.placed)
        ids = np.stack([placed, placed, np.full(len(placed), len(self.placed))], axis=1)
        return Trajectory(self.poses[placed], ids=ids)

    @property
    def loop_count(self) -> int:
        """How many edges of the pose graph close loops."""
        return sum(edge.uncertain for edge in self.pose_graph.edges)

    def merge(self, clouds: Sequence[PointCloud]) -> PointCloud:
        """The clouds that were placed as one, in the frame of the reference, with the attributes that all of them have.

        Args:
            clouds: Those that were registered, or others in their frames, in the same order.

        Raises:
            TypeError: Not point clouds.
            ValueError: Not as many as were registered.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 4000))
            >>> surface = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
            >>> clouds = [loom.PointCloud(surface[x < 0.6]), loom.PointCloud(surface[x > -0.6] + [1, 2, 3])]
            >>> found = loom.registration.register_fragments(clouds, voxel_size=0.08)
            >>> len(found.merge(clouds)) == len(clouds[0]) + len(clouds[1])
            True
        """
        clouds = check_list("clouds", clouds, "point clouds")
        for i, cloud in enumerate(clouds):
            check_cloud(f"clouds[{i}]", cloud)
        if len(clouds) != len(self.placed):
            raise ValueError(f"clouds: expected {len(self.placed)}, as many as were registered, got {len(clouds)}")
        return PointCloud.concatenate([clouds[i].transform(self.poses[i]) for i in np.flatnonzero(self.placed)])

    def to_dict(self, names: Sequence[str] | None = None) -> dict[str, Any]:
        """All of it in JSON's types; clouds are called by their numbers, from 0, or by these names."""
        called = range(len(self.placed)) if names is None else names
        return plain(
            {
                "clouds": list(called),
                "not_placed": [name for name, placed in zip(called, self.placed, strict=True) if not placed],
                "reference": called[self.reference],
                "poses": [T if placed else None for T, placed in zip(self.poses, self.placed, strict=True)],
                "pairs": len(self.pairs),
                "edges": len(self.pose_graph.edges),
                "loops": self.loop_count,
                "registered": [
                    {"source": called[p.source], "target": called[p.target], "fitness": p.fitness, "score": p.score}
                    for p in self.pairs
                ],
            }
        )

    def fields(self) -> Fields:
        """How many clouds were placed, by which pairs, and in whose frame."""
        edges = f"{len(self.pairs):,} that lie on each other, {len(self.pose_graph.edges):,} of them kept in the pose"
        return [
            ("clouds", f"{self.placed.sum()} of {len(self.placed)} placed"),
            ("pairs", f"{edges} graph, {self.loop_count:,} to close loops"),
            ("frame", f"that of {self.reference}"),
        ]


def register_fragments(
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
    """Bring many clouds of one scene into one frame, from no starting poses.

    Pairs are registered from no guess; accepted ones are refined, a tree of the pairs that most
    others agree with gives first poses, and the rest are loop closures of a pose graph, which drops the wrong ones.
    Then pairs that turn out to overlap are registered too, and the graph is optimised again.

    Args:
        clouds: At least one, all on one device; in the order they were taken if there is one.
        voxel_size: Edge of a voxel [m], as of `register_globally`; poses end up far finer than it.
        neighbors: How many of the clouds that follow it each cloud is tried with; None tries every pair of up to 40
            clouds, and the next 5 of more.
        seed: As of `register_globally`.
        known: Pairs whose pose is known from elsewhere, as from odometry: they are refined with the others, and not
            registered from no guess. Their score is their confidence beside those that are found.
        pairs: The pairs of clouds to try, by their indices; None for those that `neighbors` says.
        free: None, or ("x", "y", "z", "yaw") for clouds that are all level (`levelled`): pairs are sought, refined and
            adjusted in these motions, and no pose tilts. Known pairs have to be level, too.
        progress: Called with ("pairs", pairs done, pairs in all) while pairs are registered.

    Returns:
        Poses, and which clouds could be placed; a cloud that overlaps no other is left out and said to be.

    Raises:
        ValueError: No clouds, a known pair of clouds that do not exist, or as `register_globally`.
        DeviceError: Clouds on different devices.

    Notes:
        O(total points) memory, and one registration a pair. The same bits from run to run. Choi, Zhou and Koltun 2015,
        sections 4 and 5.
    """
    size = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    clouds, chooser = check_list("clouds", clouds, "point clouds"), check_seed(seed)
    if not clouds:
        raise ValueError("clouds: expected at least one, got none")
    for i, cloud in enumerate(clouds):
        check_cloud(f"clouds[{i}]", cloud)
        check_same_device(f"clouds[{i}]", clouds[0].device, cloud.device)
    common_unit("clouds", (cloud.unit for cloud in clouds))
    tell, level = check_progress(progress), check_level(free)
    believed = check_known(known, len(clouds), level)
    given = {frozenset((pair.source, pair.target)) for pair in believed}
    tried = [ends for ends in pairs_to_try(len(clouds), neighbors, pairs) if frozenset(ends) not in given]
    described = [describe(cloud, size) for cloud in clouds]
    for done, (i, j) in enumerate(tried):
        tell("pairs", done, len(tried))
        pair, _ = try_pair(j, i, described[j], described[i], chooser, level)
        believed += [pair] if pair.score > SURE else []
    tell("pairs", len(tried), len(tried))
    surfaces = [d.thinned for d in described]
    believed, information = refine_pairs(surfaces, believed, size, level)
    extents = [Extent.of(surface) for surface in surfaces]
    found = place_by_pairs(extents, believed, information, size, level)
    boxes = [box_under(surfaces[m], found.poses[m]) for m in found.members]
    closing = those_that_overlap(surfaces, candidates_to_close(boxes, found.poses, found.members, believed), size)
    if closing:
        more, more_information = refine_pairs(surfaces, closing, size, level)
        believed, information = [*believed, *more], [*information, *more_information]
        found = with_pairs(found, believed, information, size, level)
    result = fragments_result(found, believed)
    report("fragments", clouds=clouds, poses=result.poses, placed=result.placed)
    return result


def try_pair(
    source: int, target: int, left: Description, right: Description, seed: int, free: Sequence[str] | None = None
) -> tuple[FragmentPair, str]:
    """Two clouds registered from no guess, and what speaks against it where its score is not above SURE."""
    found = register_described(left, right, seed=seed, free=free)
    return FragmentPair(source, target, found.transformation, found.fitness, found.score or 0.0), found.reason


def fragments_result(found: FragmentGraph, pairs: list[FragmentPair]) -> FragmentsResult:
    """What is told of a graph and of the pairs that made it."""
    poses, placed = found.poses.copy(), np.zeros(len(found.poses), bool)
    placed[found.members] = True
    poses[~placed] = np.eye(4)
    return FragmentsResult(poses, placed, int(found.members[0]), found.groups, found.graph, pairs)


def pairs_to_try(count: int, neighbors: Any, pairs: Any) -> list[tuple[int, int]]:
    """Pairs of so many clouds, (earlier, later), ascending and each once.

    Raises:
        ValueError: Both are given, or a pair of clouds that do not exist, or of one.
    """
    if pairs is None:
        nearby = count if count <= ALL_PAIRS else NEARBY
        span = nearby if neighbors is None else check_count("neighbors", neighbors)
        return [(i, j) for i in range(count) for j in range(i + 1, min(i + span, count - 1) + 1)]
    if neighbors is not None:
        raise ValueError("neighbors, pairs: expected one of them, got both")
    found = set()
    for k, ends in enumerate(check_list("pairs", pairs, "pairs of indices")):
        if not isinstance(ends, Sequence | np.ndarray) or isinstance(ends, str) or len(ends) != 2:
            raise ValueError(f"pairs[{k}]: expected two indices, got {shown(ends)}")
        i, j = (
            check_count(f"pairs[{k}]", end, minimum=0, maximum=count - 1, because=f"there are {count} clouds")
            for end in ends
        )
        if i == j:
            raise ValueError(f"pairs[{k}]: expected two clouds, got {i} twice")
        found.add((min(i, j), max(i, j)))
    return sorted(found)


def check_known(known: Sequence[FragmentPair], count: int, free: Sequence[str] | None = None) -> list[FragmentPair]:
    """Pairs that are given, once they make sense for so many clouds, and are level where only such are free."""
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
                f"known[{k}].transformation: tilts by {np.degrees(tilt):.3g} degrees, and free= has no tilt"
            )
        check_positive(f"known[{k}].score", pair.score)
    return pairs
