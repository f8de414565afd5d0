"""The complete reconstruction system: its settings, its fragments, its model, and interrupted runs that continue."""

import copy
import dataclasses
import errno
import functools
import io
import json
import operator
import os
import shutil
import weakref
from functools import partial
from pathlib import Path
from unittest.mock import Mock

import numpy as np
import pytest

import pointloom as loom
from pointloom.core import atomic, records
from pointloom.core.errors import DeviceError, FileError
from pointloom.core.wording import json_text
from pointloom.core.work_folder import locked
from pointloom.datasets.scenes.room import surface_errors
from pointloom.rgbd.reconstruction import fragments, placement, scene
from pointloom.rgbd.reconstruction.fragments import fragments_in, make_fragments
from pointloom.rgbd.reconstruction.job_files import JobFiles
from pointloom.rgbd.reconstruction.nonrigid import refine_with_slac
from pointloom.rgbd.reconstruction.placement import multiway, register_fragments
from pointloom.rgbd.reconstruction.refinement import method_for, refine_registration
from pointloom.rgbd.reconstruction.scene import integrate_scene

from ...interruptions import run_lines
from ...products import few_quick
from .walks import ShortSequence, blank, config, drift_of, frame_at

run_reconstruction_system = loom.rgbd.run_reconstruction_system


def digest_of(folder):
    """The content of the files of a job, without times."""
    paths = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def on_the_truth(report, sequence, folder):
    """The vertices of the model, with its first camera aligned to the true one."""
    path = loom.read_trajectory(folder / "scene" / "trajectory.log")
    T = sequence.read(int(path.ids[0, 0])).T_world_camera @ np.linalg.inv(path.poses[0])
    vertices = loom.read_triangle_mesh(folder / "scene" / "integrated.ply").vertices
    return vertices @ T[:3, :3].T + T[:3, 3]


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A sequence of nine frames in three fragments, and its reconstruction."""
    folder, sequence = tmp_path_factory.mktemp("job"), ShortSequence(range(9), width=160)
    return sequence, folder, run_reconstruction_system(sequence, config(n_frames_per_fragment=3), folder)


@pytest.mark.slow
def test_frames_without_poses_are_reconstructed_to_the_room(room):
    sequence, folder, report = room
    assert (report.used, report.lost, report.warnings) == (9, (), ())
    assert [fragment.frames for fragment in report.fragments] == [3, 3, 3]
    assert all(fragment.placed for fragment in report.fragments) and report.trajectory_error["rmse"] < 0.01
    errors = surface_errors(on_the_truth(report, sequence, folder))
    assert np.median(errors) < 0.01 and len(errors) == report.mesh["vertices"] > 3000


@pytest.mark.slow
def test_the_report_is_json_and_names_existing_files(room):
    _, _, report = room
    assert json.loads(json_text(report))["used"] == 9
    assert [Path(path).name for path in report.files] == ["integrated.ply", "trajectory.log"]
    assert all(Path(path).is_file() for path in report.files)


def test_open3d_reads_the_pose_graphs(room, o3d):
    _, folder, report = room
    graph = o3d.io.read_pose_graph(str(folder / "scene" / "refined_registration_optimized.json"))
    assert (len(graph.nodes), len(graph.edges)) == (3, report.edges)
    assert len(o3d.io.read_pose_graph(str(folder / "fragments" / "fragment_optimized_000.json")).nodes) == 3


@pytest.mark.slow
def test_each_stage_can_be_run_by_itself(room, tmp_path):
    sequence, folder, _ = room
    settings = config(n_frames_per_fragment=3)
    make_fragments(sequence, settings, tmp_path)
    register_fragments(settings, tmp_path)
    integrated = integrate_scene(sequence, settings, tmp_path)
    refine_registration(settings, tmp_path)
    refined = integrate_scene(sequence, settings, tmp_path)
    settings.write(tmp_path / "config.json")
    assert not np.array_equal(integrated.T_world_camera, refined.T_world_camera)
    assert digest_of(tmp_path) == digest_of(folder)
    path = loom.read_trajectory(folder / "scene" / "trajectory.log")
    assert path.ids.tolist() == [[i, i, 9] for i in range(9)], "the path names the frames"


def test_a_stage_requires_the_previous_one(tmp_path):
    settings, sequence = config(), ShortSequence([0, 1])
    for stage in (register_fragments, refine_with_slac):
        with pytest.raises(FileError, match="make_fragments"):
            stage(settings, tmp_path)
    make_fragments(sequence, settings, tmp_path)
    for stage in (refine_registration, refine_with_slac, lambda *job: integrate_scene(sequence, *job)):
        with pytest.raises(FileError, match="register_fragments"):
            stage(settings, tmp_path)
    register_fragments(settings, tmp_path)
    with pytest.raises(FileError, match="refine_with_slac"):
        integrate_scene(sequence, settings, tmp_path, slac=True)


def test_each_stage_runs_on_the_device_that_is_passed(tmp_path):
    of_frames = (partial(stage, ShortSequence([0])) for stage in (make_fragments, integrate_scene))
    for stage in (*of_frames, register_fragments, refine_registration, refine_with_slac):
        with pytest.raises(DeviceError, match="cuda:99"):
            stage(config(), tmp_path, device="cuda:99")


def test_recomputed_fragments_are_registered_again(tmp_path):
    run_reconstruction_system(ShortSequence([0, 1]), config(), tmp_path)
    make_fragments(ShortSequence([0, 1, 2]), config(), tmp_path)
    with pytest.raises(FileError, match="recreated after their registration"):
        integrate_scene(ShortSequence([0, 1, 2]), config(), tmp_path)


def test_parts_that_cannot_be_joined_are_listed(tmp_path):
    report = run_reconstruction_system(ShortSequence([0, 1, 2, 3, 40, 41]), config(), tmp_path)
    assert report.used == 4
    (lost,) = report.lost
    assert (lost.first, lost.last, lost.count, lost.stage) == ("frame-4", "frame-5", 2, "register_fragments")
    assert "2 of 6 frames are not in the model" in str(report.warnings)
    assert [fragment.placed for fragment in report.fragments] == [True, False]


@pytest.mark.slow
def test_overlapping_parts_are_joined_without_odometry(tmp_path):
    report = run_reconstruction_system(ShortSequence([0, 1, 2, 40, 41, 42, 2, 1, 0], width=160), config(), tmp_path)
    assert [fragment.placed for fragment in report.fragments] == [True, False, True]
    assert [fragment.joined for fragment in report.fragments] == [False, False, False]
    assert report.trajectory_error["rmse"] < 0.01


def test_one_frame_is_a_model(tmp_path):
    report = run_reconstruction_system(ShortSequence([0]), config(), tmp_path)
    assert (report.used, report.reliable) == (1, True) and report.mesh["vertices"] > 1000


def test_blank_frames_leave_no_model_and_are_reported(tmp_path):
    report = run_reconstruction_system(
        ShortSequence([0, 1], changed={i: blank(frame_at(i)) for i in (0, 1)}), config(), tmp_path
    )
    assert (report.used, report.files, report.mesh) == (0, (), None) and report.lost[0].count == 2
    assert "frames overlap" in str(report.warnings)


def stream(count):
    sequence = ShortSequence(range(count))
    frames = (sequence.read(i) for i in range(count))
    return loom.frames_from(((frame.color, frame.depth) for frame in frames), sequence.intrinsic)


def test_a_stream_is_recorded_and_then_read_as_often_as_needed(tmp_path):
    report = run_reconstruction_system(stream(4), config(), tmp_path)
    assert (report.used, report.trajectory_error) == (4, None)
    assert len(loom.open_frames(tmp_path / "frames")) == 4
    assert run_reconstruction_system(stream(0), config(), tmp_path, resume=True).resumed == 1
    with pytest.raises(FileError, match="frames"):
        run_reconstruction_system(stream(4), config(), tmp_path)


def test_frames_are_released_after_use(tmp_path):
    sequence, alive, alive_counts = ShortSequence(range(8)), [], []
    inner = sequence.read

    def read(index):
        frame = inner(index)
        frame = dataclasses.replace(frame, depth=frame.depth.copy())
        alive.append(weakref.ref(frame.depth))
        alive_counts.append(sum(ref() is not None for ref in alive))
        return frame

    sequence.read = read
    run_reconstruction_system(sequence, config(n_frames_per_fragment=4), tmp_path)
    assert len(alive_counts) == 32  # twice for fragments, once for the scene, once for the check of the images
    assert max(alive_counts) <= 6  # frames that are decoded ahead


STAGES = "fragments", "walk", "placement", "refinement", "scene", "job"
FILES = tuple(f"rgbd/reconstruction/{name}.py" for name in STAGES)
SETTINGS = config(n_frames_per_fragment=3)


def short_sequence():
    """Seven frames, one of them covered: two fragments, the second bridged."""
    return ShortSequence(range(7), changed={3: blank(frame_at(3))})


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    """An uninterrupted run: its folder, its report and its files."""
    folder = tmp_path_factory.mktemp("whole")
    report = run_reconstruction_system(short_sequence(), SETTINGS, folder)
    return folder, report, digest_of(folder)


@pytest.fixture
def complete_digest(done):
    return done[2]


@pytest.fixture
def job(done, tmp_path):
    """A copy of the completed run that a test may change."""
    return Path(shutil.copytree(done[0], tmp_path / "job"))


def test_a_completed_run_is_unchanged(done, job):
    times = {path: path.stat().st_mtime_ns for path in job.rglob("*.ply")}
    again = run_reconstruction_system(short_sequence(), SETTINGS, job, resume=True)
    assert again.resumed == 2 and {path: path.stat().st_mtime_ns for path in job.rglob("*.ply")} == times
    for name in ("lost", "fragments", "mesh", "trajectory_error", "warnings"):
        assert getattr(again, name) == getattr(done[1], name)
    assert digest_of(job) == done[2]


@pytest.mark.slow
def test_an_interrupted_run_resumes_to_the_same_bits(tmp_path, complete_digest):
    lines = run_lines(lambda: run_reconstruction_system(short_sequence(), SETTINGS, tmp_path / "all"), FILES)
    for k, stop in enumerate(np.linspace(1, lines - 1, 9).astype(int).tolist()):
        folder = tmp_path / str(k)
        assert (
            run_lines(lambda folder=folder: run_reconstruction_system(short_sequence(), SETTINGS, folder), FILES, stop)
            == stop
        )
        run_reconstruction_system(short_sequence(), SETTINGS, folder, resume=True)
        assert digest_of(folder) == complete_digest, f"interrupted before line {stop} of {lines}"


def test_an_interruption_loses_one_fragment_at_most(tmp_path):
    sequence = short_sequence()
    inner = sequence.read

    def read(index):
        if index == 6 and (tmp_path / "records" / "fragment_000.json").exists():
            raise KeyboardInterrupt
        return inner(index)

    sequence.read = read
    with pytest.raises(KeyboardInterrupt):
        run_reconstruction_system(sequence, SETTINGS, tmp_path)
    assert run_reconstruction_system(short_sequence(), SETTINGS, tmp_path, resume=True).resumed == 1


class FullDisk(io.FileIO):
    """A file on a disk with little space left, for all files together."""

    room = 0

    def write(self, data):
        FullDisk.room -= len(data)
        if FullDisk.room < 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return super().write(data)


@few_quick(1, "room", [3000, 200_000])
def test_a_full_disk_is_reported_and_the_run_resumes_from_there(tmp_path, monkeypatch, complete_digest, room):
    FullDisk.room = room
    with monkeypatch.context() as patch:
        patch.setattr(atomic.io, "FileIO", FullDisk)
        with pytest.raises(FileError, match="No space left"):
            run_reconstruction_system(short_sequence(), SETTINGS, tmp_path)
    assert not list(tmp_path.rglob("*.part"))
    run_reconstruction_system(short_sequence(), SETTINGS, tmp_path, resume=True)
    assert digest_of(tmp_path) == complete_digest


@pytest.mark.parametrize("name", ["fragments/fragment_001.ply", "scene/integrated.ply", "records/refine.json"])
def test_a_damaged_file_is_recomputed(job, complete_digest, name):
    path = job / name
    path.write_bytes(path.read_bytes()[:-40])
    run_reconstruction_system(short_sequence(), SETTINGS, job, resume=True)
    assert digest_of(job) == complete_digest


READERS = {
    "fragment_000": lambda job, path: fragments.read_fragments(job),
    "register": lambda job, path: placement.read_placement(job, "register", 2),
    "refine": lambda job, path: placement.read_placement(job, "refine", 2),
    "integrate": lambda job, path: scene._read_scene(job, json.loads(path.read_text())["made_from"]),
}
OPTIONAL = {("result", "joint"), ("result", "figures", "bounds"), ("result", "figures", "trajectory_error")}


def places(value, path=()):
    """The positions of all values in JSON, the first of each list."""
    yield path
    inner = value.items() if isinstance(value, dict) else enumerate(value[:1]) if isinstance(value, list) else ()
    for key, each in inner:
        yield from places(each, (*path, key))


@pytest.mark.parametrize("name", READERS)
def test_a_record_of_other_values_is_not_used_though_its_digest_matches(job, name):
    path, files = job / "records" / f"{name}.json", JobFiles.make(job, SETTINGS)
    before = json.loads(path.read_text())
    assert READERS[name](files, path)
    for place in list(places(before))[1:]:
        *outer, last = place
        if place[0] not in ("stage", "version", "result"):
            continue
        for value in ("x", None, {"a": 1}, [[1]], "missing"):
            content = {key: value for key, value in copy.deepcopy(before).items() if key != "digest"}
            at = functools.reduce(operator.getitem, outer, content)
            is_text = place[0] == "result" and isinstance(at[last], str)
            if (value is None and place in OPTIONAL) or (value == "x" and is_text):
                continue
            at[last] = value
            if value == "missing":
                del at[last]
            path.write_text(json.dumps(content | {"digest": records.digest_of(content)}))
            assert not READERS[name](files, path), (place, value)


@pytest.mark.parametrize(("name", "field"), [("fragment_001", "velocity"), ("register", "placed"), ("refine", "poses")])
def test_a_stage_with_a_record_of_other_values_is_recomputed(job, complete_digest, name, field):
    path = job / "records" / f"{name}.json"
    content = json.loads(path.read_text())
    content.pop("digest")
    content["result"][field] = [[None]]
    path.write_text(json.dumps(content | {"digest": records.digest_of(content)}))
    run_reconstruction_system(short_sequence(), SETTINGS, job, resume=True)
    assert digest_of(job) == complete_digest


@pytest.mark.parametrize("content", ["{}", '{"scene": "hall"}', "photos"])
def test_a_folder_of_another_program_is_not_used(tmp_path, content):
    (tmp_path / "config.json").write_text(content)
    with pytest.raises(FileError, match="do not belong to a run"):
        run_reconstruction_system(short_sequence(), SETTINGS, tmp_path)
    assert (tmp_path / "config.json").read_text() == content and len(list(tmp_path.iterdir())) == 1


def test_other_files_in_the_folder_are_kept_and_a_second_run_is_an_error(job, complete_digest):
    (job / "notes.txt").write_text("mine")
    run_reconstruction_system(short_sequence(), SETTINGS, job)
    assert (job / "notes.txt").read_text() == "mine" and digest_of(job).keys() == {*complete_digest, "notes.txt"}
    with locked(job), pytest.raises(FileError, match="another run is using it"):
        run_reconstruction_system(short_sequence(), SETTINGS, job)


def test_a_changed_configuration_starts_a_new_run(job):
    report = run_reconstruction_system(short_sequence(), config(n_frames_per_fragment=2), job, resume=True)
    assert report.resumed == 0 and [fragment.frames for fragment in report.fragments] == [2, 2]


def test_a_stage_is_rerun_if_its_own_settings_change(done, job):
    report = run_reconstruction_system(
        short_sequence(), config(n_frames_per_fragment=3, tsdf_voxel_size=0.04), job, resume=True
    )
    assert report.resumed == 2 and report.mesh["vertices"] < done[1].mesh["vertices"]


def test_a_changed_frame_reruns_its_fragment_and_later_ones(job):
    changed = ShortSequence(range(7), changed={3: blank(frame_at(3)), 5: {"depth": frame_at(5).depth + np.uint16(1)}})
    assert run_reconstruction_system(changed, SETTINGS, job, resume=True).resumed == 1


@pytest.mark.slow
def test_a_longer_sequence_reuses_complete_fragments(tmp_path):
    run_reconstruction_system(ShortSequence(range(5)), SETTINGS, tmp_path)
    report = run_reconstruction_system(ShortSequence(range(8)), SETTINGS, tmp_path, resume=True)
    assert report.resumed == 1 and [fragment.frames for fragment in report.fragments] == [3, 3, 2]


def test_a_shorter_sequence_leaves_no_old_fragment(job):
    report = run_reconstruction_system(ShortSequence(range(3)), SETTINGS, job, resume=True)
    assert [fragment.frames for fragment in report.fragments] == [3] and report.used == 3
    assert not list(job.rglob("*_001.*"))


@pytest.mark.slow
def test_old_fragments_are_removed_even_after_an_interruption(tmp_path):
    run_reconstruction_system(ShortSequence(range(8)), config(n_frames_per_fragment=2), tmp_path)
    (tmp_path / "records" / "fragment_001.json").unlink()
    assert (
        run_reconstruction_system(ShortSequence(range(4)), config(n_frames_per_fragment=2), tmp_path, resume=True).used
        == 4
    )
    assert not list(tmp_path.rglob("*_003.*"))


def test_without_resume_nothing_is_reused(job):
    assert run_reconstruction_system(short_sequence(), SETTINGS, job).resumed == 0


Config = loom.rgbd.ReconstructionConfig


# Open3D's examples/python/reconstruction_system/config/tutorial.json, and the defaults of Open3D's
# initialize_config.py.
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
    other = "name", "python_multi_threading", "depth_map_type", "block_count", "device", "subfolder_slac", "debug_mode"
    unwritten = "folder_fragment", "folder_scene", "template_global_posegraph"
    assert set(TUTORIAL) - set(names) == {*other, *unwritten}


def test_the_defaults_are_open3ds_except_data_dependent_ones():
    different = {name for name, value in Config().to_names().items() if name in TUTORIAL and value != TUTORIAL[name]}
    assert different == {"path_dataset", "depth_scale", "sdf_trunc", "global_registration"}


def test_fragments_have_a_fifth_of_the_voxel_edge_or_the_given_one():
    assert Config(voxel_size=0.1).fragment_voxel == pytest.approx(0.02)
    assert Config(fragment_voxel_size=0.03).fragment_voxel == 0.03


def test_older_names_mean_the_same():
    assert Config.from_names({"max_depth": 2.5, "max_depth_diff": 0.05}) == Config(depth_max=2.5, depth_diff_max=0.05)


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
    assert Config.from_names(grouped) == Config.from_names(flat) == Config(**fragments, **methods, **surface)


def test_the_seed_is_that_of_the_registration(tmp_path, monkeypatch):
    search = Mock(wraps=multiway.register_multiway)
    monkeypatch.setattr(multiway, "register_multiway", search)
    settings = config(n_frames_per_fragment=1, n_frames_least=1, seed=7)
    make_fragments(ShortSequence([0, 1]), settings, tmp_path)
    register_fragments(settings, tmp_path)
    assert search.call_args.kwargs["seed"] == 7


def test_the_voxel_of_the_scene_is_a_512th_of_its_cube():
    assert Config(tsdf_cubic_size=2.56).volume_voxel_size == pytest.approx(0.005)
    assert Config(tsdf_cubic_size=5.12, tsdf_voxel_size=0.02).volume_voxel_size == 0.02


def test_files_have_the_requested_names(tmp_path):
    names = {
        "template_fragment_posegraph": "parts/%d.graph.json",
        "template_fragment_posegraph_optimized": "parts/%d.optimized.json",
        "template_fragment_pointcloud": "parts/%d.ply",
        "template_global_posegraph_optimized": "all/registered.json",
        "template_refined_posegraph": "all/edges.json",
        "template_refined_posegraph_optimized": "all/refined.json",
        "template_global_mesh": "model.ply",
        "template_global_traj": "path.log",
        "folder_slac": "bent",
        "template_optimized_posegraph_slac": "poses.json",
    }
    settings = config(n_frames_per_fragment=2, max_iterations=1, **names)
    sequence = ShortSequence([0, 1, 2, 3])
    report = run_reconstruction_system(sequence, settings, tmp_path, stages=("refine", "slac", "integrate"))
    assert report.used == 4
    written = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.*")}
    expected = (
        {"config.json"}
        | {each % k for each in list(names.values())[:3] for k in (0, 1)}
        | set(list(names.values())[3:8])
    )
    expected |= {"bent/poses.json", "bent/control_grid.npz", "bent/output_slac_pointcloud.ply"}
    assert {name for name in written if not name.startswith("records")} == expected


def test_a_written_configuration_is_read_again(tmp_path):
    config = Config(
        "frames", path_intrinsic="camera.json", voxel_size=0.1, icp_method="generalized", tsdf_voxel_size=0.02
    )
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
        ({"folder_slac": "/slac"}, "folder_slac: expected a path within the job's folder"),
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


def test_frames_of_redwood_give_a_model(tmp_path, scan_set, scan_file):
    frames = loom.open_frames(scan_file("rgbd-cupoch-redwood5"))
    report = run_reconstruction_system(frames, Config(tsdf_voxel_size=0.02), tmp_path)
    assert len(frames) == {"shipped": 3, "real": 5}[scan_set]
    assert report.used == len(frames) and "(the default of redwood)" in report.warnings[0]
    assert report.trajectory_error["rmse"] < 0.005  # accuracy of the given poses


@pytest.mark.slow
def test_frames_of_3dmatch_far_apart_are_joined_or_listed(tmp_path, real_file):
    """Frames 0, 1, 2, 116 and 422: three follow each other, the fourth shares half with the third, the last nothing."""
    frames = loom.open_frames(real_file("rgbd-nvblox-3dmatch/seq-01"))
    report = run_reconstruction_system(frames, Config(tsdf_voxel_size=0.02, depth_max=4.0), tmp_path)
    assert [run.first for run in report.lost] in (["frame-000422"], ["frame-000116", "frame-000422"])
    path = loom.read_trajectory(tmp_path / "scene" / "trajectory.log").poses
    truth = np.array([frames.read(i).T_world_camera for i in range(3)])
    steps, true = (np.linalg.inv(poses[:2]) @ poses[1:3] for poses in (path, truth))
    assert np.abs(steps - true)[:, :3, 3].max() < 0.02  # the given poses are off by a centimeter


def test_a_pair_without_poses_gives_a_model(tmp_path, real_file):
    """The pair of slambook: two color images and two depth images in one folder, nothing else."""
    camera = loom.PinholeCameraIntrinsic(640, 480, 481.2, 480.0, 319.5, 239.5)
    frames = loom.open_frames(real_file("rgbd-slambook-ch7"), intrinsic=camera, depth_scale=5000.0)
    report = run_reconstruction_system(frames, Config(tsdf_voxel_size=0.02), tmp_path)
    assert (report.used, report.trajectory_error) == (2, None) and report.mesh["vertices"] > 5000


@pytest.mark.slow
def test_every_sixth_frame_of_the_kitchen_is_registered(tmp_path, real_file):
    frames = loom.open_dataset(real_file("rgbd-7scenes-redkitchen"), every=6)
    report = run_reconstruction_system(frames, Config(n_frames_per_fragment=25, tsdf_voxel_size=0.02), tmp_path)
    assert (report.used, report.frames) == (50, 50)
    assert report.trajectory_error["rmse"] < 0.06  # the true poses are accurate to centimeters


def frames_of(result):
    return [fragment.indices.tolist() for fragment in result.fragments]


def test_frames_that_follow_each_other_become_fragments(tmp_path, device):
    sequence = ShortSequence(range(8))
    result = make_fragments(sequence, config(n_frames_per_fragment=5), tmp_path, device=device)
    assert (frames_of(result), result.lost) == ([[0, 1, 2, 3, 4], [5, 6, 7]], [])
    assert max(drift_of(fragment, sequence) for fragment in result.fragments) < 0.015
    first, second = result.fragments
    assert first.joint is None and second.joint.fragment == 0
    truth = np.linalg.inv(frame_at(0).T_world_camera) @ frame_at(5).T_world_camera
    assert np.abs(second.T_earlier(first) - truth).max() < 0.02
    cloud = first.read_cloud(device)
    assert cloud.has_normals and cloud.has_colors


def test_loops_are_detected_where_keyframes_overlap(tmp_path):
    there_and_back = ShortSequence([0, 1, 2, 3, 4, 3, 2, 1, 0])
    (fragment,) = make_fragments(there_and_back, config(n_keyframes_per_n_frame=2), tmp_path).fragments
    tried, aligned, accepted = fragment.loops
    assert tried >= aligned >= accepted >= 4
    graph = loom.registration.read_pose_graph(tmp_path / "fragments" / "fragment_000.json")
    before, after = (np.linalg.norm(pose[:3, 3]) for pose in (graph.nodes[-1].pose, fragment.poses[-1]))
    assert after < 0.75 * before
    ends = [(edge.source_node_id, edge.target_node_id) for edge in graph.edges if edge.uncertain]
    assert len(ends) == aligned and (8, 0) in ends


def test_loops_of_a_fragment_have_more_confidence_if_preferred(tmp_path):
    """The confidence of an edge is (mu / (mu + r))^2, with mu proportional to the preference."""
    sequence = ShortSequence([0, 1, 2, 1, 0])
    ratios = []
    for preference in (0.1, 0.4):
        folder = tmp_path / str(preference)
        settings = config(n_keyframes_per_n_frame=2, preference_loop_closure_odometry=preference)
        make_fragments(sequence, settings, folder)
        graph = loom.registration.read_pose_graph(folder / "fragments" / "fragment_optimized_000.json")
        roots = np.sqrt([edge.confidence for edge in graph.edges if edge.uncertain])
        ratios.append(roots / (1 - roots))
    assert len(ratios[0]) == 3
    np.testing.assert_allclose(ratios[1] / ratios[0], 4, rtol=1e-3)  # r differs a little


def test_loops_between_fragments_have_more_confidence_if_preferred(tmp_path):
    """As within a fragment."""
    sizes, ratios = {"n_frames_per_fragment": 1, "n_frames_least": 1}, []
    make_fragments(ShortSequence([0, 1, 2]), config(**sizes), tmp_path)
    register_fragments(config(**sizes), tmp_path)
    for preference in (1.0, 4.0):
        graph = refine_registration(
            config(preference_loop_closure_registration=preference, **sizes), tmp_path
        ).pose_graph
        (root,) = np.sqrt([edge.confidence for edge in graph.edges if edge.uncertain])
        ratios.append(root / (1 - root))
    assert ratios[1] / ratios[0] == pytest.approx(4, rel=1e-3)


def test_a_covered_lens_breaks_the_fragment_and_odometry_bridges_it(tmp_path):
    result = make_fragments(ShortSequence(range(7), changed={3: blank(frame_at(3))}), config(), tmp_path)
    assert frames_of(result) == [[0, 1, 2], [4, 5, 6]]
    assert [(frame.index, frame.name) for frame in result.lost] == [(3, "frame-3")]
    assert "0.0% of its pixels have a depth" in result.lost[0].reason
    joint = result.fragments[1].joint
    assert (joint.fragment, joint.skipped) == (0, 1)


def test_a_pair_that_does_not_align_breaks_the_fragment(tmp_path):
    result = make_fragments(ShortSequence([0, 1, 2, 40, 41, 42]), config(), tmp_path)
    assert frames_of(result) == [[0, 1, 2], [3, 4, 5]] and result.fragments[1].joint is None
    assert result.fragments[1].broke
    for number, fragment in enumerate(result.fragments):
        graph = loom.registration.read_pose_graph(tmp_path / "fragments" / f"fragment_{number:03d}.json")
        assert len(graph.edges) == len(fragment) - 1
        assert not any(np.array_equal(edge.transformation, np.eye(4)) for edge in graph.edges)


def test_isolated_frames_are_excluded_and_reported(tmp_path):
    result = make_fragments(ShortSequence([0, 1, 2, 40, 80, 81]), config(), tmp_path)
    assert frames_of(result) == [[0, 1, 2], [4, 5]]
    (lost,) = result.lost
    assert lost.index == 3 and "1 frame unconnected, 2 needed" in lost.reason


def test_one_frame_remains_where_no_two_frames_overlap(tmp_path):
    result = make_fragments(ShortSequence([0, 40, 80]), config(), tmp_path)
    assert frames_of(result) == [[0]] and [frame.index for frame in result.lost] == [1, 2]


def test_a_missing_frame_breaks_the_fragment(tmp_path):
    result = make_fragments(ShortSequence(range(5), missing=(2,)), config(), tmp_path)
    assert frames_of(result) == [[0, 1], [3, 4]] and "does not exist" in result.lost[0].reason


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda frame: {"depth": (frame.depth // 256).astype(np.uint8)}, "its depth is uint8"),
        (lambda frame: {"depth": frame.depth[::2, ::2]}, "its depth has shape"),
        (lambda frame: {"color": frame.color[::2, ::2]}, "its color is"),
        (lambda frame: {"color": frame.color.astype(np.float32)}, "its color is float32"),
    ],
    ids=["depth of 8 bits", "depth of another size", "color of another size", "color in floats"],
)
def test_an_unsuitable_frame_is_excluded_with_a_reason(tmp_path, change, message):
    result = make_fragments(ShortSequence(range(3), changed={2: change(frame_at(2))}), config(), tmp_path)
    assert frames_of(result) == [[0, 1]] and message in result.lost[0].reason


@pytest.mark.parametrize("shade", [128, None], ids=["one shade of gray", "no color"])
def test_a_room_without_texture_is_tracked_where_its_shape_constrains_the_pose(tmp_path, shade):
    """Frames of corners and furniture, whose least certain motion costs two to four times the limit."""
    steps = range(92, 98)
    color = None if shade is None else np.full_like(frame_at(92, 160).color, shade)
    sequence = ShortSequence(steps, changed={i: {"color": color} for i in range(len(steps))}, width=160)
    result = make_fragments(sequence, config(), tmp_path)
    assert (frames_of(result), result.lost) == ([[0, 1, 2, 3, 4, 5]], [])
    assert drift_of(result.fragments[0], sequence) < 0.005
    assert result.fragments[0].colored == (shade is not None)


def test_a_frame_without_color_gives_a_cloud_without_colors(tmp_path):
    (fragment,) = make_fragments(ShortSequence(range(4), changed={2: {"color": None}}), config(), tmp_path).fragments
    cloud = fragment.read_cloud()
    assert len(fragment) == 4 and not cloud.has_colors
    mixed = [cloud, cloud.paint_uniform_color([1, 0, 0])]  # color ICP requires colors in both clouds
    assert "PointToPlane" in type(method_for(config(icp_method="color"), mixed)).__name__


def test_depth_in_meters_is_supported(tmp_path):
    meters = {i: {"depth": frame_at(i).depth.astype(np.float32) / 1000} for i in range(3)}
    first = make_fragments(ShortSequence(range(3)), config(), tmp_path / "a").fragments[0]
    second = make_fragments(ShortSequence(range(3), changed=meters), config(), tmp_path / "b").fragments[0]
    assert np.array_equal(first.poses, second.poses)


def test_depth_out_of_range_is_not_used(tmp_path):
    near = make_fragments(ShortSequence([0, 1]), config(depth_min=0.1, depth_max=0.2), tmp_path)
    assert [frame.index for frame in near.lost] == [0, 1] and "from 0.1 to 0.2 m" in near.lost[0].reason


def test_written_fragments_match_the_returned_ones(tmp_path):
    settings = config(n_frames_per_fragment=3)
    result = make_fragments(ShortSequence(range(5)), settings, tmp_path)
    for one, other in zip(result.fragments, fragments_in(JobFiles.make(tmp_path, settings)), strict=True):
        assert np.array_equal(one.poses, other.poses)
        for name in ("names", "broke", "loops", "made_from"):
            assert getattr(one, name) == getattr(other, name)


@pytest.mark.parametrize(
    ("source", "error"),
    [([], TypeError), (iter(()), TypeError), (None, TypeError), (object(), TypeError), (ShortSequence([]), ValueError)],
    ids=["a list", "a stream", "None", "an object", "no frame"],
)
def test_a_source_must_be_readable_by_index_and_contain_a_frame(tmp_path, source, error):
    with pytest.raises(error, match="source:"):
        make_fragments(source, config(), tmp_path)
