"""SLAC reduces the surface error of a room scan with distorted depth."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.datasets.scenes.room import room_sequence, surface_errors
from pointloom.registration import PoseGraph, PoseGraphEdge, PoseGraphNode
from pointloom.registration.deformable.slac import run_rigid_optimizer_for_fragments
from pointloom.registration.rigid import fit_pose, invert_pose
from pointloom.rgbd.reconstruction.volumes import integrate_deformed

VIEWS, DEPTH_MAX = 31, 4.0  # frames of one round, and the maximum depth [m]
slac = loom.rgbd


def moved(T, points):
    return points @ T[:3, :3].T + T[:3, 3]


class BentRound:
    """One fragment per frame; depth is 2 % too large at the image corners; poses are known."""

    def __init__(self):
        frames = room_sequence(120, width=80, height=60, noise=False)
        self.camera = frames.intrinsic
        v, u = np.mgrid[: self.camera.height, : self.camera.width]
        spread = ((u - self.camera.cx) / self.camera.fx) ** 2 + ((v - self.camera.cy) / self.camera.fy) ** 2
        stretch = 1 + 0.02 * spread / spread.max()
        seen = [frames.read(i) for i in range(VIEWS)]
        self.poses = [frame.T_world_camera for frame in seen]
        self.depths = [(frame.depth * stretch).astype(np.float32) for frame in seen]
        self.truths = [np.where(bent <= DEPTH_MAX, f.depth, 0) for f, bent in zip(seen, self.depths, strict=True)]
        self.clouds = [self.cloud(depth) for depth in self.depths]
        edges = [
            PoseGraphEdge(i, j, invert_pose(self.poses[j]) @ self.poses[i])
            for i in range(VIEWS)
            for j in range(i + 1, VIEWS)
            if j - i <= 3 or j - i >= VIEWS - 3
        ]
        self.graph = PoseGraph([PoseGraphNode(T) for T in self.poses], edges)

    def cloud(self, depth):
        return loom.PointCloud.create_from_depth_image(depth, self.camera, depth_trunc=DEPTH_MAX)

    def fuse(self, graph, grid):
        """Vertices of the model in the room's frame, after a rigid fit of all fragments."""
        volume = loom.TSDFVolume(voxel_size=0.04, color=False)
        for node, depth in zip(graph.nodes, self.depths, strict=True):
            integrate_deformed(volume, grid, depth, self.camera, node.pose, depth_max=DEPTH_MAX)
        deformed = [moved(n.pose, grid.deform(c).points) for n, c in zip(graph.nodes, self.clouds, strict=True)]
        truth = [
            moved(T, loom.PointCloud.create_from_depth_image(d, self.camera, depth_trunc=2 * DEPTH_MAX).points)
            for T, d in zip(self.poses, self.truths, strict=True)
        ]
        mesh = volume.extract_triangle_mesh(weight_threshold=2)
        return moved(fit_pose(np.concatenate(deformed), np.concatenate(truth)), mesh.vertices)


@pytest.mark.slow
@pytest.mark.slow_on_emulated_cuda("fuses 62 frames")
def test_a_room_seen_by_a_camera_that_bends_is_nearer_to_the_truth_after_slac():
    scene = BentRound()
    params = slac.SLACOptimizerParams(max_iterations=3)
    rigid = run_rigid_optimizer_for_fragments(scene.clouds, scene.graph, params)
    solved, grid = slac.run_slac_optimizer_for_fragments(scene.clouds, scene.graph, params)
    assert solved.report.rmse[-1] < 0.65 * rigid.report.rmse[-1]
    models = (rigid, slac.ControlGrid()), (solved, grid)
    before, after = (surface_errors(scene.fuse(graph, bend)) for graph, bend in models)
    assert np.median(after) < 0.75 * np.median(before)
    assert np.sqrt(np.mean(after**2)) < 0.85 * np.sqrt(np.mean(before**2))
