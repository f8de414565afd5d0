"""Pinhole cameras: what is accepted, what is refused, and Open3D's JSON."""

import contextlib
import json
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.cameras.camera import (
    PinholeCameraIntrinsic,
    read_pinhole_camera_intrinsic,
    write_pinhole_camera_intrinsic,
)
from pointloom.core.errors import FileError

CAMERA = PinholeCameraIntrinsic(640, 480, 525.1, 525.25, 1 / 3, 239.5)
MATRIX = [525.1, 0, 0, 0, 525.25, 0, 320, 240, 1]


def store(path, content) -> str:
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    return str(path)


def test_matrix_is_a_copy_of_the_intrinsics():
    assert CAMERA.matrix.tolist() == [[525.1, 0, 1 / 3], [0, 525.25, 239.5], [0, 0, 1]]
    assert CAMERA.matrix.dtype == np.float64
    assert PinholeCameraIntrinsic.from_matrix(CAMERA.matrix, 640, 480) == CAMERA
    CAMERA.matrix[0, 0] = 1.0
    assert CAMERA.matrix[0, 0] == 525.1 and PinholeCameraIntrinsic(64, 48, 525, 525, -20.5, 100).cx == -20.5


def test_numpy_numbers_are_taken_as_plain_ones():
    camera = PinholeCameraIntrinsic(np.int64(640), np.uint16(480), np.float32(525), 525, np.int32(3), np.float64(4))
    assert [type(v) for v in (camera.width, camera.height, camera.fx, camera.cx)] == [int, int, float, float]


def test_impossible_values_are_refused_by_name():
    """NaN, infinities and what is no number: tests/pcd/test_hostile_arguments.py."""
    values = {"width": 640, "height": 480, "fx": 525.0, "fy": 525.0, "cx": 319.5, "cy": 239.5}
    for name, value in (("width", 0), ("height", -480), ("fx", 0.0), ("fy", -525.0), ("fy", np.inf), ("cy", -np.inf)):
        with pytest.raises(ValueError, match=name):
            PinholeCameraIntrinsic(**values | {name: value})
    for factor in (0, -1, 1e-4):
        with pytest.raises(ValueError, match="factor"):
            CAMERA.scaled(factor)


@pytest.mark.parametrize(
    ("index", "value", "claim"),
    [((0, 1), 0.5, "skew"), ((1, 0), 1e-3, "skew"), ((2, 2), 2.0, "last row"), ((0, 0), np.nan, "finite")],
)
def test_matrices_that_are_no_pinhole_are_refused(index, value, claim):
    K = CAMERA.matrix
    K[index] = value
    with pytest.raises(ValueError, match=claim):
        PinholeCameraIntrinsic.from_matrix(K, 640, 480)
    with pytest.raises(ValueError, match=r"shape \[3, 3\]"):
        PinholeCameraIntrinsic.from_matrix(np.eye(4), 640, 480)


def test_scaling_keeps_the_image_borders_fixed():
    """The corners (-0.5, -0.5) and (w - 0.5, h - 0.5) are seen along the same rays at every size."""
    for factor in (0.5, 0.25, 2.0, 1 / 3, 0.123):
        small = CAMERA.scaled(factor)
        for camera_u, small_u in ((-0.5, -0.5), (CAMERA.width - 0.5, small.width - 0.5)):
            ray, small_ray = (camera_u - CAMERA.cx) / CAMERA.fx, (small_u - small.cx) / small.fx
            assert small_ray == pytest.approx(ray, abs=1e-12)


def open3d_cameras(o3d):
    """Sizes and matrices of its three defaults."""
    kinds = o3d.camera.PinholeCameraIntrinsicParameters
    names = (kinds.PrimeSenseDefault, kinds.Kinect2DepthCameraDefault, kinds.Kinect2ColorCameraDefault)
    cameras = [o3d.camera.PinholeCameraIntrinsic(name) for name in names]
    return [(camera.width, camera.height, np.asarray(camera.intrinsic_matrix)) for camera in cameras]


def test_defaults_are_those_of_open3d(oracle):
    makers = ("prime_sense_default", "kinect2_depth_default", "kinect2_color_default")
    for maker, (width, height, matrix) in zip(makers, oracle("cameras/defaults", open3d_cameras), strict=True):
        camera = getattr(PinholeCameraIntrinsic, maker)()
        assert (camera.width, camera.height) == (width, height) and np.array_equal(camera.matrix, matrix)


def open3d_files(o3d):
    """What it writes for the camera, alone and with a pose, and the matrix that it reads from our file."""
    with tempfile.TemporaryDirectory() as folder:
        path, parameters = f"{folder}/camera.json", o3d.camera.PinholeCameraParameters()
        write_pinhole_camera_intrinsic(path, CAMERA)
        read = o3d.io.read_pinhole_camera_intrinsic(path)
        parameters.intrinsic, parameters.extrinsic = read, np.eye(4)
        o3d.io.write_pinhole_camera_intrinsic(path, read)
        alone = Path(path).read_text()
        o3d.io.write_pinhole_camera_parameters(path, parameters)
        return alone, Path(path).read_text(), np.asarray(read.intrinsic_matrix)


def test_files_round_trip_and_match_open3d(tmp_path, oracle):
    *texts, matrix = oracle("cameras/files", open3d_files)
    assert np.array_equal(matrix, CAMERA.matrix)
    write_pinhole_camera_intrinsic(tmp_path / "camera.json", CAMERA)
    for text in ((tmp_path / "camera.json").read_text(), *texts):
        assert read_pinhole_camera_intrinsic(store(tmp_path / "text.json", text)) == CAMERA


def test_metadata_of_a_recorder_does_no_harm(tmp_path):
    content = {"width": 640, "height": 480, "intrinsic_matrix": MATRIX, "serial_number": "7", "fps": 30.0}
    assert read_pinhole_camera_intrinsic(store(tmp_path / "intrinsic.json", content)).cx == 320


@pytest.mark.parametrize(
    ("content", "claim"),
    [
        ("", "line 1"),
        ("{\n\n]", "line 3"),
        ("[]", "expected a JSON object, got a list"),
        ("\xff\xfe", "JSON"),
        ({"width": 640, "height": 480}, "key intrinsic_matrix"),
        ({"width": 640, "height": 480, "intrinsic_matrix": MATRIX, "distortion": [0.1]}, "key distortion"),
        ({"width": 640, "height": 480, "intrinsic_matrix": MATRIX[:8]}, "9 numbers, got 8"),
        ({"width": 640, "height": 480, "intrinsic_matrix": [*MATRIX[:8], "1"]}, "finite numbers, got '1'"),
        ({"width": 640, "height": 480, "intrinsic_matrix": [525, 0, 320, 0, 525, 240, 0, 0, 1]}, "column by column"),
        ({"width": 640, "height": 480, "intrinsic_matrix": [525, 0, 0, 0.1, 525, 0, 320, 240, 1]}, "skew"),
        ({"width": 640, "height": 0, "intrinsic_matrix": MATRIX}, "height"),
        ('{"width": 640, "height": 480, "intrinsic_matrix": [NaN,0,0,0,5,0,3,2,1]}', "NaN"),
        ('{"width": 640, "height": 480, "intrinsic_matrix": [1e999,0,0,0,5,0,3,2,1]}', "1e999"),
        ('{"width": 640, "width": 641, "height": 480, "intrinsic_matrix": [5,0,0,0,5,0,3,2,1]}', "given twice"),
        ({"intrinsic": [1], "extrinsic": []}, "key intrinsic"),
        ({"intrinsic": {"width": 640}, "extrinsic": []}, "key intrinsic.height"),
    ],
)
def test_errors_of_bad_files_give_the_location(tmp_path, content, claim):
    path = store(tmp_path / "camera.json", content)
    with pytest.raises(FileError, match=r"camera\.json") as caught:
        read_pinhole_camera_intrinsic(path)
    assert claim in str(caught.value)


def test_missing_file_and_folder_are_file_errors(tmp_path):
    for path in (tmp_path / "none.json", tmp_path):
        with pytest.raises(FileError, match="cannot be read"):
            read_pinhole_camera_intrinsic(path)
    with pytest.raises(FileError, match=r"/camera\.json:"):
        write_pinhole_camera_intrinsic(tmp_path / "none" / "camera.json", CAMERA)


@settings(
    max_examples=100, derandomize=True, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(start=st.integers(0, 200), length=st.integers(0, 8), patch=st.binary(max_size=8))
def test_changed_bytes_give_a_camera_or_a_file_error(tmp_path, start, length, patch):
    path = tmp_path / "camera.json"
    write_pinhole_camera_intrinsic(path, CAMERA)
    data = path.read_bytes()
    path.write_bytes(data[:start] + patch + data[start + length :])
    with contextlib.suppress(FileError):
        assert isinstance(read_pinhole_camera_intrinsic(path), PinholeCameraIntrinsic)


def test_matrices_are_cameras_where_the_size_is_known():
    K, images = CAMERA.matrix, [(None, np.ones((480, 640), np.float32))]
    for matrix in (K, K.tolist()):
        assert loom.frames_from(images, matrix).intrinsic == CAMERA
        assert len(loom.PointCloud.create_from_depth_image(images[0][1], matrix, stride=40)) == 192
    for call in (
        lambda: loom.frames_from(iter(images), K),
        lambda: loom.rgbd.DenseSLAM(K),
        lambda: loom.View(K, np.eye(4)),
    ):
        with pytest.raises(TypeError, match=r"intrinsic.*PinholeCameraIntrinsic.from_matrix\(K, width, height\)"):
            call()
    with pytest.raises(ValueError, match="intrinsic: expected fx and fy in pixels"):
        loom.frames_from(images, np.eye(3))
