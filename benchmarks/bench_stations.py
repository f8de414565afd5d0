"""register_stations beside Open3D's multiway registration: eight stations over a ground with boxes, from rough poses.

    python benchmarks/bench_stations.py          # how far either ends from the truth

Open3D's recipe: voxels, normals, each pair's ICP from points to planes in two distances, its information matrix, and
global_optimization. It has six degrees of freedom, so ours gets them too (level=False); ours also finds which pairs
overlap, weighs each by what its residuals show, and tests it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from contest import OURS, Contestant, Operation, load_open3d, timed

VOXEL, NOISE, REACH = 0.15, 0.002, 7.0  # [m]
TURN, SHIFT = 0.02, 0.1  # of rough poses [rad], [m]
APART = 0.01  # [m]: both are right to some millimeters
PLACES = np.array(
    [[0, 0, 1.5], [4, 1, 1.6], [8, 0, 1.4], [11, 3, 1.5], [8, 6, 1.7], [4, 7, 1.5], [0, 6, 1.6], [5, 4, 1.5]]
)


@dataclass(frozen=True)
class Survey:
    """Points of each station in its own coordinates, true poses, rough ones."""

    scans: list[np.ndarray]
    truth: np.ndarray
    rough: np.ndarray


def survey(count: int) -> Callable[[], Survey]:
    def make() -> Survey:
        from scipy.spatial.transform import Rotation

        rng, scans, truth = np.random.default_rng(0), [], np.tile(np.eye(4), (len(PLACES), 1, 1))
        rough = truth.copy()
        for k, place in enumerate(PLACES):
            ways, away = rng.uniform(0, 2 * np.pi, count), REACH * np.sqrt(rng.random(count))
            x, y = place[0] + away * np.cos(ways), place[1] + away * np.sin(ways)
            z = 0.5 * np.sin(1.5 * x) * np.cos(y) + 0.3 * np.sin(2 * y + x)
            wall = rng.random(count) < 0.3  # posts: what stands out of the ground
            x = np.where(wall, np.round(x / 3) * 3 + 0.3 * np.cos(7 * ways), x)
            y = np.where(wall, np.round(y / 3) * 3 + 0.3 * np.sin(7 * ways), y)
            z = np.where(wall, rng.uniform(0, 2.5, count), z)
            truth[k, :3, :3] = Rotation.from_rotvec([0, 0, rng.uniform(-3, 3)]).as_matrix()
            truth[k, :3, 3] = place
            points = np.column_stack([x, y, z]) + rng.normal(0, NOISE, (count, 3))
            scans.append((points - place) @ truth[k, :3, :3])
            rough[k] = truth[k]
            if k:
                rough[k, :3, :3] = Rotation.from_rotvec(rng.normal(0, TURN, 3)).as_matrix() @ truth[k, :3, :3]
                rough[k, :3, 3] += rng.normal(0, SHIFT, 3)
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
            for reach in (4 * VOXEL, 2 * VOXEL):
                method = reg.TransformationEstimationPointToPlane()
                found = reg.registration_icp(clouds[i], clouds[j], reach, T, method)
                T = found.transformation
            if found.fitness >= 0.15:
                information = reg.get_information_matrix_from_point_clouds(clouds[i], clouds[j], 2 * VOXEL, T)
                graph.edges.append(reg.PoseGraphEdge(i, j, T, information, uncertain=j != i + 1))
        option = reg.GlobalOptimizationOption(max_correspondence_distance=2 * VOXEL, reference_node=0)
        method, criteria = reg.GlobalOptimizationLevenbergMarquardt(), reg.GlobalOptimizationConvergenceCriteria()
        reg.global_optimization(graph, method, criteria, option)
        return np.array([node.pose for node in graph.nodes])

    return call


def facts(poses: np.ndarray) -> np.ndarray:
    """Where the stations stand beside the first."""
    return (np.linalg.inv(poses[0]) @ poses)[:, :3, 3]


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=APART, err_msg=f"stations do not stand where {peer} has them")


STATIONS = Operation(
    name="stations",
    scenes={"8 of 50k": survey(50_000)},
    quick={"8 of 8k": survey(8000)},
    contestants=(
        Contestant(OURS, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
)
OPERATIONS = (STATIONS,)


@timed(STATIONS)
def test_stations(turn) -> None:
    turn()


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
