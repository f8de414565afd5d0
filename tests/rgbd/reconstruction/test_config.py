"""Open3D's configurations are read unchanged; invalid values are named in the error."""

import json

import pytest

import pointloom as loom
from pointloom.core.errors import FileError

Config = loom.reconstruction.ReconstructionConfig

# Open3D's examples/python/reconstruction_system/config/tutorial.json, and the defaults set by initialize_config.py.
TUTORIAL = json.loads("""{
"name": "Open3D reconstruction tutorial http://open3d.org/docs/release/tutorial/reconstruction_system/index.html",
"path_dataset": "dataset/tutorial/", "path_intrinsic": "", "depth_max": 3.0, "voxel_size": 0.05,
"depth_diff_max": 0.07, "preference_loop_closure_odometry": 0.1, "preference_loop_closure_registration": 5.0,
"tsdf_cubic_size": 3.0, "icp_method": "color", "global_registration": "ransac", "python_multi_threading": true,
"depth_map_type": "redwood", "n_frames_per_fragment": 100, "n_keyframes_per_n_frame": 5, "depth_min": 0.3,
"depth_scale": 1000, "max_iterations": 5, "sdf_trunc": 0.04, "block_count": 40000, "distance_threshold": 0.07,
"fitness_threshold": 0.3, "regularizer_weight": 1, "method": "slac", "device": "CPU:0", "save_output_as": "pointcloud",
"folder_slac": "slac/", "template_optimized_posegraph_slac": "optimized_posegraph_slac.json",
"folder_fragment": "fragments/", "subfolder_slac": "slac/0.050/", "debug_mode": false, "folder_scene": "scene/",
"template_fragment_posegraph": "fragments/fragment_%03d.json",
"template_fragment_posegraph_optimized": "fragments/fragment_optimized_%03d.json",
"template_fragment_pointcloud": "fragments/fragment_%03d.ply",
"template_global_posegraph": "scene/global_registration.json",
"template_global_posegraph_optimized": "scene/global_registration_optimized.json",
"template_refined_posegraph": "scene/refined_registration.json",
"template_refined_posegraph_optimized": "scene/refined_registration_optimized.json",
"template_global_mesh": "scene/integrated.ply", "template_global_traj": "scene/trajectory.log"
}""")


def test_open3ds_configuration_is_accepted_unchanged(tmp_path):
    path = tmp_path / "tutorial.json"
    path.write_text(json.dumps(TUTORIAL))
    names = Config.read(path).to_names()
    understood = {name: value for name, value in TUTORIAL.items() if name in names}
    assert {name: names[name] for name in understood} == understood
    ignored = set(TUTORIAL) - set(names)
    assert ignored == {
        *("name", "python_multi_threading", "depth_map_type", "block_count", "device", "subfolder_slac", "debug_mode")
    }


def test_the_defaults_are_open3ds_except_data_dependent_ones():
    default = Config().to_names()
    assert {name for name, value in default.items() if name in TUTORIAL and value != TUTORIAL[name]} == {
        *("path_dataset", "depth_scale", "sdf_trunc", "global_registration")
    }


def test_older_names_mean_the_same():
    config = Config.from_names({"max_depth": 2.5, "max_depth_diff": 0.05})
    assert config == Config(depth_max=2.5, depth_diff_max=0.05)


def test_names_of_the_tensor_system_are_accepted_with_or_without_groups():
    grouped = {
        "general": {"fragment_size": 50, "depth_max": 2.0},
        "odometry": {"odometry_method": "point2plane", "odometry_loop_interval": 10, "odometry_distance_thr": 0.05},
        "registration": {"icp_method": "colored", "icp_voxelsize": 0.04, "registration_loop_weight": 0.1},
        "integration": {"voxel_size": 0.01, "trunc_voxel_multiplier": 8.0, "surface_weight_thr": 3.0},
    }
    flat = {name: value for group in grouped.values() for name, value in group.items()}
    fragments = {"n_frames_per_fragment": 50, "depth_max": 2.0, "n_keyframes_per_n_frame": 10, "depth_diff_max": 0.05}
    methods = {"odometry_method": "point_to_plane", "icp_method": "color", "preference_loop_closure_registration": 0.1}
    surface = {"voxel_size": 0.04, "tsdf_voxel_size": 0.01, "sdf_trunc": 0.08, "surface_weight_threshold": 3.0}
    expected = Config(**fragments, **methods, **surface)
    assert Config.from_names(grouped) == Config.from_names(flat) == expected


def test_a_written_configuration_is_read_again(tmp_path):
    config = Config(voxel_size=0.1, icp_method="generalized", tsdf_voxel_size=0.02)
    config.write(tmp_path / "config.json")
    assert Config.read(tmp_path / "config.json") == config


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ({"voxelsize": 0.05}, "voxelsize: unknown name .* did you mean 'voxel_size'"),
        ({"depth_max": "3.0"}, "depth_max: expected a number"),
        ({"depth_max": True}, "depth_max: expected a number"),
        ({"depth_max": None}, "depth_max: expected a number"),
        ({"voxel_size": 0}, "voxel_size: expected a finite number > 0"),
        ({"n_frames_per_fragment": 10.0}, "n_frames_per_fragment: expected an integer"),
        ({"n_frames_per_fragment": 0}, "n_frames_per_fragment: expected an integer >= 1"),
        ({"icp_method": "colors"}, "icp_method: expected one of"),
        ({"icp_method": 3}, "icp_method: expected a string"),
        ({"depth_min": 4.0}, "depth_min: expected less than depth_max"),
        ({"max_depth": 2.0, "depth_max": 2.0}, "depth_max: a second name of max_depth"),
        ({"integration": {"voxel_size": 0.1}, "voxel_size": 0.1}, "voxel_size: given twice"),
        ({"sdf_trunc": 0.001}, "sdf_trunc: expected at least one voxel"),
        ({"n_frames_least": 200}, "n_frames_least: expected at most n_frames_per_fragment"),
        ({"folder_scene": "/scene"}, "folder_scene: expected a path within the job's folder"),
        ({"template_global_mesh": "../mesh.ply"}, "template_global_mesh: expected a path within"),
        ({"template_fragment_posegraph": "fragment.json"}, "template_fragment_posegraph: expected one %03d"),
        ({"template_fragment_posegraph": "%03d/%03d.json"}, "template_fragment_posegraph: expected one %03d"),
    ],
)
def test_invalid_values_are_named(tmp_path, names, message):
    path = tmp_path / "config.json"
    path.write_text(json.dumps(names))
    with pytest.raises(FileError, match=message) as caught:
        Config.read(path)
    assert str(path) in str(caught.value)
    with pytest.raises((TypeError, ValueError), match=message):
        Config.from_names(names)


def test_a_list_is_rejected_as_a_configuration(tmp_path):
    with pytest.raises(TypeError, match="expected a mapping"):
        Config.from_names([])
    (tmp_path / "list.json").write_text("[]")
    with pytest.raises(FileError, match=r"/list\.json:"):
        Config.read(tmp_path / "list.json")
