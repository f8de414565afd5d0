"""Folders of frames with missing poses: nothing is invented, and missing files are named."""

from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.core.errors import DatasetError, FileError
from pointloom.io.frames.datasets import open_dataset, open_frames
from pointloom.io.frames.rgbd_sources import RGBDSource
from pointloom.io.pictures.image_files import write_png

from ..scan_cases import on_sets
from .frame_folders import LAYOUTS, SMALL, depth_map, make, picture, pose, write_listing, write_poses


def without_poses(folder: Path) -> Path:
    for path in [*folder.glob("*.pose.txt"), folder / "trajectory.log", folder / "groundtruth.txt"]:
        path.unlink(missing_ok=True)
    return folder


@pytest.mark.parametrize("layout", LAYOUTS)
def test_each_layout_opens_without_poses(tmp_path, layout):
    folder = without_poses(make(layout, tmp_path / "set"))
    source = open_frames(folder, intrinsic=SMALL)
    assert isinstance(source, RGBDSource) and (source.layout, len(source), source.left_out) == (layout, 3, [])
    assert [frame.T_world_camera for frame in source] == [None] * 3
    assert [frame.color is not None and frame.color[0, 0, 0] < 10 for frame in source] == [True] * 3
    if layout == "tum":
        assert [frame.timestamp for frame in source] == pytest.approx([100.0, 100.1, 100.2]) and source.notes == []
    with pytest.raises(DatasetError):
        open_dataset(folder, layout=layout, intrinsic=SMALL)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_unrequested_poses_are_not_opened(tmp_path, layout):
    folder = make(layout, tmp_path / "set")
    for path in [*folder.glob("*.pose.txt"), folder / "trajectory.log", folder / "groundtruth.txt"]:
        if path.exists():
            path.write_text("no pose\n")
    with pytest.raises(FileError):
        open_frames(folder, intrinsic=SMALL)
    assert len(open_frames(folder, intrinsic=SMALL, poses=False)) == 3


def test_a_single_pose_that_is_missing_is_none(tmp_path):
    folder = make("7scenes", tmp_path / "set")
    (folder / "frame-000001.pose.txt").unlink()
    assert [frame.T_world_camera is None for frame in open_frames(folder, intrinsic=SMALL)] == [False, True, False]
    tum = make("tum", tmp_path / "tum")
    write_poses(tum, [(100.0, 0), (100.2, 2)])
    assert [frame.T_world_camera is None for frame in open_frames(tum, intrinsic=SMALL)] == [False, True, False]


def test_time_jumps_are_reported_by_frame(tmp_path):
    folder = make("tum", tmp_path / "set", 9)
    times = [100 + 0.1 * i for i in range(7)] + [103.0, 103.1]
    for name in ("depth", "rgb"):
        for new, old in zip(times, sorted((folder / name).iterdir()), strict=True):
            old.rename(folder / name / f"{new:.6f}.png")
        write_listing(folder, name, times)
    without_poses(folder)
    notes = open_frames(folder, intrinsic=SMALL).notes
    assert notes == ["103.000000: comes 2.400 s after the frame before it, instead of the usual 0.100 s"]


@pytest.mark.parametrize("missing", ["depth", "color"])
def test_a_picture_missing_in_the_middle_is_named_or_skipped_and_listed(tmp_path, missing):
    folder = without_poses(make("7scenes", tmp_path / "set"))
    (folder / f"frame-000001.{missing}.png").unlink()
    source = open_frames(folder, intrinsic=SMALL, skip_missing=True)
    assert [frame.name for frame in source] == ["frame-000000", "frame-000002"]
    assert len(source.left_out) == 1 and source.left_out[0].startswith(f"frame-000001.{missing}.")


def test_redwood_and_tum_name_or_skip_missing_files(tmp_path):
    redwood = make("redwood", tmp_path / "redwood")
    (redwood / "color" / "00001.jpg").unlink()
    with pytest.raises(DatasetError, match=r"00001\.png"):
        open_frames(redwood, intrinsic=SMALL)
    source = open_frames(redwood, intrinsic=SMALL, skip_missing=True)
    assert [(f.name, f.T_world_camera[0, 3]) for f in source] == [("00000", 0), ("00002", 2)]
    tum = make("tum", tmp_path / "tum")
    (tum / "depth" / "100.100000.png").unlink()
    with pytest.raises(DatasetError, match=r"100\.100000\.png"):
        open_frames(tum, intrinsic=SMALL)
    source = open_frames(tum, intrinsic=SMALL, skip_missing=True)
    assert [f.name for f in source] == ["100.000000", "100.200000"] and source.left_out == ["100.100000.png: missing"]


@pytest.mark.parametrize("layout", LAYOUTS)
def test_folder_without_complete_frames_is_rejected(tmp_path, layout):
    folder = without_poses(make(layout, tmp_path / "set"))
    for path in folder.rglob("*.png"):
        if "depth" in str(path.relative_to(folder)):
            path.unlink()
    with pytest.raises(DatasetError):
        open_frames(folder, layout=layout, intrinsic=SMALL, skip_missing=True)


def test_fusing_frames_without_pose_is_an_error(tmp_path):
    source = open_frames(without_poses(make("7scenes", tmp_path / "set")), intrinsic=SMALL)
    with pytest.raises(ValueError, match="frame frame-000000:"):
        loom.fuse(source)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_color_of_another_size_is_named_or_brought_to_that_of_depth(tmp_path, layout):
    folder = without_poses(make(layout, tmp_path / "set"))
    for path in [*folder.rglob("*.*")]:
        name = str(path.relative_to(folder))
        if path.suffix in (".png", ".jpg") and ("color" in name or "rgb" in name):
            colors = np.repeat(np.repeat(picture(50), 2, axis=0), 2, axis=1)
            path.unlink()
            write_png(path.with_suffix(".png"), colors)
    with pytest.raises(DatasetError, match=r"is 16 x 12, but .* is 8 x 6.*resize_color=True"):
        open_frames(folder, intrinsic=SMALL)
    for frame in open_frames(folder, intrinsic=SMALL, resize_color=True):
        assert frame.color.shape == (6, 8, 3) and (frame.color == 50).all()


@pytest.mark.parametrize("layout", LAYOUTS)
def test_depth_of_8_bits_is_refused_by_name(tmp_path, layout):
    folder = without_poses(make(layout, tmp_path / "set"))
    path = next(p for p in sorted(folder.rglob("*.png")) if "depth" in str(p.relative_to(folder)))
    path.unlink()
    write_png(path, np.full((6, 8), 200, np.uint8))
    with pytest.raises(FileError, match=r"expected a depth map, got a PNG with 1 x 8 bits"):
        open_frames(folder, intrinsic=SMALL)


def make_pictures(folder: Path, names="{}_depth {}") -> Path:
    folder.mkdir()
    for i in (1, 2, 10):
        depth, color = names.format(i, i).split()
        write_png(folder / f"{depth}.png", depth_map(5000 * i))
        write_png(folder / f"{color}.png", picture(i))
    return folder


@pytest.mark.parametrize("names", ["{}_depth {}", "dep_{} img_{}", "depth{} rgb{}", "{}-D-depth {}-D-color"])
def test_pictures_in_one_folder_pair_by_the_rest_of_their_names(tmp_path, names):
    folder = make_pictures(tmp_path / "set", names)
    source = open_frames(folder, intrinsic=SMALL, depth_scale=5000)
    assert (source.layout, source.depth_scale) == ("pictures", 5000)
    frames = [(f.depth[0, 0] / 5000, f.color[0, 0, 0], f.T_world_camera) for f in source]
    assert frames == [(1, 1, None), (2, 2, None), (10, 10, None)]


def test_poses_of_pictures_are_matrices_or_a_line_of_tum(tmp_path):
    folder = make_pictures(tmp_path / "set", "dep_{} img_{}")
    np.savetxt(folder / "pose_1.txt", pose(4))
    (folder / "pose_2.txt").write_text("5 0 0 0 0 0 1\n")
    frames = list(open_frames(folder, intrinsic=SMALL, depth_scale=1000))
    assert [f.T_world_camera is not None and f.T_world_camera[0, 3] for f in frames] == [4, 5, False]
    (folder / "pose_2.txt").write_text("5 0 0 0 0 0 7\n")
    with pytest.raises(FileError, match=r"/pose_2\.txt \(line 1\):"):
        open_frames(folder, intrinsic=SMALL, depth_scale=1000)


def test_parameters_missing_from_the_files_must_be_given(tmp_path):
    folder = make_pictures(tmp_path / "set")
    for given in ({"depth_scale": 5000}, {"intrinsic": SMALL}):
        with pytest.raises(DatasetError, match="/set:"):
            open_frames(folder, **given)
    with pytest.raises(ValueError, match="depth_scale"):
        open_frames(folder, intrinsic=SMALL, depth_scale=0)


def test_pictures_that_do_not_pair_are_refused_by_name(tmp_path):
    folder = make_pictures(tmp_path / "set")
    write_png(folder / "3.png", picture(3))
    with pytest.raises(DatasetError, match=r"3\.png"):
        open_frames(folder, intrinsic=SMALL, depth_scale=5000)
    source = open_frames(folder, intrinsic=SMALL, depth_scale=5000, skip_missing=True)
    assert len(source) == 3 and source.left_out == ["3.png: has no depth map of the same name"]
    write_png(folder / "3_depth.png", depth_map(1))
    write_png(folder / "3-depth.png", depth_map(1))
    with pytest.raises(DatasetError, match=r"/3_depth\.png:"):
        open_frames(folder, intrinsic=SMALL, depth_scale=5000)


def test_parent_and_empty_folders_are_rejected_with_a_hint(tmp_path):
    make_pictures(tmp_path / "set")
    with pytest.raises(DatasetError, match=r"Did you mean .*set\?"):
        open_frames(tmp_path)
    (tmp_path / "nothing").mkdir()
    with pytest.raises(DatasetError, match="/nothing:"):
        open_frames(tmp_path / "nothing")


@on_sets(
    "name layout count posed",
    shipped=[("rgbd-cupoch-redwood5", "redwood", 3, True)],
    real=[
        ("rgbd-cupoch-redwood5", "redwood", 5, True),
        ("rgbd-nvblox-3dmatch/seq-01", "7scenes", 5, True),
        ("rgbd-slambook-ch7", "pictures", 2, False),
        ("rgbd-tum-pairs/case_1", "pictures", 2, True),
        ("rgbd-tum-pairs/case_2", "pictures", 2, True),
    ],
)
def test_small_real_sets_open(scan_file, name, layout, count, posed):
    options = {}
    if layout == "pictures":
        options = {"intrinsic": PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5), "depth_scale": 5000}
    source = open_frames(scan_file(name), **options)
    assert (source.layout, len(source)) == (layout, count)
    for frame in source:
        meters = frame.depth[frame.depth > 0] / source.depth_scale
        assert 0.5 < np.median(meters) < 5
        assert (frame.T_world_camera is not None) == posed and frame.color.shape == (480, 640, 3)
