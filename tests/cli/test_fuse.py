"""fuse: outputs, reports and errors, and the view of the picture."""

import json
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.jobs.frame_folder import FolderOptions
from pointloom.cli.jobs.fuse import fuse_folder
from pointloom.cli.jobs.model_outputs import ModelOutputs
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.visualization.render.scene_view import level_up, view_scene

from ..rgbd.fusion.walls import Wall
from .commands import names_in


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


def test_a_folder_becomes_a_mesh_and_a_picture(device, folder, tmp_path):
    outputs = ModelOutputs(tmp_path / "mesh.ply", picture=tmp_path / "mesh.png")
    report = fuse_folder(folder, outputs, voxel_size=0.05, device=device).to_dict()
    assert report["reliable"]
    assert report["layout"] == "7scenes"
    assert report["frames"] == 12
    assert report["triangles"] > 1000
    assert report["files"] == [str(tmp_path / "mesh.ply"), str(tmp_path / "mesh.png")]
    assert names_in(tmp_path) == ["mesh.ply", "mesh.png"]
    assert list(report["seconds"]) == ["open", "read", "integrate", "extract", "check", "write"]
    json.dumps(report, allow_nan=False)


def test_stl_is_written_without_colors(folder, tmp_path):
    report = fuse_folder(folder, ModelOutputs(tmp_path / "mesh.stl"), voxel_size=0.1).to_dict()
    assert (tmp_path / "mesh.stl").stat().st_size == 84 + 50 * report["triangles"]


@pytest.mark.parametrize("depth_max", [0.05, 0.3])
def test_frames_beyond_depth_max_are_unreliable(folder, tmp_path, depth_max):
    report = fuse_folder(folder, ModelOutputs(tmp_path / "mesh.ply"), voxel_size=0.02, depth_max=depth_max).to_dict()
    assert "depth_max" in str(report["warnings"])
    assert report["files"] == [] == names_in(tmp_path)


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
    assert report["reliable"]
    assert report["frames"] == 6
    assert report["used_share"] > 0.8
    assert report["triangles"] > 10_000
    low, high = np.array(report["bounds"]["min"]), np.array(report["bounds"]["max"])
    assert (low > [-3, -2, 0]).all()
    assert (high < [2, 2, 4.5]).all()


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
def test_a_view_shows_the_complete_scene_for_any_camera_poses(way):
    mesh = loom.fuse(Wall(), voxel_size=0.05).mesh
    view = view_scene(mesh, cameras_that_look(way), width=160, height=120)
    T = np.linalg.inv(view.T_world_camera)
    local = mesh.vertices @ T[:3, :3].T + T[:3, 3]
    pixels = local @ view.intrinsic.matrix.T
    pixels = pixels[:, :2] / pixels[:, 2:]
    assert (local[:, 2] > 0).all()
    assert (pixels >= -0.5).all()
    assert (pixels <= [159.5, 119.5]).all()


def test_frames_without_depth_are_unreliable_and_the_warning_names_the_depth_maps(tmp_path, monkeypatch):
    monkeypatch.setattr("pointloom.cli.jobs.frame_folder.open_dataset", lambda *_, **__: Still(depth=0))
    report = fuse_folder(tmp_path, ModelOutputs(tmp_path / "mesh.ply"), voxel_size=0.05).to_dict()
    assert "; ".join(report["warnings"]).startswith("only 0.0% of the pixels have a depth; check the depth maps")
    assert report["files"] == [] and not (tmp_path / "mesh.ply").exists()
