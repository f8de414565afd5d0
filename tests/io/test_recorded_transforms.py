"""Frames and transforms from recordings: the tree, interpolation, and transformed clouds."""

import json

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.spatial.transform import Rotation, Slerp

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError

pytest.importorskip("rosbags")

from rosbags.typesys import get_types_from_msg

from .test_bags import CLOUD, cloud_message, points_of, write
from .test_recorded_frames import Writer

TF = "tf2_msgs/msg/TFMessage"
ROTATIONS = Rotation.from_rotvec(np.outer(np.linspace(0, 2.5, 6), [0.2, -0.1, 1.0]))
POSITIONS = np.stack([500_000 + np.arange(6.0), np.arange(6.0) ** 2, np.zeros(6)], axis=1)
MOUNT = ([0.5, 0.0, 1.2], Rotation.from_euler("zyx", [90, 5, -3], degrees=True).as_quat())


def send_tf(out, topic, time, parent, child, position, q):
    types = out.store.types
    if TF not in types:
        out.store.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms", TF))
    vector = types["geometry_msgs/msg/Vector3"](*map(float, position))
    rotation = types["geometry_msgs/msg/Quaternion"](*map(float, q))
    moved = types["geometry_msgs/msg/Transform"](vector, rotation)
    stamped = types["geometry_msgs/msg/TransformStamped"](out.header(time, parent), child, moved)
    if topic not in out.connections:
        out.connections[topic] = out.writer.add_connection(topic, TF, typestore=out.store)
    encode = out.store.serialize_ros1 if out.is_one else out.store.serialize_cdr
    out.writer.write(out.connections[topic], int(1e9 * (time + 0.05)), encode(types[TF]([stamped]), TF))


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
            if "/points" not in out.connections:
                out.connections["/points"] = out.writer.add_connection("/points", CLOUD, typestore=out.store)
            encode = out.store.serialize_ros1 if out.is_one else out.store.serialize_cdr
            out.writer.write(out.connections["/points"], int(1e9 * (11 + scan)), encode(message, CLOUD))
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
