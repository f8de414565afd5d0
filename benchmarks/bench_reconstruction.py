"""The reconstruction system from frames to mesh: the furnished room at VGA in two fragments, beside Open3D.

Open3D's system is a set of example programs. Here its calls are made in sequence, with its defaults: hybrid odometry of
consecutive frames, a pose graph and a cloud per fragment, colored ICP between neighbors, a pose graph of the fragments,
colored ICP again, integration of all frames. Its loop closures within a fragment need OpenCV and are omitted, as are
its
intermediate files. Its volume is the tensor one, since the legacy volume gives empty clouds in 0.20. pointloom runs all
steps, including loop closures, records and files. Both get decoded frames.
"""

from __future__ import annotations

import tempfile
from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed

SEQUENCE_FRAMES = 1200  # of the full sequence: 1.2 degrees and 1.5 cm apart, which Open3D can track
VOXEL, SCENE_VOXEL, TRUNCATION, DEPTH_MAX = 0.05, 0.01, 0.04, 4.0
SCALES = ((1.0, 50), (2.0, 30), (4.0, 14))
MAX_DIFFERENCE = 0.05  # [m] between the two trajectories
Scene = dict[str, Any]


class Decoded:
    """Decoded frames in memory."""

    depth_scale = 1000.0

    def __init__(self, frames: list[Any]):
        self.intrinsic, self.read, self.count = frames[0].intrinsic, frames.__getitem__, len(frames)

    def __len__(self) -> int:
        return self.count


def first_frames(count: int, per_fragment: int, width: int = 640) -> Scene:
    """The first frames of a camera path through the room."""
    from pointloom.datasets.scenes.room import room_sequence

    room = room_sequence(SEQUENCE_FRAMES, width=width, height=width * 3 // 4)
    return {"frames": [room.read(i) for i in range(count)], "per_fragment": per_fragment}


def prepare_pointloom(scene: Scene, device: str) -> Any:
    import pointloom as loom

    config = loom.rgbd.ReconstructionConfig(
        voxel_size=VOXEL,
        tsdf_voxel_size=SCENE_VOXEL,
        sdf_trunc=TRUNCATION,
        depth_max=DEPTH_MAX,
        n_frames_per_fragment=scene["per_fragment"],
    )

    def run() -> Any:
        with tempfile.TemporaryDirectory() as folder:
            loom.rgbd.run_reconstruction_system(Decoded(scene["frames"]), config, folder, device=device)
            return loom.read_trajectory(f"{folder}/scene/trajectory.log").poses

    return run


class Open3DSystem:
    """Open3D's calls, in the order of its example programs."""

    def __init__(self, scene: Scene):
        import open3d as o3d

        self.o3d, self.reg = o3d, o3d.pipelines.registration
        self.frames, self.per_fragment = scene["frames"], scene["per_fragment"]
        camera = self.frames[0].intrinsic
        numbers = (camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy)
        self.intrinsic = o3d.camera.PinholeCameraIntrinsic(*numbers)
        self.K = o3d.core.Tensor(camera.matrix)

    def run(self) -> np.ndarray:
        fragments, graph = [], self.reg.PoseGraph()
        for first in range(0, len(self.frames), self.per_fragment):
            fragments.append(self.make_fragment(range(first, min(first + self.per_fragment, len(self.frames)))))
        clouds = [cloud for cloud, _ in fragments]
        graph.nodes.append(self.reg.PoseGraphNode(np.eye(4)))
        pose = np.eye(4)
        for k in range(1, len(fragments)):
            T, information = self.icp(clouds[k - 1], clouds[k], np.linalg.inv(fragments[k - 1][1][-1]))
            pose = T @ pose
            graph.nodes.append(self.reg.PoseGraphNode(np.linalg.inv(pose)))
            graph.edges.append(self.reg.PoseGraphEdge(k - 1, k, T, information, uncertain=False))
        for a in range(len(fragments)):
            for b in range(a + 2, len(fragments)):
                self.add_loop(graph, clouds, a, b)
        self.optimize(graph, 1.4 * VOXEL, 5.0)
        for edge in graph.edges:
            a, b = edge.source_node_id, edge.target_node_id
            edge.transformation, edge.information = self.icp(clouds[a], clouds[b], edge.transformation)
        self.optimize(graph, 1.4 * VOXEL, 5.0)
        poses = np.concatenate([node.pose @ inner for node, (_, inner) in zip(graph.nodes, fragments, strict=True)])
        self.integrate(range(len(self.frames)), poses, SCENE_VOXEL).extract_triangle_mesh(3.0).to_legacy()
        return poses

    def rgbd(self, index: int) -> Any:
        frame, geometry = self.frames[index], self.o3d.geometry
        color, depth = geometry.Image(frame.color), geometry.Image(frame.depth)
        return geometry.RGBDImage.create_from_color_and_depth(color, depth, 1000.0, DEPTH_MAX, True)

    def make_fragment(self, indices: range) -> tuple[Any, np.ndarray]:
        odometry, graph, pose = self.o3d.pipelines.odometry, self.reg.PoseGraph(), np.eye(4)
        graph.nodes.append(self.reg.PoseGraphNode(pose))
        option = odometry.OdometryOption(depth_diff_max=0.07, depth_max=DEPTH_MAX)
        term = odometry.RGBDOdometryJacobianFromHybridTerm()
        for k, index in enumerate(indices[:-1]):
            pair = self.rgbd(index), self.rgbd(index + 1)
            _, T, information = odometry.compute_rgbd_odometry(*pair, self.intrinsic, np.eye(4), term, option)
            pose = T @ pose
            graph.nodes.append(self.reg.PoseGraphNode(np.linalg.inv(pose)))
            graph.edges.append(self.reg.PoseGraphEdge(k, k + 1, T, information, uncertain=False))
        self.optimize(graph, 0.07, 0.1)
        poses = np.array([node.pose for node in graph.nodes])
        return self.integrate(indices, poses, SCENE_VOXEL).extract_point_cloud(1.0).to_legacy(), poses

    def add_loop(self, graph: Any, clouds: list[Any], a: int, b: int) -> None:
        search = self.o3d.geometry.KDTreeSearchParamHybrid(5 * VOXEL, 100)
        thin = [clouds[i].voxel_down_sample(VOXEL) for i in (a, b)]
        features = [self.reg.compute_fpfh_feature(cloud, search) for cloud in thin]
        point, max_distance = self.reg.TransformationEstimationPointToPoint(False), 1.4 * VOXEL
        checks = [self.reg.CorrespondenceCheckerBasedOnEdgeLength(0.9)]
        checks.append(self.reg.CorrespondenceCheckerBasedOnDistance(max_distance))
        rules = self.reg.RANSACConvergenceCriteria(1_000_000, 0.999)
        result = self.reg.registration_ransac_based_on_feature_matching(
            *thin, *features, False, max_distance, point, 4, checks, rules
        )
        T = result.transformation
        information = self.reg.get_information_matrix_from_point_clouds(*thin, max_distance, T)
        if T.trace() != 4.0 and information[5, 5] / min(len(c.points) for c in thin) >= 0.3:
            graph.edges.append(self.reg.PoseGraphEdge(a, b, T, information, uncertain=True))

    def icp(self, source: Any, target: Any, T: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        estimation, pair = self.reg.TransformationEstimationForColoredICP(), []
        for fineness, steps in SCALES:
            size = VOXEL / fineness
            pair = [cloud.voxel_down_sample(size) for cloud in (source, target)]
            for cloud in pair:
                cloud.estimate_normals(self.o3d.geometry.KDTreeSearchParamHybrid(2 * size, 30))
            rules = self.reg.ICPConvergenceCriteria(1e-6, 1e-6, steps)
            T = self.reg.registration_colored_icp(*pair, size, T, estimation, rules).transformation
        max_distance = 1.4 * VOXEL / SCALES[-1][0]
        return T, self.reg.get_information_matrix_from_point_clouds(*pair, max_distance, T)

    def optimize(self, graph: Any, distance: float, preference: float) -> None:
        option = self.reg.GlobalOptimizationOption(distance, 0.25, preference, 0)
        rules = self.reg.GlobalOptimizationConvergenceCriteria()
        self.reg.global_optimization(graph, self.reg.GlobalOptimizationLevenbergMarquardt(), rules, option)

    def integrate(self, indices: range, poses: np.ndarray, voxel_size: float) -> Any:
        core, Image = self.o3d.core, self.o3d.t.geometry.Image
        types = (core.float32, core.uint16, core.uint16)
        volume = self.o3d.t.geometry.VoxelBlockGrid(
            ("tsdf", "weight", "color"), types, ((1), (1), (3)), voxel_size, 16, 20000
        )
        for index, pose in zip(indices, poses, strict=True):
            frame, extrinsic = self.frames[index], core.Tensor(np.linalg.inv(pose))
            depth, color = Image(core.Tensor(frame.depth)), Image(core.Tensor(frame.color))
            depth_range = (1000.0, DEPTH_MAX, TRUNCATION / voxel_size)
            blocks = volume.compute_unique_block_coordinates(depth, self.K, extrinsic, *depth_range)
            volume.integrate(blocks, depth, color, self.K, self.K, extrinsic, *depth_range)
        return volume


def prepare_open3d(scene: Scene, device: str) -> Any:
    return Open3DSystem(scene).run


def facts(poses: np.ndarray) -> np.ndarray:
    return poses[:, :3, 3]


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same trajectory within the odometry error."""
    assert actual.shape == reference.shape, peer
    assert np.abs(actual - reference).max() < MAX_DIFFERENCE, peer


RECONSTRUCTION = Operation(
    name="reconstruction",
    scenes={"24 frames": partial(first_frames, 24, 12)},
    quick={"6 frames": partial(first_frames, 6, 3, 160)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    targets={"24 frames": 3},
)
OPERATIONS = (RECONSTRUCTION,)


@timed(RECONSTRUCTION)
def test_reconstruction(time_lap) -> None:
    time_lap()
