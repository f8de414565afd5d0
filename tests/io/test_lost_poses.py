"""Poses marked as lost by inf or NaN are omitted by name and do not invalidate the other frames."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.io.pictures.image_files import write_png

from . import frame_folders
from .frame_folders import SMALL, depth_map

MARKS = ["-inf", "nan", "-1.#IND", "-nan(ind)"]


def matrix(mark, rows=4):
    row = " ".join([mark] * 4)
    return "\n".join([row] * rows) if mark else "\n".join(" ".join(map(str, r)) for r in np.eye(4)[:rows])


def make(folder, layout, marks):
    """A folder of frames whose poses have these marks, or are valid if the mark is empty."""
    if layout == "pictures":
        folder.mkdir()
    else:
        frame_folders.make(layout, folder, len(marks))
    rows = []
    for i, mark in enumerate(marks):
        if layout == "redwood":
            rows.append(f"{i} {i} {i + 1}\n{matrix(mark)}\n")
        elif layout == "tum":
            rows.append(f"{100 + i / 10} {' '.join([mark] * 7) if mark else '0 0 0 0 0 0 1'}\n")
        else:
            name = f"{i:06d}_pose.txt" if layout == "pictures" else f"frame-{i:06d}.pose.txt"
            (folder / name).write_text(matrix(mark))
        if layout == "pictures":
            write_png(folder / f"{i:06d}_depth.png", depth_map(1500))
    if rows:
        (folder / ("groundtruth.txt" if layout == "tum" else "trajectory.log")).write_text("".join(rows))
    return folder


@pytest.mark.parametrize("layout", ["7scenes", "redwood", "tum", "pictures"])
@pytest.mark.parametrize("lost_value", MARKS)
def test_frames_with_lost_poses_are_left_out_by_name(tmp_path, layout, lost_value):
    folder = make(tmp_path / "set", layout, ["", "", lost_value, ""])
    options, scale = {"intrinsic": SMALL, "layout": layout}, {"depth_scale": 1000.0}
    name = {"redwood": "00002", "tum": "100.2"}.get(layout, "000002")
    frames = loom.open_frames(folder, **options, **scale)
    assert [frame.T_world_camera is None for frame in frames] == [False, False, True, False]
    frames = loom.open_frames(folder, **options, **scale, skip_missing=True)
    assert len(frames) == 3 and len(frames.left_out) == 1 and name in frames.left_out[0]
    assert len(loom.open_frames(folder, **options, **scale, skip_missing="pictures")) == 4
    if layout != "pictures":
        with pytest.raises(loom.FileError, match=r"inf or NaN.*skip_missing=True"):
            loom.open_dataset(folder, **options)
        frames = loom.open_dataset(folder, **options, skip_missing=True)
        assert len(frames) == 3 and name in frames.left_out[0]
        assert loom.fuse(frames, voxel_size=0.1).T_world_camera.shape == (3, 4, 4)


def test_a_folder_of_lost_poses_alone_is_refused(tmp_path):
    folder = make(tmp_path / "set", "7scenes", ["nan", "inf"])
    with pytest.raises(loom.FileError):
        loom.open_dataset(folder, intrinsic=SMALL, skip_missing=True)


def test_the_command_leaves_them_out(tmp_path, capsys):
    folder = make(tmp_path / "set", "7scenes", ["", "-inf", "", ""])
    loom.write_pinhole_camera_intrinsic(tmp_path / "camera.json", SMALL)
    command = ["fuse", str(folder), "-o", str(tmp_path / "a.ply"), "--intrinsic", str(tmp_path / "camera.json")]
    with pytest.raises(SystemExit) as leaving:
        cli(command)
    assert leaving.value.code == 1 and "--skip-missing" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli([*command, "--skip-missing"])
    assert "frame-000001.pose.txt" in capsys.readouterr().out and (tmp_path / "a.ply").exists()


@pytest.mark.parametrize("lost_value", MARKS)
@pytest.mark.parametrize("name", ["path.log", "path.tum", "path.kitti"])
def test_trajectory_omits_lost_poses_on_request(tmp_path, name, lost_value):
    rows = {
        "path.log": lambda i, m: f"{i} {i} {i + 1}\n{matrix(m)}",
        "path.tum": lambda i, m: f"{i}.0 " + (" ".join([m] * 7) if m else "0 0 0 0 0 0 1"),
        "path.kitti": lambda i, m: matrix(m, 3).replace("\n", " "),
    }[name]
    path = tmp_path / name
    path.write_text("\n".join(rows(i, m) for i, m in enumerate(["", lost_value, ""])) + "\n")
    with pytest.raises(loom.FileError, match=r"line \d+.*skip_missing=True"):
        loom.read_trajectory(path)
    result = loom.read_trajectory(path, skip_missing=True)
    numbers = result.timestamps if name == "path.tum" else result.ids[:, 0]
    assert len(result) == 2 and list(numbers) == [0, 2] and np.isfinite(result.poses).all()
    lens = loom.read_cameras(path, pictures=["0.png", "1.png", "2.png"], intrinsic=SMALL)
    assert len(lens) == 2 and lens.left_out == ("1.png: no pose",)
