"""The complete reconstruction system: the model of connected frames, and the report of the others."""

import dataclasses
import json
import weakref
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.core.wording import json_text
from pointloom.datasets.scenes.room import surface_errors
from pointloom.io.frames.datasets import Frame

from .walks import ShortSequence, blank, config, frame_at

run_system = loom.reconstruction.run_system


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
    report = run_system(sequence, config(n_frames_per_fragment=3), folder)
    return sequence, folder, report


@pytest.mark.slow
def test_frames_without_poses_are_reconstructed_to_the_room(room):
    sequence, folder, report = room
    assert (report.used, report.lost, report.warnings) == (9, (), ())
    assert [fragment.frames for fragment in report.fragments] == [3, 3, 3]
    assert all(fragment.placed for fragment in report.fragments)
    assert report.trajectory_error["rmse"] < 0.01
    errors = surface_errors(on_the_truth(report, sequence, folder))
    assert np.median(errors) < 0.01
    assert len(errors) == report.mesh["vertices"] > 3000


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


def test_the_path_names_the_frames(room):
    _, folder, _ = room
    path = loom.read_trajectory(folder / "scene" / "trajectory.log")
    assert path.ids.tolist() == [[i, i, 9] for i in range(9)]


def test_each_stage_can_be_run_by_itself(room, tmp_path):
    sequence, folder, _ = room
    settings = config(n_frames_per_fragment=3)
    loom.reconstruction.make_fragments(sequence, settings, tmp_path)
    loom.reconstruction.register_fragments(settings, tmp_path)
    integrated = loom.reconstruction.integrate_scene(sequence, settings, tmp_path)
    loom.reconstruction.refine_registration(settings, tmp_path)
    refined = loom.reconstruction.integrate_scene(sequence, settings, tmp_path)
    settings.write(tmp_path / "config.json")
    assert not np.array_equal(integrated.T_world_camera, refined.T_world_camera)
    assert digest_of(tmp_path) == digest_of(folder)


def test_a_stage_requires_the_previous_one(tmp_path):
    with pytest.raises(FileError, match="make_fragments"):
        loom.reconstruction.register_fragments(config(), tmp_path)
    loom.reconstruction.make_fragments(ShortSequence([0, 1]), config(), tmp_path)
    for stage in (
        lambda: loom.reconstruction.refine_registration(config(), tmp_path),
        lambda: loom.reconstruction.integrate_scene(ShortSequence([0, 1]), config(), tmp_path),
    ):
        with pytest.raises(FileError, match="register_fragments"):
            stage()


def test_recomputed_fragments_are_registered_again(tmp_path):
    run_system(ShortSequence([0, 1]), config(), tmp_path)
    loom.reconstruction.make_fragments(ShortSequence([0, 1, 2]), config(), tmp_path)
    with pytest.raises(FileError, match="recreated after their registration"):
        loom.reconstruction.integrate_scene(ShortSequence([0, 1, 2]), config(), tmp_path)


def test_parts_that_cannot_be_joined_are_listed(tmp_path):
    report = run_system(ShortSequence([0, 1, 2, 3, 40, 41]), config(), tmp_path)
    assert report.used == 4
    (lost,) = report.lost
    assert (lost.first, lost.last, lost.count, lost.stage) == ("frame-4", "frame-5", 2, "register_fragments")
    assert "2 of 6 frames are not in the model" in str(report.warnings)
    assert [fragment.placed for fragment in report.fragments] == [True, False]


@pytest.mark.slow
def test_overlapping_parts_are_joined_without_odometry(tmp_path):
    sequence = ShortSequence([0, 1, 2, 40, 41, 42, 2, 1, 0], width=160)
    report = run_system(sequence, config(), tmp_path)
    assert [fragment.placed for fragment in report.fragments] == [True, False, True]
    assert [fragment.joined for fragment in report.fragments] == [False, False, False]
    assert report.trajectory_error["rmse"] < 0.01


def test_one_frame_is_a_model(tmp_path):
    report = run_system(ShortSequence([0]), config(), tmp_path)
    assert (report.used, report.reliable) == (1, True)
    assert report.mesh["vertices"] > 1000


def test_blank_frames_leave_no_model_and_are_reported(tmp_path):
    report = run_system(ShortSequence([0, 1], changed={i: blank(frame_at(i)) for i in (0, 1)}), config(), tmp_path)
    assert (report.used, report.files, report.mesh) == (0, (), None)
    assert report.lost[0].count == 2
    assert "frames overlap" in str(report.warnings)


class Stream:
    depth_scale = 1000.0

    def __init__(self, sequence):
        self.intrinsic, self.frames = sequence.intrinsic, [sequence.read(i) for i in range(len(sequence))]

    def __iter__(self):
        while self.frames:
            frame = self.frames.pop(0)
            yield Frame(frame.depth, frame.color, None, frame.name)


def test_a_stream_is_recorded_and_then_read_as_often_as_needed(tmp_path):
    sequence = ShortSequence(range(4))
    report = run_system(Stream(sequence), config(), tmp_path)
    assert (report.used, report.trajectory_error) == (4, None)
    assert len(loom.open_frames(tmp_path / "frames")) == 4
    again = run_system(Stream(ShortSequence([])), config(), tmp_path, resume=True)
    assert again.resumed == 1
    with pytest.raises(FileError, match="frames"):
        run_system(Stream(sequence), config(), tmp_path)


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
    run_system(sequence, config(n_frames_per_fragment=4), tmp_path)
    assert len(alive_counts) == 24  # twice for fragments, once for the scene
    assert max(alive_counts) <= 6  # frames that are decoded ahead
