"""register_stations beside Open3D's multiway registration: eight stations over a ground with boxes, from rough poses.

    python benchmarks/bench_stations.py          # errors of both

Open3D's recipe: voxels, normals, point-to-plane ICP of each pair at two distances, its information matrix, and
global_optimization. It has six degrees of freedom, so pointloom uses them too (level=False). pointloom also selects
overlapping pairs, weights each by its residuals, and tests it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed

VOXEL, NOISE, RADIUS = 0.15, 0.002, 7.0  # [m]
ROTATION_SIGMA, SHIFT_SIGMA = 0.02, 0.1  # standard deviations of rough poses [rad], [m]
APART = 0.01  # [m]: both are accurate to some millimeters
POSITIONS = np.array(
    [[0, 0, 1.5], [4, 1, 1.6], [8, 0, 1.4], [11, 3, 1.5], [8, 6, 1.7], [4, 7, 1.5], [0, 6, 1.6], [5, 4, 1.5]]
)


@dataclass(frozen=True)
class Survey:
    """Points of each station in its own coordinates, true poses, rough poses."""

    scans: list[np.ndarray]
    truth: np.ndarray
    rough: np.ndarray


def survey(count: int) -> Callable[[], Survey]:
    def make() -> Survey:
        from scipy.spatial.transform import Rotation

        rng, scans, truth = np.random.default_rng(0), [], np.tile(np.eye(4), (len(POSITIONS), 1, 1))
        rough = truth.copy()
        for k, position in enumerate(POSITIONS):
            angles, distances = rng.uniform(0, 2 * np.pi, count), RADIUS * np.sqrt(rng.random(count))
            x, y = position[0] + distances * np.cos(angles), position[1] + distances * np.sin(angles)
            z = 0.5 * np.sin(1.5 * x) * np.cos(y) + 0.3 * np.sin(2 * y + x)
            wall = rng.random(count) < 0.3  # posts that rise from the ground
            x = np.where(wall, np.round(x / 3) * 3 + 0.3 * np.cos(7 * angles), x)
            y = np.where(wall, np.round(y / 3) * 3 + 0.3 * np.sin(7 * angles), y)
            z = np.where(wall, rng.uniform(0, 2.5, count), z)
            truth[k, :3, :3] = Rotation.from_rotvec([0, 0, rng.uniform(-3, 3)]).as_matrix()
            truth[k, :3, 3] = position
            points = np.column_stack([x, y, z]) + rng.normal(0, NOISE, (count, 3))
            scans.append((points - position) @ truth[k, :3, :3])
            rough[k] = truth[k]
            if k:
                rough[k, :3, :3] = Rotation.from_rotvec(rng.normal(0, ROTATION_SIGMA, 3)).as_matrix() @ truth[k, :3, :3]
                rough[k, :3, 3] += rng.normal(0, SHIFT_SIGMA, 3)
        return Survey(scans, truth, rough)

    return make


def prepare_pointloom(scene: Survey, device: str) -> Callable[[], Any]:
    import pointloom as loom

    scans = [loom.PointCloud(points, device=device) for points in scene.scans]
    options: dict[str, Any] = {"poses": scene.rough, "voxel_size": VOXEL, "level": False}
    return lambda: loom.registration.register_stations(scans, **options).poses


def prepare_open3d(scene: Survey, device: str) -> Callable[[], Any]:
    o3d = load_open3d()
    reg, given = o3d.pipelines.registration, [o3d.utility.Vector3dVector(points) for points in scene.scans]

    def call() -> np.ndarray:
        clouds = [o3d.geometry.PointCloud(points).voxel_down_sample(VOXEL) for points in given]
        for cloud in clouds:
            cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(2 * VOXEL, 30))
        graph = reg.PoseGraph()
        for T in scene.rough:
            graph.nodes.append(reg.PoseGraphNode(T))
        for i, j in itertools.combinations(range(len(clouds)), 2):
            T = np.linalg.inv(scene.rough[j]) @ scene.rough[i]
            for max_distance in (4 * VOXEL, 2 * VOXEL):
                method = reg.TransformationEstimationPointToPlane()
                result = reg.registration_icp(clouds[i], clouds[j], max_distance, T, method)
                T = result.transformation
            if result.fitness >= 0.15:
                information = reg.get_information_matrix_from_point_clouds(clouds[i], clouds[j], 2 * VOXEL, T)
                graph.edges.append(reg.PoseGraphEdge(i, j, T, information, uncertain=j != i + 1))
        option = reg.GlobalOptimizationOption(max_correspondence_distance=2 * VOXEL, reference_node=0)
        method, criteria = reg.GlobalOptimizationLevenbergMarquardt(), reg.GlobalOptimizationConvergenceCriteria()
        reg.global_optimization(graph, method, criteria, option)
        return np.array([node.pose for node in graph.nodes])

    return call


def facts(poses: np.ndarray) -> np.ndarray:
    """Poses of the stations relative to the first."""
    return (np.linalg.inv(poses[0]) @ poses)[:, :3, 3]


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    np.testing.assert_allclose(
        actual, reference, rtol=0, atol=APART, err_msg=f"the poses of stations differ from {peer}'s"
    )


STATIONS = Operation(
    name="stations",
    scenes={"8 of 50k": survey(50_000)},
    quick={"8 of 8k": survey(8000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    targets={"8 of 50k": 1.5},
    reasons={
        "8 of 50k": (
            "Poses are ten times as accurate: a third of the time rates each pair, a quarter is ICP at several scales."
        )
    },
)
OPERATIONS = (STATIONS,)


@timed(STATIONS)
def test_stations(time_lap) -> None:
    time_lap()


if __name__ == "__main__":
    import time

    made = survey(50_000)()
    for contestant in STATIONS.contestants:
        call = contestant.trial(made, "cpu").call
        call()
        start, cpu = time.perf_counter(), time.process_time()
        off = np.linalg.norm(facts(call()) - facts(made.truth), axis=1)[1:] * 1000
        spent = f"{time.perf_counter() - start:.1f} s, {time.process_time() - cpu:.1f} s of CPU"
        print(f"{contestant.name}: {np.median(off):.2f} mm off (median), {off.max():.2f} (largest), {spent}")
