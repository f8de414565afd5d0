"""Frames to a mesh: accuracy, order, colour, and what makes a result poor."""

import dataclasses
import json
import threading
from pathlib import Path

import numpy as np
import pytest

from pointloom.app.fuse import READ_AHEAD, fuse_dataset, fuse_folder
from pointloom.app.pictures.scene_view import level_up, view_scene
from pointloom.app.room import room_sequence, surface_errors, write_room_sequence
from pointloom.app.surface_weights import WEIGHTS
from pointloom.pcd.camera import PinholeCameraIntrinsic
from pointloom.pcd.errors import FileError
from pointloom.pcd.io.datasets import Frame, open_dataset

VOXEL = 0.05


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """12 small frames of the room, laid out as 7-Scenes."""
    folder = tmp_path_factory.mktemp("frames") / "room"
    write_room_sequence(folder, frame_count=12, width=160, height=120)
    return folder


class Wall:
    """Frames of a flat wall 1 m in front of a camera that stands still."""

    def __init__(self, frame_count=3, *, depth=1000, color=True):
        self.intrinsic, self.depth_scale = PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5), 1000.0
        self.frame_count, self.depth, self.color = frame_count, depth, color
        self.asked = []

    def __len__(self):
        return self.frame_count

    def read(self, index):
        self.asked.append(index)
        color = np.full((24, 32, 3), (255, 128, 0), np.uint8) if self.color else None
        return Frame(np.full((24, 32), self.depth, np.uint16), color, np.eye(4), f"frame-{index}")


class Still(Wall):
    """... as if from a folder."""

    layout, left_out = "made up", ()
    intrinsic_source, intrinsic_doubt = "made up", ""


class Broken(Wall):
    """... whose third frame is as `replace` says."""

    def __init__(self, **replace):
        super().__init__(40)
        self.replace = replace

    def read(self, index):
        frame = super().read(index)
        if index == 2:
            if not self.replace:
                raise FileError("frame-2.png", "damaged")
            return dataclasses.replace(frame, **self.replace)
        return frame


# ------------------------------------------------------------------------------------------------ sequences


def test_exact_frames_of_the_room_fuse_to_its_surface(device):
    frames = room_sequence(24, width=320, height=240, noise=False, device=device)
    mesh = fuse_dataset(frames, voxel_size=VOXEL, device=device, read_ahead=0).mesh
    errors = surface_errors(mesh.vertices, device=device)
    assert np.median(errors) < 0.05 * VOXEL
    assert np.mean(errors < VOXEL / 2) > 0.9


def test_reading_ahead_changes_no_bit(device, folder):
    dataset = open_dataset(folder)
    meshes = [fuse_dataset(dataset, voxel_size=VOXEL, device=device, read_ahead=n).mesh for n in (0, READ_AHEAD)]
    for name in ("vertices", "triangles", "vertex_colors"):
        left, right = (getattr(mesh, name) for mesh in meshes)
        np.testing.assert_array_equal(left, right)
    assert len(meshes[0]) > 1000


def test_the_wall_keeps_its_place_and_its_colour(device):
    mesh = fuse_dataset(Wall(), voxel_size=0.02, device=device).mesh
    np.testing.assert_allclose(mesh.vertices[:, 2], 1.0, atol=1e-4)
    np.testing.assert_allclose(mesh.vertex_colors, np.tile([1, 128 / 255, 0], (len(mesh.vertices), 1)), atol=0.005)


def test_frames_without_colour_give_a_mesh_without():
    result = fuse_dataset(Wall(color=False), voxel_size=0.02)
    assert len(result.mesh) > 0
    assert result.mesh.vertex_colors is None


@pytest.mark.parametrize(("frame_count", "threshold"), [(1, 0), (9, 0), (10, 1), (29, 1), (30, 3)])
def test_the_more_frames_the_more_often_a_voxel_must_be_seen(frame_count, threshold):
    result = fuse_dataset(Wall(frame_count), voxel_size=0.05)
    assert result.weight_threshold == threshold
    assert result.frame_count == frame_count
    assert len(result.mesh) > 0
    assert [frames for frames, _ in WEIGHTS] == sorted((frames for frames, _ in WEIGHTS), reverse=True)


def test_shares_tell_missing_depth_from_depth_out_of_reach():
    far = fuse_dataset(Wall(depth=3000), voxel_size=0.05, depth_max=2.0)
    assert (far.depth_share, far.used_share) == (1.0, 0.0)
    none = fuse_dataset(Wall(depth=0), voxel_size=0.05)
    assert (none.depth_share, none.used_share) == (0.0, 0.0)
    assert len(far.mesh) == len(none.mesh) == 0


def test_progress_counts_every_frame():
    said = []
    fuse_dataset(Wall(4), voxel_size=0.05, progress=lambda *step: said.append(step))
    assert said == [*(("frames", i, 4) for i in range(5)), ("extract", 0, 0)]


@pytest.mark.parametrize("read_ahead", [0, READ_AHEAD])
def test_a_damaged_frame_ends_the_reading(read_ahead):
    source = Broken()
    with pytest.raises(FileError, match=r"frame-2\.png: damaged"):
        fuse_dataset(source, voxel_size=0.05, read_ahead=read_ahead)
    assert max(source.asked) <= 2 + read_ahead
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("pointloom-read")]


@pytest.mark.parametrize(
    ("part", "reason"),
    [
        ({"T_world_camera": np.diag([2.0, 2, 2, 1])}, "rigid"),
        ({"T_world_camera": np.full((4, 4), np.nan)}, "rigid"),
        ({"T_world_camera": np.zeros((4, 4))}, "rigid"),
        ({"depth": np.ones((24, 31), np.uint16)}, "31 x 24"),
        ({"color": np.zeros((12, 16, 3), np.uint8)}, "16 x 12"),
    ],
)
def test_a_frame_that_does_not_fit_is_named(part, reason):
    with pytest.raises(ValueError, match=f"frame frame-2: .*{reason}"):
        fuse_dataset(Broken(**part), voxel_size=0.05)


@pytest.mark.parametrize(
    ("options", "name"),
    [
        ({"voxel_size": 0.0}, "voxel_size"),
        ({"voxel_size": 0.1, "truncation": 0.01}, "truncation"),
        ({"depth_max": -1.0}, "depth_max"),
        ({"read_ahead": -1}, "read_ahead"),
        ({"weight_threshold": -1.0}, "weight_threshold"),
    ],
)
def test_options_out_of_range_are_named(options, name):
    with pytest.raises(ValueError, match=name):
        fuse_dataset(Wall(), **options)


def test_no_frame_is_an_error():
    with pytest.raises(ValueError, match="at least one frame"):
        fuse_dataset(Wall(0))


# ------------------------------------------------------------------------------------------------ folders


def test_a_folder_becomes_a_mesh_and_a_picture(device, folder, tmp_path):
    report = fuse_folder(folder, tmp_path / "mesh.ply", voxel_size=VOXEL, device=device, picture=tmp_path / "mesh.png")
    assert report["poor"] is None
    assert report["layout"] == "7scenes"
    assert report["frames"] == 12
    assert report["triangles"] > 1000
    assert report["files"] == [str(tmp_path / "mesh.ply"), str(tmp_path / "mesh.png")]
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["mesh.ply", "mesh.png"]
    assert list(report["seconds"]) == ["open", "read", "integrate", "extract", "write"]
    json.dumps(report, allow_nan=False)


def test_every_second_frame_is_half_of_them(folder, tmp_path):
    assert fuse_folder(folder, tmp_path / "mesh.ply", voxel_size=0.1, every=2)["frames"] == 6


def test_stl_comes_without_the_colours_that_it_cannot_hold(folder, tmp_path):
    report = fuse_folder(folder, tmp_path / "mesh.stl", voxel_size=0.1)
    assert (tmp_path / "mesh.stl").stat().st_size == 84 + 50 * report["triangles"]


@pytest.mark.parametrize(("depth_max", "remedy"), [(0.05, "--depth-max"), (0.3, "--depth-max")])
def test_frames_out_of_reach_are_a_poor_result(folder, tmp_path, depth_max, remedy):
    report = fuse_folder(folder, tmp_path / "mesh.ply", voxel_size=0.02, depth_max=depth_max)
    assert remedy in report["poor"]
    assert report["files"] == []
    assert list(tmp_path.iterdir()) == []


def test_outputs_are_checked_before_the_frames_are(tmp_path):
    (tmp_path / "there.ply").write_bytes(b"kept")
    for output, picture in (("there.ply", None), ("mesh.txt", None), ("no/mesh.ply", None), ("mesh.ply", "mesh.jpg")):
        with pytest.raises(FileError, match=r"there\.ply|mesh\.txt|no/mesh\.ply|mesh\.jpg"):
            fuse_folder(tmp_path / "missing", tmp_path / output, picture=picture)
    assert (tmp_path / "there.ply").read_bytes() == b"kept"


def test_the_kitchen_becomes_a_mesh(device, data, tmp_path):
    report = fuse_folder(
        data / "rgbd-7scenes-redkitchen", tmp_path / "kitchen.ply", every=50, voxel_size=0.04, device=device
    )
    assert report["poor"] is None
    assert report["frames"] == 6
    assert report["used_share"] > 0.8
    assert report["triangles"] > 10_000
    low, high = np.array(report["bounds"]["min"]), np.array(report["bounds"]["max"])
    assert (low > [-3, -2, 0]).all()
    assert (high < [2, 2, 4.5]).all()


# ------------------------------------------------------------------------------------------------ views


def test_a_floor_tells_what_is_up(rng):
    tilt = np.radians(20)
    up = np.array([0, np.cos(tilt), np.sin(tilt)])
    floor = up + rng.normal(0, 0.02, (500, 3))
    wall = np.array([0, -np.sin(tilt), np.cos(tilt)]) + rng.normal(0, 0.02, (1500, 3))
    normals = np.concatenate([floor, wall])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert np.degrees(np.arccos(level_up(normals, np.array([0, 1.0, 0])) @ up)) < 1


def test_without_level_surfaces_the_guess_stands(rng):
    guess = np.array([0, 1.0, 0])
    np.testing.assert_array_equal(level_up(np.tile([0, 0, 1.0], (100, 1)), guess), guess)
    np.testing.assert_array_equal(level_up(np.empty((0, 3)), guess), guess)


def cameras_that_look(way):
    """Two poses: ahead, all round, straight down, or upside down the second time."""
    T = np.tile(np.eye(4), (2, 1, 1))
    if way == "all round":
        T[1, :3, :3] = np.diag([-1, 1, -1])
    elif way == "down":
        T[:, :3, :3] = [[1, 0, 0], [0, 0, 1], [0, -1, 0]]
    elif way == "upside down":
        T[1, :3, :3] = np.diag([-1, -1, 1])
    return T


@pytest.mark.parametrize("way", ["ahead", "all round", "down", "upside down"])
def test_a_view_shows_the_whole_scene_however_the_cameras_looked(way):
    mesh = fuse_dataset(Wall(), voxel_size=0.05).mesh
    view = view_scene(mesh, cameras_that_look(way), width=160, height=120)
    T = np.linalg.inv(view.T_world_camera)
    local = mesh.vertices @ T[:3, :3].T + T[:3, 3]
    pixels = local @ view.intrinsic.matrix.T
    pixels = pixels[:, :2] / pixels[:, 2:]
    assert (local[:, 2] > 0).all()
    assert (pixels >= -0.5).all()
    assert (pixels <= [159.5, 119.5]).all()


def test_threads_follow_the_chosen_compiler(device):
    """What is read ahead may launch kernels; the caller's choice of compiler holds for them."""
    from pointloom.kernels.lang import current_cpu_compiler

    seen = []

    class Asking(Wall):
        def read(self, index):
            seen.append((threading.current_thread().name.startswith("pointloom-read"), current_cpu_compiler()))
            return super().read(index)

    fuse_dataset(Asking(3), voxel_size=0.05, device=device)
    assert set(seen) == {(True, current_cpu_compiler())}


@pytest.mark.parametrize(("depth_max", "used"), [(0.999, 0.0), (1.0, 1.0), (1.001, 1.0)])
def test_a_depth_at_the_limit_counts_as_used_and_is_fused(depth_max, used):
    result = fuse_dataset(Wall(depth=1000), voxel_size=0.05, depth_max=depth_max)
    assert (result.depth_share, result.used_share) == (1.0, used)
    assert (len(result.mesh) > 0) == bool(used)


def test_frames_without_depth_are_a_poor_result_that_sends_to_the_depth_maps(tmp_path, monkeypatch):
    monkeypatch.setattr("pointloom.app.fuse.open_dataset", lambda *_, **__: Still(depth=0))
    report = fuse_folder(tmp_path, tmp_path / "mesh.ply", voxel_size=0.05)
    assert report["poor"].startswith("only 0.0% of the pixels have a depth; check the depth maps")
    assert report["files"] == [] and not (tmp_path / "mesh.ply").exists()
