"""Covariances of the poses of fragments: the errors of their pairs, propagated through the optimized pose graph."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from ...core.quaternions import nearest_rotations
from ...kernels.linear_algebra import matmul
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..assessment_constants import FINE_VOXEL_FACTOR, MATCH_VOXELS, SOURCE_VOXEL_FACTOR
from ..pose_errors import PoseCovariance, common_covariance, motions_of_source, root_of_covariance, step_between
from ..rigid import to_local
from ..surfaces import surfaces_of
from ..unobservable_motions import judge_motions
from .fragment_graph import Extent
from .pose_graph import GraphArrays, PoseGraph, PoseGraphEdge, center_frames, check_pose_graph
from .pose_graph_system import EdgeMeasurements, NodePoses, NormalEquations

Array = NDArray[np.float64]
NODE_DAMPING = 1e-12  # relative to the stiffness of the nodes: edges need not determine all motions
MAX_DAMPING_FRACTION = 1e-3  # fraction of the stiffness along a motion that is damping: undetermined


def fragment_covariances(
    graph: PoseGraph, clouds: Sequence[PointCloud], voxel_size: float, motions: Sequence[int]
) -> list[PoseCovariance]:
    """The covariance of each node's pose, about the node's data, relative to node 0. One cloud for each node.

    `motions`: numbers of the free ones of the six motions.
    """
    arrays, centers = center_frames(check_pose_graph(graph))
    matrices, pairs = np.zeros((len(clouds), 6, 6)), _Pairs(clouds, voxel_size, motions)
    if len(arrays.source):
        nodes, loose, gains = _gains(arrays, motions)
        errors = [
            matmul(root_of_covariance(pairs.covariance(edge, centers[edge.source_node_id])), gains(k)[motions])
            for k, edge in enumerate(graph.edges)
        ]
        for node, part in zip(nodes, np.concatenate(errors).reshape(-1, len(nodes), 6).transpose(1, 0, 2), strict=True):
            matrices[node] = matmul(part.T, part)
        matrices[nodes[loose]] = np.inf
    return [PoseCovariance((M + M.T) / 2, T[:3, 3].copy()) for M, T in zip(matrices, arrays.poses, strict=True)]


def _gains(
    arrays: GraphArrays, motions: Sequence[int]
) -> tuple[NDArray[np.int64], NDArray[np.bool_], Callable[[int], Array]]:
    """The nodes without node 0, a mask of those that the edges do not determine, and the derivative of the poses.

    The derivative is a function of the edge: by its error, [6, 6 nodes].
    """
    rotations, positions = nearest_rotations(arrays.poses[:, :3, :3]), arrays.poses[:, :3, 3] - arrays.poses[0, :3, 3]
    poses, edges = NodePoses(rotations, positions), EdgeMeasurements(arrays)
    is_free = np.isin(np.arange(6), motions)
    system = NormalEquations(edges, np.arange(len(rotations)) == 0, None if is_free.all() else is_free)
    errors = edges.errors(poses)
    system.linearize(poses, errors, arrays.confidences)
    solved = system.inverse(NODE_DAMPING)
    damped = np.diag(solved) * system.scale * NODE_DAMPING  # fraction of the stiffness along each motion
    inverse = np.zeros((len(rotations), 6, len(solved)))
    inverse[system.free] = solved.reshape(len(system.free), 6, -1)
    inverse[:, ~is_free] = 0.0
    by_source, by_target = edges.jacobians(poses, errors)
    information = arrays.confidences[:, None, None] * arrays.information

    def gain(k: int) -> Array:
        moved = matmul(by_source[k], inverse[arrays.source[k]]) + matmul(by_target[k], inverse[arrays.target[k]])
        return matmul(information[k], moved)

    return system.free, damped.reshape(-1, 6).max(axis=1) > MAX_DAMPING_FRACTION, gain


class _Pairs:
    """Errors of the poses between clouds. Their surfaces are computed once."""

    def __init__(self, clouds: Sequence[PointCloud], voxel_size: float, motions: Sequence[int]):
        self.clouds, self.voxel_size, self.motions = clouds, voxel_size, motions
        self.known: dict[tuple[int, float], Surface] = {}

    def covariance(self, edge: PoseGraphEdge, center: Array) -> Array:
        """Of the motion of the source in its own axes about a center. As large as the source if no surfaces match."""
        a, b, size = edge.source_node_id, edge.target_node_id, FINE_VOXEL_FACTOR * self.voxel_size
        pose = to_local(edge.transformation, self.clouds[a].origin, self.clouds[b].origin)
        step = step_between(*self.surfaces(a, b, size), pose, MATCH_VOXELS * self.voxel_size, size, self.motions)
        if step is None or not step.is_solved:
            radius = Extent.of(self.clouds[a]).radius
            return np.diag(np.repeat([1.0, radius**2], 3)[self.motions])
        to_source = motions_of_source(step, self.clouds[a].origin - center)
        common = common_covariance(
            step, lambda: judge_motions(*self.surfaces(a, b, self.voxel_size), pose, step.distance, step.free)
        )
        return matmul(to_source, step.scatter + common, to_source.T)

    def surfaces(self, a: int, b: int, size: float) -> tuple[Surface, Surface]:
        ends = (a, SOURCE_VOXEL_FACTOR * size), (b, size)
        if missing := [end for end in ends if end not in self.known]:
            sizes = [size for _, size in missing]
            self.known |= zip(missing, surfaces_of([self.clouds[i] for i, _ in missing], sizes), strict=True)
        return self.known[ends[0]], self.known[ends[1]]
