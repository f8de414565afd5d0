"""fuse, track, texture and reconstruct: outputs, reports, and unreliable results."""

import json
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.frame_check import FrameCheck
from pointloom.cameras.trajectory import read_trajectory
from pointloom.cli.jobs import texture as texture_job
from pointloom.cli.jobs.frame_folder import FolderOptions
from pointloom.cli.jobs.fuse import fuse_folder
from pointloom.cli.jobs.model_outputs import ModelOutputs
from pointloom.cli.jobs.reconstruct import reconstruct_folder
from pointloom.cli.jobs.track import track_folder
from pointloom.core.errors import FileError
from pointloom.core.wording import json_text
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.io.frames.datasets import open_dataset
from pointloom.io.images.image_files import read_color, read_depth, write_png
from pointloom.meshing.color_map import optimizers, texturing
from pointloom.meshing.mesh.mesh_files import read_triangle_mesh
from pointloom.rgbd.fusion.refine import PoseRefinement
from pointloom.rgbd.slam import dense_slam, looped_model, tracking
from pointloom.rgbd.slam.fixed_parts import FixedParts
from pointloom.rgbd.slam.results import TrackingResult
from pointloom.rgbd.slam.stream_check import StreamCheck
from pointloom.visualization.render.frame_views import level_up, view_scene

from ..rgbd.fusion.walls import Wall
from ..scan_cases import on_sets
from .commands import answer, names_in, output_of, refusal, run, unreliable


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """12 small frames of the room in the layout of 7-Scenes."""
    folder = tmp_path_factory.mktemp("frames") / "room"
    write_room_sequence(folder, frame_count=12, width=160, height=120)
    return folder


class Still(Wall):
    """Frames of a wall with the attributes of a folder of frames."""

    layout, left_out = "made up", ()
    intrinsic_source, warnings = "made up", ()


@pytest.mark.slow
def test_a_folder_becomes_a_mesh_and_a_picture(device, folder, tmp_path):
    outputs = ModelOutputs(tmp_path / "mesh.ply", picture=tmp_path / "mesh.png")
    report = fuse_folder(folder, outputs, voxel_size=0.05, device=device).to_dict()
    assert (report["reliable"], report["layout"], report["frames"]) == (True, "7scenes", 12)
    assert report["triangles"] > 1000
    assert report["files"] == [str(tmp_path / "mesh.ply"), str(tmp_path / "mesh.png")]
    assert names_in(tmp_path) == ["mesh.ply", "mesh.png"]
    assert list(report["seconds"]) == ["open", "read", "integrate", "extract", "check", "write"]
    json.dumps(report, allow_nan=False)


@pytest.mark.parametrize("depth_max", [0.05, 0.3])
def test_frames_beyond_depth_max_are_unreliable(folder, tmp_path, depth_max):
    report = fuse_folder(folder, ModelOutputs(tmp_path / "mesh.ply"), voxel_size=0.02, depth_max=depth_max).to_dict()
    assert "depth_max" in str(report["warnings"]) and report["files"] == [] == names_in(tmp_path)


def test_outputs_are_checked_before_the_frames_are_read(tmp_path):
    (tmp_path / "there.ply").write_bytes(b"kept")
    for output, picture in (("there.ply", None), ("mesh.txt", None), ("no/mesh.ply", None), ("mesh.ply", "mesh.jpg")):
        with pytest.raises(FileError, match=r"there\.ply|mesh\.txt|no/mesh\.ply|mesh\.jpg"):
            fuse_folder(tmp_path / "missing", ModelOutputs(tmp_path / output, picture=picture))
    assert (tmp_path / "there.ply").read_bytes() == b"kept"


def test_the_kitchen_becomes_a_mesh(device, real_file, tmp_path):
    kitchen, options = real_file("rgbd-7scenes-redkitchen"), FolderOptions(every=50)
    outputs = ModelOutputs(tmp_path / "kitchen.ply")
    report = fuse_folder(kitchen, outputs, options=options, voxel_size=0.04, device=device).to_dict()
    assert (report["reliable"], report["frames"]) == (True, 6)
    assert report["used_fraction"] > 0.8 and report["triangles"] > 10_000
    assert (np.array(report["bounds"]["min"]) > [-3, -2, 0]).all()
    assert (np.array(report["bounds"]["max"]) < [2, 2, 4.5]).all()


def test_the_up_axis_is_estimated_from_a_floor(rng):
    tilt = np.radians(20)
    up = np.array([0, np.cos(tilt), np.sin(tilt)])
    floor = up + rng.normal(0, 0.02, (500, 3))
    wall = np.array([0, -np.sin(tilt), np.cos(tilt)]) + rng.normal(0, 0.02, (1500, 3))
    normals = np.concatenate([floor, wall])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert np.degrees(np.arccos(level_up(normals, np.array([0, 1.0, 0])) @ up)) < 1


def test_without_level_surfaces_the_initial_up_axis_is_used(rng):
    guess = np.array([0, 1.0, 0])
    np.testing.assert_array_equal(level_up(np.tile([0, 0, 1.0], (100, 1)), guess), guess)
    np.testing.assert_array_equal(level_up(np.empty((0, 3)), guess), guess)


DOWN = [[1, 0, 0], [0, 0, 1], [0, -1, 0]]
CAMERAS = {"ahead": (np.eye(3), np.eye(3)), "all round": (np.eye(3), np.diag([-1, 1, -1])), "down": (DOWN, DOWN)}
CAMERAS |= {"upside down": (np.eye(3), np.diag([-1, -1, 1]))}


@pytest.mark.parametrize("rotations", CAMERAS.values(), ids=CAMERAS)
def test_a_view_shows_the_complete_scene_for_any_camera_poses(rotations):
    mesh, poses = loom.rgbd.fuse(Wall(), voxel_size=0.05).mesh, np.tile(np.eye(4), (2, 1, 1))
    poses[:, :3, :3] = rotations
    view = view_scene(mesh, poses, width=160, height=120)
    T = np.linalg.inv(view.T_world_camera)
    local = mesh.vertices @ T[:3, :3].T + T[:3, 3]
    pixels = local @ view.intrinsic.matrix.T
    pixels = pixels[:, :2] / pixels[:, 2:]
    assert (local[:, 2] > 0).all() and ((pixels >= -0.5) & (pixels <= [159.5, 119.5])).all()


def test_frames_without_depth_are_unreliable_and_the_warning_names_the_depth_maps(tmp_path, monkeypatch):
    monkeypatch.setattr("pointloom.cli.jobs.frame_folder.open_frames", lambda *_, **__: Still(depth=0))
    report = fuse_folder(tmp_path, ModelOutputs(tmp_path / "mesh.ply"), voxel_size=0.05).to_dict()
    assert "; ".join(report["warnings"]).startswith("only 0.0% of the pixels have a depth; check the depth maps")
    assert report["files"] == [] and not (tmp_path / "mesh.ply").exists()


COARSE = ["--voxel", 0.05]


def true_poses(folder: Path) -> np.ndarray:
    return np.array([np.loadtxt(path) for path in sorted(folder.glob("*.pose.txt"))])


def shift_poses(folder: Path, shifts) -> None:
    for path, shift in zip(sorted(folder.glob("*.pose.txt")), shifts, strict=True):
        T = np.loadtxt(path)
        T[:3, 3] += shift
        np.savetxt(path, T, fmt="%.17g")


@pytest.mark.slow
def test_inaccurate_poses_are_corrected(sequence_folder, tmp_path, rng, device):
    truth = true_poses(sequence_folder)
    shift_poses(sequence_folder, np.vstack([np.zeros(3), rng.normal(0, 0.015, (7, 3))]))
    given = np.linalg.norm(true_poses(sequence_folder)[1:, :3, 3] - truth[1:, :3, 3], axis=1)
    words = ["--refine", "--trajectory", tmp_path / "poses.log", "--device", device]
    report = answer("fuse", sequence_folder, "-o", tmp_path / "mesh.ply", "--voxel", 0.03, *words)
    refined = np.linalg.norm(read_trajectory(tmp_path / "poses.log").poses[:, :3, 3] - truth[:, :3, 3], axis=1)
    assert refined[0] == 0 and np.median(refined[1:]) < 0.3 * np.median(given)
    figures = report["refinement"]
    assert (figures["refined"], figures["kept"]) == (7, [])
    assert figures["moved_m"] == pytest.approx(np.median(given), rel=0.5)
    assert report["files"] == [str(tmp_path / "mesh.ply"), str(tmp_path / "poses.log")]


@pytest.mark.slow
def test_a_pose_that_does_not_fit_is_left_unchanged_and_counted(sequence_folder, tmp_path):
    shift_poses(sequence_folder, [[0, 0, 1.5] if i == 4 else [0, 0, 0] for i in range(8)])
    given = true_poses(sequence_folder)
    words = ["--refine", "--trajectory", tmp_path / "poses.txt"]
    report = answer("fuse", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE, *words)
    assert [entry["frame"] for entry in report["refinement"]["kept"]] == [4]
    np.testing.assert_allclose(read_trajectory(tmp_path / "poses.txt").poses[4], given[4], atol=1e-9)
    result = run("fuse", sequence_folder, "-o", tmp_path / "again.ply", *COARSE, "--refine", "--every", 2)
    assert result.exit_code == 0 and "2 refined, by " in result.stdout and "1 unchanged: frame " in result.stdout


def test_poses_that_all_disagree_are_unreliable(sequence_folder, tmp_path):
    shift_poses(sequence_folder, [[0, 0, 2.0 * i] for i in range(8)])
    report = unreliable("fuse", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE, "--refine")
    assert "7 of 8 poses could not be refined" in str(report["warnings"]) and report["triangles"] > 0


def test_without_refine_poses_are_unchanged_and_missing_poses_are_an_error(sequence_folder, tmp_path):
    words = ["-o", tmp_path / "mesh.ply", "--trajectory", tmp_path / "poses.log"]
    assert answer("fuse", sequence_folder, *COARSE, *words)["refinement"] is None
    np.testing.assert_array_equal(read_trajectory(tmp_path / "poses.log").poses, true_poses(sequence_folder))
    for path in sequence_folder.glob("*.pose.txt"):
        path.unlink()
    assert "pointloom reconstruct" in refusal("fuse", sequence_folder, "-o", tmp_path / "a.ply", *COARSE)


@pytest.mark.parametrize(("unchanged", "is_unreliable"), [(0, False), (5, False), (6, True), (9, True)])
def test_more_than_half_of_the_poses_unchanged_is_unreliable(unchanged, is_unreliable):
    refined = (0.0,) * (10 - unchanged)
    refinement = PoseRefinement({i + 1: "r" for i in range(unchanged)}, refined, refined)
    assert refinement.frame_count == 11 and (not refinement.reliable) == is_unreliable


class Guided:
    """A tracker that returns the true poses with given statuses; only the command is tested."""

    def __init__(self, fates: dict[int, str] | None = None):
        self.fates, self.seen, self.folded = fates or {}, 0, []
        self.results, self.joins, self.stream, self.fixed_parts = [], [], StreamCheck(), FixedParts()
        self.images = FrameCheck(loom.PinholeCameraIntrinsic.prime_sense_default(), 1000.0)

    def join_maps(self):
        return []

    def check_camera(self):
        return None

    def step(self, frame):
        self.results.append(self.judge(frame))

    def judge(self, frame):
        number = self.seen
        self.seen += 1
        fate = self.fates.get(number, "tracked")
        if not (np.asarray(frame.depth) > 0).any():
            fate = "lost"
        if fate == "lost":
            return TrackingResult(None, fate, ("no depth in reach",))
        if fate == "tracked":
            self.folded.append(frame.name)
        pose = np.linalg.inv(self.start(frame)) @ frame.T_world_camera
        return TrackingResult(pose, fate, inlier_rmse=0.002, fitness=0.9, iterations=int(number > 0))

    def start(self, frame):
        if not hasattr(self, "first"):
            self.first = frame.T_world_camera
        return self.first


@pytest.fixture
def guided(monkeypatch):
    """Make trackers that return the true poses, with the statuses of some frames."""

    def use(fates=None):
        tracker = Guided(fates)
        monkeypatch.setattr(tracking, "make_slam", lambda *_, **__: tracker)
        return tracker

    use()
    return use


def test_track_writes_the_trajectory_and_its_errors(guided, frames, tmp_path):
    tracker = guided()
    report = answer("track", frames, "-o", tmp_path / "poses.log")
    trajectory = read_trajectory(tmp_path / "poses.log")
    truth = true_poses(frames)
    np.testing.assert_allclose(trajectory.poses, np.linalg.inv(truth[0]) @ truth, atol=1e-12)
    assert trajectory.ids[:, 0].tolist() == [0, 1, 2, 3, 4, 5]
    assert (report["frames"], report["tracked"], report["lost"], report["uncertain"]) == (6, 6, [], [])
    assert report["errors"]["absolute"]["m"]["rmse"] < 1e-9 and report["files"] == [str(tmp_path / "poses.log")]
    assert tracker.folded == [f"frame-{i:06d}" for i in range(6)]


def test_a_lost_frame_has_no_pose_and_is_reported(guided, frames, tmp_path):
    tracker = guided({2: "lost", 3: "lost", 5: "uncertain"})
    report = unreliable("track", frames, "-o", tmp_path / "poses.log")
    assert [entry["frame"] for entry in report["lost"]] == [2, 3] and report["uncertain"] == [5]
    assert "2 of 6 frames were lost (frame 2-3) and are left out: no depth in reach" in str(report["warnings"])
    trajectory = read_trajectory(tmp_path / "poses.log")
    assert trajectory.ids[:, 0].tolist() == [0, 1, 4, 5] and report["errors"]["compared"] == 4
    assert report["errors"]["absolute"]["m"]["rmse"] < 1e-9  # each pose is compared with its own ground truth
    assert "frame-000002" not in tracker.folded
    guided({2: "lost", 3: "lost", 5: "uncertain"})
    result = run("track", frames, "-o", tmp_path / "again.txt")
    assert result.exit_code == 3
    for part in ("ATE", "RPE", "frames/s", "off the model", "lost       2: frame 2-3", "uncertain  1: frame 5"):
        assert part in result.stdout


def test_broken_and_missing_pictures_are_left_out_and_named(guided, frames, tmp_path):
    path = frames / "frame-000003.depth.png"
    path.write_bytes(path.read_bytes()[:-200])
    report = unreliable("track", frames, "-o", tmp_path / "poses.log")
    assert [entry["frame"] for entry in report["unreadable"]] == [3]
    assert "1 of 6 frames cannot be read and are left out: " in str(report["warnings"])
    assert "frame-000003.depth.png (byte" in str(report["warnings"])
    assert read_trajectory(tmp_path / "poses.log").ids[:, 0].tolist() == [0, 1, 2, 4, 5]
    guided()
    (frames / "frame-000004.color.png").unlink()
    report = unreliable("track", frames, "-o", tmp_path / "poses.txt")
    assert report["frames"] == 5
    assert "1 of 6 frames lack an image and are left out, the first frame-000004.color.png" in str(report["warnings"])


def test_frames_beyond_depth_max_and_without_any_depth_are_unreliable(guided, frames, tmp_path):
    report = unreliable("track", frames, "-o", tmp_path / "poses.txt", "--depth-max", "0.1")
    assert "raise depth_max" in str(report["warnings"])
    for path in frames.glob("*.depth.png"):
        write_png(path, np.zeros_like(read_depth(path)))
    report = unreliable("track", frames, "-o", tmp_path / "other.txt")
    assert (report["tracked"], report["files"], report["errors"]) == (0, [], None)
    assert "other.txt" not in names_in(tmp_path)


def test_track_rejects_invalid_calls_first(guided, frames, tmp_path):
    poses = tmp_path / "poses.txt"
    assert "poses are not written to .ply" in refusal("track", frames, "-o", tmp_path / "a.ply")
    assert "does not exist" in refusal("track", tmp_path / "none", "-o", poses)
    assert "Make the folder first" in refusal("track", frames, "-o", tmp_path / "no" / "a.txt")
    poses.write_text("kept")
    assert "Give another name, or --force" in refusal("track", frames, "-o", poses) and poses.read_text() == "kept"
    assert answer("track", frames, "-o", poses, "--force")["tracked"] == 6
    assert "expected at least two frames, got one" in refusal("track", frames, "-o", poses, "--force", "--every", 10)
    for path in frames.glob("*.png"):
        path.write_bytes(path.read_bytes()[:-200])
    assert "frame-000000.depth.png (byte" in refusal("track", frames, "-o", tmp_path / "b.txt")
    assert names_in(tmp_path) == ["frames", "poses.txt"]


def test_a_camera_of_another_size_is_an_error_that_names_the_option(guided, frames, tmp_path):
    camera = tmp_path / "camera.json"
    content = json.loads((frames / "camera-intrinsics.json").read_text())
    camera.write_text(json.dumps(content | {"width": 640, "height": 480}))
    message = refusal("track", frames, "-o", tmp_path / "a.txt", "--intrinsic", camera)
    assert "is 160 x 120, but the intrinsic given is for 640 x 480" in message
    assert "Give --intrinsic of these images" in message


@pytest.fixture(scope="module")
def scan(folder):
    """A folder of the frames, in `room`, and their mesh without colors."""
    fused = loom.rgbd.fuse(open_dataset(folder), voxel_size=0.06).mesh
    bare = loom.TriangleMesh(fused.vertices, fused.triangles)
    loom.write_triangle_mesh(folder.parent / "bare.ply", bare)
    side = int(np.ceil(np.sqrt(len(bare))))  # a trivial atlas: a small square for each triangle
    row, column = np.divmod(np.arange(len(bare))[:, None], side)
    uvs = (np.stack([column, row], axis=2) + np.array([[0.1, 0.1], [0.9, 0.1], [0.1, 0.9]])) / side
    bare.triangle_uvs, bare.textures = uvs.reshape(-1, 2), [np.zeros((4, 4, 3), np.uint8)]
    loom.write_triangle_mesh(folder.parent / "mapped.obj", bare)
    return folder.parent


@pytest.mark.slow
def test_vertices_take_the_colors_of_the_frames(scan, tmp_path):
    report = answer("texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--device", "cpu")
    assert report["command"] == "texture" and report["method"] == "rigid" and report["frames"] == 12
    assert report["seen_fraction"] > 0.5 and report["residual"] < report["residual_before"]
    assert report["size"] is None and report["reliable"]
    mesh = loom.read_triangle_mesh(tmp_path / "out.ply")
    assert len(mesh) == report["triangles"] and np.ptp(mesh.vertex_colors) > 0.5
    bare, frames = loom.read_triangle_mesh(scan / "bare.ply", device="cpu"), loom.open_dataset(scan / "room")
    result = loom.meshing.texture_mesh(bare, frames)  # the same call in Python
    loom.write_triangle_mesh(tmp_path / "called.ply", result.mesh)
    assert (tmp_path / "called.ply").read_bytes() == (tmp_path / "out.ply").read_bytes()
    figures = json.loads(json_text(result.to_dict()))
    assert figures == {key: report[key] for key in figures}


@pytest.mark.slow
def test_a_texture_is_filled_if_the_mesh_has_texture_coordinates(scan, tmp_path):
    words = ["texture", scan / "mapped.obj", scan / "room", "-o", tmp_path / "out.glb", "--size", "256"]
    report = answer(*words, "--method", "non-rigid", "--every", "2", "--device", "cpu")
    assert report["size"] == 256 and report["texel_fraction"] > 0.3
    mesh = loom.read_triangle_mesh(tmp_path / "out.glb")
    assert mesh.textures[0].shape == (256, 256, 3) and mesh.textures[0].std() > 10 and mesh.vertex_colors is None


def test_poses_are_unchanged_without_a_method(scan, tmp_path):
    words = ["texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--method", "none"]
    report = answer(*words, "--every", "2", "--picture", tmp_path / "out.png")
    assert report["turned"] == pytest.approx(0, abs=1e-5) and report["moved"] < 1e-12 and report["frames"] == 6
    assert report["residual"] == report["residual_before"] and read_color(tmp_path / "out.png").shape == (960, 1280, 3)
    assert names_in(tmp_path) == ["out.ply", "out.png"]


def test_the_summary_matches_the_library(scan, tmp_path):
    shown = output_of("texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--every", "2")
    for word in ("of the vertices", "residual", "moved", "out.ply"):
        assert word in shown
    bare, frames = loom.read_triangle_mesh(scan / "bare.ply"), loom.open_dataset(scan / "room", every=2)
    assert "\n".join(shown.splitlines()[1:-4]) == str(loom.meshing.texture_mesh(bare, frames))


@pytest.mark.slow
@pytest.mark.parametrize("step", ["_paint_atlas", "write_triangle_mesh"])
def test_an_interrupted_texture_continues_and_leaves_only_the_output(scan, tmp_path, monkeypatch, step):
    words = ["texture", scan / "mapped.obj", scan / "room", "--size", "64", "--every", "2", "--device", "cpu"]
    answer(*words, "-o", tmp_path / "whole.glb")

    def interrupted(*_, **__):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(texturing if step == "_paint_atlas" else texture_job, step, interrupted)
        stopped = run(*words, "-o", tmp_path / "out.glb")
    assert stopped.exit_code == 130 and names_in(tmp_path) == ["out-texture", "whole.glb"]
    first, last = (line for line in stopped.stderr.splitlines() if "out-texture" in line)
    assert first.startswith("intermediate files: ") and "finished work is kept in " in last
    optimized = []
    monkeypatch.setattr(optimizers, "_optimize", lambda *_: optimized.append(1))  # would fail
    answer(*words, "-o", tmp_path / "out.glb")
    assert names_in(tmp_path) == ["out.glb", "whole.glb"] and not optimized
    assert (tmp_path / "out.glb").read_bytes() == (tmp_path / "whole.glb").read_bytes()


def test_frames_that_do_not_show_the_mesh_or_little_of_it_are_unreliable(scan, tmp_path):
    mesh = loom.read_triangle_mesh(scan / "bare.ply")
    loom.write_triangle_mesh(tmp_path / "far.ply", loom.TriangleMesh(mesh.vertices + 100.0, mesh.triangles))
    report = unreliable("texture", tmp_path / "far.ply", scan / "room", "-o", tmp_path / "out.ply")
    assert "no frame shows the mesh" in str(report["warnings"]) and report["files"] == []
    assert names_in(tmp_path) == ["far.ply"]
    words = ["texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--every", "12"]
    report = unreliable(*words, "--depth-max", "2")
    assert "only" in str(report["warnings"]) and "of the vertices" in str(report["warnings"])
    assert (tmp_path / "out.ply").exists()


def test_invalid_input_is_an_error_that_names_it(scan, tmp_path):
    out = tmp_path / "out.ply"
    assert "not written to .stl" in refusal("texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.stl")
    assert "no.ply" in refusal("texture", tmp_path / "no.ply", scan / "room", "-o", out)
    vertices = loom.read_triangle_mesh(scan / "bare.ply").vertices
    loom.write_triangle_mesh(tmp_path / "points.off", loom.TriangleMesh(vertices))
    assert "contains no faces" in refusal("texture", tmp_path / "points.off", scan / "room", "-o", out)
    out.write_bytes(b"old")
    assert "exists" in refusal("texture", scan / "bare.ply", scan / "room", "-o", out) and out.read_bytes() == b"old"
    write_room_sequence(tmp_path / "gray", frame_count=2, width=64, height=48)
    for path in (tmp_path / "gray").glob("*.color.png"):
        path.unlink()
    assert "frames without" in refusal("texture", scan / "bare.ply", tmp_path / "gray", "-o", tmp_path / "a.ply")


def test_images_of_a_model_give_a_texture(tmp_path):
    from ..meshing.image_scenes import CAMERA, wall_scene

    scene = wall_scene((0.8, 1.1, 1.0))
    loom.write_triangle_mesh(tmp_path / "wall.ply", scene.mesh)
    names = [f"{k}.png" for k in range(3)]
    model = loom.SfmModel(names, [loom.CameraModel.from_intrinsic(CAMERA)] * 3, np.array(scene.extrinsics))
    for sparse, images in (("project/sparse/0", "project/images"), ("work/mesh/sparse", "work/undistorted/images")):
        (tmp_path / images).mkdir(parents=True)
        (tmp_path / sparse).parent.mkdir(parents=True, exist_ok=True)
        for name, picture in zip(names, scene.images, strict=True):
            write_png(tmp_path / images / name, picture)
        loom.write_colmap_model(tmp_path / sparse, model)
    words = ["texture", tmp_path / "wall.ply"]
    report = answer(*words, tmp_path / "project", "-o", tmp_path / "a.glb", "--size", "256", "--device", "cpu")
    assert report["layout"] == "model" and report["images"] == 3 and report["size"] == 256
    assert report["reliable"] and report["seen"] > 0.3 * report["triangles"]
    assert answer(*words, tmp_path / "work", "-o", tmp_path / "b.glb", "--size", "256", "--device", "cpu")["files"]
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes()
    assert loom.read_triangle_mesh(tmp_path / "a.glb").textures[0].shape == (256, 256, 3)
    assert not list(tmp_path.glob("*-texture"))
    refused = run(*words, tmp_path / "project", "-o", tmp_path / "c.glb", "--method", "rigid")
    assert refused.exit_code == 2 and "--method is for RGB-D frames" in refused.stderr


def cover(folder: Path, *numbers: int) -> None:
    """Set the depth of frames to zero, as if the lens was covered."""
    for number in numbers:
        path = folder / f"frame-{number:06d}.depth.png"
        write_png(path, np.zeros_like(read_depth(path)))


@pytest.mark.slow
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


@pytest.mark.slow
def test_a_short_blank_gap_is_a_note(sequence_folder, tmp_path):
    cover(sequence_folder, 5, 6)
    shown = output_of("reconstruct", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE)
    assert re.search(r"lost +2: frame 5-6", shown)
    assert re.search(r"note +2 frames are blank and were left out \(frame 5-6\)", shown)


class Closure:
    """A synthetic result of `close_loops`: each loop lifts the last submap by 6 cm."""

    refused, loops, graph_warnings = (), (), ()

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
    tracked, rebuilt = SimpleNamespace(frame_count=1), SimpleNamespace(frame_count=2)
    slam = SimpleNamespace(volume=tracked)

    def close_loops(progress):
        slam.volume = rebuilt
        return SimpleNamespace(T_world_submap=[0], refused=[], loops=[], graph_warnings=("not converged",))

    slam.close_loops = close_loops
    volume, account = looped_model._close_loops(slam, None, None)
    assert volume == tracked and account.loop_warnings == ("not converged",)


@pytest.mark.slow
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
    shown = output_of(*words, "-o", tmp_path / "again.ply", "--slac", "--resume")
    assert f"mm apart on {report['slac']['used']} of {report['edges']} overlaps, " in shown
    assert (tmp_path / "again.ply").read_bytes() == (tmp_path / "bent.ply").read_bytes()


@pytest.mark.slow
def test_an_earlier_run_is_resumed_or_replaced_only_on_request(sequence_folder, tmp_path, small_fragments):
    words = ["reconstruct", sequence_folder, *small_fragments, "--work", tmp_path / "work"]
    (tmp_path / "work" / "fragments").mkdir(parents=True)  # as an immediately interrupted run leaves it
    answer(*words, "-o", tmp_path / "a.ply")
    message = refusal(*words, "-o", tmp_path / "b.ply")
    assert "contains an earlier run. Give --resume to continue it, --force to start over" in message
    assert answer(*words, "-o", tmp_path / "b.ply", "--resume")["resumed"]["fragments"] == 2
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()
    assert answer(*words, "-o", tmp_path / "b.ply", "--force")["resumed"]["fragments"] == 0
    result = run(*words, "-o", tmp_path / "c.ply", "--resume")
    assert "2 of 2 joined, 0 loops; 2 reused from an earlier run" in result.stdout


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
    assert result.exit_code == (3 if report["lost"] or not words else 0) and report["tracked"] >= tracked
    assert report["triangles"] > 3000


@pytest.mark.parametrize("command", ["track", "reconstruct"])
def test_an_interruption_leaves_nothing(sequence_folder, tmp_path, command):
    def interrupt(stage, done, total):
        if done == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        if command == "track":
            track_folder(sequence_folder, tmp_path / "poses.txt", progress=interrupt)
        else:
            reconstruct_folder(sequence_folder, ModelOutputs(tmp_path / "mesh.ply"), progress=interrupt)
    assert names_in(tmp_path) == ["walk"]


@pytest.mark.parametrize("command", ["fuse", "reconstruct"])
def test_the_up_axis_of_a_model_can_be_given(sequence_folder, tmp_path, command):
    ups = {}
    for up in ("y", "z", None):
        words = [command, sequence_folder, "-o", tmp_path / f"{up}.glb", "--every", 4, "--voxel", 0.06]
        answer(*words, *([] if up is None else ["--up", up]))
        ups[up] = loom.read_triangle_mesh(tmp_path / f"{up}.glb").up
    assert ups["y"] == (0.0, 1.0, 0.0) and ups["z"] == (0.0, 0.0, 1.0) and ups[None] is not None
    refused = run(command, sequence_folder, "-o", tmp_path / "a.ply", "--up", "z")
    assert refused.exit_code == 2 and "--up z requires a .glb" in refused.stderr
