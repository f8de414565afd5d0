"""Recordings written by rosbags: scans, frames, transforms, motions and damage."""

import io
import json
import struct
import threading
from concurrent.futures import ThreadPoolExecutor
from time import sleep

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image
from scipy.spatial.transform import Rotation, Slerp

import pointloom as loom
from pointloom.cli.jobs.recorded_positions import read_positions
from pointloom.cli.shell.cli import cli
from pointloom.core.coordinate_systems import CoordinateSystem
from pointloom.core.errors import FileError
from pointloom.io.bags.clouds import table_of_livox
from pointloom.io.frames.rgbd_sources import RGBDSource

from .test_bags import CLOUD, cloud_message, points_of, write

pytest.importorskip("rosbags")

from rosbags import rosbag1, rosbag2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

HEIGHT, WIDTH = 12, 16
IMAGES = ("sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage")
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

    def write(self, topic, kind, time, message):
        if topic not in self.connections:
            self.connections[topic] = self.writer.add_connection(topic, kind, typestore=self.store)
        encode = self.store.serialize_ros1 if self.is_one else self.store.serialize_cdr
        self.writer.write(self.connections[topic], int(1e9 * time), encode(message, kind))

    def send(self, topic, kind, time, *values, frame="camera"):
        self.write(topic, kind, time + 0.05, self.store.types[kind](self.header(time, frame), *values))

    def image(self, topic, time, encoding, array, big=False, padding=0):
        rows = np.ascontiguousarray(array.astype(array.dtype.newbyteorder(">" if big else "<")))
        data = np.pad(rows.view(np.uint8).reshape(HEIGHT, -1), ((0, 0), (0, padding)))
        self.send(topic, IMAGES[0], time, HEIGHT, WIDTH, encoding, int(big), data.shape[1], data.reshape(-1))

    def packed(self, topic, time, form, data):
        self.send(topic, IMAGES[1], time, form, np.frombuffer(data, np.uint8))

    def info(self, topic=INFO, k=K, d=(0.0,) * 5, p=None):
        roi = self.store.types["sensor_msgs/msg/RegionOfInterest"](0, 0, 0, 0, False)
        P = np.array(p or [*k[:3], 0, *k[3:6], 0, *k[6:], 0], float)
        given = [HEIGHT, WIDTH, "plumb_bob", np.array(d), np.array(k, float), np.eye(3).ravel(), P, 0, 0, roi]
        self.send(topic, "sensor_msgs/msg/CameraInfo", 0.5, *given)


def write_frames(folder, form="mcap", count=5, apart=0.004):
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
    frames = loom.open_recording(write_frames(tmp_path, form)).frames()
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


def test_threads_read_the_frames_of_one_thread(tmp_path, monkeypatch):
    recording, in_use = loom.open_recording(write_frames(tmp_path, count=4)), threading.Lock()
    content_at = recording.content_at

    def read_alone(row):
        assert in_use.acquire(blocking=False), "the caches of a recording are for one thread"
        try:
            sleep(0.001)
            return content_at(row)
        finally:
            in_use.release()

    frames = recording.frames()
    monkeypatch.setattr(recording, "content_at", read_alone)
    with ThreadPoolExecutor(4) as pool:
        read = [*pool.map(frames.read, [*range(4)] * 3)]
    for number, frame in enumerate(read):
        np.testing.assert_array_equal(frame.depth, depth_of(number % 4))
        np.testing.assert_array_equal(frame.color, color_of(number % 4))


@pytest.mark.parametrize("big", [False, True])
def test_depth_in_floats_is_metres(tmp_path, big):
    meters = (depth_of(0) / 1000).astype(np.float32)
    meters[1, 1] = np.nan
    frame = one_frame(tmp_path, ("32FC1", meters), big=big, padding=4).frames().read(0)
    np.testing.assert_array_equal(frame.depth, meters)
    assert frame.color is None


def test_packed_images_are_unpacked(tmp_path):
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


def test_images_pair_by_their_headers_and_the_rest_is_listed(tmp_path):
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


PACKED = "/cam/depth/image_raw/compressedDepth"


@pytest.mark.parametrize(("packed", "change", "reason"), [
    (None, {"width": 0}, "frame-000000: an image of 0 x 12 pixels"),
    (None, {"data": np.zeros(9, np.uint8)}, "frame-000000: an image of 12 rows of 32 bytes has 9, not 384"),
    (None, {"step": 31}, "frame-000000: an image has rows of 31 bytes, but 16 pixels need 32"),
    (None, {"encoding": "rgb8"}, "frame-000000: an image of encoding 'rgb8' is not a depth map. Depth encodings are"),
    (None, {"height": 6, "data": np.zeros(192, np.uint8)}, r"depth: .* got \[6, 16\]. Give the intrinsic of these"),
    (b"RVL", {}, "frame-000000: depth packed as '32FC1; compressedDepth' is not a PNG. RVL is not supported"),
    (struct.pack("<iff", 0, 0, 1) + png(depth_of(0)), {}, "depth of floats packed with the numbers 0 and 1"),
    (struct.pack("<iff", 0, 1, np.inf) + png(depth_of(0)), {}, "depth of floats packed with the numbers 1 and inf"),
    (png(depth_of(0)), {}, "depth of floats packed with the numbers 0 and 0"),
])  # fmt: skip
def test_invalid_depth_messages_are_rejected_with_their_frame(tmp_path, monkeypatch, packed, change, reason):
    with Writer(tmp_path) as out:
        out.info()
        if packed is None:
            out.image(DEPTH_TOPIC, 1.0, "16UC1", depth_of(0))
        else:
            out.packed(PACKED, 1.0, "32FC1; compressedDepth", packed)
    recording = loom.open_recording(out.path)
    frames, content_at = recording.frames(), recording.content_at

    def changed(row):
        message = content_at(row)
        for name, value in change.items():
            setattr(message, name, value)
        return message

    monkeypatch.setattr(recording, "content_at", changed)
    with pytest.raises(FileError, match=reason):
        frames.read(0)


def test_a_depth_topic_without_headers_or_with_a_camera_of_no_size_is_rejected(tmp_path, monkeypatch):
    recording = one_frame(tmp_path)
    monkeypatch.setattr(recording, "bytes_at", lambda row: ("cdr", bytes(11)))
    with pytest.raises(FileError, match=f"/run: {DEPTH_TOPIC}: message 0 has no header"):
        recording.frames()
    monkeypatch.undo()
    content_at = recording.content_at

    def changed(row):
        message = content_at(row)
        if hasattr(message, "k"):
            message.width = 0
        return message

    monkeypatch.setattr(recording, "content_at", changed)
    with pytest.raises(FileError, match=r"/run: a camera_info is not a valid camera: width: .*\. Give intrinsic"):
        recording.frames()


def test_messages_of_an_unknown_type_are_an_error_with_its_name(tmp_path):
    kind = "my_robot/msg/Battery"
    with Writer(tmp_path) as out:
        out.store.register(get_types_from_msg("float32 charge\n", kind))
        out.write("/battery", kind, 1.0, out.store.types[kind](0.5))
    messages = loom.open_recording(out.path).messages("/battery")
    with pytest.raises(FileError, match=rf"/run:.*messages of {kind} are not supported"):
        next(messages)


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
    path = write_frames(tmp_path, count=3)
    result = CliRunner().invoke(cli, ["track", str(path), "-o", str(tmp_path / "poses.tum"), "--depth-scale", "500"])
    assert result.exit_code == 1 and "is a recording, for which --depth-scale is not an option" in result.output
    result = CliRunner().invoke(cli, ["track", str(path), "-o", str(tmp_path / "poses.tum"), "--json"])
    assert json.loads(result.stdout)["layout"] == "recording"


TF = "tf2_msgs/msg/TFMessage"
ROTATIONS = Rotation.from_rotvec(np.outer(np.linspace(0, 2.5, 6), [0.2, -0.1, 1.0]))
POSITIONS = np.stack([500_000 + np.arange(6.0), np.arange(6.0) ** 2, np.zeros(6)], axis=1)
MOUNT = ([0.5, 0.0, 1.2], Rotation.from_euler("zyx", [90, 5, -3], degrees=True).as_quat())


def send_tf(out, topic, time, parent, child, position, q):
    types = out.store.types
    if TF not in types:
        out.store.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms", TF))
    moved = types["geometry_msgs/msg/Transform"](vector(out.store, position), quaternion(out.store, q))
    stamped = types["geometry_msgs/msg/TransformStamped"](out.header(time, parent), child, moved)
    out.write(topic, TF, time + 0.05, types[TF]([stamped]))


def robot(folder, form="mcap", *, scan_times=(), frame="lidar"):
    """A base that moves in odom from 10 to 15 s, with a scanner."""
    with Writer(folder, form) as out:
        send_tf(out, "/tf_static", 9.0, "base_link", "/lidar" if form == "bag1" else "lidar", *MOUNT)
        for i in range(6):
            send_tf(out, "/tf", 10.0 + i, "odom", "base_link", POSITIONS[i], ROTATIONS[i].as_quat() * (-1) ** i)
        send_tf(out, "/tf", 10.0, "attic", "box", [0, 0, 0], [0, 0, 0, 1])
        for scan, time in enumerate(scan_times):
            message = cloud_message(out.store, "velodyne", scan)
            message.header = out.header(time, frame)
            out.write("/points", CLOUD, 11 + scan, message)
    return out.path


def pose(position, rotation):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation.as_matrix(), position
    return T


def true_pose(time):
    """T_odom_lidar, by SciPy's slerp."""
    position = [np.interp(time, 10 + np.arange(6), POSITIONS[:, k]) for k in range(3)]
    return pose(position, Slerp(10.0 + np.arange(6), ROTATIONS)(time)) @ pose(MOUNT[0], Rotation.from_quat(MOUNT[1]))


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_transforms_are_interpolated(tmp_path, form):
    tree = loom.open_recording(robot(tmp_path, form)).transforms()
    assert tree.frames == ["attic", "base_link", "box", "lidar", "odom"]
    assert tree.parents == {"base_link": "odom", "box": "attic", "lidar": "base_link"}
    assert tree.span("base_link") == (10.0, 15.0) and tree.span("lidar") is None
    times = np.array([10.0, 10.25, 12.9, 14.0, 15.0])
    result = tree.lookup("odom", "lidar", times)
    np.testing.assert_allclose(result, [true_pose(time) for time in times], rtol=0, atol=1e-9)
    back = tree.lookup("lidar", "odom", 12.9)
    np.testing.assert_allclose(back @ result[2], np.eye(4), rtol=0, atol=1e-9)
    np.testing.assert_array_equal(tree.lookup("odom", "odom", times), np.tile(np.eye(4), (5, 1, 1)))


def test_recordings_without_a_transform_are_named(tmp_path):
    with Writer(tmp_path) as out:
        out.store.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms", TF))
        out.write("/tf", TF, 1.0, out.store.types[TF]([]))
    with pytest.raises(FileError, match=r"/run: contains no transform"):
        loom.open_recording(out.path).transforms()


def test_undefined_lookups_are_named(tmp_path):
    tree = loom.open_recording(robot(tmp_path)).transforms()
    fixed = pose(MOUNT[0], Rotation.from_quat(MOUNT[1]))
    for time in ([], [1e9]):  # fixed frames need none
        np.testing.assert_allclose(tree.lookup("base_link", "lidar", *time), fixed, atol=1e-12)
    for wrong in (("odom", "lidar"), ("map", "lidar", 12.0)):
        with pytest.raises(FileError, match=r"/run:.*base_link"):
            tree.lookup(*wrong)
    with pytest.raises(FileError, match="/run:"):
        tree.lookup("box", "lidar", 12.0)
    for time in (9.999, 15.001, [12.0, 16.0]):
        with pytest.raises(FileError, match=r"/run:.*base_link.*10\.000000.*15\.000000"):
            tree.lookup("odom", "lidar", time)
    with pytest.raises(FileError, match="/run:"):
        tree.span("odom")
    for wrong in (None, 5, b"odom"):
        for ends, name in (((wrong, "lidar"), "target"), (("odom", wrong), "source")):
            with pytest.raises(TypeError, match=name):
                tree.lookup(*ends, 12.0)
        with pytest.raises(TypeError, match="frame"):
            tree.span(wrong)
    with pytest.raises(TypeError, match="time"):
        tree.lookup("odom", "lidar", "noon")
    for time in (np.nan, [[12.0]]):
        with pytest.raises(ValueError, match="time:"):
            tree.lookup("odom", "lidar", time)


def test_cycles_two_parents_and_invalid_transforms_are_named(tmp_path):
    still = ([0, 0, 0], [0, 0, 0, 1])
    cases = [("circle", [("a", "b", *still), ("b", "a", *still)]), ("two", [("a", "b", *still), ("c", "b", *still)])]
    cases += [("long", [("a", "b", [0, 0, 0], [0, 0, 0, 2])]), ("nan", [("a", "b", [np.nan, 0, 0], [0, 0, 0, 1])])]
    cases += [("self", [("a", "a", *still)]), ("nameless", [("", "b", *still)])]
    messages = ["a cycle", "b has the parents a and c", "no transform of b", "no transform of b", "'a' to 'a'", "to ''"]
    with Writer(tmp_path) as out:
        out.send("/t", "sensor_msgs/msg/FluidPressure", 1.0, 1.0, 0.0)
    with pytest.raises(FileError, match=r"/run:.*tf2_msgs/msg/TFMessage"):
        loom.open_recording(out.path).transforms()
    for (name, items), text in zip(cases, messages, strict=True):
        (tmp_path / name).mkdir()
        with Writer(tmp_path / name) as out:
            for item in items:
                send_tf(out, "/tf", 1.0, *item)
        with pytest.raises(FileError, match=text):
            loom.open_recording(out.path).transforms().lookup("a", "b", 1.0)


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_clouds_are_brought_into_a_frame_at_their_time(tmp_path, form):
    times = [10.5, 12.9]
    recording = loom.open_recording(robot(tmp_path, form, scan_times=times))
    for scan, cloud in enumerate(recording.scans(frame="odom")):
        T = true_pose(times[scan])
        np.testing.assert_allclose(cloud.points, points_of(scan) @ T[:3, :3].T + T[:3, 3], rtol=0, atol=1e-4)
        assert "time" in cloud.attributes
    for scan, cloud in enumerate(recording.scans(frame="lidar")):
        np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(scan))


def test_cloud_without_a_time_needs_static_transforms(tmp_path):
    recording = loom.open_recording(robot(tmp_path, scan_times=[0.0]))
    assert len(next(recording.scans(frame="base_link"))) == 240
    with pytest.raises(FileError, match="/run:"):
        next(recording.scans(frame="odom"))


def run(*arguments):
    return CliRunner().invoke(cli, [*map(str, arguments)])


def test_convert_writes_a_folder_of_scans_with_their_times(tmp_path):
    recording = robot(tmp_path, scan_times=[11.0, 12.5, 14.0])
    result = run("convert", recording, tmp_path / "scans", "--topic", "/points", "--json")
    assert result.exit_code == 0, result.output
    assert json.loads(result.output)["scans"] == 3
    names = sorted(path.name for path in (tmp_path / "scans").iterdir())
    assert names == ["000000.ply", "000001.ply", "000002.ply", "scans.json"]
    written = json.loads((tmp_path / "scans" / "scans.json").read_text())
    assert written == {"recording": "run", "topic": "/points", "frame": None, "times": [11.0, 12.5, 14.0]}
    cloud = loom.read_point_cloud(tmp_path / "scans" / "000002.ply")
    np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(2))
    again = run("convert", recording, tmp_path / "scans")
    assert again.exit_code == 1 and "exists already" in again.stderr
    assert run("convert", recording, tmp_path / "scans", "--force", "--frame", "odom").exit_code == 0


def test_convert_brings_scans_together_by_transforms_or_poses(tmp_path):
    times = [11.0, 12.5, 14.0]
    recording = robot(tmp_path, scan_times=times)
    alone = run("convert", recording, tmp_path / "all.ply")
    assert alone.exit_code == 1 and "3 scans, each in the frame of its sensor" in alone.stderr
    assert run("convert", recording, tmp_path / "all.ply", "--frame", "odom").exit_code == 0
    poses = np.array([true_pose(time) for time in times])
    expected = np.concatenate([points_of(k) @ T[:3, :3].T + T[:3, 3] for k, T in enumerate(poses)])
    points = loom.read_point_cloud(tmp_path / "all.ply").points
    np.testing.assert_allclose(points, expected, rtol=0, atol=1e-4)
    loom.write_trajectory(tmp_path / "poses.tum", loom.Trajectory(poses, timestamps=times))
    assert run("convert", recording, tmp_path / "b.ply", "--poses", tmp_path / "poses.tum").exit_code == 0
    np.testing.assert_allclose(loom.read_point_cloud(tmp_path / "b.ply").points, expected, rtol=0, atol=1e-4)
    loom.write_trajectory(tmp_path / "two.tum", loom.Trajectory(poses[:2], timestamps=times[:2]))
    short = run("convert", recording, tmp_path / "c.ply", "--poses", tmp_path / "two.tum")
    assert short.exit_code == 1 and "expected 3 poses" in short.stderr and not (tmp_path / "c.ply").exists()


def test_options_of_recordings_are_refused_with_other_files(tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points_of(0)))
    for option in (["--topic", "/points"], ["--frame", "odom"], ["--poses", tmp_path / "p.tum"]):
        result = run("convert", tmp_path / "a.ply", tmp_path / "b.ply", *option)
        assert result.exit_code == 2 and f"{option[0]} requires a recording" in result.stderr
    for option in (["--topic", "/points"], ["--frame", "odom"]):
        result = run("view", tmp_path / "a.ply", "--screenshot", tmp_path / "a.png", *option)
        assert result.exit_code == 1 and "is not a recording" in result.stderr
    (tmp_path / "frames").mkdir()
    result = run("track", tmp_path / "frames", "-o", tmp_path / "p.tum", "--topic", "/depth")
    assert result.exit_code == 1 and "is not a recording, so it has no topic '/depth'" in result.stderr


def test_missing_transform_of_a_scan_leaves_no_output(tmp_path):
    recording = robot(tmp_path, scan_times=[11.0, 20.0])
    scans = loom.open_recording(recording).scans("/points", frame="odom")
    next(scans)
    with pytest.raises(FileError, match=r"/run:.*1.*1.*20\.000000"):
        next(scans)
    for output in ("scans", "all.ply"):
        result = run("convert", recording, tmp_path / output, "--frame", "odom")
        assert result.exit_code == 1 and "not at 20.000000 s" in result.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["run"]


def test_view_draws_the_clouds_of_a_recording(tmp_path):
    recording = robot(tmp_path, scan_times=[11.0, 12.5])
    for name, option in (("one", []), ("all", ["--frame", "odom"])):
        page = tmp_path / f"{name}.html"
        result = run("view", recording, "--topic", "/points", *option, "--save-html", page, "--json")
        assert result.exit_code == 0 and page.exists(), result.output


@pytest.mark.filterwarnings("default::pointloom.io.bags.message_chunks.RecordingWarning")
def test_a_damaged_recording_ends_with_exit_code_3(tmp_path):
    recording = write(tmp_path, "bag1", count=20)
    assert run("info", recording).exit_code == 0
    data = recording.read_bytes()
    (tmp_path / "cut.bag").write_bytes(data[: len(data) * 6 // 10])
    result = run("info", tmp_path / "cut.bag", "--json")
    assert result.exit_code == 3 and "unreliable result" in result.stderr and "is cut off" in result.stderr
    assert json.loads(result.stdout)["files"][0]["damage"]
    assert run("info", tmp_path / "cut.bag", tmp_path / "missing.bag").exit_code == 1
    result = run("convert", tmp_path / "cut.bag", tmp_path / "scans", "--json")
    report = json.loads(result.stdout)
    assert result.exit_code == 3 and 0 < report["scans"] < 20 and "is cut off" in str(report["warnings"])
    assert len([*(tmp_path / "scans").glob("*.ply")]) == report["scans"]


def vector(store, values, kind="Vector3"):
    return store.types[f"geometry_msgs/msg/{kind}"](*map(float, values))


def quaternion(store, q):
    return store.types["geometry_msgs/msg/Quaternion"](*map(float, q))


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_readings_are_arrays_with_nan_for_missing_values(tmp_path, form):
    with Writer(tmp_path, form) as out:
        for i in range(20):
            none = np.array([-1.0, *[0.0] * 8]) if i < 5 else np.zeros(9)
            parts = [quaternion(out.store, [0, 0, 0.6, 0.8]), none]
            parts += [vector(out.store, [0.1, i, 0.3]), np.zeros(9), vector(out.store, [0, 0, 9.81]), np.zeros(9)]
            out.send("/imu", "sensor_msgs/msg/Imu", 1 + 0.01 * i, *parts)
    imu = loom.open_recording(out.path).imu()
    assert len(imu) == 20
    np.testing.assert_allclose(imu.times, 1 + 0.01 * np.arange(20), atol=1e-9)
    np.testing.assert_array_equal(imu.angular_velocity[:, 1], np.arange(20))
    np.testing.assert_array_equal(imu.linear_acceleration, np.tile([0, 0, 9.81], (20, 1)))
    assert np.isnan(imu.orientation[:5]).all() and imu.orientation[5:].tolist() == [[0.8, 0, 0, 0.6]] * 15


def send_imu(out, time, rates=(0, 0, 0.1), force=(0, 0, 9.81), *, frame="imu", is_missing=False, recorded=None):
    none = np.array([-1.0 if is_missing else 0.0, *[0.0] * 8])
    parts = [quaternion(out.store, [0, 0, 0, 1]), none, vector(out.store, rates), none, vector(out.store, force), none]
    kind = "sensor_msgs/msg/Imu"
    out.write("/imu", kind, recorded or time + 0.05, out.store.types[kind](out.header(time, frame), *parts))


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_invalid_readings_are_errors_with_the_message_number(tmp_path, form):
    for name, messages, match in (
        ("nan", [(1.0,), (1.1, (0, np.nan, 0))], r"/imu: message 1 .*not finite"),
        ("time", [(1.0,), (1.1,), (1.05,)], r"/imu: message 2 has the time 1\.05"),
    ):
        (tmp_path / name).mkdir()
        with Writer(tmp_path / name, form) as out:
            for number, message in enumerate(messages):
                send_imu(out, *message, recorded=2.0 + number)
        with pytest.raises(FileError, match=match):
            loom.open_recording(out.path).imu()


def test_missing_values_are_nan_and_accelerations_in_g_are_converted(tmp_path):
    with Writer(tmp_path) as out:
        for i in range(9):
            send_imu(out, 1 + 0.01 * i, force=(0, 0.6, 0.8), is_missing=i < 3)
    with pytest.warns(loom.RecordingWarning, match="as g"):
        readings = loom.open_recording(out.path).imu()
    assert np.isnan(readings.angular_velocity[:3]).all() and np.isnan(readings.linear_acceleration[:3]).all()
    np.testing.assert_allclose(readings.linear_acceleration[3:], np.tile([0, 5.88399, 7.84532], (6, 1)))


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_the_pose_of_the_imu_is_the_static_transform(tmp_path, form):
    with Writer(tmp_path, form) as out:
        send_tf(out, "/tf_static", 0.5, "lidar", "imu", *MOUNT)
        for i in range(3):
            send_imu(out, 1 + 0.01 * i)
    recording = loom.open_recording(out.path)
    expected = pose(np.array(MOUNT[0]), Rotation.from_quat(MOUNT[1]))
    np.testing.assert_allclose(recording.imu(frame="lidar").T_sensor_imu, expected, atol=1e-12)
    np.testing.assert_array_equal(recording.imu().T_sensor_imu, np.eye(4))
    np.testing.assert_array_equal(recording.imu(frame="/imu").T_sensor_imu, np.eye(4))
    with pytest.warns(loom.RecordingWarning, match="'imu' of /imu is assumed to equal 'nowhere'"):
        assert (recording.imu(frame="nowhere").T_sensor_imu == np.eye(4)).all()


@pytest.mark.filterwarnings("ignore::pointloom.io.bags.message_chunks.RecordingWarning")
def test_odometry_of_a_recording_uses_its_imu(tmp_path):
    with Writer(tmp_path) as out:
        for i in range(260):  # to 2.295 s
            send_imu(out, 1 + 0.005 * i, (0, 0, 0), (0, 0, 9.81))
        for scan in range(16):
            message = cloud_message(out.store, "velodyne", 0)
            message.header = out.header(1 + 0.1 * scan, "lidar")
            out.write("/points", CLOUD, 1.1 + 0.1 * scan, message)
    words = ["odometry", out.path, "-o", tmp_path / "poses.tum", "--min-range", 1, "--json"]
    report = json.loads(run(*words, "--imu", "/imu").stdout)
    assert report["without_imu"] == [13, 14, 15] and report["imu_differing"] == []
    assert json.loads(run(*words, "--force").stdout)["without_imu"] == []
    result = run(*words, "--force", "--imu", "/points")
    assert result.exit_code == 1 and "sensor_msgs/msg/Imu" in result.stderr


@pytest.mark.parametrize("kind", ["geometry_msgs/msg/PoseStamped", "nav_msgs/msg/Odometry"])
def test_poses_are_a_trajectory(tmp_path, kind):
    rotations = Rotation.from_rotvec(np.outer(np.linspace(0, 2, 6), [0.1, 0.2, 1.0]))
    with Writer(tmp_path) as out:
        types = out.store.types
        for i, q in enumerate(rotations.as_quat()):
            position = vector(out.store, [500_000 + i, 2 * i, 3], "Point")
            pose = types["geometry_msgs/msg/Pose"](position, quaternion(out.store, q))
            if kind.endswith("Odometry"):
                spread = types["geometry_msgs/msg/PoseWithCovariance"](pose, np.zeros(36))
                still = types["geometry_msgs/msg/Twist"](vector(out.store, [0] * 3), vector(out.store, [0] * 3))
                speed = types["geometry_msgs/msg/TwistWithCovariance"](still, np.zeros(36))
                out.send("/pose", kind, 1.0 + i, "base", spread, speed)
            else:
                out.send("/pose", kind, 1.0 + i, pose)
    path = loom.open_recording(out.path).trajectory()
    np.testing.assert_allclose(path.poses[:, :3, :3], rotations.as_matrix(), atol=1e-12)
    np.testing.assert_array_equal(path.poses[:, 0, 3], 500_000 + np.arange(6))
    np.testing.assert_array_equal(path.timestamps, 1.0 + np.arange(6))


def test_invalid_poses_and_topics_of_other_types_are_named(tmp_path):
    with Writer(tmp_path) as out:
        place, rotation = vector(out.store, [0] * 3, "Point"), quaternion(out.store, [0] * 4)
        pose = out.store.types["geometry_msgs/msg/Pose"](place, rotation)
        out.send("/pose", "geometry_msgs/msg/PoseStamped", 1.0, pose)
    recording = loom.open_recording(out.path)
    with pytest.raises(FileError, match=r"/run:.*0"):
        recording.trajectory()
    with pytest.raises(FileError, match=r"/run:.*sensor_msgs/msg/Imu"):
        recording.imu()
    with pytest.raises(FileError, match="/run:"):
        recording.trajectory("/x")


KIND = "livox_ros_driver2/msg/CustomMsg"
POINT = "uint32 offset_time\nfloat32 x\nfloat32 y\nfloat32 z\nuint8 reflectivity\nuint8 tag\nuint8 line\n"
LIVOX = "std_msgs/Header header\nuint64 timebase\nuint32 point_num\nuint8 lidar_id\nuint8[3] rsvd\n"


def made(folder, form, frame="livox_frame", count_error=0):
    with Writer(folder, form) as out:
        point = KIND.replace("Msg", "Point")
        kinds = get_types_from_msg(POINT, point)
        out.store.register(kinds | get_types_from_msg(LIVOX + f"{point.replace('/msg', '')}[] points\n", KIND))
        make = out.store.types[point]
        for number, count in enumerate((5, 1, 0, 40)):
            points = [make(1000 * i, 1.5 * i, -i, 0.25 * number, i % 256, 16, i % 6) for i in range(count)]
            values = 10**18, count + count_error, 1, np.zeros(3, np.uint8), points
            out.send("/livox/lidar", KIND, number + 1, *values, frame=frame)
    return out.path


@pytest.mark.parametrize("form", ["bag1", "mcap"])
@pytest.mark.parametrize("frame", ["a", "livox", "livox_frame"])
def test_points_have_times_lines_and_reflectivity(tmp_path, form, frame):
    scans = list(loom.open_recording(made(tmp_path, form, frame=frame)).scans())
    assert [len(scan) for scan in scans] == [5, 1, 0, 40]
    i = np.arange(40)
    np.testing.assert_array_equal(scans[3].points, np.column_stack([1.5 * i, -i, np.full(40, 0.75)]))
    np.testing.assert_allclose(scans[3]["time"], 1e-6 * i)
    np.testing.assert_array_equal(scans[3]["line"], i % 6)
    np.testing.assert_array_equal(scans[3]["reflectivity"], i)


def test_truncated_or_inconsistent_cloud_is_named(tmp_path):
    with pytest.raises(FileError, match=r"/run:.*0.*6.*5"):
        list(loom.open_recording(made(tmp_path, "mcap", count_error=1)).scans())
    recording = loom.open_recording(made(tmp_path, "bag1"))
    encoding, data = recording.bytes_at(recording.rows_of("/livox/lidar")[3])
    for end in (0, 10, 20, 30, len(data) - 1):
        with pytest.raises(FileError, match=r"/run\.bag:"):
            table_of_livox(recording.path, data[:end], encoding)


FIX = "sensor_msgs/msg/NavSatFix"


def send_fix(out, time, place, *, status=0, variances=(0.04, 0.09, 1.0), kind=2, frame="gps"):
    state = out.store.types["sensor_msgs/msg/NavSatStatus"](status, 1)
    covariance = np.diag(variances).ravel().astype(float)
    out.send("/gps/fix", FIX, time, state, *map(float, place), covariance, kind, frame=frame)


def street_with_fixes(folder, form="mcap", *, mount=(0.5, 0.0, 1.0)):
    """A drive with positions by GNSS at 5 Hz. The antenna is at `mount` [m] in the frame of the scanner, if given."""
    scene, frame = loom.datasets.street_scans(6), loom.WorldFrame(47.5, 8.25, 430.0)
    with Writer(folder, form) as out:
        if mount is not None:
            send_tf(out, "/tf_static", 0.5, "lidar", "gps", mount, [0, 0, 0, 1])
        for k, (scan, pose) in enumerate(zip(scene.scans, scene.poses, strict=True)):
            message = cloud_message(out.store, "velodyne")
            message.header = out.header(1.0 + 0.2 * k, "lidar")
            rows = np.zeros((len(scan), 22), np.uint8)
            rows[:, :12] = scan.points.astype("<f4").view(np.uint8).reshape(-1, 12)
            rows[:, 18:] = scan["time"].astype("<f4").view(np.uint8).reshape(-1, 4)
            message.width, message.row_step, message.data = len(rows), rows.size, rows.reshape(-1)
            out.write("/points", CLOUD, 1.0 + 0.2 * k, message)
            antenna = pose[:3, :3] @ np.array(mount or (0, 0, 0)) + pose[:3, 3]
            send_fix(out, 1.0 + 0.2 * k, frame.to_geodetic([antenna])[0])
        send_fix(out, 9.0, (47.6, 8.25, 430.0), status=-1)
        send_fix(out, 9.2, (np.nan, np.nan, np.nan))
    return out.path, scene.poses


@pytest.mark.parametrize("form", ["bag1", "mcap"])
@pytest.mark.parametrize("mount", [(0.5, 0.0, 1.0), None])
def test_positions_of_gnss_in_a_recording_have_meters_deviations_and_the_antenna(tmp_path, form, mount):
    path, poses = street_with_fixes(tmp_path, form, mount=mount)
    given = read_positions("/gps/fix", 3.0, path, None)
    readings = given.readings
    np.testing.assert_allclose(readings.times, 1.0 + 0.2 * np.arange(6), atol=1e-6)
    antennas = poses[:, :3, :3] @ np.array(mount or (0, 0, 0)) + poses[:, :3, 3]
    np.testing.assert_allclose(readings.positions, antennas - antennas[0], atol=1e-3)
    np.testing.assert_allclose(readings.sigma, np.tile([0.2, 0.3, 1.0], (6, 1)))
    assert readings.offset.tolist() == list(mount or (0, 0, 0))
    assert "47.5" in given.notes[0] and "2 of 8 messages of /gps/fix have no position" in given.notes[-1]
    assert any("is assumed at the scanner" in note for note in given.notes) == (mount is None)
    system = read_positions("/gps/fix", 3.0, path, None, CoordinateSystem("EPSG:32632"))
    east, north, up = system.readings.positions.T
    assert abs(east[0] - 443_500) < 500 and abs(north[0] - 5_261_000) < 1500 and system.notes[0].endswith("EPSG:32632")
    lengths = np.linalg.norm(np.diff(np.column_stack([east, north, up]), axis=0), axis=1)
    np.testing.assert_allclose(lengths, np.linalg.norm(np.diff(antennas, axis=0), axis=1), rtol=1e-3)  # scale 0.9996
    other = read_positions(path, 3.0, tmp_path, None).readings  # a recording of positions, for a folder of scans
    np.testing.assert_array_equal(other.positions, readings.positions)


def test_fixes_without_covariances_or_heights_have_the_given_deviation_and_unknown_heights(tmp_path):
    with Writer(tmp_path) as out:
        for k in range(3):
            send_fix(out, 1.0 + k, (47.5, 8.25 + 1e-5 * k, np.nan), kind=0)
            send_fix(out, 1.0 + k, (47.5, 8.25, np.nan))  # the time again
    readings = read_positions(out.path, 3.0, tmp_path, None).readings
    assert readings.sigma.tolist() == [[3.0, 3.0, 1e6]] * 3 and len(readings) == 3
    assert abs(readings.positions[:, 2]).max() < 1e-3 and readings.positions[2, 0] == pytest.approx(1.506, abs=0.01)


def test_map_takes_a_topic_of_positions_and_names_the_topics_of_a_wrong_one(tmp_path):
    path, _ = street_with_fixes(tmp_path)
    words = ["map", str(path), "-o", str(tmp_path / "map.ply"), "--device", "cpu", "--force", "--positions"]
    result = CliRunner().invoke(cli, [*words, "/gps/fix"])
    assert result.exit_code in (0, 3), result.stderr
    assert "the reference frame is meters east, north and up" in result.stderr
    result = CliRunner().invoke(cli, [*words, "/gps/none"])
    assert result.exit_code == 1 and f"/gps/fix ({FIX}, 8)" in result.stderr
    (tmp_path / "none").mkdir()
    with Writer(tmp_path / "none") as out:
        send_fix(out, 1.0, (0, 0, 0), status=-1)
    with pytest.raises(FileError, match="/gps/fix: none of 1 messages has a position"):
        read_positions(out.path, 1.0, tmp_path, None)
