"""Recordings made by the writers of rosbags are read back, whole and damaged, with the layouts of the drivers."""

import json
import warnings

import numpy as np
import pytest
from click.testing import CliRunner

import pointloom as loom
from pointloom.app.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.files.bags.pieces import RecordingWarning

pytest.importorskip("rosbags")

from rosbags import rosbag1, rosbag2
from rosbags.typesys import Stores, get_typestore

CLOUD = "sensor_msgs/msg/PointCloud2"
CODES = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}
XYZ = [("x", "f4", 0), ("y", "f4", 4), ("z", "f4", 8)]
DRIVERS = {  # fields, bytes a row, the field of time and a tenth of a second in its unit
    "velodyne": ([*XYZ, ("intensity", "f4", 12), ("ring", "u2", 16), ("time", "f4", 18)], 22, "time", 0.1, 0),
    "ouster": ([*XYZ, ("intensity", "f4", 16), ("t", "u4", 20), ("reflectivity", "u2", 24), ("ring", "u2", 26),
                ("ambient", "u2", 28), ("range", "u4", 32)], 48, "t", 10**8, 0),
    "livox": ([*XYZ, ("intensity", "f4", 12), ("tag", "u1", 16), ("line", "u1", 17), ("timestamp", "f8", 18)],
              26, "timestamp", 1e8, 1.7e18),
    "hesai": ([*XYZ, ("intensity", "f4", 12), ("timestamp", "f8", 16), ("ring", "u2", 24)], 26, "timestamp", 0.1,
              1.7e9),
    "robosense": ([*XYZ, ("intensity", "f4", 12), ("ring", "u2", 16), ("timestamp", "f8", 18)], 26, "timestamp", 0.1,
                  1.7e9),
}  # fmt: skip


def points_of(scan, count=240):
    v = np.arange(count)
    return np.stack([10 + 0.01 * v + scan, np.sin(v), 0.1 * v], axis=1).astype(np.float32)


def cloud_message(store, driver, scan=0, *, big=False, height=1, padding=0):
    fields, step, named, tenth, start = DRIVERS[driver]
    order, points = ">" if big else "<", points_of(scan)
    kind = np.dtype({
        "names": [f[0] for f in fields], "formats": [order + f[1] for f in fields],
        "offsets": [f[2] for f in fields], "itemsize": step,
    })  # fmt: skip
    rows = np.zeros(len(points), kind)
    rows["x"], rows["y"], rows["z"] = points.T
    rows["intensity"] = np.arange(len(points))
    rows[named] = start + np.linspace(0, 1, len(points)) * tenth
    width = len(points) // height
    data = np.frombuffer(rows.tobytes(), np.uint8).reshape(height, width * step)
    data = np.pad(data, ((0, 0), (0, padding))).reshape(-1)
    types, time = store.types, store.types["builtin_interfaces/msg/Time"](sec=5, nanosec=0)
    header = types["std_msgs/msg/Header"]
    header = (
        header(seq=0, stamp=time, frame_id="lidar") if "seq" in header.__dataclass_fields__ else header(time, "lidar")
    )
    told = [types["sensor_msgs/msg/PointField"](name, at, CODES[code], 1) for name, code, at in fields]
    return types[CLOUD](header, height, width, told, big, step, width * step + padding, data, True)


def write(folder, form, messages=None, driver="velodyne", topics=("/points",), count=6, compress=None, **layout):
    """A recording of some scans on each topic, a second apart."""
    if form == "bag1":
        path, store = folder / "run.bag", get_typestore(Stores.ROS1_NOETIC)
        writer, encode = rosbag1.Writer(path), store.serialize_ros1
        writer.chunk_threshold = 20_000
        if compress:
            writer.set_compression(writer.CompressionFormat[compress])
    else:
        path, store = folder / "run", get_typestore(Stores.ROS2_HUMBLE)
        plugin = rosbag2.StoragePlugin.MCAP if form == "mcap" else rosbag2.StoragePlugin.SQLITE3
        writer, encode = rosbag2.Writer(path, version=9, storage_plugin=plugin), store.serialize_cdr
    with writer:
        connections = [writer.add_connection(topic, CLOUD, typestore=store) for topic in topics]
        for scan in range(count):
            for connection in connections:
                message = cloud_message(store, driver, scan, **layout)
                writer.write(connection, (scan + 1) * 10**9, encode(message, CLOUD))
    return path


def file_of(path):
    return path if path.is_file() else next(p for p in path.iterdir() if p.suffix in (".mcap", ".db3"))


def in_small_chunks(path):
    """The same MCAP file in chunks of some 20 kB, by the writer of `mcap`."""
    from mcap.reader import make_reader
    from mcap.writer import Writer

    other = path.with_name("chunks.mcap")
    with path.open("rb") as source, other.open("wb") as file:
        writer, channels = Writer(file, chunk_size=20_000), {}
        writer.start(profile="ros2")
        for schema, channel, message in make_reader(source).iter_messages():
            if channel.topic not in channels:
                known = writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.topic] = writer.register_channel(channel.topic, channel.message_encoding, known)
            writer.add_message(channels[channel.topic], message.log_time, message.data, message.publish_time)
        writer.finish()
    return other


FORMS = ["bag1", "mcap", "db3"]


@pytest.mark.parametrize("form", FORMS)
def test_scans_come_in_order_of_time_with_all_their_bits(tmp_path, form):
    path = write(tmp_path, form)
    recording = loom.open_recording(path)
    (topic,) = recording.topics
    assert (topic.name, topic.type, topic.count, topic.frame_id) == ("/points", CLOUD, 6, "lidar")
    assert (topic.first, topic.last) == pytest.approx((1.0, 6.0)) and recording.damage is None
    scans = list(recording.scans())
    for scan, cloud in enumerate(scans):
        np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(scan))
        np.testing.assert_allclose(cloud["time"], np.linspace(0, 0.1, len(cloud)), atol=1e-7)
    assert len(scans) == 6


@pytest.mark.parametrize("driver", DRIVERS)
@pytest.mark.parametrize("layout", [{}, {"big": True}, {"height": 4, "padding": 7}], ids=["rows", "big", "grid"])
def test_drivers_layouts_give_points_and_seconds(tmp_path, driver, layout):
    cloud = next(loom.open_recording(write(tmp_path, "mcap", driver=driver, count=1, **layout)).scans())
    np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(0))
    np.testing.assert_array_equal(cloud["intensity"], np.arange(len(cloud)))
    np.testing.assert_allclose(cloud["time"], np.linspace(0, 0.1, len(cloud)), atol=1e-6)
    assert cloud.grid == ((4, 60) if layout.get("height") else None)


@pytest.mark.parametrize("compress", ["BZ2", "LZ4"])
def test_packed_chunks_are_unpacked(tmp_path, compress):
    assert len(list(loom.open_recording(write(tmp_path, "bag1", compress=compress)).scans())) == 6


@pytest.mark.parametrize("form", FORMS)
def test_what_is_cut_off_is_read_up_to_there_and_said(tmp_path, form):
    path = file_of(write(tmp_path, form, count=20))
    if form == "mcap":
        path = in_small_chunks(path)
    data, seen = path.read_bytes(), set()
    for share in (0.3, 0.6, 0.9):
        short = tmp_path / f"short{share}{path.suffix}"
        short.write_bytes(data[: int(len(data) * share)])
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            try:
                recording = loom.open_recording(short)
                for scan, cloud in enumerate(recording.scans()):
                    np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(scan))
                    seen.add(scan)
            except FileError:
                continue
        assert recording.damage and [w.category for w in told] == [RecordingWarning]
    assert 5 < len(seen) < 20


@pytest.mark.parametrize("form", FORMS)
def test_flipped_bits_give_clouds_or_named_errors(tmp_path, form):
    path = file_of(write(tmp_path, form, count=2))
    data, rng = bytearray(path.read_bytes()), np.random.default_rng(3)
    for turn in range(15):
        at, bit = int(rng.integers(len(data))), 1 << int(rng.integers(8))
        data[at] ^= bit
        flipped = tmp_path / f"flip{turn}{path.suffix}"
        flipped.write_bytes(data)
        data[at] ^= bit
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RecordingWarning)
            try:
                for _ in loom.open_recording(flipped).scans():
                    pass
            except FileError:
                pass


def test_topics_that_do_not_fit_are_named(tmp_path):
    recording = loom.open_recording(write(tmp_path, "mcap", topics=("/left", "/right"), count=1))
    with pytest.raises(FileError, match=r"2 topics of .*: /left, /right"):
        recording.scans()
    with pytest.raises(FileError, match="no topic '/up'"):
        recording.scans("/up")
    with pytest.raises(ValueError, match="/left, /right"):
        recording.messages("/up")
    assert len(list(recording.scans("/right"))) == 1
    other = tmp_path / "run.bag"
    other.write_bytes(b"#ROSBAG V1.2\n")
    with pytest.raises(FileError, match="no bag of ROS 1"):
        loom.open_recording(other)


def test_info_lists_topics_and_odometry_wants_one(tmp_path):
    path = write(tmp_path, "db3", topics=("/a", "/b"), count=3)
    told = CliRunner().invoke(cli, ["info", "--json", str(path)])
    topics = json.loads(told.stdout)["files"][0]["topics"]
    assert [(topic["name"], topic["count"]) for topic in topics] == [("/a", 3), ("/b", 3)]
    arguments = ["odometry", str(path), "-o", str(tmp_path / "poses.txt"), "--device", "cpu"]
    assert CliRunner().invoke(cli, arguments).exit_code != 0  # two topics of clouds


def test_a_bag_that_is_zeroed_in_the_middle_keeps_what_was_before(tmp_path):
    path = write(tmp_path, "bag1", count=20)
    data = bytearray(path.read_bytes())
    middle = len(data) // 2
    data[middle : middle + 60_000] = bytes(min(60_000, len(data) - middle))
    path.write_bytes(data)
    with pytest.warns(RecordingWarning, match="damaged"):
        recording = loom.open_recording(path)
    scans = recording.scans("/points")
    for scan in range(5):
        np.testing.assert_array_equal(next(scans).points.astype(np.float32), points_of(scan))
