"""Coarse-to-fine ICP refinement of fragment edges, and pose graph optimization."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.records import digest_of
from ...kernels.linear_algebra import matmul
from ...pcd.cloud import PointCloud
from ...registration.icp.estimation import (
    TransformationEstimation,
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPlane,
    TransformationEstimationPointToPoint,
)
from ...registration.icp.iterative import IterativeRegistration
from ...registration.pose_graphs.pose_graph import PoseGraph, PoseGraphNode
from ...registration.pose_graphs.pose_graph_files import write_pose_graph
from ...registration.pose_graphs.pose_graph_optimization import GlobalOptimizationOption, global_optimization
from ...registration.rigid import invert_pose
from .config import ReconstructionConfig
from .fragments import MIN_LOOP_CONFIDENCE, Fragment, fragments_in, make_edge
from .job_files import JobFiles
from .placement import Placement, placement_of, read_clouds, read_placement, write_placement

Matrix = NDArray[np.float64]

STAGE = "refine"
SETTINGS = ("voxel_size", "icp_method", "preference_loop_closure_registration")
SCALES_AND_STEPS = ((1.0, 50), (2.0, 30), (4.0, 14))  # voxel factors and iterations, as in Open3D
MAX_DISTANCE = 1.4  # [voxels] correspondence distance, as in Open3D
MIN_RELATIVE_CHANGE = 1e-6  # convergence threshold, as in Open3D
MAX_DISPLACEMENT_VOXELS = 2.0  # [coarsest voxels] maximum displacement; beyond it the match is wrong
METHODS: dict[str, type[TransformationEstimation]] = {
    "point_to_point": TransformationEstimationPointToPoint,
    "point_to_plane": TransformationEstimationPointToPlane,
    "color": TransformationEstimationForColoredICP,
    "generalized": TransformationEstimationForGeneralizedICP,
}


def refine_registration(
    config: ReconstructionConfig,
    folder: FilePath,
    *,
    resume: bool = False,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> Placement:
    """Refine the fragment poses in a job's folder.

    Each edge of `register_fragments` is refined by `icp_method` at voxels of `voxel_size`, a half and a quarter of it,
    in batches. Then the pose graph is optimized again. An edge that drifts off keeps its pose.

    Args:
        config, folder, device: As of `register_fragments`.
        resume: Keep a valid earlier result.
        progress: Called with ("refine", scales done, scales).

    Returns:
        The fragment poses. Bitwise reproducible.

    Raises:
        TypeError: Not a configuration.
        FileError, DeviceError: No placement, a file that cannot be read or written, or no such device.
    """
    job, where = JobFiles.make(folder, config), resolve_device(device)
    report_progress = check_progress(progress)
    fragments = fragments_in(job)
    before = placement_of(job, fragments)
    made_from = digest_of([before.made_from, {name: getattr(config, name) for name in SETTINGS}])
    if resume:
        done = read_placement(job, STAGE, len(fragments), made_from)
        if done is not None:
            return done
    members = before.members
    clouds = read_clouds([fragments[i] for i in members], config, where)
    graph = _refine_edges(before.pose_graph, clouds, config, report_progress)
    write_pose_graph(job.refined_graph, graph)
    option = GlobalOptimizationOption(
        max_correspondence_distance=MAX_DISTANCE * config.voxel_size,
        edge_prune_threshold=MIN_LOOP_CONFIDENCE,
        preference_loop_closure=config.preference_loop_closure_registration,
        reference_node=0,
    )
    solved = global_optimization(graph, option=option)
    poses = before.poses.copy()
    poses[members] = [node.pose for node in solved.nodes]
    placement = Placement(poses, before.placed, before.groups, solved, made_from, before.made_from, before.fragments)
    write_placement(job, STAGE, placement)
    return placement


def latest_placement(job: JobFiles, fragments: list[Fragment]) -> Placement:
    """The refined placement if up to date, else the original. FileError without any."""
    original = placement_of(job, fragments)
    refined = read_placement(job, STAGE, len(fragments))
    return original if refined is None or refined.before != original.made_from else refined


def _refine_edges(
    graph: PoseGraph, clouds: Sequence[PointCloud], config: ReconstructionConfig, report_progress: ReportProgress
) -> PoseGraph:
    edges, nodes = graph.edges, [PoseGraphNode(node.pose) for node in graph.nodes]
    if not edges:
        return PoseGraph(nodes)
    start = np.array([matmul(invert_pose(nodes[e.target_node_id].pose), nodes[e.source_node_id].pose) for e in edges])
    poses, method = start, method_for(config, clouds)
    information: Sequence[Matrix] = []
    for done, (fineness, steps) in enumerate(SCALES_AND_STEPS):
        report_progress("refine", done, len(SCALES_AND_STEPS))
        size = config.voxel_size / fineness
        level = [cloud.voxel_down_sample(size) for cloud in clouds]
        sources, targets = [level[e.source_node_id] for e in edges], [level[e.target_node_id] for e in edges]
        problem = IterativeRegistration(sources, targets, poses, MAX_DISTANCE * size, method)
        problem.run(steps, MIN_RELATIVE_CHANGE, MIN_RELATIVE_CHANGE)
        poses, information = np.array([r.transformation for r in problem.results()]), list(problem.information())
    report_progress("refine", len(SCALES_AND_STEPS), len(SCALES_AND_STEPS))
    refined = []
    for edge, first, last, matrix in zip(edges, start, poses, information, strict=True):
        if _moved(clouds[edge.source_node_id], first, last) > MAX_DISPLACEMENT_VOXELS * config.voxel_size:
            refined.append(edge)
        else:
            ends = edge.source_node_id, edge.target_node_id
            refined.append(make_edge(*ends, last, matrix, uncertain=edge.uncertain))
    return PoseGraph(nodes, refined)


def method_for(config: ReconstructionConfig, clouds: Sequence[PointCloud]) -> TransformationEstimation:
    name = config.icp_method
    if name == "color" and not all(cloud.has_colors for cloud in clouds):
        name = "point_to_plane"
    return METHODS[name]()


def _moved(cloud: PointCloud, first: Matrix, last: Matrix) -> float:
    """Root mean square corner displacement of a cloud's box between two poses [m]."""
    box = cloud.get_axis_aligned_bounding_box()
    low, high = np.asarray(box.min_bound), np.asarray(box.max_bound)
    corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    D = last - first
    return float(np.sqrt(((matmul(corners, D[:3, :3].T) + D[:3, 3]) ** 2).sum(axis=1).mean()))
