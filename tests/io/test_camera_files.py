"""Cameras with known poses in several formats: trajectories, transforms, phones, Metashape, and models of them."""

import copy
import json
import pickle
import re

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.pose_text import read_pose
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.core.errors import FileError
from pointloom.io.models import metashape
from pointloom.io.models.frame_cameras import read_transforms
from pointloom.io.models.metashape import read_metashape_cameras

from .sfm_models import LENS, assert_same, ring_model

# A camera at (1, 2, 3) that looks along the world's +x, its top toward the world's +y (ARKit: y is up).
LOOK = np.array([[0.0, 0, 1], [0, -1, 0], [1, 0, 0]])  # T_world_camera's rotation, x right, y down, z forward
ARKIT = np.array([[0.0, 0, -1, 1], [0, 1, 0, 2], [1, 0, 0, 3], [0, 0, 0, 1]])  # x right, y up, z back
SIZE = {"w": 64, "h": 48, "fl_x": 60.0, "fl_y": 61.0, "cx": 32.5, "cy": 24.0}
PINHOLE = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content))
    return path


def transforms(tmp_path, frame=(), **more):
    frames = [{"file_path": "./images/a.png", "transform_matrix": ARKIT.tolist(), **dict(frame)}]
    return write(tmp_path / "transforms.json", {**SIZE, **more, "frames": frames})


def assert_looks_along_x(model, name):
    assert model.names == (name,)
    np.testing.assert_allclose(model.T_world_camera[0, :3, :3], LOOK, atol=1e-12)
    np.testing.assert_allclose(model.centers[0], [1, 2, 3], atol=1e-12)
    # a point ahead is projected to the center, a higher one to the upper half
    ahead = np.array([[5.0, 2, 3], [5.0, 2.4, 3]]) @ model.T_camera_world[0, :3, :3].T + model.T_camera_world[0, :3, 3]
    (_, middle), (_, upper) = model.cameras[0].project(ahead)
    assert middle == pytest.approx(model.cameras[0].intrinsic.cy) and upper < middle


def test_transforms_have_y_up_and_z_back(tmp_path):
    model = loom.read_cameras(transforms(tmp_path))
    assert_looks_along_x(model, "images/a.png")
    assert model.cameras[0] == loom.CameraModel("PINHOLE", 64, 48, [60, 61, 32.5, 24])


def test_lenses_of_transforms_follow_colmap(tmp_path):
    for more, expected in (
        ({"k1": 0.1, "p2": 0.01}, ("OPENCV", [60, 61, 32.5, 24, 0.1, 0, 0, 0.01])),
        ({"k1": 0.1, "k3": 0.2}, ("FULL_OPENCV", [60, 61, 32.5, 24, 0.1, 0, 0, 0, 0.2, 0, 0, 0])),
        ({"camera_model": "OPENCV_FISHEYE", "k4": 0.1}, ("OPENCV_FISHEYE", [60, 61, 32.5, 24, 0, 0, 0, 0.1])),
        ({"is_fisheye": True, "k1": 0.1}, ("OPENCV_FISHEYE", [60, 61, 32.5, 24, 0.1, 0, 0, 0])),
        ({"is_fisheye": False, "k1": 0.1}, ("OPENCV", [60, 61, 32.5, 24, 0.1, 0, 0, 0])),
    ):
        (camera,) = loom.read_cameras(transforms(tmp_path, **more)).cameras
        assert (camera.model, list(camera.params)) == expected


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"camera_model": "EQUIRECTANGULAR"}, "EQUIRECTANGULAR"),
        ({"k4": 0.1}, "k4 to k6"),
        ({"is_fisheye": True, "camera_model": "OPENCV"}, "is_fisheye"),
        ({"w": 63.5}, "w: expected whole pixels"),
        ({"fl_x": "60"}, "fl_x: expected 1 finite number"),
        ({"frame": {"transform_matrix": (2 * ARKIT).tolist()}}, r"frames\[0\]"),
        ({"frame": {"transform_matrix": [[1, 2], [3, 4]]}}, "expected 4 rows"),
        ({"frame": {"transform_matrix": [[10**400, 0, 0, 0], *np.eye(4).tolist()[1:]]}}, "too large"),
        ({"frame": {"file_path": 3}}, "file_path"),
        ({"frame": {"file_path": "\ud800.png"}}, "surrogates not allowed"),
    ],
)
def test_invalid_transforms_are_rejected(tmp_path, changes, message):
    with pytest.raises(FileError, match=message):
        loom.read_cameras(transforms(tmp_path, **changes))


@pytest.mark.parametrize(("name", "file"), [("./train/r_0", "train/r_0.png"), ("r.JPG", "r.JPG"), ("r.0", "r.0.png")])
def test_transforms_without_a_size_take_that_of_the_image(tmp_path, name, file):
    frame = {"file_path": name, "transform_matrix": ARKIT.tolist()}
    path = write(tmp_path / "t.json", {"camera_angle_x": 0.7, "camera_angle_y": 0.5, "frames": [frame]})
    with pytest.raises(FileError, match=r"/t\.json \(frames\[0\]\):"):
        loom.read_cameras(path)
    (tmp_path / file).parent.mkdir(exist_ok=True)
    Image.new("RGB", (80, 60)).save(tmp_path / file)
    model = loom.read_cameras(path)
    assert model.names == (file,)
    expected = [40 / np.tan(0.35), 30 / np.tan(0.25), 40, 30]
    assert model.cameras[0].params == pytest.approx(expected) and model.cameras[0].model == "PINHOLE"


def test_angles_of_view_are_converted_to_focal_lengths(tmp_path):
    for angles, expected in (
        ({"camera_angle_x": 0.7}, (32 / np.tan(0.35), 32 / np.tan(0.35))),
        ({"camera_angle_y": 0.7}, (24 / np.tan(0.35), 24 / np.tan(0.35))),
        ({"fl_x": 60, "camera_angle_x": 0.1, "camera_angle_y": 0.7}, (60, 24 / np.tan(0.35))),
        ({}, "focal length"),
        ({"camera_angle_x": 0}, "camera_angle_x"),
        ({"fl_x": 60, "camera_angle_y": 3.2}, "camera_angle_y"),
    ):
        frame = {"file_path": "a.png", "transform_matrix": ARKIT.tolist()}
        path = write(tmp_path / "t.json", {"w": 64, "h": 48, **angles, "frames": [frame]})
        if isinstance(expected, str):
            with pytest.raises(FileError, match=expected):
                loom.read_cameras(path)
        else:
            assert loom.read_cameras(path).cameras[0].params[:2] == pytest.approx(expected)


def polycam(**more):
    rows = {f"t_{i}{j}": ARKIT[i, j] for i in range(3) for j in range(4)}
    return rows | {"fx": 60.0, "fy": 61.0, "cx": 32.5, "cy": 24.0, "width": 64, "height": 48, "blur_score": 7.5} | more


def test_cameras_of_polycam_have_y_up_and_z_back_and_need_a_lens(tmp_path):
    write(tmp_path / "cameras" / "12345.json", polycam())
    write(tmp_path / "cameras" / "mesh_info.json", {"alignmentTransform": []})  # is beside them
    model = loom.read_cameras(tmp_path / "cameras")
    assert_looks_along_x(model, "12345")
    assert model.cameras[0] == loom.CameraModel("PINHOLE", 64, 48, [60, 61, 32.5, 24])
    write(tmp_path / "cameras" / "1.json", {key: value for key, value in polycam().items() if key != "fy"})
    with pytest.raises(FileError, match=r"/1\.json"):
        loom.read_cameras(tmp_path / "cameras")


def test_frames_of_the_scanner_app_take_their_size_from_the_image(tmp_path):
    frame = {"cameraPoseARFrame": ARKIT.ravel().tolist(), "intrinsics": [60, 0, 32.5, 0, 61, 24, 0, 0, 1]}
    for number in (0, 1):
        write(tmp_path / f"frame_0000{number}.json", frame)
    Image.new("RGB", (64, 48)).save(tmp_path / "frame_00000.jpg")
    model = loom.read_cameras(tmp_path)
    assert_looks_along_x(model, "frame_00000")
    assert model.cameras[0] == loom.CameraModel("PINHOLE", 64, 48, [60, 61, 32.5, 24])
    assert model.left_out == ("frame_00001: no image",)
    (tmp_path / "frame_00000.jpg").unlink()
    with pytest.raises(FileError, match="2 have none"):
        loom.read_cameras(tmp_path)


def trajectory(tmp_path, name, **more):
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, 0, 3] = 0, 1, 2
    loom.write_trajectory(tmp_path / name, loom.Trajectory(poses, **more), format=name.rsplit(".", 1)[1])
    return tmp_path / name


def test_poses_are_of_the_images_with_their_times_or_numbers_or_in_natural_order(tmp_path):
    times = trajectory(tmp_path, "p.tum", timestamps=[5.0, 5.1, 5.2])
    numbers = trajectory(tmp_path, "p.log", ids=np.array([[4, 4, 5], [8, 8, 9], [12, 12, 13]]))
    plain = trajectory(tmp_path, "p.kitti")
    for path, expected, left_out in (
        (times, {"5.0.png": 0, "5.110.png": 1}, ["5.14.png"]),
        (numbers, {"f_4.png": 0, "f_8.png": 1}, ["f_5.png"]),
        (plain, {"f_2.png": 0, "f_9.png": 1, "f_10.png": 2}, []),
    ):
        model = loom.read_cameras(path, images=[*left_out, *expected][::-1], intrinsic=PINHOLE)
        assert dict(zip(model.names, model.centers[:, 0].tolist(), strict=True)) == expected
        assert model.left_out == tuple(f"{name}: no pose" for name in left_out)
    with pytest.raises(FileError, match=r"/p\.kitti:.*3.*2"):
        loom.read_cameras(plain, images=["a.png", "b.png"], intrinsic=PINHOLE)


def test_unknown_paths_and_a_missing_or_additional_lens_are_rejected(tmp_path):
    with pytest.raises(FileError, match=r"/cameras\.csv:"):
        loom.read_cameras(tmp_path / "cameras.csv")
    with pytest.raises(FileError, match="no supported cameras"):
        loom.read_cameras(tmp_path)
    with pytest.raises(FileError, match="no lens"):
        loom.read_cameras(trajectory(tmp_path, "p.kitti"), images=["a.png"])
    with pytest.raises(ValueError, match="intrinsic: "):
        loom.read_cameras(transforms(tmp_path), intrinsic=PINHOLE)
    with pytest.raises(
        ValueError, match="images: expected the names of the images, which a trajectory does not contain"
    ):
        loom.read_cameras(trajectory(tmp_path, "p.kitti"), intrinsic=PINHOLE)
    path = trajectory(tmp_path, "p.tum", timestamps=[5.0, 5.1, 5.2])
    with pytest.raises(
        FileError, match=r"/p\.tum: contains the pose of none of the images\. The first image is 9\.0\.png"
    ):
        loom.read_cameras(path, images=["9.0.png", "9.1.png"], intrinsic=PINHOLE)
    for frames in (None, {}, []):
        path = write(tmp_path / "t.json", {**SIZE, "frames": frames, "camera_model": "OPENCV"})
        with pytest.raises(FileError, match=r"/t\.json \(key frames\): expected a list of at least one frame"):
            read_transforms(path)
    frame = {"file_path": "a.png", "transform_matrix": ARKIT.tolist()}
    with pytest.raises(FileError, match=r"/t\.json: names: 'a\.png' is duplicated"):
        loom.read_cameras(write(tmp_path / "t.json", {**SIZE, "frames": [frame, frame]}))


def test_colmap_and_metashape_files_are_detected_by_content(tmp_path):
    camera = loom.CameraModel("PINHOLE", 64, 48, [60, 61, 32.5, 24])
    model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None])
    loom.write_colmap_model(tmp_path / "sparse", model)
    assert loom.read_cameras(tmp_path).names == ("a.png",)
    (tmp_path / "cameras.xml").write_text("<document/>")
    with pytest.raises(FileError, match="one chunk"):
        loom.read_cameras(tmp_path / "cameras.xml")


@pytest.mark.parametrize(
    ("model", "params"),
    [
        ("SIMPLE_PINHOLE", [60, 32, 24]),
        ("PINHOLE", [60, 61, 32.5, 24]),
        ("SIMPLE_RADIAL", [60, 32, 24, 0.1]),
        ("RADIAL", [60, 32, 24, 0.1, -0.02]),
        ("OPENCV", [60, 61, 32.5, 24, 0.1, -0.02, 0.001, 0.002]),
        ("OPENCV_FISHEYE", [60, 61, 32.5, 24, 0.1, -0.02, 0.003, 0.004]),
        ("FULL_OPENCV", [60, 61, 32.5, 24, 0.1, -0.02, 0.001, 0.002, 0.003, 0, 0, 0]),
    ],
)
def test_transforms_round_trip(tmp_path, model, params):
    rng = np.random.default_rng(0)
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[0, :3, :3], poses[:, :3, 3] = LOOK, rng.normal(size=(2, 3))
    points = rng.normal(size=(5, 3))
    lens = loom.CameraModel(model, 64, 48, params)
    before = loom.SfmModel(["b.png", "sub/a.png"], [lens] * 2, poses, points, colors=np.full((5, 3), 40, np.uint8))
    loom.write_transforms(tmp_path / "transforms.json", before, images="images")
    after = loom.read_cameras(tmp_path / "transforms.json")
    assert after.names == ("images/b.png", "images/sub/a.png")
    np.testing.assert_allclose(after.T_camera_world, before.T_camera_world, atol=1e-15)
    pixels = rng.uniform(0, 40, (20, 2))
    np.testing.assert_array_equal(after.cameras[0].unproject(pixels), lens.unproject(pixels))
    content = json.loads((tmp_path / "transforms.json").read_text())
    cloud = loom.read_point_cloud(tmp_path / content["ply_file_path"])
    np.testing.assert_allclose(cloud.points, points, atol=1e-6)
    np.testing.assert_allclose(cloud.colors, 40 / 255, atol=1e-6)


def test_lenses_unsupported_by_transforms_are_rejected(tmp_path):
    for model, params in (("FOV", [60, 61, 32, 24, 0.9]), ("FULL_OPENCV", [60, 61, 32, 24, *[0] * 5, 0.1, 0, 0])):
        with pytest.raises(ValueError, match=r"^model:"):
            lens = loom.CameraModel(model, 64, 48, params)
            loom.write_transforms(tmp_path / "t.json", loom.SfmModel(["a.png"], [lens], np.eye(4)[None]))
    fisheye = loom.CameraModel("OPENCV_FISHEYE", 64, 48, [60, 61, 32.5, 24, 0.1, -0.02, 0.003, 0.004])
    pinhole = loom.CameraModel("PINHOLE", 64, 48, [60, 61, 32.5, 24])
    mixed = loom.SfmModel(["a.png", "b.png"], [pinhole, fisheye], np.stack([np.eye(4)] * 2))
    with pytest.raises(ValueError, match=r"^model: .* got OPENCV and OPENCV_FISHEYE; write two models"):
        loom.write_transforms(tmp_path / "t.json", mixed)
    with pytest.raises(ValueError, match="model: expected at least one image, got none"):
        loom.write_transforms(tmp_path / "t.json", loom.SfmModel([], [], []))
    with pytest.raises(TypeError, match="model: expected an SfmModel, got CameraModel"):
        loom.write_transforms(tmp_path / "t.json", pinhole)
    assert not list(tmp_path.iterdir())


POSE = "0 -1 0 2 1 0 0 3 0 0 1 4 0 0 0 1"  # 90 degrees about z, at (2, 3, 4)
ROTATION = "<rotation locked='true'>0 0 1 1 0 0 0 1 0</rotation>"
TRANSFORM = f"<transform>{ROTATION}<translation>10 20 30</translation><scale locked='true'>2</scale></transform>"


def sensor(lens: str, *, kind: str = "frame", number: int = 0, resolution: str = "width='640' height='480'") -> str:
    return (
        f"<sensor id='{number}' type='{kind}'><resolution {resolution}/>"
        f"<calibration type='{kind}' class='initial'><resolution {resolution}/><f>1</f></calibration>"
        f"<calibration type='{kind}' class='adjusted'><resolution {resolution}/>{lens}</calibration></sensor>"
    )


def camera(label: str = "IMG_1", pose: str | None = POSE, more: str = "", number: int = 0) -> str:
    transform = "" if pose is None else f"<transform>{pose}</transform>"
    tags = f"{transform}<orientation>1</orientation>"
    return f"<camera id='{number}' sensor_id='0' label='{label}' {more}>{tags}</camera>"


def document(cameras: str, sensors: str = sensor("<f>500</f>"), more: str = "") -> str:
    return (
        "<?xml version='1.0' encoding='UTF-8'?>\n<document version='2.0.0'><chunk label='Chunk 1' enabled='true'>"
        f"<sensors>{sensors}</sensors>{more}<cameras>{cameras}</cameras></chunk></document>"
    )


def read(tmp_path, text: str | bytes) -> loom.SfmModel:
    path = tmp_path / "cameras.xml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_metashape_cameras(path)


def test_camera_centers_are_read_from_transforms_with_the_precision_of_geocentric_positions(tmp_path):
    transform = "<translation>-2499366.429888 -4256836.520906 4029217.965003</translation><scale>12.35</scale>"
    model = read(tmp_path, document(camera(), more=f"<transform>{transform}</transform>"))
    expected = np.array([-2499366.429888, -4256836.520906, 4029217.965003]) + 12.35 * np.array([2, 3, 4])
    assert np.abs(model.centers[0] - expected).max() < 1e-8
    model = read(tmp_path, document(camera()))
    assert model.names == ("IMG_1",) and model.centers.tolist() == [[2, 3, 4]]
    assert (model.T_world_camera[0, :3, 0] == [0, 1, 0]).all()  # its x axis


@pytest.mark.parametrize("what", ["chunk", "component"])
def test_chunk_and_component_transforms_apply_to_cameras(tmp_path, what):
    component = f"<components><component id='7'>{TRANSFORM}</component></components>"
    text = document(camera(more="component_id='7'"), more=TRANSFORM if what == "chunk" else component)
    model = read(tmp_path, text)
    assert model.centers[0].tolist() == pytest.approx([10 + 2 * 4, 20 + 2 * 2, 30 + 2 * 3])
    assert model.T_world_camera[0, :3, 0].tolist() == pytest.approx([0, 0, 1])
    assert np.linalg.det(model.T_camera_world[0, :3, :3]) == pytest.approx(1)


def test_a_component_counts_above_the_chunk_and_only_for_its_own_cameras(tmp_path):
    more = f"<components><component id='7'>{TRANSFORM}</component></components><transform><scale>5</scale></transform>"
    cameras = camera("a", more="component_id='7'") + camera("b", more="component_id='8'")
    model = read(tmp_path, document(cameras, more=more))
    assert model.centers[0].tolist() == pytest.approx([18, 24, 36])
    assert model.centers[1].tolist() == pytest.approx([10, 15, 20])


def test_cameras_without_a_pose_are_reported(tmp_path):
    cameras = "<group id='0'>" + camera("in a group") + "</group>"
    cameras += camera("lost", None) + camera("off", more="enabled='false'") + camera("old", more="enabled='0'")
    cameras += camera("right eye", None, more="master_id='0'")
    model = read(tmp_path, document(cameras))
    assert model.names == ("in a group",)
    expected = ("lost: not aligned", "off: disabled", "old: disabled", "right eye: of a multi-camera system")
    assert model.left_out == expected


@pytest.mark.parametrize(
    ("kind", "terms", "model"),
    [
        ("frame", {}, "SIMPLE_PINHOLE"),
        ("frame", {"b1": 3}, "PINHOLE"),
        ("frame", {"k1": -0.1}, "SIMPLE_RADIAL"),
        ("frame", {"k1": -0.1, "k2": 0.02}, "RADIAL"),
        ("frame", {"k1": -0.1, "b1": 3}, "OPENCV"),
        ("frame", {"k1": -0.1, "p1": 1e-3, "p2": -2e-3}, "OPENCV"),
        ("frame", {"k1": -0.1, "k3": 0.01, "p1": 1e-3, "b1": 2}, "FULL_OPENCV"),
        ("frame", {"k1": -0.1, "k4": 0.01, "p1": 1e-3}, "METASHAPE"),
        ("frame", {"k1": -0.1, "b2": 0.5}, "METASHAPE"),
        ("fisheye", {"k1": 0.02, "k4": 0.001, "b1": 2}, "OPENCV_FISHEYE"),
        ("fisheye", {"k1": 0.02, "p1": 1e-3, "p2": -2e-3, "k4": 1e-3}, "THIN_PRISM_FISHEYE"),
        ("equidistant_fisheye", {"k1": 0.02, "b2": 0.5, "p1": 1e-3}, "METASHAPE_FISHEYE"),
    ],
)
def test_lens_becomes_the_simplest_equivalent_model(tmp_path, kind, terms, model):
    values = {"f": 500.0, "cx": 1.5, "cy": -2.25, **terms}
    lens = "".join(f"<{name}>{value}</{name}>" for name, value in values.items())
    result = read(tmp_path, document(camera(), sensor(lens, kind=kind))).cameras[0]
    assert result.model == model
    x, y = 0.3, -0.2
    if kind != "frame":
        r = np.hypot(x, y)
        x, y = x * np.arctan(r) / r, y * np.arctan(r) / r
    v = {name: values.get(name, 0.0) for name in ("f", "cx", "cy", "k1", "k2", "k3", "k4", "p1", "p2", "b1", "b2")}
    r2 = x * x + y * y
    radial = 1 + v["k1"] * r2 + v["k2"] * r2**2 + v["k3"] * r2**3 + v["k4"] * r2**4
    xd = x * radial + v["p1"] * (r2 + 2 * x * x) + 2 * v["p2"] * x * y
    yd = y * radial + v["p2"] * (r2 + 2 * y * y) + 2 * v["p1"] * x * y
    expected = [320 + v["cx"] + xd * v["f"] + xd * v["b1"] + yd * v["b2"], 240 + v["cy"] + yd * v["f"]]
    assert (result.project([[0.3, -0.2, 1.0]])[0] + 0.5).tolist() == pytest.approx(expected, abs=1e-9)


def test_initial_calibration_is_used_if_none_was_adjusted(tmp_path):
    lens = "<resolution width='640' height='480'/><calibration class='initial'><f>700</f></calibration>"
    model = read(tmp_path, document(camera(), f"<sensor id='0'>{lens}</sensor>"))
    assert model.cameras[0].params[0] == 700


BOMB = "<!DOCTYPE d [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>]><document>&b;</document>"
LEAK = "<!DOCTYPE d [<!ENTITY a SYSTEM 'file:///etc/hostname'>]><document>&a;</document>"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (BOMB, "declares a document type"),
        (LEAK, "declares a document type"),
        ("<a>" * 1000, "more than 64 elements"),
        ("nothing", "line 1, column 0.*no XML|no XML"),
        ("<?xml version='1.0' encoding='none-such'?><document/>", "no XML|not read"),
        ("<document><chunk/><chunk/></document>", "got 2 chunks"),
        (document(camera(pose=None)), r"no aligned camera \(1 are disabled or not aligned\)"),
        (document(camera() + camera()), "'IMG_1' is duplicated.*label of its own"),
        (document(camera(pose=POSE.replace("2", "nan"))), "expected 16 finite numbers"),
        (document(camera(), more="<transform><scale>0</scale></transform>"), "the scale of the chunk is 0"),
        (document(camera(), more=f"<transform><rotation>{'1 ' * 9}</rotation></transform>"), "rotation of the chunk"),
        (document(camera(), sensors=""), "sensor '0', which is missing"),
        (document(camera(), "<sensor id='0'/>"), "sensor 0.*no calibration"),
        (document(camera(), sensor("<f>5</f>", kind="equisolid_fisheye")), "lens is 'equisolid_fisheye'"),
        (document(camera(), sensor("<f>5</f><p3>0.1</p3>")), "p3 is not supported"),
        (document(camera(), sensor("<f>x</f>")), "f of sensor 0: expected 1 finite"),
        (document(camera(), sensor("<cx>1</cx>")), "focal lengths above"),
        (document(camera(), sensor("<f>5</f>", resolution="width='6e2' height='4'")), "resolution .*, got '6e2'"),
        (document(camera(), re.sub("<resolution[^>]*>", "", sensor("<f>5</f>"))), r"\(sensor 0\): has no resolution"),
        (document("<camera id='0' label='a'><transform>1</transform></camera>"), "has no sensor_id"),
    ],
)
def test_files_that_are_not_camera_exports_are_rejected(tmp_path, text, message):
    with pytest.raises(loom.FileError, match=message):
        read(tmp_path, text)


def test_exports_of_too_many_bytes_are_not_parsed(tmp_path, monkeypatch):
    text = document(camera())
    assert len(read(tmp_path, text)) == 1
    monkeypatch.setattr(metashape, "MAX_XML_BYTES", len(text) - 1)
    with pytest.raises(FileError, match=f"has {len(text):,} bytes; expected at most {len(text) - 1:,}"):
        read(tmp_path, text)


MODEL = ring_model()


def reprojections(model: loom.SfmModel) -> np.ndarray:
    seen = np.empty_like(model.pixels)
    for i, camera in enumerate(model.cameras):
        rows = model.observations[:, 0] == i
        T = model.T_camera_world[i]
        seen[rows] = camera.project(model.points[model.observations[rows, 1]] @ T[:3, :3].T + T[:3, 3])
    return seen


def test_images_are_sorted_by_name_with_all_that_belongs_to_them():
    order = [3, 1, 5, 0, 4, 2]
    rows = np.column_stack([np.argsort(order)[MODEL.observations[:, 0]], MODEL.observations[:, 1]])
    images = [MODEL.names[i] for i in order], [MODEL.cameras[i] for i in order], MODEL.T_camera_world[order]
    points = MODEL.points, MODEL.colors, MODEL.errors
    shuffled = loom.SfmModel(*images, *points, rows[::-1], MODEL.pixels[::-1])
    assert shuffled.names == tuple(sorted(MODEL.names))
    assert_same(shuffled, MODEL)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 37.0, 1e6])
@pytest.mark.parametrize("far", [0.0, 5e6])
def test_a_moved_model_is_seen_as_before(scale, far):
    T = np.eye(4)
    T[:3, :3] = scale * MODEL.T_camera_world[2, :3, :3]
    T[:3, 3] = [far, -far, 3.0]
    moved = MODEL.transform(T)
    assert np.abs(moved.centers - (MODEL.centers @ T[:3, :3].T + T[:3, 3])).max() <= 1e-9 * max(scale, far, 1)
    slack = 1e-9 + 1e-12 * far / scale
    assert np.abs(reprojections(moved) - reprojections(MODEL)).max() < 500 * slack
    R = moved.T_camera_world[:, :3, :3]
    assert np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max() < 1e-13


def test_centers_follow_from_poses_and_scaling_is_inverted_by_the_inverse_scale():
    for center, T in zip(MODEL.centers, MODEL.T_camera_world, strict=True):
        assert np.abs(T[:3, :3] @ center + T[:3, 3]).max() < 1e-14
    assert np.abs(MODEL.T_world_camera @ MODEL.T_camera_world - np.eye(4)).max() < 1e-14
    assert_same(MODEL.scaled(8.0).scaled(0.125), MODEL)
    larger = MODEL.scaled(2.0)
    assert np.array_equal(larger.centers, 2 * MODEL.centers) and np.array_equal(larger.points, 2 * MODEL.points)
    assert np.array_equal(larger.pixels, MODEL.pixels)


def test_selected_images_keep_their_observed_points():
    names = [MODEL.names[4], MODEL.names[1]]
    part = MODEL.select(names)
    assert part.names == tuple(sorted(names))
    assert np.array_equal(np.unique(part.observations[:, 1]), np.arange(len(part.points)))
    selected = np.isin(MODEL.observations[:, 0], [1, 4])
    assert np.array_equal(part.points[part.observations[:, 1]], MODEL.points[MODEL.observations[selected, 1]])
    assert np.array_equal(reprojections(part), reprojections(MODEL)[selected]) and len(MODEL.select([])) == 0


def test_poses_go_out_as_a_trajectory(tmp_path):
    for name in ("poses.log", "poses.tum", "poses.kitti"):
        loom.write_trajectory(tmp_path / name, MODEL.trajectory())
        back = loom.read_trajectory(tmp_path / name)
        assert np.abs(back.poses - MODEL.T_world_camera).max() < 1e-14
    times = np.arange(6) / 30
    loom.write_trajectory(tmp_path / "times.tum", MODEL.trajectory(times))
    assert np.array_equal(loom.read_trajectory(tmp_path / "times.tum").timestamps, times)
    assert loom.read_trajectory(tmp_path / "poses.log").ids[:, 0].tolist() == list(range(6))


def test_points_go_out_as_a_cloud(tmp_path):
    cloud = MODEL.point_cloud()
    loom.write_point_cloud(tmp_path / "sparse.ply", cloud)
    back = loom.read_point_cloud(tmp_path / "sparse.ply")
    assert np.abs(back.points - MODEL.points).max() < 1e-6 and np.array_equal(np.round(back.colors * 255), MODEL.colors)
    assert np.array_equal(back["views"], MODEL.view_counts)
    assert np.array_equal(back["error"], MODEL.errors.astype(np.float32), equal_nan=True)
    assert len(ring_model(2, 0).point_cloud().points) == 0


def test_model_is_immutable_copies_its_arguments_and_survives_pickling():
    with pytest.raises(ValueError, match="read-only"):
        MODEL.points[0] = 0
    points = np.zeros((1, 3))
    model = loom.SfmModel(["a"], [LENS], np.eye(4)[None], points)
    points[0] = 7
    assert model.points[0].tolist() == [0, 0, 0]
    for other in (pickle.loads(pickle.dumps(MODEL)), copy.deepcopy(MODEL)):
        assert_same(other, MODEL)


def test_image_index_is_looked_up_by_name():
    assert [MODEL.index_of(name) for name in MODEL.names] == list(range(6))
    with pytest.raises(KeyError, match="did you mean"):
        MODEL.index_of("left/0.png")


def good(**changed):
    fields = {"names": ["a", "b"], "cameras": [LENS] * 2, "T_camera_world": np.tile(np.eye(4), (2, 1, 1))}
    fields |= {"points": np.zeros((3, 3)), "observations": [[0, 2]], "pixels": [[1.0, 2.0]], **changed}
    return fields


@pytest.mark.parametrize(
    ("changed", "kind", "message"),
    [
        ({"names": ["a", "a"]}, ValueError, "names: 'a' is duplicated"),
        ({"names": ["a", 1]}, TypeError, "names"),
        ({"names": ["b", ""]}, ValueError, "names: expected a name for every image, got an empty one"),
        (
            {"colors": np.zeros((2, 3), np.uint8)},
            ValueError,
            r"colors: expected shape \[3, 3\] as there are 3 points, got",
        ),
        (
            {"pixels": [[1, 2], [3, 4]]},
            ValueError,
            r"pixels: expected shape \[1, 2\], one per row of observations, got 2",
        ),
        ({"cameras": [LENS]}, ValueError, "cameras: expected 2, one per image, got 1"),
        ({"cameras": [LENS, LENS.params]}, TypeError, "cameras: expected CameraModels"),
        ({"T_camera_world": np.tile(2 * np.eye(4), (2, 1, 1))}, ValueError, r"T_camera_world\[0\]"),
        ({"T_camera_world": [np.eye(4), np.diag([1, 1, -1, 1])]}, ValueError, r"T_camera_world\[1\]"),
        ({"points": [[0, 0, np.nan]] * 3}, ValueError, "points: expected finite"),
        ({"colors": np.zeros((3, 3))}, TypeError, "colors: expected uint8"),
        ({"errors": [0.0, -1.0, 0.0]}, ValueError, "errors"),
        ({"observations": [[-1, 0]]}, ValueError, "row 0"),
        ({"observations": [[0.0, 1.0]]}, TypeError, "whole numbers"),
        ({"pixels": None}, ValueError, "pixels: expected one per row"),
        ({"pixels": [[np.nan, 0]]}, ValueError, "pixels: expected finite"),
        ({"observations": None}, ValueError, "pixels: given without observations"),
        ({"left_out": "text"}, TypeError, "left_out"),
    ],
)
def test_inconsistent_arguments_are_rejected(changed, kind, message):
    loom.SfmModel(**good())
    with pytest.raises(kind, match=message):
        loom.SfmModel(**good(**changed))


def test_invalid_scales_and_similarities_are_rejected():
    for factor in (0, -1, np.nan, np.inf, 1e31):
        with pytest.raises(ValueError, match="factor"):
            MODEL.scaled(factor)
    for T in (np.diag([1, 2, 1, 1.0]), np.diag([1, 1, -1, 1.0]), np.full((4, 4), np.nan), np.diag([1e31] * 3 + [1])):
        with pytest.raises(ValueError, match="transformation"):
            MODEL.transform(T)


CAMERA = PinholeCameraIntrinsic.prime_sense_default()
FORMATS = [("tum", "t.txt"), ("kitti", "t.txt"), *((name, f"t.{name}") for name in ("log", "tum", "kitti", "json"))]


def rotations(generator, count):
    """Random rotations, including rotations by 180 degrees, for which a quaternion has w = 0."""
    q = generator.normal(size=(count, 4))
    q[:3] = [[1, 0, 0, 0], [0, 1, 0, 1e-9], [0.6, 0.8, 0, 0]]
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    R = []
    for vx, vy, vz, w in q:
        K = np.array([[0, -vz, vy], [vz, 0, -vx], [-vy, vx, 0]])
        R.append(np.eye(3) + 2 * w * K + 2 * K @ K)
    return np.array(R)


@pytest.fixture
def made() -> Trajectory:
    generator = np.random.default_rng(0)
    poses = np.tile(np.eye(4), (12, 1, 1))
    poses[:, :3, :3] = rotations(generator, 12)
    poses[:, :3, 3] = generator.normal(size=(12, 3)) * (1, 10, 100)
    ids = np.stack([np.arange(12) * 3, np.arange(12), np.full(12, 99)], axis=1)
    return Trajectory(poses, timestamps=1305031102.175304 + np.arange(12) / 30, ids=ids)


def log_text(pose=None, ids="0 0 1") -> str:
    rows = np.eye(4) if pose is None else pose
    return f"{ids}\n" + "".join(" ".join(map(repr, row.tolist())) + "\n" for row in rows)


def json_text(*cameras) -> str:
    return json.dumps({"class_name": "PinholeCameraTrajectory", "parameters": cameras})


@pytest.mark.parametrize(("format", "name"), FORMATS)
def test_round_trip(tmp_path, made, format, name):
    write_trajectory(tmp_path / name, made, format=format, intrinsic=CAMERA)
    again = read_trajectory(tmp_path / name)
    np.testing.assert_allclose(again.poses, made.poses, rtol=0, atol=1e-12)
    if format in ("log", "kitti"):
        assert np.array_equal(again.poses, made.poses)
    assert (again.timestamps is not None) == (format == "tum") and (again.ids is not None) == (format == "log")
    if again.timestamps is not None:
        assert np.array_equal(again.timestamps, made.timestamps)
    if again.ids is not None:
        assert np.array_equal(again.ids, made.ids)


def test_real_logs_are_read_in_full(real_file):
    assert len(read_trajectory(real_file("rgbd-cupoch-redwood5/trajectory.log"))) == 5
    odometry = read_trajectory(real_file("rgbd-cupoch-redwood5/odometry.log"))
    assert odometry.poses[0, :3, 3].tolist() == [2, 2, -0.3]
    pairs = read_trajectory(real_file("reg-3dmatch-logs/configs/benchmarks/3DMatch/7-scenes-redkitchen/gt.log"))
    assert pairs.ids is not None and pairs.ids[1].tolist() == [0, 2, 60]


def test_tum_quaternions_are_x_y_z_w_and_camera_to_world(tmp_path):
    path = tmp_path / "groundtruth.txt"
    path.write_text("# a comment\n\n7.5 1 2 3 0 0 0.7071 0.7071\n")
    trajectory = read_trajectory(path)
    assert trajectory.timestamps is not None and trajectory.timestamps.tolist() == [7.5]
    expected = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]
    np.testing.assert_allclose(trajectory.poses[0], expected, atol=1e-12)


def test_missing_times_and_ids_are_counted_as_open3d_does(tmp_path):
    plain = Trajectory(np.tile(np.eye(4), (3, 1, 1)))
    write_trajectory(tmp_path / "t.log", plain)
    write_trajectory(tmp_path / "t.tum", plain)
    ids, times = read_trajectory(tmp_path / "t.log").ids, read_trajectory(tmp_path / "t.tum").timestamps
    assert ids is not None and ids.tolist() == [[0, 0, 1], [1, 1, 2], [2, 2, 3]]
    assert times is not None and times.tolist() == [0, 1, 2]


def test_rounded_rotations_are_unchanged_and_in_tum_the_nearest_rotation(tmp_path):
    rounded = np.eye(4)
    rounded[0, 0] = 0.995
    (tmp_path / "t.log").write_text(log_text(rounded))
    assert np.array_equal(read_trajectory(tmp_path / "t.log").poses[0], rounded)
    rounded[:3, :3] = 1.004 * np.eye(3)
    write_trajectory(tmp_path / "t.tum", Trajectory(rounded[None]))
    np.testing.assert_allclose(read_trajectory(tmp_path / "t.tum").poses[0], np.eye(4), atol=1e-12)


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("t.log", "# nothing\n", "contains no pose"),
        ("t.log", log_text() + "1 1 2\n1 0 0 0\n", "line 7): ends within a pose"),
        ("t.log", log_text(ids="0 0 1.5"), "line 1): expected three integers"),
        ("t.log", log_text() + log_text(np.diag([2.0, 1, 1, 1])), "line 7): pose: expected a rigid motion"),
        ("t.log", log_text().replace("1.0", "nan"), "line 2): expected finite"),
        ("t.log", log_text().replace("1.0", "one"), "line 2): not a number"),
        ("t.log", log_text().replace("1.0 0.0", "1.0", 1), "line 2): expected 4 numbers, got 3"),
        ("t.txt", "1 2 3 4\n", "line 1): expected 8 columns (TUM) or 12 (KITTI), got 4"),
        ("t.txt", "0 0 0 0 0 0 0 0\n", "length 0"),
        ("t.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 2 0 0 0 0 1 0\n", "line 2): pose: expected a rigid"),
        ("t.json", "{}", "key class_name): missing"),
        ("t.json", json_text().replace("PinholeCameraTrajectory", "PoseGraph"), "got 'PoseGraph'"),
        ("t.json", json_text(), "at least one camera"),
        ("t.json", json_text(3), "key parameters[0]"),
        ("t.json", json_text({"extrinsic": [1, 2]}), "extrinsic): expected a list of 16 numbers, got 2"),
        # digits, blanks and line ends of ASCII
        ("t.tum", "\uff11 0 0 0 0 0 0 1\n", "line 1"),
        ("t.tum", "1 0 0 0 0 0 0 1\n\u2028\n2 0 0 0 0 0 0 1\n", "line 2"),
        ("t.tum", "1 0 0 0 0 0 0 1\x1c2 0 0 0 0 0 0 1\n", "line 1"),
        ("t.log", log_text(ids="\uff10 0 1"), "expected three integers before a pose"),
        ("t.dat", "1", "unknown trajectory format '.dat'"),
        ("t.log", b"\xff", "not a text file"),
    ],
)
def test_bad_files_are_refused_with_the_line(tmp_path, name, text, message):
    (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(FileError) as caught:
        read_trajectory(tmp_path / name)
    assert message in str(caught.value) and name in str(caught.value)


def test_pose_file_has_four_rows(tmp_path):
    path = tmp_path / "frame.pose.txt"
    path.write_text("1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n")
    assert read_pose(path)[:3, 3].tolist() == [5, 6, 7]
    path.write_text("1 0 0 5\n0 1 0 6\n0 0 1 7\n")
    with pytest.raises(FileError, match=r"/frame\.pose\.txt:.*4.*3"):
        read_pose(path)


def test_writing_refuses_before_it_touches_the_file(tmp_path, made):
    path = tmp_path / "t.json"
    path.write_text("precious")
    with pytest.raises(ValueError, match="intrinsic"):
        write_trajectory(path, made)
    with pytest.raises(FileError, match="exists already"):
        write_trajectory(path, made, intrinsic=CAMERA, overwrite=False)
    skewed = Trajectory(made.poses * 1.0)
    skewed.poses[7, 0, 0] += 1
    with pytest.raises(ValueError, match=r"poses\[7\]"):
        write_trajectory(path, skewed, intrinsic=CAMERA)
    with pytest.raises(ValueError, match=r"^trajectory:"):
        write_trajectory(path, Trajectory(np.empty((0, 4, 4))), intrinsic=CAMERA)
    assert path.read_text() == "precious" and len(list(tmp_path.iterdir())) == 1


def test_formats_and_names_must_agree(tmp_path, made):
    for more in ({}, {"format": "log"}):
        with pytest.raises(FileError, match=r"/t\.txt:"):
            write_trajectory(tmp_path / "t.txt", made, **more)
    with pytest.raises(ValueError, match="format:"):
        write_trajectory(tmp_path / "t.txt", made, format="euroc")
    assert not list(tmp_path.iterdir())


def test_trajectory_iterates_over_poses_and_checks_shapes(made):
    for wrong in ({"poses": np.eye(4)}, {"timestamps": [1, 2]}, {"ids": [[0.5, 1, 2]]}, {"ids": [[0], [1]]}):
        with pytest.raises(ValueError, match=f"{next(iter(wrong))}: expected"):
            Trajectory(**{"poses": np.eye(4)[None]} | wrong)
    assert np.array_equal(made[-1], made.poses[-1]) and np.array_equal(list(made), made.poses)
