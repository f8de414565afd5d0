"""Cameras with known poses in several formats: phones, radiance fields, trajectories."""

import json

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError

# A camera at (1, 2, 3) that looks along the world's +x, its top toward the world's +y (ARKit: y is up).
LOOK = np.array([[0.0, 0, 1], [0, -1, 0], [1, 0, 0]])  # T_world_camera's rotation, x right, y down, z forward
ARKIT = np.array([[0.0, 0, -1, 1], [0, 1, 0, 2], [1, 0, 0, 3], [0, 0, 0, 1]])  # x right, y up, z back
SIZE = {"w": 64, "h": 48, "fl_x": 60.0, "fl_y": 61.0, "cx": 32.5, "cy": 24.0}
LENS = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)


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
        ({"fl_x": 10**400}, "too large"),
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
def test_transforms_without_a_size_take_that_of_the_picture(tmp_path, name, file):
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


def test_frames_of_the_scanner_app_take_their_size_from_the_picture(tmp_path):
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


def test_poses_are_of_the_pictures_with_their_times_or_numbers_or_in_natural_order(tmp_path):
    times = trajectory(tmp_path, "p.tum", timestamps=[5.0, 5.1, 5.2])
    numbers = trajectory(tmp_path, "p.log", ids=np.array([[4, 4, 5], [8, 8, 9], [12, 12, 13]]))
    plain = trajectory(tmp_path, "p.kitti")
    for path, expected, left_out in (
        (times, {"5.0.png": 0, "5.110.png": 1}, ["5.14.png"]),
        (numbers, {"f_4.png": 0, "f_8.png": 1}, ["f_5.png"]),
        (plain, {"f_2.png": 0, "f_9.png": 1, "f_10.png": 2}, []),
    ):
        model = loom.read_cameras(path, pictures=[*left_out, *expected][::-1], intrinsic=LENS)
        assert dict(zip(model.names, model.centers[:, 0].tolist(), strict=True)) == expected
        assert model.left_out == tuple(f"{name}: no pose" for name in left_out)
    with pytest.raises(FileError, match=r"/p\.kitti:.*3.*2"):
        loom.read_cameras(plain, pictures=["a.png", "b.png"], intrinsic=LENS)


def test_unknown_paths_and_a_missing_or_additional_lens_are_rejected(tmp_path):
    with pytest.raises(FileError, match=r"/cameras\.csv:"):
        loom.read_cameras(tmp_path / "cameras.csv")
    with pytest.raises(FileError, match="no supported cameras"):
        loom.read_cameras(tmp_path)
    with pytest.raises(FileError, match="no lens"):
        loom.read_cameras(trajectory(tmp_path, "p.kitti"), pictures=["a.png"])
    with pytest.raises(ValueError, match="intrinsic: "):
        loom.read_cameras(transforms(tmp_path), intrinsic=LENS)


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
    loom.write_transforms(tmp_path / "transforms.json", before, pictures="images")
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
    assert not list(tmp_path.iterdir())
