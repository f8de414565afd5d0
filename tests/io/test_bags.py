"""Recordings written by rosbags are read, complete and damaged, with the point layouts and times of the drivers."""

import bz2
import itertools
import json
import sqlite3
import struct
import tracemalloc
import warnings
from contextlib import closing, nullcontext, suppress
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.io.bags.clouds import SECONDS_PER_UNIT, table_of_message, with_seconds
from pointloom.io.bags.message_chunks import RecordingWarning, unpack

pytest.importorskip("rosbags")

from rosbags import rosbag1, rosbag2
from rosbags.typesys import Stores, get_typestore

CLOUD = "sensor_msgs/msg/PointCloud2"
CODES = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}
XYZ = [("x", "f4", 0), ("y", "f4", 4), ("z", "f4", 8)]
DRIVERS = {  # fields, bytes per row, the time field and 0.1 s in its unit
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
    kind = types["std_msgs/msg/Header"]
    header = kind(0, time, "lidar") if "seq" in kind.__dataclass_fields__ else kind(time, "lidar")
    point_fields = [types["sensor_msgs/msg/PointField"](name, at, CODES[code], 1) for name, code, at in fields]
    return types[CLOUD](header, height, width, point_fields, big, step, width * step + padding, data, True)


def write(folder, form, messages=None, driver="velodyne", topics=("/points",), count=6, compress=None, **layout):
    """A recording of some scans on each topic, one second apart."""
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


def in_small_chunks(path, compress="ZSTD"):
    """The same MCAP file in chunks of about 20 kB, written by `mcap`."""
    from mcap.reader import make_reader
    from mcap.writer import CompressionType, Writer

    other = path.with_name("chunks.mcap")
    with path.open("rb") as source, other.open("wb") as file:
        writer, channels = Writer(file, 20_000, CompressionType[compress]), {}
        writer.start(profile="ros2")
        for schema, channel, message in make_reader(source).iter_messages():
            if channel.topic not in channels:
                known = writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.topic] = writer.register_channel(channel.topic, channel.message_encoding, known)
            writer.add_message(channels[channel.topic], message.log_time, message.data, message.publish_time)
        writer.finish()
    return other


FORMS = ["bag1", "mcap", "db3"]


@pytest.mark.parametrize(("form", "compress"), [(form, None) for form in FORMS] + [("bag1", "BZ2"), ("bag1", "LZ4")])
def test_scans_are_ordered_by_time_and_exact(tmp_path, form, compress):
    recording = loom.open_recording(write(tmp_path, form, compress=compress))
    (topic,) = recording.topics
    assert (topic.name, topic.type, topic.count, topic.frame_id) == ("/points", CLOUD, 6, "lidar")
    assert (topic.first, topic.last) == pytest.approx((1.0, 6.0)) and recording.damage is None
    scans = list(recording.scans())
    for scan, cloud in enumerate(scans):
        np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(scan))
        np.testing.assert_allclose(cloud["time"], np.linspace(0, 0.1, len(cloud)), atol=1e-7)
    assert len(scans) == 6


def payloads(path):
    """Time [ns] and bytes of the messages of each topic. Rejected messages and warnings are left out."""
    found = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RecordingWarning)
        recording = loom.open_recording(path)
    for topic in recording.topics:
        for row in recording.rows_of(topic.name):
            with suppress(FileError):
                found.setdefault(topic.name, []).append((row[0], recording.bytes_at(row)[1]))
    return found


def payloads_of_libraries(path):
    if path.suffix == ".mcap":
        from mcap.reader import make_reader

        with path.open("rb") as file:
            messages = [
                (c.topic, m.log_time, m.data) for _, c, m in make_reader(file, validate_crcs=True).iter_messages()
            ]
    else:
        with rosbag1.Reader(path) if path.suffix == ".bag" else rosbag2.Reader(path.parent) as reader:
            messages = [(connection.topic, time, bytes(data)) for connection, time, data in reader.messages()]
    return {name: [message[1:] for message in messages if message[0] == name] for name in {m[0] for m in messages}}


@pytest.mark.parametrize(("form", "compress"), [
    ("db3", None), *[("bag1", name) for name in (None, "BZ2", "LZ4")], *[("mcap", c) for c in ("NONE", "LZ4", "ZSTD")],
])  # fmt: skip
def test_complete_files_have_the_messages_of_other_readers_and_truncated_ones_no_others(tmp_path, form, compress):
    path = file_of(write(tmp_path, form, topics=("/b", "/a"), compress=compress if form == "bag1" else None))
    path = in_small_chunks(path, compress) if form == "mcap" else path
    complete, data = payloads(path), path.read_bytes()
    assert complete == payloads_of_libraries(path) and [len(complete[name]) for name in ("/a", "/b")] == [6, 6]
    counts, short = set(), tmp_path / f"short{path.suffix}"
    for size in np.linspace(0, len(data) - 1, 25).astype(int):
        short.write_bytes(data[:size])
        with suppress(FileError):
            counts.add(sum(map(len, (found := payloads(short)).values())))
            assert all({*found[name]} <= {*complete[name]} for name in found)
    assert len(counts) > 2 and max(counts) <= 12


@pytest.mark.parametrize("driver", DRIVERS)
@pytest.mark.parametrize("layout", [{}, {"big": True}, {"height": 4, "padding": 7}], ids=["rows", "big", "grid"])
def test_drivers_layouts_give_points_and_seconds(tmp_path, driver, layout):
    cloud = next(loom.open_recording(write(tmp_path, "mcap", driver=driver, count=1, **layout)).scans())
    np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(0))
    np.testing.assert_array_equal(cloud["intensity"], np.arange(len(cloud)))
    np.testing.assert_allclose(cloud["time"], np.linspace(0, 0.1, len(cloud)), atol=1e-6)
    assert cloud.grid == ((4, 60) if layout.get("height") else None)


def test_scans_have_arrays_of_the_requested_library(tmp_path):
    recording = loom.open_recording(write(tmp_path, "mcap", driver=next(iter(DRIVERS)), count=1))
    assert next(recording.scans(arrays="warp")).array_library == "warp"
    assert next(recording.scans()).array_library == "numpy"


@pytest.mark.parametrize("form", FORMS)
def test_truncated_recording_is_read_up_to_the_cut_with_a_warning(tmp_path, form):
    path = file_of(write(tmp_path, form, count=20))
    if form == "mcap":
        path = in_small_chunks(path)
    data, scans_read = path.read_bytes(), set()
    for fraction in (0.3, 0.6, 0.9):
        short = tmp_path / f"short{fraction}{path.suffix}"
        short.write_bytes(data[: int(len(data) * fraction)])
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                recording = loom.open_recording(short)
                for scan, cloud in enumerate(recording.scans()):
                    np.testing.assert_array_equal(cloud.points.astype(np.float32), points_of(scan))
                    scans_read.add(scan)
            except FileError:
                continue
        assert recording.damage and [w.category for w in caught] == [RecordingWarning]
    assert 5 < len(scans_read) < 20


@pytest.mark.parametrize("form", FORMS)
def test_flipped_bits_give_clouds_or_named_errors(tmp_path, form):
    path = file_of(write(tmp_path, form, count=2))
    data, rng = bytearray(path.read_bytes()), np.random.default_rng(3)
    for trial in range(15):
        at, bit = int(rng.integers(len(data))), 1 << int(rng.integers(8))
        data[at] ^= bit
        flipped = tmp_path / f"flip{trial}{path.suffix}"
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
    with pytest.raises(FileError, match=r"/run:.*2"):
        recording.scans()
    with pytest.raises(FileError, match="/run:"):
        recording.scans("/up")
    with pytest.raises(ValueError, match="/left, /right"):
        recording.messages("/up")
    assert len(list(recording.scans("/right"))) == 1
    other = tmp_path / "run.bag"
    other.write_bytes(b"#ROSBAG V1.2\n")
    with pytest.raises(FileError, match=r"/run\.bag \(byte 0\):.*1"):
        loom.open_recording(other)


def test_info_lists_topics_and_odometry_wants_one(tmp_path):
    path = write(tmp_path, "db3", topics=("/a", "/b"), count=3)
    result = CliRunner().invoke(cli, ["info", "--json", str(path)])
    topics = json.loads(result.stdout)["files"][0]["topics"]
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


def bomb_of(kind, size):
    import lz4.frame

    if kind == "zstd":
        try:
            from compression import zstd
        except ImportError:
            from backports import zstd
        return zstd.compress(bytes(size))
    return {"bz2": bz2, "lz4": lz4.frame}[kind].compress(bytes(size))


@pytest.mark.parametrize("kind", ["bz2", "lz4", "zstd"])
@pytest.mark.parametrize("parts", [1, 2])
def test_chunk_memory_is_limited_by_its_header(kind, parts):
    packed = bomb_of(kind, 1 << 24) * parts
    for claimed in (1000, 1 << 31):  # the second is impossible for so few bytes
        tracemalloc.start()
        with pytest.raises(FileError, match=r"run\.bag"):
            unpack(Path("run.bag"), packed, kind, claimed)
        assert tracemalloc.get_traced_memory()[1] < 1 << 22
        tracemalloc.stop()
    assert unpack(Path("run.bag"), bomb_of(kind, 1000) * parts, kind, 1000 * parts) == bytes(1000 * parts)
    for damaged in (bomb_of(kind, 1000)[:-1], bomb_of(kind, 1000) + b"behind"):
        with pytest.raises(FileError, match=r"run\.bag"):
            unpack(Path("run.bag"), damaged, kind, 1000)


def u(number):
    return struct.pack("<I", number)


def record1(data=b"", **fields):
    head = b"".join(u(len(name) + 1 + len(value)) + name.encode() + b"=" + value for name, value in fields.items())
    return u(len(head)) + head + u(len(data)) + data


def small_bag(path, index=None, closed=True, info=None, conn=None, time=None, topic=b"/b"):
    """A bag of two chunks with two messages of /a and /b in each. Changes apply to the second chunk."""
    header_of = lambda name: b"".join(  # noqa: E731
        u(len(x)) + x
        for x in (b"topic=" + name, b"type=std_msgs/String", b"md5sum=x", b"message_definition=string data")
    )
    head = lambda at: record1(  # noqa: E731
        b" " * 99, op=b"\3", index_pos=struct.pack("<Q", at), conn_count=u(2), chunk_count=u(2)
    )
    data, infos = b"#ROSBAG V2.0\n" + head(1), b""
    for k in range(2):
        rows, body = {0: [], 1: []}, b"" if k else record1(header_of(topic), op=b"\7", conn=u(1), topic=topic)
        for m, c in itertools.product(range(2), range(2)):
            rows[c].append([10 * k + m, c, len(body)])
            body += record1(u(2) + b"ab", op=b"\2", conn=u(c), time=struct.pack("<II", 10 * k + m, c))
        if k and time is not None:
            rows[0][0][0] = time
        infos += record1(
            struct.pack("<IIII", 0, 2, 1, 2) if info is None or not k else info,
            op=b"\6", ver=u(1), chunk_pos=struct.pack("<Q", len(data)), count=u(2),
            start_time=struct.pack("<II", 10 * k, 0), end_time=struct.pack("<II", 10 * k + 1, 1),
        )  # fmt: skip
        data += record1(body, op=b"\5", compression=b"none", size=u(len(body)))
        for c, count in ((0, 2), (1, 2)) if index is None or not k else index:
            named = c if conn is None or not k or c else conn
            entries = b"".join(struct.pack("<III", *row) for row in rows[c])
            data += record1(entries, op=b"\4", ver=u(1), conn=u(named), count=u(count))
    for c, name in ((0, b"/a"), (1, b"/b")):
        data += record1(header_of(name), op=b"\7", conn=u(c), topic=name)
    path.write_bytes(data + infos if closed else data)


@pytest.mark.parametrize(
    ("damage", "warns"),
    [
        ({}, False),
        ({"closed": False}, False),  # the state after a killed recorder
        ({"index": [(0, 2)]}, True),
        ({"index": [(0, 2), (1, 2), (1, 2)]}, True),
        ({"index": [(0, 4), (1, 2)]}, True),
        ({"index": [(0, 1), (1, 2)]}, True),
        ({"conn": 77}, True),
        ({"conn": 1}, True),
        ({"conn": 77, "closed": False}, True),
        ({"conn": 1, "closed": False}, True),
        ({"index": [(0, 2)], "closed": False}, True),
        ({"index": []}, False),
        ({"time": 99}, True),
        ({"info": struct.pack("<IIII", 0, 1, 1, 2)}, True),
        ({"topic": b"/other", "closed": False}, True),  # the same number has two names
    ],
    ids=str,
)
def test_an_index_that_contradicts_its_messages_is_reported_and_not_used(tmp_path, damage, warns):
    small_bag(tmp_path / "run.bag", **damage)
    with pytest.warns(RecordingWarning) if warns else nullcontext() as caught:
        recording = loom.open_recording(tmp_path / "run.bag")
    assert not warns or len(caught) == 1
    assert sum(topic.count for topic in recording.topics) == 8
    if "topic" not in damage:
        assert {topic.name: topic.count for topic in recording.topics} == {"/a": 4, "/b": 4}
        assert [topic.last for topic in recording.topics] == [11, pytest.approx(11, abs=1e-8)]


@pytest.mark.parametrize("form", FORMS)
def test_a_message_is_compared_with_its_entry(tmp_path, form):
    recording = loom.open_recording(write(tmp_path, form, topics=("/a", "/b"), count=2))
    time, part, channel, piece, offset = recording.rows_of("/a")[0]
    other = next(row[2] for row in recording.rows_of("/b"))
    for row in ((time + 1, part, channel, piece, offset), (time, part, other, piece, offset)):
        with pytest.raises(FileError, match="run"):
            recording.bytes_at(row)


def record_mcap(op, content):
    return bytes([op]) + struct.pack("<Q", len(content)) + content


def mcap_records(rows=(0, 1), statistics=2, inside=b"", checksum=0, size=None):
    """The records of an MCAP file with two messages of /a in a chunk, by their names in the order of the file. `inside`
    follows the messages in the chunk, `size` is the declared size of its bytes."""
    text = lambda words: u(len(words)) + words  # noqa: E731
    messages = [record_mcap(5, struct.pack("<HIQQ", 1, 0, 7 + k, 7 + k) + b"abcd") for k in range(2)]
    body = b"".join(messages) + inside
    stored = struct.pack("<Q", len(body) if size is None else size) + body
    index = b"".join(struct.pack("<QQ", 7 + k, k * len(messages[0])) for k in rows)
    counts = struct.pack("<HQ", 1, statistics or 0)
    head = struct.pack("<QHIIIIQQ", statistics or 0, 1, 1, 0, 0, 1, 7, 8)
    return {
        "magic": b"\x89MCAP0\r\n",
        "header": record_mcap(1, text(b"") + text(b"")),
        "schema": record_mcap(3, struct.pack("<H", 1) + text(b"std_msgs/msg/String") + text(b"ros2msg") + u(0)),
        "channel": record_mcap(4, struct.pack("<HH", 1, 1) + text(b"/a") + text(b"cdr") + u(0)),
        "chunk": record_mcap(6, struct.pack("<QQQI", 7, 8, len(body), checksum) + text(b"") + stored),
        "index": record_mcap(7, struct.pack("<HI", 1, len(index)) + index) if rows else b"",
        "end": record_mcap(15, bytes(4)),
        "statistics": record_mcap(11, head + u(len(counts)) + counts) if statistics else b"",
        "footer": record_mcap(2, bytes(20)) + b"\x89MCAP0\r\n",
    }


@pytest.mark.parametrize(("rows", "statistics", "warns"), [
    ([0, 1], 2, False), ([0, 1], None, False), ([0], 2, True), ([0], None, True), ([0, 0, 1], 2, True),
    ([0, 1], 3, True), ([], 2, False),
])  # fmt: skip
def test_the_index_of_an_mcap_file_is_compared_with_its_statistics(tmp_path, rows, statistics, warns):
    (tmp_path / "run.mcap").write_bytes(b"".join(mcap_records(rows, statistics).values()))
    with pytest.warns(RecordingWarning) if warns else nullcontext() as caught:
        recording = loom.open_recording(tmp_path / "run.mcap")
    assert len(recording) == 2 and (not warns or len(caught) == 1)


def damage_of(path):
    """The number of readable messages, and the warning about damage or the error of each message that is rejected."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", RecordingWarning)
        try:
            recording = loom.open_recording(path)
        except FileError as error:
            return 0, str(error)
    count, words = 0, [str(warning.message) for warning in caught]
    for topic in recording.topics:
        for row in recording.rows_of(topic.name):
            try:
                recording.bytes_at(row)
                count += 1
            except FileError as error:
                words.append(str(error))
    return count, " ".join(words)


STATISTICS = mcap_records()["statistics"]


@pytest.mark.parametrize(("options", "records", "count", "reason"), [
    ({}, {"magic": b"\x89MCAP1\r\n"}, 0, "run.mcap (byte 0): is not an MCAP file"),
    ({}, {"index": record_mcap(0, b"")}, 2, "a record has no kind"),
    ({}, {"index": record_mcap(5, bytes(21))}, 2, "a message of 21 bytes has no head"),
    ({}, {"header": record_mcap(7, bytes(6))}, 0, "is cut off or damaged: an index record has no chunk"),
    ({}, {"channel": record_mcap(4, bytes(4) + u(99) + b"/a")}, 0, "(byte 8): a message reaches beyond its chunk"),
    ({"size": 500}, {}, 0, "is cut off or damaged: run.mcap (byte 113): a chunk is longer than its record"),
    ({"rows": []}, {"footer": b"\x05" + struct.pack("<Q", 99)}, 2,
     "has a damaged summary: run.mcap (byte 301): a record of 99 bytes is cut off"),
    ({}, {"statistics": record_mcap(11, STATISTICS[9:-1])}, 2, "has a damaged summary: the statistics are cut off"),
    ({}, {"statistics": record_mcap(11, STATISTICS[9:51] + u(9) + bytes(9))}, 2, "the statistics are cut off"),
    ({"checksum": 5}, {}, 0, "a chunk is damaged: its checksum differs"),
    ({"checksum": 5, "rows": []}, {}, 0, "has a damaged chunk: run.mcap (byte 113): a chunk is damaged: its checksum"),
    ({"inside": record_mcap(8, b""), "rows": []}, {}, 2, "a chunk contains a record of kind 8"),
    ({"inside": record_mcap(200, b""), "rows": []}, {}, 2, ""),  # of an application
    ({"inside": record_mcap(5, bytes(9)), "rows": []}, {}, 2, "a message of 9 bytes has no head"),
])  # fmt: skip
def test_a_damaged_record_of_an_mcap_file_is_named_and_the_messages_before_it_remain(
    tmp_path, monkeypatch, options, records, count, reason
):
    monkeypatch.chdir(tmp_path)
    Path("run.mcap").write_bytes(b"".join((mcap_records(**options) | records).values()))
    found = damage_of("run.mcap")
    assert found[0] == count and reason in found[1] and bool(reason) == bool(found[1])


def bag_with(old, new, **layout):
    """An edit of `small_bag`: its first bytes `old` are replaced."""

    def edit(path):
        small_bag(path, **layout)
        data = path.read_bytes()
        assert old in data
        path.write_bytes(data.replace(old, new, 1))

    return edit


INDEX_1 = record1(struct.pack("<III", 1, 0, 0), op=b"\4", ver=u(1), conn=u(0), count=u(1))


@pytest.mark.parametrize(("edit", "count", "reason"), [
    (bag_with(b"#ROSBAG V2.0\n", b"#ROSBAG V2.0\n" + INDEX_1), 0, "byte 13 of 1703: an index record has no chunk"),
    (bag_with(b"", b"", info=struct.pack("<II", 0, 2)), 8, "byte 1512 of 1628: the list of chunks is contra"),
    (bag_with(b"", b"", info=struct.pack("<6I", 0, 2, 1, 2, 0, 2)), 8, "of 1644: the list of chunks is contradictory"),
    (bag_with(b"op=\2", b"op=\3", closed=False), 4, "run.bag (byte 189): a chunk contains a record of kind 3"),
    (bag_with(b"compression=none", b"compression=blue"), 4, "compressed with 'blue'. Supported are none, lz4"),
    (bag_with(b"type=", b"KIND=", closed=False), 4, "has a damaged chunk: a record has no field 'type'"),
])  # fmt: skip
def test_a_damaged_record_of_a_bag_is_named_and_the_messages_before_it_remain(
    tmp_path, monkeypatch, edit, count, reason
):
    monkeypatch.chdir(tmp_path)
    edit(Path("run.bag"))
    found = damage_of("run.bag")
    assert found[0] == count and reason in found[1]


DB3 = {"topics": "id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT",
       "messages": "id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB"}  # fmt: skip
ENDLESS = "WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT "


@pytest.mark.parametrize(
    "code",
    [
        f"VIEW topics AS {ENDLESS} x AS id, '/a' AS name, 'b' AS type, 'cdr' AS serialization_format FROM c",
        f"VIEW messages AS {ENDLESS} x AS id, 1 AS topic_id, x AS timestamp, x'00' AS data FROM c",
        "VIEW messages AS SELECT 1 AS id, 1 AS topic_id, 5 AS timestamp, x'00' AS data",
        "VIRTUAL TABLE messages USING fts4(id, topic_id, timestamp, data)",
        f"TABLE messages ({DB3['messages']}, more BLOB AS (zeroblob(id * 1000000000)))",
    ],
)
def test_only_real_tables_are_read(tmp_path, code):
    name = "topics" if "topics" in code else "messages"
    with closing(sqlite3.connect(tmp_path / "run.db3")) as base:
        for table, columns in DB3.items():
            base.execute(f"CREATE {code}" if table == name else f"CREATE TABLE {table} ({columns})")
        if name == "messages":
            base.execute("INSERT INTO topics VALUES (1, '/a', 'b', 'cdr')")
        base.commit()
        base.execute("PRAGMA writable_schema = ON")
        base.execute("UPDATE sqlite_master SET type = 'table' WHERE name = ?", (name,))  # wrong
        base.commit()
    with pytest.raises(FileError, match=rf"run\.db3: .*{name}"):
        loom.open_recording(tmp_path / "run.db3")


def test_rows_that_a_damaged_page_hides_or_repeats_are_reported(tmp_path):
    path, changed_count = tmp_path / "run.db3", 0
    with closing(sqlite3.connect(path)) as base:
        for table, columns in DB3.items():
            base.execute(f"CREATE TABLE {table} ({columns})")
        base.execute("CREATE INDEX timestamp_idx ON messages (timestamp ASC)")
        base.execute("INSERT INTO topics VALUES (1, '/a', 'b', 'cdr')")
        base.executemany("INSERT INTO messages VALUES (?, 1, ?, ?)", [(k, 10 * k, bytes(300)) for k in range(1, 99)])
        base.commit()
    assert len(loom.open_recording(path)) == 98
    data = path.read_bytes()
    for page in range(4096, len(data), 4096):
        count = int.from_bytes(data[page + 3 : page + 5], "big")
        if data[page] in (5, 13) and count > 2:  # of a table: an inner page or a leaf
            first = page + (12 if data[page] == 5 else 8)
            for at, new in ((page + 3, count - 1), (first, int.from_bytes(data[first + 2 : first + 4], "big"))):
                changed, changed_count = bytearray(data), changed_count + 1
                changed[at : at + 2] = new.to_bytes(2, "big")
                path.write_bytes(changed)
                with pytest.warns(RecordingWarning):
                    loom.open_recording(path)
    assert changed_count > 10


def db3_of(path, *rows, index=False, page_size=4096):
    with closing(sqlite3.connect(path)) as base:
        base.execute(f"PRAGMA page_size = {page_size}")
        base.execute("PRAGMA synchronous = OFF")
        for table, columns in DB3.items():
            base.execute(f"CREATE TABLE {table} ({columns})")
        if index:
            base.execute("CREATE INDEX timestamp_idx ON messages (timestamp ASC)")
        base.executemany("INSERT INTO topics VALUES (?, ?, ?, ?)", [(1, "/a", "std_msgs/msg/String", "cdr")])
        base.executemany("INSERT INTO messages VALUES (?, 1, ?, ?)", rows)
        base.commit()


@pytest.mark.parametrize(("rows", "edit", "count", "reason"), [
    ([(1, 5, b"ab")], lambda data: data.replace(b"SQLite", b"SQLATE"), 0, "run.db3 (byte 0): is not a SQLite file"),
    ([(1, 5, b"ab")], lambda data: data[:100] + bytes(4000), 0, "is not a ROS 2 bag, or is damaged at its beginning"),
    ([(1, 5, b"ab"), (2, "soon", b"ab")], bytes, 1, "has 1 rows without a time or topic, which were left out"),
    ([(1, 5, b"ab"), (2, 6, "text")], bytes, 1, "run.db3 (row 2): a message is missing"),
    ([(1, 5, b"ab"), (2, 6, bytes(9000))], lambda data: data[:12288] + b"\xff" * 4 + data[12292:], 1,
     "run.db3 (row 2): damaged: database disk image is malformed"),
])  # fmt: skip
def test_damaged_rows_of_a_database_are_named_and_the_others_remain(tmp_path, monkeypatch, rows, edit, count, reason):
    monkeypatch.chdir(tmp_path)
    db3_of("run.db3", *rows)
    Path("run.db3").write_bytes(edit(Path("run.db3").read_bytes()))
    found = damage_of("run.db3")
    assert found[0] == count and reason in found[1]


@pytest.mark.parametrize("page_size", [512, 4096, 65536])
@pytest.mark.parametrize("index", [False, True])
def test_only_rows_on_the_incomplete_page_of_a_cut_database_are_left_out(tmp_path, page_size, index):
    """SQLite fills up that page with zeros. Rows are in leaves of the table, or continue on overflow pages."""
    rng, path, short = np.random.default_rng(page_size), tmp_path / "run.db3", tmp_path / "short.db3"
    sizes = rng.choice([3, 40, 300, 470, 500, 4090, 9000, 70_000], 150, p=[0.3, 0.2, 0.2, 0.1, 0.05, 0.05, 0.05, 0.05])
    rows = [(3 * k - 50, 10 * k, rng.integers(1, 256, size).astype("u1").tobytes()) for k, size in enumerate(sizes)]
    db3_of(path, *rows, index=index, page_size=page_size)
    complete, data, count = {*payloads(path)["/a"]}, path.read_bytes(), 0
    for size in rng.integers(3 * page_size, len(data), 12):
        found = []
        for end in (size, size // page_size * page_size):
            short.write_bytes(data[:end])
            found.append(set())
            with suppress(FileError):
                found[-1] |= {*payloads(short).get("/a", [])}
        assert found[1] <= found[0] <= complete
        count += len(found[0])
    assert count > 300
    short.write_bytes(data[:-1])
    with pytest.warns(RecordingWarning, match=f"messages: its last page has {page_size - 1} bytes"):
        loom.open_recording(short)


def test_paths_without_a_recording_are_named(tmp_path):
    (tmp_path / "packed").mkdir()
    (tmp_path / "packed" / "run.db3.zstd").touch()
    (tmp_path / "empty").mkdir()
    (tmp_path / "run.txt").touch()
    for name, reason in (
        ("packed", "contains no recording. Unpack run.db3.zstd with zstd -d"),
        ("empty", "contains no recording. Bags of ROS 2 are .mcap or .db3 files"),
        ("none.bag", "does not exist"),
        ("run.txt", "is not a recording: '.txt'. Supported are .bag .mcap .db3"),
    ):
        with pytest.raises(FileError) as caught:
            loom.open_recording(tmp_path / name)
        assert str(caught.value) == f"{tmp_path / name}: {reason}"


@pytest.mark.parametrize(("encoding", "data", "reason"), [
    ("json", b"{}", "its messages are encoded as 'json'. Supported are ros1 and cdr"),
    ("cdr", b"\0\1\0\0\x09\0\0\0a", "a message is not a valid std_msgs/msg/String: "),
])  # fmt: skip
def test_messages_that_cannot_be_decoded_are_named(tmp_path, encoding, data, reason):
    db3_of(tmp_path / "run.db3", (1, 5, data))
    with closing(sqlite3.connect(tmp_path / "run.db3")) as base:
        base.execute("UPDATE topics SET serialization_format = ?", (encoding,))
        base.commit()
    recording = loom.open_recording(tmp_path / "run.db3")
    with pytest.raises(FileError, match=f"/run.db3: {reason}"):
        recording.content_at(recording.rows_of("/a")[0])
    for size in (15, 16):  # without a frame, and with one that ends after the message
        db3_of(tmp_path / f"{size}.db3", (1, 5, bytes(12) + b"\5\0\0\0"[: size - 12]))
        other = loom.open_recording(tmp_path / f"{size}.db3")
        with pytest.raises(FileError, match=rf"/{size}.db3: a message is cut off in its header: {size} bytes"):
            other.header_at(other.rows_of("/a")[0])


@pytest.mark.parametrize("driver", DRIVERS)
def test_absolute_times_are_on_the_clock_of_the_headers(tmp_path, driver):
    """The header is at 5 s. Clocks of Livox, Hesai and RoboSense began in 1970, those of others at the header."""
    path = write(tmp_path, "mcap", driver=driver, count=1)
    cloud = next(loom.open_recording(path).scans(absolute_times=True))
    np.testing.assert_allclose(cloud["time"], 5 + np.linspace(0, 0.1, len(cloud)), atol=1e-6)


@pytest.mark.parametrize(("first", "stamp", "start"), [
    (0.0, 1.7e9, 1.7e9), (-0.1, 1.7e9, 1.7e9 - 0.1), (1.7e9 - 0.05, 1.7e9, 1.7e9 - 0.05), (512.25, 1.7e9, 1.7e9),
    (0.0, 0.5, 0.5), (30.0, 30.1, 30.0),
])  # fmt: skip
def test_starts_of_scans_follow_the_conventions_of_drivers(first, stamp, start):
    times = first + np.linspace(0, 0.1, 50)
    found = with_seconds(PATH, {"timestamp": times}, np.ones(50, bool), stamp, absolute_times=True)
    np.testing.assert_allclose(found["time"], start + np.linspace(0, 0.1, 50), atol=1e-6)


PATH, COUNT = Path("run.mcap"), 50
SINCE_1970, SINCE_START = 1.7e9, 512.25  # [s]
SWEEPS = np.linspace(0, 0.1, COUNT)


def read(name, times, stamp=SINCE_1970, valid=None):
    valid = np.ones(len(times), bool) if valid is None else valid
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        attributes = with_seconds(PATH, {name: times, "ring": np.arange(len(times))}, valid, stamp)
    assert {w.category for w in caught} <= {RecordingWarning}
    return attributes, [str(w.message) for w in caught]


def assert_sweep(attributes, tolerance=1e-6, messages=()):
    assert "time" in attributes and not messages
    np.testing.assert_allclose(attributes["time"], SWEEPS, atol=tolerance)


@pytest.mark.parametrize("unit", SECONDS_PER_UNIT)
@pytest.mark.parametrize("start", [SINCE_1970, SINCE_START, 86_000.0], ids=["1970", "boot", "a day"])
@pytest.mark.parametrize("stamp", [None, 0.0, 1.6e9], ids=["same clock", "no stamp", "another clock"])
def test_unit_follows_from_the_clock_of_the_header_or_from_the_sweep_duration(unit, start, stamp):
    """Nanoseconds since power-on are small numbers: by their size they would be 10^8 s."""
    stamp = start + 0.1 if stamp is None else stamp
    attributes, messages = read("timestamp", (start + SWEEPS) / SECONDS_PER_UNIT[unit], stamp=stamp)
    assert_sweep(attributes, 1e-6, messages)


def test_times_of_known_drivers_are_read_by_name():
    nanoseconds = np.uint32(SWEEPS * 1e9)
    known = [("time", np.float32(SWEEPS)), ("time", np.float32(SWEEPS - 0.1)), ("t", nanoseconds)]
    for name, times in (*known, ("offset_time", nanoseconds)):
        attributes, messages = read(name, times)
        assert_sweep(attributes, 1e-6, messages)


@pytest.mark.parametrize(("name", "kind", "unit"), [("time", "f4", "us"), ("t", "u4", "us"), ("time", "f8", "ms")])
def test_unit_other_than_the_drivers_is_reported(name, kind, unit):
    attributes, messages = read(name, (SWEEPS / SECONDS_PER_UNIT[unit]).astype(kind))
    assert_sweep(attributes, 1e-6)
    assert len(messages) == 1 and f"read as {unit}" in messages[0] and repr(name) in messages[0]


def test_numbers_without_a_unit_are_preserved_and_reported():
    for name, times, expected_name in (
        ("timestamp", np.float64(SWEEPS * 1e-3), "timestamp"),  # 0.1 ms, or 100 s of thousandths
        ("time", np.float32([0.0, 1900.0]), "timestamps"),
        ("time_stamp", np.uint32([0, 10]), "time_stamp"),
    ):
        attributes, messages = read(name, times, stamp=5.0)
        assert "time" not in attributes and len(messages) == 1 and "in any unit" in messages[0]
        np.testing.assert_array_equal(attributes[expected_name], times)


@pytest.mark.parametrize("name", ["time", "t", "timestamp"])
def test_flash_has_zero_duration(name):
    attributes, messages = read(name, np.full(COUNT, 7, "u4" if name == "t" else "f8"))
    assert not messages and attributes["time"].tolist() == [0] * COUNT


def test_unmeasured_points_are_ignored():
    times, seen = SINCE_1970 + SWEEPS, np.ones(COUNT, bool)
    times[[3, 9]], seen[3] = 0, False  # one not finite, and one with an unset time
    attributes, messages = read("timestamp", times, stamp=0.0, valid=seen)
    others = np.delete(np.arange(COUNT), [3, 9])
    assert not messages
    np.testing.assert_allclose(attributes["time"][others], SWEEPS[others], atol=1e-6)


def test_a_cloud_without_points_or_times_is_read():
    assert read("time", np.zeros(0, np.float32))[0]["time"].size == 0 and set(read("gps", SWEEPS)[0]) == {"gps", "ring"}
    assert set(read("time", np.full(4, np.nan))[0]) == {"time", "ring"}


@pytest.mark.parametrize("start", [1.7e9, 3e5, 2e4 + 7], ids=["1970", "week", "boot"])
@pytest.mark.parametrize("name", ["time", "timestamp", "t", "time_offset"])
def test_float32_times_that_do_not_resolve_the_sweep_are_named_with_their_resolution(name, start):
    times = np.float32(start + (SWEEPS if start > 1e5 else SWEEPS / 10))
    attributes, messages = read(name, times)
    (message,) = messages
    assert f"'{name}'" in message and f"{np.spacing(times.max()):g} apart" in message and "not deskewed" in message
    np.testing.assert_array_equal(attributes.pop(f"{name}_field"), times)
    assert set(attributes) == {"ring"}  # nothing that odometry takes for point times


def write_drive(path, store, *, stamped=True, clock="header", named="time", count=5):
    """Scans in a street at 10 Hz, whose headers are times since 1970 of the beginning of a sweep. None: no times."""
    scans = loom.datasets.street_scans(count).scans
    with rosbag2.Writer(path, version=9, storage_plugin=rosbag2.StoragePlugin.MCAP) as writer:
        connection = writer.add_connection("/points", CLOUD, typestore=store)
        for k, scan in enumerate(scans):
            offset = {"header": -0.1 * k, "end": -0.1 * (k + 1), "start": 0.0, "1970": 1.7e9, "none": 0.0}[clock]
            code = "f8" if clock == "1970" else "f4"
            fields = XYZ if clock == "none" else [*XYZ, (named, code, 12)]
            rows = np.zeros(len(scan), np.dtype({"names": [f[0] for f in fields], "formats": [f[1] for f in fields],
                                                 "offsets": [f[2] for f in fields], "itemsize": 20}))  # fmt: skip
            rows["x"], rows["y"], rows["z"] = scan.points.T
            if clock != "none":
                rows[named] = scan["time"] + offset
            types, nanoseconds = store.types, (k + (clock == "end")) * 10**8
            time = types["builtin_interfaces/msg/Time"](1_700_000_000 * stamped, nanoseconds * stamped)
            header = types["std_msgs/msg/Header"](time, "lidar")
            parts = [types["sensor_msgs/msg/PointField"](f[0], f[2], CODES[f[1]], 1) for f in fields]
            data = np.frombuffer(rows.tobytes(), np.uint8)
            message = types[CLOUD](header, 1, len(rows), parts, False, 20, len(data), data, True)
            writer.write(connection, 10**9 * (k + 1), store.serialize_cdr(message, CLOUD))


@pytest.mark.parametrize("clock", ["header", "end", "start", "1970", "none"])
def test_paths_of_recordings_have_the_times_of_the_ends_of_sweeps(tmp_path, clock):
    write_drive(tmp_path / "run", get_typestore(Stores.ROS2_HUMBLE), clock=clock)
    ends = 1.7e9 + 0.1 * np.arange(5) + (0.1 if clock != "none" else 0.0)
    for words in (
        ["odometry", "-o", tmp_path / "a.tum"],
        ["map", "-o", tmp_path / "m.ply", "--trajectory", tmp_path / "b.tum"],
    ):
        result = CliRunner().invoke(cli, [words[0], str(tmp_path / "run"), *map(str, words[1:]), "--device", "cpu"])
        assert result.exit_code == 0, result.output
        np.testing.assert_allclose(loom.read_trajectory(words[-1]).timestamps, ends, atol=2e-3)


def test_paths_of_recordings_without_times_in_the_headers_are_numbered_with_a_warning(tmp_path):
    write_drive(tmp_path / "run", get_typestore(Stores.ROS2_HUMBLE), stamped=False)
    with warnings.catch_warnings():
        warnings.simplefilter("always")  # the command prints it
        result = CliRunner().invoke(
            cli, ["odometry", str(tmp_path / "run"), "-o", str(tmp_path / "a.tum"), "--device", "cpu"]
        )
    assert "5 of 5 headers have no time" in result.output
    assert loom.read_trajectory(tmp_path / "a.tum").timestamps.tolist() == [0, 1, 2, 3, 4]


def test_the_truth_of_a_recording_is_matched_by_its_times_if_the_counts_differ(tmp_path):
    write_drive(tmp_path / "run", get_typestore(Stores.ROS2_HUMBLE), count=12)
    truth = loom.datasets.street_scans(12).poses
    truth_path = str(tmp_path / "truth.tum")
    times = 1.7e9 + 0.1 * (1 + np.arange(12))
    for count in (12, 10):
        loom.write_trajectory(truth_path, loom.Trajectory(truth[:count], times[:count]))
        words = [
            "odometry",
            str(tmp_path / "run"),
            "-o",
            str(tmp_path / "a.tum"),
            "--truth",
            truth_path,
            "--force",
            "--json",
        ]
        result = CliRunner().invoke(cli, [*words, "--device", "cpu"])
        assert result.exit_code == 0, result.output
        assert json.loads(result.stdout)["errors"]["compared"] == count


def cloud_of_rows(rows, codes, *, height=1, row_step=None):
    store = get_typestore(Stores.ROS2_HUMBLE)
    types, kind = store.types, rows.dtype
    header = types["std_msgs/msg/Header"](types["builtin_interfaces/msg/Time"](5, 0), "lidar")
    fields = [types["sensor_msgs/msg/PointField"](name, kind.fields[name][1], code, 1)
              for name, code in zip(kind.names, codes, strict=True)]  # fmt: skip
    step, data = kind.itemsize, np.frombuffer(rows.tobytes(), np.uint8)
    width = len(rows) // height
    return types[CLOUD](header, height, width, fields, False, step, width * step if row_step is None else row_step,
                        data, True)  # fmt: skip


def test_fields_of_the_types_of_pcl_are_left_out_by_name():
    rows = np.zeros(
        4, [("x", "f4"), ("id", "i8"), ("y", "f4"), ("stamp", "u8"), ("z", "f4"), ("hit", "?"), ("w", "u2")]
    )
    rows["x"], rows["z"], rows["w"] = np.arange(4), 7, np.arange(4)
    with pytest.warns(RecordingWarning, match=r"left out: id \(int64\), stamp \(uint64\), hit \(bool\)"):
        table = table_of_message(PATH, cloud_of_rows(rows, [7, 9, 7, 10, 7, 11, 4]))
    assert table.points.tolist() == [[k, 0, 7] for k in range(4)] and set(table.attributes) == {"w"}
    assert table.attributes["w"].tolist() == [0, 1, 2, 3]


@pytest.mark.parametrize(("codes", "change", "reason"), [
    ([9, 7, 7, 7], {}, "a cloud has no field 'x'; it has y, z, w"),
    ([7, 7, 7, 12], {}, "field 'w' of a cloud has the unknown type 12"),
    ([7, 7, 7, 0], {}, "field 'w' of a cloud has the unknown type 0"),
    ([7, 7, 6, 7], {}, "a cloud has coordinates that are not one float each"),
    ([7, 7, 7, 8], {}, "field 'w' of a cloud reaches beyond its rows of 16 bytes"),
    ([7, 7, 7, 7], {"height": 2, "width": 2, "row_step": 31, "data": np.zeros(90, np.uint8)},
     "a cloud has rows of 31 bytes for 2 points of 16"),
    ([7, 7, 7, 7], {"width": 5}, "a cloud of 5 x 1 points needs 80 bytes, but has 64"),
    ([7, 7, 7, 7], {"width": 5, "point_step": 0, "fields": []}, "a cloud has no field 'x'; it has none"),
])  # fmt: skip
def test_clouds_with_contradictory_fields_are_rejected(codes, change, reason):
    rows = np.zeros(4, [(name, "f4") for name in "xyzw"])
    message = cloud_of_rows(rows, codes)
    for name, value in change.items():
        setattr(message, name, value)
    with pytest.raises(FileError) as caught, warnings.catch_warnings():
        warnings.simplefilter("ignore", RecordingWarning)
        table_of_message(PATH, message)
    assert str(caught.value) == f"run.mcap: {reason}"


@pytest.mark.parametrize("names", ["red green blue", "r g b", "Red Green Blue"])
@pytest.mark.parametrize(("kind", "code", "full"), [("u1", 2, 255), ("u2", 4, 65535), ("f4", 7, 1)])
def test_colors_in_three_fields_are_colors(names, kind, code, full):
    rows = np.zeros(3, [(axis, "f4") for axis in "xyz"] + [(name, kind) for name in names.split()])
    for number, name in enumerate(names.split()):
        rows[name] = full * (np.arange(3) == number)
    table = table_of_message(PATH, cloud_of_rows(rows, [7, 7, 7, code, code, code]))
    assert table.colors.tolist() == np.eye(3).tolist() and not table.attributes


@pytest.mark.parametrize("row_step", [0, 12, 12 * 6, 13 * 2])
def test_a_row_step_that_contradicts_the_exact_size_of_the_data_is_not_used(row_step):
    rows = np.zeros(6, [(axis, "f4") for axis in "xyz"])
    rows["x"] = np.arange(6)
    table = table_of_message(PATH, cloud_of_rows(rows, [7, 7, 7], height=3, row_step=row_step))
    assert table.points[:, 0].tolist() == [0, 1, 2, 3, 4, 5] and table.grid == (3, 2)
    message = cloud_of_rows(rows, [7, 7, 7], height=3, row_step=12 * 6)
    message.data = message.data[:-1]
    with pytest.raises(FileError, match="needs"):
        table_of_message(PATH, message)
