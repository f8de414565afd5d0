"""Folders of RGB-D frames: matching files are paired, and mismatches are named."""

import json
import re
import shutil

import numpy as np
import pytest
from PIL import Image

from pointloom.cameras.camera import PinholeCameraIntrinsic, write_pinhole_camera_intrinsic
from pointloom.core.errors import DatasetError, FileError
from pointloom.io.frames.datasets import open_dataset
from pointloom.io.pictures.image_files import write_png

from .frame_folders import LAYOUTS, SMALL, depth_map, make, picture, write_poses


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
        write_png(path, depth_map(1, (480, 640)) if "depth" in str(path) else picture(1, (480, 640, 3)))
    for path in folder.rglob("*.jpg"):
        Image.fromarray(picture(1, (480, 640, 3))).save(path)
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
        write_png(path, depth_map(1, (480, 640)) if "depth" in str(path) else picture(1, (480, 640, 3)))
    assert open_dataset(folder).reliable
    (folder / name).write_text("fx: 500\n")
    dataset = open_dataset(folder)
    assert dataset.intrinsic_source == "the default of 7-Scenes"
    assert dataset.warnings == (f"{name} is beside the frames, but was not read; pass it as intrinsic=",)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_camera_of_another_size_is_refused(tmp_path, layout):
    folder = make(layout, tmp_path / "set")
    with pytest.raises(DatasetError, match=r"is 8 x 6, but the default of .* is for 640 x 480"):
        open_dataset(folder)
    with pytest.raises(DatasetError, match=r"the intrinsic given is for 4 x 3.*scaled"):
        open_dataset(folder, intrinsic=SMALL.scaled(0.5))


def test_pictures_that_change_after_opening_are_noticed(tmp_path):
    folder = make("redwood", tmp_path / "set")
    dataset = open_dataset(folder, intrinsic=SMALL)
    write_png(folder / "depth" / "00001.png", depth_map(1, (3, 4)))
    with pytest.raises(FileError, match=r"00001\.png"):
        dataset.read(1)
    data = (folder / "depth" / "00000.png").read_bytes()
    (folder / "depth" / "00000.png").write_bytes(data[:-20])
    with pytest.raises(FileError, match=r"00000\.png"):
        dataset.read(0)
    assert len(open_dataset(make("redwood", tmp_path / "other"), intrinsic=SMALL)) == 3


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
