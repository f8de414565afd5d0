"""Every argument of every public call of rgbd rejects invalid values with an error that names it.

The checks are the host's, so the CPU stands for all devices. Records that operations return are left out.
"""

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom import registration
from pointloom.rgbd.reconstruction.volumes import integrate_deformed
from pointloom.rgbd.slam.submaps import Submap

from ..hostile import call_of, faults_of, missing_from, public_arguments, read_table
from .fusion.walls import Wall
from .reconstruction.walks import ShortSequence, config
from .sequences import CAMERA, turning_path, waves

# One line per call: the function, and a valid value of each of its arguments, as expressions over `things()`.
CALLS = {
    "frames": """
loom.rgbd.fuse(frames=posed, voxel_size=0.1, truncation=0.4, depth_max=3.0, weight_threshold=0.0, device="cpu", read_ahead=0, progress=None, clock=None)
loom.rgbd.track(frames=frames, voxel_size=0.1, depth_max=3.0, device="cpu", read_ahead=0, progress=None, clock=None)
loom.rgbd.check_focal(frames=frames, trajectory=turning, uncertain=[7], depth_max=3.0, device="cpu")
loom.rgbd.reconstruct(frames=frames, voxel_size=0.1, depth_max=3.0, fragments=None, device="cpu", read_ahead=0, progress=None, clock=None)
""",  # noqa: E501
    "odometry": """
reg.OdometryFrame(depth=depth, intrinsic=camera, color=color, depth_scale=1000.0, depth_max=5.0, device="cpu")
reg.align_frames(source=frame, target=frame, init=pose, method="hybrid")
reg.compute_rgbd_odometry(source=rgbd, target=rgbd, pinhole_camera_intrinsic=camera, odo_init=pose, method="hybrid", max_iterations=[3, 2], depth_min=0.0, depth_max=4.0)
reg.compute_odometry_information_matrix(source_depth=depth, target_depth=depth, intrinsic=camera, source_to_target=pose, dist_threshold=0.07, depth_scale=1000.0, depth_max=3.0)
""",  # noqa: E501
    "slam": """
reg.DenseSLAM(intrinsic=camera, voxel_size=0.1, truncation=0.4, T_init=pose, depth_scale=1000.0, depth_max=3.0, submap_frames=10, seed=0, device="cpu")
tracker().close_loops(progress=None)
tracker().extract_point_cloud(weight_threshold=0.0)
tracker().extract_triangle_mesh(weight_threshold=0.0)
tracker().integrate(frame=frame)
tracker().check_camera()
tracker().join_maps()
tracker().trajectory_of(number=0)
tracker().render(T_world_camera=pose)
tracker().run(source=[frame], progress=None)
tracker().step(frame=frame)
tracker().track(frame=frame)
reg.SlamModel(intrinsic=camera, voxel_size=0.1, truncation=0.4, T_init=pose, depth_scale=1000.0, depth_max=3.0, device="cpu")
model().extract_point_cloud(weight_threshold=0.0)
model().extract_triangle_mesh(weight_threshold=0.0)
model().integrate(frame=frame, T_world_camera=pose)
model().prepare(frame=frame)
model().render(T_world_camera=pose, weight_threshold=0.0)
model().track_frame(frame=frame, T_world_camera=pose)
Submap(volume=submap.volume, T_world_submap=pose, frames=[0, 1], T_submap_camera=[pose, pose])
submap.cloud(voxel_size=0.1)
reg.SubmapRecorder(intrinsic=camera, voxel_size=0.1, truncation=0.4, depth_scale=1000.0, depth_max=3.0, frames=4, max_length=1.0, shared=0.25, device="cpu")
recorder().add(depth=frame.depth, T_world_camera=pose, color=color, number=0)
reg.close_loops(submaps=[submap], voxel_size=0.1, drift=0.05, seed=0, progress=None)
reg.corrected_trajectory(submaps=[submap], T_world_submap=[pose])
reg.fuse_submaps(submaps=[submap], T_world_submap=[pose], voxel_size=0.1)
""",  # noqa: E501
    "reconstruction": """
reg.ReconstructionConfig(path_dataset="frames", path_intrinsic="camera.json", depth_min=0.3, depth_max=3.0, depth_scale=1000.0, depth_diff_max=0.07, odometry_method="hybrid", n_frames_per_fragment=100, n_frames_least=2, n_keyframes_per_n_frame=5, preference_loop_closure_odometry=0.1, voxel_size=0.05, global_registration="robust", icp_method="color", preference_loop_closure_registration=5.0, tsdf_cubic_size=3.0, tsdf_voxel_size=0.01, fragment_voxel_size=0.01, sdf_trunc=0.04, surface_weight_threshold=3.0, seed=0, max_iterations=5, distance_threshold=0.07, fitness_threshold=0.3, regularizer_weight=1.0, method="slac", save_output_as="mesh", folder_slac="slac/", template_fragment_posegraph="fragments/fragment_%03d.json", template_fragment_posegraph_optimized="fragments/fragment_optimized_%03d.json", template_fragment_pointcloud="fragments/fragment_%03d.ply", template_global_posegraph_optimized="scene/global_registration_optimized.json", template_refined_posegraph="scene/refined_registration.json", template_refined_posegraph_optimized="scene/refined_registration_optimized.json", template_global_mesh="scene/integrated.ply", template_global_traj="scene/trajectory.log", template_optimized_posegraph_slac="optimized_posegraph_slac.json")
reg.ReconstructionConfig.from_names(names={"depth_max": 2.0})
reg.ReconstructionConfig.read(path="config.json")
settings.write(path="written.json")
reg.FragmentOptions(folder="stages", config=settings)
reg.run_reconstruction_system(source=sequence, config=settings, folder="job", stages=["refine"], device="cpu", progress=None)
reg.SLACOptimizerParams(max_iterations=2, voxel_size=0.05, distance_threshold=0.07, fitness_threshold=0.3, regularizer_weight=1.0, grid_size=0.375)
reg.run_slac_optimizer_for_fragments(fragments=clouds, fragment_pose_graph=graph, params=params, progress=None)
reg.run_rigid_optimizer_for_fragments(fragments=clouds, fragment_pose_graph=graph, params=params, progress=None)
reg.ControlGrid(grid_size=0.375, device="cpu")
grid.touch(cloud=cloud)
grid.deform(cloud=cloud)
grid.set_positions(positions=grid.get_init_positions())
grid.deform_depth(depth=depth, intrinsic=camera, extrinsic=pose, depth_scale=1000.0, depth_max=3.0)
grid.deform_rgbd(image=image, intrinsic=camera, extrinsic=pose, depth_max=3.0)
integrate_deformed(volume=volume, grid=grid, depth=depth, intrinsic=camera, T_world_fragment=pose, T_fragment_camera=pose, color=image.color, depth_max=3.0)
""",  # noqa: E501
}
HOMES = {
    "tracker()": "DenseSLAM", "model()": "SlamModel", "recorder()": "SubmapRecorder", "submap": "Submap",
    "settings": "ReconstructionConfig", "grid": "ControlGrid",
}  # fmt: skip
LEFT_OUT = {  # records, and methods of the model that tracking calls
    "odometry": {"OdometryFrame.from_image"},
    "slam": {"SlamModel.seen_from", "SlamModel.fuse", "SlamModel.begin_anew", "SubmapRecorder.take_over"},
    "reconstruction": set(),
}  # fmt: skip
MAY_BE_INFINITE = {("compute_rgbd_odometry", "depth_max"), ("OdometryFrame", "depth_max")}
ALSO = {"source": "frame", "depth": "intrinsic"}  # the names in messages of slam
TABLES = {package: read_table(lines, HOMES) for package, lines in CALLS.items()}
SLOW = [
    ("check_focal", "depth_max"),
    *(("run_reconstruction_system", name) for name in TABLES["reconstruction"]["run_reconstruction_system"][1]),
]
CASES = [
    pytest.param(package, call, name, marks=pytest.mark.slow if (call, name) in SLOW else ())
    for package, table in TABLES.items()
    for call, (_, names) in table.items()
    for name in names
]
GOOD = [(package, call) for package in ("odometry", "slam") for call in TABLES[package]]
SMALL = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
SEEN = SimpleNamespace(depth=1.0 + 0.1 * np.sin(np.mgrid[:24, :32].sum(axis=0)), color=None)


@cache
def things(package: str) -> dict[str, Any]:
    make = {"frames": frame_things, "odometry": pair_things, "slam": slam_things, "reconstruction": job_things}[package]
    return {"loom": loom, "reg": loom.rgbd, "pose": np.eye(4)} | make()


def frame_things() -> dict[str, Any]:
    return {"posed": Wall(1), "frames": loom.frames_from(waves()[:2], CAMERA), "turning": turning_path()}


def pair_things() -> dict[str, Any]:
    od, depth = loom.rgbd, np.full((24, 32), 1500, np.uint16)
    color = np.random.default_rng(0).integers(0, 255, (24, 32, 3), np.uint8)
    return dict(
        depth=depth, color=color, camera=SMALL, frame=od.OdometryFrame(depth, SMALL, color),
        rgbd=loom.RGBDImage(color, depth),
    )  # fmt: skip


def slam_things() -> dict[str, Any]:
    model = loom.rgbd.SlamModel(SMALL, voxel_size=0.1, depth_max=2.0)
    model.integrate(SEEN, np.eye(4))

    @cache  # for all values: a rejected call changes nothing
    def tracker() -> Any:
        made = loom.rgbd.DenseSLAM(SMALL, voxel_size=0.1, submap_frames=10)
        made.step(SEEN)
        made.track(SEEN)
        return made

    def recorder(color: bool = True) -> Any:
        return loom.rgbd.SubmapRecorder(SMALL, voxel_size=0.1, frames=4, color=color)

    plain = recorder(color=False)
    plain.add(SEEN.depth, np.eye(4))
    return {
        "Submap": Submap,
        "submap": plain.finish()[0], "recorder": recorder, "color": np.full((24, 32, 3), 100, np.uint8),
        "camera": SMALL, "frame": SEEN, "model": lambda: model, "tracker": tracker,
    }  # fmt: skip


def job_things() -> dict[str, Any]:
    rec, points = loom.rgbd, np.random.default_rng(0).random((300, 3)) * [1, 1, 0]
    grid, clouds = rec.ControlGrid(), [loom.PointCloud(points), loom.PointCloud(points)]
    grid.touch(clouds[0])
    nodes = [registration.PoseGraphNode(), registration.PoseGraphNode()]
    depth = np.full((12, 16), 1000, np.uint16)
    return {
        "integrate_deformed": integrate_deformed,
        "settings": config(), "sequence": ShortSequence([0, 1]), "grid": grid, "clouds": clouds, "cloud": clouds[0],
        "graph": registration.PoseGraph(nodes, [registration.PoseGraphEdge(0, 1)]), "depth": depth,
        "params": rec.SLACOptimizerParams(max_iterations=1), "volume": loom.TSDFVolume(voxel_size=0.02),
        "camera": loom.PinholeCameraIntrinsic(16, 12, 20.0, 20.0, 7.5, 5.5),
        "image": loom.RGBDImage(np.zeros((12, 16, 3), np.uint8), depth),
    }  # fmt: skip


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    config().write("config.json")


def test_the_tables_name_every_argument_of_every_public_call():
    table = {call: entry for calls in TABLES.values() for call, entry in calls.items()}
    assert missing_from(table, public_arguments(loom.rgbd, set().union(*LEFT_OUT.values()))) == {}


def good_call(package, call):
    function, expressions = TABLES[package][call]
    good = {name: eval(expression, dict(things(package))) for name, expression in expressions.items()}
    return call_of(function, things(package)), good


@pytest.mark.parametrize(("package", "call"), GOOD)
def test_the_good_arguments_are_taken(package, call):
    act, good = good_call(package, call)
    act(**good)


@pytest.mark.parametrize(("package", "call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(package, call, argument):
    check_argument(package, call, argument, every=(call, argument) in SLOW)


@pytest.mark.slow
@pytest.mark.parametrize(("package", "call"), [(package, call) for package, table in TABLES.items() for call in table])
def test_all_hostile_values_are_refused_by_name(package, call):
    for argument in TABLES[package][call][1]:
        if (call, argument) not in SLOW:
            check_argument(package, call, argument, every=True)


def check_argument(package, call, argument, every):
    act, good = good_call(package, call)
    finite, also = (call, argument) not in MAY_BE_INFINITE, ALSO.get(argument, "") if package == "slam" else ""
    faults = faults_of(act, good, argument, finite=finite, also=also, every=every)
    assert not faults, "\n".join(faults)
