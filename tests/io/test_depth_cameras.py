"""Drivers of depth cameras, replaced by stubs: frames, calibration, and failures."""

import sys
from functools import partial

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import CameraError
from pointloom.io.frames.depth_cameras import LensMap, distort
from pointloom.io.frames.rgbd_sources import RGBDSource

from .camera_stubs import HEIGHT, WIDTH, K4ATimeoutException, KinectStub, RealSenseStub, color_of, depth_of

CAMERA = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 30.0, 30.0, 15.5, 11.5)


def plug_in(monkeypatch, module, make, *arguments, **options):
    stub = make(*arguments, **options)
    monkeypatch.setitem(sys.modules, module, stub)
    return stub


@pytest.fixture
def realsense(monkeypatch):
    return partial(plug_in, monkeypatch, "pyrealsense2", RealSenseStub)


@pytest.fixture
def kinect(monkeypatch):
    return partial(plug_in, monkeypatch, "pyk4a", KinectStub)


def test_missing_driver_is_named_with_its_installation(monkeypatch):
    for module, camera, extra in (
        ("pyrealsense2", loom.RealSenseCamera, "realsense"),
        ("pyk4a", loom.AzureKinectCamera, "azure-kinect"),
    ):
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(CameraError, match=rf"{module}.*pip install \"pointloom\[{extra}\]\""):
            camera()


def take(camera, count):
    return [frame for _, frame in zip(range(count), camera, strict=False)]


def test_realsense_frames_have_calibration_and_time(realsense):
    stub = realsense([1, 2, 3])
    with loom.RealSenseCamera(serial="0123", width=WIDTH, height=HEIGHT, rate=15) as camera:
        assert isinstance(camera, RGBDSource)
        assert (camera.intrinsic, camera.depth_scale) == (CAMERA, pytest.approx(4000, rel=1e-12))
        frames = take(camera, 3)
    assert not stub.running
    assert stub.calls[:3] == [
        ("enable_device", "0123"),
        ("enable_stream", "depth", WIDTH, HEIGHT, "z16", 15),
        ("enable_stream", "color", WIDTH, HEIGHT, "rgb8", 15),
    ]
    for i, frame in enumerate(frames, 1):
        assert np.array_equal(frame.depth, depth_of(i)) and np.array_equal(frame.color, color_of(i))
        assert frame.timestamp == pytest.approx(0.033 * i) and frame.T_world_camera is None
    assert [frame.name for frame in frames] == ["frame-000000", "frame-000001", "frame-000002"]


def test_frames_without_color_yet_are_passed_over(realsense):
    realsense(["late", 1])
    assert np.array_equal(take(loom.RealSenseCamera(), 1)[0].color, color_of(1))
    realsense(["late"])
    frame = take(loom.RealSenseCamera(color=False), 1)[0]
    assert frame.color is None and np.array_equal(frame.depth, depth_of(0))


def test_each_depth_map_is_paired_once_with_the_closest_color(realsense):
    """As from the driver: an image is repeated while it waits for the other camera."""
    realsense([(1, 1), (2, 1), (2, 2), (3, 2), (4, 3), (4, 4), (5, 5)])
    camera = loom.RealSenseCamera()
    pairs = [(frame.depth[0, 0] - 1000, frame.color[0, 0, 2]) for frame in take(camera, 5)]
    assert pairs == [(1, 1), (2, 2), (3, 2), (4, 4), (5, 5)] and (camera.dropped, camera.notes) == (0, [])


def test_a_frame_that_waits_for_its_color_is_not_lost_and_those_lost_by_the_driver_are_counted(realsense):
    realsense([1, (2, 1), RuntimeError("Device disconnected")])
    times = []
    with pytest.raises(CameraError, match="stopped after 2 frames: Device disconnected"):
        times.extend(frame.timestamp for frame in loom.RealSenseCamera())
    realsense([1, (2, 1)])
    assert len(list(loom.RealSenseCamera(file="walk.bag"))) == 2
    realsense([1, 2, 7, 8])
    camera = loom.RealSenseCamera()
    take(camera, 4)
    assert (camera.count, camera.dropped) == (4, 4)
    assert camera.notes == ["4 frames were lost before they reached the program"]


@pytest.mark.parametrize("last", ["silence", RuntimeError("Device disconnected")])
def test_realsense_failure_is_reported_after_the_last_complete_frame(realsense, last):
    stub = realsense([1, 2, last])
    camera, frames = loom.RealSenseCamera(timeout=0.5), []
    with pytest.raises(CameraError, match=r"nothing for 0.5 s after 2 frames|after 2 frames: Device disconn"), camera:
        for frame in camera:
            frames.append(frame)
    assert len(frames) == 2 and np.array_equal(frames[0].depth, depth_of(1))
    assert ("wait", 500) in stub.calls and not stub.running


def test_a_missing_realsense_and_a_lens_of_an_unknown_kind_are_refused(realsense):
    realsense([], start_error=RuntimeError("No device connected"))
    with pytest.raises(CameraError, match=r"No device connected\. Check the cable"):
        loom.RealSenseCamera()
    stub = realsense([1], model="ftheta", coefficients=(0.1, 0, 0, 0, 0))
    with pytest.raises(CameraError, match="ftheta"):
        loom.RealSenseCamera()
    assert not stub.running


@pytest.mark.parametrize("jpeg", [False, True])
def test_frames_of_a_kinect_recording_have_calibration_and_time(kinect, jpeg):
    stub = kinect(["late", 1, 2], jpeg=jpeg)
    with loom.AzureKinectCamera(file="walk.mkv") as camera:
        assert (camera.intrinsic, camera.depth_scale) == (CAMERA, 1000.0)
        frames = list(camera)
    assert stub.calls == ["walk.mkv"] and not stub.running
    assert [frame.timestamp for frame in frames] == pytest.approx([0.033, 0.066])
    for i, frame in enumerate(frames, 1):
        assert np.array_equal(frame.depth, depth_of(i))
        assert np.abs(frame.color.astype(int) - color_of(i)).max() <= (12 if jpeg else 0)


def test_kinect_failure_is_reported_after_the_last_complete_frame(kinect):
    stub = kinect([1, 2, "silence"])
    camera, frames = loom.AzureKinectCamera(number=1), []
    assert stub.calls[0][1] == 1 and stub.calls[0][0]["synchronized_images_only"]
    with pytest.raises(CameraError, match="stopped after 2 frames: K4ATimeoutException"), camera:
        for frame in camera:
            frames.append(frame)
    assert len(frames) == 2 and not stub.running


def test_a_kinect_that_is_not_there_is_an_error(kinect):
    kinect([], start_error=K4ATimeoutException())
    with pytest.raises(CameraError, match="no Azure Kinect 0 can be opened"):
        loom.AzureKinectCamera()
    kinect([])
    with pytest.raises(CameraError, match="contains no frame"):
        loom.AzureKinectCamera(file="empty.mkv")


def bent_scene(lens_coefficients):
    """Depth and color of a plane through a lens, and through a pinhole, at 160 x 120."""
    camera = loom.PinholeCameraIntrinsic(160, 120, 140.0, 140.0, 80.0, 59.0)
    v, u = np.mgrid[:120, :160].astype(float)
    x, y = (u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy
    k = np.zeros(8)
    k[: len(lens_coefficients)] = lens_coefficients
    ideal = np.stack([x, y])
    for _ in range(60):  # ideal position of each pixel of the lens
        ideal = ideal - (distort(ideal, k) - np.stack([x, y]))

    def scene(a, b):
        return (2000 + 400 * a + 300 * b).astype(np.uint16), (127 + 80 * np.sin(6 * a) * np.cos(5 * b)).astype(np.uint8)

    return camera, scene(*ideal), scene(x, y)


@pytest.mark.parametrize("lens", [(0.12, -0.2, 0.001, -0.002, 0.05), (0.5, -2.5, 3e-4, 1e-4, 1.5, 0.4, -2.3, 1.4)])
def test_depth_and_color_are_undistorted(lens):
    camera, (depth, gray), (straight_depth, straight_gray) = bent_scene(lens)
    lens = LensMap(camera, lens)
    assert lens.shift > 0.3
    got, color = lens.straighten_depth(depth), lens.straighten_color(np.dstack([gray] * 3))
    valid = got > 0
    assert valid.mean() > 0.9
    assert np.abs(got.astype(int) - straight_depth)[valid].max() <= 3  # half a pixel of slope
    assert np.abs(color[..., 1].astype(int) - straight_gray)[valid].max() <= 3


def test_inverse_distortion_inverts_the_model():
    camera = loom.PinholeCameraIntrinsic(160, 120, 140.0, 140.0, 80.0, 59.0)
    k = (0.1, -0.1, 0.001, 0.001, 0.02)
    lens = LensMap(camera, k, inverse=True)
    coordinates = np.stack([(lens.positions[0] - camera.cx) / camera.fx, (lens.positions[1] - camera.cy) / camera.fy])
    back = distort(coordinates, np.array([*k, 0, 0, 0]))
    v, u = np.mgrid[:120, :160]
    assert np.abs(back[0] * camera.fx + camera.cx - u).max() < 1e-6
    assert np.abs(back[1] * camera.fy + camera.cy - v).max() < 1e-6


def test_frames_of_a_distorting_camera_are_undistorted(kinect):
    kinect([1], coefficients=(0.3, -0.1, 0, 0, 0, 0, 0, 0))
    camera = loom.AzureKinectCamera(file="walk.mkv")
    frame = next(iter(camera))
    expected = LensMap(CAMERA, (0.3, -0.1, 0, 0, 0, 0, 0, 0))
    assert np.array_equal(frame.depth, expected.straighten_depth(depth_of(1)))
    assert np.array_equal(frame.color, expected.straighten_color(color_of(1)))
    assert not np.array_equal(frame.depth, depth_of(1))
