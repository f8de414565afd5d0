"""Every argument of every public call of the reconstruction system refuses what makes no sense, by its name."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom import reconstruction as rec
from pointloom import registration as reg

from ...hostile import faults_of, missing_from, public_arguments, read_table
from .walks import Walk, config

CALLS = """
rec.ReconstructionConfig(path_dataset="frames", path_intrinsic="camera.json", depth_min=0.3, depth_max=3.0, depth_scale=1000.0, depth_diff_max=0.07, odometry_method="hybrid", n_frames_per_fragment=100, n_frames_least=2, n_keyframes_per_n_frame=5, preference_loop_closure_odometry=0.1, voxel_size=0.05, global_registration="robust", icp_method="color", preference_loop_closure_registration=5.0, tsdf_cubic_size=3.0, tsdf_voxel_size=0.01, fragment_voxel_size=0.01, sdf_trunc=0.04, surface_weight_threshold=3.0, seed=0, max_iterations=5, distance_threshold=0.07, fitness_threshold=0.3, regularizer_weight=1.0, method="slac", save_output_as="mesh", folder_fragment="fragments/", folder_scene="scene/", folder_slac="slac/", template_fragment_posegraph="fragments/fragment_%03d.json", template_fragment_posegraph_optimized="fragments/fragment_optimized_%03d.json", template_fragment_pointcloud="fragments/fragment_%03d.ply", template_global_posegraph="scene/global_registration.json", template_global_posegraph_optimized="scene/global_registration_optimized.json", template_refined_posegraph="scene/refined_registration.json", template_refined_posegraph_optimized="scene/refined_registration_optimized.json", template_global_mesh="scene/integrated.ply", template_global_traj="scene/trajectory.log", template_optimized_posegraph_slac="optimized_posegraph_slac.json")
rec.ReconstructionConfig.from_names(names={"depth_max": 2.0})
rec.ReconstructionConfig.read(path="config.json")
settings.write(path="written.json")
rec.FragmentOptions(folder="stages", config=settings)
rec.make_fragments(source=walk, config=settings, folder="job", device="cpu", progress=None)
rec.register_fragments(config=settings, folder="done", device="cpu", progress=None)
rec.refine_registration(config=settings, folder="done", device="cpu", progress=None)
rec.refine_with_slac(config=settings, folder="done", device="cpu", progress=None)
rec.integrate_scene(source=walk, config=settings, folder="done", device="cpu", progress=None)
rec.run_system(source=walk, config=settings, folder="job", device="cpu", progress=None)
rec.SLACOptimizerParams(max_iterations=2, voxel_size=0.05, distance_threshold=0.07, fitness_threshold=0.3, regularizer_weight=1.0, grid_size=0.375)
rec.run_slac_optimizer_for_fragments(fragments=clouds, fragment_pose_graph=graph, params=params, progress=None)
rec.run_rigid_optimizer_for_fragments(fragments=clouds, fragment_pose_graph=graph, params=params, progress=None)
rec.ControlGrid(grid_size=0.375, device="cpu")
grid.touch(cloud=cloud)
grid.deform(cloud=cloud)
grid.set_positions(positions=grid.get_init_positions())
grid.deform_depth(depth=depth, intrinsic=camera, extrinsic=pose, depth_scale=1000.0, depth_max=3.0)
grid.deform_rgbd(image=image, intrinsic=camera, extrinsic=pose, depth_max=3.0)
rec.integrate_deformed(volume=volume, grid=grid, depth=depth, intrinsic=camera, T_world_fragment=pose, T_fragment_camera=pose, color=image.color, depth_scale=1000.0, depth_max=3.0)
"""  # noqa: E501
RESULTS = {
    *("Fragment", "FragmentSet", "LostFrame", "Placement", "BentPlacement", "Scene"),
    *("FragmentOverlap", "RefinementReport", "SystemReport"),
}
LINES = read_table(CALLS, {"settings": "ReconstructionConfig", "grid": "ControlGrid"})
TABLE = {name.removeprefix("rec."): line for name, line in LINES.items()}


@cache
def things() -> dict[str, Any]:
    """What the expressions of the table name."""
    points = np.random.default_rng(0).random((300, 3)) * [1, 1, 0]
    grid, clouds = rec.ControlGrid(), [loom.PointCloud(points), loom.PointCloud(points)]
    grid.touch(clouds[0])
    nodes, edge = [reg.PoseGraphNode(), reg.PoseGraphNode()], reg.PoseGraphEdge(0, 1)
    depth = np.full((12, 16), 1000, np.uint16)
    return {
        "rec": rec, "settings": config(), "walk": Walk([0, 1]), "grid": grid, "clouds": clouds, "cloud": clouds[0],
        "graph": reg.PoseGraph(nodes, [edge]), "params": rec.SLACOptimizerParams(max_iterations=1), "depth": depth,
        "camera": loom.PinholeCameraIntrinsic(16, 12, 20.0, 20.0, 7.5, 5.5), "pose": np.eye(4),
        "image": loom.RGBDImage(np.zeros((12, 16, 3), np.uint8), depth), "volume": loom.TSDFVolume(voxel_size=0.02),
    }  # fmt: skip


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """Files named by hostile values go here, beside a job that is done and a configuration."""
    monkeypatch.chdir(tmp_path)
    config().write("config.json")


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(rec, RESULTS)) == {}


CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@pytest.mark.parametrize(
    ("call", "argument"),
    [pytest.param(*case, marks=pytest.mark.slow if case[0] == "run_system" else ()) for case in CASES],
)
def test_a_hostile_value_is_refused_by_name(call, argument):
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}

    def act(**given: Any) -> Any:
        return eval(function, dict(things()))(**given)

    faults = faults_of(act, good, argument)
    assert not faults, "\n".join(faults)
