"""The node of docs/other-tools.md on rclpy, and with replacements of the modules of ROS 2 where it is not installed."""

from __future__ import annotations

import importlib.util
import sys
import time
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.typesys import Stores, get_typestore
from scipy.spatial.transform import Rotation

import pointloom as loom

from ..page_blocks import blocks_of

STEP, SCANS = 0.3, 11  # [m] between scans
DEGREES = 2.0  # between scans


def room() -> np.ndarray:
    """Points on the walls, the floor and the ceiling of a room of 16 x 16 x 5 m."""
    rng = np.random.default_rng(0)
    points = rng.uniform(-8, 8, (12_000, 3)) * [1, 1, 0.3]
    rows = np.arange(len(points))
    points[rows, rows % 3] = np.where(rng.random(len(points)) < 0.5, -1, 1) * np.array([8.0, 8.0, 2.5])[rows % 3]
    return points


def true_pose(k: int) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3] = Rotation.from_euler("z", DEGREES * k, degrees=True).as_matrix()
    T[0, 3] = STEP * k
    return T


def module(name: str, **members: Any) -> ModuleType:
    made = ModuleType(name)
    vars(made).update(members)
    return made


def odometry_message(**fields: Any) -> SimpleNamespace:
    """A message with the fields of nav_msgs/Odometry that the node uses."""
    position, orientation = SimpleNamespace(), SimpleNamespace()
    pose = SimpleNamespace(pose=SimpleNamespace(position=position, orientation=orientation), covariance=None)
    return SimpleNamespace(pose=pose, **fields)


class Node:
    def __init__(self, name: str):
        self.name, self.published, self.subscribed = name, {}, {}

    def create_publisher(self, kind: Any, topic: str, depth: int) -> SimpleNamespace:
        return SimpleNamespace(publish=self.published.setdefault(topic, []).append)

    def create_subscription(self, kind: Any, topic: str, callback: Any, profile: Any) -> None:
        self.subscribed[topic] = callback


@pytest.fixture
def nodes(monkeypatch) -> list[Node]:
    """The nodes that a program spins. Each receives the scans of a moving sensor."""
    spun: list[Node] = []

    def spin(node: Node) -> None:
        for k in range(SCANS):
            T = np.linalg.inv(true_pose(k))
            points = (room() @ T[:3, :3].T + T[:3, 3]).astype(np.float32)
            header = SimpleNamespace(frame_id="lidar", stamp=k)
            node.subscribed["points"](SimpleNamespace(header=header, points=points))
        spun.append(node)

    def read_points_numpy(message: Any, field_names: tuple[str, ...], skip_nans: bool) -> np.ndarray:
        assert field_names == ("x", "y", "z")
        assert skip_nans
        return message.points

    clouds = module(
        "point_cloud2", read_points_numpy=read_points_numpy, create_cloud_xyz32=lambda header, points: (header, points)
    )
    for made in (
        module("rclpy", init=lambda: None, spin=spin),
        module("rclpy.node", Node=Node),
        module("rclpy.qos", qos_profile_sensor_data=object()),
        module("nav_msgs"),
        module("nav_msgs.msg", Odometry=odometry_message),
        module("sensor_msgs"),
        module("sensor_msgs.msg", PointCloud2=object),
        module("sensor_msgs_py", point_cloud2=clouds),
    ):
        monkeypatch.setitem(sys.modules, made.__name__, made)
    return spun


def run_block() -> None:
    (block,) = [block for block in blocks_of("docs/other-tools.md") if "test_ros_node" in (block.reason or "")]
    assert len(block.code.strip().splitlines()) <= 40
    exec(compile(block.source(), block.page, "exec"), {"__name__": "page"})


def assert_true_poses(messages: list[Any]) -> None:
    assert len(messages) == SCANS
    for k, message in enumerate(messages):
        assert (message.header.frame_id, message.child_frame_id) == ("odom", "lidar")
        position, turn = message.pose.pose.position, message.pose.pose.orientation
        T = true_pose(k)
        np.testing.assert_allclose([position.x, position.y, position.z], T[:3, 3], atol=0.02)
        R = Rotation.from_quat([turn.x, turn.y, turn.z, turn.w])
        assert np.degrees((R * Rotation.from_matrix(T[:3, :3]).inv()).magnitude()) < 0.2
        assert np.shape(message.pose.covariance) == (36,)
    position_variances = np.array([message.pose.covariance[[0, 7, 14]] for message in messages[1:]])
    assert (position_variances > 0).all()


def assert_room(points: np.ndarray) -> None:
    assert np.abs(np.abs(points).max(axis=0) - [8.0, 8.0, 2.5]).max() < 0.1


def test_the_node_publishes_poses_of_the_sensor_and_a_map(nodes):
    run_block()
    (node,) = nodes
    messages = node.published["odometry"]
    types = get_typestore(Stores.ROS2_HUMBLE).types
    for message in messages:
        assert set(vars(message)) <= set(types["nav_msgs/msg/Odometry"].__dataclass_fields__)
    assert_true_poses(messages)
    ((header, points),) = node.published["map"]
    assert header.frame_id == "odom"
    assert_room(points)


def packed(header: Any, points: np.ndarray) -> Any:
    """A PointCloud2 of float32 points, as `create_cloud_xyz32` of sensor_msgs_py makes it."""
    from sensor_msgs.msg import PointCloud2, PointField

    fields = [PointField(name=name, offset=4 * k, datatype=PointField.FLOAT32, count=1) for k, name in enumerate("xyz")]
    data = np.asarray(points, np.float32).tobytes()
    rows = len(points)
    return PointCloud2(
        header=header, height=1, width=rows, fields=fields, point_step=12, row_step=12 * rows, data=data, is_dense=False
    )


def unpacked(message: Any, field_names: tuple[str, ...] = ("x", "y", "z"), skip_nans: bool = True) -> np.ndarray:
    """The points of such a message, as `read_points_numpy` of sensor_msgs_py returns them."""
    assert field_names == ("x", "y", "z")
    points = np.frombuffer(message.data, np.float32).reshape(-1, 3)
    return points[np.isfinite(points).all(axis=1)] if skip_nans else points


@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of modules that ROS imports
def test_the_node_runs_on_rclpy_with_messages_of_ros(monkeypatch):
    """Messages go through rclpy and its middleware in this process. `sensor_msgs_py` has no wheel."""
    if importlib.util.find_spec("rclpy") is None:
        pytest.skip("rclpy is not installed. `make test-other-tools` runs this test")
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")  # no messages to or from other processes
    import rclpy
    from nav_msgs.msg import Odometry
    from rclpy.executors import SingleThreadedExecutor
    from sensor_msgs.msg import PointCloud2
    from std_msgs.msg import Header

    if importlib.util.find_spec("sensor_msgs_py") is None:
        clouds = module("point_cloud2", read_points_numpy=unpacked, create_cloud_xyz32=packed)
        monkeypatch.setitem(sys.modules, "sensor_msgs_py", module("sensor_msgs_py", point_cloud2=clouds))
    poses: list[Any] = []
    maps: list[Any] = []

    def spin(node: Any) -> None:
        sensor = rclpy.create_node("sensor")
        sensor.create_subscription(Odometry, "odometry", poses.append, SCANS)
        sensor.create_subscription(PointCloud2, "map", maps.append, 1)
        scans, executor = sensor.create_publisher(PointCloud2, "points", SCANS), SingleThreadedExecutor()
        executor.add_node(node)
        executor.add_node(sensor)
        end = time.monotonic() + 60
        for k in range(SCANS):
            T, header = np.linalg.inv(true_pose(k)), Header(frame_id="lidar")
            header.stamp.sec = k
            points = np.concatenate([room() @ T[:3, :3].T + T[:3, 3], np.full((5, 3), np.nan)])
            scans.publish(packed(header, points))
            while time.monotonic() < end and (len(poses) <= k or (k == SCANS - 1 and not maps)):
                executor.spin_once(timeout_sec=0.1)
        sensor.destroy_node()
        node.destroy_node()

    monkeypatch.setattr(rclpy, "spin", spin)
    try:
        run_block()
    finally:
        rclpy.try_shutdown()
    assert_true_poses(poses)
    assert [message.header.stamp.sec for message in poses] == list(range(SCANS))
    (cloud,) = maps
    assert (cloud.header.frame_id, [field.name for field in cloud.fields]) == ("odom", ["x", "y", "z"])
    assert_room(unpacked(cloud))


@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of modules that ROS imports
def test_a_bag_of_messages_that_ros_serialized_has_their_points_and_poses(tmp_path):
    if importlib.util.find_spec("rclpy") is None:
        pytest.skip("rclpy is not installed. `make test-other-tools` runs this test")
    from nav_msgs.msg import Odometry
    from rclpy.serialization import serialize_message
    from rosbags import rosbag2
    from std_msgs.msg import Header

    store, scans = get_typestore(Stores.ROS2_HUMBLE), np.random.default_rng(0).random((3, 500, 3), np.float32)
    writer = rosbag2.Writer(tmp_path / "bag", version=9, storage_plugin=rosbag2.StoragePlugin.MCAP)
    with writer:
        clouds = writer.add_connection("/points", "sensor_msgs/msg/PointCloud2", typestore=store)
        poses = writer.add_connection("/odometry", "nav_msgs/msg/Odometry", typestore=store)
        for k, points in enumerate(scans):
            header, message = Header(frame_id="lidar"), Odometry(child_frame_id="lidar")
            header.stamp.sec = 10 + k
            message.header, pose = header, message.pose.pose
            pose.position.x, pose.position.y, pose.position.z = true_pose(k)[:3, 3].tolist()
            rotation = Rotation.from_matrix(true_pose(k)[:3, :3]).as_quat().tolist()
            pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w = rotation
            writer.write(clouds, (10 + k) * 10**9, serialize_message(packed(header, points)))
            writer.write(poses, (10 + k) * 10**9, serialize_message(message))
    recording = loom.open_recording(tmp_path / "bag")
    for scan, points in zip(recording.scans("/points"), scans, strict=True):
        np.testing.assert_array_equal(scan.points, points)
    trajectory = recording.trajectory("/odometry")
    np.testing.assert_allclose(trajectory.timestamps, [10.0, 11.0, 12.0])
    np.testing.assert_allclose(trajectory.poses, [true_pose(k) for k in range(3)], atol=1e-12)
