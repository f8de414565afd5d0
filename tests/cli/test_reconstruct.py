"""reconstruct: a mesh of frames without poses by both methods, and reports of omitted frames."""

import json
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from pointloom.cameras.trajectory import read_trajectory
from pointloom.cli.jobs.model_outputs import ModelOutputs
from pointloom.cli.jobs.reconstruct import StageOptions, reconstruct_folder
from pointloom.io.frames.frames import open_folder
from pointloom.io.pictures.image_files import read_depth, write_png
from pointloom.meshing.mesh.mesh_files import read_triangle_mesh
from pointloom.meshing.volume.surface_weights import min_weight
from pointloom.rgbd.slam import dense_slam, looped_model
from pointloom.rgbd.slam.tracking import make_slam, track_with

from ..scan_cases import on_sets
from .commands import answer, names_in, refusal, run, unreliable

COARSE = ["--voxel", 0.05]


def cover(folder: Path, *numbers: int) -> None:
    """Set the depth of frames to zero, as if the lens was covered."""
    for number in numbers:
        path = folder / f"frame-{number:06d}.depth.png"
        write_png(path, np.zeros_like(read_depth(path)))


def test_frames_become_a_mesh_a_trajectory_and_a_picture(sequence_folder, tmp_path, device):
    mesh, poses, picture = tmp_path / "mesh.ply", tmp_path / "poses.log", tmp_path / "mesh.png"
    words = ["--trajectory", poses, "--picture", picture, "--device", device]
    report = answer("reconstruct", sequence_folder, "-o", mesh, *COARSE, *words)
    assert report["method"] == "slam" and (report["frames"], report["tracked"], report["lost"]) == (8, 8, [])
    assert len(read_triangle_mesh(mesh)) == report["triangles"] > 1000
    assert read_triangle_mesh(mesh).vertex_colors is not None
    assert read_trajectory(poses).ids[:, 0].tolist() == list(range(8))
    assert report["errors"]["absolute"]["m"]["rmse"] < 0.01 and report["files"] == [str(mesh), str(picture), str(poses)]
    assert names_in(tmp_path) == ["mesh.ply", "mesh.png", "poses.log", "walk"]


def test_reconstruct_prints_a_summary(sequence_folder, tmp_path):
    result = run("reconstruct", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE, "--every", 4)
    assert result.exit_code == 0, result.stderr
    for part in ("2 of 2, ", "ATE", "RPE", "loops", "voxels of 50 mm", "mesh.ply"):
        assert part in result.stdout
    assert result.stderr == ""


def test_lost_frames_give_an_unreliable_result_with_a_mesh(sequence_folder, tmp_path):
    cover(sequence_folder, 6, 7)
    report = unreliable("reconstruct", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE)
    assert [entry["frame"] for entry in report["lost"]] == [6, 7]
    assert "2 of 8 frames were lost (frame 6-7) and are left out: " in str(report["warnings"])
    assert len(read_triangle_mesh(tmp_path / "mesh.ply")) > 1000


def test_a_short_blank_gap_is_a_note(sequence_folder, tmp_path):
    cover(sequence_folder, 5, 6)
    result = run("reconstruct", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE)
    assert result.exit_code == 0, result.stderr
    assert re.search(r"lost +2: frame 5-6", result.stdout)
    assert re.search(r"note +2 frames are blank and were left out \(frame 5-6\)", result.stdout)


class Closure:
    """A synthetic result of `close_loops`: each loop lifts the last submap by 6 cm."""

    refused, loops = (), ()

    def __init__(self, submaps, **_):
        self.T_world_submap = np.array([submap.T_world_submap for submap in submaps])
        self.T_world_submap[-1, 2, 3] += 0.06 * len(self.loops)


@pytest.fixture
def made_up(monkeypatch):
    """Submaps of 3 frames, without loops until the fixture is called with some."""
    monkeypatch.setattr(looped_model, "SUBMAP_FRAMES", 3)
    monkeypatch.setattr(dense_slam, "close_loops", Closure)
    return lambda loops: monkeypatch.setattr(Closure, "loops", loops)


@pytest.mark.slow
@pytest.mark.parametrize("colored", [True, False], ids=["with color", "without"])
def test_loops_correct_all_frames_between(sequence_folder, tmp_path, made_up, colored):
    for path in [] if colored else sequence_folder.glob("*.color.png"):
        path.unlink()
    words = ["reconstruct", sequence_folder, *COARSE, "-o"]
    plain = answer(*words, tmp_path / "a.ply", "--trajectory", tmp_path / "a.log")
    made_up([SimpleNamespace(source=1, target=0)])
    report = answer(*words, tmp_path / "b.ply", "--trajectory", tmp_path / "b.log")
    assert (plain["submaps"], plain["loops"], plain["corrected_m"]) == (3, [], 0) and report["loops"] == [[0, 1]]
    lifts = (read_trajectory(tmp_path / "b.log").poses - read_trajectory(tmp_path / "a.log").poses)[:, 2, 3]
    assert lifts[0] == pytest.approx(0, abs=1e-9) and lifts[-1] == pytest.approx(0.06, abs=1e-9)
    assert (np.diff(lifts) >= -1e-9).all() and report["corrected_m"] == pytest.approx(0.06, abs=1e-9)
    meshes = [read_triangle_mesh(tmp_path / name) for name in ("a.ply", "b.ply")]
    assert [mesh.vertex_colors is not None for mesh in meshes] == [colored, colored]
    assert all(len(mesh) > 1000 for mesh in meshes)


def test_without_loops_the_surface_is_not_rebuilt():
    slam = SimpleNamespace(volume="tracked", model=SimpleNamespace(frame_count=1))

    def close_loops(progress):
        slam.volume = "rebuilt"
        return SimpleNamespace(T_world_submap=[0], refused=[], loops=[])

    slam.close_loops = close_loops
    assert looped_model._close_loops(slam, None, None)[0] == "tracked"


@pytest.mark.slow
def test_without_loops_the_surface_is_the_tracked_one(sequence_folder, tmp_path, made_up):
    """It is not rebuilt from the submaps, where frames shared by two submaps would count twice."""
    plain = answer("reconstruct", sequence_folder, "-o", tmp_path / "plain.ply", *COARSE)
    dataset = open_folder(sequence_folder)
    sizes = {"voxel_size": 0.05, "depth_max": 4.0, "device": "cpu"}
    slam = make_slam(dataset, **sizes)
    track_with(slam, dataset, **sizes)
    mesh = slam.extract_triangle_mesh(weight_threshold=min_weight(len(dataset)))
    assert np.array_equal(read_triangle_mesh(tmp_path / "plain.ply").vertices, mesh.vertices) and plain["submaps"] == 3


def test_an_unreadable_frame_does_not_shift_other_poses(sequence_folder, tmp_path, made_up):
    made_up([SimpleNamespace(source=1, target=0)])
    path = sequence_folder / "frame-000002.depth.png"
    path.write_bytes(path.read_bytes()[:-200])
    words = ["-o", tmp_path / "a.ply", "--trajectory", tmp_path / "a.log"]
    report = unreliable("reconstruct", sequence_folder, *COARSE, *words)
    assert [entry["frame"] for entry in report["unreadable"]] == [2]
    assert read_trajectory(tmp_path / "a.log").ids[:, 0].tolist() == [0, 1, 3, 4, 5, 6, 7]
    assert report["corrected_m"] == pytest.approx(0.06, abs=1e-9)


@pytest.fixture
def small_fragments(tmp_path) -> list:
    """Options that split 8 frames into two fragments."""
    path = tmp_path / "system.json"
    path.write_text(json.dumps({"n_frames_per_fragment": 4, "depth_max": 4.0, "voxel_size": 0.1}))
    return ["--method", "fragments", "--config", path, *COARSE]


def test_fragments_become_a_mesh_and_keep_their_stages(sequence_folder, tmp_path, small_fragments):
    mesh, poses = tmp_path / "mesh.stl", tmp_path / "poses.txt"
    report = answer("reconstruct", sequence_folder, "-o", mesh, *small_fragments, "--trajectory", poses)
    assert (report["used"], report["voxel_size"], report["depth_max"]) == (8, 0.05, 4.0)
    assert len(report["fragments"]) == 2 and report["errors"]["absolute"]["m"]["rmse"] < 0.02
    assert mesh.stat().st_size == 84 + 50 * report["triangles"] and len(read_trajectory(poses)) == 8
    assert report["work"] == str(tmp_path / "mesh-fragments") and (tmp_path / "mesh-fragments" / "fragments").is_dir()


@pytest.mark.slow
def test_slac_resumes_the_stages_and_deforms_the_frames(sequence_folder, tmp_path, small_fragments):
    words = ["reconstruct", sequence_folder, *small_fragments, "--work", tmp_path / "work"]
    plain = answer(*words, "-o", tmp_path / "plain.ply")
    report = answer(*words, "-o", tmp_path / "bent.ply", "--slac", "--resume")
    assert (plain["slac"], report["resumed"]["fragments"]) == (None, 2)
    assert report["slac"]["edges"] == report["edges"] >= 1 and report["slac"]["anchors"] > 50
    assert (tmp_path / "plain.ply").read_bytes() != (tmp_path / "bent.ply").read_bytes()
    result = run(*words, "-o", tmp_path / "again.ply", "--slac", "--resume")
    assert result.exit_code == 0
    assert f"mm apart on {report['slac']['used']} of {report['edges']} overlaps, " in result.stdout
    assert (tmp_path / "again.ply").read_bytes() == (tmp_path / "bent.ply").read_bytes()


@pytest.mark.slow
def test_an_earlier_run_is_resumed_or_replaced_only_on_request(sequence_folder, tmp_path, small_fragments):
    words = ["reconstruct", sequence_folder, *small_fragments, "--work", tmp_path / "work"]
    (tmp_path / "work" / "fragments").mkdir(parents=True)  # as an immediately interrupted run leaves it
    answer(*words, "-o", tmp_path / "a.ply")
    message = refusal(*words, "-o", tmp_path / "b.ply")
    assert "contains an earlier run. Give --resume to continue it, --force to start over" in message
    report = answer(*words, "-o", tmp_path / "b.ply", "--resume")
    assert report["resumed"]["fragments"] == 2
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()
    assert answer(*words, "-o", tmp_path / "b.ply", "--force")["resumed"]["fragments"] == 0
    result = run(*words, "-o", tmp_path / "c.ply", "--resume")
    assert "2 of 2 joined, 0 loops; 2 reused from an earlier run" in result.stdout


@pytest.mark.slow
def test_an_interrupted_run_is_resumed(sequence_folder, tmp_path):
    outputs = ModelOutputs(tmp_path / "mesh.ply")

    def interrupt(stage, done, total):
        if stage == "integrate" and done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        stages = StageOptions(work=tmp_path / "work")
        reconstruct_folder(sequence_folder, outputs, stages=stages, voxel_size=0.05, progress=interrupt)
    assert names_in(tmp_path) == ["walk", "work"]
    stages = StageOptions(work=tmp_path / "work", resume=True)
    report = reconstruct_folder(sequence_folder, outputs, stages=stages, voxel_size=0.05).to_dict()
    assert report["resumed"]["fragments"] == 1 and report["files"] == [str(tmp_path / "mesh.ply")]


@pytest.mark.slow
def test_frames_that_are_not_in_the_model_are_reported(sequence_folder, tmp_path, small_fragments):
    cover(sequence_folder, 7)
    report = unreliable("reconstruct", sequence_folder, "-o", tmp_path / "mesh.ply", *small_fragments)
    assert report["used"] == 7 and "1 of 8 frames are not in the model" in str(report["warnings"])
    result = run("reconstruct", sequence_folder, "-o", tmp_path / "b.ply", *small_fragments)
    assert result.exit_code == 3 and "lost       frame-000007: " in result.stdout


def test_reconstruct_rejects_invalid_calls_first(sequence_folder, tmp_path):
    mesh = tmp_path / "mesh.ply"
    assert "meshes are not written to .pcd" in refusal("reconstruct", sequence_folder, "-o", tmp_path / "a.pcd")
    words = ["reconstruct", sequence_folder, "-o", mesh]
    assert "poses are not written to .json" in refusal(*words, "--trajectory", "a.json")
    assert "ends in .png" in refusal(*words, "--picture", tmp_path / "a.jpg")
    assert "does not exist" in refusal("reconstruct", tmp_path / "none", "-o", mesh)
    fragments = [*words, "--method", "fragments"]
    assert "contains files that do not belong to a run" in refusal(*fragments, "--work", sequence_folder)
    assert "Make the folder first" in refusal(*fragments, "--work", tmp_path / "no" / "work")
    assert "none.json" in refusal(*fragments, "--config", tmp_path / "none.json")
    mesh.write_bytes(b"kept")
    assert "Give another name, or --force" in refusal(*words) and mesh.read_bytes() == b"kept"
    assert names_in(tmp_path) == ["mesh.ply", "walk"]


def test_an_interruption_leaves_nothing(sequence_folder, tmp_path):
    def interrupt(stage, done, total):
        if done == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        reconstruct_folder(sequence_folder, ModelOutputs(tmp_path / "mesh.ply"), progress=interrupt)
    assert names_in(tmp_path) == ["walk"]


@on_sets(
    "folder words tracked",
    shipped=[("rgbd-cupoch-redwood5", [], 3)],
    real=[
        ("rgbd-cupoch-redwood5", [], 5),
        pytest.param("rgbd-nvblox-3dmatch/seq-01", [], 3, marks=pytest.mark.slow),  # its other two are far from these
        ("rgbd-slambook-ch7", ["--depth-scale", 5000], 2),
    ],
)
def test_a_few_real_frames_become_a_mesh(scan_file, tmp_path, folder, words, tracked):
    if words:
        K = [525.0, 0, 0, 0, 525.0, 0, 319.5, 239.5, 1]
        camera = tmp_path / "camera.json"
        camera.write_text(json.dumps({"width": 640, "height": 480, "intrinsic_matrix": K}))
        words = [*words, "--intrinsic", camera]
    result = run("reconstruct", scan_file(folder), "-o", tmp_path / "mesh.ply", *words, "--json", "--device", "cpu")
    report = json.loads(result.stdout)
    assert result.exit_code == (3 if report["lost"] else 0) and report["tracked"] >= tracked
    assert report["triangles"] > 3000
