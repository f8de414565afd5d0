"""RGB-D frames from recordings written by rosbags: encodings, pairing by time, cameras, damage."""

import io
import json
import struct

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.io.frames.rgbd_sources import RGBDSource

pytest.importorskip("rosbags")

from rosbags import rosbag1, rosbag2
from rosbags.typesys import Stores, get_typestore

HEIGHT, WIDTH = 12, 16
PICTURES = ("sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage")
K = [20.0, 0, 7.5, 0, 21.0, 5.5, 0, 0, 1]
DEPTH_TOPIC, COLOR_TOPIC, INFO = "/cam/depth/image_raw", "/cam/color/image_raw", "/cam/depth/camera_info"


def depth_of(frame):
    depth = (1000 + 10 * np.arange(HEIGHT * WIDTH).reshape(HEIGHT, WIDTH) + frame).astype(np.uint16)
    depth[0, 0] = 0
    return depth


def color_of(frame):
    return np.random.default_rng(frame).integers(0, 256, (HEIGHT, WIDTH, 3)).astype(np.uint8)


def png(array):
    file = io.BytesIO()
    Image.fromarray(array).save(file, "PNG")
    return file.getvalue()


class Writer:
    """A ROS 1 or 2 recording that is written message by message."""

    def __init__(self, folder, form="mcap"):
        self.is_one = form == "bag1"
        self.store = get_typestore(Stores.ROS1_NOETIC if self.is_one else Stores.ROS2_HUMBLE)
        self.path = folder / ("run.bag" if self.is_one else "run")
        storage = {} if self.is_one else {"version": 9, "storage_plugin": rosbag2.StoragePlugin.MCAP}
        self.writer = (rosbag1 if self.is_one else rosbag2).Writer(self.path, **storage)
        self.connections = {}

    def __enter__(self):
        self.writer.open()
        return self

    def __exit__(self, *_):
        self.writer.close()

    def header(self, time, frame):
        types = self.store.types
        stamp = types["builtin_interfaces/msg/Time"](sec=int(time), nanosec=round((time - int(time)) * 1e9))
        kind = types["std_msgs/msg/Header"]
        return kind(seq=0, stamp=stamp, frame_id=frame) if self.is_one else kind(stamp, frame)

    def send(self, topic, kind, time, *values, frame="camera"):
        if topic not in self.connections:
            self.connections[topic] = self.writer.add_connection(topic, kind, typestore=self.store)
        message = self.store.types[kind](self.header(time, frame), *values)
        encode = self.store.serialize_ros1 if self.is_one else self.store.serialize_cdr
        self.writer.write(self.connections[topic], int(1e9 * (time + 0.05)), encode(message, kind))

    def image(self, topic, time, encoding, array, big=False, padding=0):
        rows = np.ascontiguousarray(array.astype(array.dtype.newbyteorder(">" if big else "<")))
        data = np.pad(rows.view(np.uint8).reshape(HEIGHT, -1), ((0, 0), (0, padding)))
        self.send(topic, PICTURES[0], time, HEIGHT, WIDTH, encoding, int(big), data.shape[1], data.reshape(-1))

    def packed(self, topic, time, form, data):
        self.send(topic, PICTURES[1], time, form, np.frombuffer(data, np.uint8))

    def info(self, topic=INFO, k=K, d=(0.0,) * 5, p=None):
        roi = self.store.types["sensor_msgs/msg/RegionOfInterest"](0, 0, 0, 0, False)
        P = np.array(p or [*k[:3], 0, *k[3:6], 0, *k[6:], 0], float)
        given = [HEIGHT, WIDTH, "plumb_bob", np.array(d), np.array(k, float), np.eye(3).ravel(), P, 0, 0, roi]
        self.send(topic, "sensor_msgs/msg/CameraInfo", 0.5, *given)


def write(folder, form="mcap", count=5, apart=0.004):
    with Writer(folder, form) as out:
        out.info()
        for i in range(count):
            out.image(DEPTH_TOPIC, 1 + 0.1 * i, "16UC1", depth_of(i))
            out.image(COLOR_TOPIC, 1 + 0.1 * i + apart, "rgb8", color_of(i))
    return out.path


def one_frame(folder, depth=None, color=None, *, info=None, **layout):
    """A recording of one frame; the layout is that of the color, or of the depth if there is none."""
    with Writer(folder) as out:
        out.info(**(info or {}))
        out.image(DEPTH_TOPIC, 1.0, *(depth or ("16UC1", depth_of(0))), **({} if color else layout))
        if color:
            out.image(COLOR_TOPIC, 1.0, *color, **layout)
    return loom.open_recording(out.path)


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_frames_have_camera_color_and_times(tmp_path, form):
    frames = loom.open_recording(write(tmp_path, form)).frames()
    camera = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 20.0, 21.0, 7.5, 5.5)
    assert (len(frames), frames.intrinsic, frames.depth_scale) == (5, camera, 1000)
    assert isinstance(frames, RGBDSource) and frames.intrinsic_source == INFO and frames.reliable
    for i, frame in enumerate(frames):
        np.testing.assert_array_equal(frame.depth, depth_of(i))
        np.testing.assert_array_equal(frame.color, color_of(i))
        assert frame.timestamp == pytest.approx(1 + 0.1 * i, abs=1e-9)
    np.testing.assert_array_equal(frames.read(-1).depth, depth_of(4))


@pytest.mark.parametrize(("encoding", "channels"), [
    ("rgb8", [0, 1, 2]), ("bgr8", [2, 1, 0]), ("8UC3", [2, 1, 0]), ("rgba8", [0, 1, 2, 0]), ("bgra8", [2, 1, 0, 0]),
])  # fmt: skip
@pytest.mark.parametrize("padding", [0, 3])
def test_colors_of_every_order_are_converted_to_rgb(tmp_path, encoding, channels, padding):
    recording = one_frame(tmp_path, color=(encoding, color_of(0)[:, :, channels]), padding=padding)
    np.testing.assert_array_equal(recording.frames().read(0).color, color_of(0))


@pytest.mark.parametrize("big", [False, True])
def test_depth_in_floats_is_metres(tmp_path, big):
    meters = (depth_of(0) / 1000).astype(np.float32)
    meters[1, 1] = np.nan
    frame = one_frame(tmp_path, ("32FC1", meters), big=big, padding=4).frames().read(0)
    np.testing.assert_array_equal(frame.depth, meters)
    assert frame.color is None


def test_packed_pictures_are_unpacked(tmp_path):
    a, b = 100.0, -20.0
    meters = depth_of(0) / 1000.0
    inverse = np.zeros((HEIGHT, WIDTH), np.uint16)
    inverse[meters > 0] = np.rint(a / meters[meters > 0] + b).astype(np.uint16)
    head = struct.pack("<iff", 0, a, b)
    with Writer(tmp_path) as out:
        out.info()
        out.info("/cam/float/camera_info")
        out.packed("/cam/depth/image_raw/compressedDepth", 1.0, "16UC1; compressedDepth png", head + png(depth_of(0)))
        out.packed("/cam/float/image_raw/compressedDepth", 1.0, "32FC1; compressedDepth png", head + png(inverse))
        out.packed("/cam/color/compressed", 1.0, "bgr8; png compressed bgr8", png(color_of(0)))
    recording = loom.open_recording(out.path)
    with pytest.raises(FileError, match=r"/run:.*2"):
        recording.frames()
    frame = recording.frames("/cam/depth/image_raw/compressedDepth").read(0)
    np.testing.assert_array_equal(frame.depth, depth_of(0))
    np.testing.assert_array_equal(frame.color, color_of(0))
    floats = recording.frames("/cam/float/image_raw/compressedDepth").read(0).depth
    assert floats.dtype == np.float32 and floats[0, 0] == 0
    np.testing.assert_allclose(floats, meters, rtol=0.02)


def test_pictures_pair_by_their_headers_and_the_rest_is_listed(tmp_path):
    with Writer(tmp_path) as out:
        out.info()
        for i in range(6):
            out.image(DEPTH_TOPIC, 1 + 0.1 * i, "16UC1", depth_of(i))
            if i != 3:
                out.image(COLOR_TOPIC, 1 + 0.1 * i + 0.015, "rgb8", color_of(i))
    recording = loom.open_recording(out.path)
    frames = recording.frames()
    assert len(frames) == 5 and len(frames.left_out) == 1 and "at 1.300000 s" in frames.left_out[0]
    np.testing.assert_array_equal(frames.read(3).color, color_of(4))
    assert len(recording.frames(every=2)) == 3
    with pytest.raises(FileError, match=r"/run:.*0\.001"):
        recording.frames(tolerance=0.001)


def test_distorted_depth_warns_and_rectified_images_use_p(tmp_path):
    with Writer(tmp_path) as out:
        out.info(d=(0.1, -0.2, 0, 0, 0), p=[30.0, 0, 8, 0, 0, 31.0, 6, 0, 0, 0, 1, 0])
        out.image(DEPTH_TOPIC, 1.0, "16UC1", depth_of(0))
        out.image("/cam/depth/image_rect", 1.0, "16UC1", depth_of(0))
    recording = loom.open_recording(out.path)
    raw, rect = recording.frames(DEPTH_TOPIC), recording.frames("/cam/depth/image_rect")
    assert "has a lens distortion (0.1, -0.2, 0, 0, 0) that is not corrected" in raw.warnings[0]
    assert (rect.intrinsic.fx, rect.intrinsic.cy, rect.warnings) == (30.0, 6.0, ())


def test_missing_or_empty_cameras_are_named(tmp_path):
    with Writer(tmp_path) as out:
        out.info("/other/camera_info")
        out.image(DEPTH_TOPIC, 1.0, "16UC1", depth_of(0))
    recording = loom.open_recording(out.path)
    with pytest.raises(FileError, match=r"/run:.*/cam/depth/camera_info.*/other/camera_info"):
        recording.frames()
    camera = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 20.0, 20.0, 7.5, 5.5)
    assert recording.frames(intrinsic=camera).read(0).depth.shape == (HEIGHT, WIDTH)
    folder = tmp_path / "more"
    folder.mkdir()
    with pytest.raises(FileError, match=r"/run:.*0.*0"):
        one_frame(folder, info={"k": [0.0] * 9}).frames()


@pytest.mark.parametrize(("encoding", "array", "words"), [
    ("bayer_rggb8", color_of(0)[:, :, 0], "images of encoding 'bayer_rggb8' are not supported"),
    ("rgb8", color_of(0)[:, :, 0], "rows of 16 bytes, but 16 pixels need 48"),
    ("rgb8", color_of(0)[:6], r"of 12 rows of 24 bytes|rows of 24 bytes, but 16 pixels"),
])  # fmt: skip
def test_inconsistent_images_are_rejected_with_their_frame(tmp_path, encoding, array, words):
    with pytest.raises(FileError, match=f"frame-000000: .*({words})"):
        one_frame(tmp_path, color=(encoding, array)).frames().read(0)


def test_recording_without_depth_is_an_error(tmp_path):
    with Writer(tmp_path) as out:
        out.image(COLOR_TOPIC, 1.0, "rgb8", color_of(0))
    recording = loom.open_recording(out.path)
    for topics in ([], ["/x"]):
        with pytest.raises(FileError, match="/run:"):
            recording.frames(*topics)
    for wrong in ({"tolerance": 0.0}, {"every": 0}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            recording.frames(**wrong)
    with pytest.raises(TypeError, match="intrinsic:"):
        recording.frames(intrinsic=3)


@pytest.mark.slow
def test_command_reads_a_recording_and_rejects_missing_topics(tmp_path):
    path = write(tmp_path, count=3)
    result = CliRunner().invoke(cli, ["track", str(path), "-o", str(tmp_path / "poses.tum"), "--depth-scale", "500"])
    assert result.exit_code == 1 and "is a recording, for which depth_scale is not an option" in result.output
    result = CliRunner().invoke(cli, ["track", str(path), "-o", str(tmp_path / "poses.tum"), "--json"])
    assert json.loads(result.stdout)["layout"] == "recording"
