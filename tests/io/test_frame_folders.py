"""Folders of RGB-D frames: layouts, pairing, cameras, missing poses and missing files."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsic, write_pinhole_camera_intrinsic
from pointloom.cameras.trajectory import Trajectory, write_trajectory
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import DatasetError, FileError
from pointloom.io.frames.dataset_layouts import associate, list_redwood, list_seven_scenes, list_tum
from pointloom.io.frames.datasets import open_dataset, open_frames
from pointloom.io.frames.frames import source_warnings
from pointloom.io.frames.rgbd_sources import RGBDSource
from pointloom.io.images.image_files import write_png

from ..scan_cases import on_sets

SMALL = PinholeCameraIntrinsic(8, 6, 7.0, 7.0, 3.5, 2.5)
LAYOUTS = ["7scenes", "redwood", "tum"]


def pose(x: float) -> np.ndarray:
    T_world_camera = np.eye(4)
    T_world_camera[0, 3] = x
    return T_world_camera


def depth_map(value: int, shape=(6, 8)) -> np.ndarray:
    return np.full(shape, value, np.uint16)


def image(value: int, shape=(6, 8, 3)) -> np.ndarray:
    return np.full(shape, value, np.uint8)


def make_seven_scenes(folder: Path, count: int = 3) -> Path:
    folder.mkdir()
    for i in range(count):
        write_png(folder / f"frame-{i:06d}.depth.png", depth_map(1000 + i))
        write_png(folder / f"frame-{i:06d}.color.png", image(i))
        np.savetxt(folder / f"frame-{i:06d}.pose.txt", pose(i))
    return folder


def make_redwood(folder: Path, count: int = 3) -> Path:
    for name in ("depth", "color"):
        (folder / name).mkdir(parents=True)
    for i in range(count):
        write_png(folder / "depth" / f"{i:05d}.png", depth_map(1000 + i))
        Image.fromarray(image(i)).save(folder / "color" / f"{i:05d}.jpg")
    write_log(folder, range(count))
    return folder


def write_log(folder: Path, ids) -> None:
    """Write a log in which pose k is at x = k meters."""
    ids = np.array([[i, i, i + 1] for i in ids])
    write_trajectory(folder / "trajectory.log", Trajectory(np.array([pose(k) for k in range(len(ids))]), ids=ids))


def make_tum(folder: Path, count: int = 3) -> Path:
    for name in ("depth", "rgb"):
        (folder / name).mkdir(parents=True)
    depth_times = [100 + 0.1 * i for i in range(count)]
    color_times = [time + 0.012 for time in depth_times]
    for i in range(count):
        write_png(folder / "depth" / f"{depth_times[i]:.6f}.png", depth_map(5000 + i))
        write_png(folder / "rgb" / f"{color_times[i]:.6f}.png", image(i))
    write_listing(folder, "depth", depth_times)
    write_listing(folder, "rgb", color_times)
    write_poses(folder, [(time + 0.004, i) for i, time in enumerate(depth_times)])
    return folder


def write_listing(folder: Path, name: str, times) -> None:
    lines = [f"{time:.6f} {name}/{time:.6f}.png" for time in times]
    (folder / f"{name}.txt").write_text("\n".join(["# images", "# timestamp filename", *lines, ""]))


def write_poses(folder: Path, entries) -> None:
    poses = Trajectory(np.array([pose(x) for _, x in entries]), timestamps=np.array([time for time, _ in entries]))
    write_trajectory(folder / "groundtruth.txt", poses, format="tum")


def make(layout: str, folder: Path, count: int = 3) -> Path:
    return {"7scenes": make_seven_scenes, "redwood": make_redwood, "tum": make_tum}[layout](folder, count)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_each_layout_is_detected_and_read_in_order(tmp_path, layout):
    dataset = open_dataset(make(layout, tmp_path / "set"), intrinsic=SMALL)
    scale = 5000 if layout == "tum" else 1000
    assert (dataset.layout, len(dataset), dataset.depth_scale, dataset.left_out) == (layout, 3, scale, [])
    for i, frame in enumerate(dataset):
        assert frame.color is not None and frame.depth.dtype == np.uint16 and frame.color.dtype == np.uint8
        assert (frame.depth == scale + i).all() and np.abs(frame.color.astype(int) - i).max() <= 1
        assert frame.T_world_camera[0, 3] == i and frame.name == dataset.frames[i].name


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_second_frame_begins_with_the_first(tmp_path, layout):
    dataset = open_dataset(make(layout, tmp_path / "set"), intrinsic=SMALL, every=2)
    assert [frame.T_world_camera[0, 3] for frame in dataset] == [0, 2] and dataset.read(-1).T_world_camera[0, 3] == 2
    with pytest.raises(IndexError):
        dataset.read(2)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_set_without_color_has_frames_without_color(tmp_path, layout):
    folder = make(layout, tmp_path / "set")
    for path in [*folder.glob("*.color.png"), folder / "rgb.txt"]:
        path.unlink(missing_ok=True)
    for name in ("color", "rgb"):
        shutil.rmtree(folder / name, ignore_errors=True)
    frame = open_dataset(folder, intrinsic=SMALL).read(1)
    assert frame.color is None and frame.T_world_camera[0, 3] == 1


def test_unknown_layouts_and_folders_and_no_positive_number_of_frames_are_refused(tmp_path):
    folder = make("redwood", tmp_path / "set")
    for every in (0, -1, 1.5, "2", True):
        with pytest.raises(DatasetError, match="every:"):
            open_dataset(folder, every=every)
    with pytest.raises(ValueError, match="layout:"):
        open_dataset(tmp_path, layout="scannet")
    with pytest.raises(DatasetError, match="/none:"):
        open_dataset(tmp_path / "none")
    (tmp_path / "file").write_text("")
    with pytest.raises(DatasetError, match="/file:"):
        open_dataset(tmp_path / "file")


def test_empty_folder_error_lists_the_expected_files(tmp_path):
    (tmp_path / "depth").mkdir()
    with pytest.raises(DatasetError) as caught:
        open_dataset(tmp_path)
    for text in ("frame-NNNNNN.depth.png (missing)", "depth/ (found)", "trajectory.log (missing)", "groundtruth.txt"):
        assert text in str(caught.value)
    for layout in LAYOUTS:
        with pytest.raises(DatasetError):
            open_dataset(tmp_path, layout=layout)


def test_two_layouts_in_one_folder_need_a_word(tmp_path):
    folder = make("redwood", tmp_path / "set")
    (folder / "depth.txt").write_text("0 depth/00000.png\n0.1 depth/00001.png\n")
    write_poses(folder, [(0, 5), (0.1, 6)])
    with pytest.raises(DatasetError, match="ambiguous:"):
        open_dataset(folder)
    assert len(open_dataset(folder, layout="redwood", intrinsic=SMALL)) == 3
    assert open_dataset(folder, layout="tum", intrinsic=SMALL).frames[1].T_world_camera[0, 3] == 6


def test_only_in_seven_scenes_the_largest_depth_is_no_measurement(tmp_path):
    depth = depth_map(1500)
    depth[0, :3] = 0, 65534, 65535
    files = (("7scenes", "frame-000001.depth.png", 0), ("redwood", "depth/00001.png", 65535))
    for layout, name, expected in files:
        folder = make(layout, tmp_path / layout)
        write_png(folder / name, depth)
        read = open_dataset(folder, intrinsic=SMALL).read(1).depth
        assert read[0, :4].tolist() == [0, 65534, expected, 1500]


@pytest.mark.parametrize("layout", LAYOUTS)
def test_default_camera_depends_on_the_layout(tmp_path, layout):
    folder = make(layout, tmp_path / "set")
    for path in folder.rglob("*.png"):
        write_png(path, depth_map(1, (480, 640)) if "depth" in str(path) else image(1, (480, 640, 3)))
    for path in folder.rglob("*.jpg"):
        Image.fromarray(image(1, (480, 640, 3))).save(path)
    expected = PinholeCameraIntrinsic(640, 480, 585, 585, 320, 240) if layout == "7scenes" else None
    assert open_dataset(folder).intrinsic == (expected or PinholeCameraIntrinsic.prime_sense_default())


def test_given_camera_overrides_the_folder_and_the_default(tmp_path):
    folder = make("redwood", tmp_path / "set")
    write_pinhole_camera_intrinsic(folder / "camera.json", SMALL)
    assert open_dataset(folder).intrinsic == SMALL
    other = PinholeCameraIntrinsic(8, 6, 9.0, 9.0, 3.5, 2.5)
    assert open_dataset(folder, intrinsic=other).intrinsic == other
    write_pinhole_camera_intrinsic(folder / "intrinsic.json", other)
    with pytest.raises(DatasetError, match=r"intrinsic\.json"):
        open_dataset(folder)


def test_the_depth_scale_of_a_recorder_is_heeded(tmp_path):
    folder = make("redwood", tmp_path / "set")
    matrix = SMALL.matrix.T.ravel().tolist()
    content = {"width": 8, "height": 6, "intrinsic_matrix": matrix, "depth_scale": 4000.0}
    (folder / "intrinsic.json").write_text(json.dumps(content))
    assert open_dataset(folder).depth_scale == 4000
    (folder / "intrinsic.json").write_text(json.dumps({**content, "depth_scale": 0}))
    with pytest.raises(FileError, match=r"/intrinsic\.json \(key depth_scale\):"):
        open_dataset(folder)


def test_scene_matrix_is_read_from_the_scene_or_sequence_folder(tmp_path):
    folder = make("7scenes", tmp_path / "seq-07")
    np.savetxt(tmp_path / "camera-intrinsics.txt", SMALL.matrix)
    assert open_dataset(folder).intrinsic == SMALL
    (folder / "camera-intrinsics.txt").write_text("1 0 0\n0 1 0\n")
    with pytest.raises(FileError, match=r"/camera-intrinsics\.txt:.*3.*2"):
        open_dataset(folder)


def test_two_matrices_that_disagree_are_refused(tmp_path):
    folder = make("7scenes", tmp_path / "set")
    for name in ("K.txt", "intrinsics.K.txt"):
        np.savetxt(folder / name, SMALL.matrix)
    assert open_dataset(folder).intrinsic == SMALL
    np.savetxt(folder / "K.txt", SMALL.scaled(0.5).matrix)
    with pytest.raises(DatasetError, match=r"K\.txt"):
        open_dataset(folder)


@pytest.mark.parametrize(
    ("numbers", "warning"),
    [
        ((7, 7, 7.5, 5.5), "of images of 8 x 6; it may be for 15 x 11"),
        ((7, 7, 0, 0), r"principal point \(0, 0\) is far from the center"),
        ((7, 200, 3.5, 2.5), "focal length 200 gives a field of view of 1.72"),
        ((0.5, 7, 3.5, 2.5), "a field of view of 166 degrees for a width of 8"),
    ],
)
def test_camera_that_contradicts_the_images_is_reported(tmp_path, numbers, warning):
    folder, given = make("7scenes", tmp_path / "set"), PinholeCameraIntrinsic(8, 6, *numbers)
    np.savetxt(folder / "intrinsics.K.txt", given.matrix)
    assert re.search(warning, open_dataset(folder).warnings[0])
    dataset = open_dataset(folder, intrinsic=given)
    assert re.search(warning, dataset.warnings[0]) and not dataset.reliable
    assert dataset.intrinsic_source == "the intrinsic given"


@pytest.mark.parametrize("name", ["kinect_calibration.yaml", "intrinsics.xml", "frames.K.txt", "Camera.txt"])
def test_a_file_like_a_camera_that_is_not_read_is_reported_with_the_default(tmp_path, name):
    folder = make("7scenes", tmp_path / "set", 1)
    for path in folder.glob("*.png"):
        write_png(path, depth_map(1, (480, 640)) if "depth" in str(path) else image(1, (480, 640, 3)))
    dataset = open_dataset(folder)
    assert not dataset.reliable and "contains no camera file, so it is assumed" in dataset.warnings[0]
    (folder / name).write_text("fx: 500\n")
    dataset = open_dataset(folder)
    assert dataset.intrinsic_source == "the default of 7-Scenes"
    assert f"it is assumed: {name} is beside the frames" in dataset.warnings[0]
    assert open_dataset(folder, intrinsic=PinholeCameraIntrinsic.prime_sense_default()).reliable


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_camera_of_another_size_is_refused(tmp_path, layout):
    folder = make(layout, tmp_path / "set")
    with pytest.raises(DatasetError, match=r"is 8 x 6, but the default of .* is for 640 x 480"):
        open_dataset(folder)
    with pytest.raises(DatasetError, match=r"the intrinsic given is for 4 x 3.*scaled"):
        open_dataset(folder, intrinsic=SMALL.scaled(0.5))


def test_images_that_change_after_opening_are_noticed(tmp_path):
    folder = make("redwood", tmp_path / "set")
    dataset = open_dataset(folder, intrinsic=SMALL)
    write_png(folder / "depth" / "00001.png", depth_map(1, (3, 4)))
    with pytest.raises(FileError, match=r"00001\.png"):
        dataset.read(1)
    data = (folder / "depth" / "00000.png").read_bytes()
    (folder / "depth" / "00000.png").write_bytes(data[:-20])
    with pytest.raises(FileError, match=r"00000\.png"):
        dataset.read(0)
    np.save(tmp_path / "depth.npy", np.ones((6, 8), np.float32))
    (tmp_path / "depth.npy").rename(folder / "depth" / "00002.png")
    with pytest.raises(FileError, match=r"00002\.png: is no longer a 16-bit PNG\. Open the folder again"):
        dataset.read(2)
    assert len(open_dataset(make("redwood", tmp_path / "other"), intrinsic=SMALL)) == 3


def test_missing_duplicate_and_unusable_images_and_cameras_are_named(tmp_path):
    folder = make("redwood", tmp_path / "set")
    (folder / "color" / "00001.png").write_bytes((folder / "color" / "00001.jpg").read_bytes())
    with pytest.raises(DatasetError, match=r"/00001\.png: duplicates 00001\.jpg\. Keep one of the two"):
        open_dataset(folder, intrinsic=SMALL)
    shutil.rmtree(folder / "depth")
    with pytest.raises(DatasetError, match=r"/set/depth: missing\. Give the folder above it, or another layout"):
        list_redwood(folder)
    (folder / "color" / "00001.png").unlink()
    with pytest.raises(DatasetError, match=r"/set/color: contains no PNG with depth in its name"):
        open_frames(folder / "color", intrinsic=SMALL, depth_scale=1000, layout="images")
    scene = make("7scenes", tmp_path / "seq-01")
    np.savetxt(scene / "camera-intrinsics.txt", np.diag([-1.0, 1.0, 1.0]))
    with pytest.raises(FileError, match=r"/seq-01/camera-intrinsics\.txt: .*-1"):
        open_dataset(scene)


def test_the_red_kitchen_opens_with_its_own_camera(real_file):
    dataset = open_dataset(real_file("rgbd-7scenes-redkitchen"), every=100)
    assert (dataset.layout, len(dataset), dataset.depth_scale) == ("7scenes", 3, 1000)
    assert dataset.intrinsic == PinholeCameraIntrinsic(640, 480, 585, 585, 320, 240)
    assert dataset.reliable and dataset.warnings == ()
    frame = dataset.read(1)
    assert frame.name == "frame-000100" and frame.color is not None and frame.color.shape == (480, 640, 3)
    assert 0 < frame.depth.max() < 10_000


def test_redwood_frames_meet_in_the_world(scan_set, scan_file):
    """The depth of the last frame, seen from the first, agrees to centimeters where both overlap."""
    dataset = open_dataset(scan_file("rgbd-cupoch-redwood5"))
    assert dataset.layout == "redwood" and len(dataset) == {"shipped": 3, "real": 5}[scan_set]
    first, last = dataset.read(0), dataset.read(len(dataset) - 1)
    K = dataset.intrinsic.matrix
    v, u = np.nonzero(last.depth)
    z = last.depth[v, u] / dataset.depth_scale
    points = np.linalg.inv(K) @ (np.stack([u, v, np.ones_like(u)]) * z)
    T_first_last = np.linalg.inv(first.T_world_camera) @ last.T_world_camera
    points = T_first_last[:3, :3] @ points + T_first_last[:3, 3:]
    u, v = np.rint((K @ points)[:2] / points[2]).astype(int)
    visible = (u >= 0) & (v >= 0) & (u < 640) & (v < 480)
    there = first.depth[v[visible], u[visible]] / dataset.depth_scale
    assert np.median(np.abs(there - points[2][visible])[there > 0]) < 0.01


def test_a_list_with_a_name_that_no_file_can_have_is_an_error_that_names_it(tmp_path):
    folder = make("tum", tmp_path / "set")
    lines = (folder / "depth.txt").read_text().splitlines()
    (folder / "depth.txt").write_text("\n".join([*lines[:-1], f"{lines[-1].split()[0]} {'n' * 5000}.png", ""]))
    with pytest.raises(DatasetError, match=r"n\.png"):
        open_dataset(folder, intrinsic=SMALL)


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
def test_an_image_missing_in_the_middle_is_named_or_skipped_and_listed(tmp_path, missing):
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
        loom.rgbd.fuse(source)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_color_of_another_size_is_named_or_brought_to_that_of_depth(tmp_path, layout):
    folder = without_poses(make(layout, tmp_path / "set"))
    for path in [*folder.rglob("*.*")]:
        name = str(path.relative_to(folder))
        if path.suffix in (".png", ".jpg") and ("color" in name or "rgb" in name):
            colors = np.repeat(np.repeat(image(50), 2, axis=0), 2, axis=1)
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


def make_images(folder: Path, names="{}_depth {}") -> Path:
    folder.mkdir()
    for i in (1, 2, 10):
        depth, color = names.format(i, i).split()
        write_png(folder / f"{depth}.png", depth_map(5000 * i))
        write_png(folder / f"{color}.png", image(i))
    return folder


@pytest.mark.parametrize("names", ["{}_depth {}", "dep_{} img_{}", "depth{} rgb{}", "{}-D-depth {}-D-color"])
def test_images_in_one_folder_pair_by_the_rest_of_their_names(tmp_path, names):
    folder = make_images(tmp_path / "set", names)
    source = open_frames(folder, intrinsic=SMALL, depth_scale=5000)
    assert (source.layout, source.depth_scale) == ("images", 5000)
    frames = [(f.depth[0, 0] / 5000, f.color[0, 0, 0], f.T_world_camera) for f in source]
    assert frames == [(1, 1, None), (2, 2, None), (10, 10, None)]


def test_poses_of_images_are_matrices_or_a_line_of_tum(tmp_path):
    folder = make_images(tmp_path / "set", "dep_{} img_{}")
    np.savetxt(folder / "pose_1.txt", pose(4))
    (folder / "pose_2.txt").write_text("5 0 0 0 0 0 1\n")
    frames = list(open_frames(folder, intrinsic=SMALL, depth_scale=1000))
    assert [f.T_world_camera is not None and f.T_world_camera[0, 3] for f in frames] == [4, 5, False]
    (folder / "pose_2.txt").write_text("5 0 0 0 0 0 7\n")
    with pytest.raises(FileError, match=r"/pose_2\.txt \(line 1\):"):
        open_frames(folder, intrinsic=SMALL, depth_scale=1000)


def test_parameters_missing_from_the_files_must_be_given(tmp_path):
    folder = make_images(tmp_path / "set")
    for given in ({"depth_scale": 5000}, {"intrinsic": SMALL}):
        with pytest.raises(DatasetError, match="/set:"):
            open_frames(folder, **given)
    with pytest.raises(ValueError, match="depth_scale"):
        open_frames(folder, intrinsic=SMALL, depth_scale=0)


def test_images_that_do_not_pair_are_refused_by_name(tmp_path):
    folder = make_images(tmp_path / "set")
    write_png(folder / "3.png", image(3))
    with pytest.raises(DatasetError, match=r"3\.png"):
        open_frames(folder, intrinsic=SMALL, depth_scale=5000)
    source = open_frames(folder, intrinsic=SMALL, depth_scale=5000, skip_missing=True)
    assert len(source) == 3 and source.left_out == ["3.png: has no depth map of the same name"]
    write_png(folder / "3_depth.png", depth_map(1))
    write_png(folder / "3-depth.png", depth_map(1))
    with pytest.raises(DatasetError, match=r"/3_depth\.png:"):
        open_frames(folder, intrinsic=SMALL, depth_scale=5000)


def test_parent_and_empty_folders_are_rejected_with_a_hint(tmp_path):
    make_images(tmp_path / "set")
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
        ("rgbd-slambook-ch7", "images", 2, False),
        ("rgbd-tum-pairs/case_1", "images", 2, True),
        ("rgbd-tum-pairs/case_2", "images", 2, True),
    ],
)
def test_small_real_sets_open(scan_file, name, layout, count, posed):
    options = {}
    if layout == "images":
        options = {"intrinsic": PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5), "depth_scale": 5000}
    source = open_frames(scan_file(name), **options)
    assert (source.layout, len(source)) == (layout, count)
    for frame in source:
        meters = frame.depth[frame.depth > 0] / source.depth_scale
        assert 0.5 < np.median(meters) < 5
        assert (frame.T_world_camera is not None) == posed and frame.color.shape == (480, 640, 3)


def test_seven_scenes_refuses_doubles(tmp_path):
    folder = make("7scenes", tmp_path / "set")
    (folder / "frame-01.depth.png").touch()
    with pytest.raises(DatasetError, match=r"/frame-01\.depth\.png:.*frame-000001"):
        list_seven_scenes(folder, every=1)
    (folder / "frame-01.depth.png").unlink()
    (folder / "frame-000001.color.jpg").touch()
    with pytest.raises(DatasetError, match=r"frame-000001\.color\.png"):
        list_seven_scenes(folder, every=1)


@pytest.mark.parametrize("text", ["nan " * 16, "1 0 0\n" * 4, "2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1", "-1.#IND\n", ""])
def test_poses_that_are_no_motion_are_refused_by_name(tmp_path, text):
    folder = make("7scenes", tmp_path / "set")
    (folder / "frame-000002.pose.txt").write_text(text)
    with pytest.raises(FileError, match=r"frame-000002\.pose\.txt"):
        list_seven_scenes(folder, every=1)


def test_redwood_pairs_by_number_if_the_names_differ(tmp_path):
    """As in the original recordings: a counter from 1 and a separate time on each side."""
    folder = make("redwood", tmp_path / "set")
    for i in range(3):
        (folder / "depth" / f"{i:05d}.png").rename(folder / "depth" / f"{i + 1:07d}-{33369 * i:012d}.png")
        (folder / "color" / f"{i:05d}.jpg").rename(folder / "color" / f"{i + 1:07d}-{33360 * i:012d}.jpg")
    frames = list_redwood(folder)
    named = [(f.color and f.color.name[:7], f.T_world_camera[0, 3]) for f in frames]
    assert named == [("0000001", 0), ("0000002", 1), ("0000003", 2)]


@pytest.mark.parametrize("name", ["image", "rgb"])
def test_redwood_accepts_alternative_color_folder_names(tmp_path, name):
    folder = make("redwood", tmp_path / "set")
    (folder / "color").rename(folder / name)
    assert list_redwood(folder)[0].color == folder / name / "00000.jpg"
    (folder / "color").mkdir()
    with pytest.raises(DatasetError, match="Keep one folder of color"):
        list_redwood(folder)


def test_redwood_ids_name_the_frames_of_a_thinned_set(tmp_path):
    folder = make("redwood", tmp_path / "set", 6)
    for i in (0, 2, 3):
        (folder / "depth" / f"{i:05d}.png").unlink()
        (folder / "color" / f"{i:05d}.jpg").unlink()
    write_log(folder, [5, 1, 4])
    frames = list_redwood(folder)
    assert [(f.name, f.T_world_camera[0, 3]) for f in frames] == [("00001", 1), ("00004", 2), ("00005", 0)]


@pytest.mark.parametrize("ids", [[1, 2, 3], [0, 1, 1], [2, 1, 7], [0, 10, 20], range(2), range(4)])
def test_redwood_ids_that_name_no_frame_are_refused(tmp_path, ids):
    folder = make("redwood", tmp_path / "set")
    write_log(folder, ids)
    with pytest.raises(DatasetError, match=r"trajectory\.log"):
        list_redwood(folder)


def test_redwood_images_that_pair_with_no_depth_map_are_named(tmp_path):
    folder = make("redwood", tmp_path / "set", 2)
    (folder / "color" / "00007.jpg").touch()
    with pytest.raises(DatasetError, match=r"00007\.jpg"):
        list_redwood(folder)
    (folder / "color" / "00007.jpg").unlink()
    for i in range(2):
        (folder / "color" / f"{i:05d}.jpg").rename(folder / "color" / f"7-{i}.jpg")
    with pytest.raises(DatasetError, match=r"7-0\.jpg"):
        list_redwood(folder)


def test_hidden_and_foreign_files_do_no_harm(tmp_path):
    folder = make("redwood", tmp_path / "set")
    for name in (".DS_Store", "._00000.png", "Thumbs.db"):
        (folder / "depth" / name).write_bytes(b"?")
    assert len(list_redwood(folder)) == 3


def test_tum_reports_frames_without_a_partner(tmp_path):
    folder = make("tum", tmp_path / "set", 4)
    write_listing(folder, "rgb", [100.012, 100.225, 100.312])  # the second is 25 ms from its depth map
    write_poses(folder, [(100.0, 0), (100.1, 1), (100.2, 2), (100.275, 3)])  # and the last pose from the last one
    frames, left_out = list_tum(folder)
    assert [frame.name for frame in frames] == ["100.000000"]
    reasons = [text.split(": ")[1] for text in left_out]
    assert reasons == ["no color within 0.02 s", "no color within 0.02 s", "no pose within 0.02 s"]
    (warning,) = source_warnings(open_dataset(folder, intrinsic=SMALL))
    assert "only 1 of 3 frames have all images and a pose at their time" in warning
    assert source_warnings(open_dataset(make("tum", tmp_path / "all"), intrinsic=SMALL, every=3)) == ()


def test_association_agrees_with_trying_all_pairs():
    generator = np.random.default_rng(0)
    for _ in range(50):
        first, second = (np.sort(generator.uniform(0, 1, generator.integers(0, 40))) for _ in range(2))
        free_first, free_second, expected = set(range(len(first))), set(range(len(second))), {}
        for _, i, j in sorted((abs(a - b), i, j) for i, a in enumerate(first) for j, b in enumerate(second)):
            if abs(first[i] - second[j]) < 0.02 and i in free_first and j in free_second:
                expected[i] = j
                free_first.remove(i)
                free_second.remove(j)
        assert associate(first, second, 0.02) == expected


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("depth.txt", "", "lists no image"),
        ("depth.txt", "soon depth/a.png\n", "line 1): not a number"),
        ("depth.txt", "100.0 ../../etc/x.png\n", "name of an image in the folder"),
        ("depth.txt", "100.1 depth/a.png\n100.0 depth/b.png\n", "line 2): expected increasing times"),
        ("groundtruth.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n", "has no times"),
        ("groundtruth.txt", "1 0 0 0 0 0 0 0\n", "unit quaternion"),
    ],
)
def test_tum_lists_are_checked_by_line(tmp_path, name, text, message):
    folder = make("tum", tmp_path / "set")
    (folder / name).write_text(text)
    with pytest.raises(FileError, match=re.escape(message)):
        list_tum(folder)


def test_tum_color_without_its_list_and_poses_of_another_clock_are_refused(tmp_path):
    folder = make("tum", tmp_path / "set")
    (folder / "rgb.txt").rename(tmp_path / "rgb.txt")
    with pytest.raises(DatasetError, match=r"rgb\.txt"):
        list_tum(folder)
    (tmp_path / "rgb.txt").rename(folder / "rgb.txt")
    write_poses(folder, [(5.0, 0), (5.1, 1)])
    with pytest.raises(DatasetError, match=r"clocks must agree: depth.txt 100 to .* s, groundtruth\.txt 5 to 5\.1 s"):
        list_tum(folder)


MARKS = ["-inf", "nan", "-1.#IND", "-nan(ind)"]


def matrix(mark, rows=4):
    row = " ".join([mark] * 4)
    return "\n".join([row] * rows) if mark else "\n".join(" ".join(map(str, r)) for r in np.eye(4)[:rows])


def make_lost(folder, layout, marks):
    """A folder of frames whose poses have these marks, or are valid if the mark is empty."""
    if layout == "images":
        folder.mkdir()
    else:
        make(layout, folder, len(marks))
    rows = []
    for i, mark in enumerate(marks):
        if layout == "redwood":
            rows.append(f"{i} {i} {i + 1}\n{matrix(mark)}\n")
        elif layout == "tum":
            rows.append(f"{100 + i / 10} {' '.join([mark] * 7) if mark else '0 0 0 0 0 0 1'}\n")
        else:
            name = f"{i:06d}_pose.txt" if layout == "images" else f"frame-{i:06d}.pose.txt"
            (folder / name).write_text(matrix(mark))
        if layout == "images":
            write_png(folder / f"{i:06d}_depth.png", depth_map(1500))
    if rows:
        (folder / ("groundtruth.txt" if layout == "tum" else "trajectory.log")).write_text("".join(rows))
    return folder


@pytest.mark.parametrize("layout", ["7scenes", "redwood", "tum", "images"])
@pytest.mark.parametrize("lost_value", MARKS)
def test_frames_with_lost_poses_are_left_out_by_name(tmp_path, layout, lost_value):
    folder = make_lost(tmp_path / "set", layout, ["", "", lost_value, ""])
    options, scale = {"intrinsic": SMALL, "layout": layout}, {"depth_scale": 1000.0}
    name = {"redwood": "00002", "tum": "100.2"}.get(layout, "000002")
    frames = loom.open_frames(folder, **options, **scale)
    assert [frame.T_world_camera is None for frame in frames] == [False, False, True, False]
    frames = loom.open_frames(folder, **options, **scale, skip_missing=True)
    assert len(frames) == 3 and len(frames.left_out) == 1 and name in frames.left_out[0]
    assert len(loom.open_frames(folder, **options, **scale, skip_missing="images")) == 4
    if layout != "images":
        with pytest.raises(loom.FileError, match=r"inf or NaN.*skip_missing=True"):
            loom.open_dataset(folder, **options)
        frames = loom.open_dataset(folder, **options, skip_missing=True)
        assert len(frames) == 3 and name in frames.left_out[0]
        assert loom.rgbd.fuse(frames, voxel_size=0.1).T_world_camera.shape == (3, 4, 4)


def test_a_folder_of_lost_poses_alone_is_refused(tmp_path):
    folder = make_lost(tmp_path / "set", "7scenes", ["nan", "inf"])
    with pytest.raises(loom.FileError):
        loom.open_dataset(folder, intrinsic=SMALL, skip_missing=True)


def test_the_command_leaves_them_out(tmp_path, capsys):
    folder = make_lost(tmp_path / "set", "7scenes", ["", "-inf", "", ""])
    SMALL.write(tmp_path / "camera.json")
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
    lens = loom.read_cameras(path, images=["0.png", "1.png", "2.png"], intrinsic=SMALL)
    assert len(lens) == 2 and lens.left_out == ("1.png: no pose",)


@pytest.mark.parametrize("layout", ["7scenes", "redwood", "tum"])
def test_a_matrix_is_the_camera_and_poses_can_be_required(tmp_path, layout):
    folder = make(layout, tmp_path / "set")
    frames = open_frames(folder, intrinsic=SMALL.matrix, poses="required")
    assert frames.intrinsic == SMALL and [frame.name for frame in frames] == [
        frame.name for frame in open_dataset(folder, intrinsic=SMALL)
    ]
    with pytest.raises(ValueError, match="poses"):
        open_frames(folder, intrinsic=SMALL, poses="needed")


def test_images_without_a_pose_are_refused_if_poses_are_required(tmp_path):
    write_png(tmp_path / "1_depth.png", depth_map(1000))
    options = {"layout": "images", "intrinsic": SMALL, "depth_scale": 1000.0}
    assert len(open_frames(tmp_path, **options)) == 1
    with pytest.raises(DatasetError, match="has no pose"):
        open_frames(tmp_path, **options, poses="required")


@pytest.mark.parametrize("name", ["run.bag", "run.mcap", "run.db3", "run"])
def test_readers_of_other_files_name_the_reader_of_recordings(tmp_path, name):
    path = tmp_path / name
    if name == "run":
        path.mkdir()
        path = path / "a.db3"
    path.write_bytes(b"bytes")
    path = tmp_path / name
    readers = loom.read_point_cloud, loom.read_triangle_mesh, loom.read_trajectory, open_frames, open_dataset
    for reader in readers:
        with pytest.raises(FileError, match=r"loom.open_recording\(path\)"):
            reader(path)


def test_omitted_frames_make_results_unreliable(tmp_path):
    folder = make("7scenes", tmp_path / "set")
    next(folder.glob("*1.color.png")).unlink()
    (warning,) = source_warnings(open_frames(folder, intrinsic=SMALL, skip_missing=True))
    assert warning.startswith("1 of 3 frames lack an image")
