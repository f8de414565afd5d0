"""Fragment poses: odometry links, global registration, and a robust pose graph."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.json_fields import Checks, all_of, has_fields, is_count, is_flag, is_pose, is_text, list_of
from ...core.progress import ReportProgress
from ...core.records import digest_of, files_below, read_record, write_record
from ...pcd.cloud import PointCloud
from ...registration.pose_graphs import multiway
from ...registration.pose_graphs.multiway import FragmentPair
from ...registration.pose_graphs.pose_graph import PoseGraph
from ...registration.pose_graphs.pose_graph_files import read_pose_graph, write_pose_graph
from .config import ReconstructionConfig
from .fragments import Fragment, digest_of_all, fragments_in
from .job_files import JobFiles

Matrix = NDArray[np.float64]

STAGE = "register"
SETTINGS = ("voxel_size", "seed")
VOXEL_DIVISOR = 4.0  # finest downsampling, per voxel edge
ODOMETRY_CONFIDENCE = 1.0  # confidence of odometry links


@dataclass(frozen=True, eq=False)
class Placement:
    """Fragment poses.

    Attributes:
        poses: T_scene_fragment, float64 [n, 4, 4]. The identity if not placed.
        placed: Mask, bool [n].
        groups: Connected component of each fragment, int [n]. The largest is the scene.
        pose_graph: Graph of the placed fragments, in order.
        made_from: Digest of the inputs.
        before: Digest of the refined placement. Empty if there is none.
        fragments: Digest of the fragments.
    """

    poses: Matrix
    placed: NDArray[np.bool_]
    groups: NDArray[np.int64]
    pose_graph: PoseGraph
    made_from: str
    before: str = ""
    fragments: str = ""

    @property
    def members(self) -> list[int]:
        return np.flatnonzero(self.placed).tolist()


def register_fragments(
    config: ReconstructionConfig,
    folder: FilePath,
    *,
    resume: bool = False,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> Placement:
    """Register the fragments in a job's folder.

    Odometry links are refined, and all other pairs are registered globally. A pose graph removes contradicting loops
    (`registration.register_multiway`).

    Args:
        config: As of `make_fragments`.
        folder: Job folder of `make_fragments`.
        resume: Keep a valid earlier result.
        device: Compute device; None: the CPU.
        progress: Called with ("pairs", done, all).

    Returns:
        The fragment poses. Only the largest (then first) connected group is placed.

    Raises:
        TypeError: Not a configuration.
        FileError: No fragments, or a file that cannot be read or written.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible. Memory O(downsampled points of all fragments).
    """
    job, where = JobFiles.make(folder, config), resolve_device(device)
    report_progress = check_progress(progress)
    fragments = fragments_in(job)
    fragments_digest = digest_of_all(fragments)
    made_from = digest_of([fragments_digest, {name: getattr(config, name) for name in SETTINGS}])
    if resume:
        result = read_placement(job, STAGE, len(fragments), made_from)
        if result is not None:
            return result
    clouds = read_clouds(fragments, config, where)
    known = [
        FragmentPair(f.number, f.joint.fragment, f.T_earlier(fragments[f.joint.fragment]), 0.0, ODOMETRY_CONFIDENCE)
        for f in fragments
        if f.joint is not None
    ]
    result = multiway.register_multiway(
        clouds, voxel_size=config.voxel_size, seed=config.seed, known=known, progress=report_progress
    )
    placement = Placement(
        result.poses, result.placed, result.groups, result.pose_graph, made_from, fragments=fragments_digest
    )
    write_placement(job, STAGE, placement)
    return placement


def read_clouds(fragments: list[Fragment], config: ReconstructionConfig, device: DeviceLike) -> list[PointCloud]:
    size = config.voxel_size / VOXEL_DIVISOR
    return [fragment.read_cloud(device).voxel_down_sample(size) for fragment in fragments]


def write_placement(job: JobFiles, stage: str, placement: Placement) -> None:
    path = job.scene_graph if stage == STAGE else job.refined_graph_optimized
    write_pose_graph(path, placement.pose_graph)
    result = {
        "poses": placement.poses.tolist(),
        "placed": placement.placed.tolist(),
        "groups": placement.groups.tolist(),
        "before": placement.before,
        "fragments": placement.fragments,
    }
    write_record(job.record(stage), stage, placement.made_from, files_below(job.root, [path]), result)


def placement_of(job: JobFiles, fragments: list[Fragment]) -> Placement:
    """The current result of `register_fragments`. FileError if missing or outdated."""
    placement = read_placement(job, STAGE, len(fragments))
    if placement is None or placement.fragments != digest_of_all(fragments):
        reason = (
            "contains no registered fragments"
            if placement is None
            else "contains fragments that were recreated after their registration"
        )
        raise FileError(job.root, reason, remedy="Run register_fragments with this folder first")
    return placement


def read_placement(job: JobFiles, stage: str, count: int, made_from: str | None = None) -> Placement | None:
    """The valid result of a stage for `count` fragments, or None."""
    is_placed = all_of(list_of(is_flag, count), any)
    checks: Checks = {"poses": list_of(is_pose, count), "placed": is_placed, "groups": list_of(is_count, count)}
    checks |= dict.fromkeys(("before", "fragments"), is_text)
    result = read_record(job.record(stage), stage, job.root, has_fields(checks), made_from)
    if result is None:
        return None
    graph = read_pose_graph(job.scene_graph if stage == STAGE else job.refined_graph_optimized)
    if len(graph.nodes) != sum(result["placed"]):
        return None
    poses, is_placed = np.array(result["poses"]), np.array(result["placed"], bool)
    return Placement(
        poses,
        is_placed,
        np.array(result["groups"], np.int64),
        graph,
        result["made_from"],
        result["before"],
        result["fragments"],
    )
